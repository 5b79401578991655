// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermoError.H"

#include <cstdio>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const char* Foam::titan::thermoError::name() const
{
    switch (reason_)
    {
        case reason::notANumber:        return "notANumber";
        case reason::composition:       return "composition";
        case reason::temperatureRange:  return "temperatureRange";
        case reason::pressureRange:     return "pressureRange";
        case reason::noSuchPhase:       return "noSuchPhase";
        case reason::noEquilibrium:     return "noEquilibrium";
        case reason::unknownName:       return "unknownName";
        case reason::badEntry:          return "badEntry";
    }
    return "unknown";
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::string Foam::titan::formatted(const char* format, double a, double b, double c)
{
    char buffer[256];
    std::snprintf(buffer, sizeof buffer, format, a, b, c);
    return buffer;
}
