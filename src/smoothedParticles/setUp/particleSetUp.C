// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleSetUp.H"
#include "fluidSelection.H"
#include "pointColumns.H"
#include "smoothingKernels.H"
#include "wallLayers.H"
#include "weaklyCompressible.H"

#include "DynamicList.H"
#include "FlatOutput.H"
#include "PtrList.H"
#include "Switch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::smoothedParticles;

//- Particles nearer than this part of the spacing to one of a wall are removed. Round-off does not decide at the half.
constexpr scalar nearest = 0.5*(1 - 1e-6);

//- With contact, particles whose edge is deeper than this part of the spacing in a wall are removed. Stretched cells are not;
//  from there a spring with a factor of 0.1 drives a particle to c0/24.
constexpr scalar touching = 0.1;

//- Cells by which a box may miss a multiple of the spacing
constexpr scalar sizeTolerance = 1e-6;


//- What all parts of the geometry know
struct lattice
{
    int dim;
    scalar spacing;
    scalar support;     //!< of the kernel [m]
    const std::vector<symmetryPlane>& symmetry;

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
                << "Expected: a box of at least half the spacing, " << grid.spacing
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
    wallParticles particles_;
    autoPtr<pointColumns> columns_;

    //- Around the wall and all that is too near to one of its particles
    boundBox reach_;


protected:

    const lattice grid_;

    virtual wallParticles fillUp() = 0;

    virtual boundBox bounds() const = 0;

    //- Is a point in the wall?
    virtual bool contains(const point&) const = 0;

    //- Of a closed wall: its solid, and what its particles, and cells where it has none, make of it
    solidMeasures solid_, represented_;


public:

    const word name;

    //- Removed because another wall was there
    label nRemoved = 0;

    //- Particles of fluid removed because this wall is there
    label nFluidRemoved = 0;


    wallShape(const dictionary& dict, const lattice& grid)
    :
        grid_(grid),
        name(dict.get<word>("name"))
    {}

    virtual ~wallShape() = default;

    //- At most so many particles, before any is made
    virtual scalar nParticles() const = 0;

    const wallParticles& particles() const
    {
        return particles_;
    }

    //- Is a point in the wall or too near to one of its particles?
    bool occupies(const point& p) const
    {
        return reach_.contains(p) && (contains(p) || columns_->findNearest(p, nearest*grid_.spacing) >= 0);
    }

