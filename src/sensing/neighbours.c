/* Finds the k nearest photons of the same band and side, and of other emitted
 * photons, by queries of the kd-tree for 2 k, 4 k, .. nearest photons, until k
 * of them are of that kind, or until the maximum radius or 32 k photons are
 * reached. In a periodic domain nine images of the place are queried and the
 * results merged. */
#include "sensing/neighbours.h"

#include "base/sort.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

/* Photons queried, as multiples of k: at first, and at most. The maximum bounds
 * the work if many photons of other bands or sides lie near. */
#define FIRST_QUERY 2
#define LAST_QUERY  32

typedef struct near_one {
    double distance2_m2;
    uint32_t number;
} near_one;

struct murk_neighbours_workspace {
    uint32_t *found;
    double *distance2_m2;
    near_one *nearest; /* photons of the nine images */
};

murk_neighbours_workspace *murk_neighbours_workspace_create(size_t k)
{
    const size_t capacity = LAST_QUERY * k;
    murk_neighbours_workspace *workspace = calloc(1, sizeof *workspace);
    if (!workspace) {
        return NULL;
    }
    workspace->found = calloc(capacity, sizeof *workspace->found);
    workspace->distance2_m2 = calloc(capacity, sizeof *workspace->distance2_m2);
    workspace->nearest = calloc(9 * capacity, sizeof *workspace->nearest);
    if (!workspace->found || !workspace->distance2_m2 || !workspace->nearest) {
        murk_neighbours_workspace_destroy(workspace);
        return NULL;
    }
    return workspace;
}

void murk_neighbours_workspace_destroy(murk_neighbours_workspace *workspace)
{
    if (workspace) {
        free(workspace->found);
        free(workspace->distance2_m2);
        free(workspace->nearest);
        free(workspace);
    }
}

static int by_distance(const void *a, const void *b)
{
    const near_one *x = a, *y = b;
    const int farther = MURK_ORDER(x->distance2_m2, y->distance2_m2);
    return farther ? farther : MURK_ORDER(x->number, y->number);
}

/* The m nearest photons over all images of the place. A photon beyond half a
 * period may occur twice. */
static size_t nearest_of_images(const murk_neighbours *neighbours,
                                murk_neighbours_workspace *workspace,
                                murk_vec3 place, size_t m)
{
    const int images = murk_domain_images(neighbours->domain);
    size_t all = 0;
    for (int image = 0; image < images; ++image) {
        const murk_vec3 center =
            murk_domain_image(neighbours->domain, place, image);
        /* The nearest photons of this image. */
        const size_t n =
            murk_photon_map_nearest(neighbours->map, center, m,
                                    workspace->found, workspace->distance2_m2);
        for (size_t k = 0; k < n; ++k) {
            workspace->nearest[all++] =
                (near_one){workspace->distance2_m2[k], workspace->found[k]};
        }
    }
    /* Merge the images by distance. */
    if (images > 1) {
        qsort(workspace->nearest, all, sizeof *workspace->nearest, by_distance);
    }
    return all < m ? all : m;
}

bool murk_neighbours_alike(const murk_photon *of, const murk_photon *photon)
{
    return murk_photon_band(of) == murk_photon_band(photon) &&
           (murk_photon_is_volume(of) ||
            murk_dot(murk_photon_normal(of), murk_photon_normal(photon)) > 0);
}

size_t murk_neighbours_find(const murk_neighbours *neighbours,
                            murk_neighbours_workspace *workspace,
                            const murk_photon *of, uint64_t emitted,
                            uint32_t *found, double *radius_m)
{
    assert(neighbours->k >= 2 && neighbours->max_m > 0);
    const murk_photon *photon = murk_photon_map_photons(neighbours->map);
    const murk_vec3 place = murk_photon_place(of);
    /* Query more and more photons, and collect those of the same kind in order
     * of distance. */
    const double most2_m2 = neighbours->max_m * neighbours->max_m;
    const size_t last = LAST_QUERY * neighbours->k;
    for (size_t m = FIRST_QUERY * neighbours->k;; m *= 2) {
        const size_t n = nearest_of_images(neighbours, workspace, place, m);
        const bool ends = n < m || m >= last;
        size_t collected = 0;
        /* The radius is the distance of the k-th photon of the kind, of the
         * last photon queried, or the maximum. */
        for (size_t i = 0; i < n; ++i) {
            const near_one *one = &workspace->nearest[i];
            const murk_photon *p = &photon[one->number];
            if (one->distance2_m2 > most2_m2) {
                *radius_m = neighbours->max_m;
                return collected;
            }
            const bool counts = murk_photon_emitted(p) != emitted &&
                                murk_neighbours_alike(of, p);
            const bool is_last = ends && n == m && i + 1 == n;
            if (is_last || (counts && collected + 1 == neighbours->k)) {
                *radius_m = sqrt(one->distance2_m2);
                return collected;
            }
            if (counts) {
                found[collected++] = one->number;
            }
        }
        if (ends) {
            *radius_m = neighbours->max_m;
            return collected;
        }
    }
}
