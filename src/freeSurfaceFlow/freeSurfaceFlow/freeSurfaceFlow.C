// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "findRefCell.H"
#include "functionObject.H"
#include "fvc.H"
#include "gravityMeshObject.H"
#include "inputChecks.H"
#include "restart.H"
#include "uniformDimensionedFields.H"
#include "profiling.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- So far out of 0 to 1, as on regular meshes, a fraction stays as it is
const scalar tolerableExcess = 1e-3;


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

//- Do function objects look up the flux of the liquid? scalarTransport with the
//  entry phase does, under the name alphaPhiUn
bool namesLiquidFlux(const dictionary& controlDict)
{
    OStringStream os;
    os  << controlDict.subOrEmptyDict("functions");
    const std::string functions(os.str());

    return
        functions.find("scalarTransport") != std::string::npos
     || functions.find("alphaPhiUn") != std::string::npos;
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
    mesh_(withCheckedInput(mesh)),
    time_(mesh.time()),
    scene_(mesh),
    pimple_(mesh),
    composite_(mesh),
    rDeltaT_(newLocalTimeSteps()),
    body_(scene_.hasBody() ? new bodyMotion(mesh) : nullptr),
    history_
    (
        body_ && backwardDifference::isWanted(mesh) && body_->isMovedBy("addedMass")
      ? new bodyHistory(time_)
      : nullptr
    ),
    addedMass_(body_ && addedMassTensor::isWanted(body_()) ? new addedMassTensor(mesh, body_()) : nullptr),
    p_rgh_(readField("p_rgh", mesh), mesh),
    U_(readField("U", mesh), mesh),
    phi_(restart::field("phi", mesh), fvc::flux(U_)),
    Uf_
    (
        mesh.dynamic()
      ? new surfaceVectorField(restart::field("Uf", mesh), fvc::interpolate(U_))
      : nullptr
    ),
    backward_(backwardDifference::isWanted(mesh) ? new backwardDifference(composite_, U_) : nullptr),
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
        IOobject("rho", time_.timeName(), mesh, IOobject::READ_IF_PRESENT),
        mixture_.alpha1()*mixture_.rho1() + mixture_.alpha2()*mixture_.rho2()
    ),
    rhoPhi_
    (
        IOobject("rhoPhi", time_.timeName(), mesh),
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
                composite_
            }
        )
    ),
    alphaPhiUn_
    (
        functionObject::postProcess || namesLiquidFlux(time_.controlDict())
      ? new surfaceScalarField
        (
            IOobject("alphaPhiUn", time_.timeName(), mesh),
            scheme_->alphaPhi()
        )
      : nullptr
    ),
    fringeVolume_(),
    buoyancy_(scene_.gravity() ? new buoyancy(mesh) : nullptr),
    p_
    (
        IOobject("p", time_.timeName(), mesh, IOobject::NO_READ, IOobject::AUTO_WRITE),
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
    longestDeltaT_(0),
    repeats_(body_ && body_->isMovedBy("addedMass")),
    nRepeats_(0),
    nUnbalanced_(0),
    worstBalance_(0),
    worstTime_(0),
    guard_()
{
    if (scene_.slips())
    {
        slipOverWalls();
    }
    check();

    volScalarField& alpha1 = mixture_.alpha1();
    const scalar excess = max(gMax(alpha1.primitiveField()) - 1, -gMin(alpha1.primitiveField()));
    if (excess > tolerableExcess && !restart::isFrom(mesh_))
    {
        Info<< "Volume fractions of the liquid are out of 0 to 1 by up to " << excess << ", as warped cells make them: cut off" << nl << endl;
        alpha1.primitiveFieldRef() = min(max(alpha1.primitiveField(), scalar(0)), scalar(1));
        alpha1.correctBoundaryConditions();
        mixture_.alpha2() = 1 - alpha1;
        rho_ = alpha1*mixture_.rho1() + mixture_.alpha2()*mixture_.rho2();
    }
    if (scene_.conservesFringe())
    {
        fringeVolume_.reset(new fringeVolume(composite_, alpha1));
    }
    rho_.oldTime();
    mesh_.setFluxRequired(p_rgh_.name());
    setPressureReference();

    // The viscosities and the distance from the wall follow the mesh by
    // themselves: of a constant, interpolation would leave all but the last
    // digits
    composite_.doNotInterpolate
    ({
        "HbyA", "grad(p_rgh)", "nHat", "surfaceIntegrate(phi)",
        "surfaceIntegrate(phiHbyA)", "pcorr", "cellDisplacement",
        "nu", "nu1", "nu2", "yWall"
    });

    if (controls().correctPhi && !composite_.isOverset())
    {
        rAU_ = tmp<volScalarField>::New
        (
            restart::field("rAU", mesh),
            mesh_,
            dimensionedScalar("one", dimTime/dimDensity, 1)
        );
    }

    if (functionObject::postProcess)
    {
        return;
    }

    // A restart has its flux; only a first start may lack continuity
    const bool restarted = restart::isFrom(mesh_);
    if (!restarted && scene_.potentialStart())
    {
        startImpulsively();
    }
    else if (!restarted)
    {
        projectFlux();
    }

    // A restart has read its eddy viscosity: wall functions iterate on it from
    // one call to the next
    if (!restarted || !scene_.turbulence())
    {
        turbulence_->validate();
    }
    reportScene(Info);
    guard_.reset(new runGuard(mesh_, smallLoad()));
    checkDiffusion();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::freeSurfaceFlow::check()
{
    restart::check(mesh_, scene_.hasBody(), backward_.valid(), history_.valid());
    checkFluids();
    checkCorrections();

    composite_.checkDonors();
    if (body_)
    {
        body_->check(composite_.backgroundBounds());
    }
    composite_.checkHoles();

    checkBoundaryLayer();

    if (scene_.potentialStart() && !body_)
    {
        refuseEntry(scene_.dict(), "initialFlow", "is potential, but the scene has no body", "fields.");
    }

    const dictionary& dict = pimple_.dict();
    if (dict.lookupOrDefault<bool>("massFluxInterpolation", false))
    {
        refuseEntry(dict, "massFluxInterpolation", "is on", "off, the only choice.");
    }

    if (time_.controlDict().lookupOrDefault<bool>("adjustTimeStep", false))
    {
        for (const word name : {"maxCo", "maxAlphaCo"})
        {
            readPositive(time_.controlDict(), name, "a positive Courant number.");
        }
        const scalar largest = runGuard::largestCourant(nCorrections());
        if (!isGiven() && time_.controlDict().get<scalar>("maxCo") > largest)
        {
            refuseEntry
            (
                time_.controlDict(),
                "maxCo",
                text("is ", time_.controlDict().get<scalar>("maxCo"), ", but a step has one pressure correction"),
                text("at most ", largest, ", or nCorrectors 2 in system/fvSolution.")
            );
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
    c.oversetAdjustPhi =
        composite_.isOverset() && dict.lookupOrDefault("oversetAdjustPhi", false);
    return c;
}


void Foam::freeSurfaceFlow::setPressureReference()
{
    if (buoyancy_)
    {
        p_ = p_rgh_ + rho_*buoyancy_->gh;
    }
    if (composite_.isOverset() && p_rgh_.needReference())
    {
        const point reference(pressureReference());
        // A body may come over it later
        const bool mayBeCovered =
            restart::isFrom(mesh_) && composite_.backgroundBounds().contains(reference);
        if (!mayBeCovered && !composite_.isInFlow(reference))
        {
            refuseEntry
            (
                pimple_.dict(),
                pimple_.dict().found("pRefCell") ? "pRefCell" : "pRefPoint",
                text("sets the pressure's reference at ", reference, ", where there is no fluid"),
                "a place in the fluids, in no body."
            );
        }
        pRefValue_ = pimple_.dict().get<scalar>("pRefValue");
        pRefCell_ = composite_.calculatedCell(reference);
    }
    else
    {
        setRefCell(p_, p_rgh_, pimple_.dict(), pRefCell_, pRefValue_);
    }
    setPressure();
}


Foam::point Foam::freeSurfaceFlow::pressureReference() const
{
    const dictionary& dict = pimple_.dict();
    if (!dict.found("pRefCell"))
    {
        return dict.get<point>("pRefPoint");
    }

    // As in OpenFOAM, a cell of the first processor
    point centre(Zero);
    if (Pstream::master())
    {
        const label celli = dict.get<label>("pRefCell");
        if (celli < 0 || celli >= mesh_.nCells())
        {
            refuseEntry(dict, "pRefCell", text("is ", celli), text("a cell from 0 to ", mesh_.nCells() - 1, "."));
        }
        centre = mesh_.cellCentres()[celli];
    }
    Pstream::scatter(centre);
    return centre;
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
