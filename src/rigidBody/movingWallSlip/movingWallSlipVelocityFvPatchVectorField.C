// SPDX-License-Identifier: GPL-3.0-or-later

#include "movingWallSlipVelocityFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "fvcMeshPhi.H"
#include "surfaceFields.H"
#include "volFields.H"

namespace Foam
{
    makePatchTypeField(fvPatchVectorField, movingWallSlipVelocityFvPatchVectorField);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::movingWallSlipVelocityFvPatchVectorField::movingWallSlipVelocityFvPatchVectorField
(
    const fvPatch& patch,
    const DimensionedField<vector, volMesh>& field
)
:
    directionMixedFvPatchVectorField(patch, field)
{
    refValue() = Zero;
    refGrad() = Zero;
    valueFraction() = sqr(patch.nf());
}


Foam::movingWallSlipVelocityFvPatchVectorField::movingWallSlipVelocityFvPatchVectorField
(
    const fvPatch& patch,
    const DimensionedField<vector, volMesh>& field,
    const dictionary& dict
)
:
    movingWallSlipVelocityFvPatchVectorField(patch, field)
{
    patchType() = dict.getOrDefault<word>("patchType", word::null);
    if (dict.found("value"))
    {
        *this == vectorField("value", dict, patch.size());
    }
    else
    {
        // At rest, until it moves
        *this == vectorField(patch.size(), Zero);
    }
}


Foam::movingWallSlipVelocityFvPatchVectorField::movingWallSlipVelocityFvPatchVectorField
(
    const movingWallSlipVelocityFvPatchVectorField& other,
    const fvPatch& patch,
    const DimensionedField<vector, volMesh>& field,
    const fvPatchFieldMapper& mapper
)
:
    directionMixedFvPatchVectorField(other, patch, field, mapper)
{}


Foam::movingWallSlipVelocityFvPatchVectorField::movingWallSlipVelocityFvPatchVectorField
(
    const movingWallSlipVelocityFvPatchVectorField& other,
    const DimensionedField<vector, volMesh>& field
)
:
    directionMixedFvPatchVectorField(other, field)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::movingWallSlipVelocityFvPatchVectorField::updateCoeffs()
{
    if (updated())
    {
        return;
    }
    const fvMesh& mesh = internalField().mesh();
    if (mesh.moving())
    {
        const volVectorField& U = db().lookupObject<volVectorField>(internalField().name());
        const scalarField swept(patch().patchField<surfaceScalarField, scalar>(fvc::meshPhi(U)));
        refValue() = patch().nf()*swept/patch().magSf();
    }
    valueFraction() = sqr(patch().nf());
    directionMixedFvPatchVectorField::updateCoeffs();
}


void Foam::movingWallSlipVelocityFvPatchVectorField::operator==(const Field<vector>& velocity)
{
    refValue() = velocity;
    directionMixedFvPatchVectorField::operator==(velocity);
}


void Foam::movingWallSlipVelocityFvPatchVectorField::write(Ostream& os) const
{
    fvPatchVectorField::write(os);
    writeEntry("value", os);
}

// ************************************************************************* //
