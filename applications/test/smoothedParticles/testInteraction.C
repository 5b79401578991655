// SPDX-License-Identifier: GPL-3.0-or-later
// Neighbours of particles and the sums over them, against sums over all pairs in double precision.

#include <gtest/gtest.h>

#include "interaction.H"
#include "smoothingKernels.H"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

using namespace Foam::smoothedParticles;

namespace
{

constexpr double spacing = 0.01;
constexpr double rho0 = 1000;

//- No passive particles
std::vector<unsigned char> none(std::size_t n)
{
    return std::vector<unsigned char>(n, 0);
}


template<int dim>
struct cloud
{
    typedef std::array<double, dim> vector;

    std::vector<vector> x, v;
    std::vector<double> density, pressure, volume;

    //- A disturbed lattice with a cavity, so that columns have gaps and broken clusters
    explicit cloud(int n)
    {
        std::mt19937 generator(5);
        std::uniform_real_distribution<double> uniform(-0.3, 0.3);
        const int layers = dim == 3 ? n : 1;
        for (int i = 0; i < n*n*layers; ++i)
        {
            const int lattice[] = {i % n, i/n % n, i/n/n};
            vector at, velocity;
            double fromCentre2 = 0;
            for (int d = 0; d < dim; ++d)
            {
                at[d] = spacing*(lattice[d] + uniform(generator));
                velocity[d] = uniform(generator);
                fromCentre2 += std::pow(at[d]/spacing - 0.5*n, 2);
            }
            if (fromCentre2 < 9)
            {
                continue;
            }
            x.push_back(at);
            v.push_back(velocity);
            density.push_back(10*uniform(generator));
            pressure.push_back(1000*uniform(generator));
            volume.push_back(std::pow(spacing, dim)/(1 + density.back()/rho0));
        }
    }

    template<class Real>
    packedParticles<Real, dim> packed(const clusterNeighbours<dim>& neighbours) const
    {
        typedef packedParticles<Real, dim> fields;
        fields result;
        result.rho0 = rho0;
        result.resize(neighbours.size());
        for (std::size_t i = 0; i < neighbours.size(); ++i)
        {
            const int k = neighbours.order()[i];
            if (k < 0)
            {
                continue;
            }
            for (int d = 0; d < dim; ++d)
            {
                result(i, fields::x + d) = x[k][d];
                result(i, fields::v + d) = v[k][d];
            }
            result(i, fields::density) = density[k];
            result(i, fields::volume) = volume[k];
            result(i, fields::pressure) = pressure[k];
            result(i, fields::share) = 1;
            result.fluid.push_back(i);
        }
        return result;
    }
};


//- Each of two particles' parts in the sums: r_ij, v_ij, F_ij with grad W_ij = F_ij r_ij
template<int dim>
struct pairOf
{
    std::array<double, dim> r, v;
    double r2 = 0;
    double approach = 0;
    double F;

    pairOf(const cloud<dim>& c, std::size_t i, std::size_t j, const interactionModel& m)
    {
        for (int d = 0; d < dim; ++d)
        {
            r[d] = c.x[i][d] - c.x[j][d];
            v[d] = c.v[i][d] - c.v[j][d];
            r2 += r[d]*r[d];
            approach += r[d]*v[d];
        }
        F =
            i == j || r2 >= 4*m.h*m.h
          ? 0
          : kernelNormalisation(m.kernel, dim)/std::pow(m.h, dim + 2)*kernelFactor(m.kernel, std::sqrt(r2)/m.h);
    }
};


//- L sum_j V_j (rho_j - rho_i) grad W_ij, by Cramer's rule
template<int dim>
std::array<double, dim> gradient(const cloud<dim>& c, std::size_t i, const interactionModel& m)
{
    double A[3][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, dim == 2 ? 1.0 : 0.0}};
    double b[3] = {0, 0, 0};
    for (std::size_t j = 0; j < c.x.size(); ++j)
    {
        const pairOf<dim> p(c, i, j, m);
        for (int d = 0; d < dim; ++d)
        {
            b[d] += c.volume[j]*(c.density[j] - c.density[i])*p.F*p.r[d];
            for (int e = 0; e < dim; ++e)
            {
                A[d][e] -= c.volume[j]*p.r[d]*p.F*p.r[e];
            }
        }
    }
    const auto determinant = [&](int column)
    {
        double M[3][3];
        for (int d = 0; d < 3; ++d)
        {
            for (int e = 0; e < 3; ++e)
            {
                M[d][e] = e == column ? b[d] : A[d][e];
            }
        }
        double sum = 0;
        for (int d = 0; d < 3; ++d)
        {
            sum += M[0][d]*(M[1][(d + 1) % 3]*M[2][(d + 2) % 3] - M[1][(d + 2) % 3]*M[2][(d + 1) % 3]);
        }
        return sum;
    };
    std::array<double, dim> result;
    for (int d = 0; d < dim; ++d)
    {
        result[d] = determinant(d)/determinant(-1);
    }
    return result;
}


