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


template<int dim>
void Foam::smoothedParticles::clusterNeighbours<dim>::sortColumn(const std::vector<position>& x, std::int32_t column)
{
    constexpr int last = dim - 1;
    const std::int64_t end = starts_[column + 1];
    std::sort
    (
        sorted_.begin() + starts_[column], sorted_.begin() + end,
        [&](std::int32_t a, std::int32_t b)
        {
            return x[a][last] < x[b][last] || (x[a][last] == x[b][last] && a < b);
        }
    );
    std::int64_t from = starts_[column];
    for (std::int64_t cluster = firstCluster_[column]; cluster < firstCluster_[column + 1]; ++cluster)
    {
        box& b = boxes_[cluster];
        b.low.fill(std::numeric_limits<double>::max());
        b.high.fill(std::numeric_limits<double>::lowest());
        for (int lane = 0; lane < clusterSize; ++lane, ++from)
        {
            const std::int32_t i = from < end ? sorted_[from] : -1;
            order_[cluster*clusterSize + lane] = i;
            for (int d = 0; i >= 0 && d < dim; ++d)
            {
                b.low[d] = std::min(b.low[d], x[i][d]);
                b.high[d] = std::max(b.high[d], x[i][d]);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int dim>
void Foam::smoothedParticles::clusterNeighbours<dim>::sort(const std::vector<position>& x, double spacing, int nThreads)
{
    constexpr int last = dim - 1;
    const std::int64_t n = x.size();

    // As wide as a cluster is high
    columnWidth_ = spacing*std::pow(clusterSize, 1.0/dim);

    double low[dim], high[dim];
    std::fill_n(low, dim, std::numeric_limits<double>::max());
    std::fill_n(high, dim, std::numeric_limits<double>::lowest());
    #pragma omp parallel for num_threads(nThreads) schedule(static) reduction(min: low) reduction(max: high)
    for (std::int64_t i = 0; i < n; ++i)
    {
        for (int d = 0; d < dim; ++d)
        {
            low[d] = std::min(low[d], x[i][d]);
            high[d] = std::max(high[d], x[i][d]);
        }
    }
    std::copy_n(low, dim, origin_.begin());
    std::copy_n(high, dim, end_.begin());
    std::int64_t columns = 1;
    for (int d = 0; d < last; ++d)
    {
        nColumns_[d] = n ? 1 + static_cast<int>((high[d] - low[d])/columnWidth_) : 1;
        columns *= nColumns_[d];
    }

    // By column, counting: each thread a share of the particles, whose places in a column follow those of the share before
    columnOf_.resize(n);
    counts_.assign(nThreads*columns, 0);
    #pragma omp parallel for num_threads(nThreads) schedule(static, 1)
    for (int thread = 0; thread < nThreads; ++thread)
    {
        std::int64_t* count = counts_.data() + thread*columns;
        for (std::int64_t i = n*thread/nThreads; i < n*(thread + 1)/nThreads; ++i)
        {
            std::int64_t key = 0;
            for (int d = 0; d < last; ++d)
            {
                key = key*nColumns_[d] + column(x[i][d], d);
            }
            columnOf_[i] = key;
            ++count[key];
        }
    }
    firstCluster_.resize(columns + 1);
    starts_.resize(columns + 1);
    firstCluster_[0] = 0;
    starts_[0] = 0;
    for (std::int64_t c = 0; c < columns; ++c)
    {
        std::int64_t next = starts_[c];
        for (int thread = 0; thread < nThreads; ++thread)
        {
            std::int64_t& count = counts_[thread*columns + c];
            const std::int64_t first = next;
            next += count;
            count = first;
        }
        starts_[c + 1] = next;
        firstCluster_[c + 1] = firstCluster_[c] + (next - starts_[c] + clusterSize - 1)/clusterSize;
    }
    sorted_.resize(n);
    #pragma omp parallel for num_threads(nThreads) schedule(static, 1)
    for (int thread = 0; thread < nThreads; ++thread)
    {
        std::int64_t* next = counts_.data() + thread*columns;
        for (std::int64_t i = n*thread/nThreads; i < n*(thread + 1)/nThreads; ++i)
        {
            sorted_[next[columnOf_[i]]++] = i;
        }
    }

    boxes_.resize(firstCluster_[columns]);
    order_.resize(boxes_.size()*clusterSize);
    #pragma omp parallel for num_threads(nThreads) schedule(dynamic, 8)
    for (std::int64_t c = 0; c < columns; ++c)
    {
        sortColumn(x, c);
    }
}


template<int dim>
typename Foam::smoothedParticles::clusterNeighbours<dim>::position
Foam::smoothedParticles::clusterNeighbours<dim>::middle() const
{
    position result;
    for (int d = 0; d < dim; ++d)
    {
        result[d] = 0.5*(origin_[d] + end_[d]);
    }
    return result;
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

    passive_.resize(nClusters);
    #pragma omp parallel for num_threads(nThreads) schedule(static)
    for (std::int64_t cluster = 0; cluster < nClusters; ++cluster)
    {
        const std::int32_t* in = order_.data() + cluster*clusterSize;
        passive_[cluster] = std::all_of(in, in + clusterSize, [&](std::int32_t i){return i < 0 || passive[i];});
    }

    // Shares of the clusters, which the result does not depend on; some have more to search than others
    const int nShares = nThreads > 1 ? 8*nThreads : 1;
    candidates_.resize(nShares);
    found_.resize(nShares);
    starts_.resize(order_.size() + 1);
    starts_[0] = 0;

    #pragma omp parallel for num_threads(nThreads) schedule(dynamic, 1)
    for (int share = 0; share < nShares; ++share)
    {
        std::vector<std::int32_t>& found = found_[share];
        found.clear();
        std::vector<std::int32_t>& candidates = candidates_[share];

        const std::int64_t end = nClusters*(share + 1)/nShares;
        for (std::int64_t cluster = nClusters*share/nShares; cluster < end; ++cluster)
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
    #pragma omp parallel for num_threads(nThreads) schedule(dynamic, 1)
    for (int share = 0; share < nShares; ++share)
    {
        const std::int64_t first = nClusters*share/nShares*clusterSize;
        std::copy(found_[share].begin(), found_[share].end(), clusters_.begin() + starts_[first]);
    }
}


template<int dim>
std::size_t Foam::smoothedParticles::clusterNeighbours<dim>::bytes() const
{
    std::size_t result =
        (order_.capacity() + clusters_.capacity() + firstCluster_.capacity() + sorted_.capacity() + columnOf_.capacity())
       *sizeof(std::int32_t)
      + (starts_.capacity() + counts_.capacity())*sizeof(std::int64_t)
      + boxes_.capacity()*sizeof(box) + passive_.capacity();
    for (const auto& found : found_)
    {
        result += found.capacity()*sizeof(std::int32_t);
    }
    return result;
}


template class Foam::smoothedParticles::clusterNeighbours<2>;
template class Foam::smoothedParticles::clusterNeighbours<3>;
