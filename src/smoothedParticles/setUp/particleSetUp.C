// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleSetUp.H"
#include "fluidSelection.H"
#include "smoothingKernels.H"
#include "weaklyCompressible.H"

#include "DynamicList.H"
#include "FlatOutput.H"
#include "indexedOctree.H"
#include "OSspecific.H"
#include "orientedSurface.H"
#include "PtrList.H"
#include "Switch.H"
#include "treeDataPoint.H"
#include "triSurface.H"
#include "triSurfaceSearch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::smoothedParticles;

//- Particles nearer than this part of the spacing to one of a wall are removed. Round-off does not decide at the half.
constexpr scalar nearest = 0.5*(1 - 1e-6);

//- Cells by which a box may miss a multiple of the spacing
constexpr scalar sizeTolerance = 1e-6;


//- What all parts of the geometry know
struct lattice
{
    int dim;
    scalar spacing;
    scalar support;     //!< of the kernel [m]

    //- Cells of about the spacing that fill a box; one across the plane
    vector nCells(const boundBox& box) const
    {
        vector n(1, 1, 1);
        for (direction d = 0; d < dim; ++d)
        {
            n[d] = std::round((box.max()[d] - box.min()[d])/spacing);
        }
        return n;
    }

    bool isMultiple(const boundBox& box) const
    {
        const vector n(nCells(box));
        bool multiple = true;
        for (direction d = 0; d < dim; ++d)
        {
            multiple =
                multiple
             && mag((box.max()[d] - box.min()[d])/spacing - n[d]) < sizeTolerance;
        }
        return multiple;
    }

    //- Layers of a wall, the first half a spacing behind its face, that a particle on the face can feel
    label nLayers() const
    {
        return label(std::ceil(support/spacing - 0.5 - sizeTolerance));
    }
};


vector readVector(const dictionary& dict, const word& key, const int dim)
{
    const vector v(dict.get<vector>(key));
    if (dim == 2 && v.z() != 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " is " << v << " in a two-dimensional case" << nl
            << "Expected: a third component of 0." << exit(FatalIOError);
    }
    return v;
}


boundBox readBox(const dictionary& dict, const lattice& grid)
{
    const boundBox box(readVector(dict, "min", grid.dim), readVector(dict, "max", grid.dim));
    for (direction d = 0; d < grid.dim; ++d)
    {
        if (!(box.min()[d] < box.max()[d]))
        {
            FatalIOErrorInFunction(dict)
                << "Entries min and max are " << box.min() << " and " << box.max() << nl
                << "Expected: min below max in each direction." << exit(FatalIOError);
        }
        if (!(grid.nCells(box)[d] >= 1))
        {
            FatalIOErrorInFunction(dict)
                << "Entries min and max are " << box.min() << " and " << box.max() << nl
                << "Expected: a box of at least the spacing, " << grid.spacing
                << " m, in each direction." << exit(FatalIOError);
        }
    }
    return box;
}


//- FatalIOError unless the entry type is among these
word readType(const dictionary& dict, const wordList& types)
{
    const word type(dict.get<word>("type"));
    if (!types.found(type))
    {
        FatalIOErrorInFunction(dict)
            << "Entry type is " << type << nl
            << "Expected: any of " << flatOutput(types) << exit(FatalIOError);
    }
    return type;
}


PtrList<dictionary> readDictionaries(const dictionary& geometry, const word& key)
{
    return PtrList<dictionary>(geometry.lookup(key));
}


//- Coordinates of the particles in each direction
typedef FixedList<DynamicList<scalar>, 3> latticeLines;

//- Add the middles of n cells
void appendCells(DynamicList<scalar>& line, const scalar from, const scalar size, const label n)
{
    for (label i = 0; i < n; ++i)
    {
        line.append(from + (i + 0.5)*size);
    }
}


//- Lines of n cells each that fill a box
latticeLines fill(const boundBox& box, const vector& n)
{
    latticeLines lines;
    for (direction d = 0; d < 3; ++d)
    {
        appendCells(lines[d], box.min()[d], (box.max()[d] - box.min()[d])/n[d], label(n[d]));
    }
    return lines;
}


//- All crossings of the lines that the condition holds for
template<class Condition>
pointField crossings(const latticeLines& lines, const Condition& wanted)
{
    DynamicList<point> points;
    for (const scalar x : lines[0])
    {
        for (const scalar y : lines[1])
        {
            for (const scalar z : lines[2])
            {
                if (wanted(point(x, y, z)))
                {
                    points.append(point(x, y, z));
                }
            }
        }
    }
    return pointField(std::move(points));
}


