// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "frictionLine.H"
#include "movingWallSlipVelocityFvPatchVectorField.H"
#include "nutWallFunctionFvPatchScalarField.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- First layers at the wall in a laminar layer's thickness that give its
//  friction within 5 % (validation/boundaryLayer)
const scalar layersInLaminarLayer = 10;

//- Of the first cells' centres that wall functions are made for [-]
const scalar leastYPlus = 30, greatestYPlus = 300;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::freeSurfaceFlow::boundaryLayerPatches() const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const dictionary coeffs
    (
        scene_.dict().subOrEmptyDict("frictionLineCoeffs")
    );

    if (coeffs.found("patches"))
    {
        const wordRes names(coeffs.get<wordRes>("patches"));
        const labelList given(patches.patchSet(names).sortedToc());
        if (given.empty())
        {
            FatalIOErrorInFunction(scene_.dict().subDict("frictionLineCoeffs"))
                << "Entry patches " << names << " names no patch of the mesh."
                << nl << "Expected: one or more of " << patches.names()
                << exit(FatalIOError);
        }
        return given;
    }
    return
        body_
      ? body_->patches().sortedToc()
      : patches.findPatchIDs<wallPolyPatch>().sortedToc();
}


void Foam::freeSurfaceFlow::slipOverWalls()
{
    typedef movingWallSlipVelocityFvPatchVectorField slipWall;

    for (const label patchi : boundaryLayerPatches())
    {
        if (!isA<slipWall>(U_.boundaryField()[patchi]))
        {
            Info<< "U on " << mesh_.boundary()[patchi].name() << ": "
                << slipWall::typeName << " takes the place of "
                << U_.boundaryField()[patchi].type() << endl;
            const fvPatch& patch = mesh_.boundary()[patchi];
            const vectorField wall
            (
                body_ ? body_->velocity(patch.Cf())() : U_.boundaryField()[patchi]
            );
            U_.boundaryFieldRef().set(patchi, new slipWall(patch, U_));
            U_.boundaryFieldRef()[patchi] == wall;
        }
    }
}


Foam::autoPtr<Foam::incompressible::turbulenceModel>
Foam::freeSurfaceFlow::newTurbulence() const
{
    if (scene_.boundaryLayer() == scene::boundaryLayerType::frictionLine)
    {
        return autoPtr<incompressible::turbulenceModel>
        (
            new frictionLine
            (
                U_,
                phi_,
                mixture_,
                body_.get(),
                scene_.transitionReynolds(),
                boundaryLayerPatches(),
                composite_ ? composite_->zoneID() : labelList()
            )
        );
    }
    return incompressible::turbulenceModel::New(U_, phi_, mixture_);
}


Foam::freeSurfaceFlow::wallScales Foam::freeSurfaceFlow::scalesOfWalls() const
{
    boundBox box;
    wallScales w{0, 0, 0};
    for (const label patchi : boundaryLayerPatches())
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        box.add(mesh_.boundaryMesh()[patchi].localPoints());
        w.area += sum(patch.magSf());
        w.distance += sum(patch.magSf()/patch.deltaCoeffs());
    }
    box.reduce();
    reduce(w.area, sumOp<scalar>());
    reduce(w.distance, sumOp<scalar>());
    w.distance /= max(w.area, VSMALL);
    w.length = w.area > 0 ? cmptMax(box.span()) : 0;
    return w;
}


