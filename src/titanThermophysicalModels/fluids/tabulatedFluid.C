// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluidModel.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

using namespace Foam::titan;


[[noreturn]] void refuseOutside(double T, double p, const tableLimits& limits)
{
    if (!std::isfinite(T) || !std::isfinite(p))
    {
        throw thermoError(thermoError::reason::notANumber, "temperature T or pressure p is not a number");
    }
    if (T < limits.Tmin || T > limits.Tmax)
    {
        throw thermoError
        (
            thermoError::reason::temperatureRange,
            formatted("temperature T is %.6g K: the table holds %.6g to %.6g K", T, limits.Tmin, limits.Tmax)
        );
    }
    throw thermoError
    (
        thermoError::reason::pressureRange,
        formatted("pressure p is %.6g Pa: the table holds %.6g to %.6g Pa", p, limits.pMin, limits.pMax)
    );
}


//- A division of an interval into equal parts, and Chebyshev's points of each
class division
{
    double first_;
    double width_;
    double overWidth_;
    int n_;


public:

    static constexpr int nPoints = 4;

    division(double first, double last, int n)
    :
        first_(first),
        width_((last - first)/n),
        overWidth_(last > first ? n/(last - first) : 0),
        n_(n)
    {}

    int n() const
    {
        return n_;
    }

    //- Value at s in [-1, 1] of a part
    double at(int part, double s) const
    {
        return first_ + width_*(part + 0.5*(1 + s));
    }

    //- The part that holds x, and x in [-1, 1] of it
    int find(double x, double& s) const
    {
        const double scaled = (x - first_)*overWidth_;
        const int part = std::min(static_cast<int>(scaled), n_ - 1);
        s = 2*(scaled - part) - 1;
        return part;
    }

    //- Chebyshev's points in [-1, 1]
    static double point(int k)
    {
        return std::cos(M_PI*(2*k + 1)/(2*nPoints));
    }

    //- Coefficients of 1, s, s^2, s^3 of the cubic through values at Chebyshev's points
    static void coefficients(const double* values, std::ptrdiff_t stride, double* c, std::ptrdiff_t cStride)
    {
        double a[nPoints];
        for (int j = 0; j < nPoints; ++j)
        {
            a[j] = 0;
            for (int k = 0; k < nPoints; ++k)
            {
                a[j] += values[k*stride]*std::cos(M_PI*j*(2*k + 1)/(2*nPoints));
            }
            a[j] *= (j ? 2.0 : 1.0)/nPoints;
        }
        c[0] = a[0] - a[2];
        c[cStride] = a[1] - 3*a[3];
        c[2*cStride] = 2*a[2];
        c[3*cStride] = 4*a[3];
    }
};


//- One property as a bicubic polynomial in each rectangle of a division of T and p
class propertyTable
{
    static constexpr int n = division::nPoints;

    division T_;
    division p_;
    std::vector<std::array<double, n*n>> patches_;


public:

    propertyTable(const fluidModel& source, property q, const tableLimits& limits, int nT, int np)
    :
        T_(limits.Tmin, limits.Tmax, nT),
        p_(limits.pMin, limits.pMax, np),
        patches_(nT*np)
    {
        for (int i = 0; i < nT; ++i)
        {
            for (int j = 0; j < np; ++j)
            {
                double values[n*n], rows[n*n];
                for (int a = 0; a < n; ++a)
                {
                    double T[n], p[n];
                    for (int b = 0; b < n; ++b)
                    {
                        T[b] = T_.at(i, division::point(a));
                        p[b] = p_.at(j, division::point(b));
                    }
                    source.evaluate(q, n, T, p, values + n*a);
                    division::coefficients(values + n*a, 1, rows + n*a, 1);
                }
                for (int b = 0; b < n; ++b)
                {
                    division::coefficients(rows + b, n, patches_[i*np + j].data() + b, n);
                }
            }
        }
    }

    double operator()(double T, double p) const
    {
        double s, t;
        const int i = T_.find(T, s);
        const int j = p_.find(p, t);
        const double* c = patches_[i*p_.n() + j].data();
        double value = 0;
        for (int a = n - 1; a >= 0; --a)
        {
            const double* r = c + n*a;
            value = value*s + (r[0] + t*(r[1] + t*(r[2] + t*r[3])));
        }
        return value;
    }

    //- Largest relative difference from the source, seen at the points where a cubic through Chebyshev's points is
    //  furthest off, in T, in p, and in both
    struct difference
    {
        double T = 0, p = 0, both = 0;
    };