//- The equations of interaction.H, pair by pair: the rate of density first, then the acceleration
template<int dim>
std::array<double, dim + 1> rates
(
    const cloud<dim>& c,
    std::size_t i,
    const interactionModel& m,
    const std::vector<std::array<double, dim>>& gradients
)
{
    std::array<double, dim + 1> sum{};
    const double rho = rho0 + c.density[i];
    const double scale = kernelNormalisation(m.kernel, dim)/std::pow(m.h, dim + 2);
    for (std::size_t j = 0; j < c.x.size(); ++j)
    {
        double r2 = 0;
        double approach = 0;
        for (int d = 0; d < dim; ++d)
        {
            r2 += std::pow(c.x[i][d] - c.x[j][d], 2);
            approach += (c.x[i][d] - c.x[j][d])*(c.v[i][d] - c.v[j][d]);
        }
        if (j == i || r2 >= 4*m.h*m.h)
        {
            continue;
        }
        const double F = scale*kernelFactor(m.kernel, std::sqrt(r2)/m.h);
        const double VF = c.volume[j]*F;
        const double regular = r2 + 0.01*m.h*m.h;
        const double r = std::sqrt(r2);
        const double rhoJ = rho0 + c.density[j];

        sum[0] += rho*VF*approach;
        if (m.diffusion == diffusionType::Riemann)
        {
            double difference = c.pressure[i] - c.pressure[j];
            for (int d = 0; d < dim; ++d)
            {
                difference -= rho0*m.g[d]*(c.x[i][d] - c.x[j][d]);
            }
            sum[0] += r/m.c0*difference*VF;
        }
        else if (m.diffusion != diffusionType::none)
        {
            double difference = c.density[i] - c.density[j];
            for (int d = 0; m.diffusion == diffusionType::Antuono && d < dim; ++d)
            {
                difference -= 0.5*(gradients[i][d] + gradients[j][d])*(c.x[i][d] - c.x[j][d]);
            }
            for (int d = 0; m.diffusion == diffusionType::Fourtakas && d < dim; ++d)
            {
                difference -=
                    rho0*m.g[d]/(m.c0*m.c0)*(c.x[i][d] - c.x[j][d])
                   *(1 + (2 - m.gamma)*0.5*(c.density[i] + c.density[j])/rho0);
            }
            sum[0] += 2*m.delta*m.h*m.c0*difference*VF;
        }
        double stress = c.pressure[i] + c.pressure[j];
        if (m.pressure == pressureType::solid)
        {
            stress = rho*rhoJ*(c.pressure[i]/(rho*rho) + c.pressure[j]/(rhoJ*rhoJ));
        }
        if (m.viscosity == viscosityType::artificial && approach < 0)
        {
            const double mu = m.h*approach/regular;
            stress += 0.5*(rho + rhoJ)*(-m.alpha*m.c0*mu + m.beta*mu*mu);
        }
        if (m.viscosity == viscosityType::laminar)
        {
            stress -= 2*(dim + 2)*m.mu*approach/regular;
        }
        if (m.viscosity == viscosityType::Riemann && approach < 0)
        {
            const double closing = -approach/r;
            stress += std::min(3*closing/m.c0, 1.0)*0.5*(rho + rhoJ)*m.c0*closing;
        }
        for (int d = 0; d < dim; ++d)
        {
            sum[1 + d] -= VF*stress*(c.x[i][d] - c.x[j][d])/rho;
        }
    }
    return sum;
}


