/* Neighbours are those of a search through all photons, and a density from the
 * k - 1 nearer ones is without bias, limited radius or not.
 *
 * The checks share a 1e-6 chance of a false alarm (Sidak); the seed is fixed.
 */
#include "sensing/neighbours.h"

#include "base/rng.h"
#include "base/stats.h"
#include "check.h"

#include <stdlib.h>

#define CHECKS 2
#define SEED   11
#define K      16

static const murk_domain interior = {.box = {{0, 0, 0}, {1, 1, 1}}};
static const murk_domain tiled = {.box = {{0, 0, 0}, {1, 1, 1}},
                                  .is_periodic = true};

/* All over the cube; two bands, two sides, paths of two records. */
static murk_photon_map *crowd_of(uint32_t n, uint32_t stream)
{
    murk_photon *photon = calloc(n, sizeof *photon);
    for (uint32_t i = 0; i < n; ++i) {
        const murk_random4 u = murk_random(SEED, MURK_SCATTER, i, stream, 0);
        for (int a = 0; a < 3; ++a) {
            photon[i].position_m[a] = (float)u.u[a];
        }
        photon[i].normal =
            murk_direction_pack(murk_vec(0, 0, i % 4 < 2 ? 1 : -1));
        photon[i].band = i % 2;
        photon[i].emitted = i / 2;
    }
    murk_photon_map *map = NULL;
    murk_error err = {0};
    CHECK(murk_photon_map_create(&map, photon, n, 1, &err) == MURK_OK);
    return map;
}

/* The distance of the nearest image. */
static double distance(const murk_domain *domain, const murk_photon *a,
                       const murk_photon *b)
{
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        double d = fabs((double)a->position_m[i] - (double)b->position_m[i]);
        d = domain->is_periodic && i < 2 ? fmin(d, 1 - d) : d;
        sum += d * d;
    }
    return sqrt(sum);
}

static bool tells(const murk_photon *of, const murk_photon *p)
{
    return p->emitted != of->emitted && p->band == of->band &&
           murk_dot(murk_direction_unpack(of->normal),
                    murk_direction_unpack(p->normal)) > 0;
}

static void check_against_all(const murk_domain *domain, double max_m)
{
    /* Random photons in two bands with normals up or down. */
    enum { N = 600 };
    murk_photon_map *map = crowd_of(N, 0);
    const murk_photon *photon = murk_photon_map_photons(map);
    const murk_neighbours neighbours = {map, domain, K, max_m};
    murk_neighbours_workspace *workspace = murk_neighbours_workspace_create(K);
    for (size_t i = 0; i < N; ++i) {
        /* The search finds as many neighbours as are nearer than the
         * radius. */
        uint32_t found[K];
        double radius_m;
        const size_t n =
            murk_neighbours_find(&neighbours, workspace, &photon[i],
                                 photon[i].emitted, found, &radius_m);
        size_t nearer = 0;
        for (size_t k = 0; k < N; ++k) {
            nearer += tells(&photon[i], &photon[k]) &&
                      distance(domain, &photon[i], &photon[k]) <
                          radius_m * (1 - 1e-5);
        }
        CHECK(n == nearer);
        /* Fewer than K - 1 neighbours: the radius is the largest allowed. */
        CHECK(n < K && (n == K - 1 || radius_m == max_m));
        /* Each neighbour counts for the photon, and lies within the radius. */
        for (size_t k = 0; k < n; ++k) {
            CHECK(tells(&photon[i], &photon[found[k]]));
            CHECK(distance(domain, &photon[i], &photon[found[k]]) <=
                  radius_m * (1 + 1e-5));
        }
    }
    murk_neighbours_workspace_destroy(workspace);
    murk_photon_map_destroy(map);
}

static void test_those_of_a_search_through_all(void)
{
    check_against_all(&interior, 0.5);
    check_against_all(&interior, 0.2);
    check_against_all(&tiled, 0.5);
    check_against_all(&tiled, 0.2);
}

/* Each map is asked once, so that estimates are independent. The k-th is at a
 * gamma law's volume: relative variance 1 / (k - 2). */
static void check_density(double max_m)
{
    enum { MAPS = 1200, N = 500 };
    murk_neighbours_workspace *workspace = murk_neighbours_workspace_create(K);
    const murk_photon middle = {.position_m = {.5F, .5F, .5F},
                                .normal =
                                    murk_direction_pack(murk_vec(0, 0, 1))};
    double sum = 0, with_all = 0;
    for (uint32_t i = 0; i < MAPS; ++i) {
        murk_photon_map *map = crowd_of(N, i + 1);
        const murk_neighbours neighbours = {map, &interior, K, max_m};
        uint32_t found[K];
        double radius_m;
        const double n = (double)murk_neighbours_find(
            &neighbours, workspace, &middle, UINT64_MAX, found, &radius_m);
        const double volume = 4 / 3. * MURK_PI * pow(radius_m, 3);
        sum += n / volume;
        with_all += (n + (n == K - 1)) / volume;
        murk_photon_map_destroy(map);
    }
    const double want = N / 4., error = want / sqrt((K - 2.) * MAPS);
    CHECK_WITHIN(murk_sidak_limit(1e-6, CHECKS), sum / MAPS, want, error);
    /* Teeth: k in place of k - 1, where the k-th is within the limit. */
    CHECK(max_m < .5 || sigmas_off(with_all / MAPS, want, error) >
                            murk_sidak_limit(1e-6, CHECKS));
    murk_neighbours_workspace_destroy(workspace);
}

static void test_densities_are_without_bias(void)
{
    check_density(0.5);
    check_density(0.31); /* some 16 within: either may end it */
}

int main(void)
{
    test_those_of_a_search_through_all();
    test_densities_are_without_bias();
    return check_done();
}
