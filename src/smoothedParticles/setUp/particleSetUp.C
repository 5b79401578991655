// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleSetUp.H"

#include "filledWall.H"
#include "fluidBox.H"
#include "inputChecks.H"
#include "smoothingKernels.H"
#include "thinWalls.H"
#include "walls.H"
#include "weaklyCompressible.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::smoothedParticles;

//- With contact, particles whose edge is deeper than this part of the spacing in a wall are removed. Stretched cells are not;
//  from there a spring with a factor of 0.1 drives a particle to c0/24.
constexpr scalar touching = 0.1;

//- Of a wall's wetted surface: a plate that is too thin on more is refused, on less is no matter
constexpr scalar thinRefused = 0.5;
constexpr scalar thinIgnored = 0.02;


void checkThickness
(
    const dictionary& dict,
    const shape& wall,
    const PtrList<shape>& all,
    const lattice& grid,
    DynamicList<string>& notes
)
{
    if (wall.surrounds())
    {
        return;
    }
    const thinPart thin(findThinPart(wall, all, grid));
    const std::string where
    (
        text
        (
            "a plate down to ", thin.thickness, " m thick, at ", thin.x, ", where the kernel reaches ", grid.support,
            " m: the liquid on its two sides meets through it"
        )
    );
    if (thin.share > thinRefused)
    {
        refuse
        (
            dict,
            text("Wall ", dict.get<word>("name"), " is, on ", label(100*thin.share + 0.5), " % of its surface, ", where),
            text
            (
                "walls ", grid.support, " m thick, or a spacing up to ",
                grid.spacing*thin.thickness/grid.support, " m."
            )
        );
    }
    if (thin.share > thinIgnored)
    {
        notes.append
        (
            text("On ", label(100*thin.share + 0.5), " % of its surface the wall ", dict.get<word>("name"), " is ", where, '.')
        );
    }
}


