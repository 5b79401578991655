// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleBodies.H"

#include "wallLayers.H"
#include "walls.H"

#include "FlatOutput.H"
#include "inputChecks.H"

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
    surfaceLevel_(properties.outputs().lookupOrDefault<scalar>("surfaceLevel", 0)),
    symmetry_(properties.symmetry())
{
    const bool ends = properties.dict().found("until");
    if (!properties.dict().found("bodies"))
    {
        if (ends)
        {
            refuseEntry
            (
                properties.dict(),
                "until",
                "is given, but nothing moves",
                "no such entry, or a body in bodies."
            );
        }
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
            refuseEntry
            (
                dict,
                name,
                "is no wall",
                text("the name of one of the geometry's walls, ", flatOutput(wallNames))
            );
        }
        shapes_.append(shape::New(wallDicts[wall], {dim, runTime.path()}));
        if (shapes_.last().surrounds())
        {
            refuseEntry(dict, name, "is a tank around the fluid, which cannot move", "a solid wall.");
        }
        if (name == "particles")
        {
            refuseEntry
            (
                dict,
                name,
                "is a wall with the name of VTK/particles.vtp.series",
                "another name for a wall that moves."
            );
        }
        walls_.append(wall);
        names_.append(name);
        bodies_.append(new freeBody(dict.subDict(name), runTime, properties.gravity()));
        trajectories_.append
        (
            new bodyTrajectory(runTime, names.size() == 1 ? word("trajectory") : word("trajectory_" + name), properties.gravity())
        );
    }
    starts_ = motions();
    wallNames_ = wallNames;
    obstacles_ = readShapes(properties.geometry(), properties.shapesOf(runTime.path()));
    for (const shape& one : obstacles_)
    {
        surfaces0_.append(new pointField(one.outline().points));
    }
    if (ends)
    {
        if (bodies_.size() != 1)
        {
            refuseEntry
            (
                properties.dict(),
                "until",
                text("is given, but there are ", bodies_.size(), " bodies"),
                "one body."
            );
        }
        until_.reset(new bodyEvent(properties.dict(), "until"));
    }
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
Foam::bodyAcceleration Foam::smoothedParticles::particleBodies<dim>::respond(const label wall, const bodyLoads& loads)
{
    return bodies_[walls_.find(wall)].accelerationUnder(loads.pressure + loads.viscous, loads.moment);
}


template<int dim>
void Foam::smoothedParticles::particleBodies<dim>::write(const particleFlow<dim>& flow)
{
    forAll(bodies_, i)
    {
        // The acceleration of the loads beside it, not the mean of the last step
        bodyState now(bodies_[i].state());
        const bodyAcceleration a(respond(walls_[i], flow.wallLoads(walls_[i])));
        now.acceleration = a.linear;
        now.angularAcceleration = a.angular;
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
bool Foam::smoothedParticles::particleBodies<dim>::end(Time& time)
{
    if (!until_)
    {
        return false;
    }
    const bodyState now(bodies_[0].state());
    const vector& up = trajectories_[0].up();
    const bool happened = until_->hasHappened
    ({
        -surfaces_[0].reach(now, -up) - surfaceLevel_,
        surfaces_[0].reach(now, up) - surfaceLevel_,
        mag(now.velocity),
        now.velocity & up
    });
    if (happened)
    {
        until_->end(time);
    }
    return happened;
}


template<int dim>
bool Foam::smoothedParticles::particleBodies<dim>::reachesInto
(
    const label wall,
    const label other,
    const scalar tolerance,
    point& where
) const
{
    const shape& solid = obstacles_[other];
    const auto poseOf = [&](const label w)
    {
        const label i = bodyOf(w);
        bodyState rest{Zero, tensor::I, Zero, Zero, Zero, Zero};
        return i < 0 ? std::make_pair(rest, rest) : std::make_pair(bodyState(bodies_[i].state()), starts_.at(w));
    };
    const auto from = poseOf(wall), to = poseOf(other);

    // From the geometry's axes, where the surfaces are, to those of now and back to the other's of then
    const tensor turn(from.first.orientation & from.second.orientation.T());
    const tensor back(to.second.orientation & to.first.orientation.T());
    for (const point& p : surfaces0_[wall])
    {
        const point now(from.first.centreOfMass + (turn & (p - from.second.centreOfMass)));
        const point then(to.second.centreOfMass + (back & (now - to.first.centreOfMass)));
        if
        (
            solid.bounds().contains(then) && isOnNearSide(now, symmetry_) && solid.contains(then)
         && solid.findNearest(then, GREAT).depth > tolerance
        )
        {
            where = now;
            return true;
        }
    }
    return false;
}


template<int dim>
std::string Foam::smoothedParticles::particleBodies<dim>::collision(const scalar tolerance) const
{
    for (const label body : walls_)
    {
        forAll(obstacles_, other)
        {
            point where;
            const bool isBody = bodyOf(other) >= 0;
            if
            (
                other != body && !(isBody && other < body)
             && (
                    reachesInto(body, other, tolerance, where)
                 || (!obstacles_[other].surrounds() && reachesInto(other, body, tolerance, where))
                )
            )
            {
                return text
                (
                    "The body ", wallNames_[body], " meets the ", isBody ? "body " : "wall ", wallNames_[other], " at ", where, " m"
                );
            }
        }
    }
    return "";
}


template<int dim>
void Foam::smoothedParticles::particleBodies<dim>::makeSurfaces()
{
    forAll(bodies_, i)
    {
        surfaces_.append(new bodyVTK(time_, names_[i], shapes_[i], starts_.at(walls_[i])));
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
    if (until_)
    {
        const FixedList<scalar, 2> memory(until_->memory());
        all.insert(all.end(), memory.begin(), memory.end());
    }
    return all;
}


template<int dim>
void Foam::smoothedParticles::particleBodies<dim>::set(const std::vector<double>& numbers)
{
    std::size_t n = 0;
    for (const freeBody& body : bodies_)
    {
        n += body.numbers().size();
    }
    constexpr std::size_t nMemory = 2;
    if (numbers.size() != n && numbers.size() != n + nMemory)
    {
        throw std::runtime_error
        (
            "the state has " + std::to_string(numbers.size()) + " numbers of bodies: expected those of "
          + std::to_string(bodies_.size()) + " bodies"
        );
    }
    auto next = numbers.begin();
    for (freeBody& body : bodies_)
    {
        const auto first = next;
        next += body.numbers().size();
        body.set(std::vector<double>(first, next));
    }
    // What was written without the entry until remembers nothing
    if (until_ && numbers.size() == n + nMemory)
    {
        until_->remember({next[0], next[1]});
    }
}


template class Foam::smoothedParticles::particleBodies<2>;
template class Foam::smoothedParticles::particleBodies<3>;

// ************************************************************************* //
