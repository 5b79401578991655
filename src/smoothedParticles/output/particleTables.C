// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleTables.H"

#include "fluidSelection.H"
#include "inputChecks.H"
#include "smoothingKernels.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A column for each name and suffix
std::string header(const wordList& names, const wordList& suffixes)
{
    std::string columns("time_s");
    for (const word& name : names)
    {
        for (const word& suffix : suffixes)
        {
            columns += "," + name + "_" + suffix;
        }
    }
    return columns;
}


//- Names with a component of each dimension, as in Ux_m_s
wordList components(const int dim, const char* quantity, const char* unit)
{
    wordList names;
    for (int d = 0; d < dim; ++d)
    {
        names.append(std::string(quantity) + "xyz"[d] + "_" + unit);
    }
    return names;
}


std::unique_ptr<csvTable> newTable(const Time& runTime, const word& name, const std::string& columns)
{
    return std::unique_ptr<csvTable>(new csvTable(runTime, name, name, columns.c_str()));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<int dim>
Foam::smoothedParticles::particleTables<dim>::particleTables
(
    const Time& runTime,
    const dictionary& outputs,
    const particleFlowModel<dim>& model,
    const wordList& wallNames
)
:
    time_(runTime),
    model_(model),
    interval_(outputs.get<scalar>("interval")),
    next_(runTime.value()),
    energy_
    (
        runTime,
        "energy",
        "energy",
        (
            std::string("time_s,kinetic_J,potential_J,internal_J,") + (model.contact.isOn() ? "contact_J,deepest_in_walls_m," : "")
          + "max_speed_m_s,c0_at_least_10_max_speed_so_far"
          + (model.energy ? ",internal_eq2_J,wall_layers_J,dissipated_J,work_of_walls_J,budget_J" : "")
        ).c_str()
    )
{
    checkKeywords(outputs, wordHashSet({"interval", "surfaceLevel", "gauges", "probes"}));
    if (!(interval_ >= 0))
    {
        refuseEntry(outputs, "interval", text("is ", interval_), "0 or above [s].");
    }
    if (wallNames.size())
    {
        wallTable_ = newTable(runTime, "walls", header(wallNames, components(dim, "F", dim == 2 ? "N_m" : "N")));
    }
    gaugeTable_ = readPoints(outputs, "gauges", {"m"}, gauges_);
    wordList columns({"p_Pa"});
    columns.append(components(dim, "U", "m_s"));
    columns.append("share");
    probeTable_ = readPoints(outputs, "probes", columns, probes_);

    double g2 = 0;
    for (const double g : model_.interaction.g)
    {
        g2 += g*g;
    }
    if (gaugeTable_ && !(g2 > 0))
    {
        refuseEntry(outputs, "gauges", "is given, but there is no gravity", "gravity, along which gauges measure.");
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int dim>
std::unique_ptr<Foam::csvTable> Foam::smoothedParticles::particleTables<dim>::readPoints
(
    const dictionary& outputs,
    const word& kind,
    const wordList& columns,
    std::vector<point>& points
) const
{
    if (!outputs.found(kind))
    {
        return nullptr;
    }
    const dictionary& dict = outputs.subDict(kind);
    for (const word& name : dict.toc())
    {
        const vector x(dict.get<vector>(name));
        if (dim == 2 && x.z() != 0)
        {
            refuseEntry(dict, name, text("is ", x), "a point with z = 0, for dimensions is 2.");
        }
        point p;
        for (int d = 0; d < dim; ++d)
        {
            p[d] = x[d];
        }
        points.push_back(p);
    }
    return newTable(time_, kind, header(dict.toc(), columns));
}


template<int dim>
void Foam::smoothedParticles::particleTables<dim>::writeWalls(particleFlow<dim>& flow)
{
    *wallTable_ << time_.value();
    for (const point& force : flow.wallForces())
    {
        for (const double component : force)
        {
            *wallTable_ << component;
        }
    }
    wallTable_->endLine();
}


template<int dim>
void Foam::smoothedParticles::particleTables<dim>::writeGauges(const particleState<dim>& state)
{
    point up;
    double g2 = 0;
    for (int d = 0; d < dim; ++d)
    {
        up[d] = -model_.interaction.g[d];
        g2 += up[d]*up[d];
    }

    *gaugeTable_ << time_.value();
    for (const point& gauge : gauges_)
    {
        double highest = 0;
        for (std::size_t k = 0; k < state.size(); ++k)
        {
            double height = 0;
            double r2 = 0;
            for (int d = 0; d < dim; ++d)
            {
                height += (state.x[k][d] - gauge[d])*up[d]/std::sqrt(g2);
                r2 += (state.x[k][d] - gauge[d])*(state.x[k][d] - gauge[d]);
            }
            if (state.wall[k] == state.fluid && r2 - height*height < model_.spacing*model_.spacing)
            {
                highest = std::max(highest, height + 0.5*model_.spacing);
            }
        }
        *gaugeTable_ << highest;
    }
    gaugeTable_->endLine();
}


template<int dim>
void Foam::smoothedParticles::particleTables<dim>::writeProbes(const particleState<dim>& state)
{
    const double h = model_.interaction.h;
    *probeTable_ << time_.value();
    for (const point& probe : probes_)
    {
        double share = 0;
        double pressure = 0;
        point velocity{};
        for (std::size_t k = 0; k < state.size(); ++k)
        {
            double r2 = 0;
            for (int d = 0; d < dim; ++d)
            {
                r2 += (state.x[k][d] - probe[d])*(state.x[k][d] - probe[d]);
            }
            const double q = std::sqrt(r2)/h;
            if (state.wall[k] != state.fluid || q >= supportRatio)
            {
                continue;
            }
            const double weight =
                WendlandC2::normalisation(dim)*WendlandC2::w<double>(q)/std::pow(h, dim)
               *state.mass[k]/(model_.interaction.circumference(state.x[k][0])*(model_.rho0 + state.density[k]));
            share += weight;
            pressure += weight*state.pressure[k];
            for (int d = 0; d < dim; ++d)
            {
                velocity[d] += weight*state.v[k][d];
            }
        }
        const double scale = share > 0 ? 1/share : 0;
        *probeTable_ << scale*pressure;
        for (const double component : velocity)
        {
            *probeTable_ << scale*component;
        }
        *probeTable_ << share;
    }
    probeTable_->endLine();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int dim>
void Foam::smoothedParticles::particleTables<dim>::write(particleFlow<dim>& flow, const bool soundSpeedHolds)
{
    if (time_.value() < next_ - 0.5*time_.deltaTValue())
    {
        return;
    }
    if (interval_ > 0)
    {
        // Multiples of the interval, so that a restarted case keeps to them
        next_ = interval_*(std::floor(time_.value()/interval_ + 0.5) + 1);
    }

    const typename particleFlow<dim>::energies e(flow.energy());
    energy_ << time_.value() << e.kinetic << e.potential << e.internal;
    if (model_.contact.isOn())
    {
        energy_ << e.contact << flow.particlesInWalls().deepest;
    }
    energy_ << flow.maxSpeed() << soundSpeedHolds;
    if (model_.energy)
    {
        energy_ << e.internalEq2 << e.wallLayers << e.dissipated << e.workOfWalls << e.budget();
    }
    energy_.endLine();

    if (wallTable_)
    {
        writeWalls(flow);
    }
    if (gaugeTable_ || probeTable_)
    {
        const particleState<dim> state(flow.state());
        if (gaugeTable_)
        {
            writeGauges(state);
        }
        if (probeTable_)
        {
            writeProbes(state);
        }
    }
}


template class Foam::smoothedParticles::particleTables<2>;
template class Foam::smoothedParticles::particleTables<3>;

// ************************************************************************* //
