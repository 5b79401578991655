// SPDX-License-Identifier: GPL-3.0-or-later
// Contact by springs

#include "flowIn.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Real, int dim>
typename Foam::smoothedParticles::flowIn<Real, dim>::wallPose
Foam::smoothedParticles::flowIn<Real, dim>::poseOf(std::int32_t wall) const
{
    const auto found = bodies_.find(wall);
    if (found == bodies_.end())
    {
        return {Foam::vector::zero, Foam::vector::zero, Foam::tensor::I};
    }
    const bodyState& home = model_.contact.homes.at(wall);
    const bodyState& now = found->second.at;
    return {now.centreOfMass, home.centreOfMass, home.orientation & now.orientation.T()};
}


template<class Real, int dim>
double Foam::smoothedParticles::flowIn<Real, dim>::inverseMass(std::int32_t wall) const
{
    double largest = 0;
    for (int d = 0; response_ && d < dim; ++d)
    {
        Foam::vector unit(Foam::vector::zero);
        unit[d] = 1;
        const bodyAcceleration pushed(response_(wall, {unit, Foam::vector::zero, Foam::vector::zero}));
        const bodyAcceleration free(response_(wall, {Foam::vector::zero, Foam::vector::zero, Foam::vector::zero}));
        largest = std::max(largest, mag(pushed.linear - free.linear));
    }
    return largest;
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::sumContact()
{
    const penaltyContact& contact = model_.contact;
    const std::int64_t n = x_.size();
    contactEnergy_ = 0;
    bodyFrequency2_ = 0;
    double deepest = 0;
    long nInside = 0;
    for (std::size_t w = 0; w < contact.walls.size(); ++w)
    {
        const contactSurface& surface = contact.walls[w];
        const wallPose pose(poseOf(w));

        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn) reduction(max: deepest) reduction(+: nInside)
        for (std::int64_t k = 0; k < n; ++k)
        {
            push_[k].fill(0);
            spring_[k] = 0;
            shape::touching t;
            if (!surface.touch(pose.home + (pose.back & (toVector(x_[k]) - pose.now)), t))
            {
                continue;
            }
            // The surface is felt at half a spacing
            const double behind = t.depth - 0.5*model_.spacing;
            deepest = std::max(deepest, behind);
            nInside += behind > 0;
            if (t.depth <= contact.maxDepth)
            {
                const double force = contact.k(mass_[k], soundStep(), t.area)*t.depth;
                const Foam::vector push(force*(pose.back.T() & t.normal));
                spring_[k] = 0.5*force*t.depth;
                for (int d = 0; d < dim; ++d)
                {
                    push_[k][d] = push[d];
                    a_[k][d] += push[d]/mass_[k];
                }
            }
        }

        // In the order of the particles, whatever the number of threads
        double stiffness = 0;
        bodyLoads& loads = contactLoads_[w];
        loads = {Foam::vector::zero, Foam::vector::zero, Foam::vector::zero};
        for (std::int64_t k = 0; k < n; ++k)
        {
            if (spring_[k] > 0)
            {
                const Foam::vector push(toVector(push_[k]));
                contactEnergy_ += spring_[k];
                stiffness += 0.5*magSqr(push)/spring_[k];
                loads.pressure -= push;
                loads.moment -= (toVector(x_[k]) - pose.now) ^ push;
            }
        }
        const auto found = bodies_.find(w);
        if (found != bodies_.end())
        {
            found->second.loads = loads;
            bodyFrequency2_ = std::max(bodyFrequency2_, stiffness*inverseMass(w));
        }
    }
    inWalls_ = {deepest, nInside};
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::setUpContact()
{
    const penaltyContact& contact = model_.contact;
    push_.resize(x_.size());
    spring_.resize(x_.size());
    contactLoads_.resize(contact.walls.size());
    const double lightest = *std::min_element(mass_.begin(), mass_.end());
    for (const contactSurface& wall : contact.walls)
    {
        contactFrequency2_ = std::max(contactFrequency2_, contact.k(lightest, soundStep(), wall.maxArea())/lightest);
    }
}


template class Foam::smoothedParticles::flowIn<float, 2>;
template class Foam::smoothedParticles::flowIn<float, 3>;
template class Foam::smoothedParticles::flowIn<double, 2>;
template class Foam::smoothedParticles::flowIn<double, 3>;
