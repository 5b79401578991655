// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleFlow.H"
#include "particleShifting.H"
#include "smoothingKernels.H"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

using namespace Foam::smoothedParticles;
using Foam::bodyLoads;
using Foam::bodyState;

// Search radius beyond the support, over the spacing: larger is slower to sum, and searched more seldom
constexpr double skinRatio = 0.3;

// Every so many particles have their neighbours counted
constexpr int countedShare = 64;

// Particles in turn for each thread: those of walls, which come together, have more to do in some loops and less in others
constexpr int turn = 1024;


[[noreturn]] void refuse(const std::string& entry, double value, const char* expected)
{
    std::ostringstream message;
    message << entry << " is " << value << ": expected " << expected;
    throw std::invalid_argument(message.str());
}


void checkPositive(const std::string& entry, double value)
{
    if (!(value > 0) || !std::isfinite(value))
    {
        refuse(entry, value, "a number above 0");
    }
}


void checkNotNegative(const std::string& entry, double value)
{
    if (!(value >= 0) || !std::isfinite(value))
    {
        refuse(entry, value, "0 or above");
    }
}


//- p = B ((rho/rho0)^gamma - 1)
class MurnaghanPressure
{
    double rho0_;
    double gamma_;
    double B_;

    //- gamma, where it is a small whole number; else 0
    int whole_;

    //- (1 + x)^gamma - 1, without cancellation; not a number where the density is below 0
    double growth(double x) const
    {
        if (whole_ && x > -1)
        {
            double sum = 1;
            for (int k = 1; k < whole_; ++k)
            {
                sum = sum*(1 + x) + 1;
            }
            return x*sum;
        }
        return std::expm1(gamma_*std::log1p(x));
    }


public:

    MurnaghanPressure(double rho0, double c0, double gamma)
    :
        rho0_(rho0),
        gamma_(gamma),
        B_(rho0*c0*c0/gamma),
        whole_(gamma <= 16 && gamma == std::floor(gamma) ? static_cast<int>(gamma) : 0)
    {}

    //- p [Pa] of rho - rho0 [kg/m3]
    double pressure(double density) const
    {
        return B_*growth(density/rho0_);
    }

    //- rho - rho0 [kg/m3] of p [Pa]
    double density(double p) const
    {
        return rho0_*std::expm1(std::log1p(p/B_)/gamma_);
    }

    //- rho - rho0 [kg/m3] at rest under gravity times depth [m2/s2]: dp = rho(p) g dz
    double densityAtRest(double load) const
    {
        return rho0_*std::expm1(std::log1p((gamma_ - 1)/gamma_*rho0_*load/B_)/(gamma_ - 1));
    }

    //- Internal energy [J/kg]: the integral of p/rho^2 from rho0
    double energy(double density) const
    {
        const double lnRatio = std::log1p(density/rho0_);
        return B_/rho0_*(std::expm1((gamma_ - 1)*lnRatio)/(gamma_ - 1) + std::expm1(-lnRatio));
    }
};


