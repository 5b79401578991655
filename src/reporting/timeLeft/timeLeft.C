// SPDX-License-Identifier: GPL-3.0-or-later

#include "timeLeft.H"

#include <cmath>
#include <iomanip>
#include <sstream>

std::string Foam::hoursMinutesSeconds(const double seconds)
{
    const long s = std::lround(seconds);
    std::ostringstream os;
    os  << s/3600 << ':' << std::setfill('0') << std::setw(2) << (s/60) % 60
        << ':' << std::setw(2) << s % 60;
    return os.str();
}

// ************************************************************************* //
