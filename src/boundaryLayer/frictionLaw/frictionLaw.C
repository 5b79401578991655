// SPDX-License-Identifier: GPL-3.0-or-later

#include "frictionLaw.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- No boundary layer is this short: the laws begin here
const scalar leastRe = 1e3;

scalar laminarLocal(const scalar Re)
{
    return 0.664/Foam::sqrt(Re);
}


scalar turbulentLocal(const scalar Re)
{
    return frictionLaw::turbulentMean(Re)*(1 - 2.58/Foam::log(Re));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::frictionLaw::laminarMean(const scalar Re)
{
    return 1.328/Foam::sqrt(Re);
}


Foam::scalar Foam::frictionLaw::turbulentMean(const scalar Re)
{
    return 0.455/Foam::pow(Foam::log10(Re), 2.58);
}


Foam::scalar Foam::frictionLaw::laminarThickness(const scalar Re)
{
    return 5/Foam::sqrt(Re);
}


Foam::scalar Foam::frictionLaw::mean(const scalar anyRe) const
{
    const scalar Re = max(anyRe, leastRe);
    if (!turbulent(Re))
    {
        return laminarMean(Re);
    }
    const scalar start = max(transition_, leastRe);
    const scalar kept =
        transition_ > 0 ? start*(turbulentMean(start) - laminarMean(start)) : 0;
    return turbulentMean(Re) - kept/Re;
}


Foam::scalar Foam::frictionLaw::local(const scalar anyRe) const
{
    const scalar Re = max(anyRe, leastRe);
    return turbulent(Re) ? turbulentLocal(Re) : laminarLocal(Re);
}


Foam::scalar Foam::frictionLaw::thickness(const scalar anyRe) const
{
    const scalar Re = max(anyRe, leastRe);
    return turbulent(Re) ? 72.0/7*mean(Re)/2 : laminarThickness(Re);
}

// ************************************************************************* //