    difference largest(const fluidModel& source, property q) const
    {
        // The ends of the interval and the extrema between the points
        static const double extrema[] = {-1, -M_SQRT1_2, 0, M_SQRT1_2, 1};

        difference result;
        auto compare = [&](int i, double s, int j, double t, double& worst)
        {
            const double T = T_.at(i, s);
            const double p = p_.at(j, t);
            const double exact = source.value(q, T, p);
            worst = std::max(worst, std::abs((*this)(T, p)/exact - 1));
        };
        for (int i = 0; i < T_.n(); ++i)
        {
            for (int j = 0; j < p_.n(); ++j)
            {
                for (const double s : extrema)
                {
                    // Away from the edges of the patch, at which another patch may answer
                    const double a = 0.999*s;
                    compare(i, a, j, division::point(1), result.T);
                    compare(i, division::point(1), j, a, result.p);
                    for (const double t : extrema)
                    {
                        compare(i, a, j, 0.999*t, result.both);
                    }
                }
            }
        }
        return result;
    }
};


class tabulatedFluidModel
:
    public fluidModel
{
    const std::unique_ptr<fluidModel> direct_;
    const tableLimits limits_;
    std::array<std::unique_ptr<propertyTable>, nProperties> tables_;

    void makeTable(property q)
    {
        // The extrema are where the error is largest but for its higher orders
        constexpr double margin = 0.5;
        constexpr int maxPatches = 1 << 14;

        int nT = 1;
        int np = 1;
        while (true)
        {
            std::unique_ptr<propertyTable> table(new propertyTable(*direct_, q, limits_, nT, np));
            const propertyTable::difference error = table->largest(*direct_, q);
            if (error.both <= margin*limits_.relativeError)
            {
                tables_[static_cast<int>(q)] = std::move(table);
                return;
            }
            if (nT*np >= maxPatches || !std::isfinite(error.both))
            {
                throw thermoError
                (
                    thermoError::reason::badEntry,
                    std::string("a table of ") + propertyName(q)
                  + formatted(" differs by %.3g from the equations: expected %.3g; take a smaller range", error.both,
                        limits_.relativeError, 0)
                );
            }
            (error.T >= error.p ? nT : np) *= 2;
        }
    }


public:

    tabulatedFluidModel
    (
        const composition& x,
        phase ph,
        const tableLimits& limits,
        const std::vector<property>& tabulated
    )
    :
        direct_(directFluid(x, ph)),
        limits_(limits)
    {
        range::check(limits.Tmin, limits.pMin);
        range::check(limits.Tmax, limits.pMax);
        if (!(limits.Tmin < limits.Tmax) || !(limits.pMin < limits.pMax))
        {
            throw thermoError
            (
                thermoError::reason::badEntry,
                "limits of the table: expected Tmin below Tmax and pMin below pMax"
            );
        }
        if (!(limits.relativeError >= 1e-10 && limits.relativeError < 1))
        {
            throw thermoError
            (
                thermoError::reason::badEntry,
                formatted("relative error of the table is %.3g: expected %.3g to %.3g", limits.relativeError, 1e-10, 1)
            );
        }
        // A phase that ends within the table ends at a corner of it: no polynomial may bridge that
        for (const double T : {limits.Tmin, limits.Tmax})
        {
            for (const double p : {limits.pMin, limits.pMax})
            {
                direct_->value(property::density, T, p);
            }
        }
        for (const property q : tabulated)
        {
            makeTable(q);
        }
    }

    const char* type() const override
    {
        return "tabulated";
    }

    void evaluate(property q, std::size_t n, const double* T, const double* p, double* values) const override
    {
        const propertyTable* table = tables_[static_cast<int>(q)].get();
        if (!table)
        {
            throw thermoError
            (
                thermoError::reason::badEntry,
                std::string("there is no table of ") + propertyName(q)
            );
        }
        for (std::size_t i = 0; i < n; ++i)
        {
            if (!(T[i] >= limits_.Tmin && T[i] <= limits_.Tmax && p[i] >= limits_.pMin && p[i] <= limits_.pMax))
            {
                refuseOutside(T[i], p[i], limits_);
            }
            values[i] = (*table)(T[i], p[i]);
        }
    }

    fluidProperties properties(double T, double p) const override
    {
        if (!(T >= limits_.Tmin && T <= limits_.Tmax && p >= limits_.pMin && p <= limits_.pMax))
        {
            refuseOutside(T, p, limits_);
        }
        return direct_->properties(T, p);
    }
};

} // End anonymous namespace


std::unique_ptr<Foam::titan::fluidModel> Foam::titan::tabulatedFluid
(
    const composition& x,
    phase ph,
    const tableLimits& limits,
    const std::vector<property>& tabulated
)
{
    return std::unique_ptr<fluidModel>(new tabulatedFluidModel(x, ph, limits, tabulated));
}
