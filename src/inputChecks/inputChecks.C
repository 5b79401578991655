// SPDX-License-Identifier: GPL-3.0-or-later

#include "inputChecks.H"

#include "FlatOutput.H"

#include <cstdlib>

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::refuse(const dictionary& dict, const std::string& wrong, const std::string& expected)
{
    FatalIOErrorInFunction(dict)
        << wrong.c_str() << nl
        << "Expected: " << expected.c_str() << exit(FatalIOError);
    std::abort();
}


void Foam::refuseEntry(const dictionary& dict, const word& entry, const std::string& wrong, const std::string& expected)
{
    refuse(dict, "Entry " + entry + ' ' + wrong, expected);
}


void Foam::checkKeywords(const dictionary& dict, const wordHashSet& known)
{
    for (const entry& e : dict)
    {
        if (!known.found(e.keyword()))
        {
            refuse(dict, text("Unknown entry ", e.keyword()), text("any of ", flatOutput(known.sortedToc())));
        }
    }
}


Foam::scalar Foam::checkPositive
(
    const dictionary& dict,
    const word& entry,
    const scalar value,
    const std::string& expected
)
{
    if (!(value > 0 && value < VGREAT))
    {
        refuseEntry(dict, entry, text("is ", value), expected);
    }
    return value;
}


Foam::scalar Foam::readPositive(const dictionary& dict, const word& entry, const std::string& expected)
{
    return checkPositive(dict, entry, dict.get<scalar>(entry), expected);
}


Foam::scalar Foam::readPositiveOrDefault(const dictionary& dict, const word& entry, const scalar otherwise)
{
    return checkPositive(dict, entry, dict.lookupOrDefault<scalar>(entry, otherwise));
}


const Foam::word& Foam::checkChoice
(
    const dictionary& dict,
    const word& entry,
    const word& given,
    const wordList& choices
)
{
    if (!choices.found(given))
    {
        refuseEntry(dict, entry, "is " + given, text("one of ", flatOutput(choices)));
    }
    return given;
}

// ************************************************************************* //
