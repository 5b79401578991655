// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Application
    titanSpeed

Description
    Times the evaluations of titanThermophysicalModels on this machine and
    compares the faster with the most accurate. Prints a .csv table: evaluation,
    microseconds (the least of several repeats), largest relative error against
    the direct model, what a table takes to make.

Usage
    titanSpeed
\*---------------------------------------------------------------------------*/

#include "fluidModel.H"
#include "phaseEquilibrium.H"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

using namespace Foam::titan;

namespace
{

// Of a lake: 2000 states near the surface, as the cells of a field would have them
constexpr int nStates = 2000;
constexpr int nRepeats = 9;

const composition ternary(0.05, 0.25, 0.70);
const composition quaternary(0.05, 0.25, 0.65, 0.05);
const tableLimits limits{90, 98, 1e5, 2e6, 0};


struct states
{
    std::vector<double> T, p;

    //- In order, as from one cell to the next, or scattered over the range
    explicit states(bool scattered)
    {
        for (int i = 0; i < nStates; ++i)
        {
            const double s = scattered ? std::fmod(i*0.6180339887498949, 1.0) : (i + 0.5)/nStates;
            const double t = scattered ? std::fmod(i*0.7548776662466927, 1.0) : s;
            T.push_back(limits.Tmin + s*(limits.Tmax - limits.Tmin));
            p.push_back(limits.pMin + t*(limits.pMax - limits.pMin));
        }
    }
};


//- Time of one of n evaluations [us]; the sum keeps the compiler from leaving them out
template<class Function>
double microseconds(int n, double& sum, const Function& evaluateAll)
{
    double least = 1e300;
    for (int k = 0; k < nRepeats; ++k)
    {
        const auto start = std::chrono::steady_clock::now();
        sum += evaluateAll();
        const auto end = std::chrono::steady_clock::now();
        least = std::min(least, std::chrono::duration<double, std::micro>(end - start).count()/n);
    }
    return least;
}


void report(const char* name, double us, double error = 0, double madeIn = 0)
{
    std::printf("\"%s\",%.4g,%.3g,%.3g\n", name, us, error, madeIn);
}

} // End anonymous namespace


int main(int argc, char*[])
{
    if (argc > 1)
    {
        std::fprintf(stderr, "Usage: titanSpeed\nTimes the evaluations of titanThermophysicalModels; takes a minute.\n");
        return 2;
    }

    const states ordered(false);
    const states scattered(true);
    double sum = 0;

    std::printf("evaluation,time_us,relative_error,made_in_s\n");

    for (const composition* x : {&ternary, &quaternary})
    {
        const helmholtzMixture mixture(*x);
        const char* const name = x == &ternary ? "ternary" : "quaternary";
        auto cold = [&]
        {
            double s = 0;
            for (int i = 0; i < nStates; ++i)
            {
                s += mixture.state(scattered.T[i], scattered.p[i], phase::liquid).soundSpeed;
            }
            return s;
        };
        auto warm = [&]
        {
            double s = 0;
            double guess = 0;
            for (int i = 0; i < nStates; ++i)
            {
                const fluidState state = mixture.state(ordered.T[i], ordered.p[i], phase::liquid, guess);
                guess = state.molarDensity;
                s += state.soundSpeed;
            }
            return s;
        };
        report((std::string("density and properties, cold start, ") + name).c_str(), microseconds(nStates, sum, cold));
        report((std::string("density and properties, warm start, ") + name).c_str(), microseconds(nStates, sum, warm));
    }

    {
        const helmholtzMixture mixture(ternary);
        const helmholtzMixture::isotherm isotherm(mixture, 94);
        report
        (
            "density at one temperature, warm start, ternary",
            microseconds
            (
                nStates, sum,
                [&]
                {
                    double guess = 0;
                    double s = 0;
                    for (const double p : ordered.p)
                    {
                        s += guess = isotherm.molarDensity(p, phase::liquid, guess);
                    }
                    return s;
                }
            )
        );
    }

    // A field of one property, by the interface that solvers use
    auto field = [&](const fluidModel& model, property q, const states& at)
    {
        std::vector<double> values(nStates);
        return microseconds
        (
            nStates, sum,
            [&]
            {
                model.evaluate(q, nStates, at.T.data(), at.p.data(), values.data());
                return values[nStates/2];
            }
        );
    };
    const std::unique_ptr<fluidModel> direct = directFluid(ternary, phase::liquid);
    report("direct, field of density", field(*direct, property::density, ordered));
    report("direct, field of viscosity", field(*direct, property::viscosity, ordered));

    for (const double relativeError : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8})
    {
        tableLimits wanted = limits;
        wanted.relativeError = relativeError;
        const auto start = std::chrono::steady_clock::now();
        const std::unique_ptr<fluidModel> table =
            tabulatedFluid(ternary, phase::liquid, wanted, {property::density, property::viscosity});
        const double madeIn = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

        for (const property q : {property::density, property::viscosity})
        {
            std::vector<double> exact(nStates), values(nStates);
            direct->evaluate(q, nStates, scattered.T.data(), scattered.p.data(), exact.data());
            table->evaluate(q, nStates, scattered.T.data(), scattered.p.data(), values.data());
            double error = 0;
            for (int i = 0; i < nStates; ++i)
            {
                error = std::max(error, std::abs(values[i]/exact[i] - 1));
            }
            char name[128];
            std::snprintf
            (
                name, sizeof name, "table for an error of %.0e, field of %s", relativeError, propertyName(q)
            );
            report(name, field(*table, q, scattered), error, madeIn);
        }
    }

    {
        const std::unique_ptr<fluidModel> constant = constantFluid(direct->properties(94, 1.467e5));
        for (const property q : {property::density, property::viscosity})
        {
            double error = 0;
            for (int i = 0; i < nStates; ++i)
            {
                error = std::max
                (
                    error, std::abs(constant->value(q, 0, 0)/direct->value(q, scattered.T[i], scattered.p[i]) - 1)
                );
            }
            report
            (
                (std::string("constant, field of ") + propertyName(q)).c_str(), field(*constant, q, scattered), error
            );
        }
    }

    constexpr int nEquilibria = 200;
    auto equilibria = [&](const auto& one)
    {
        return microseconds
        (
            nEquilibria, sum,
            [&]
            {
                double s = 0;
                for (int i = 0; i < nEquilibria; ++i)
                {
                    s += one(scattered.T[i]);
                }
                return s;
            }
        );
    };
    report("bubble point, ternary", equilibria([](double T){return bubblePoint(ternary, T).p;}));
    report("bubble point, quaternary", equilibria([](double T){return bubblePoint(quaternary, T).p;}));
    report
    (
        "dissolved nitrogen",
        equilibria([](double T){return saturateWithNitrogen(0.25, 0.75, 0, T, 1.467e5).liquid[N2];})
    );

    return std::isfinite(sum) ? 0 : 1;
}
