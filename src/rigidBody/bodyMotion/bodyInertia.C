// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyInertia.H"

Foam::symmTensor Foam::steiner(const scalar mass, const vector& r)
{
    return mass*(magSqr(r)*symmTensor(1, 0, 0, 1, 0, 1) - sqr(r));
}


Foam::symmTensor Foam::centralInertia(const sixDoFRigidBodyMotion& motion)
{
    const diagTensor& I = motion.momentOfInertia();
    const symmTensor given(I.xx(), 0, 0, I.yy(), 0, I.zz());
    const vector arm(motion.momentArm());
    if (magSqr(arm) < VSMALL)
    {
        return given;
    }

    // From the earth's axes of the start to those of now
    const point origin(motion.transform(point(Zero)));
    const tensor turn
    (
        tensor
        (
            motion.transform(point(1, 0, 0)) - origin,
            motion.transform(point(0, 1, 0)) - origin,
            motion.transform(point(0, 0, 1)) - origin
        ).T()
    );
    const symmTensor added(steiner(motion.mass(), turn.T() & arm));
    return given - symmTensor(added.xx(), 0, 0, added.yy(), 0, added.zz());
}

// ************************************************************************* //
