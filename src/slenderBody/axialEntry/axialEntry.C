// SPDX-License-Identifier: GPL-3.0-or-later

#include "axialEntry.H"

#include "mathematicalConstants.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::slenderBody;
using constant::mathematical::pi;

constexpr int nPanels = 48;

//- Depths of the table up to the widest section, and behind it
constexpr int nNose = 24, nAfter = 12;

//- Of the contact line's radius: how near to it pressures below the surface's are the edge's
constexpr scalar edge = 0.1;

//- Of a flat face's radius: the depth in which it takes its impulse, and from which on the flow is computed
constexpr scalar impulseDepth = 0.01, leastDepth = 0.05;

//- Largest rise of the liquid [-]
constexpr scalar largestRise = 0.5*pi;


//- Velocity in the plane r > 1 about a spheroid that moves across it, over that of the spheroid, whose half axes are 1 in the
//  plane and a across it (Lamb 1932, arts. 105, 108)
scalar velocityBeside(const scalar a, const scalar r)
{
    if (std::abs(a - 1) < 1e-6)
    {
        return 0.5/pow3(r);
    }
    if (a < 1)
    {
        const scalar k = std::sqrt(1 - a*a);
        const auto inverse = [](const scalar zeta){ return std::atan2(scalar(1), zeta); };
        const scalar zeta0 = a/k, zeta = std::sqrt(r*r - k*k)/k;
        return (1/zeta - inverse(zeta))/(inverse(zeta0) - zeta0/(1 + zeta0*zeta0));
    }
    const scalar k = std::sqrt(a*a - 1);
    const auto inverse = [](const scalar zeta){ return 0.5*std::log((zeta + 1)/(zeta - 1)); };
    const scalar zeta0 = a/k, zeta = std::sqrt(1 + r*r/(k*k));
    return (inverse(zeta) - 1/zeta)/(zeta0/(zeta0*zeta0 - 1) - inverse(zeta0));
}


//- int_0^1 w(1/s) ds, with s = sin(t) for the root at the edge
scalar riseOfCone(const scalar a)
{
    constexpr int n = 200;
    scalar sum = 0;
    for (int i = 0; i < n; ++i)
    {
        const scalar t = 0.5*pi*(i + 0.5)/n;
        sum += velocityBeside(a, 1/std::sin(t))*std::cos(t);
    }
    return 0.5*pi*sum/n;
}


//- d phi/ds at the middles of the panels, within smooth pieces; phi is 0 at the contact line
std::vector<scalar> derivative(const axialEntry::flow& f, const scalar end, const bool cut)
{
    std::vector<scalar> result(f.phi.size());
    for (std::size_t piece = 0; piece + 1 < f.pieces.size(); ++piece)
    {
        const std::size_t first = f.pieces[piece], last = f.pieces[piece + 1] - 1;
        for (std::size_t i = first; i <= last; ++i)
        {
            const bool contact = cut && i == last && piece + 2 == f.pieces.size();
            const std::size_t a = i == first ? i : i - 1;
            const std::size_t b = i == last ? i : i + 1;
            const scalar sb = contact ? end : f.s[b], phib = contact ? 0 : f.phi[b];
            if (i == first || (i == last && !contact))
            {
                result[i] = (phib - f.phi[a])/(sb - f.s[a]);
                continue;
            }
            // The parabola through three points
            const scalar da = f.s[i] - f.s[a], db = sb - f.s[i];
            result[i] = ((f.phi[i] - f.phi[a])*db/da + (phib - f.phi[i])*da/db)/(da + db);
        }
    }
    return result;
}


