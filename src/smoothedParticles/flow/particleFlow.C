// SPDX-License-Identifier: GPL-3.0-or-later
#include "flowIn.H"

#include <cmath>
#include <sstream>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

using Foam::smoothedParticles::refuse;

void checkPositive(const std::string& entry, double value)
{
    if (!(value > 0) || !std::isfinite(value))
    {
        refuse(entry, value, "a number above 0");
    }
}


void checkNotNegative(const std::string& entry, double value)
{
    if (!(value >= 0) || !std::isfinite(value))
    {
        refuse(entry, value, "0 or above");
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::smoothedParticles::refuse(const std::string& entry, double value, const char* expected)
{
    std::ostringstream message;
    message << entry << " is " << value << ": expected " << expected;
    throw std::invalid_argument(message.str());
}


template<int dim>
std::unique_ptr<Foam::smoothedParticles::particleFlow<dim>> Foam::smoothedParticles::newParticleFlow
(
    const particleState<dim>& start,
    const particleFlowModel<dim>& model,
    int nThreads,
    const wallMotions& moving,
    const bodyResponse& response
)
{
    const interactionModel& m = model.interaction;
    checkPositive("spacing", model.spacing);
    checkPositive("rho0", model.rho0);
    checkPositive("Courant", model.Courant);
    checkPositive("h", m.h);
    checkPositive("c0", m.c0);
    checkNotNegative("mu", m.mu);
    checkNotNegative("alpha", m.alpha);
    checkNotNegative("beta", m.beta);
    checkNotNegative("delta", m.delta);
    checkNotNegative("acousticDamper", m.acousticDamper);
    checkNotNegative("shifting", model.shifting);
    checkNotNegative("wallTension", model.wallTension);
    checkPositive("number of threads", nThreads);
    if (!(m.gamma > 1) || !std::isfinite(m.gamma))
    {
        refuse("gamma", m.gamma, "a number above 1");
    }
    if (m.h < model.spacing || m.h > 10*model.spacing)
    {
        refuse("h", m.h/model.spacing, "1 to 10 spacings");
    }
    const std::size_t n = start.size();
    if
    (
        start.v.size() != n || start.density.size() != n || start.wall.size() != n
     || (start.energy.size() != n && !start.energy.empty()) || start.heat.size() != start.energy.size()
     || (start.mass.size() != n && !start.mass.empty()) || (start.acceleration.size() != n && !start.acceleration.empty())
    )
    {
        throw std::invalid_argument
        (
            "state of the particles: expected as many velocities, densities, walls, and masses, accelerations and energies if"
            " any, as positions"
        );
    }
    if (start.felt.size() != moving.size() && !start.felt.empty())
    {
        throw std::invalid_argument
        (
            "state of the particles: accelerations of " + std::to_string(start.felt.size()) + " walls that move: expected "
          + std::to_string(moving.size())
        );
    }
    if (m.axisymmetric)
    {
        checkPositive("least radius of rings", m.leastRadius);
        const bool mirrored = std::any_of
        (
            model.symmetry.begin(), model.symmetry.end(),
            [](const symmetryPlane& p){ return p.axis == 0 && p.at == 0 && p.side == 1; }
        );
        const bool beyond = std::any_of(start.x.begin(), start.x.end(), [](const std::array<double, dim>& x){ return !(x[0] > 0); });
        const bool viscous = m.viscosity == viscosityType::laminar || m.viscosity == viscosityType::Riemann;
        if (dim != 2 || !mirrored || beyond || model.contact.isOn() || viscous || m.diffusion == diffusionType::none)
        {
            throw std::invalid_argument
            (
                "axisymmetric: expected two dimensions, the plane x = 0 as one of symmetry, all particles at x above 0, viscosity none"
                " or artificial, density diffusion, and no contact"
            );
        }
    }
    for (const symmetryPlane& a : model.symmetry)
    {
        for (const symmetryPlane* b = &a + 1; b != model.symmetry.data() + model.symmetry.size(); ++b)
        {
            // An image has no image in the plane that it comes from
            const double least = supportRatio*m.h + skinRatio*model.spacing;
            if (a.axis == b->axis && (a.side == b->side || !(a.side*(b->at - a.at) > least)))
            {
                refuse
                (
                    "distance of two planes of symmetry across one coordinate, on either side of the particles",
                    a.side == b->side ? 0 : a.side*(b->at - a.at),
                    ("more than the reach of a particle, " + std::to_string(least)).c_str()
                );
            }
        }
    }
    for (std::size_t k = 0; k < n; ++k)
    {
        double sum = start.density[k];
        for (int d = 0; d < dim; ++d)
        {
            sum += start.x[k][d] + start.v[k][d];
        }
        if (!std::isfinite(sum))
        {
            throw std::invalid_argument
            (
                "particle " + std::to_string(k) + " starts with a position, velocity or density that is not a number"
            );
        }
    }
    if (std::count(start.wall.begin(), start.wall.end(), particleState<dim>::fluid) == 0)
    {
        throw std::invalid_argument("no particle of fluid: expected one at least");
    }

    if (model.singlePrecision)
    {
        return std::unique_ptr<particleFlow<dim>>(new flowIn<float, dim>(start, model, nThreads, moving, response));
    }
    return std::unique_ptr<particleFlow<dim>>(new flowIn<double, dim>(start, model, nThreads, moving, response));
}


template std::unique_ptr<Foam::smoothedParticles::particleFlow<2>> Foam::smoothedParticles::newParticleFlow<2>
(const particleState<2>&, const particleFlowModel<2>&, int, const wallMotions&, const bodyResponse&);

template std::unique_ptr<Foam::smoothedParticles::particleFlow<3>> Foam::smoothedParticles::newParticleFlow<3>
(const particleState<3>&, const particleFlowModel<3>&, int, const wallMotions&, const bodyResponse&);
