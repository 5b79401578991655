// SPDX-License-Identifier: GPL-3.0-or-later
// Walls that move: where they are, and how the liquid and they push each other

#include "flowIn.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

//- Of a rigid body: three of the centre of mass, then three about it
typedef std::array<double, 6> degrees;


degrees toDegrees(const Foam::vector& linear, const Foam::vector& angular)
{
    return {{linear[0], linear[1], linear[2], angular[0], angular[1], angular[2]}};
}


Foam::vector part(const degrees& d, int which)
{
    return Foam::vector(d[3*which], d[3*which + 1], d[3*which + 2]);
}


//- A x = b, by Gauss; b becomes x
void solve(std::array<degrees, 6>& A, degrees& b)
{
    for (int k = 0; k < 6; ++k)
    {
        int pivot = k;
        for (int i = k + 1; i < 6; ++i)
        {
            pivot = std::abs(A[i][k]) > std::abs(A[pivot][k]) ? i : pivot;
        }
        std::swap(A[k], A[pivot]);
        std::swap(b[k], b[pivot]);
        for (int i = k + 1; i < 6; ++i)
        {
            const double factor = A[i][k]/A[k][k];
            for (int j = k; j < 6; ++j)
            {
                A[i][j] -= factor*A[k][j];
            }
            b[i] -= factor*b[k];
        }
    }
    for (int k = 5; k >= 0; --k)
    {
        for (int j = k + 1; j < 6; ++j)
        {
            b[k] -= A[k][j]*b[j];
        }
        b[k] /= A[k][k];
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::moveBodies(double part, double deltaT)
{
    for (auto& b : bodies_)
    {
        body& one = b.second;
        one.at.centreOfMass = one.now.centreOfMass + part*(one.end.centreOfMass - one.now.centreOfMass);
        one.at.orientation = one.now.orientation + part*(one.end.orientation - one.now.orientation);
    }
    for (const bodyParticle& p : bodyParticles_)
    {
        const Foam::vector end(p.of->end.centreOfMass + (p.of->end.orientation & p.inBody));
        for (int d = 0; d < dim; ++d)
        {
            v_[p.now][d] = (end[d] - xOld_[p.now][d])/deltaT;
            x_[p.now][d] = xOld_[p.now][d] + part*(end[d] - xOld_[p.now][d]);
        }
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::arriveBodies()
{
    for (auto& b : bodies_)
    {
        body& one = b.second;
        const bodyState last(one.felt);
        one.now = one.felt = one.end;
        if (response_)
        {
            // Where the next solution starts
            one.felt.acceleration = last.acceleration;
            one.felt.angularAcceleration = last.angularAcceleration;
        }
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::coupleBodies()
{
    if (bodies_.empty() || model_.contact.isOn())
    {
        return;
    }
    interaction_.sumWallForce(neighbours_, packed_, bodyPlaces_, nThreads_);
    if (response_)
    {
        interaction_.sumWallResponse(neighbours_, packed_, bodyPlaces_, nThreads_);
    }
    for (auto& b : bodies_)
    {
        coupleBody(b.first, b.second);
    }
}


template<class Real, int dim>
void Foam::smoothedParticles::flowIn<Real, dim>::coupleBody(std::int32_t wall, body& one)
{
    // a = free + C L, of which the force and moment L follow from the pressures, and these from a
    degrees free{}, change{};
    std::array<degrees, 6> C{};
    if (response_)
    {
        const auto respond = [&](const Foam::vector& force, const Foam::vector& moment)
        {
            const bodyAcceleration a(response_(wall, {force, Foam::vector::zero, moment}));
            return toDegrees(a.linear, a.angular);
        };
        free = respond(Foam::vector::zero, Foam::vector::zero);
        for (int k = 0; k < 6; ++k)
        {
            degrees unit{};
            unit[k] = 1;
            const degrees a(respond(part(unit, 0), part(unit, 1)));
            for (int i = 0; i < 6; ++i)
            {
                C[i][k] = a[i] - free[i];
            }
        }
    }
    const degrees first(toDegrees(one.felt.acceleration, one.felt.angularAcceleration));

    // Walls hold no tension: L is linear but for the particles that are at this bound. Newton's steps find which they are.
    constexpr int nSteps = 20;
    for (int step = 0; step <= nSteps; ++step)
    {
        degrees load{};
        std::array<degrees, 6> slope{};
        Foam::vector viscous(Foam::vector::zero);
        for (const bodyParticle& p : bodyParticles_)
        {
            if (p.of != &one)
            {
                continue;
            }
            const std::size_t i = place_[p.now];
            Foam::vector force(Foam::vector::zero), friction(Foam::vector::zero), head(Foam::vector::zero), push(Foam::vector::zero);
            for (int d = firstDirection(); d < dim; ++d)
            {
                force[d] = packed_.acceleration[d][i];
                friction[d] = packed_.friction[d][i];
                head[d] = packed_.wallHead[d][i];
                push[d] = packed_.wallPush[d][i];
            }
            Foam::vector r(toVector(x_[p.now]) - one.at.centreOfMass);
            for (int d = 0; d < firstDirection(); ++d)
            {
                // A ring turns nothing
                r[d] = 0;
            }
            const degrees heads(toDegrees(head, r ^ head));
            const degrees pushes(toDegrees(push, r ^ push));
            const double before = packed_.wallPressure[i];
            double now = before;
            for (int k = 0; k < 6; ++k)
            {
                now -= heads[k]*change[k];
            }
            force += (std::max(now, -model_.wallTension) - std::max(before, -model_.wallTension))*push;
            viscous += friction;
            const degrees loads(toDegrees(force + friction, r ^ (force + friction)));
            for (int k = 0; k < 6; ++k)
            {
                load[k] += loads[k];
            }
            if (response_ && now > -model_.wallTension)
            {
                for (int k = 0; k < 6; ++k)
                {
                    for (int l = 0; l < 6; ++l)
                    {
                        slope[k][l] += pushes[k]*heads[l];
                    }
                }
            }
        }
        one.loads = {part(load, 0) - viscous, viscous, part(load, 1)};
        if (!response_ || step == nSteps)
        {
            break;
        }

        // (1 + C slope) correction = free + C L - a
        std::array<degrees, 6> A{};
        degrees correction{};
        for (int i = 0; i < 6; ++i)
        {
            A[i][i] = 1;
            correction[i] = free[i] - first[i] - change[i];
            for (int k = 0; k < 6; ++k)
            {
                correction[i] += C[i][k]*load[k];
                for (int l = 0; l < 6; ++l)
                {
                    A[i][l] += C[i][k]*slope[k][l];
                }
            }
        }
        solve(A, correction);
        bool found = true;
        for (int which = 0; which < 2; ++which)
        {
            const double size = mag(part(free, which)) + mag(part(first, which)) + mag(part(change, which));
            found = found && mag(part(correction, which)) <= 1e-9*size;
        }
        if (found)
        {
            break;
        }
        for (int k = 0; k < 6; ++k)
        {
            change[k] += correction[k];
        }
    }

    one.felt.acceleration += part(change, 0);
    one.felt.angularAcceleration += part(change, 1);
    for (const bodyParticle& p : bodyParticles_)
    {
        if (p.of == &one)
        {
            const std::size_t i = place_[p.now];
            const Foam::vector a(part(change, 0) + (part(change, 1) ^ (toVector(x_[p.now]) - one.at.centreOfMass)));
            for (int d = 0; d < dim; ++d)
            {
                packed_.wallPressure[i] -= d < firstDirection() ? 0 : packed_.wallHead[d][i]*a[d];
            }
            packWallPressure(i);
        }
    }
}


template class Foam::smoothedParticles::flowIn<float, 2>;
template class Foam::smoothedParticles::flowIn<float, 3>;
template class Foam::smoothedParticles::flowIn<double, 2>;
template class Foam::smoothedParticles::flowIn<double, 3>;
