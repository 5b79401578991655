// SPDX-License-Identifier: GPL-3.0-or-later
#include "stratifiedLake.H"
#include "mixtureTransport.H"
#include "phaseEquilibrium.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

using Foam::titan::thermoError;

// Runge-Kutta steps between two layers: an error in p of less than 1e-10 where they differ by 1 K and 15 % methane over
// 50 m, and enough nodes for the check of stability to see what is between the layers.
constexpr int nSteps = 8;


[[noreturn]] void refuse(const std::string& input, double value, const char* unit, const std::string& expected)
{
    throw thermoError
    (
        std::isfinite(value) ? thermoError::reason::badEntry : thermoError::reason::notANumber,
        input + " is " + (std::isnan(value) ? "NaN" : std::to_string(value) + " " + unit) + ", expected " + expected
    );
}


//- What is thrown for a layer or a depth says where
[[noreturn]] void refuseAt(double depth, const thermoError& why)
{
    throw thermoError(why.why(), "lake at a depth of " + std::to_string(depth) + " m: " + why.what());
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Layers  * * * * * * * * * * * * * * * * * //

Foam::titan::lakeLayer Foam::titan::lakeLayer::saturated
(
    double depth,
    double T,
    double CH4,
    double C2H6,
    double C3H8,
    double p
)
{
    return {depth, T, saturateWithNitrogen(CH4, C2H6, C3H8, T, p).liquid};
}


// * * * * * * * * * * * * * * Private Members * * * * * * * * * * * * * * * //

Foam::titan::stratifiedLake::place Foam::titan::stratifiedLake::find(double depth) const
{
    if (!(depth >= 0 && depth <= maxDepth()))
    {
        refuse("depth", depth, "m", "0 to " + std::to_string(maxDepth()) + " m, the last layer's");
    }
    const auto lower = std::find_if
    (
        layers_.begin() + 1,
        layers_.end() - 1,
        [depth](const lakeLayer& layer) { return layer.depth >= depth; }
    );
    const std::size_t upper = lower - layers_.begin() - 1;
    return {upper, (depth - layers_[upper].depth)/(lower->depth - layers_[upper].depth)};
}


double Foam::titan::stratifiedLake::temperature(const place& at) const
{
    return (1 - at.share)*layers_[at.upper].T + at.share*layers_[at.upper + 1].T;
}


Foam::titan::composition Foam::titan::stratifiedLake::x(const place& at) const
{
    composition::fractions mixed;
    for (int i = 0; i < nSpecies; ++i)
    {
        mixed[i] = (1 - at.share)*layers_[at.upper].x[i] + at.share*layers_[at.upper + 1].x[i];
    }
    return composition(mixed);
}


double Foam::titan::stratifiedLake::pressureGradient(const place& at, double p) const
{
    const double T = temperature(at);
    const helmholtzMixture mixture(x(at));
    range::check(T, p);
    return g_*mixture.molarMass()*mixture.molarDensity(T, p, phase::liquid);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::titan::stratifiedLake::stratifiedLake(const std::vector<lakeLayer>& layers, double p0, double g)
:
    layers_(layers),
    g_(g)
{
    if (layers.size() < 2)
    {
        throw thermoError
        (
            thermoError::reason::badEntry,
            "number of layers is " + std::to_string(layers.size()) + ", expected at least 2"
        );
    }
    if (!(g > 0) || !std::isfinite(g))
    {
        refuse("g", g, "m/s2", "a positive number");
    }
    if (layers[0].depth != 0)
    {
        refuse("depth of the first layer", layers[0].depth, "m", "0");
    }
    for (std::size_t i = 1; i < layers.size(); ++i)
    {
        if (!(layers[i].depth > layers[i - 1].depth) || !std::isfinite(layers[i].depth))
        {
            refuse
            (
                "depth of layer " + std::to_string(i + 1), layers[i].depth, "m",
                "more than the " + std::to_string(layers[i - 1].depth) + " m of the one above"
            );
        }
    }

    // Fourth-order Runge-Kutta
    double depth = 0;
    double p = p0;
    try
    {
        for (std::size_t i = 0; i + 1 < layers.size(); ++i)
        {
            const double h = (layers[i + 1].depth - layers[i].depth)/nSteps;
            for (int k = 0; k < nSteps; ++k)
            {
                const double share = double(k)/nSteps;
                depth = layers[i].depth + k*h;
                const double a = pressureGradient({i, share}, p);
                nodes_.push_back({depth, p, a});

                const double half = share + 0.5/nSteps;
                const double b = pressureGradient({i, half}, p + 0.5*h*a);
                const double c = pressureGradient({i, half}, p + 0.5*h*b);
                const double d = pressureGradient({i, share + 1.0/nSteps}, p + h*c);
                p += h/6*(a + 2*b + 2*c + d);
            }
        }
        depth = maxDepth();
        nodes_.push_back({depth, p, pressureGradient({layers.size() - 2, 1}, p)});
    }
    catch (const thermoError& why)
    {
        refuseAt(depth, why);
    }

    for (std::size_t k = 1; k < nodes_.size(); ++k)
    {
        const node& upper = nodes_[k - 1];
        const node& lower = nodes_[k];
        if (lower.gradient < upper.gradient)
        {
            throw thermoError
            (
                thermoError::reason::badEntry,
                "lake is unstable between depths of " + std::to_string(upper.depth) + " and "
              + std::to_string(lower.depth) + " m: its density is " + std::to_string(upper.gradient/g) + " and "
              + std::to_string(lower.gradient/g) + " kg/m3, expected not to decrease with the depth"
            );
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::titan::stratifiedLake::temperature(double depth) const
{
    return temperature(find(depth));
}


Foam::titan::composition Foam::titan::stratifiedLake::x(double depth) const
{
    return x(find(depth));
}


double Foam::titan::stratifiedLake::pressure(double depth) const
{
    find(depth);

    // Cubic Hermite polynomial: the gradients are known
    const auto lower = std::find_if
    (
        nodes_.begin() + 1,
        nodes_.end() - 1,
        [depth](const node& n) { return n.depth >= depth; }
    );
    const node& a = *(lower - 1);
    const node& b = *lower;
    const double h = b.depth - a.depth;
    const double s = (depth - a.depth)/h;
    return
        a.p + s*s*(3 - 2*s)*(b.p - a.p)
      + h*s*(1 - s)*((1 - s)*a.gradient - s*b.gradient);
}


double Foam::titan::stratifiedLake::density(double depth) const
{
    return pressureGradient(find(depth), pressure(depth))/g_;
}


double Foam::titan::stratifiedLake::viscosity(double depth) const
{
    const place at = find(depth);
    const helmholtzMixture mixture(x(at));
    const fluidState s = mixture.state(temperature(at), pressure(depth), phase::liquid);
    return mixtureTransport(mixture.x(), phase::liquid).viscosity(s);
}


Foam::titan::fluidProperties Foam::titan::stratifiedLake::properties(double depth) const
{
    const place at = find(depth);
    return directFluid(x(at), phase::liquid)->properties(temperature(at), pressure(depth));
}