void Foam::freeSurfaceFlow::checkBoundaryLayer() const
{
    if (scene_.boundaryLayer() == scene::boundaryLayerType::wallFunction)
    {
        const volScalarField nut(turbulence_->nut());
        for (const label patchi : boundaryLayerPatches())
        {
            const fvPatchScalarField& wall = nut.boundaryField()[patchi];
            if (!isA<nutWallFunctionFvPatchScalarField>(wall))
            {
                FatalIOErrorInFunction(scene_.dict())
                    << "Entry boundaryLayer is wallFunction, but nut on "
                    << wall.patch().name() << " is " << wall.type() << nl
                    << "Expected: a wall function in "
                    << time_.timeName() << "/nut, as nutUSpaldingWallFunction."
                    << exit(FatalIOError);
            }
        }
    }

    if (scene_.boundaryLayer() != scene::boundaryLayerType::laminar)
    {
        return;
    }

    scalar length, speed;
    string origin;
    referenceScales(length, speed, origin);
    const wallScales walls(scalesOfWalls());
    const scalar nu = gMax(mixture_.nuModel1().nu()().primitiveField());
    if (!(walls.area > 0 && speed > SMALL && nu > 0))
    {
        return;
    }

    const scalar half = 0.5*length;
    const scalar thickness = half*frictionLaw::laminarThickness(speed*half/nu);
    const scalar needed = thickness/layersInLaminarLayer;
    if (2*walls.distance > needed)
    {
        FatalIOErrorInFunction(scene_.dict())
            << "Entry boundaryLayer is laminar, but the mesh does not resolve a"
            << " laminar layer, which is " << thickness << " m thick half way"
            << " along " << length << " m at " << speed << " m/s: first cells"
            << " at the walls are " << 2*walls.distance << " m thick" << nl
            << "Expected: first cells of " << needed << " m or thinner; or"
            << " boundaryLayer frictionLine, whose friction is Blasius' up to"
            << " the transition." << exit(FatalIOError);
    }
}


void Foam::freeSurfaceFlow::reportBoundaryLayer
(
    Ostream& os,
    DynamicList<string>& remarks,
    const scalar Re,
    const scalar speed
) const
{
    const scene::boundaryLayerType type = scene_.boundaryLayer();
    const wallScales walls(scalesOfWalls());
    const frictionLaw law(scene_.transitionReynolds());
    const bool unstated = type == scene::boundaryLayerType::unstated;
    if (!(Re > 0) || !(walls.area > 0) || (unstated && !body_))
    {
        return;
    }

    const scalar rho = mixture_.rho1().value();
    const scalar plate = 0.5*rho*sqr(speed)*walls.area*law.mean(Re);
    const string friction
    (
        "a flat plate of " + name(walls.area) + " m2, the wall in this mesh,"
        " has " + name(plate) + " N at this Re, turbulent from Re_x = "
      + name(scene_.transitionReynolds())
    );

    switch (type)
    {
        case scene::boundaryLayerType::frictionLine:
        {
            os  << "    layer       : friction line, turbulent from Re_x "
                << scene_.transitionReynolds() << "; plate of the wall's area "
                << plate << " N" << nl;
            remarks.append
            (
                "The boundary layer is a friction line, which holds within"
                " about 10 % for slender bodies (towed hulls); a layer that"
                " separates is not predicted"
            );
            if (Re < 1e4)
            {
                remarks.append
                (
                    "Re = " + name(Re) + " is below 1e4: the layer is no"
                    " longer thin, and a friction line too small"
                );
            }
            break;
        }
        case scene::boundaryLayerType::wallFunction:
        {
            const scalar nu = gMax(mixture_.nuModel1().nu()().primitiveField());
            const scalar uTau = speed*Foam::sqrt(law.local(0.5*Re)/2);
            const scalar yPlus = walls.distance*uTau/nu;
            os  << "    layer       : wall functions of "
                << turbulence_->type() << ", first cells at y+ of about "
                << yPlus << nl;
            if (yPlus < leastYPlus || yPlus > greatestYPlus)
            {
                remarks.append
                (
                    "First cells are at y+ of about " + name(yPlus)
                  + ": wall functions expect " + name(leastYPlus) + " to "
                  + name(greatestYPlus) + ", friction is wrong beyond; "
                  + friction
                );
            }
            break;
        }
        case scene::boundaryLayerType::laminar:
        {
            if (law.turbulent(Re))
            {
                remarks.append
                (
                    "Re = " + name(Re) + " but the boundary layer is laminar;"
                    " " + friction
                );
            }
            break;
        }
        case scene::boundaryLayerType::none:
        {
            remarks.append("There is no boundary layer: " + friction);
            break;
        }
        case scene::boundaryLayerType::unstated:
        {
            if (law.turbulent(Re) && !scene_.turbulence())
            {
                remarks.append
                (
                    "Re = " + name(Re) + " but turbulence is off, and friction"
                    " is that of what the mesh resolves: " + friction
                );
            }
            break;
        }
    }
}

// ************************************************************************* //
