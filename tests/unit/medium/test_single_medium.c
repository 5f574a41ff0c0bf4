/* Density paths by medium add up to a world's optical depth, and each is the
 * length that a ray has in what is not hidden of it. Nothing is random. */
#include "check.h"
#include "medium/phase.h"
#include "medium/rescaled.h"

#define MEDIA 3

static const murk_box DOMAIN = {{-10, -10, -10}, {10, 10, 10}};

static murk_spectrum two(double a, double b)
{
    return (murk_spectrum){{a, b}};
}

/* Fog everywhere, smoke in a box within it, and a layered mist in a ball that
 * takes the place of both. */
static murk_media *world(const murk_profile *layers)
{
    const murk_medium medium[MEDIA] = {
        {.extinction_per_m = two(0.2, 0)},
        {.extinction_per_m = two(0.7, 0.4)},
        {.extinction_per_m = two(1, 1), .profile = layers}};
    const murk_affine still = murk_affine_identity();
    const murk_region region[MEDIA] = {
        {.medium = 0, .shape = MURK_REGION_EVERYWHERE},
        {.medium = 1,
         .shape = MURK_REGION_BOX,
         .box = {{-4, -4, -4}, {4, 4, 4}},
         .to_world = still},
        {.medium = 2,
         .shape = MURK_REGION_SPHERE,
         .center = {1, 0, 0},
         .radius_m = 2,
         .to_world = still,
         .replaces = true}};
    murk_media *media = NULL;
    murk_error err = {0};
    CHECK(!murk_media_create(&media, medium, MEDIA, region, MEDIA, &DOMAIN,
                             &err));
    return media;
}

static double path(const murk_media *media, size_t medium, int band,
                   murk_vec3 from, murk_vec3 direction, double length_m)
{
    murk_media *alone = NULL;
    murk_error err = {0};
    CHECK(!murk_media_single(&alone, media, medium, &err));
    const double path_m =
        murk_media_optical_depth(alone, band, 0, from, direction, length_m);
    murk_media_destroy(alone);
    return path_m;
}

static void test_paths_are_lengths(const murk_media *media)
{
    const murk_vec3 from = {-8, 0, 0}, along = {1, 0, 0};
    for (int band = 0; band < 2; ++band) {
        CHECK_NEAR(path(media, 0, band, from, along, 16), 12, 1e-12);
        CHECK_NEAR(path(media, 1, band, from, along, 16), 4, 1e-12);
    }
    /* the mist is .3 and .6 per metre at that height */
    CHECK_NEAR(path(media, 2, 0, from, along, 16), 1.2, 1e-12);
    CHECK_NEAR(path(media, 2, 1, from, along, 16), 2.4, 1e-12);
}

static void test_paths_add_up_to_depths(const murk_media *media)
{
    const double extinction[MEDIA][2] = {{0.2, 0}, {0.7, 0.4}, {1, 1}};
    const murk_vec3 from = {-5, -4, -3};
    const murk_vec3 along = murk_unit(murk_vec(6, 4, 3.5));
    for (int band = 0; band < 2; ++band) {
        double sum = 0;
        for (size_t m = 0; m < MEDIA; ++m) {
            sum += extinction[m][band] * path(media, m, band, from, along, 9);
        }
        const double depth =
            murk_media_optical_depth(media, band, 0, from, along, 9);
        CHECK(depth > 1);
        CHECK_NEAR(sum, depth, 1e-12);
    }
}

static void test_laws_are_distinguished(void)
{
    const murk_phase phase[] = {
        murk_phase_hg(0.5),
        murk_phase_hg(0.5000000000000001),
        murk_phase_rayleigh(),
        murk_phase_two_hg(0.5, 0.1, 0.5),
        murk_phase_two_hg(0.5, 0.1, 0.6),
        murk_phase_two_hg(0.5, 0.2, 0.5),
    };
    const size_t n = sizeof phase / sizeof *phase;
    for (size_t i = 0; i < n * n; ++i) {
        CHECK(murk_phase_is_same(&phase[i / n], &phase[i % n]) ==
              (i / n == i % n));
    }
}

static void test_tables_are_distinguished(void)
{
    const double slope[3] = {3.6, 3.6, 3.7};
    murk_phase_table *table[3] = {NULL};
    murk_error err = {0};
    for (int i = 0; i < 3; ++i) {
        CHECK(!murk_phase_table_fournier_forand(&table[i], 1.1, slope[i], "ff",
                                                &err));
    }
    CHECK(murk_phase_table_is_same(table[0], table[1]));
    CHECK(!murk_phase_table_is_same(table[0], table[2]));
    const murk_phase a = murk_phase_tabulated(table[0]),
                     b = murk_phase_tabulated(table[1]),
                     c = murk_phase_tabulated(table[2]);
    CHECK(murk_phase_is_same(&a, &b) && !murk_phase_is_same(&a, &c));
    for (int i = 0; i < 3; ++i) {
        murk_phase_table_destroy(table[i]);
    }
}

int main(void)
{
    const double heights[2] = {-5, 5};
    const murk_spectrum layer[2] = {two(0.3, 0.2), two(0.3, 1)};
    const murk_profile layers = {2, heights, layer};
    murk_media *media = world(&layers);
    if (media) {
        test_paths_are_lengths(media);
        test_paths_add_up_to_depths(media);
    }
    murk_media_destroy(media);
    test_laws_are_distinguished();
    test_tables_are_distinguished();
    return check_done();
}
