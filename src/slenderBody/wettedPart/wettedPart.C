// SPDX-License-Identifier: GPL-3.0-or-later

#include "wettedPart.H"

#include "mathematicalConstants.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using constant::mathematical::pi;

//- Share of a circle's area below y
scalar circleShare(const scalar y)
{
    return y <= -1 ? 0 : y >= 1 ? 1 : 0.5 + (y*std::sqrt(1 - y*y) + std::asin(y))/pi;
}

//- Its integral
scalar circleIntegral(const scalar y)
{
    return
        y <= -1 ? 0
      : y >= 1 ? y
      : y*circleShare(y) + 2*(1 - y*y)*std::sqrt(1 - y*y)/(3*pi);
}

//- (1 - y^2)^(3/2), 0 outside the circle
scalar dome(const scalar y)
{
    return std::abs(y) >= 1 ? 0 : (1 - y*y)*std::sqrt(1 - y*y);
}

//- Its integral
scalar domeIntegral(const scalar y)
{
    return
        y <= -1 ? 0
      : y >= 1 ? 3*pi/8
      : (y*(5 - 2*y*y)*std::sqrt(1 - y*y) + 3*std::asin(y))/8 + 3*pi/16;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::slenderBody::wettedPart::update
(
    const std::vector<meridian::slice>& body,
    const meridian& curve,
    const vector& nose,
    const vector& up,
    const scalar height,
    const vector& velocity,
    const vector& omega
)
{
    // Of the sections' planes and of the axis
    const scalar tilt = std::hypot(up.y(), up.z());
    const vector upRate(-(omega ^ up));
    const scalar tiltRate = tilt > VSMALL ? (up.y()*upRate.y() + up.z()*upRate.z())/tilt : 0;
    across = tilt > VSMALL ? vector(0, up.y()/tilt, up.z()/tilt) : vector::zero;

    const auto depthAt = [&](const scalar x){ return -height - ((nose - vector(x, 0, 0)) & up); };
    const auto rateAt = [&](const scalar x){ return -((velocity + (omega ^ (nose - vector(x, 0, 0)))) & up); };

    slices.resize(body.size());
    length = lengthRate = 0;
    lowest = GREAT;
    highest = -GREAT;
    const auto reach = [&](const scalar x, const scalar r)
    {
        const scalar d = depthAt(x);
        lowest = min(lowest, -d - r*tilt);
        highest = max(highest, -d + r*tilt);
    };
    reach(0, curve.faceRadius());
    reach(curve.length(), curve.baseRadius());

    for (std::size_t i = 0; i < body.size(); ++i)
    {
        const meridian::slice& of = body[i];
        share& s = slices[i];
        const scalar dx = of.high - of.low;
        scalar lo = depthAt(of.low), hi = depthAt(of.high);
        scalar loRate = rateAt(of.low), hiRate = rateAt(of.high);
        s.depth = depthAt(of.centre);
        if (lo > hi)
        {
            std::swap(lo, hi);
            std::swap(loRate, hiRate);
        }
        const scalar R = of.radius*tilt;
        reach(of.centre, of.radius);

        if (lo >= R || hi <= -R)
        {
            s.wet = lo >= R && hi > 0 ? 1 : 0;
            s.rate = s.offset = 0;
        }
        else if (hi - lo > 1e-6*R)
        {
            const auto share = [&](const scalar d){ return R > VSMALL ? circleShare(d/R) : scalar(d > 0); };
            const auto integral = [&](const scalar d){ return R > VSMALL ? R*circleIntegral(d/R) : max(d, scalar(0)); };
            const scalar D = hi - lo;
            s.wet = (integral(hi) - integral(lo))/D;
            s.rate = ((share(hi) - s.wet)*hiRate + (s.wet - share(lo))*loRate)/D;
            s.offset = 0;
            if (R > VSMALL)
            {
                s.rate += 2*(dome(hi/R) - dome(lo/R))/(3*pi*D)*of.radius*tiltRate;
                s.offset = -2*of.radius/(3*pi)*R*(domeIntegral(hi/R) - domeIntegral(lo/R))/D;
            }
        }
        else
        {
            const scalar y = 0.5*(lo + hi)/R;
            const scalar chord = std::abs(y) < 1 ? 2*std::sqrt(1 - y*y)/(pi*R) : 0;
            s.wet = circleShare(y);
            s.rate = chord*(0.5*(loRate + hiRate) - y*of.radius*tiltRate);
            s.offset = -2*of.radius/(3*pi)*dome(y);
        }
        length += s.wet*dx;
        lengthRate += s.rate*dx;
    }
    if (highest < 0)
    {
        length = curve.length() - highest;
        lengthRate = -(velocity & up);
    }
}

// ************************************************************************* //
