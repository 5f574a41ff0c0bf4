#include "peer_kd.h"

#include <cstdint>
#include <memory>
#include <nanoflann.hpp>

namespace
{

struct Cloud {
    const float *points;
    size_t n;

    size_t kdtree_get_point_count() const
    {
        return n;
    }
    float kdtree_get_pt(size_t i, size_t axis) const
    {
        return points[3 * i + axis];
    }
    template <class Box> bool kdtree_get_bbox(Box &) const
    {
        return false;
    }
};

using Index = nanoflann::KDTreeSingleIndexAdaptor<
    nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3, uint32_t>;

/* A result set that counts, and lists nothing. */
struct Sum {
    using DistanceType = float;
    using IndexType = uint32_t;
    float square;
    size_t count = 0;

    size_t size() const
    {
        return count;
    }
    bool full() const
    {
        return true;
    }
    bool addPoint(float, uint32_t)
    {
        ++count;
        return true;
    }
    float worstDist() const
    {
        return square;
    }
};

} // namespace

struct peer_kd {
    Cloud cloud;
    Index index;

    peer_kd(const float *points, size_t n, size_t leaf)
        : cloud{points, n},
          index(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(leaf))
    {
        index.buildIndex();
    }
};

peer_kd *peer_kd_create(const float *points, size_t n, size_t leaf)
{
    return std::make_unique<peer_kd>(points, n, leaf).release();
}

void peer_kd_destroy(peer_kd *index)
{
    delete index;
}

size_t peer_kd_within(const peer_kd *index, const float *centers, size_t n,
                      float radius)
{
    std::vector<std::pair<uint32_t, float>> found;
    nanoflann::SearchParams unsorted;
    unsorted.sorted = false;
    size_t all = 0;
    for (size_t i = 0; i < n; ++i) {
        all += index->index.radiusSearch(centers + 3 * i, radius * radius,
                                         found, unsorted);
    }
    return all;
}

size_t peer_kd_sums(const peer_kd *index, const float *centers, size_t n,
                    float radius)
{
    const nanoflann::SearchParams unsorted(0, 0, false);
    size_t all = 0;
    for (size_t i = 0; i < n; ++i) {
        Sum sum{radius * radius};
        index->index.findNeighbors(sum, centers + 3 * i, unsorted);
        all += sum.count;
    }
    return all;
}
