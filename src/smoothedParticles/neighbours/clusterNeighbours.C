// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusterNeighbours.H"

#include <algorithm>
#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

template<class Position>
double square(double low, double high, const Position& x, int d)
{
    const double gap = std::max(0.0, std::max(low - x[d], x[d] - high));
    return gap*gap;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<int dim>
int Foam::smoothedParticles::clusterNeighbours<dim>::column(double x, int d) const
{
    const int c = static_cast<int>((x - origin_[d])/columnWidth_);
    return std::min(std::max(c, 0), nColumns_[d] - 1);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int dim>
void Foam::smoothedParticles::clusterNeighbours<dim>::sort(const std::vector<position>& x, double spacing)
{
    constexpr int last = dim - 1;
    const std::size_t n = x.size();

    // As wide as a cluster is high
    columnWidth_ = spacing*std::pow(clusterSize, 1.0/dim);

    position high;
    origin_.fill(std::numeric_limits<double>::max());
    high.fill(std::numeric_limits<double>::lowest());
    for (const position& xi : x)
    {
        for (int d = 0; d < dim; ++d)
        {
            origin_[d] = std::min(origin_[d], xi[d]);
            high[d] = std::max(high[d], xi[d]);
        }
    }
    std::size_t columns = 1;
    for (int d = 0; d < last; ++d)
    {
        nColumns_[d] = n ? 1 + static_cast<int>((high[d] - origin_[d])/columnWidth_) : 1;
        columns *= nColumns_[d];
    }

    // By column, counting; then each column by the last coordinate
    keys_.resize(n);
    firstCluster_.assign(columns + 1, 0);
    for (std::size_t i = 0; i < n; ++i)
    {
        std::int64_t key = 0;
        for (int d = 0; d < last; ++d)
        {
            key = key*nColumns_[d] + column(x[i][d], d);
        }
        keys_[i] = key;
        ++firstCluster_[key + 1];
    }
    std::size_t first = 0;
    std::size_t place = 0;
    std::vector<std::int32_t>& counts = firstCluster_;
    sorted_.resize(n);
    starts_.resize(columns + 1);
    starts_[0] = 0;
    for (std::size_t c = 0; c < columns; ++c)
    {
        starts_[c + 1] = starts_[c] + counts[c + 1];
    }
    for (std::size_t i = 0; i < n; ++i)
    {
        sorted_[starts_[keys_[i]]++] = i;
    }

    order_.clear();
    boxes_.clear();
    firstCluster_[0] = 0;
    for (std::size_t c = 0; c < columns; ++c)
    {
        const std::size_t end = starts_[c];
        std::sort
        (
            sorted_.begin() + first, sorted_.begin() + end,
            [&](std::int32_t a, std::int32_t b)
            {
                return x[a][last] < x[b][last] || (x[a][last] == x[b][last] && a < b);
            }
        );
        for (; first < end; first += std::min<std::size_t>(clusterSize, end - first))
        {
            box b;
            b.low.fill(std::numeric_limits<double>::max());
            b.high.fill(std::numeric_limits<double>::lowest());
            for (place = 0; place < clusterSize; ++place)
            {
                if (first + place >= end)
                {
                    order_.push_back(-1);
                    continue;
                }
                const std::int32_t i = sorted_[first + place];
                order_.push_back(i);
                for (int d = 0; d < dim; ++d)
                {
                    b.low[d] = std::min(b.low[d], x[i][d]);
                    b.high[d] = std::max(b.high[d], x[i][d]);
                }
            }
            boxes_.push_back(b);
        }
        firstCluster_[c + 1] = boxes_.size();
    }
}


template<int dim>
void Foam::smoothedParticles::clusterNeighbours<dim>::renumber(std::int32_t n)
{
    std::int32_t first = 0;
    std::int32_t second = n;
    for (std::int32_t& k : order_)
    {
        if (k >= 0)
        {
            k = k < n ? first++ : second++;
        }
    }
}


template<int dim>
void Foam::smoothedParticles::clusterNeighbours<dim>::search
(
    const std::vector<position>& x,
    const std::vector<unsigned char>& passive,
    const std::vector<unsigned char>& silent,
    double radius,
    int nThreads
)
{
    constexpr int last = dim - 1;
    const std::int64_t nClusters = boxes_.size();
    const double radius2 = radius*radius;

    passive_.assign(nClusters, true);
    for (std::size_t i = 0; i < order_.size(); ++i)
    {
        if (order_[i] >= 0 && !passive[order_[i]])
        {
            passive_[i/clusterSize] = false;
        }
    }

    candidates_.resize(nThreads);
    found_.resize(nThreads);
    starts_.assign(order_.size() + 1, 0);

    // Each thread its own share of the clusters, so that the result does not depend on their number
    #pragma omp parallel for num_threads(nThreads) schedule(static, 1)
    for (int thread = 0; thread < nThreads; ++thread)
    {
        std::vector<std::int32_t>& found = found_[thread];
        found.clear();
        std::vector<std::int32_t>& candidates = candidates_[thread];

        const std::int64_t end = nClusters*(thread + 1)/nThreads;
        for (std::int64_t cluster = nClusters*thread/nThreads; cluster < end; ++cluster)
        {
            const box& own = boxes_[cluster];

            // Columns within the radius, and in each those clusters that are near enough in the last coordinate
            candidates.clear();
            int low[dim - 1], high[dim - 1], at[dim - 1];
            for (int d = 0; d < last; ++d)
            {
                low[d] = at[d] = column(own.low[d] - radius, d);
                high[d] = column(own.high[d] + radius, d);
            }
            for (bool more = true; more; )
            {
                std::int64_t key = 0;
                for (int d = 0; d < last; ++d)
                {
                    key = key*nColumns_[d] + at[d];
                }
                auto other = std::lower_bound
                (
                    boxes_.begin() + firstCluster_[key], boxes_.begin() + firstCluster_[key + 1],
                    own.low[last] - radius,
                    [](const box& b, double value){return b.high[last] < value;}
                );
                for
                (
                    ;
                    other != boxes_.begin() + firstCluster_[key + 1] && other->low[last] <= own.high[last] + radius;
                    ++other
                )
                {
                    double distance2 = 0;
                    for (int d = 0; d < dim; ++d)
                    {
                        const double gap = std::max(0.0, std::max(own.low[d] - other->high[d], other->low[d] - own.high[d]));
                        distance2 += gap*gap;
                    }
                    if (distance2 < radius2)
                    {
                        candidates.push_back(other - boxes_.begin());
                    }
                }
                more = false;
                for (int d = last - 1; d >= 0 && !more; --d)
                {
                    more = ++at[d] <= high[d];
                    if (!more)
                    {
                        at[d] = low[d];
                    }
                }
            }

            for (int lane = 0; lane < clusterSize; ++lane)
            {
                const std::size_t place = cluster*clusterSize + lane;
                const std::size_t before = found.size();
                if (order_[place] >= 0 && !silent[order_[place]])
                {
                    const position& xi = x[order_[place]];
                    const bool isPassive = passive[order_[place]];
                    for (const std::int32_t c : candidates)
                    {
                        if (isPassive && passive_[c])
                        {
                            continue;
                        }
                        double distance2 = 0;
                        for (int d = 0; d < dim; ++d)
                        {
                            distance2 += square(boxes_[c].low[d], boxes_[c].high[d], xi, d);
                        }
                        if (distance2 < radius2)
                        {
                            found.push_back(c);
                        }
                    }
                }
                starts_[place + 1] = found.size() - before;
            }
        }
    }

    for (std::size_t i = 0; i < order_.size(); ++i)
    {
        starts_[i + 1] += starts_[i];
    }
    clusters_.resize(starts_.back());
    #pragma omp parallel for num_threads(nThreads) schedule(static, 1)
    for (int thread = 0; thread < nThreads; ++thread)
    {
        const std::int64_t first = nClusters*thread/nThreads*clusterSize;
        std::copy(found_[thread].begin(), found_[thread].end(), clusters_.begin() + starts_[first]);
    }
}


template<int dim>
std::size_t Foam::smoothedParticles::clusterNeighbours<dim>::bytes() const
{
    std::size_t result =
        (order_.capacity() + clusters_.capacity() + firstCluster_.capacity() + sorted_.capacity())*sizeof(std::int32_t)
      + (starts_.capacity() + keys_.capacity())*sizeof(std::int64_t)
      + boxes_.capacity()*sizeof(box) + passive_.capacity();
    for (const auto& found : found_)
    {
        result += found.capacity()*sizeof(std::int32_t);
    }
    return result;
}


template class Foam::smoothedParticles::clusterNeighbours<2>;
template class Foam::smoothedParticles::clusterNeighbours<3>;
