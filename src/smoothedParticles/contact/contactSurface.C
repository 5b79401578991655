// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactSurface.H"

#include "closedSurface.H"
#include "particleSetUp.H"

#include "boundBox.H"
#include "Switch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::smoothedParticles;

boundBox readBox(const dictionary& wall)
{
    return boundBox(wall.get<point>("min"), wall.get<point>("max"));
}


//- Of one segment size
class smoothSurface
:
    public contactSurface
{
    const scalar area_;

protected:

    const int dim_;

    //- Of a particle
    const scalar radius_;

    //- Touched from a surface at this distance of the particle's centre, positive outside?
    bool touched(const scalar distance, const vector& normal, touching& t) const
    {
        t = {radius_ - distance, normal, area_};
        return t.depth > 0;
    }

public:

    smoothSurface(const int dim, const scalar spacing)
    :
        area_(dim == 2 ? spacing : sqr(spacing)),
        dim_(dim),
        radius_(0.5*spacing)
    {}

    scalar maxArea() const
    {
        return area_;
    }
};


class tankContact
:
    public smoothSurface
{
    const boundBox box_;
    const scalar thickness_;
    boolList open_;

public:

    tankContact(const dictionary& wall, const int dim, const scalar spacing, const scalar thickness)
    :
        smoothSurface(dim, spacing),
        box_(readBox(wall)),
        thickness_(thickness),
        open_(2*dim, false)
    {
        for (const word& face : wall.lookupOrDefault<wordList>("open", wordList()))
        {
            open_[faceOf(face, dim, wall, "open")] = true;
        }
    }

    bool touch(const point& p, touching& t) const
    {
        // Behind the closed faces, and nearest way out over a rim or through the wall
        vector into(Zero);
        vector way(Zero);
        scalar out = GREAT;
        for (direction i = 0; i < 2*dim_; ++i)
        {
            const direction d = i/2;
            const scalar side = i % 2 ? 1 : -1;
            const scalar behind = side*(p[d] - (i % 2 ? box_.max()[d] : box_.min()[d]));
            if (!open_[i])
            {
                into[d] = behind > -radius_ ? side*(behind + radius_) : into[d];
            }
            const scalar left = radius_ + (open_[i] ? 0 : thickness_) - behind;
            if (left <= 0)
            {
                return false;
            }
            if (left < out)
            {
                out = left;
                way = Zero;
                way[d] = side;
            }
        }
        const scalar depth = mag(into);
        if (depth > out)
        {
            return touched(radius_ - out, way, t);
        }
        return depth > 0 && touched(radius_ - depth, -into/depth, t);
    }
};


class boxContact
:
    public smoothSurface
{
    const boundBox box_;

public:

    boxContact(const dictionary& wall, const int dim, const scalar spacing)
    :
        smoothSurface(dim, spacing),
        box_(readBox(wall))
    {}

    bool touch(const point& p, touching& t) const
    {
        vector beyond(Zero);
        scalar inside = GREAT;
        vector normal(Zero);
        for (direction d = 0; d < dim_; ++d)
        {
            const scalar low = p[d] - box_.min()[d];
            const scalar high = box_.max()[d] - p[d];
            if (low <= -radius_ || high <= -radius_)
            {
                return false;
            }
            beyond[d] = low < 0 ? low : high < 0 ? -high : 0;
            if (min(low, high) < inside)
            {
                inside = min(low, high);
                normal = Zero;
                normal[d] = low < high ? -1 : 1;
            }
        }
        if (inside >= 0)
        {
            return touched(-inside, normal, t);
        }
        return touched(mag(beyond), beyond/mag(beyond), t);
    }
};


class sphereContact
:
    public smoothSurface
{
    const point centre_;
    const scalar sphereRadius_;

public:

    sphereContact(const dictionary& wall, const int dim, const scalar spacing)
    :
        smoothSurface(dim, spacing),
        centre_(wall.get<point>("centre")),
        sphereRadius_(wall.get<scalar>("radius"))
    {}

    bool touch(const point& p, touching& t) const
    {
        const vector r(p - centre_);
        const scalar distance = mag(r);
        return touched(distance - sphereRadius_, distance > 0 ? vector(r/distance) : vector(1, 0, 0), t);
    }
};


class triangleContact
:
    public contactSurface
{
    const scalar radius_;
    const closedSurface surface_;

    //- Around all particles that touch
    boundBox box_;

    //- Of segments [m2], by triangle
    scalarField area_;

public:

    triangleContact(const dictionary& wall, const int dim, const scalar spacing, const fileName& caseDirectory)
    :
        radius_(0.5*spacing),
        surface_(wall, caseDirectory, dim),
        box_(surface_.bounds()),
        area_(surface_.triangles().magFaceAreas())
    {
        box_.min() -= vector::uniform(radius_);
        box_.max() += vector::uniform(radius_);
        if (dim == 2)
        {
            // A segment of the cut is two triangles
            area_ *= 2/boundBox(surface_.triangles().points(), false).span().z();
        }
    }

    bool touch(const point& p, touching& t) const
    {
        if (!box_.contains(p))
        {
            return false;
        }
        const closedSurface::foot foot(surface_.findNearest(p, GREAT));
        // On the surface itself there is no direction to it
        t =
        {
            radius_ + foot.depth,
            mag(foot.depth) > SMALL*radius_ ? vector((foot.x - p)/foot.depth) : surface_.triangles().faceNormals()[foot.triangle],
            area_[foot.triangle]
        };
        return t.depth > 0;
    }

    scalar maxArea() const
    {
        return max(area_);
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::shared_ptr<const Foam::smoothedParticles::contactSurface> Foam::smoothedParticles::newContactSurface
(
    const dictionary& wall,
    const int dim,
    const scalar spacing,
    const scalar thickness,
    const fileName& caseDirectory
)
{
    const word type(wall.get<word>("type"));
    if (type == "surface")
    {
        return std::make_shared<triangleContact>(wall, dim, spacing, caseDirectory);
    }
    if (type == "sphere")
    {
        return std::make_shared<sphereContact>(wall, dim, spacing);
    }
    if (type != "box")
    {
        FatalIOErrorInFunction(wall)
            << "Entry type is " << type << nl
            << "Expected: box, sphere or surface." << exit(FatalIOError);
    }
    if (wall.lookupOrDefault<Switch>("solid", false))
    {
        return std::make_shared<boxContact>(wall, dim, spacing);
    }
    return std::make_shared<tankContact>(wall, dim, spacing, thickness);
}

// ************************************************************************* //
