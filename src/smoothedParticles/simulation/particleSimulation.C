// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleSimulation.H"

#include "particleCheckpoint.H"
#include "particleSetUp.H"
#include "walls.H"

#include "OSspecific.H"

#include <stdexcept>

// * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * * //

namespace
{

//- Surfaces that are deeper than this part of the spacing in each other collide; what rests on a wall does not
constexpr Foam::scalar contactTolerance = 0.01;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int dim>
Foam::smoothedParticles::particleSimulation<dim>::particleSimulation
(
    Time& runTime,
    const particleProperties& properties,
    const int nThreads
)
:
    time_(runTime),
    properties_(properties),
    nThreads_(nThreads),
    bodies_(runTime, properties),
    model_(model()),
    tables_(runTime, properties.outputs(), model_, readWallNames(properties.geometry())),
    vtk_(runTime),
    progress_(runTime)
{
    const particleState<dim> first(start());
    build(first);
    bodies_.makeSurfaces();
    const std::string collision(bodies_.collision(contactTolerance*model_.spacing));
    if (collision.size())
    {
        FatalErrorInFunction
            << collision.c_str() << " at the start, " << time_.value() << " s" << nl
            << "Expected: bodies apart from walls and from each other, which have no contact." << exit(FatalError);
    }

    const std::size_t nFluid = std::count(first.wall.begin(), first.wall.end(), first.fluid);
    Info<< "Start: " << label(nFluid) << " of the fluid, " << label(first.size() - nFluid) << " of walls, from "
        << (lastGood_.empty() ? "the geometry" : lastGood_.c_str()) << nl
        << "Computation: " << nThreads_ << " threads, " << flow_->instructions() << ", "
        << scalar(flow_->bytes())/1048576 << " MiB" << nl << endl;

    properties_.printScene(Info, notes_);
    Info<< "Mach number: " << flow_->maxSpeed()/model_.interaction.c0 << ", of " << flow_->maxSpeed()
        << " m/s, the highest speed of fluid and bodies at the start" << nl << endl;
    checkSpeed();
    // By its time step Time knows whether the end is reached
    chooseTimeStep();
    tables_.write(*flow_, soundSpeedHolds_);
    bodies_.write(*flow_);
    vtk_.write(flow_->state(), model_.rho0);
    bodies_.writeVTK();
    endAtEvent();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int dim>
Foam::smoothedParticles::particleFlowModel<dim> Foam::smoothedParticles::particleSimulation<dim>::model() const
{
    particleFlowModel<dim> result(properties_.template model<dim>());
    result.contact.homes = bodies_.starts();
    return result;
}


template<int dim>
Foam::smoothedParticles::particleState<dim> Foam::smoothedParticles::particleSimulation<dim>::start()
{
    const fileName checkpoint(time_.timePath()/"particles");
    if (isFile(checkpoint))
    {
        try
        {
            const particleState<dim> state(readCheckpoint<dim>(checkpoint, model_.spacing, model_.rho0));
            bodies_.set(state.bodies);
            // All digits, which the name of the directory has not
            time_.setTime(state.time, 0);
            lastGood_ = checkpoint;
            return state;
        }
        catch (const std::runtime_error& e)
        {
            FatalErrorInFunction
                << e.what() << exit(FatalError);
        }
    }
    if (time_.value() != 0)
    {
        FatalErrorInFunction
            << "No particles to start from at time " << time_.timeName() << ": " << checkpoint << " is missing" << nl
            << "Expected: a time that plungeSPH has written, or 0, for the geometry." << exit(FatalError);
    }
    return readParticles<dim>(properties_.geometry(), model_, time_.path(), notes_);
}


template<int dim>
Foam::smoothedParticles::particleState<dim> Foam::smoothedParticles::particleSimulation<dim>::state() const
{
    particleState<dim> now(flow_->state());
    now.bodies = bodies_.numbers();
    return now;
}


template<int dim>
void Foam::smoothedParticles::particleSimulation<dim>::build(const particleState<dim>& state)
{
    if (flow_)
    {
        particleSteps_ += flow_->nParticleSteps();
        pairs_ += flow_->nPairs();
        flow_.reset();
    }
    try
    {
        flow_ = newParticleFlow<dim>
        (
            state, model_, nThreads_, bodies_.motions(),
            [this](const label wall, const bodyLoads& loads){ return bodies_.respond(wall, loads); }
        );
    }
    catch (const std::invalid_argument& e)
    {
        FatalIOErrorInFunction(properties_.dict())
            << e.what() << exit(FatalIOError);
    }
    catch (const std::runtime_error& e)
    {
        FatalErrorInFunction
            << e.what() << exit(FatalError);
    }
}


template<int dim>
void Foam::smoothedParticles::particleSimulation<dim>::checkSpeed()
{
    const scalar bound = properties_.boundOnSpeed();
    if (soundSpeedHolds_ && flow_->maxSpeed() > bound)
    {
        soundSpeedHolds_ = false;
        WarningInFunction
            << "At " << time_.value() << " s the flow has " << flow_->maxSpeed() << " m/s, but the speed of sound bears "
            << bound << " m/s: c0 >= 10 v_max does not hold, and the liquid is too compressible." << nl
            << "    energy.csv marks it from here. A larger c0 or maxSpeed in speedOfSound avoids it." << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int dim>
void Foam::smoothedParticles::particleSimulation<dim>::chooseTimeStep()
{
    const scalar stable = flow_->stableTimeStep();
    time_.setDeltaT(stable);
    // Time rounds the number of steps until the next write; the last few would come out too long
    if (time_.deltaTValue() > 1.05*stable)
    {
        time_.setDeltaT(stable/1.5);
    }
}


template<int dim>
void Foam::smoothedParticles::particleSimulation<dim>::advance()
{
    try
    {
        bodies_.advance(*flow_, time_.deltaTValue());
        flow_->advance(time_.deltaTValue());
    }
    catch (const std::runtime_error& e)
    {
        FatalErrorInFunction
            << e.what() << nl
            << "The last good state is " << (lastGood_.empty() ? "the geometry" : lastGood_.c_str()) << nl
            << "Expected: finite numbers. A larger speed of sound, more viscosity or densityDiffusion, or a smaller Courant"
            << " number may help." << exit(FatalError);
    }
    checkSpeed();
}


template<int dim>
void Foam::smoothedParticles::particleSimulation<dim>::report()
{
    tables_.write(*flow_, soundSpeedHolds_);
    bodies_.write(*flow_);
    noteParticlesInWalls();
    progress_.print(*flow_, particleSteps_ + flow_->nParticleSteps(), pairs_ + flow_->nPairs());
}


template<int dim>
void Foam::smoothedParticles::particleSimulation<dim>::endAtEvent()
{
    hasEnded_ = bodies_.end(time_);
}


template<int dim>
void Foam::smoothedParticles::particleSimulation<dim>::stopAtCollision()
{
    const std::string collision(bodies_.collision(contactTolerance*model_.spacing));
    if (collision.size())
    {
        writeNow();
        FatalErrorInFunction
            << collision.c_str() << ", at " << time_.value() << " s: they have no contact, and would pass through each other" << nl
            << "The state has been written to " << time_.timePath() << nl
            << "Expected: an end before, by endTime or until, or a wall that is farther." << exit(FatalError);
    }
}


template<int dim>
void Foam::smoothedParticles::particleSimulation<dim>::noteParticlesInWalls()
{
    const auto inWalls(flow_->particlesInWalls());
    const scalar deepest = inWalls.deepest/model_.spacing;
    // Once, and again where it is twice as bad
    if (deepest > max(0.5, 2*deepestNoted_))
    {
        deepestNoted_ = deepest;
        Info<< "Run" << nl << "    Note: At " << time_.value() << " s the springs of contact let " << label(inWalls.n)
            << " particles behind the surfaces of walls, the deepest by " << deepest << " spacings." << endl;
    }
}


template<int dim>
void Foam::smoothedParticles::particleSimulation<dim>::write()
{
    if (time_.writeTime() || hasEnded_)
    {
        writeNow();
    }
}


template<int dim>
void Foam::smoothedParticles::particleSimulation<dim>::writeNow()
{
    const particleState<dim> state(this->state());
    try
    {
        writeCheckpoint<dim>(time_.timePath(), state, model_.spacing, model_.rho0);
    }
    catch (const std::runtime_error& e)
    {
        FatalErrorInFunction
            << e.what() << exit(FatalError);
    }
    lastGood_ = time_.timePath()/"particles";

    kept_.append(time_.timePath());
    const label nKept = time_.controlDict().template lookupOrDefault<label>("purgeWrite", 0);
    if (nKept > 0 && kept_.size() > nKept)
    {
        rmDir(kept_[kept_.size() - 1 - nKept]);
    }

    vtk_.write(state, model_.rho0);
    bodies_.writeVTK();
    build(state);
}


template class Foam::smoothedParticles::particleSimulation<2>;
template class Foam::smoothedParticles::particleSimulation<3>;

// ************************************************************************* //
