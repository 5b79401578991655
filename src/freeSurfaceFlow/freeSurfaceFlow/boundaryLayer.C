// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "frictionLine.H"
#include "inputChecks.H"
#include "movingWallSlipVelocityFvPatchVectorField.H"
#include "nutWallFunctionFvPatchScalarField.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- First layers at the wall in a laminar layer's thickness that give its
//  friction within 5 % (validation/studies/flatPlate)
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
        for (const wordRe& name : names)
        {
            if (patches.indices(name).empty())
            {
                refuse
                (
                    scene_.dict().subDict("frictionLineCoeffs"),
                    text("Entry patches: ", name, " names no patch of the mesh."),
                    text("any of ", patches.names())
                );
            }
        }
        const labelList given(patches.patchSet(names).sortedToc());
        for (const label patchi : given)
        {
            if (!isA<wallPolyPatch>(patches[patchi]))
            {
                refuseEntry
                (
                    scene_.dict().subDict("frictionLineCoeffs"),
                    "patches",
                    text(names, ": ", patches[patchi].name(), " is of type ", patches[patchi].type()),
                    "patches of type wall."
                );
            }
            if (body_ && !body_->patches().found(patchi))
            {
                refuseEntry
                (
                    scene_.dict().subDict("frictionLineCoeffs"),
                    "patches",
                    text(names, ": ", patches[patchi].name(), " is not the body's"),
                    "patches of constant/dynamicMeshDict alone."
                );
            }
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
            if (!body_ && gMax(mag(wall)) > SMALL)
            {
                refuseEntry
                (
                    scene_.dict(),
                    "boundaryLayer",
                    text
                    (
                        "is frictionLine or none, but the wall ", patch.name(),
                        " moves, and no sixDoFRigidBodyMotion moves it"
                    ),
                    "walls at rest, or those of a body."
                );
            }
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
                composite_.zoneID()
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
    if (scene_.boundaryLayer() == scene::boundaryLayerType::unstated)
    {
        return;
    }

    const wallScales walls(scalesOfWalls());
    if (walls.area <= 0)
    {
        refuseEntry
        (
            scene_.dict(),
            "boundaryLayer",
            "is given, but the scene has no body and the mesh no patch of type wall",
            "a wall in constant/polyMesh/boundary, or no entry boundaryLayer."
        );
    }

    // With these the fluids stick to the walls
    if (!scene_.slips())
    {
        for (const label patchi : boundaryLayerPatches())
        {
            const fvPatchVectorField& wall = U_.boundaryField()[patchi];
            if (!wall.fixesValue())
            {
                refuseEntry
                (
                    scene_.dict(),
                    "boundaryLayer",
                    text("is laminar or wallFunction, but U on ", wall.patch().name(), " is ", wall.type()),
                    text("noSlip or movingWallVelocity in ", time_.timeName(), "/U.")
                );
            }
        }
    }

    if (scene_.boundaryLayer() == scene::boundaryLayerType::frictionLine)
    {
        if (mesh_.dynamic() && !body_)
        {
            refuseEntry
            (
                scene_.dict(),
                "boundaryLayer",
                "is frictionLine, but the mesh moves, and no sixDoFRigidBodyMotion moves its walls",
                "walls at rest, or those of a body."
            );
        }

        const dictionary& transport = mixture_;
        if (mixture_.rho1().value() <= mixture_.rho2().value())
        {
            refuseEntry
            (
                transport,
                "phases",
                text(transport.get<wordList>("phases"), ": the first is not the heavier one"),
                "the liquid first, with boundaryLayer frictionLine."
            );
        }
        if (!(gMin(mixture_.nuModel1().nu()().primitiveField()) > 0))
        {
            refuseEntry
            (
                scene_.dict(),
                "boundaryLayer",
                "is frictionLine, but the liquid has no viscosity",
                "boundaryLayer none."
            );
        }
    }

    if (scene_.boundaryLayer() == scene::boundaryLayerType::wallFunction)
    {
        const volScalarField nut(turbulence_->nut());
        for (const label patchi : boundaryLayerPatches())
        {
            const fvPatchScalarField& wall = nut.boundaryField()[patchi];
            if (!isA<nutWallFunctionFvPatchScalarField>(wall))
            {
                refuseEntry
                (
                    scene_.dict(),
                    "boundaryLayer",
                    text("is wallFunction, but nut on ", wall.patch().name(), " is ", wall.type()),
                    text("a wall function in ", time_.timeName(), "/nut, as nutUSpaldingWallFunction.")
                );
            }
        }
    }

    // A body that has become faster since the start is no reason to lose work
    if
    (
        scene_.boundaryLayer() != scene::boundaryLayerType::laminar
     || time_.timeIndex() > 0
    )
    {
        return;
    }

    scalar length, speed;
    string origin;
    referenceScales(length, speed, origin);
    const scalar nu = gMax(mixture_.nuModel1().nu()().primitiveField());
    if (!(speed > SMALL && nu > 0))
    {
        return;
    }

    const scalar half = 0.5*length;
    const scalar thickness = half*frictionLaw::laminarThickness(speed*half/nu);
    const scalar needed = thickness/layersInLaminarLayer;
    if (2*walls.distance > needed)
    {
        refuseEntry
        (
            scene_.dict(),
            "boundaryLayer",
            text
            (
                "is laminar, but the mesh does not resolve a laminar layer, which is ", name(thickness),
                " m thick half way along ", name(length), " m at ", name(speed),
                " m/s: first cells at the walls are ", name(2*walls.distance), " m thick"
            ),
            text
            (
                "first cells of ", name(needed),
                " m or thinner; or boundaryLayer frictionLine, whose friction is Blasius' up to the transition."
            )
        );
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
        "the friction of a flat plate as large as "
      + string(body_ ? "the body's surface, were all of it wet" : "the walls")
      + ", turbulent from Re_x = " + name(scene_.transitionReynolds())
      + (
            body_
          ? ", would slow the body by " + name(plate/body_->mass()) + " m/s2"
          : ", is " + name(plate) + " N on the walls of this mesh"
        )
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
                "The boundary layer is a friction line, made for slender bodies"
                " along the flow: towed hulls have 1.10 to 1.18 of ITTC-57's,"
                " form drag included. Separation and roughness are left out"
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
            remarks.append
            (
                "The boundary layer is that of " + turbulence_->type()
              + " with wall functions: turbulent from its beginning on, smooth"
            );
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
