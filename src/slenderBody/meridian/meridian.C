// SPDX-License-Identifier: GPL-3.0-or-later

#include "meridian.H"

#include "mathematicalConstants.H"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;
using Foam::constant::mathematical::pi;

//- A corner turns by more than this [rad]
constexpr scalar cornerAngle = 0.1;

//- Over the largest radius: flat ends that are smaller are points
constexpr scalar leastFace = 0.01;

//- Of the frustum of a cone from x = 0 to h
void frustum(const scalar r1, const scalar r2, const scalar h, scalar& volume, scalar& moment)
{
    volume = pi*h*(r1*r1 + r1*r2 + r2*r2)/3;
    moment = pi*h*h*(r1*r1 + 2*r1*r2 + 3*r2*r2)/12;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slenderBody::meridian::meridian(std::vector<scalar> x, std::vector<scalar> r)
:
    x_(std::move(x)),
    r_(std::move(r))
{
    if (x_.size() < 3 || x_.size() != r_.size())
    {
        throw std::invalid_argument("a meridian of " + std::to_string(x_.size()) + " points: expected three or more");
    }
    const scalar x0 = x_.front();
    for (std::size_t i = 0; i < x_.size(); ++i)
    {
        x_[i] -= x0;
        if (!(std::isfinite(x_[i]) && std::isfinite(r_[i]) && r_[i] >= 0))
        {
            throw std::invalid_argument("point " + std::to_string(i + 1) + ": expected finite numbers and no radius below 0");
        }
        if (i > 0 && x_[i] < x_[i - 1] - 1e-9*std::abs(x_.back()))
        {
            throw std::invalid_argument
            (
                "point " + std::to_string(i + 1) + " is ahead of the one before: expected x to grow from the nose to the tail, as the"
                " sections of a slender body do"
            );
        }
        x_[i] = i > 0 ? std::max(x_[i], x_[i - 1]) : 0;
    }
    widest_ = 0;
    for (std::size_t i = 1; i < r_.size(); ++i)
    {
        if (r_[i] > r_[widest_]*(1 + 1e-9))
        {
            widest_ = i;
        }
    }
    if (!(r_[widest_] > 0 && x_.back() > 0))
    {
        throw std::invalid_argument("points on one line: expected a body with length and width");
    }
    if (r_.front() > 1e-9*r_[widest_] || r_.back() > 1e-9*r_[widest_])
    {
        throw std::invalid_argument("its ends are off the axis: expected r = 0 at the nose and at the tail");
    }
    r_.front() = r_.back() = 0;

    // Between nose and tail the axis is no place for a point
    std::size_t kept = 1;
    for (std::size_t i = 1; i < x_.size(); ++i)
    {
        const bool last = i + 1 == x_.size();
        const bool same = std::hypot(x_[i] - x_[kept - 1], r_[i] - r_[kept - 1]) < 1e-12*x_.back();
        if (last || (r_[i] > 1e-9*r_[widest_] && !same))
        {
            x_[kept] = x_[i];
            r_[kept] = r_[i];
            kept += 1;
        }
    }
    x_.resize(kept);
    r_.resize(kept);
    widest_ = std::max_element(r_.begin(), r_.end(), [](const scalar a, const scalar b){ return a*(1 + 1e-9) < b; }) - r_.begin();

    reach_ = {0};
    for (std::size_t i = 1; i < r_.size(); ++i)
    {
        reach_.push_back(std::max(reach_.back(), r_[i]));
    }

    s_ = volume_ = moment_ = area_ = {0};
    for (std::size_t i = 1; i < x_.size(); ++i)
    {
        const scalar dx = x_[i] - x_[i - 1];
        const scalar ds = std::hypot(dx, r_[i] - r_[i - 1]);
        scalar volume, moment;
        frustum(r_[i - 1], r_[i], dx, volume, moment);
        s_.push_back(s_.back() + ds);
        volume_.push_back(volume_.back() + volume);
        moment_.push_back(moment_.back() + moment + x_[i - 1]*volume);
        area_.push_back(area_.back() + (dx > 1e-9*ds ? pi*(r_[i - 1] + r_[i])*ds : 0));
    }

    corners_ = {0};
    for (std::size_t i = 1; i + 1 < x_.size(); ++i)
    {
        const scalar before = std::atan2(r_[i] - r_[i - 1], x_[i] - x_[i - 1]);
        const scalar after = std::atan2(r_[i + 1] - r_[i], x_[i + 1] - x_[i]);
        if (std::abs(after - before) > cornerAngle && s_[i] - corners_.back() > 1e-6*s_.back())
        {
            corners_.push_back(s_[i]);
        }
    }
    if (s_.back() - corners_.back() < 1e-6*s_.back() && corners_.size() > 1)
    {
        corners_.pop_back();
    }
    corners_.push_back(s_.back());
    setDirections();
}


Foam::slenderBody::meridian Foam::slenderBody::meridian::read(const std::string& file)
{
    std::ifstream in(file);
    if (!in)
    {
        throw std::invalid_argument(file + " cannot be read: expected a table of x and r [m], from the nose to the tail");
    }
    std::vector<scalar> x, r;
    int number = 0;
    for (std::string line; std::getline(in, line);)
    {
        ++number;
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream fields(line.substr(0, line.find('#')));
        scalar one, other;
        if (fields >> one >> other)
        {
            x.push_back(one);
            r.push_back(other);
        }
        else if (number > 1 && line.find_first_not_of(" \t\r") != std::string::npos && line[0] != '#')
        {
            throw std::invalid_argument(file + ", line " + std::to_string(number) + ": expected two numbers, x and r [m]");
        }
    }
    try
    {
        return meridian(x, r);
    }
    catch (const std::invalid_argument& e)
    {
        throw std::invalid_argument(file + ": " + e.what());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::slenderBody::meridian::faceRadius() const
{
    std::size_t i = 0;
    while (x_[i + 1] < 1e-9*length())
    {
        ++i;
    }
    return r_[i] > leastFace*maxRadius() ? r_[i] : 0;
}


Foam::scalar Foam::slenderBody::meridian::baseRadius() const
{
    std::size_t i = x_.size() - 1;
    while (x_[i - 1] > (1 - 1e-9)*length())
    {
        --i;
    }
    return r_[i] > leastFace*maxRadius() ? r_[i] : 0;
}


Foam::scalar Foam::slenderBody::meridian::arcOf(const scalar x) const
{
    if (x >= length())
    {
        return s_.back();
    }
    const std::size_t i = std::upper_bound(x_.begin(), x_.end(), std::max(x, scalar(0))) - x_.begin();
    return s_[i - 1] + (s_[i] - s_[i - 1])*(x - x_[i - 1])/(x_[i] - x_[i - 1]);
}


Foam::scalar Foam::slenderBody::meridian::xOf(const scalar r) const
{
    // The nose may have dents: the first point that is as wide counts
    const auto first = std::lower_bound(reach_.begin() + 1, reach_.begin() + widest_, r);
    const std::size_t i = first - reach_.begin();
    const scalar dr = r_[i] - r_[i - 1];
    return dr > 0 ? x_[i - 1] + (x_[i] - x_[i - 1])*std::min(std::max((r - r_[i - 1])/dr, scalar(0)), scalar(1)) : x_[i];
}


Foam::scalar Foam::slenderBody::meridian::radius(const scalar x) const
{
    return x >= length() ? baseRadius() : at(arcOf(x)).r;
}


Foam::slenderBody::meridian::place Foam::slenderBody::meridian::at(const scalar s) const
{
    const std::size_t i =
        std::min<std::size_t>(std::max<std::size_t>(std::upper_bound(s_.begin(), s_.end(), s) - s_.begin(), 1), s_.size() - 1);
    const scalar ds = s_[i] - s_[i - 1];
    const scalar t = std::min(std::max((s - s_[i - 1])/ds, scalar(0)), scalar(1));

    // Hermite's cubic
    const scalar toEnd = t*t*(3 - 2*t), fromBegin = t*Foam::sqr(1 - t)*ds, beforeEnd = t*t*(t - 1)*ds;
    const scalar dEnd = 6*t*(1 - t)/ds, dBegin = (1 - t)*(1 - 3*t), dBefore = t*(3*t - 2);
    place p;
    p.x = x_[i - 1] + toEnd*(x_[i] - x_[i - 1]) + fromBegin*beginX_[i - 1] + beforeEnd*endX_[i - 1];
    p.r = std::max(r_[i - 1] + toEnd*(r_[i] - r_[i - 1]) + fromBegin*beginR_[i - 1] + beforeEnd*endR_[i - 1], scalar(0));
    p.tx = dEnd*(x_[i] - x_[i - 1]) + dBegin*beginX_[i - 1] + dBefore*endX_[i - 1];
    p.tr = dEnd*(r_[i] - r_[i - 1]) + dBegin*beginR_[i - 1] + dBefore*endR_[i - 1];
    const scalar size = std::hypot(p.tx, p.tr);
    p.tx /= size;
    p.tr /= size;
    return p;
}


Foam::scalar Foam::slenderBody::meridian::sharpCorner(const scalar degrees) const
{
    const scalar small = 1e-6*s_.back();
    for (std::size_t i = 1; i + 1 < corners_.size(); ++i)
    {
        const place before(at(corners_[i] - small)), after(at(corners_[i] + small));
        const scalar turn = std::atan2(before.tr, before.tx) - std::atan2(after.tr, after.tx);
        if (turn > degrees*pi/180 && before.r > 0.01*maxRadius())
        {
            return corners_[i];
        }
    }
    return -1;
}


void Foam::slenderBody::meridian::ahead(const scalar x, scalar& volume, scalar& moment, scalar& area) const
{
    if (x >= length())
    {
        volume = volume_.back();
        moment = moment_.back();
        area = area_.back();
        return;
    }
    const std::size_t i = std::upper_bound(x_.begin(), x_.end(), x) - x_.begin();
    const scalar dx = x - x_[i - 1];
    const scalar share = dx/(x_[i] - x_[i - 1]);
    const scalar r = r_[i - 1] + share*(r_[i] - r_[i - 1]);
    frustum(r_[i - 1], r, dx, volume, moment);
    moment += x_[i - 1]*volume + moment_[i - 1];
    volume += volume_[i - 1];
    area = area_[i - 1] + pi*(r_[i - 1] + r)*share*(s_[i] - s_[i - 1]);
}


void Foam::slenderBody::meridian::setDirections()
{
    const std::size_t n = s_.size() - 1;
    beginX_.resize(n);
    beginR_.resize(n);
    endX_.resize(n);
    endR_.resize(n);
    std::size_t corner = 0;
    for (std::size_t i = 0; i <= n; ++i)
    {
        while (corner + 1 < corners_.size() && corners_[corner] < s_[i])
        {
            ++corner;
        }
        const bool isCorner = corners_[corner] == s_[i];
        if (!isCorner)
        {
            // The parabola through three points
            const scalar a = s_[i] - s_[i - 1], b = s_[i + 1] - s_[i];
            const auto slope = [&](const std::vector<scalar>& y)
            {
                return ((y[i] - y[i - 1])*b/a + (y[i + 1] - y[i])*a/b)/(a + b);
            };
            endX_[i - 1] = beginX_[i] = slope(x_);
            endR_[i - 1] = beginR_[i] = slope(r_);
            continue;
        }
        if (i < n)
        {
            beginX_[i] = (x_[i + 1] - x_[i])/(s_[i + 1] - s_[i]);
            beginR_[i] = (r_[i + 1] - r_[i])/(s_[i + 1] - s_[i]);
        }
        if (i > 0)
        {
            endX_[i - 1] = (x_[i] - x_[i - 1])/(s_[i] - s_[i - 1]);
            endR_[i - 1] = (r_[i] - r_[i - 1])/(s_[i] - s_[i - 1]);
        }
    }
}


std::vector<Foam::slenderBody::meridian::slice> Foam::slenderBody::meridian::slices(const int n) const
{
    std::vector<scalar> ends;
    for (int k = 0; k <= n; ++k)
    {
        ends.push_back(length()*std::pow(scalar(k)/n, 1.5));
    }
    for (const scalar corner : corners_)
    {
        ends.push_back(at(corner).x);
    }
    std::sort(ends.begin(), ends.end());
    ends.back() = length();

    std::vector<slice> result;
    scalar low = 0, volume0 = 0, moment0 = 0, area0 = 0;
    for (const scalar end : ends)
    {
        if (end - low < 1e-7*length())
        {
            continue;
        }
        scalar volume, moment, area;
        ahead(end, volume, moment, area);
        const scalar own = volume - volume0;
        if (own > 0)
        {
            result.push_back({low, end, own, (moment - moment0)/own, area - area0, std::sqrt(own/(pi*(end - low)))});
        }
        low = end;
        volume0 = volume;
        moment0 = moment;
        area0 = area;
    }
    result.back().high = length();
    return result;
}


Foam::slenderBody::meridian Foam::slenderBody::meridian::withCylinder(const scalar x, const scalar more) const
{
    std::vector<scalar> xs, rs;
    const scalar end = arcOf(std::min(x, length()*(1 - 1e-9)));
    for (std::size_t i = 0; i < s_.size() && s_[i] < end - 1e-9*s_.back(); ++i)
    {
        xs.push_back(x_[i]);
        rs.push_back(r_[i]);
    }
    const scalar r = at(end).r;
    for (const scalar share : {0.0, 0.5, 1.0})
    {
        xs.push_back(x + share*more);
        rs.push_back(r);
    }
    xs.push_back(x + more);
    rs.push_back(0);
    return meridian(xs, rs);
}

// ************************************************************************* //
