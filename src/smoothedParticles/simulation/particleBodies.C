// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleBodies.H"

#include "particleSetUp.H"

#include "FlatOutput.H"
#include "Switch.H"

#include <algorithm>
#include <stdexcept>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int dim>
Foam::smoothedParticles::particleBodies<dim>::particleBodies
(
    const Time& runTime,
    const particleProperties& properties
)
:
    time_(runTime),
    model_(properties.modelled()),
    surfaceLevel_(properties.outputs().lookupOrDefault<scalar>("surfaceLevel", 0))
{
    if (!properties.dict().found("bodies"))
    {
        return;
    }
    const dictionary& dict = properties.dict().subDict("bodies");
    const wordList wallNames(readWallNames(properties.geometry()));
    const wordList names(dict.toc());
    const PtrList<dictionary> wallDicts(readWalls(properties.geometry()));
    for (const word& name : names)
    {
        const label wall = wallNames.find(name);
        if (wall < 0)
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << name << " is no wall" << nl
                << "Expected: the name of one of the geometry's walls, " << flatOutput(wallNames) << exit(FatalIOError);
        }
        const dictionary& shape = wallDicts[wall];
        if (shape.get<word>("type") == "box" && !shape.lookupOrDefault<Switch>("solid", false))
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << name << " is a tank around the fluid, which cannot move" << nl
                << "Expected: a solid wall." << exit(FatalIOError);
        }
        if (name == "particles")
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << name << " is a wall with the name of VTK/particles.vtp.series" << nl
                << "Expected: another name for a wall that moves." << exit(FatalIOError);
        }
        walls_.append(wall);
        bodies_.append(new freeBody(dict.subDict(name), runTime, properties.gravity()));
        trajectories_.append
        (
            new bodyTrajectory(runTime, names.size() == 1 ? word("trajectory") : word("trajectory_" + name), properties.gravity())
        );
    }
    starts_ = motions();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int dim>
Foam::smoothedParticles::wallMotions Foam::smoothedParticles::particleBodies<dim>::motions() const
{
    wallMotions result;
    forAll(bodies_, i)
    {
        result[walls_[i]] = bodies_[i].state();
    }
    return result;
}


template<int dim>
void Foam::smoothedParticles::particleBodies<dim>::advance(particleFlow<dim>& flow, const scalar deltaT)
{
    forAll(bodies_, i)
    {
        const bodyLoads loads(flow.wallLoads(walls_[i]));
        bodies_[i].advance(loads.pressure + loads.viscous, loads.moment, deltaT);
        flow.moveWall(walls_[i], bodies_[i].state());
    }
}


template<int dim>
void Foam::smoothedParticles::particleBodies<dim>::write(const particleFlow<dim>& flow)
{
    forAll(bodies_, i)
    {
        const bodyState now(bodies_[i].state());
        trajectories_[i].write
        (
            time_.value(),
            now,
            flow.wallLoads(walls_[i]),
            bodies_[i].mass(),
            surfaces_[i].reach(now, -trajectories_[i].up()) + surfaceLevel_,
            model_
        );
    }
}


template<int dim>
void Foam::smoothedParticles::particleBodies<dim>::makeSurfaces(const particleProperties& properties)
{
    if (bodies_.empty())
    {
        return;
    }
    const PtrList<dictionary> wallDicts(readWalls(properties.geometry()));
    for (const label wall : walls_)
    {
        surfaces_.append(new bodyVTK(time_, wallDicts[wall], dim, starts_.at(wall)));
    }
}


template<int dim>
void Foam::smoothedParticles::particleBodies<dim>::writeVTK()
{
    forAll(bodies_, i)
    {
        surfaces_[i].write(bodies_[i].state());
    }
}


template<int dim>
std::vector<double> Foam::smoothedParticles::particleBodies<dim>::numbers() const
{
    std::vector<double> all;
    for (const freeBody& body : bodies_)
    {
        const std::vector<double> some(body.numbers());
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}


template<int dim>
void Foam::smoothedParticles::particleBodies<dim>::set(const std::vector<double>& numbers)
{
    const std::size_t n = bodies_.empty() ? 0 : numbers.size()/bodies_.size();
    if (n*bodies_.size() != numbers.size())
    {
        throw std::runtime_error
        (
            "the state has " + std::to_string(numbers.size()) + " numbers of bodies: expected those of "
          + std::to_string(bodies_.size()) + " bodies"
        );
    }
    forAll(bodies_, i)
    {
        bodies_[i].set(std::vector<double>(numbers.begin() + i*n, numbers.begin() + (i + 1)*n));
    }
}


template class Foam::smoothedParticles::particleBodies<2>;
template class Foam::smoothedParticles::particleBodies<3>;

// ************************************************************************* //
