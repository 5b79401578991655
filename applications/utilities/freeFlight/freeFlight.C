// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Application
    freeFlight

Description
    A body on which nothing but its weight acts, moved by one of the integrators
    of sixDoFRigidBodyMotion. Prints, for each of the times wanted, the time [s],
    the angular velocity in body axes [rad/s], the orientation (three columns:
    body axes in earth axes), the position [m], and the relative changes of the
    kinetic energy of rotation and of the angular momentum.

Usage
    freeFlight DICTIONARY STEP INTERVAL END
    with the coefficients of the motion in DICTIONARY, and gravity in its g
\*---------------------------------------------------------------------------*/

#include "dictionary.H"
#include "freeBody.H"
#include "IFstream.H"
#include "Time.H"

#include <cstdio>
#include <cstdlib>

using namespace Foam;

int main(int argc, char *argv[])
{
    if (argc != 5)
    {
        std::fprintf(stderr, "Usage: freeFlight DICTIONARY STEP INTERVAL END\n");
        return 1;
    }
    IFstream file(argv[1]);
    const dictionary dict(file);
    const scalar step = std::atof(argv[2]);
    const label every = std::lround(std::atof(argv[3])/step);
    const label steps = std::lround(std::atof(argv[4])/step);

    const autoPtr<Time> time(Time::New());
    freeBody body(dict, time(), dict.getOrDefault<vector>("g", Zero));
    const vector moments(dict.get<vector>("momentOfInertia"));
    const diagTensor I(moments.x(), moments.y(), moments.z());

    scalar energy0 = 0;
    vector momentum0(Zero);
    for (label n = 0; n <= steps; ++n)
    {
        if (n)
        {
            body.advance(Zero, Zero, step);
        }
        if (n % every)
        {
            continue;
        }
        const freeBody::fullState s(body.state());
        const vector omega(s.orientation.T() & s.omega);
        const vector pi(I & omega);
        const vector momentum(s.orientation & pi);
        const scalar energy = 0.5*(omega & pi);
        if (n == 0)
        {
            energy0 = energy;
            momentum0 = momentum;
        }
        const vector& x = s.centreOfMass;
        const tensor& Q = s.orientation;
        const scalar row[] =
        {
            n*step, omega.x(), omega.y(), omega.z(),
            Q.xx(), Q.xy(), Q.xz(), Q.yx(), Q.yy(), Q.yz(), Q.zx(), Q.zy(), Q.zz(),
            x.x(), x.y(), x.z(),
            energy0 > 0 ? energy/energy0 - 1 : 0,
            mag(momentum0) > 0 ? mag(momentum - momentum0)/mag(momentum0) : 0
        };
        for (const scalar value : row)
        {
            std::printf("%.16g ", value);
        }
        std::printf("\n");
    }
    return 0;
}

// ************************************************************************* //
