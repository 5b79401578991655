// SPDX-License-Identifier: GPL-3.0-or-later

#include "slenderLiquid.H"

#include "fluidSelection.H"
#include "inputChecks.H"
#include "lakeProfile.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Steps of the table of a lake: an error below 1e-5 where the viscosity changes by a factor of three
constexpr int nSteps = 400;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::slenderBody::slenderLiquid::readLake(const dictionary& dict, const scalar g)
{
    if (!(g > 0))
    {
        refuse(dict, "g is zero in this case: a depth has no direction", "gravity, in constant/g, where there is a stratification.");
    }
    const std::vector<titan::lakeLayer> layers(titan::lakeProfile::readLayers(dict));
    titan::orRefuse
    (
        dict,
        "layers",
        [&]
        {
            const titan::stratifiedLake lake(layers, dict.get<scalar>("p"), g);
            step_ = lake.maxDepth()/nSteps;
            for (int k = 0; k <= nSteps; ++k)
            {
                const scalar depth = min(k*step_, lake.maxDepth());
                rhos_.push_back(lake.density(depth));
                mus_.push_back(lake.viscosity(depth));
            }
        }
    );
    rho_ = rhos_[0];
    mu_ = mus_[0];
}


Foam::scalar Foam::slenderBody::slenderLiquid::at(const std::vector<scalar>& values, const scalar depth) const
{
    const scalar place = max(depth, scalar(0))/step_;
    if (place > (nSteps + 1e-9))
    {
        refuse
        (
            dict_,
            text("Entry layers: the body reaches ", depth, " m below the surface, and the last layer is at ", nSteps*step_, " m"),
            "layers as deep as the dive, or an end before."
        );
    }
    const int i = min(int(place), nSteps - 1);
    return values[i] + (place - i)*(values[i + 1] - values[i]);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slenderBody::slenderLiquid::slenderLiquid(const dictionary& dict, const scalar g)
:
    dict_(dict),
    sigma_(0),
    step_(0)
{
    const auto readTension = [&](const scalar known)
    {
        sigma_ = dict.lookupOrDefault<scalar>("sigma", known);
        if (!(sigma_ >= 0))
        {
            refuseEntry(dict, "sigma", text("is ", sigma_), "a surface tension, 0 or above [N/m].");
        }
    };
    if (dict.found("stratification"))
    {
        checkKeywords(dict, {"stratification", "sigma"});
        readTension(0);
        readLake(dict.subDict("stratification"), g);
        return;
    }
    if (dict.found("fluid") || dict.found("composition"))
    {
        wordHashSet known({"sigma"});
        known += titan::fluidSelection::keywords;
        checkKeywords(dict, known);
        const titan::fluidSelection liquid(dict);
        if (liquid.ph() != titan::phase::liquid)
        {
            refuse(dict, text("Entry fluid or composition is ", liquid.name(), ", a gas"), "a liquid.");
        }
        rho_ = liquid.value(titan::property::density, dict);
        mu_ = liquid.value(titan::property::viscosity, dict);
        readTension(liquid.has(titan::property::surfaceTension) ? liquid.value(titan::property::surfaceTension, dict) : 0);
        liquid.print(Info, {titan::property::density, titan::property::viscosity});
        return;
    }
    checkKeywords(dict, {"rho", "mu", "sigma"});
    rho_ = readPositive(dict, "rho", "a positive density [kg/m3].");
    mu_ = dict.get<scalar>("mu");
    if (!(mu_ >= 0 && mu_ < GREAT))
    {
        refuseEntry(dict, "mu", text("is ", mu_), "a viscosity, 0 or above [Pa s].");
    }
    readTension(0);
}

// ************************************************************************* //