template<class Real, int dim>
double largestError(const cloud<dim>& c, const interactionModel& m, instructionSet widest, double tolerance)
{
    clusterNeighbours<dim> neighbours;
    neighbours.sort(c.x, spacing, 1);
    neighbours.search(c.x, none(c.x.size()), none(c.x.size()), 2.2*m.h, 1);
    auto particles = c.template packed<Real>(neighbours);
    const interaction<Real, dim> interact(m, widest);
    std::vector<std::array<double, dim>> gradients(c.x.size());
    if (m.diffusion == diffusionType::Antuono)
    {
        particles.addDensityGradient();
        interact.sumDensityGradient(neighbours, particles, 1);
        double least = 0;
        double largest = 0;
        double error = 0;
        for (std::size_t i = 0; i < neighbours.size(); ++i)
        {
            const int k = neighbours.order()[i];
            if (k < 0)
            {
                continue;
            }
            const std::array<double, dim> exact = gradient(c, k, m);
            double size = 0;
            for (int d = 0; d < dim; ++d)
            {
                gradients[k][d] = particles.densityGradient[d][i];
                size += std::abs(gradients[k][d]);
                largest = std::max(largest, std::abs(exact[d]));
            }
            for (int d = 0; size > 0 && d < dim; ++d)
            {
                error = std::max(error, std::abs(gradients[k][d] - exact[d]));
            }
            least += size > 0;
        }
        EXPECT_LT(error, tolerance*largest);
        // All but those of corners
        EXPECT_GT(least, 0.95*c.x.size());
    }
    interact.sumDensityRate(neighbours, particles, 1);
    interact.sumAcceleration(neighbours, particles, 1);

    // Against the largest of each rate
    std::array<double, dim + 1> largest{}, error{};
    for (std::size_t i = 0; i < neighbours.size(); i += 7)
    {
        const int k = neighbours.order()[i];
        if (k < 0)
        {
            continue;
        }
        const auto exact = rates<dim>(c, k, m, gradients);
        for (int q = 0; q <= dim; ++q)
        {
            const double value = q ? particles.acceleration[q - 1][i] : particles.densityRate[i];
            largest[q] = std::max(largest[q], std::abs(exact[q]));
            error[q] = std::max(error[q], std::abs(value - exact[q]));
        }
    }
    double worst = 0;
    for (int q = 0; q <= dim; ++q)
    {
        EXPECT_LT(error[q], tolerance*largest[q]) << "rate " << q << " in " << interact.instructions();
        worst = std::max(worst, error[q]/largest[q]);
    }
    return worst;
}


//- All that can be chosen
std::vector<interactionModel> models(double h)
{
    std::vector<interactionModel> all;
    for (const kernelType kernel : {kernelType::WendlandC2, kernelType::WendlandC4, kernelType::cubicSpline})
    {
        for (const viscosityType viscosity : {viscosityType::none, viscosityType::laminar, viscosityType::artificial})
        {
            for
            (
                const diffusionType diffusion :
                {diffusionType::none, diffusionType::Molteni, diffusionType::Fourtakas, diffusionType::Antuono}
            )
            {
                interactionModel m;
                m.kernel = kernel;
                m.viscosity = viscosity;
                m.diffusion = diffusion;
                m.h = h;
                m.c0 = 30;
                m.mu = 50;
                m.alpha = 0.5;
                m.delta = 0.1;
                m.g = {{5, -800, 700}};
                all.push_back(m);
            }
        }
    }
    return all;
}


