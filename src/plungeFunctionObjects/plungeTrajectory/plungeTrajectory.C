// SPDX-License-Identifier: GPL-3.0-or-later

#include "plungeTrajectory.H"
#include "addToRunTimeSelectionTable.H"
#include "gravityMeshObject.H"
#include "Switch.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(plungeTrajectory, 0);
    addToRunTimeSelectionTable(functionObject, plungeTrajectory, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Standard gravity [m/s^2]
constexpr scalar g0 = 9.80665;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::plungeTrajectory::plungeTrajectory
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    body_(mesh_),
    g_(meshObjects::gravity::New(runTime).value()),
    up_(mag(g_) > SMALL ? -g_/mag(g_) : vector(0, 0, 1)),
    surfaceLevel_(0),
    halfModel_(false),
    lastVelocity_(body_.velocity()),
    lastTime_(runTime.value()),
    table_
    (
        runTime,
        name,
        "trajectory",
        "time_s,penetration_m,speed_m_s,deceleration_m_s2,deceleration_g,"
        "x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,ax_m_s2,ay_m_s2,az_m_s2,"
        "v1_m_s,v2_m_s,v3_m_s,a1_m_s2,a2_m_s2,a3_m_s2,"
        "pitch_deg,omega1_rad_s,omega2_rad_s,omega3_rad_s,"
        "Fpx_N,Fpy_N,Fpz_N,Fvx_N,Fvy_N,Fvz_N,Fgx_N,Fgy_N,Fgz_N,"
        "Mx_Nm,My_Nm,Mz_Nm"
    )
{
    read(dict);
    writeLine(Zero);
}


// * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * * //

bool Foam::functionObjects::plungeTrajectory::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    surfaceLevel_ = dict.get<scalar>("surfaceLevel");
    halfModel_ = dict.get<Switch>("halfModel");
    return true;
}


bool Foam::functionObjects::plungeTrajectory::execute()
{
    const scalar t = time_.value();
    if (t <= lastTime_)
    {
        return true;
    }
    const vector v(body_.velocity());
    writeLine((v - lastVelocity_)/(t - lastTime_));
    lastVelocity_ = v;
    lastTime_ = t;
    return true;
}


void Foam::functionObjects::plungeTrajectory::writeLine
(
    const vector& acceleration
)
{
    bodyMotion::loads loads(body_.fluidLoads());
    scalar mass = body_.mass();
    if (halfModel_)
    {
        // The other half mirrors what lies in the plane of symmetry
        for (vector* f : {&loads.pressure, &loads.viscous})
        {
            *f = vector(2*f->x(), 0, 2*f->z());
        }
        loads.moment = vector(0, 2*loads.moment.y(), 0);
        mass *= 2;
    }

    const tensor Q(body_.orientation());
    const vector forward(Q.xx(), Q.yx(), Q.zx());
    const vector v(body_.velocity());
    const scalar deceleration = -(acceleration & forward);
    const scalar penetration = body_.reach(-up_) + surfaceLevel_;
    const scalar pitch = radToDeg(std::asin(max(min(forward & up_, scalar(1)), scalar(-1))));

    setResult("penetration", penetration);
    setResult("speed", mag(v));
    setResult("deceleration", deceleration);

    table_
        << time_.value() << penetration << mag(v)
        << deceleration << deceleration/g0
        << body_.centreOfMass() << v << acceleration
        << vector(Q.T() & v) << vector(Q.T() & acceleration)
        << pitch << vector(Q.T() & body_.omega())
        << loads.pressure << loads.viscous << vector(mass*g_) << loads.moment;
    table_.endLine();
}

// ************************************************************************* //