template<int dim>
std::array<double, dim> toArray(const vector& v)
{
    std::array<double, dim> a;
    for (int d = 0; d < dim; ++d)
    {
        a[d] = v[d];
    }
    return a;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::scalar Foam::smoothedParticles::readSpacing(const dictionary& geometry)
{
    return readPositive(geometry, "spacing", "a positive number [m].");
}


template<int dim>
Foam::smoothedParticles::particleState<dim> Foam::smoothedParticles::readParticles
(
    const dictionary& geometry,
    const particleFlowModel<dim>& model,
    const fileName& caseDirectory,
    DynamicList<string>& notes
)
{
    checkKeywords(geometry, {"spacing", "fluid", "walls"});
    readWallNames(geometry);
    const lattice grid{dim, readSpacing(geometry), supportRatio*model.interaction.h, model.symmetry};

    // What is asked for
    const PtrList<dictionary> fluidDicts(geometry.lookup("fluid"));
    PtrList<fluidBox> fluids(fluidDicts.size());
    scalar nParticles = 0;
    forAll(fluids, i)
    {
        checkChoice(fluidDicts[i], "type", fluidDicts[i].get<word>("type"), {"box"});
        fluids.set(i, new fluidBox(fluidDicts[i], grid));
        nParticles += fluids[i].nParticles();
    }
    const PtrList<dictionary> wallDicts(readWalls(geometry));
    const PtrList<shape> shapes(readShapes(geometry, {dim, caseDirectory, grid.nLayers()*grid.spacing}));
    PtrList<filledWall> walls(shapes.size());
    forAll(walls, i)
    {
        walls.set(i, filledWall::New(wallDicts[i], shapes[i], grid));
        nParticles += walls[i].nParticles();
    }
    if (!(nParticles <= labelMax))
    {
        refuseEntry
        (
            geometry,
            "spacing",
            text("is ", grid.spacing, " m: about ", nParticles, " particles"),
            text("a spacing with at most ", labelMax, " of them.")
        );
    }

    forAll(walls, i)
    {
        checkThickness(wallDicts[i], shapes[i], shapes, grid, notes);
    }

    // With contact walls have no particles, and no particle of fluid starts where it touches one
    const bool contact = model.contact.isOn();
    UPtrList<const filledWall> made;
    for (label i = 0; !contact && i < walls.size(); ++i)
    {
        walls[i].make(made, wallDicts[i]);
        walls[i].checkSolid(wallDicts[i], notes);
        made.append(&walls[i]);
    }

    particleState<dim> state;
    const auto append = [&]
    (
        const point& x, const vector& v, scalar volume, scalar density, scalar pressure, label wall
    )
    {
        state.x.push_back(toArray<dim>(x));
        state.v.push_back(toArray<dim>(v));
        state.density.push_back(density);
        state.mass.push_back((model.rho0 + density)*volume*model.interaction.circumference(x.x()));
        state.pressure.push_back(pressure);
        state.wall.push_back(wall);
    };

    const interactionModel& liquid = model.interaction;
    const titan::MurnaghanLaw law
    (
        0, model.rho0, model.rho0*sqr(liquid.c0)/liquid.gamma, liquid.gamma
    );
    const vector weight(model.rho0*vector(liquid.g[0], liquid.g[1], liquid.g[2]));

    label nInWalls = 0, nInFluid = 0;
    forAll(fluids, i)
    {
        const pointField points(fluids[i].particles());
        const scalarField load(fluids[i].load(points, weight));

        // dp/dz = rho(p) g by Murnaghan's law
        const scalar n = liquid.gamma/(liquid.gamma - 1);
        const scalarField p(law.k0()*(pow(1 + load/(n*law.k0()), n) - 1));
        forAll(points, k)
        {
            bool inFluid = false;
            for (label j = 0; j < i; ++j)
            {
                inFluid = inFluid || fluids[j].contains(points[k]);
            }
            label wall = 0;
            while
            (
                wall < walls.size()
             && !(contact ? model.contact.touches(wall, points[k], touching*grid.spacing) : walls[wall].occupies(points[k]))
            )
            {
                ++wall;
            }
            if (wall < walls.size())
            {
                ++nInWalls;
                ++walls[wall].nFluidRemoved;
            }
            else if (inFluid)
            {
                ++nInFluid;
            }
            else if (isOnNearSide(points[k], grid.symmetry, sizeTolerance*grid.spacing))
            {
                append
                (
                    points[k], fluids[i].velocity,
                    cmptProduct(fluids[i].cell()), law.density(p[k]) - law.rho0(), p[k], particleState<dim>::fluid
                );
            }
        }
    }

    if (state.x.empty())
    {
        refuse
        (
            geometry,
            "Entry fluid: no particle of fluid" + (nInWalls ? text(", all ", nInWalls, " are in walls") : std::string()),
            "at least one box of fluid outside the walls."
        );
    }

    Info<< "Particles, " << grid.spacing << " m apart" << nl
        << "    fluid: " << label(state.size()) << ", removed " << nInWalls
        << " in or near walls, " << nInFluid << " twice in fluid" << nl;
    forAll(walls, i)
    {
        const wallParticles& particles = walls[i].particles();
        forAll(particles.x, k)
        {
            append(particles.x[k], Zero, particles.volume[k], 0, 0, i);
        }
        Info<< "    wall " << walls[i].name << ": " << particles.x.size()
            << ", removed " << walls[i].nRemoved << " in or near other walls, and "
            << walls[i].nFluidRemoved << " of the fluid" << nl;
        if (!contact)
        {
            walls[i].printSolid(Info);
        }
    }
    Info<< endl;
    return state;
}


// * * * * * * * * * * * * * Explicit Instantiation  * * * * * * * * * * * * //

template Foam::smoothedParticles::particleState<2> Foam::smoothedParticles::readParticles
(
    const dictionary&,
    const particleFlowModel<2>&,
    const fileName&,
    DynamicList<string>&
);

template Foam::smoothedParticles::particleState<3> Foam::smoothedParticles::readParticles
(
    const dictionary&,
    const particleFlowModel<3>&,
    const fileName&,
    DynamicList<string>&
);

// ************************************************************************* //