template<int dim>
void checkNeighbours()
{
    const cloud<dim> c(dim == 2 ? 40 : 14);
    const double radius = 2.7*spacing;
    clusterNeighbours<dim> neighbours;
    neighbours.sort(c.x, spacing, 1);
    neighbours.search(c.x, none(c.x.size()), none(c.x.size()), radius, 1);

    // Every particle has one place
    std::set<int> seen;
    for (const std::int32_t k : neighbours.order())
    {
        if (k >= 0)
        {
            EXPECT_TRUE(seen.insert(k).second);
        }
    }
    ASSERT_EQ(seen.size(), c.x.size());
    EXPECT_LT(neighbours.size(), 1.5*c.x.size());

    for (std::size_t i = 0; i < neighbours.size(); ++i)
    {
        const int k = neighbours.order()[i];
        if (k < 0)
        {
            EXPECT_EQ(neighbours.begin(i), neighbours.end(i));
            continue;
        }
        std::set<int> found;
        for (const std::int32_t* cluster = neighbours.begin(i); cluster != neighbours.end(i); ++cluster)
        {
            for (int lane = 0; lane < clusterSize; ++lane)
            {
                const int other = neighbours.order()[*cluster*clusterSize + lane];
                if (other >= 0)
                {
                    EXPECT_TRUE(found.insert(other).second);
                }
            }
        }
        for (std::size_t j = 0; j < c.x.size(); ++j)
        {
            double r2 = 0;
            for (int d = 0; d < dim; ++d)
            {
                r2 += std::pow(c.x[k][d] - c.x[j][d], 2);
            }
            if (r2 < radius*radius)
            {
                ASSERT_TRUE(found.count(j)) << k << " misses " << j;
            }
        }
    }

    // Whatever the number of threads
    clusterNeighbours<dim> shared;
    shared.sort(c.x, spacing, 3);
    shared.search(c.x, none(c.x.size()), none(c.x.size()), radius, 3);
    ASSERT_EQ(shared.order(), neighbours.order());
    for (std::size_t i = 0; i < neighbours.size(); ++i)
    {
        ASSERT_TRUE(std::equal(shared.begin(i), shared.end(i), neighbours.begin(i), neighbours.end(i)));
    }
}


template<class Real, int dim>
void checkTwins(double momentumTolerance)
{
    const cloud<dim> c(dim == 2 ? 40 : 14);
    interactionModel m = models(1.5*spacing)[9];
    clusterNeighbours<dim> neighbours;
    neighbours.sort(c.x, spacing, 1);
    neighbours.search(c.x, none(c.x.size()), none(c.x.size()), 2.2*m.h, 1);
    auto once = c.template packed<Real>(neighbours);
    auto again = c.template packed<Real>(neighbours);
    const interaction<Real, dim> interact(m);
    interact.sumDensityRate(neighbours, once, 1);
    interact.sumAcceleration(neighbours, once, 1);
    interact.sumDensityRate(neighbours, again, 2);
    interact.sumAcceleration(neighbours, again, 2);
    EXPECT_EQ(once.densityRate, again.densityRate);
    EXPECT_EQ(once.acceleration, again.acceleration);

    // Momentum: what one particle gives another gets
    for (int d = 0; d < dim; ++d)
    {
        double total = 0;
        double size = 0;
        for (std::size_t i = 0; i < neighbours.size(); ++i)
        {
            const int k = neighbours.order()[i];
            if (k >= 0)
            {
                const double force = (rho0 + c.density[k])*c.volume[k]*once.acceleration[d][i];
                total += force;
                size += std::abs(force);
            }
        }
        EXPECT_LT(std::abs(total), momentumTolerance*size);
        EXPECT_GT(size, 0);
    }
}

} // End anonymous namespace


TEST(ClusterNeighbours, inThePlane)
{
    checkNeighbours<2>();
}


TEST(ClusterNeighbours, inSpace)
{
    checkNeighbours<3>();
}


TEST(ClusterNeighbours, fewParticles)
{
    clusterNeighbours<3> empty;
    empty.sort({}, spacing, 2);
    empty.search({}, {}, {}, spacing, 2);
    EXPECT_EQ(empty.size(), 0u);

    const std::vector<std::array<double, 3>> one = {{{0.1, 0.2, 0.3}}};
    clusterNeighbours<3> neighbours;
    neighbours.sort(one, spacing, 2);
    neighbours.search(one, none(1), none(1), spacing, 2);
    EXPECT_EQ(neighbours.size(), std::size_t(clusterSize));
    EXPECT_EQ(neighbours.end(0) - neighbours.begin(0), 1);
}