//- One of the list walls
class wallShape
{
    pointField particles_;

    autoPtr<indexedOctree<treeDataPoint>> tree_;


protected:

    const lattice grid_;

    virtual pointField fillUp() const = 0;


public:

    const word name;

    //- Removed because another wall was there
    label nRemoved = 0;


    wallShape(const dictionary& dict, const lattice& grid)
    :
        grid_(grid),
        name(dict.get<word>("name"))
    {}

    virtual ~wallShape() = default;

    //- At most so many particles, before any is made
    virtual scalar nParticles() const = 0;

    //- Is a point in the wall?
    virtual bool contains(const point&) const = 0;

    const pointField& particles() const
    {
        return particles_;
    }

    //- Is a point in the wall or too near to one of its particles?
    bool occupies(const point& p) const
    {
        return contains(p) || tree_->findNearest(p, sqr(nearest*grid_.spacing)).hit();
    }

    //- Make the particles where these other walls are not
    void make(const UPtrList<const wallShape>& others, const dictionary& dict)
    {
        DynamicList<point> kept;
        for (const point& p : fillUp())
        {
            bool occupied = false;
            forAll(others, i)
            {
                occupied = occupied || others[i].occupies(p);
            }
            if (occupied)
            {
                ++nRemoved;
            }
            else
            {
                kept.append(p);
            }
        }
        if (kept.empty())
        {
            FatalIOErrorInFunction(dict)
                << "Wall " << name << " has no particles; " << nRemoved
                << " were removed where there is another wall" << nl
                << "Expected: a larger wall, or a spacing below "
                << grid_.spacing << " m." << exit(FatalIOError);
        }

        particles_.transfer(kept);
        treeBoundBox bounds(particles_);
        bounds.min() -= vector::uniform(grid_.spacing);
        bounds.max() += vector::uniform(grid_.spacing);
        tree_.reset
        (
            new indexedOctree<treeDataPoint>
            (
                treeDataPoint(particles_),
                bounds,
                10,     // levels
                10,     // points of a leaf
                3.0     // copies of a point
            )
        );
    }
};


class boxWall
:
    public wallShape
{
protected:

    const boundBox box_;
    const vector n_;

public:

    boxWall(const dictionary& dict, const lattice& grid)
    :
        wallShape(dict, grid),
        box_(readBox(dict, grid)),
        n_(grid.nCells(box_))
    {
        if (!grid.isMultiple(box_))
        {
            IOWarningInFunction(dict)
                << "Wall " << name << ": the size of the box, " << box_.max() - box_.min()
                << " m, is no multiple of the spacing, " << grid.spacing << " m." << nl
                << "    Its particles are stretched to cells of "
                << cmptDivide(box_.max() - box_.min(), n_) << " m." << endl;
        }
    }
};


//- Around a box
class tankWall
:
    public boxWall
{
    boolList open_;

    //- The box and its walls
    boundBox outside_;


    pointField fillUp() const
    {
        latticeLines lines(fill(box_, n_));
        for (direction d = 0; d < grid_.dim; ++d)
        {
            const scalar dp = grid_.spacing;
            const label n = grid_.nLayers();
            if (!open_[2*d])
            {
                appendCells(lines[d], box_.min()[d], -dp, n);
            }
            if (!open_[2*d + 1])
            {
                appendCells(lines[d], box_.max()[d], dp, n);
            }
        }
        return crossings(lines, [&](const point& p){ return !box_.contains(p); });
    }


public:

    tankWall(const dictionary& dict, const lattice& grid)
    :
        boxWall(dict, grid),
        open_(2*grid.dim, false),
        outside_(box_)
    {
        titan::checkKeywords(dict, {"name", "type", "solid", "min", "max", "open"});

        for (const word& face : dict.lookupOrDefault<wordList>("open", wordList()))
        {
            open_[faceOf(face, grid.dim, dict, "open")] = true;
        }

        const scalar thickness = grid.nLayers()*grid.spacing;
        for (direction d = 0; d < grid.dim; ++d)
        {
            outside_.min()[d] -= open_[2*d] ? 0 : thickness;
            outside_.max()[d] += open_[2*d + 1] ? 0 : thickness;
        }
    }

    scalar nParticles() const
    {
        scalar all = 1;
        for (direction d = 0; d < grid_.dim; ++d)
        {
            all *= n_[d] + (!open_[2*d] + !open_[2*d + 1])*grid_.nLayers();
        }
        return all - cmptProduct(n_);
    }

    bool contains(const point& p) const
    {
        return outside_.contains(p) && !box_.contains(p);
    }
};


