// SPDX-License-Identifier: GPL-3.0-or-later

#include "propertyState.H"
#include "commandText.H"
#include "phaseEquilibrium.H"

#include <algorithm>
#include <cmath>
#include <limits>

using Foam::titan::thermoError;

namespace
{

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Foam::titan::fluidProperties noProperties(double T, double p)
{
    Foam::titan::fluidProperties result;
    result.T = T;
    result.p = p;
    result.values.fill(none);
    result.uncertainties.fill(none);
    return result;
}

} // End anonymous namespace


bool Foam::titanCommand::propertyState::hasComposition() const
{
    return !std::isnan(x[0]);
}


std::string Foam::titanCommand::propertyState::message() const
{
    return refusal.empty() ? joined(warnings, " ") : refusal;
}


Foam::titanCommand::propertyState Foam::titanCommand::propertyState::refused
(
    const titan::composition::fractions& x,
    titan::phase ph,
    double T,
    double p,
    const std::string& why
)
{
    return {T, p, ph, x, noProperties(T, p), none, none, why, {}};
}


Foam::titanCommand::propertyState Foam::titanCommand::propertyState::ofConstants
(
    const titan::fluidProperties& properties,
    titan::phase ph
)
{
    return {properties.T, properties.p, ph, {{none, none, none, none}}, properties, none, none, "", {}};
}


Foam::titanCommand::propertyState Foam::titanCommand::propertyState::ofMixture
(
    const titan::fluidModel& model,
    const titan::composition& x,
    titan::phase ph,
    double T,
    double p,
    bool withWarnings
)
{
    propertyState state = refused(x.x(), ph, T, p, "");
    try
    {
        state.properties = model.properties(T, p);
    }
    catch (const thermoError& refusalOfAll)
    {
        // One of them may be the cause, but there is no state at all without a density.
        try
        {
            model.value(titan::property::density, T, p);
        }
        catch (const thermoError& refusalOfDensity)
        {
            state.refusal = refusalOfDensity.what();
            return state;
        }
        for (int i = 0; i < titan::nProperties; ++i)
        {
            const titan::property q = static_cast<titan::property>(i);
            try
            {
                state.properties.values[i] = model.value(q, T, p);
            }
            catch (const thermoError& why)
            {
                state.warnings.push_back(std::string("No ") + titan::propertyName(q) + ": " + why.what() + ".");
            }
        }
    }

    for (int i = 0; i < titan::nProperties; ++i)
    {
        double& value = state.properties.values[i];
        if (std::isinf(value))
        {
            value = none;
            state.warnings.push_back(std::string("No ") + titan::propertyName(static_cast<titan::property>(i))
              + ": it is infinite.");
        }
    }

    if (withWarnings)
    {
        try
        {
            const std::vector<std::string> doubts = titan::stateWarnings(x, ph, T, p);
            state.warnings.insert(state.warnings.end(), doubts.begin(), doubts.end());
        }
        catch (const thermoError& why)
        {
            state.warnings.push_back(std::string("The stability of the state is not known: ") + why.what() + ".");
        }
    }
    return state;
}


void Foam::titanCommand::propertyState::findBubblePoint()
{
    try
    {
        bubblePressure = titan::bubblePoint(titan::composition(x), T).p;
    }
    catch (const thermoError& why)
    {
        warnings.push_back(std::string("No bubble pressure: ") + why.what() + ".");
    }
    try
    {
        dissolvedNitrogen =
            titan::saturateWithNitrogen(x[titan::CH4], x[titan::C2H6], x[titan::C3H8], T, p).liquid[titan::N2];
    }
    catch (const thermoError& why)
    {
        warnings.push_back(std::string("No figure for the nitrogen that it can dissolve: ") + why.what() + ".");
    }
}