// What is passive has only what is not for a neighbour, and that all of it
TEST(ClusterNeighbours, passiveParticles)
{
    const cloud<2> c(40);
    std::vector<unsigned char> passive(c.x.size());
    for (std::size_t k = 0; k < passive.size(); ++k)
    {
        passive[k] = c.x[k][0] < 0.15;
    }
    const double radius = 2.7*spacing;
    clusterNeighbours<2> neighbours, all;
    neighbours.sort(c.x, spacing, 1);
    neighbours.search(c.x, passive, none(c.x.size()), radius, 1);
    all.sort(c.x, spacing, 1);
    all.search(c.x, none(c.x.size()), none(c.x.size()), radius, 1);
    EXPECT_LT(neighbours.nPairs(), 0.8*all.nPairs());

    for (std::size_t i = 0; i < neighbours.size(); ++i)
    {
        const int k = neighbours.order()[i];
        if (k < 0)
        {
            continue;
        }
        std::set<std::int32_t> found(neighbours.begin(i), neighbours.end(i));
        for (const std::int32_t* cluster = all.begin(i); cluster != all.end(i); ++cluster)
        {
            bool active = false;
            for (int lane = 0; lane < clusterSize; ++lane)
            {
                const int other = all.order()[*cluster*clusterSize + lane];
                active = active || (other >= 0 && !passive[other]);
            }
            EXPECT_EQ(found.count(*cluster) == 1, active || !passive[k]);
        }
    }
}


// The tolerances are the round-off of sums of some 50 terms that cancel
TEST(Interaction, agreesWithTheSumOverAllPairs)
{
    const cloud<2> plane(30);
    const cloud<3> space(12);
    for (const interactionModel& m : models(1.5*spacing))
    {
        for (const instructionSet widest : {instructionSet::SSE2, instructionSet::AVX2, instructionSet::AVX512})
        {
            largestError<double, 2>(plane, m, widest, 1e-12);
            largestError<double, 3>(space, m, widest, 1e-12);
            largestError<float, 2>(plane, m, widest, 1e-4);
            largestError<float, 3>(space, m, widest, 1e-4);
        }
    }
}


TEST(Interaction, twinsAndMomentum)
{
    checkTwins<double, 2>(1e-13);
    checkTwins<double, 3>(1e-13);
    checkTwins<float, 2>(1e-5);
    checkTwins<float, 3>(1e-5);
}


namespace
{

//- A cloud whose particles on one side are of a wall: what they take part in
template<class Real, int dim>
struct wallAndFluid
{
    const cloud<dim> c;
    clusterNeighbours<dim> neighbours;
    packedParticles<Real, dim> particles;

    explicit wallAndFluid(const interactionModel& m)
    :
        c(dim == 2 ? 30 : 12)
    {
        neighbours.sort(c.x, spacing, 1);
        neighbours.search(c.x, none(c.x.size()), none(c.x.size()), 2.2*m.h, 1);
        particles = c.template packed<Real>(neighbours);
        particles.fluid.clear();
        for (std::size_t i = 0; i < neighbours.size(); ++i)
        {
            const int k = neighbours.order()[i];
            if (k >= 0)
            {
                (isWall(k) ? particles.walls : particles.fluid).push_back(i);
                particles(i, packedParticles<Real, dim>::share) = isWall(k) ? 0 : 1;
            }
        }
    }

    bool isWall(int k) const
    {
        return c.x[k][0] < 3*spacing;
    }