template<class Real, int dim>
class flowIn
:
    public particleFlow<dim>
{
    typedef packedParticles<Real, dim> fields;
    typedef std::array<double, dim> vector;

    const particleFlowModel<dim> model_;
    const int nThreads_;
    const MurnaghanPressure state_;
    const interaction<Real, dim> interaction_;

    double time_;

    // In the order in which the particles are in memory

        std::vector<std::int32_t> original_;
        std::vector<std::int32_t> wall_;
        std::vector<vector> x_, v_, a_;
        std::vector<double> density_, mass_;

        //- Energy, of eq. 2 and dissipated [J/kg], and the rates of both [W/kg]; empty if it is off
        std::vector<double> energy_, heat_, energyRate_, heating_;

        //- At the start of the step
        std::vector<vector> xOld_, vOld_;
        std::vector<double> densityOld_;

        //- Where each was when neighbours were last searched, and its place among the clusters
        std::vector<vector> xSearched_;
        std::vector<std::int32_t> place_;

        //- The number that each had before the last sort
        std::vector<std::int32_t> from_;

    // Mirror images

        std::vector<mirrorImage<dim>> images_;
        std::vector<std::int32_t> imagePlace_;

        //- Of the particles and then the images; empty if there are none
        std::vector<vector> xAll_;
        std::vector<unsigned char> passive_, silent_;

    // Walls that move

        struct body
        {
            bodyState now, end;

            //- With the acceleration that the pressure on the wall is extrapolated with
            bodyState felt;

            //- Where it is when forces are summed
            bodyState at;

            bodyLoads loads;
        };

        std::map<std::int32_t, body> bodies_;

        struct bodyParticle
        {
            std::int32_t original;
            std::int32_t now;
            body* of;
            Foam::vector inBody;
        };

        std::vector<bodyParticle> bodyParticles_;
        std::vector<std::int32_t> bodyPlaces_;

    // Contact

        //- Of the surface on each particle [N], and its energy [J]
        std::vector<vector> push_;
        std::vector<double> spring_;

        //- By wall
        std::vector<bodyLoads> contactLoads_;
        double contactEnergy_ = 0;

        //- Highest square of a spring's frequency [1/s2]
        double contactFrequency2_ = 0;

    clusterNeighbours<dim> neighbours_;
    fields packed_;

    //- Origin of the packed positions: single precision counts from the middle
    vector middle_;

    double maxSpeed_ = 0;
    double maxAcceleration_ = 0;

    long nSearches_ = 0;
    double pairsPerSum_ = 0;
    double nPairs_ = 0;
    double nParticleSteps_ = 0;
    std::size_t nFluid_ = 0;


    static Foam::vector toVector(const vector& x)
    {
        return Foam::vector(x[0], x[1], dim == 3 ? x[dim - 1] : 0);
    }

    //- Bring an array into the new order
    template<class T>
    void reorder(std::vector<T>& values, std::vector<T>& spare) const
    {
        const std::int64_t n = values.size();
        spare.resize(n);
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            spare[k] = values[from_[k]];
        }
        values.swap(spare);
    }

    template<class T>
    void copy(const std::vector<T>& from, std::vector<T>& to) const
    {
        const std::int64_t n = from.size();
        to.resize(n);
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            to[k] = from[k];
        }
    }

    //- Of particles and images
    const std::vector<vector>& positions() const
    {
        return images_.empty() ? x_ : xAll_;
    }

    bool isFluid(std::size_t k) const
    {
        return wall_[k] == particleState<dim>::fluid;
    }

    double supportRadius() const
    {
        return supportRatio*model_.interaction.h;
    }

    double searchRadius() const
    {
        return supportRadius() + skinRatio*model_.spacing;
    }

    //- After the particles
    void placeImages()
    {
        if (!images_.empty())
        {
            copy(x_, xAll_);
            for (const mirrorImage<dim>& image : images_)
            {
                xAll_.push_back(image.position(x_[image.source]));
            }
        }
    }

    //- Into the order of the clusters, with the images of now
    void sort()
    {
        const std::size_t n = x_.size();
        findMirrorImages<dim>(model_.symmetry, x_, searchRadius(), images_);
        placeImages();
        neighbours_.sort(positions(), model_.spacing, nThreads_);

        const std::vector<std::int32_t>& order = neighbours_.order();
        from_.clear();
        for (const std::int32_t k : order)
        {
            if (k >= 0 && k < std::int32_t(n))
            {
                from_.push_back(k);
            }
        }
        reorder(original_, place_);
        reorder(wall_, place_);
        reorder(x_, xOld_);
        reorder(v_, xOld_);
        reorder(a_, xOld_);
        reorder(density_, densityOld_);
        reorder(mass_, densityOld_);
        if (model_.energy)
        {
            for (std::vector<double>* values : {&energy_, &heat_, &energyRate_, &heating_})
            {
                reorder(*values, densityOld_);
            }
        }
        if (!images_.empty())
        {
            std::vector<std::int32_t>& newOf = imagePlace_;
            newOf.resize(n);
            for (std::size_t k = 0; k < n; ++k)
            {
                newOf[from_[k]] = k;
            }
            std::vector<mirrorImage<dim>> sorted;
            for (const std::int32_t k : order)
            {
                if (k >= std::int32_t(n))
                {
                    sorted.push_back(images_[k - n]);
                    sorted.back().source = newOf[sorted.back().source];
                }
            }
            images_.swap(sorted);
            placeImages();
        }
        neighbours_.renumber(n);
    }

    void search()
    {
        sort();
        const std::int64_t n = x_.size();
        passive_.resize(n + images_.size());
        silent_.assign(n + images_.size(), false);
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            passive_[k] = !isFluid(k);
        }
        for (std::size_t g = 0; g < images_.size(); ++g)
        {
            passive_[n + g] = !isFluid(images_[g].source);
            silent_[n + g] = true;
        }
        neighbours_.search(positions(), passive_, silent_, searchRadius(), nThreads_);

        place_.resize(n);
        imagePlace_.resize(images_.size());
        packed_.resize(neighbours_.size());
        packed_.fluid.clear();
        packed_.walls.clear();
        middle_ = neighbours_.middle();
        const std::vector<std::int32_t>& order = neighbours_.order();
        const std::int64_t nPlaces = order.size();
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t i = 0; i < nPlaces; ++i)
        {
            if (order[i] >= 0)
            {
                packed_(i, fields::share) = passive_[order[i]] ? 0 : 1;
                (order[i] < n ? place_[order[i]] : imagePlace_[order[i] - n]) = i;
            }
        }
        for (std::int64_t k = 0; k < n; ++k)
        {
            (passive_[k] ? packed_.walls : packed_.fluid).push_back(place_[k]);
        }
        findBodyParticles();
        if (model_.interaction.diffusion == diffusionType::Antuono)
        {
            packed_.addDensityGradient();
        }
        if (model_.energy)
        {
            packed_.addEnergy();
        }
        if (model_.shifting > 0)
        {
            packed_.addShifting();
        }
        copy(x_, xSearched_);
        ++nSearches_;
        countPairs();
    }

    void findBodyParticles()
    {
        if (bodies_.empty())
        {
            return;
        }
        packed_.moveWalls();
        const std::int64_t n = x_.size();
        std::vector<std::int32_t> newOf(n);
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            newOf[original_[k]] = k;
        }
        bodyPlaces_.clear();
        for (bodyParticle& p : bodyParticles_)
        {
            p.now = newOf[p.original];
            bodyPlaces_.push_back(place_[p.now]);
        }
    }

    //- Pairs inside the support of one sum over all particles of the fluid, from some of them
    void countPairs()
    {
        double pairs = 0;
        double counted = 0;
        const double radius2 = supportRadius()*supportRadius();
        const std::vector<vector>& x = positions();
        const std::int64_t n = x_.size();
        #pragma omp parallel for num_threads(nThreads_) schedule(dynamic, 64) reduction(+: pairs, counted)
        for (std::int64_t k = 0; k < n; k += countedShare)
        {
            if (!isFluid(k))
            {
                continue;
            }
            ++counted;
            for (auto c = neighbours_.begin(place_[k]); c != neighbours_.end(place_[k]); ++c)
            {
                for (int lane = 0; lane < clusterSize; ++lane)
                {
                    const std::int32_t j = neighbours_.order()[*c*clusterSize + lane];
                    if (j < 0 || j == k)
                    {
                        continue;
                    }
                    double r2 = 0;
                    for (int d = 0; d < dim; ++d)
                    {
                        r2 += (x[j][d] - x[k][d])*(x[j][d] - x[k][d]);
                    }
                    pairs += r2 < radius2;
                }
            }
        }
        pairsPerSum_ = counted > 0 ? pairs/counted*nFluid_ : 0;
    }

    //- For the sums: positions and velocities as they are now; densities, volumes and pressures of the fluid
    void packFields()
    {
        const interactionModel& m = model_.interaction;
        const double damping = m.acousticDamper*m.c0*m.h;
        const std::int64_t n = x_.size();

        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            const std::size_t i = place_[k];
            for (int d = 0; d < dim; ++d)
            {
                packed_(i, fields::x + d) = x_[k][d] - middle_[d];
                packed_(i, fields::v + d) = v_[k][d];
            }
            packed_(i, fields::density) = density_[k];
            packed_(i, fields::volume) = mass_[k]/(model_.rho0 + (isFluid(k) ? density_[k] : 0));
            packed_(i, fields::pressure) = state_.pressure(density_[k]) + damping*packed_.densityRate[i];
        }
        packImages();
    }

    //- As their sources are
    void packImages()
    {
        const std::int64_t n = images_.size();

        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t g = 0; g < n; ++g)
        {
            const mirrorImage<dim>& image = images_[g];
            const std::size_t from = place_[image.source];
            const std::size_t to = imagePlace_[g];
            for (int d = 0; d < dim; ++d)
            {
                packed_(to, fields::x + d) = image.sign[d]*x_[image.source][d] + image.offset[d] - middle_[d];
                packed_(to, fields::v + d) = image.sign[d]*packed_(from, fields::v + d);
            }
            for (const int field : {fields::density, fields::volume, fields::pressure})
            {
                packed_(to, field) = packed_(from, field);
            }
        }
    }

    //- To the images, of vectors (with the sign of the mirror) or of scalars by place
    void packImages(std::array<packVector<Real>, dim>& vectors)
    {
        const std::int64_t n = images_.size();
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t g = 0; g < n; ++g)
        {
            for (int d = 0; d < dim; ++d)
            {
                vectors[d][imagePlace_[g]] = images_[g].sign[d]*vectors[d][place_[images_[g].source]];
            }
        }
    }

    void packImages(packVector<Real>& scalars)
    {
        const std::int64_t n = images_.size();
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t g = 0; g < n; ++g)
        {
            scalars[imagePlace_[g]] = scalars[place_[images_[g].source]];
        }
    }

    //- Pressure and velocity of walls from the packed fluid; their density is that of the pressure
    void extrapolateToWalls()
    {
        packWalls();
        const std::int64_t n = x_.size();
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            if (!isFluid(k))
            {
                density_[k] = packed_(place_[k], fields::density);
            }
        }
    }

    //- Extrapolated, as far as walls hold the liquid [Pa]
    double wallPressure(std::size_t place) const
    {
        return std::max<double>(packed_.wallPressure[place], -model_.wallTension);
    }

    //- The same, of the packed walls alone
    void packWalls()
    {
        for (const bodyParticle& p : bodyParticles_)
        {
            const bodyState& felt = p.of->felt;
            const Foam::vector r(toVector(x_[p.now]) - felt.centreOfMass);
            const Foam::vector a
            (
                felt.acceleration + (felt.angularAcceleration ^ r) + (felt.omega ^ (felt.omega ^ r))
            );
            for (int d = 0; d < dim; ++d)
            {
                packed_.ownVelocity[d][place_[p.now]] = v_[p.now][d];
                packed_.ownAcceleration[d][place_[p.now]] = a[d];
            }
        }
        interaction_.extrapolate(neighbours_, packed_, nThreads_);

        const std::int64_t n = x_.size();
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            if (isFluid(k))
            {
                continue;
            }
            const std::size_t i = place_[k];
            const double p = wallPressure(i);
            packed_(i, fields::density) = state_.density(p);
            packed_(i, fields::pressure) = p;
            for (int d = 0; d < dim; ++d)
            {
                packed_(i, fields::v + d) = packed_.wallVelocity[d][i];
            }
        }
        packImages();
    }

    //- Rate of change of the density as it is now, into packed_
    void sumDensityRate()
    {
        packFields();
        if (model_.interaction.diffusion == diffusionType::Antuono)
        {
            interaction_.sumDensityGradient(neighbours_, packed_, nThreads_);
            packImages(packed_.densityGradient);
        }
        interaction_.sumDensityRate(neighbours_, packed_, nThreads_);
    }

    //- Acceleration of the fluid as it is now, and the loads on bodies
    void sumAcceleration()
    {
        packFields();
        extrapolateToWalls();
        interaction_.sumAcceleration(neighbours_, packed_, nThreads_);
        sumLoads();

        const std::int64_t n = x_.size();
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            if (isFluid(k))
            {
                for (int d = 0; d < dim; ++d)
                {
                    a_[k][d] = packed_.acceleration[d][place_[k]] + model_.interaction.g[d];
                }
            }
        }
        if (model_.contact.isOn())
        {
            sumContact();
        }
        nPairs_ += pairsPerSum_;
    }

    //- The step that sound allows in a liquid at rest [s]
    double soundStep() const
    {
        return model_.Courant*model_.interaction.h/model_.interaction.c0;
    }

    //- Where a wall is, and where its surface has been given
    struct wallPose
    {
        Foam::point now, home;

        //- From the axes of now to those of then
        Foam::tensor back;
    };

    wallPose poseOf(std::int32_t wall) const
    {
        const auto found = bodies_.find(wall);
        if (found == bodies_.end())
        {
            return {Foam::vector::zero, Foam::vector::zero, Foam::tensor::I};
        }
        const bodyState& home = model_.contact.homes.at(wall);
        const bodyState& now = found->second.at;
        return {now.centreOfMass, home.centreOfMass, home.orientation & now.orientation.T()};
    }

    //- Add the acceleration of the fluid by contact, and the loads on walls
    void sumContact()
    {
        const penaltyContact& contact = model_.contact;
        const std::int64_t n = x_.size();
        contactEnergy_ = 0;
        for (std::size_t w = 0; w < contact.walls.size(); ++w)
        {
            const contactSurface& surface = *contact.walls[w];
            const wallPose pose(poseOf(w));

            #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
            for (std::int64_t k = 0; k < n; ++k)
            {
                push_[k].fill(0);
                spring_[k] = 0;
                contactSurface::touching t;
                if
                (
                    surface.touch(pose.home + (pose.back & (toVector(x_[k]) - pose.now)), t)
                 && t.depth <= contact.maxDepth
                )
                {
                    const double force = contact.k(mass_[k], soundStep(), t.area)*t.depth;
                    const Foam::vector push(force*(pose.back.T() & t.normal));
                    spring_[k] = 0.5*force*t.depth;
                    for (int d = 0; d < dim; ++d)
                    {
                        push_[k][d] = push[d];
                        a_[k][d] += push[d]/mass_[k];
                    }
                }
            }

            // In the order of the particles, whatever the number of threads
            bodyLoads& loads = contactLoads_[w];
            loads = {Foam::vector::zero, Foam::vector::zero, Foam::vector::zero};
            for (std::int64_t k = 0; k < n; ++k)
            {
                if (spring_[k] > 0)
                {
                    const Foam::vector push(toVector(push_[k]));
                    contactEnergy_ += spring_[k];
                    loads.pressure -= push;
                    loads.moment -= (toVector(x_[k]) - pose.now) ^ push;
                }
            }
            const auto found = bodies_.find(w);
            if (found != bodies_.end())
            {
                found->second.loads = loads;
            }
        }
    }

    void setUpContact()
    {
        const penaltyContact& contact = model_.contact;
        push_.resize(x_.size());
        spring_.resize(x_.size());
        contactLoads_.resize(contact.walls.size());
        const double lightest = *std::min_element(mass_.begin(), mass_.end());
        for (const auto& wall : contact.walls)
        {
            contactFrequency2_ = std::max(contactFrequency2_, contact.k(lightest, soundStep(), wall->maxArea())/lightest);
        }
    }

    void sumLoads()
    {
        if (bodies_.empty())
        {
            return;
        }
        interaction_.sumWallForce(neighbours_, packed_, bodyPlaces_, nThreads_);
        for (auto& b : bodies_)
        {
            b.second.loads = {Foam::vector::zero, Foam::vector::zero, Foam::vector::zero};
        }
        for (const bodyParticle& p : bodyParticles_)
        {
            Foam::vector push(Foam::vector::zero), friction(Foam::vector::zero);
            for (int d = 0; d < dim; ++d)
            {
                push[d] = packed_.acceleration[d][place_[p.now]];
                friction[d] = packed_.friction[d][place_[p.now]];
            }
            bodyLoads& loads = p.of->loads;
            loads.pressure += push;
            loads.viscous += friction;
            loads.moment += (toVector(x_[p.now]) - p.of->at.centreOfMass) ^ (push + friction);
        }
    }

    double rate(std::size_t k) const
    {
        return packed_.densityRate[place_[k]];
    }

    //- Bodies to a part of the way of this step, 0.5 or 1, with the mean velocity of the step
    void moveBodies(double part, double deltaT)
    {
        for (auto& b : bodies_)
        {
            body& one = b.second;
            one.at.centreOfMass = one.now.centreOfMass + part*(one.end.centreOfMass - one.now.centreOfMass);
            one.at.orientation = one.now.orientation + part*(one.end.orientation - one.now.orientation);
        }
        for (const bodyParticle& p : bodyParticles_)
        {
            const Foam::vector end(p.of->end.centreOfMass + (p.of->end.orientation & p.inBody));
            for (int d = 0; d < dim; ++d)
            {
                v_[p.now][d] = (end[d] - xOld_[p.now][d])/deltaT;
                x_[p.now][d] = xOld_[p.now][d] + part*(end[d] - xOld_[p.now][d]);
            }
        }
    }

    //- The step's end is now. What a wall feels of its acceleration is a mean over the time that sound takes across h: the
    //  pressure on a wall follows its acceleration, and a body lighter than the liquid would follow the pressure at once.
    void arriveBodies(double deltaT)
    {
        const double weight = deltaT/(deltaT + model_.interaction.h/model_.interaction.c0);
        for (auto& b : bodies_)
        {
            body& one = b.second;
            const bodyState last(one.felt);
            one.now = one.felt = one.end;
            one.felt.acceleration = (1 - weight)*last.acceleration + weight*one.end.acceleration;
            one.felt.angularAcceleration = (1 - weight)*last.angularAcceleration + weight*one.end.angularAcceleration;
        }
    }

    //- The particles that have arrived, towards an even distribution
    void shift(double deltaT)
    {
        if (!(model_.shifting > 0))
        {
            return;
        }
        packFields();
        interaction_.sumConcentration(neighbours_, packed_, nThreads_);
        packImages(packed_.positionDivergence);
        interaction_.sumSurfaceNormal(neighbours_, packed_, nThreads_);

        const std::int64_t n = x_.size();
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            if (!isFluid(k))
            {
                continue;
            }
            const std::size_t i = place_[k];
            shiftingParticle<dim> one;
            one.x = x_[k];
            double speed2 = 0;
            for (int d = 0; d < dim; ++d)
            {
                speed2 += v_[k][d]*v_[k][d];
                one.concentration[d] = packed_.concentration[d][i];
                one.surfaceNormal[d] = packed_.surfaceNormal[d][i];
            }
            one.speed = std::sqrt(speed2);
            one.positionDivergence = packed_.positionDivergence[i];
            one.nearSurface = packed_.nearSurface[i] > 0;
            one.wallDistance = std::sqrt(double(packed_.wallDistance2[i]));
            const vector s(one.shift(model_.shifting, model_.interaction.h, model_.spacing, deltaT, model_.symmetry));
            for (int d = 0; d < dim; ++d)
            {
                x_[k][d] += s[d];
            }
        }
    }

    //- Rates of energy by the positions, velocities and densities as they are now
    void sumEnergyRates()
    {
        packFields();
        const std::int64_t n = x_.size();
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            for (int d = 0; d < dim; ++d)
            {
                packed_.velocity[d][place_[k]] = v_[k][d];
            }
        }
        packImages(packed_.velocity);
        packWalls();
        interaction_.sumEnergyRate(neighbours_, packed_, nThreads_);
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            energyRate_[k] = packed_.energyRate[place_[k]];
            heating_[k] = packed_.heating[place_[k]];
        }
    }

    //- Over the step that is made, by the mean of the rates at its ends
    void integrateEnergy(double deltaT)
    {
        if (!model_.energy)
        {
            return;
        }
        for (const bool after : {false, true})
        {
            if (after)
            {
                sumEnergyRates();
            }
            const std::int64_t n = x_.size();
            #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
            for (std::int64_t k = 0; k < n; ++k)
            {
                energy_[k] += 0.5*deltaT*energyRate_[k];
                heat_[k] += 0.5*deltaT*heating_[k];
            }
        }
    }

    //- Fluid: a kick and a drift of half a step
    void kickAndDrift(double half)
    {
        const std::int64_t n = x_.size();
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            if (isFluid(k))
            {
                for (int d = 0; d < dim; ++d)
                {
                    v_[k][d] += half*a_[k][d];
                    x_[k][d] += half*v_[k][d];
                }
            }
        }
    }

    void absorb(double deltaT)
    {
        if (!(model_.absorption.thickness > 0))
        {
            return;
        }
        const std::array<double, 3>& g = model_.interaction.g;
        const double weight = std::sqrt(g[0]*g[0] + g[1]*g[1] + g[2]*g[2]);
        const std::int64_t n = x_.size();
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            const double rate = isFluid(k) ? model_.absorption.rate(x_[k], model_.interaction.c0) : 0;
            if (rate > 0)
            {
                double load = weight*model_.absorption.surface;
                for (int d = 0; d < dim; ++d)
                {
                    load += g[d]*x_[k][d];
                }
                const double still = state_.densityAtRest(std::max(0.0, load));
                const double kept = std::exp(-rate*deltaT);
                density_[k] = still + kept*(density_[k] - still);
                for (int d = 0; d < dim; ++d)
                {
                    v_[k][d] *= kept;
                }
            }
        }
    }

    //- A particle that has passed a plane of symmetry changes places with its image
    void keepInside()
    {
        for (const symmetryPlane& plane : model_.symmetry)
        {
            const std::int64_t n = x_.size();
            #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
            for (std::int64_t k = 0; k < n; ++k)
            {
                if (isFluid(k) && plane.distance(x_[k]) < 0)
                {
                    x_[k][plane.axis] = 2*plane.at - x_[k][plane.axis];
                    v_[k][plane.axis] *= -1;
                    // Gravity stays
                    a_[k][plane.axis] = 2*model_.interaction.g[plane.axis] - a_[k][plane.axis];
                }
            }
        }
    }

    void stepVerlet(double deltaT)
    {
        const std::int64_t n = x_.size();
        const double half = 0.5*deltaT;

        if (!bodies_.empty())
        {
            copy(x_, xOld_);
        }
        kickAndDrift(half);
        moveBodies(0.5, deltaT);
        sumDensityRate();

        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            if (isFluid(k))
            {
                density_[k] += deltaT*rate(k);
                for (int d = 0; d < dim; ++d)
                {
                    x_[k][d] += half*v_[k][d];
                }
            }
        }
        moveBodies(1, deltaT);
        arriveBodies(deltaT);
        shift(deltaT);
        sumAcceleration();

        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            if (isFluid(k))
            {
                for (int d = 0; d < dim; ++d)
                {
                    v_[k][d] += half*a_[k][d];
                }
            }
        }
    }

    void stepSymplectic(double deltaT)
    {
        const std::int64_t n = x_.size();
        const double half = 0.5*deltaT;
        copy(x_, xOld_);
        copy(v_, vOld_);
        copy(density_, densityOld_);

        sumDensityRate();
        sumAcceleration();

        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            if (isFluid(k))
            {
                density_[k] += half*rate(k);
                for (int d = 0; d < dim; ++d)
                {
                    x_[k][d] += half*v_[k][d];
                    v_[k][d] += half*a_[k][d];
                }
            }
        }
        moveBodies(0.5, deltaT);
        sumDensityRate();
        sumAcceleration();

        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn)
        for (std::int64_t k = 0; k < n; ++k)
        {
            if (isFluid(k))
            {
                const double growth = deltaT*rate(k)/(model_.rho0 + density_[k]);
                const double rho = (model_.rho0 + densityOld_[k])*(2 + growth)/(2 - growth);
                density_[k] = rho - model_.rho0;
                for (int d = 0; d < dim; ++d)
                {
                    v_[k][d] = vOld_[k][d] + deltaT*a_[k][d];
                    x_[k][d] = xOld_[k][d] + half*(vOld_[k][d] + v_[k][d]);
                }
            }
        }
        moveBodies(1, deltaT);
        arriveBodies(deltaT);
        shift(deltaT);
    }

    //- Largest speed and acceleration; throws where a number is not finite
    void checkFields()
    {
        double speed2 = 0;
        double acceleration2 = 0;
        const std::int64_t n = x_.size();
        std::int64_t broken = n;

        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn) \
            reduction(max: speed2, acceleration2) reduction(min: broken)
        for (std::int64_t k = 0; k < n; ++k)
        {
            double v2 = 0;
            double a2 = 0;
            for (int d = 0; d < dim; ++d)
            {
                v2 += v_[k][d]*v_[k][d];
                a2 += a_[k][d]*a_[k][d];
            }
            speed2 = std::max(speed2, v2);
            acceleration2 = std::max(acceleration2, a2);
            if (!std::isfinite(v2 + a2 + density_[k]))
            {
                broken = std::min(broken, k);
            }
        }
        if (broken < n)
        {
            std::ostringstream message;
            message << "particle " << original_[broken] << " at (";
            for (int d = 0; d < dim; ++d)
            {
                message << (d ? " " : "") << x_[broken][d];
            }
            message << ") m has a velocity, density or acceleration that is not a number at " << time_ << " s";
            throw std::runtime_error(message.str());
        }
        for (const auto& b : bodies_)
        {
            // Without particles, too
            speed2 = std::max(speed2, magSqr(b.second.now.velocity));
        }
        maxSpeed_ = std::sqrt(speed2);
        maxAcceleration_ = std::sqrt(acceleration2);
    }

    //- Has a particle moved so far that a neighbour may be missing by the end of a step that moves it this far?
    bool isStale(double ahead) const
    {
        const double allowed = 0.5*skinRatio*model_.spacing - ahead;
        if (allowed <= 0)
        {
            return true;
        }
        double farthest2 = 0;
        const std::int64_t n = x_.size();
        #pragma omp parallel for num_threads(nThreads_) schedule(static, turn) reduction(max: farthest2)
        for (std::int64_t k = 0; k < n; ++k)
        {
            double moved2 = 0;
            for (int d = 0; d < dim; ++d)
            {
                moved2 += (x_[k][d] - xSearched_[k][d])*(x_[k][d] - xSearched_[k][d]);
            }
            farthest2 = std::max(farthest2, moved2);
        }
        return farthest2 > allowed*allowed;
    }


