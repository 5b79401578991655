// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleProgress.H"

#include "timeLeft.H"

#include <algorithm>
#include <iomanip>
#include <sstream>

Foam::smoothedParticles::particleProgress::particleProgress(const Time& runTime)
:
    time_(runTime),
    start_(clock::now()),
    last_(start_)
{}


template<int dim>
void Foam::smoothedParticles::particleProgress::print
(
    const particleFlow<dim>& flow,
    const double particleSteps,
    const double pairs
)
{
    const clock::time_point now(clock::now());
    const double seconds = std::chrono::duration<double>(now - last_).count();
    if (seconds < 1 && !time_.writeTime())
    {
        return;
    }

    const typename particleFlow<dim>::energies e(flow.energy());
    const double done = time_.value() - time_.startTime().value();
    const double left = std::max(0.0, time_.endTime().value() - time_.value());

    std::ostringstream os;
    os  << std::setprecision(4)
        << "Time = " << time_.timeName() << "  dt " << time_.deltaTValue() << " s, speed " << flow.maxSpeed()
        << " m/s, energy kinetic " << e.kinetic << " potential " << e.potential << " internal " << e.internal
        << (dim == 2 ? " J/m" : " J") << std::setprecision(3)
        << " | " << 1e-6*(particleSteps - lastParticleSteps_)/seconds << " million particle steps/s, "
        << 1e-6*(pairs - lastPairs_)/seconds << " million pairs/s"
        << " | left " << hoursMinutesSeconds(left*std::chrono::duration<double>(now - start_).count()/done);
    Info<< os.str().c_str() << endl;

    last_ = now;
    lastParticleSteps_ = particleSteps;
    lastPairs_ = pairs;
}


template void Foam::smoothedParticles::particleProgress::print<2>(const particleFlow<2>&, double, double);
template void Foam::smoothedParticles::particleProgress::print<3>(const particleFlow<3>&, double, double);

// ************************************************************************* //
