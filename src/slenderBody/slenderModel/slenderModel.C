// SPDX-License-Identifier: GPL-3.0-or-later

#include "slenderModel.H"

#include "inputChecks.H"
#include "mathematicalConstants.H"
#include "spheroid.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const char* const Foam::slenderBody::slenderModel::forceNames[nForces] =
{
    "inertia", "buoyancy", "friction", "form", "crossFlow", "tail"
};


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using constant::mathematical::pi;

//- Slices of a body
constexpr int nSlices = 96;

//- A corner by which the liquid leaves [deg]
constexpr scalar sharp = 10;

//- Width over length of a body that a cavity can follow although it is smooth
constexpr scalar bluff = 0.5;

//- Of the speed of capillarity sigma/mu, above which it does
constexpr scalar cavitySpeed = 0.1;

//- Cylinder that a cavity is for the flow about the nose, in radii
constexpr scalar cavityLength = 12;

//- Drag of a cylinder of finite length across the stream over that of an infinite one (Wieselsberger 1922; Goldstein 1938, p. 439),
//  by length over diameter
scalar finiteLength(const scalar ratio)
{
    static constexpr scalar ratios[] = {1, 2, 3, 5, 10, 20, 40};
    static constexpr scalar factors[] = {0.53, 0.57, 0.62, 0.62, 0.68, 0.75, 0.82};
    if (ratio <= ratios[0])
    {
        return factors[0];
    }
    for (int i = 1; i < 7; ++i)
    {
        if (ratio < ratios[i])
        {
            return factors[i - 1] + (factors[i] - factors[i - 1])*std::log(ratio/ratios[i - 1])/std::log(ratios[i]/ratios[i - 1]);
        }
    }
    return factors[6];
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::slenderBody::slenderModel::chooseFlow()
{
    const meridian& body = *properties_.shape;
    const scalar corner = body.sharpCorner(sharp);
    const scalar slenderness = 2*body.maxRadius()/body.length();
    const scalar mu = properties_.liquid->viscosity(0);
    const scalar capillary = mu > 0 ? cavitySpeed*properties_.liquid->surfaceTension()/mu : 0;
    const scalar speed = mag(properties_.velocity);

    shoulder_ = body.length();
    if (corner > 0)
    {
        shoulder_ = min(body.at(corner*(1 + 1e-9)).x, body.length());
    }
    else if (slenderness > bluff)
    {
        shoulder_ = body.widest();
    }

    switch (properties_.flow)
    {
        case flowType::attached:
            hasCavity_ = false;
            rule_ = "as asked";
            return;
        case flowType::cavity:
            hasCavity_ = true;
            rule_ = "as asked";
            if (shoulder_ >= body.length() && corner < 0)
            {
                shoulder_ = body.widest();
            }
            return;
        case flowType::automatic:
            break;
    }
    if (corner > 0)
    {
        hasCavity_ = true;
        rule_ = text("a convex corner of more than ", sharp, " deg, which the liquid leaves at any speed (May 1975)");
    }
    else if (slenderness > bluff && speed > capillary)
    {
        hasCavity_ = true;
        rule_ = text
        (
            "smooth and ", slenderness, " as wide as long, faster than ", capillary, " m/s, a tenth of sigma/mu (Duez, Ybert, Clanet and"
            " Bocquet 2007, spheres)"
        );
    }
    else
    {
        hasCavity_ = false;
        rule_ =
            slenderness > bluff
          ? text("smooth, and no faster than ", capillary, " m/s, a tenth of sigma/mu (Duez, Ybert, Clanet and Bocquet 2007, spheres)")
          : text("smooth and slender: no corner of more than ", sharp, " deg, ", slenderness, " as wide as long");
    }
}


void Foam::slenderBody::slenderModel::setDirections()
{
    const auto linear = [](const int i){ motion m; m[i] = 1; return m; };
    nDirections_ = 0;
    switch (properties_.freedom)
    {
        case freedomType::prescribed:
            break;
        case freedomType::axial:
            directions_[nDirections_++].linear = properties_.orientation.T() & properties_.heading;
            break;
        case freedomType::planar:
            for (const int i : {0, 2, 4})
            {
                directions_[nDirections_++] = linear(i);
            }
            break;
        case freedomType::free:
            for (int i = 0; i < 6; ++i)
            {
                directions_[nDirections_++] = linear(i);
            }
            break;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slenderBody::slenderModel::slenderModel(const slenderProperties& properties, const slenderModel* ofThisShape)
:
    properties_(properties),
    slices_(properties.shape->slices(nSlices)),
    frictionLaw_(properties.transitionReynolds),
    up_(upwards(properties.g))
{
    const meridian& body = *properties.shape;
    chooseFlow();
    setDirections();

    cavityDepth_ = shoulder_ > 0 && shoulder_ <= body.widest()*(1 + 1e-6) ? shoulder_/axialEntry::rise(body, shoulder_*(1 - 1e-9)) : shoulder_;

    const scalar volume = body.volume();
    const scalar a = 0.5*body.length();
    const scalar b = std::sqrt(volume/(4.0/3*pi*a));
    const spheroid lamb(a, b);
    across_ = lamb.across;
    scalar strips = 0;
    for (const meridian::slice& s : slices_)
    {
        strips += s.volume*sqr(s.centre - body.centre());
    }
    ownInertia_ = (lamb.about*volume*(a*a + b*b)/5 - across_*strips)/(across_*volume);

    // Hoerner (1965), eq. 6-28: wetted-area drag over friction, of which the second term is the pressure's of a closed tail
    const scalar slenderness = 2*body.maxRadius()/body.length();
    frictionForm_ = 1 + 1.5*std::pow(slenderness, 1.5);
    pressureForm_ = 7*pow3(slenderness)*(1 - sqr(body.baseRadius()/body.maxRadius()));
    crossFlowEnds_ = finiteLength(1/slenderness);

    bodyMass_ = motionMatrix();
    for (int i = 0; i < 3; ++i)
    {
        bodyMass_.a[i][i] = properties.mass;
        bodyMass_.a[i + 3][i + 3] = properties.momentOfInertia[i];
    }

    if (ofThisShape && ofThisShape->properties_.shape == properties.shape)
    {
        attachedEntry_ = ofThisShape->attachedEntry_;
        cavityEntry_ = ofThisShape->shoulder_ == shoulder_ ? ofThisShape->cavityEntry_ : nullptr;
    }
    if (!attachedEntry_)
    {
        attachedEntry_ = std::make_shared<axialEntry>(body);
    }
    if (hasCavity_ && !cavityEntry_)
    {
        cavityEntry_ = std::make_shared<axialEntry>(body.withCylinder(shoulder_, cavityLength*body.maxRadius()));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::slenderBody::slenderModel::state Foam::slenderBody::slenderModel::start() const
{
    const tensor& Q = properties_.orientation;
    state y{};
    for (int i = 0; i < 3; ++i)
    {
        y[i] = properties_.centreOfMass[i];
        y[7 + i] = (Q.T() & properties_.velocity)[i];
        y[10 + i] = properties_.angularVelocity[i];
    }
    // The largest of the four first (Shepperd 1978)
    const scalar trace = tr(Q);
    const scalar squares[4] = {1 + trace, 1 + 2*Q.xx() - trace, 1 + 2*Q.yy() - trace, 1 + 2*Q.zz() - trace};
    int k = 0;
    for (int i = 1; i < 4; ++i)
    {
        k = squares[i] > squares[k] ? i : k;
    }
    const scalar q = 0.5*std::sqrt(squares[k]), f = 0.25/q;
    const scalar w[3] = {Q.zy() - Q.yz(), Q.xz() - Q.zx(), Q.yx() - Q.xy()};
    const scalar s[3] = {Q.zy() + Q.yz(), Q.xz() + Q.zx(), Q.yx() + Q.xy()};
    switch (k)
    {
        case 0: y[3] = q; y[4] = f*w[0]; y[5] = f*w[1]; y[6] = f*w[2]; break;
        case 1: y[3] = f*w[0]; y[4] = q; y[5] = f*s[2]; y[6] = f*s[1]; break;
        case 2: y[3] = f*w[1]; y[4] = f*s[2]; y[5] = q; y[6] = f*s[0]; break;
        case 3: y[3] = f*w[2]; y[4] = f*s[1]; y[5] = f*s[0]; y[6] = q; break;
    }
    return y;
}


Foam::slenderBody::slenderModel::instant Foam::slenderBody::slenderModel::evaluate(const state& y) const
{
    instant now;
    const scalar size = std::sqrt(sqr(y[3]) + sqr(y[4]) + sqr(y[5]) + sqr(y[6]));
    const scalar w = y[3]/size, a = y[4]/size, b = y[5]/size, c = y[6]/size;
    now.orientation = tensor
    (
        1 - 2*(b*b + c*c), 2*(a*b - c*w), 2*(a*c + b*w),
        2*(a*b + c*w), 1 - 2*(a*a + c*c), 2*(b*c - a*w),
        2*(a*c - b*w), 2*(b*c + a*w), 1 - 2*(a*a + b*b)
    );
    now.up = now.orientation.T() & up_;
    now.velocity = {vector(y[7], y[8], y[9]), vector(y[10], y[11], y[12])};
    now.height = (vector(y[0], y[1], y[2]) & up_) - properties_.surfaceLevel;
    for (motion& force : now.forces)
    {
        force = motion();
    }

    wet(now);
    addMass(now);
    enter(now);
    buoy(now);
    rub(now);
    resistCrossFlow(now);
    steer(now);
    accelerate(now);
    return now;
}


Foam::slenderBody::slenderModel::state Foam::slenderBody::slenderModel::rate(const state& y) const
{
    const instant now(evaluate(y));
    const vector velocity(now.orientation & now.velocity.linear);
    const vector& omega = now.velocity.angular;
    state result;
    for (int i = 0; i < 3; ++i)
    {
        result[i] = velocity[i];
        result[7 + i] = now.acceleration.linear[i];
        result[10 + i] = now.acceleration.angular[i];
    }
    const vector q(y[4], y[5], y[6]);
    const vector dq(0.5*(y[3]*omega + (q ^ omega)));
    result[3] = -0.5*(q & omega);
    result[4] = dq.x();
    result[5] = dq.y();
    result[6] = dq.z();
    for (int i = 0; i < nForces; ++i)
    {
        result[13 + i] = now.forces[i] & now.velocity;
    }
    return result;
}


Foam::slenderBody::slenderModel::state Foam::slenderBody::slenderModel::scales() const
{
    const scalar L = properties_.shape->length();
    const scalar U = max(mag(properties_.velocity), std::sqrt(max(mag(properties_.g)*L, VSMALL)));
    state result;
    for (std::size_t i = 0; i < nStates; ++i)
    {
        result[i] = i < 3 ? L : i < 7 ? 1 : i < 10 ? U : i < 13 ? U/L : properties_.mass*sqr(U);
    }
    return result;
}


Foam::bodyState Foam::slenderBody::slenderModel::bodyStateOf(const state& y, const instant& now) const
{
    bodyState s;
    s.centreOfMass = point(y[0], y[1], y[2]);
    s.orientation = now.orientation;
    s.velocity = now.orientation & now.velocity.linear;
    s.omega = now.orientation & now.velocity.angular;
    s.acceleration = now.orientation & (now.acceleration.linear + (now.velocity.angular ^ now.velocity.linear));
    s.angularAcceleration = now.orientation & now.acceleration.angular;
    return s;
}


Foam::bodyLoads Foam::slenderBody::slenderModel::loadsOf(const instant& now) const
{
    motion all;
    for (const motion& force : now.forces)
    {
        all += force;
    }
    bodyLoads loads;
    loads.viscous = now.orientation & now.forces[friction].linear;
    loads.pressure = (now.orientation & all.linear) - loads.viscous;
    loads.moment = now.orientation & all.angular;
    return loads;
}


Foam::scalar Foam::slenderBody::slenderModel::kineticEnergy(const instant& now) const
{
    return 0.5*(now.velocity & (bodyMass_ & now.velocity));
}


Foam::scalar Foam::slenderBody::slenderModel::potentialEnergy(const instant& now) const
{
    return properties_.mass*mag(properties_.g)*now.height;
}


Foam::scalar Foam::slenderBody::slenderModel::closureTime() const
{
    const scalar g = mag(properties_.g);
    return g > VSMALL ? 2.285*std::sqrt(properties_.shape->radius(shoulder_*(1 - 1e-9))/g) : GREAT;
}


void Foam::slenderBody::slenderModel::closeCavity()
{
    hasCavity_ = false;
}

// ************************************************************************* //