public:

    flowIn
    (
        const particleState<dim>& start,
        const particleFlowModel<dim>& model,
        int nThreads,
        const wallMotions& moving
    )
    :
        model_(model),
        nThreads_(nThreads),
        state_(model.rho0, model.interaction.c0, model.interaction.gamma),
        interaction_(model.interaction),
        time_(start.time),
        wall_(start.wall),
        x_(start.x),
        v_(start.v),
        a_(start.size(), vector{}),
        density_(start.density),
        mass_(start.mass)
    {
        packed_.rho0 = model.rho0;
        const double cell = std::pow(model.spacing, dim);
        for (std::size_t k = mass_.size(); k < density_.size(); ++k)
        {
            mass_.push_back((model.rho0 + (isFluid(k) ? density_[k] : 0))*cell);
        }
        for (const auto& motion : moving)
        {
            body& b = bodies_[motion.first];
            b.now = b.end = b.felt = b.at = motion.second;
            if (!start.felt.empty())
            {
                const std::array<double, 6>& a = start.felt[bodies_.size() - 1];
                b.felt.acceleration = Foam::vector(a[0], a[1], a[2]);
                b.felt.angularAcceleration = Foam::vector(a[3], a[4], a[5]);
            }
        }
        original_.resize(x_.size());
        for (std::size_t k = 0; k < x_.size(); ++k)
        {
            original_[k] = k;
            nFluid_ += isFluid(k);
            const auto found = bodies_.find(wall_[k]);
            if (found != bodies_.end())
            {
                const bodyState& now = found->second.now;
                const Foam::vector r(toVector(x_[k]) - now.centreOfMass);
                const Foam::vector v(now.velocity + (now.omega ^ r));
                std::copy_n(v.begin(), dim, v_[k].begin());
                bodyParticles_.push_back({std::int32_t(k), 0, &found->second, now.orientation.T() & r});
            }
        }
        if (model_.energy)
        {
            energy_ = start.energy;
            heat_ = start.heat;
            for (std::size_t k = energy_.size(); k < x_.size(); ++k)
            {
                energy_.push_back(isFluid(k) ? state_.energy(density_[k]) : 0);
                heat_.push_back(0);
            }
            energyRate_.resize(x_.size());
            heating_.resize(x_.size());
        }
        search();
        if (model_.contact.isOn())
        {
            setUpContact();
        }
        sumAcceleration();
        if (model_.energy)
        {
            sumEnergyRates();
        }
        if (!start.acceleration.empty())
        {
            for (std::size_t k = 0; k < x_.size(); ++k)
            {
                a_[k] = start.acceleration[original_[k]];
            }
        }
        checkFields();
    }

    double time() const override
    {
        return time_;
    }

    double stableTimeStep() const override
    {
        const double h = model_.interaction.h;
        double step = h/(model_.interaction.c0 + maxSpeed_);
        if (maxAcceleration_ > 0)
        {
            step = std::min(step, std::sqrt(h/maxAcceleration_));
        }
        if (model_.interaction.viscosity == viscosityType::laminar && model_.interaction.mu > 0)
        {
            // Morris et al. 1997, eq. 22, whose factor of 0.125 is the Courant number's 0.2 here
            step = std::min(step, 0.6*h*h*model_.rho0/model_.interaction.mu);
        }
        step *= model_.Courant;
        if (contactFrequency2_ > 0)
        {
            // Half of what is stable: 2 over the frequency
            step = std::min(step, 1/std::sqrt(contactFrequency2_));
        }
        return step;
    }

    void advance(double deltaT) override
    {
        if (!(deltaT > 0) || !std::isfinite(deltaT))
        {
            refuse("time step", deltaT, "a number above 0");
        }
        const double longest = model_.shifting > 0 ? longestShift*model_.spacing : 0;
        if (isStale((maxSpeed_ + maxAcceleration_*deltaT)*deltaT + longest))
        {
            search();
        }
        if (model_.timeStepping == timeSteppingType::Verlet)
        {
            stepVerlet(deltaT);
        }
        else
        {
            stepSymplectic(deltaT);
        }
        keepInside();
        absorb(deltaT);
        integrateEnergy(deltaT);
        time_ += deltaT;
        nParticleSteps_ += nFluid_;
        checkFields();
    }

    void moveWall(std::int32_t wall, const bodyState& end) override
    {
        bodies_.at(wall).end = end;
    }

    bodyLoads wallLoads(std::int32_t wall) const override
    {
        return bodies_.at(wall).loads;
    }

    particleState<dim> state() const override
    {
        particleState<dim> s;
        s.time = time_;
        s.x.resize(x_.size());
        s.v.resize(x_.size());
        s.acceleration.resize(x_.size());
        s.density.resize(x_.size());
        s.mass.resize(x_.size());
        s.pressure.resize(x_.size());
        s.wall.resize(x_.size());
        s.energy.resize(energy_.size());
        s.heat.resize(heat_.size());
        for (std::size_t k = 0; k < x_.size(); ++k)
        {
            const std::int32_t i = original_[k];
            s.x[i] = x_[k];
            s.v[i] = v_[k];
            s.acceleration[i] = a_[k];
            s.density[i] = density_[k];
            s.mass[i] = mass_[k];
            s.pressure[i] = state_.pressure(density_[k]);
            s.wall[i] = wall_[k];
            if (model_.energy)
            {
                s.energy[i] = energy_[k];
                s.heat[i] = heat_[k];
            }
        }
        for (const auto& b : bodies_)
        {
            const Foam::vector& a = b.second.felt.acceleration;
            const Foam::vector& alpha = b.second.felt.angularAcceleration;
            s.felt.push_back({{a[0], a[1], a[2], alpha[0], alpha[1], alpha[2]}});
        }
        return s;
    }

    std::vector<vector> wallForces() override
    {
        if (model_.contact.isOn())
        {
            std::vector<vector> forces(contactLoads_.size());
            for (std::size_t w = 0; w < forces.size(); ++w)
            {
                std::copy_n(contactLoads_[w].pressure.begin(), dim, forces[w].begin());
            }
            return forces;
        }
        interaction_.sumWallForce(neighbours_, packed_, packed_.walls, nThreads_);
        const std::int32_t last = wall_.empty() ? -1 : *std::max_element(wall_.begin(), wall_.end());
        std::vector<vector> forces(last + 1, vector{});
        for (std::size_t k = 0; k < x_.size(); ++k)
        {
            if (!isFluid(k))
            {
                for (int d = 0; d < dim; ++d)
                {
                    forces[wall_[k]][d] += double(packed_.acceleration[d][place_[k]]) + packed_.friction[d][place_[k]];
                }
            }
        }
        return forces;
    }

    typename particleFlow<dim>::energies energy() const override
    {
        typename particleFlow<dim>::energies e{};
        e.contact = contactEnergy_;
        for (std::size_t k = 0; k < x_.size(); ++k)
        {
            if (isFluid(k))
            {
                for (int d = 0; d < dim; ++d)
                {
                    e.kinetic += 0.5*mass_[k]*v_[k][d]*v_[k][d];
                    e.potential -= mass_[k]*model_.interaction.g[d]*x_[k][d];
                }
                e.internal += mass_[k]*state_.energy(density_[k]);
            }
            if (model_.energy)
            {
                (isFluid(k) ? e.internalEq2 : e.wallLayers) += mass_[k]*energy_[k];
                (isFluid(k) ? e.dissipated : e.workOfWalls) += mass_[k]*heat_[k];
            }
        }
        return e;
    }

    double maxSpeed() const override
    {
        return maxSpeed_;
    }

    double nPairs() const override
    {
        return nPairs_;
    }

    double nParticleSteps() const override
    {
        return nParticleSteps_;
    }

    const char* instructions() const override
    {
        return interaction_.instructions();
    }

    std::size_t bytes() const override
    {
        return
            neighbours_.bytes()
          + neighbours_.size()*(fields::nFields + 3*dim + 2 + 2*dim*!bodies_.empty())*sizeof(Real)
          + (model_.interaction.diffusion == diffusionType::Antuono)*neighbours_.size()*dim*sizeof(Real)
          + model_.energy*(neighbours_.size()*(dim + 2)*sizeof(Real) + x_.size()*4*sizeof(double))
          + (model_.shifting > 0)*neighbours_.size()*(2*dim + 3)*sizeof(Real)
          + x_.size()*(6*sizeof(vector) + 3*sizeof(double) + 5*sizeof(std::int32_t))
          + push_.size()*(sizeof(vector) + sizeof(double))
          + xAll_.size()*sizeof(vector) + images_.size()*sizeof(mirrorImage<dim>);
    }

    long nSearches() const override
    {
        return nSearches_;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int dim>
std::unique_ptr<Foam::smoothedParticles::particleFlow<dim>> Foam::smoothedParticles::newParticleFlow
(
    const particleState<dim>& start,
    const particleFlowModel<dim>& model,
    int nThreads,
    const wallMotions& moving
)
{
    const interactionModel& m = model.interaction;
    checkPositive("spacing", model.spacing);
    checkPositive("rho0", model.rho0);
    checkPositive("Courant", model.Courant);
    checkPositive("h", m.h);
    checkPositive("c0", m.c0);
    checkNotNegative("mu", m.mu);
    checkNotNegative("alpha", m.alpha);
    checkNotNegative("beta", m.beta);
    checkNotNegative("delta", m.delta);
    checkNotNegative("acousticDamper", m.acousticDamper);
    checkNotNegative("shifting", model.shifting);
    checkNotNegative("wallTension", model.wallTension);
    checkPositive("number of threads", nThreads);
    if (!(m.gamma > 1) || !std::isfinite(m.gamma))
    {
        refuse("gamma", m.gamma, "a number above 1");
    }
    if (m.h < model.spacing || m.h > 10*model.spacing)
    {
        refuse("h", m.h/model.spacing, "1 to 10 spacings");
    }
    const std::size_t n = start.size();
    if
    (
        start.v.size() != n || start.density.size() != n || start.wall.size() != n
     || (start.energy.size() != n && !start.energy.empty()) || start.heat.size() != start.energy.size()
     || (start.mass.size() != n && !start.mass.empty()) || (start.acceleration.size() != n && !start.acceleration.empty())
    )
    {
        throw std::invalid_argument
        (
            "state of the particles: expected as many velocities, densities, walls, and masses, accelerations and energies if"
            " any, as positions"
        );
    }
    if (start.felt.size() != moving.size() && !start.felt.empty())
    {
        throw std::invalid_argument
        (
            "state of the particles: accelerations of " + std::to_string(start.felt.size()) + " walls that move: expected "
          + std::to_string(moving.size())
        );
    }
    for (const symmetryPlane& a : model.symmetry)
    {
        for (const symmetryPlane* b = &a + 1; b != model.symmetry.data() + model.symmetry.size(); ++b)
        {
            // An image has no image in the plane that it comes from
            const double least = supportRatio*m.h + skinRatio*model.spacing;
            if (a.axis == b->axis && (a.side == b->side || !(a.side*(b->at - a.at) > least)))
            {
                refuse
                (
                    "distance of two planes of symmetry across one coordinate, on either side of the particles",
                    a.side == b->side ? 0 : a.side*(b->at - a.at),
                    ("more than the reach of a particle, " + std::to_string(least)).c_str()
                );
            }
        }
    }
    for (std::size_t k = 0; k < n; ++k)
    {
        double sum = start.density[k];
        for (int d = 0; d < dim; ++d)
        {
            sum += start.x[k][d] + start.v[k][d];
        }
        if (!std::isfinite(sum))
        {
            throw std::invalid_argument
            (
                "particle " + std::to_string(k) + " starts with a position, velocity or density that is not a number"
            );
        }
    }
    if (std::count(start.wall.begin(), start.wall.end(), particleState<dim>::fluid) == 0)
    {
        throw std::invalid_argument("no particle of fluid: expected one at least");
    }

    if (model.singlePrecision)
    {
        return std::unique_ptr<particleFlow<dim>>(new flowIn<float, dim>(start, model, nThreads, moving));
    }
    return std::unique_ptr<particleFlow<dim>>(new flowIn<double, dim>(start, model, nThreads, moving));
}


template std::unique_ptr<Foam::smoothedParticles::particleFlow<2>> Foam::smoothedParticles::newParticleFlow<2>
(const particleState<2>&, const particleFlowModel<2>&, int, const wallMotions&);

template std::unique_ptr<Foam::smoothedParticles::particleFlow<3>> Foam::smoothedParticles::newParticleFlow<3>
(const particleState<3>&, const particleFlowModel<3>&, int, const wallMotions&);
