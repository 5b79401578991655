// SPDX-License-Identifier: GPL-3.0-or-later

#include "frictionLaw.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Where the laws begin: no layer is shorter, and the turbulent one has no root
const scalar leastRe = 1, leastTurbulentRe = 1e3;

scalar laminarLocal(const scalar Re)
{
    return 0.664/Foam::sqrt(max(Re, leastRe));
}


scalar turbulentLocal(const scalar anyRe)
{
    const scalar Re = max(anyRe, leastTurbulentRe);
    return frictionLaw::turbulentMean(Re)*(1 - 2.58/Foam::log(Re));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::frictionLaw::laminarMean(const scalar Re)
{
    return 1.328/Foam::sqrt(max(Re, leastRe));
}


Foam::scalar Foam::frictionLaw::turbulentMean(const scalar Re)
{
    return 0.455/Foam::pow(Foam::log10(max(Re, leastTurbulentRe)), 2.58);
}


Foam::scalar Foam::frictionLaw::laminarThickness(const scalar Re)
{
    return 5/Foam::sqrt(max(Re, leastRe));
}


Foam::scalar Foam::frictionLaw::mean(const scalar Re) const
{
    if (!turbulent(Re))
    {
        return laminarMean(Re);
    }
    const scalar saved =
        transition_*(turbulentMean(transition_) - laminarMean(transition_));
    return turbulentMean(Re) - saved/max(Re, leastRe);
}


Foam::scalar Foam::frictionLaw::local(const scalar Re) const
{
    // At the beginning of a turbulent layer the laminar law is the larger one
    const scalar laminar = laminarLocal(Re);
    return turbulent(Re) ? max(turbulentLocal(Re), laminar) : laminar;
}


Foam::scalar Foam::frictionLaw::thickness(const scalar Re) const
{
    return turbulent(Re) ? 72.0/7*mean(Re)/2 : laminarThickness(Re);
}

// ************************************************************************* //