    template<class Vectors>
    void setVelocity(Vectors& velocity) const
    {
        for (std::size_t i = 0; i < neighbours.size(); ++i)
        {
            for (int d = 0; d < dim; ++d)
            {
                velocity[d][i] = neighbours.order()[i] < 0 ? 0 : c.v[neighbours.order()[i]][d];
            }
        }
    }
};


//- Eq. 2 pair by pair, and that the sums of energy take what those of force give
template<class Real, int dim>
void checkEnergyRate(const interactionModel& m, double tolerance)
{
    typedef packedParticles<Real, dim> fields;
    wallAndFluid<Real, dim> w(m);
    const cloud<dim>& c = w.c;
    fields& particles = w.particles;
    particles.addEnergy();
    w.setVelocity(particles.velocity);
    if (m.noSlip)
    {
        // Viscosity feels another velocity of the wall than its own
        for (const std::int32_t i : particles.walls)
        {
            for (int d = 0; d < dim; ++d)
            {
                particles(i, fields::v + d) *= -0.5;
            }
        }
    }
    const interaction<Real, dim> interact(m);
    interact.sumEnergyRate(w.neighbours, particles, 1);
    interact.sumAcceleration(w.neighbours, particles, 1);

    double largest = 0;
    double error = 0;
    for (const std::int32_t i : particles.fluid)
    {
        const int k = w.neighbours.order()[i];
        const double rho = rho0 + c.density[k];
        double exact = 0;
        for (std::size_t j = 0; j < c.x.size(); ++j)
        {
            const pairOf<dim> p(c, k, j, m);
            const double mass = c.volume[j]*(m.pressure == pressureType::solid ? rho0 + c.density[j] : rho);
            exact += c.pressure[k]/(rho*rho)*mass*p.F*p.approach;
        }
        largest = std::max(largest, std::abs(exact));
        error = std::max(error, std::abs(particles.energyRate[i] - exact));
    }
    EXPECT_LT(error, tolerance*largest);

    // Kinetic, internal, dissipated, less what the wall gives
    double sum = 0;
    double size = 0;
    double heat = 0;
    for (const auto* places : {&particles.fluid, &particles.walls})
    {
        for (const std::int32_t i : *places)
        {
            const int k = w.neighbours.order()[i];
            const bool wall = w.isWall(k);
            const double mass = c.volume[k]*(rho0 + (wall ? 0 : c.density[k]));
            double power = 0;
            for (int d = 0; d < dim; ++d)
            {
                power += wall ? 0 : mass*c.v[k][d]*particles.acceleration[d][i];
            }
            power += mass*particles.energyRate[i] + mass*particles.heating[i]*(wall ? -1 : 1);
            sum += power;
            size += std::abs(power);
            heat += wall ? 0 : mass*particles.heating[i];
            EXPECT_TRUE(wall || m.noSlip || particles.heating[i] >= 0);
        }
    }
    EXPECT_LT(std::abs(sum), tolerance*size);
    EXPECT_EQ(heat > 0, m.viscosity != viscosityType::none);
}


template<class Real, int dim>
void checkSurface(const interactionModel& m, double tolerance)
{
    wallAndFluid<Real, dim> w(m);
    const cloud<dim>& c = w.c;
    auto& particles = w.particles;
    particles.addShifting();
    const interaction<Real, dim> interact(m);
    interact.sumConcentration(w.neighbours, particles, 1);
    interact.sumSurfaceNormal(w.neighbours, particles, 1);

    std::vector<double> divergence(c.x.size());
    for (const std::int32_t i : particles.fluid)
    {
        divergence[w.neighbours.order()[i]] = particles.positionDivergence[i];
    }
    std::array<double, 4> largest{}, error{};
    int nNear = 0;
    for (const std::int32_t i : particles.fluid)
    {
        const int k = w.neighbours.order()[i];
        double exact = 0;
        double nearest2 = 1e30;
        bool near = false;
        std::array<double, dim> concentration{}, normal{};
        for (std::size_t j = 0; j < c.x.size(); ++j)
        {
            const pairOf<dim> p(c, k, j, m);
            exact -= c.volume[j]*p.F*p.r2;
            near = near || (p.r2 < 4*m.h*m.h && !w.isWall(j) && divergence[j] < (dim == 2 ? 1.5 : 2.75));
            nearest2 = w.isWall(j) ? std::min(nearest2, p.r2) : nearest2;
            for (int d = 0; d < dim; ++d)
            {
                concentration[d] += c.volume[j]*p.F*p.r[d];
                normal[d] += w.isWall(j) ? 0 : c.volume[j]*(divergence[j] - divergence[k])*p.F*p.r[d];
            }
        }
        const auto compare = [&](int which, double found, double expected)
        {
            largest[which] = std::max(largest[which], std::abs(expected));
            error[which] = std::max(error[which], std::abs(found - expected));
        };
        compare(0, particles.positionDivergence[i], exact);
        const double scale = kernelNormalisation(m.kernel, dim)/std::pow(m.h, dim + 2);
        for (int d = 0; d < dim; ++d)
        {
            compare(1, particles.concentration[d][i], concentration[d]);
            compare(2, scale*particles.surfaceNormal[d][i], normal[d]);
        }
        if (nearest2 < 4*m.h*m.h)
        {
            compare(3, particles.wallDistance2[i], nearest2);
        }
        EXPECT_EQ(particles.nearSurface[i] > 0, near);
        nNear += near;
    }
    for (int which = 0; which < 4; ++which)
    {
        EXPECT_LT(error[which], tolerance*largest[which]) << which;
    }
    EXPECT_GT(nNear, 10);
    // In three dimensions the cloud is too small to be without a surface anywhere
    EXPECT_TRUE(dim == 3 || particles.fluid.size() - nNear > 10);
}

} // End anonymous namespace


