// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidSelection.H"
#include "lakeProfile.H"
#include "phaseEquilibrium.H"

#include "FlatOutput.H"
#include "inputChecks.H"
#include "Switch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::wordHashSet Foam::titan::fluidSelection::keywords
({
    "fluid", "composition", "T", "p", "phase"
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::titan;

//- SI units as in messages
const char* unit(const property q)
{
    switch (q)
    {
        case property::density:                 return "kg/m3";
        case property::soundSpeed:              return "m/s";
        case property::cp:                      return "J/(kg K)";
        case property::cv:                      return "J/(kg K)";
        case property::viscosity:               return "Pa s";
        case property::conductivity:            return "W/(m K)";
        case property::surfaceTension:          return "N/m";
        case property::isothermalBulkModulus:   return "Pa";
        case property::isentropicBulkModulus:   return "Pa";
        case property::expansivity:             return "1/K";
    }
    return "";
}


//- Amounts of the species; those that are not there are 0
composition::fractions readAmounts(const dictionary& dict)
{
    wordHashSet known({"saturated"});
    composition::fractions x;
    for (int i = 0; i < nSpecies; ++i)
    {
        known.insert(speciesName(i));
        x[i] = dict.lookupOrDefault<scalar>(speciesName(i), 0);
    }
    checkKeywords(dict, known);
    return x;
}


//- Does the entry composition ask for nitrogen?
bool isSaturated(const dictionary& dict)
{
    return
        dict.subDict("composition").lookupOrDefault<Switch>("saturated", false);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::titan::composition Foam::titan::readComposition
(
    const dictionary& dict,
    const scalar T,
    const scalar p
)
{
    const dictionary& xDict = dict.subDict("composition");
    const composition::fractions x(readAmounts(xDict));
    if (!isSaturated(dict))
    {
        return orRefuse(dict, "composition", [&]{ return composition(x); });
    }

    if (xDict.found("N2"))
    {
        refuseEntry
        (
            xDict,
            "N2",
            text("is ", x[N2], ", but entry saturated is true"),
            "CH4, C2H6 and C3H8 alone, to which the nitrogen is added, or no entry saturated."
        );
    }
    return orRefuse
    (
        dict,
        "composition, T or p",
        [&]
        {
            return saturateWithNitrogen(x[CH4], x[C2H6], x[C3H8], T, p).liquid;
        }
    );
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::titan::fluidSelection::take(namedFluid&& fluid)
{
    name_ = fluid.name;
    source_ = fluid.source;
    phase_ = fluid.ph;
    x_.reset(fluid.isConstant ? nullptr : new composition(fluid.x));
    properties_ = fluid.properties;
}


void Foam::titan::fluidSelection::selectNamed(const dictionary& dict)
{
    const word name(dict.get<word>("fluid"));
    namedFluid fluid
    (
        orRefuse(dict, "fluid", [&]{ return namedFluid::lookup(name); })
    );

    const scalar T = dict.lookupOrDefault<scalar>("T", fluid.T);
    const scalar p = dict.lookupOrDefault<scalar>("p", fluid.p);
    if (T == fluid.T && p == fluid.p)
    {
        take(std::move(fluid));
        return;
    }

    if (fluid.isConstant)
    {
        refuse
        (
            dict,
            text
            (
                "Entries T and p are ", T, " K and ", p, " Pa, but ", name, " is a set of constants that hold at ",
                fluid.T, " K and ", fluid.p, " Pa"
            ),
            "neither T nor p, or these values."
        );
    }

    if (fluid.ph == phase::liquid)
    {
        const std::string source(fluid.source);
        const composition x(fluid.x);
        fluid = orRefuse
        (
            dict,
            "T or p",
            [&]
            {
                return
                    namedFluid::saturatedLake
                    (
                        x[CH4],
                        x[C2H6],
                        x[C3H8],
                        T,
                        p
                    );
            }
        );
        fluid.name = name;
        fluid.source = source + "; T or p from the case";
        take(std::move(fluid));
    }
    else
    {
        fluid.properties = orRefuse
        (
            dict,
            "T or p",
            [&]{ return fluid.model()->properties(T, p); }
        );
        fluid.source += "; T or p from the case";
        take(std::move(fluid));
    }
}


void Foam::titan::fluidSelection::selectMixture
(
    const dictionary& dict,
    const char* name,
    const phase ph,
    const scalar T,
    const scalar p,
    const composition& x
)
{
    name_ = name;
    source_ = "composition, T and p from the case";
    phase_ = ph;
    x_.reset(new composition(x));
    properties_ = orRefuse
    (
        dict,
        "composition, T, p or phase",
        [&]{ return directFluid(x, ph)->properties(T, p); }
    );
}


void Foam::titan::fluidSelection::selectComposition(const dictionary& dict)
{
    const scalar T = dict.get<scalar>("T");
    const scalar p = dict.get<scalar>("p");
    const composition x(readComposition(dict, T, p));
    if (isSaturated(dict))
    {
        selectMixture(dict, "lake", phase::liquid, T, p, x);
        return;
    }

    const word phaseEntry(dict.get<word>("phase"));
    selectMixture
    (
        dict,
        "mixture",
        orRefuse(dict, "phase", [&]{ return phaseNamed(phaseEntry); }),
        T,
        p,
        x
    );
}


void Foam::titan::fluidSelection::selectSurface(const dictionary& dict)
{
    const lakeLayer surface(lakeProfile::readLayers(dict).front());
    selectMixture
    (
        dict,
        "lake",
        phase::liquid,
        surface.T,
        dict.get<scalar>("p"),
        surface.x
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::titan::fluidSelection::fluidSelection(const dictionary& dict)
:
    phase_(phase::liquid)
{
    wordList found;
    for (const word entry : {"fluid", "composition", "stratification"})
    {
        if (dict.found(entry))
        {
            found.append(entry);
        }
    }
    if (found.size() != 1)
    {
        wordList names;
        for (const std::string& name : namedFluid::names())
        {
            names.append(name);
        }
        refuse
        (
            dict,
            text("No single fluid: entries ", flatOutput(found)),
            text
            (
                "one of fluid, the name of a lake or an air ", flatOutput(names),
                ", composition, with T and p, or stratification."
            )
        );
    }

    if (found[0] == "fluid")
    {
        selectNamed(dict);
    }
    else if (found[0] == "composition")
    {
        selectComposition(dict);
    }
    else
    {
        selectSurface(dict.subDict("stratification"));
    }

    if
    (
        dict.found("phase")
     && dict.get<word>("phase") != phaseName(phase_)
    )
    {
        refuseEntry
        (
            dict,
            "phase",
            text("is ", dict.get<word>("phase"), ", but ", name_, " is a ", phaseName(phase_)),
            "the two to agree."
        );
    }

    if (x_)
    {
        warnings_ = orRefuse
        (
            dict,
            "fluid, composition, T or p",
            [&]{ return stateWarnings(*x_, phase_, T(), p()); }
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::titan::fluidSelection::value
(
    const property q,
    const dictionary& dict
) const
{
    if (!has(q))
    {
        refuse
        (
            dict,
            text("Entry fluid or composition: no ", propertyName(q), " is known of ", name_, ", a ", phaseName(phase_)),
            "a fluid that has one."
        );
    }
    return properties_[q];
}


Foam::scalar Foam::titan::fluidSelection::vapourPressure() const
{
    if (!x_ || phase_ != phase::liquid)
    {
        return 0;
    }
    try
    {
        const untrapped hold;
        return bubblePoint(*x_, T()).p;
    }
    catch (const thermoError&)
    {
        return 0;
    }
}


void Foam::titan::fluidSelection::print
(
    Ostream& os,
    const std::vector<property>& printed
) const
{
    const int precision = os.precision(6);
    os  << name_.c_str() << ", " << phaseName(phase_);
    if (x_)
    {
        os  << " of " << x_->name().c_str();
    }
    os  << ", at " << T() << " K and " << p() << " Pa:";

    const char* separator = " ";
    for (const property q : printed)
    {
        if (has(q))
        {
            os  << separator << propertyName(q) << ' ' << properties_[q];
            const scalar u = properties_.uncertainty(q);
            if (std::isfinite(u) && u > 0)
            {
                os  << " +- " << 0.01*round(1e4*u) << " %";
            }
            os  << ' ' << unit(q);
            separator = ", ";
        }
    }
    os  << nl << "    Source: " << source_.c_str() << nl;

    for (const std::string& warning : warnings_)
    {
        os  << "    Note: " << warning.c_str() << nl;
    }
    os  << flush;
    os.precision(precision);
}

// ************************************************************************* //