//- A full box. Deeper than the kernel reaches there are no particles
class solidBox
:
    public boxWall
{
    pointField fillUp() const
    {
        return crossings
        (
            fill(box_, n_),
            [&](const point& p)
            {
                bool deep = true;
                for (direction d = 0; d < grid_.dim; ++d)
                {
                    deep = deep && min(p[d] - box_.min()[d], box_.max()[d] - p[d]) > grid_.support;
                }
                return !deep;
            }
        );
    }


public:

    solidBox(const dictionary& dict, const lattice& grid)
    :
        boxWall(dict, grid)
    {
        titan::checkKeywords(dict, {"name", "type", "solid", "min", "max"});
    }

    scalar nParticles() const
    {
        scalar deep = 1;
        for (direction d = 0; d < grid_.dim; ++d)
        {
            deep *= max(n_[d] - 2*grid_.nLayers(), scalar(0));
        }
        return cmptProduct(n_) - deep;
    }

    bool contains(const point& p) const
    {
        return box_.contains(p);
    }
};


//- Inside of a surface. Deeper than the kernel reaches there are no particles
class surfaceWall
:
    public wallShape
{
    const fileName file_;
    triSurface surface_;
    triSurfaceSearch search_;
    boundBox box_;


    static fileName find(const dictionary& dict, const fileName& caseDirectory)
    {
        fileName file(dict.get<fileName>("file"));
        file.expand();
        if (!file.isAbsolute())
        {
            file = caseDirectory/file;
        }
        if (!isFile(file))
        {
            FatalIOErrorInFunction(dict)
                << "Entry file: there is no " << file << nl
                << "Expected: a surface, relative to the case." << exit(FatalIOError);
        }
        return file;
    }

    void checkWatertight(const dictionary& dict) const
    {
        label first = -1, nOpen = 0;
        forAll(surface_.edgeFaces(), i)
        {
            if (surface_.edgeFaces()[i].size() != 2)
            {
                first = nOpen++ ? first : i;
            }
        }
        if (surface_.empty())
        {
            FatalIOErrorInFunction(dict)
                << "Entry file: " << file_ << " has no triangles" << nl
                << "Expected: a watertight surface." << exit(FatalIOError);
        }
        if (nOpen)
        {
            const edge& e = surface_.edges()[first];
            FatalIOErrorInFunction(dict)
                << "Entry file: " << file_ << " leaks: " << nOpen << " of its "
                << surface_.nEdges() << " edges have not exactly two triangles; the first, from "
                << surface_.localPoints()[e.start()] << " to " << surface_.localPoints()[e.end()]
                << ", has " << surface_.edgeFaces()[first].size() << nl
                << "Expected: a watertight surface." << exit(FatalIOError);
        }
    }

    //- In the middle of the surface's bounding box, so that the particles are as symmetric as the surface
    latticeLines lines() const
    {
        const vector n(nCells());
        const vector half(0.5*grid_.spacing*n);
        return fill(boundBox(box_.midpoint() - half, box_.midpoint() + half), n);
    }

    vector nCells() const
    {
        return max(grid_.nCells(box_), vector(1, 1, 1));
    }

    pointField fillUp() const
    {
        return crossings
        (
            lines(),
            [&](const point& p)
            {
                return search_.tree().findNearest(p, sqr(grid_.support)).hit() && contains(p);
            }
        );
    }


public:

    surfaceWall(const dictionary& dict, const lattice& grid, const fileName& caseDirectory)
    :
        wallShape(dict, grid),
        file_(find(dict, caseDirectory)),
        surface_(file_),
        search_(surface_),
        box_(surface_.points(), false)
    {
        titan::checkKeywords(dict, {"name", "type", "file"});
        checkWatertight(dict);
        orientedSurface::orient(surface_, search_, box_.max() + box_.span(), true);
    }

    scalar nParticles() const
    {
        return cmptProduct(nCells());
    }

    bool contains(const point& p) const
    {
        return
            box_.contains(p)
         && search_.tree().getVolumeType(p) == volumeType::INSIDE;
    }
};


