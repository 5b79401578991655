// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyTrajectory.H"

#include "unitConversion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Standard gravity [m/s^2]
constexpr scalar g0 = 9.80665;


} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyTrajectory::bodyTrajectory
(
    const Time& time,
    const word& name,
    const vector& g
)
:
    g_(g),
    up_(mag(g) > SMALL ? -g/mag(g) : vector(0, 0, 1)),
    table_
    (
        time,
        name,
        "trajectory",
        "time_s,penetration_m,speed_m_s,deceleration_m_s2,deceleration_g,"
        "x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,ax_m_s2,ay_m_s2,az_m_s2,"
        "v1_m_s,v2_m_s,v3_m_s,a1_m_s2,a2_m_s2,a3_m_s2,"
        "pitch_deg,omega1_rad_s,omega2_rad_s,omega3_rad_s,"
        "Fpx_N,Fpy_N,Fpz_N,Fvx_N,Fvy_N,Fvz_N,Fgx_N,Fgy_N,Fgz_N,"
        "Mx_Nm,My_Nm,Mz_Nm"
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::bodyTrajectory::line Foam::bodyTrajectory::write
(
    const scalar time,
    const bodyState& state,
    const bodyLoads& loads,
    const scalar mass,
    const scalar penetration,
    const modelledPart& model
)
{
    const bodyLoads total(model.whole(loads));
    const scalar totalMass = model.count()*mass;

    const tensor& Q = state.orientation;
    const vector forward(Q.xx(), Q.yx(), Q.zx());
    const scalar pitch = radToDeg(std::asin(max(min(forward & up_, scalar(1)), scalar(-1))));
    const line result{penetration, mag(state.velocity), -(state.acceleration & forward)};

    table_
        << time << result.penetration << result.speed
        << result.deceleration << result.deceleration/g0
        << state.centreOfMass << state.velocity << state.acceleration
        << vector(Q.T() & state.velocity) << vector(Q.T() & state.acceleration)
        << pitch << vector(Q.T() & state.omega)
        << total.pressure << total.viscous << vector(totalMass*g_)
        << total.moment;
    table_.endLine();
    return result;
}

// ************************************************************************* //