// Exact where the density is linear, at a free surface too, so that nothing spreads; nothing at a lone pair of particles
TEST(Interaction, renormalisedGradientOfLinearDensity)
{
    interactionModel m = models(1.5*spacing)[3];
    ASSERT_EQ(m.diffusion, diffusionType::Antuono);
    cloud<3> c(12);
    for (std::size_t k = 0; k < c.x.size(); ++k)
    {
        c.v[k] = {{0, 0, 0}};
        c.density[k] = 30*c.x[k][0] - 20*c.x[k][1] + 50*c.x[k][2];
    }
    c.x.push_back({{1, 1, 1}});
    c.x.push_back({{1 + spacing, 1, 1}});
    for (int k = 0; k < 2; ++k)
    {
        c.v.push_back({{0, 0, 0}});
        c.density.push_back(k);
        c.pressure.push_back(0);
        c.volume.push_back(1e-6);
    }
    clusterNeighbours<3> neighbours;
    neighbours.sort(c.x, spacing, 1);
    neighbours.search(c.x, none(c.x.size()), none(c.x.size()), 2.2*m.h, 1);
    auto particles = c.packed<double>(neighbours);
    particles.addDensityGradient();
    const interaction<double, 3> interact(m);
    interact.sumDensityGradient(neighbours, particles, 1);
    interact.sumDensityRate(neighbours, particles, 1);
    int exact = 0;
    for (const std::int32_t i : particles.fluid)
    {
        const std::array<double, 3> g =
        {{
            particles.densityGradient[0][i], particles.densityGradient[1][i], particles.densityGradient[2][i]
        }};
        if (g != std::array<double, 3>{{0, 0, 0}})
        {
            EXPECT_NEAR(g[0], 30, 1e-8);
            EXPECT_NEAR(g[1], -20, 1e-8);
            EXPECT_NEAR(g[2], 50, 1e-8);
            ++exact;
        }
        if (c.x[neighbours.order()[i]][0] > 0.9)
        {
            EXPECT_EQ(g, (std::array<double, 3>{{0, 0, 0}}));
            EXPECT_NE(particles.densityRate[i], 0);
        }
    }
    EXPECT_GT(exact, 1000);
}


TEST(Interaction, ratesOfEnergyBalanceThoseOfMotion)
{
    interactionModel m = models(1.5*spacing)[0];
    m.beta = 0.5;
    for (const pressureType pressure : {pressureType::fluid, pressureType::solid})
    {
        for
        (
            const viscosityType viscosity :
            {viscosityType::none, viscosityType::laminar, viscosityType::artificial, viscosityType::Riemann}
        )
        {
            for (const bool noSlip : {false, true})
            {
                m.pressure = pressure;
                m.viscosity = viscosity;
                m.noSlip = noSlip;
                checkEnergyRate<double, 2>(m, 1e-12);
                checkEnergyRate<double, 3>(m, 1e-12);
                checkEnergyRate<float, 2>(m, 1e-4);
                checkEnergyRate<float, 3>(m, 1e-4);
            }
        }
    }
}


TEST(Interaction, surfaceDetectionAgreesWithTheSumOverAllPairs)
{
    const interactionModel m = models(1.5*spacing)[0];
    checkSurface<double, 2>(m, 1e-12);
    checkSurface<double, 3>(m, 1e-12);
    checkSurface<float, 2>(m, 1e-4);
    checkSurface<float, 3>(m, 1e-4);
}