autoPtr<wallShape> newWall
(
    const dictionary& dict,
    const lattice& grid,
    const fileName& caseDirectory
)
{
    const word type
    (
        readType(dict, grid.dim == 2 ? wordList({"box"}) : wordList({"box", "surface"}))
    );
    if (type == "surface")
    {
        return autoPtr<wallShape>(new surfaceWall(dict, grid, caseDirectory));
    }
    if (dict.lookupOrDefault<Switch>("solid", false))
    {
        return autoPtr<wallShape>(new solidBox(dict, grid));
    }
    return autoPtr<wallShape>(new tankWall(dict, grid));
}


//- One of the list fluid
class fluidBox
{
    const dictionary& dict_;
    const lattice grid_;
    const boundBox box_;
    const vector n_;

public:

    const vector velocity;

    fluidBox(const dictionary& dict, const lattice& grid)
    :
        dict_(dict),
        grid_(grid),
        box_(readBox(dict, grid)),
        n_(grid.nCells(box_)),
        velocity(dict.found("velocity") ? readVector(dict, "velocity", grid.dim) : Zero)
    {
        titan::checkKeywords(dict, {"type", "min", "max", "velocity", "hydrostatic", "surface"});

        if (!grid.isMultiple(box_))
        {
            scalar asked = 1;
            for (direction d = 0; d < grid.dim; ++d)
            {
                asked *= box_.max()[d] - box_.min()[d];
            }
            IOWarningInFunction(dict)
                << "Box of fluid: its size, " << box_.max() - box_.min()
                << " m, is no multiple of the spacing, " << grid.spacing << " m." << nl
                << "    The volume is " << nParticles()*std::pow(grid.spacing, grid.dim)
                << " instead of " << asked << (grid.dim == 2 ? " m2." : " m3.") << endl;
        }
    }

    scalar nParticles() const
    {
        return cmptProduct(n_);
    }

    //- What the particles fill
    boundBox filled() const
    {
        point end(box_.max());
        for (direction d = 0; d < grid_.dim; ++d)
        {
            end[d] = box_.min()[d] + n_[d]*grid_.spacing;
        }
        return boundBox(box_.min(), end);
    }

    pointField particles() const
    {
        return crossings(fill(filled(), n_), [](const point&){ return true; });
    }

    //- What weighs on these particles at rest [Pa], if the liquid were not compressed: the weight per volume rho0 g times depth
    scalarField load(const pointField& points, const vector& weight) const
    {
        const bool given = dict_.found("surface");
        if (!dict_.lookupOrDefault<Switch>("hydrostatic", true))
        {
            if (given)
            {
                FatalIOErrorInFunction(dict_)
                    << "Entry surface is given, but hydrostatic is off" << nl
                    << "Expected: one of them." << exit(FatalIOError);
            }
            return scalarField(points.size(), Zero);
        }

        const vector up(mag(weight) > 0 ? -weight/mag(weight) : vector::zero);
        const scalar top = cmptSum(max(cmptMultiply(up, box_.min()), cmptMultiply(up, box_.max())));
        const scalar surface = given ? dict_.get<scalar>("surface") : top;
        if (given && surface < top - sizeTolerance*grid_.spacing)
        {
            FatalIOErrorInFunction(dict_)
                << "Entry surface is " << surface << " m, below the highest corner of the box at "
                << top << " m" << nl
                << "Expected: a height at or above it." << exit(FatalIOError);
        }

        // A box rounded up to whole particles can end with one on its surface
        return max(mag(weight)*(surface - (points & up)), scalar(0));
    }
};


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
    const scalar spacing = geometry.get<scalar>("spacing");
    if (!(spacing > 0) || !std::isfinite(spacing))
    {
        FatalIOErrorInFunction(geometry)
            << "Entry spacing is " << spacing << nl
            << "Expected: a positive number [m]." << exit(FatalIOError);
    }
    return spacing;
}


Foam::label Foam::smoothedParticles::faceOf(const word& face, const int dim, const dictionary& dict, const word& entry)
{
    static const wordList plane({"left", "right", "bottom", "top"});
    static const wordList space({"left", "right", "front", "back", "bottom", "top"});
    const wordList& faces = dim == 2 ? plane : space;
    const label i = faces.find(face);
    if (i < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " has the face " << face << nl
            << "Expected: any of " << flatOutput(faces) << exit(FatalIOError);
    }
    return i;
}


