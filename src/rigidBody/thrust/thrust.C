// SPDX-License-Identifier: GPL-3.0-or-later

#include "thrust.H"

#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"
#include "sixDoFRigidBodyMotion.H"

namespace Foam
{
namespace sixDoFRigidBodyMotionRestraints
{
    defineTypeNameAndDebug(thrust, 0);
    addToRunTimeSelectionTable(sixDoFRigidBodyMotionRestraint, thrust, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::sixDoFRigidBodyMotionRestraints::thrust::thrust(const word& name, const dictionary& dict)
:
    sixDoFRigidBodyMotionRestraint(name, dict)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::sixDoFRigidBodyMotionRestraints::thrust::restrain
(
    const sixDoFRigidBodyMotion& motion,
    vector& restraintPosition,
    vector& restraintForce,
    vector& restraintMoment
) const
{
    const scalar now = motion.time().value();
    const scalar deltaT = motion.time().deltaTValue();
    const scalar acts = max(scalar(0), min(now, end_) - max(now - deltaT, start_));

    restraintPosition = motion.transform(refAttachmentPt_);
    // Before the first step there is none
    restraintForce = acts/max(deltaT, VSMALL)*force_*(motion.orientation() & direction_);
    restraintMoment = Zero;
}


bool Foam::sixDoFRigidBodyMotionRestraints::thrust::read(const dictionary& dict)
{
    sixDoFRigidBodyMotionRestraint::read(dict);

    const dictionary& coeffs = sDoFRBMRCoeffs_;
    checkKeywords
    (
        coeffs,
        {"sixDoFRigidBodyMotionRestraint", "force", "direction", "refAttachmentPt", "start", "end"}
    );
    force_ = coeffs.get<scalar>("force");
    direction_ = coeffs.get<vector>("direction");
    if (!(mag(direction_) > 0))
    {
        refuseEntry(coeffs, "direction", text("is ", direction_), "a direction in the body's axes.");
    }
    direction_ /= mag(direction_);
    refAttachmentPt_ = coeffs.get<point>("refAttachmentPt");
    start_ = coeffs.lookupOrDefault<scalar>("start", 0);
    end_ = coeffs.lookupOrDefault<scalar>("end", GREAT);
    if (!(end_ > start_))
    {
        refuseEntry(coeffs, "end", text("is ", end_, " s, and start ", start_, " s"), "a later time.");
    }
    return true;
}


void Foam::sixDoFRigidBodyMotionRestraints::thrust::write(Ostream& os) const
{
    os.writeEntry("force", force_);
    os.writeEntry("direction", direction_);
    os.writeEntry("refAttachmentPt", refAttachmentPt_);
    os.writeEntry("start", start_);
    os.writeEntry("end", end_);
}

// ************************************************************************* //
