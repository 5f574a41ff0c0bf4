/* The order of a map's records depends on the records alone, neither on the
 * number of threads that built the map nor on the order in which the records
 * came. The test runs under the thread sanitizer, too
 * (cmake/sanitized_tests.cmake), so it is kept short. */
#include "check.h"
#include "sets.h"

static void test_order_depends_on_the_records_alone(void)
{
    const size_t n = 30000;
    for (int set = 0; set < PHOTON_SETS; ++set) {
        murk_photon *photons = make_photons((photon_set)set, n, 3);
        murk_photon_map *map = make_map(photons, n, 1);
        for (unsigned threads = 2; threads <= 5; threads += 3) {
            murk_photon_map *other = make_map(photons, n, threads);
            CHECK(memcmp(murk_photon_map_photons(map),
                         murk_photon_map_photons(other),
                         n * sizeof *photons) == 0);
            murk_photon_map_destroy(other);
        }
        for (size_t i = n; i-- > 1;) { /* shuffled */
            const murk_random4 r = murk_random(1, MURK_TEST, i, 3, 0);
            const size_t j = (size_t)(r.u[0] * (double)(i + 1));
            const murk_photon swapped = photons[i];
            photons[i] = photons[j];
            photons[j] = swapped;
        }
        murk_photon_map *other = make_map(photons, n, 1);
        CHECK(memcmp(murk_photon_map_photons(map),
                     murk_photon_map_photons(other), n * sizeof *photons) == 0);
        murk_photon_map_destroy(other);
        murk_photon_map_destroy(map);
        free(photons);
    }
}

int main(void)
{
    test_order_depends_on_the_records_alone();
    return check_done();
}