Foam::wordList Foam::smoothedParticles::readWallNames(const dictionary& geometry)
{
    DynamicList<word> names;
    if (geometry.found("walls"))
    {
        for (const dictionary& wall : readDictionaries(geometry, "walls"))
        {
            const word name(wall.get<word>("name"));
            if (names.found(name))
            {
                FatalIOErrorInFunction(geometry)
                    << "Entry walls: two walls have the name " << name << nl
                    << "Expected: different names." << exit(FatalIOError);
            }
            names.append(name);
        }
    }
    return wordList(std::move(names));
}


template<int dim>
Foam::smoothedParticles::particleState<dim> Foam::smoothedParticles::readParticles
(
    const dictionary& geometry,
    const particleFlowModel<dim>& model,
    const fileName& caseDirectory
)
{
    titan::checkKeywords(geometry, {"spacing", "fluid", "walls"});
    readWallNames(geometry);
    const lattice grid{dim, readSpacing(geometry), supportRatio*model.interaction.h};

    // What is asked for
    const PtrList<dictionary> fluidDicts(readDictionaries(geometry, "fluid"));
    PtrList<fluidBox> fluids(fluidDicts.size());
    scalar nParticles = 0;
    forAll(fluids, i)
    {
        readType(fluidDicts[i], {"box"});
        fluids.set(i, new fluidBox(fluidDicts[i], grid));
        nParticles += fluids[i].nParticles();
    }
    const PtrList<dictionary> wallDicts
    (
        geometry.found("walls") ? readDictionaries(geometry, "walls") : PtrList<dictionary>()
    );
    PtrList<wallShape> walls(wallDicts.size());
    forAll(walls, i)
    {
        walls.set(i, newWall(wallDicts[i], grid, caseDirectory));
        nParticles += walls[i].nParticles();
    }
    if (!(nParticles <= labelMax))
    {
        FatalIOErrorInFunction(geometry)
            << "Entry spacing is " << grid.spacing << " m: about " << nParticles << " particles" << nl
            << "Expected: a spacing with at most " << labelMax << " of them." << exit(FatalIOError);
    }

    UPtrList<const wallShape> made;
    forAll(walls, i)
    {
        walls[i].make(made, wallDicts[i]);
        made.append(&walls[i]);
    }

    particleState<dim> state;
    const auto append = [&](const point& x, const vector& v, scalar density, scalar pressure, label wall)
    {
        state.x.push_back(toArray<dim>(x));
        state.v.push_back(toArray<dim>(v));
        state.density.push_back(density);
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
            bool inFluid = false, inWall = false;
            for (label j = 0; j < i; ++j)
            {
                inFluid = inFluid || fluids[j].filled().contains(points[k]);
            }
            forAll(walls, j)
            {
                inWall = inWall || walls[j].occupies(points[k]);
            }
            nInWalls += inWall;
            nInFluid += inFluid && !inWall;
            if (!inFluid && !inWall)
            {
                append
                (
                    points[k], fluids[i].velocity,
                    law.density(p[k]) - law.rho0(), p[k], particleState<dim>::fluid
                );
            }
        }
    }

    if (state.x.empty())
    {
        FatalIOErrorInFunction(geometry)
            << "Entry fluid: no particle of fluid";
        if (nInWalls)
        {
            FatalIOError << ", all " << nInWalls << " are in walls";
        }
        FatalIOError
            << nl << "Expected: at least one box of fluid outside the walls." << exit(FatalIOError);
    }

    Info<< "Particles, " << grid.spacing << " m apart" << nl
        << "    fluid: " << label(state.size()) << ", removed " << nInWalls
        << " in or near walls, " << nInFluid << " twice in fluid" << nl;
    forAll(walls, i)
    {
        for (const point& x : walls[i].particles())
        {
            append(x, Zero, 0, 0, i);
        }
        Info<< "    wall " << walls[i].name << ": " << walls[i].particles().size()
            << ", removed " << walls[i].nRemoved << " in or near other walls" << nl;
    }
    Info<< endl;
    return state;
}


// * * * * * * * * * * * * * Explicit Instantiation  * * * * * * * * * * * * //

template Foam::smoothedParticles::particleState<2> Foam::smoothedParticles::readParticles
(
    const dictionary&,
    const particleFlowModel<2>&,
    const fileName&
);

template Foam::smoothedParticles::particleState<3> Foam::smoothedParticles::readParticles
(
    const dictionary&,
    const particleFlowModel<3>&,
    const fileName&
);

// ************************************************************************* //
