// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "findRefCell.H"
#include "fvc.H"
#include "gravityMeshObject.H"
#include "localEulerDdtScheme.H"
#include "uniformDimensionedFields.H"
#include "profiling.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

IOobject readField(const word& name, const fvMesh& mesh)
{
    return IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        IOobject::MUST_READ,
        IOobject::AUTO_WRITE
    );
}


IOobject derivedField
(
    const word& name,
    const fvMesh& mesh,
    const IOobject::readOption r,
    const IOobject::writeOption w
)
{
    return IOobject(name, mesh.time().timeName(), mesh, r, w);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Classes * * * * * * * * * * * * * * * * //

Foam::freeSurfaceFlow::buoyancy::buoyancy(const fvMesh& mesh)
:
    g(meshObjects::gravity::New(mesh.time())),
    ghRef
    (
        // hRef is a coordinate along the axis of g
        (g & cmptMag(g.value())/max(mag(g.value()), VSMALL))
       *uniformDimensionedScalarField
        (
            IOobject
            (
                "hRef",
                mesh.time().constant(),
                mesh,
                IOobject::READ_IF_PRESENT,
                IOobject::NO_WRITE
            ),
            dimensionedScalar(dimLength, Zero)
        )
    ),
    gh("gh", (g & mesh.C()) - ghRef),
    ghf("ghf", (g & mesh.Cf()) - ghRef)
{}


Foam::freeSurfaceFlow::correctorTerms::correctorTerms
(
    const tmp<volScalarField>& trAU
)
:
    rAU("rAU", trAU),
    rAUf("rAUf", fvc::interpolate(rAU)),
    nByrAUf(rAU.mesh().Sf()/(rAU.mesh().magSf()*rAUf))
{}


void Foam::freeSurfaceFlow::buoyancy::update(const fvMesh& mesh)
{
    gh = (g & mesh.C()) - ghRef;
    ghf = (g & mesh.Cf()) - ghRef;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::freeSurfaceFlow::freeSurfaceFlow(dynamicFvMesh& mesh)
:
    mesh_(mesh),
    time_(mesh.time()),
    scene_(mesh),
    pimple_(mesh),
    composite_(compositeMesh::New(mesh)),
    body_(scene_.hasBody() ? new bodyMotion(mesh) : nullptr),
    addedMass_(body_ && addedMassTensor::isWanted(body_()) ? new addedMassTensor(mesh, body_()) : nullptr),
    p_rgh_(readField("p_rgh", mesh), mesh),
    U_(readField("U", mesh), mesh),
    phi_
    (
        derivedField
        (
            "phi",
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        fvc::flux(U_)
    ),
    Uf_
    (
        mesh.dynamic()
      ? new surfaceVectorField
        (
            derivedField
            (
                "Uf",
                mesh,
                IOobject::READ_IF_PRESENT,
                IOobject::AUTO_WRITE
            ),
            fvc::interpolate(U_)
        )
      : nullptr
    ),
    mixture_(U_, phi_),
    interface_
    (
        scene_.surfaceTension()
     || interfaceScheme::needsNormals(scene_.interface())
      ? new interfaceProperties(mixture_.alpha1(), U_, mixture_)
      : nullptr
    ),
    rho_
    (
        derivedField
        (
            "rho",
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE
        ),
        mixture_.alpha1()*mixture_.rho1() + mixture_.alpha2()*mixture_.rho2()
    ),
    rhoPhi_
    (
        derivedField("rhoPhi", mesh, IOobject::NO_READ, IOobject::NO_WRITE),
        fvc::interpolate(rho_)*phi_
    ),
    scheme_
    (
        interfaceScheme::New
        (
            scene_.interface(),
            scene_.dict(),
            interfaceScheme::fields
            {
                mixture_,
                interface_,
                phi_,
                U_,
                rhoPhi_,
                pimple_,
                composite_.get()
            }
        )
    ),
    fringeVolume_
    (
        composite_ && scene_.conservesFringe()
      ? new fringeVolume(*composite_, mixture_.alpha1())
      : nullptr
    ),
    buoyancy_(scene_.gravity() ? new buoyancy(mesh) : nullptr),
    p_
    (
        derivedField("p", mesh, IOobject::NO_READ, IOobject::AUTO_WRITE),
        1*p_rgh_    // the value without the boundary conditions
    ),
    pRefCell_(0),
    pRefValue_(0),
    MRF_(mesh),
    fvOptions_(fv::options::New(mesh)),
    turbulence_(newTurbulence()),
    UEqn_(),
    bodyForces_(),
    cellShapes_(),
    correctorTerms_(),
    rAU_(),
    cumulativeContinuityError_(0),
    longestDeltaT_(0)
{
    if (scene_.slips())
    {
        slipOverWalls();
    }
    check();

    rho_.oldTime();
    mesh_.setFluxRequired(p_rgh_.name());
    setPressureReference();

    if (composite_)
    {
        // The viscosities and the distance from the wall follow the mesh by
        // themselves: of a constant, interpolation would leave all but the last
        // digits
        composite_->doNotInterpolate
        ({
            "HbyA", "grad(p_rgh)", "nHat", "surfaceIntegrate(phi)",
            "surfaceIntegrate(phiHbyA)", "pcorr", "cellDisplacement",
            "nu", "nu1", "nu2", "yWall"
        });
    }

    if (controls().correctPhi && !composite_)
    {
        rAU_ = tmp<volScalarField>::New
        (
            derivedField
            (
                "rAU",
                mesh,
                IOobject::READ_IF_PRESENT,
                IOobject::AUTO_WRITE
            ),
            mesh_,
            dimensionedScalar("one", dimTime/dimDensity, 1)
        );
    }

    // A restart has its flux; only a first start may lack continuity
    const bool restart =
        IOobject(phi_.name(), time_.timeName(), mesh_)
       .typeHeaderOk<surfaceScalarField>(true);
    if (!restart && scene_.potentialStart())
    {
        startImpulsively();
    }
    else if (!restart)
    {
        projectFlux();
    }

    // A restart has read its eddy viscosity: wall functions iterate on it from
    // one call to the next
    if (!restart || !scene_.turbulence())
    {
        turbulence_->validate();
    }
    reportScene(Info);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::freeSurfaceFlow::check() const
{
    if (composite_)
    {
        composite_->checkDonors();
    }

    if (body_)
    {
        body_->check
        (
            composite_ ? composite_->backgroundBounds() : mesh_.bounds()
        );
    }

    if (composite_)
    {
        composite_->checkHoles();
    }

    checkBoundaryLayer();

    if (scene_.potentialStart() && !body_)
    {
        FatalIOErrorInFunction(scene_.dict())
            << "Entry initialFlow is potential, but the scene has no body"
            << nl << "Expected: fields." << exit(FatalIOError);
    }

    if (fv::localEulerDdt::enabled(mesh_))
    {
        FatalIOErrorInFunction(mesh_.schemesDict().subDict("ddtSchemes"))
            << "Entry default is localEuler" << nl
            << "Expected: a scheme that is accurate in time."
            << exit(FatalIOError);
    }

    const dictionary& dict = pimple_.dict();
    if (dict.lookupOrDefault<bool>("massFluxInterpolation", false))
    {
        FatalIOErrorInFunction(dict)
            << "Entry massFluxInterpolation is on" << nl
            << "Expected: off, the only choice." << exit(FatalIOError);
    }

    if (time_.controlDict().lookupOrDefault<bool>("adjustTimeStep", false))
    {
        for (const word name : {"maxCo", "maxAlphaCo"})
        {
            if (!(time_.controlDict().get<scalar>(name) > 0))
            {
                FatalIOErrorInFunction(time_.controlDict())
                    << "Entry " << name << " is "
                    << time_.controlDict().get<scalar>(name) << nl
                    << "Expected: a positive Courant number."
                    << exit(FatalIOError);
            }
        }
    }
}


Foam::freeSurfaceFlow::meshControls Foam::freeSurfaceFlow::controls() const
{
    const dictionary& dict = pimple_.dict();
    meshControls c;
    c.correctPhi = dict.lookupOrDefault("correctPhi", mesh_.dynamic());
    c.checkMeshCourantNo = dict.lookupOrDefault("checkMeshCourantNo", false);
    c.moveMeshOuterCorrectors =
        dict.lookupOrDefault("moveMeshOuterCorrectors", false);
    c.ddtCorr = dict.lookupOrDefault("ddtCorr", true);
    c.oversetAdjustPhi = dict.lookupOrDefault("oversetAdjustPhi", false);
    return c;
}


void Foam::freeSurfaceFlow::setPressureReference()
{
    if (buoyancy_)
    {
        p_ = p_rgh_ + rho_*buoyancy_->gh;
    }
    setRefCell(p_, p_rgh_, pimple_.dict(), pRefCell_, pRefValue_);
    setPressure();
}


void Foam::freeSurfaceFlow::setPressure()
{
    if (buoyancy_)
    {
        p_ == p_rgh_ + rho_*buoyancy_->gh;
    }
    else
    {
        p_ == p_rgh_;
    }

    if (p_rgh_.needReference())
    {
        const dimensionedScalar shift
        (
            "shift",
            p_.dimensions(),
            pRefValue_ - getRefCellValue(p_, pRefCell_)
        );
        p_ += shift;

        if (buoyancy_)
        {
            p_rgh_ = p_ - rho_*buoyancy_->gh;
        }
        else
        {
            p_rgh_ = p_;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::freeSurfaceFlow::correctTurbulence()
{
    addProfiling(turbulence, "turbulence");

    if (pimple_.turbCorr())
    {
        turbulence_->correct();
    }
}

// ************************************************************************* //