    //- Make the particles where these other walls are not
    void make(const UPtrList<const wallShape>& others, const dictionary& dict)
    {
        const wallParticles all(fillUp());
        DynamicList<point> kept;
        DynamicList<scalar> volume;
        forAll(all.x, k)
        {
            bool occupied = false;
            forAll(others, i)
            {
                occupied = occupied || others[i].occupies(all.x[k]);
            }
            if (occupied)
            {
                ++nRemoved;
            }
            else if (isOnNearSide(all.x[k], grid_.symmetry, sizeTolerance*grid_.spacing))
            {
                kept.append(all.x[k]);
                volume.append(all.volume[k]);
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

        particles_.x.transfer(kept);
        particles_.volume.transfer(volume);
        columns_.reset(new pointColumns(particles_.x, grid_.spacing));
        reach_ = bounds();
        reach_.min() -= vector::uniform(grid_.spacing);
        reach_.max() += vector::uniform(grid_.spacing);
    }

    //- How well the particles represent a closed wall's solid
    void printSolid(Ostream& os) const
    {
        if (solid_.volume > 0)
        {
            os  << "        " << (grid_.dim == 2 ? "area" : "volume") << " of the lattice " << represented_.volume
                << ", of the shape " << solid_.volume << (grid_.dim == 2 ? " m2" : " m3") << " ("
                << 100*(represented_.volume/solid_.volume - 1) << " %); centroids "
                << mag(represented_.centroid() - solid_.centroid())/grid_.spacing << " spacings apart; inertia differs by "
                << 100*mag(represented_.inertia() - solid_.inertia())/mag(solid_.inertia()) << " %" << nl;
        }
    }
};


class boxWall
:
    public wallShape
{
protected:

    const boundBox box_;
    const vector n_;

    //- Cells that a box is filled with are stretched, others are cubes
    scalar cellVolume(const point& p) const
    {
        scalar volume = 1;
        for (direction d = 0; d < grid_.dim; ++d)
        {
            const bool inside = box_.min()[d] < p[d] && p[d] < box_.max()[d];
            volume *= inside ? (box_.max()[d] - box_.min()[d])/n_[d] : grid_.spacing;
        }
        return volume;
    }

    wallParticles withVolumes(pointField&& x) const
    {
        scalarField volume(x.size());
        forAll(x, i)
        {
            volume[i] = cellVolume(x[i]);
        }
        return {std::move(x), std::move(volume)};
    }


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


    wallParticles fillUp()
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
        return withVolumes(crossings(lines, [&](const point& p){ return !box_.contains(p); }));
    }

    boundBox bounds() const
    {
        return outside_;
    }

    bool contains(const point& p) const
    {
        return outside_.contains(p) && !box_.contains(p);
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
};


//- A full box. Deeper than the kernel reaches there are no particles
class solidBox
:
    public boxWall
{
    wallParticles fillUp()
    {
        return withVolumes
        (
            crossings
            (
                fill(box_, n_),
                [&](const point& p)
                {
                    represented_.add(p, cellVolume(p));
                    bool deep = true;
                    for (direction d = 0; d < grid_.dim; ++d)
                    {
                        deep = deep && min(p[d] - box_.min()[d], box_.max()[d] - p[d]) > grid_.support;
                    }
                    return !deep;
                }
            )
        );
    }

    boundBox bounds() const
    {
        return box_;
    }

    bool contains(const point& p) const
    {
        return box_.contains(p);
    }


public:

    solidBox(const dictionary& dict, const lattice& grid)
    :
        boxWall(dict, grid)
    {
        titan::checkKeywords(dict, {"name", "type", "solid", "min", "max"});

        const vector size(box_.span());
        const scalar volume = grid.dim == 2 ? size.x()*size.y() : cmptProduct(size);
        const vector second(volume/12*cmptMultiply(size, size));
        solid_.add(box_.midpoint(), volume, symmTensor(second.x(), 0, 0, second.y(), 0, second.z()));
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
};


//- A full sphere, or circle
class sphereWall
:
    public wallShape
{
    const point centre_;
    const scalar radius_;


    wallParticles fillUp()
    {
        return sphereLayers(centre_, radius_, grid_.dim, grid_.spacing, grid_.nLayers(), represented_);
    }

    boundBox bounds() const
    {
        const vector toCorner(radius_, radius_, grid_.dim == 2 ? 0 : radius_);
        return boundBox(centre_ - toCorner, centre_ + toCorner);
    }

    bool contains(const point& p) const
    {
        return magSqr(p - centre_) <= sqr(radius_);
    }


public:

    sphereWall(const dictionary& dict, const lattice& grid)
    :
        wallShape(dict, grid),
        centre_(readVector(dict, "centre", grid.dim)),
        radius_(dict.get<scalar>("radius"))
    {
        titan::checkKeywords(dict, {"name", "type", "centre", "radius"});
        if (!(radius_ >= grid.spacing) || !std::isfinite(radius_))
        {
            FatalIOErrorInFunction(dict)
                << "Entry radius is " << radius_ << nl
                << "Expected: at least the spacing, " << grid.spacing << " m." << exit(FatalIOError);
        }
        solid_ = ballMeasures(centre_, radius_, grid.dim);
    }

    scalar nParticles() const
    {
        return std::pow(2*radius_/grid_.spacing, grid_.dim);
    }
};


//- Inside of a surface
class surfaceWall
:
    public wallShape
{
    const closedSurface surface_;


    wallParticles fillUp()
    {
        return surfaceLayers(surface_, grid_.dim, grid_.spacing, grid_.nLayers(), grid_.symmetry, represented_);
    }

    boundBox bounds() const
    {
        return surface_.bounds();
    }

    bool contains(const point& p) const
    {
        return surface_.contains(p);
    }


public:

    surfaceWall(const dictionary& dict, const lattice& grid, const fileName& caseDirectory)
    :
        wallShape(dict, grid),
        surface_(dict, caseDirectory, grid.dim)
    {
        titan::checkKeywords(dict, {"name", "type", "file"});
        solid_ = surface_.measures();
    }

    scalar nParticles() const
    {
        return
            min
            (
                cmptProduct(max(grid_.nCells(surface_.bounds()), vector(1, 1, 1))),
                1.5*grid_.nLayers()*surface_.area()/std::pow(grid_.spacing, grid_.dim - 1)
            );
    }
};


autoPtr<wallShape> newWall
(
    const dictionary& dict,
    const lattice& grid,
    const fileName& caseDirectory
)
{
    const word type(readType(dict, {"box", "sphere", "surface"}));
    if (type == "surface")
    {
        return autoPtr<wallShape>(new surfaceWall(dict, grid, caseDirectory));
    }
    if (type == "sphere")
    {
        return autoPtr<wallShape>(new sphereWall(dict, grid));
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
            IOWarningInFunction(dict)
                << "Box of fluid: its size, " << box_.max() - box_.min()
                << " m, is no multiple of the spacing, " << grid.spacing << " m." << nl
                << "    Its particles are stretched to cells of " << cell() << " m." << endl;
        }
    }

    //- Size of a particle's cell [m]; across the plane, 1
    vector cell() const
    {
        vector size(1, 1, 1);
        for (direction d = 0; d < grid_.dim; ++d)
        {
            size[d] = (box_.max()[d] - box_.min()[d])/n_[d];
        }
        return size;
    }

    scalar nParticles() const
    {
        return cmptProduct(n_);
    }

    bool contains(const point& p) const
    {
        return box_.contains(p);
    }

    pointField particles() const
    {
        return crossings(fill(box_, n_), [](const point&){ return true; });
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

        return mag(weight)*(surface - (points & up));
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


Foam::PtrList<Foam::dictionary> Foam::smoothedParticles::readWalls(const dictionary& geometry)
{
    return geometry.found("walls") ? readDictionaries(geometry, "walls") : PtrList<dictionary>();
}


Foam::wordList Foam::smoothedParticles::readWallNames(const dictionary& geometry)
{
    DynamicList<word> names;
    for (const dictionary& wall : readWalls(geometry))
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
    const lattice grid{dim, readSpacing(geometry), supportRatio*model.interaction.h, model.symmetry};

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
    const PtrList<dictionary> wallDicts(readWalls(geometry));
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

    // With contact walls have no particles, and no particle of fluid starts where it touches one
    const bool contact = model.contact.isOn();
    UPtrList<const wallShape> made;
    for (label i = 0; !contact && i < walls.size(); ++i)
    {
        walls[i].make(made, wallDicts[i]);
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
        state.mass.push_back((model.rho0 + density)*volume);
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
    const fileName&
);

template Foam::smoothedParticles::particleState<3> Foam::smoothedParticles::readParticles
(
    const dictionary&,
    const particleFlowModel<3>&,
    const fileName&
);

// ************************************************************************* //
