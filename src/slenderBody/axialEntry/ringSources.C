// SPDX-License-Identifier: GPL-3.0-or-later
// The potential flow about a body of revolution that moves along its axis, by ring sources.

#include "axialEntry.H"

#include "mathematicalConstants.H"

#include <array>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using constant::mathematical::pi;

//- Complete elliptic integrals of the first and second kind, by the arithmetic-geometric mean (Abramowitz and Stegun 17.6);
//  k1 = 1 - k^2
void ellipticIntegrals(const scalar k1, scalar& K, scalar& E)
{
    scalar a = 1, b = std::sqrt(k1), sum = 0.5*(1 - k1), power = 0.5;
    for (int i = 0; i < 12; ++i)
    {
        const scalar c = 0.5*(a - b);
        const scalar next = 0.5*(a + b);
        b = std::sqrt(a*b);
        a = next;
        power *= 2;
        sum += power*c*c;
        if (c < 1e-12*a)
        {
            break;
        }
    }
    K = pi/(2*a);
    E = K*(1 - sum);
}


struct effect
{
    scalar phi, x, r;   //!< potential and velocity
};

//- Of a ring source of unit strength for each metre, of radius R at X
effect ringSource(const scalar X, const scalar R, const scalar x, const scalar r)
{
    const scalar dx = x - X;
    const scalar sum2 = sqr(r + R) + dx*dx;
    const scalar difference2 = sqr(r - R) + dx*dx;
    scalar K, E;
    ellipticIntegrals(difference2/sum2, K, E);
    const scalar factor = R/(pi*std::sqrt(sum2));
    return {-factor*K, factor*dx*E/difference2, factor*((K - E)/(2*r) + E*(r - R)/difference2)};
}


//- Gauss's points of a panel that lies so far away, in panel lengths: four for each of so many parts
int parts(const scalar distance)
{
    return distance < 0.6 ? 8 : distance < 2 ? 3 : 1;
}

constexpr std::array<scalar, 4> gaussPoints{{0.069431844202974, 0.330009478207572, 0.669990521792428, 0.930568155797026}};
constexpr std::array<scalar, 4> gaussWeights{{0.173927422568727, 0.326072577431273, 0.326072577431273, 0.173927422568727}};


//- Solve A x = b by elimination with pivots
void solveLinear(std::vector<std::vector<scalar>>& A, std::vector<scalar>& b)
{
    const std::size_t n = b.size();
    for (std::size_t k = 0; k < n; ++k)
    {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i)
        {
            pivot = std::abs(A[i][k]) > std::abs(A[pivot][k]) ? i : pivot;
        }
        std::swap(A[k], A[pivot]);
        std::swap(b[k], b[pivot]);
        for (std::size_t i = k + 1; i < n; ++i)
        {
            const scalar factor = A[i][k]/A[k][k];
            for (std::size_t j = k + 1; j < n; ++j)
            {
                A[i][j] -= factor*A[k][j];
            }
            b[i] -= factor*b[k];
        }
    }
    for (std::size_t k = n; k-- > 0;)
    {
        for (std::size_t j = k + 1; j < n; ++j)
        {
            b[k] -= A[k][j]*b[j];
        }
        b[k] /= A[k][k];
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::slenderBody::axialEntry::flow Foam::slenderBody::axialEntry::solve
(
    const meridian& body,
    const scalar plane,
    const int nPanels
)
{
    const bool image = plane < GREAT;
    const scalar end = body.arcOf(plane);
    const bool cut = plane < body.length();

    // Panels are finer towards the ends of smooth pieces; those of the last wetted one grow with it
    flow f;
    std::vector<scalar> nodes{0};
    f.pieces = {0};
    for (std::size_t piece = 0; piece + 1 < body.corners().size() && body.corners()[piece] < end*(1 - 1e-12); ++piece)
    {
        const scalar low = body.corners()[piece];
        const bool last = body.corners()[piece + 1] >= end*(1 - 1e-12);
        const scalar high = last ? end : body.corners()[piece + 1];
        // Of the whole piece, so that their number does not change with the wetted length by chance
        const int n = max(8, int(nPanels*(high - low)/end + 0.5));
        for (int k = 1; k <= n; ++k)
        {
            const scalar share = 0.5*(1 - std::cos(pi*k/n));
            nodes.push_back(low + share*(high - low));
            f.s.push_back(0.5*(nodes[nodes.size() - 2] + nodes.back()));
            f.length.push_back(nodes.back() - nodes[nodes.size() - 2]);
            f.stretch.push_back(last && cut ? (f.s.back() - low)/(high - low) : 0);
        }
        f.pieces.push_back(f.s.size());
        if (last)
        {
            break;
        }
    }

    const std::size_t n = f.s.size();
    for (std::size_t i = 0; i < n; ++i)
    {
        f.middle.push_back(body.at(f.s[i]));
    }

    std::vector<std::vector<scalar>> velocity(n, std::vector<scalar>(n, 0)), potential(velocity);
    std::vector<scalar> strength(n);
    for (std::size_t j = 0; j < n; ++j)
    {
        const meridian::place& source = f.middle[j];
        for (const bool mirrored : {false, true})
        {
            if (mirrored && !image)
            {
                break;
            }
            std::array<std::vector<meridian::place>, 9> points;
            for (std::size_t i = 0; i < n; ++i)
            {
                const meridian::place& p = f.middle[i];
                const scalar x = mirrored ? 2*plane - source.x : source.x;
                const int nParts = parts(std::hypot(p.x - x, p.r - source.r)/f.length[j]);
                auto& on = points[nParts];
                if (on.empty())
                {
                    for (int part = 0; part < nParts; ++part)
                    {
                        for (const scalar g : gaussPoints)
                        {
                            on.push_back(body.at(nodes[j] + f.length[j]*(part + g)/nParts));
                        }
                    }
                }
                const scalar sign = mirrored ? -1 : 1;
                for (std::size_t q = 0; q < on.size(); ++q)
                {
                    const scalar weight = sign*f.length[j]*gaussWeights[q % 4]/nParts;
                    const effect of(ringSource(mirrored ? 2*plane - on[q].x : on[q].x, on[q].r, p.x, p.r));
                    potential[i][j] += weight*of.phi;
                    velocity[i][j] += weight*(of.r*p.tx - of.x*p.tr);
                }
            }
        }
        velocity[j][j] += 0.5;
        // The normal is (-tr, tx), and the body moves towards -x
        strength[j] = source.tr;
    }
    solveLinear(velocity, strength);

    f.phi.assign(n, 0);
    for (std::size_t i = 0; i < n; ++i)
    {
        for (std::size_t j = 0; j < n; ++j)
        {
            f.phi[i] += potential[i][j]*strength[j];
        }
    }
    return f;
}


Foam::scalar Foam::slenderBody::axialEntry::mass(const flow& f)
{
    scalar sum = 0;
    for (std::size_t i = 0; i < f.phi.size(); ++i)
    {
        sum -= f.phi[i]*f.middle[i].tr*2*pi*f.middle[i].r*f.length[i];
    }
    return sum;
}

// ************************************************************************* //