//- Force over rho U^2 with the contact line at x = plane, which grows by `rate` with the depth
scalar steadyForce(const meridian& body, const axialEntry::flow& f, const scalar plane, const scalar rate)
{
    const bool cut = plane < body.length();
    const scalar end = body.arcOf(plane);
    const scalar step = 1e-3*plane;
    const axialEntry::flow later(axialEntry::solve(body, plane + step, nPanels));
    const meridian::place contact(body.at(end*(1 - 1e-9)));
    const scalar grown = body.arcOf(plane + step) - end;

    const std::vector<scalar> slope(derivative(f, end, cut));
    const bool same = later.phi.size() == f.phi.size();
    scalar sum = 0;
    for (std::size_t i = 0; i < f.phi.size(); ++i)
    {
        const meridian::place& p = f.middle[i];
        const scalar change = same ? (later.phi[i] - f.phi[i])/step - slope[i]*f.stretch[i]*grown/step : 0;
        scalar pressure = -change*rate + 0.5 - 0.5*sqr(slope[i] + p.tx);
        if (cut && contact.tr > 0 && end - f.s[i] < edge*contact.r)
        {
            pressure = max(pressure, scalar(0));
        }
        sum += pressure*p.tr*2*pi*p.r*f.length[i];
    }
    return sum;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Column>
Foam::scalar Foam::slenderBody::axialEntry::interpolate(const scalar depth, const Column& of) const
{
    if (depth <= 0)
    {
        return 0;
    }
    if (depth >= table_.back().depth)
    {
        return of(table_.back());
    }
    const auto next = std::upper_bound
    (
        table_.begin(), table_.end(), depth, [](const scalar d, const line& l){ return d < l.depth; }
    );
    const line& b = *next;
    const line& a = *(next - 1);
    return of(a) + (of(b) - of(a))*(depth - a.depth)/(b.depth - a.depth);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slenderBody::axialEntry::axialEntry(const meridian& body)
:
    immersedMass_(mass(solve(body, GREAT, 2*nPanels)))
{
    const scalar L = body.length(), R = body.maxRadius(), widest = body.widest(), face = body.faceRadius();

    std::vector<scalar> planes;
    for (int k = 1; k <= nNose && widest > 0; ++k)
    {
        planes.push_back(widest*sqr(scalar(k)/nNose));
    }
    for (const scalar radii : {0.05, 0.1, 0.2, 0.4, 0.7, 1.0, 1.5, 2.0, 3.0, 4.0})
    {
        planes.push_back(widest + radii*R);
    }
    for (int k = 1; k < nAfter; ++k)
    {
        planes.push_back(widest + (L - widest)*k/nAfter);
    }
    planes.erase(std::remove_if(planes.begin(), planes.end(), [&](const scalar x){ return x > 0.995*L; }), planes.end());
    planes.push_back(0.998*L);
    for (const scalar radii : {0.2, 0.5, 1.0, 2.0, 4.0, 8.0})
    {
        planes.push_back(L + radii*R);
    }
    std::sort(planes.begin(), planes.end());

    // The rise of the liquid is lost behind the widest section
    const scalar widestRise = widest > 0 ? widest - widest/rise(body, widest) : 0;
    const scalar way = max(L - widest, R);
    const auto depthOf = [&](const scalar x)
    {
        return x <= widest ? x/rise(body, x) : x - widestRise*max(scalar(0), 1 - (x - widest)/way);
    };

    table_.push_back({0, 0, 0});
    if (face > 0)
    {
        const scalar m = 4*pow3(face)/3, depth = impulseDepth*face;
        table_.push_back({1e-6*depth, 0, m/depth});
        table_.push_back({depth, m, m/depth});
    }
    for (scalar x : planes)
    {
        // Beside corners, where the flow changes at once
        for (const scalar corner : body.corners())
        {
            const scalar at = body.at(corner).x;
            if (x > at*(1 - 1e-3) && x <= at && at > 0 && at < L)
            {
                x = at*(1 - 1e-3);
            }
        }
        const scalar depth = depthOf(x);
        if (x < leastDepth*face || depth <= table_.back().depth*(1 + 1e-6))
        {
            continue;
        }
        const scalar step = 1e-4*x;
        const flow f(solve(body, x, nPanels));
        table_.push_back({depth, mass(f), steadyForce(body, f, x, step/(depthOf(x + step) - depth))});
    }
    // The last plane is far away
    table_.back().force = 0;
    table_.back().mass = immersedMass_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::slenderBody::axialEntry::rise(const meridian& body, const scalar x)
{
    const scalar c = body.radius(x);
    constexpr int n = 200;
    scalar depth = 0;
    for (int i = 0; i < n; ++i)
    {
        const scalar t = 0.5*pi*(i + 0.5)/n;
        depth += body.xOf(c*std::sin(t))*std::sin(t)*0.5*pi/n;
    }
    const scalar disc = min(depth > 0 ? x/depth : largestRise, largestRise) - 1;
    return 1 + disc*riseOfCone(x/c)/(4/pi - 1);
}


Foam::scalar Foam::slenderBody::axialEntry::mass(const scalar depth) const
{
    return interpolate(depth, [](const line& l){ return l.mass; });
}


Foam::scalar Foam::slenderBody::axialEntry::force(const scalar depth) const
{
    return interpolate(depth, [](const line& l){ return l.force; });
}

// ************************************************************************* //
