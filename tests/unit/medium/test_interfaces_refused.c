/* Refractive regions that may not lie as they do. Nothing here is random. */
#include "interface_media.h"

/* ---- what may lie how ---- */

static bool is_allowed(murk_region a, murk_region b, murk_error *err)
{
    const murk_medium clear = {.where = "clear"};
    const murk_region regions[2] = {a, b};
    murk_media *media = NULL;
    *err = (murk_error){0};
    const murk_status status =
        murk_media_create(&media, &clear, 1, regions, 2, &DOMAIN, err);
    CHECK(status == MURK_OK || status == MURK_BAD_VALUE);
    murk_media_destroy(media);
    return status == MURK_OK;
}

/* The same, whichever is listed first. */
static void check_pair(bool is_fine, murk_region a, murk_region b)
{
    murk_error err;
    CHECK(is_allowed(a, b, &err) == is_fine);
    CHECK(is_allowed(b, a, &err) == is_fine);
    a.ior = 0; /* no index, no boundary */
    CHECK(is_allowed(a, b, &err));
}

static void test_crossing_is_refused(void)
{
    const murk_region unit = box(murk_vec(0, 0, 0), murk_vec(1, 1, 1), 1.5);
    const murk_vec3 none = {0, 0, 0};
    /* half spaces */
    check_pair(true, below(1, 1.3), below(2, 1.4));
    check_pair(false, below(0.5, 1.3), unit);
    check_pair(true, below(1, 1.3), unit);
    check_pair(true, below(0, 1.3), unit);
    check_pair(false, below(0, 1.3), ball(murk_vec(0, 0, 0.5), 1, 1.5));
    check_pair(true, below(0, 1.3), ball(murk_vec(0, 0, -1), 1, 1.5));
    check_pair(true, below(0, 1.3), ball(murk_vec(19.5, 0, -19.5), 3, 1.5));
    check_pair(true, everywhere(1.3), ball(murk_vec(0, 0, 0.5), 1, 1.5));
    /* boxes */
    check_pair(true, unit, box(murk_vec(1, 0, 0), murk_vec(2, 1, 1), 1.5));
    check_pair(true, unit, box(murk_vec(0, 0, 0), murk_vec(2, 1, 1), 1.3));
    check_pair(true, unit, unit);
    check_pair(false, unit, box(murk_vec(0.5, 0, 0), murk_vec(2, 1, 1), 1.3));
    check_pair(false, unit,
               moved(unit, murk_vec(0, 0, 1), 1, murk_vec(0, 0, 0)));
    check_pair(true, unit,
               moved(unit, murk_vec(0, 0, 45), 1, murk_vec(1.8, 0.5, 0)));
    check_pair(false, unit,
               moved(unit, murk_vec(0, 0, 45), 1, murk_vec(1.6, 0.1, 0)));
    check_pair(true, moved(unit, murk_vec(30, 20, 10), 0.5, none),
               box(murk_vec(-1, -1, -1), murk_vec(1, 1, 1), 1.3));
    /* apart, though only an edge-edge axis tells: two bars laid crosswise,
     * turned about both of their long axes */
    const murk_region bar =
        box(murk_vec(-4, -0.5, -0.5), murk_vec(4, 0.5, 0.5), 1.5);
    check_pair(true, moved(bar, murk_vec(45, 0, 0), 1, none),
               moved(moved(bar, none, 1, none), murk_vec(45, 0, 90), 1,
                     murk_vec(0, 0, 1.415)));
    check_pair(false, moved(bar, murk_vec(45, 0, 0), 1, none),
               moved(bar, murk_vec(45, 0, 90), 1, murk_vec(0, 0, 1.413)));
    /* beyond the domain nothing counts */
    check_pair(true, box(murk_vec(-50, -50, 0), murk_vec(30, 50, 2), 1.5),
               box(murk_vec(-30, -50, 0.5), murk_vec(90, 50, 1), 1.3));
    check_pair(false, box(murk_vec(-50, -50, 0), murk_vec(10, 50, 2), 1.5),
               box(murk_vec(-30, -50, 0.5), murk_vec(90, 50, 1), 1.3));
    /* balls */
    check_pair(true, ball(none, 1, 1.5), ball(murk_vec(2, 0, 0), 1, 1.3));
    check_pair(false, ball(none, 1, 1.5), ball(murk_vec(1.9, 0, 0), 1, 1.3));
    check_pair(true, ball(none, 1, 1.5), ball(murk_vec(1, 0, 0), 2, 1.3));
    check_pair(false, ball(none, 1, 1.5), ball(murk_vec(1.1, 0, 0), 2, 1.3));
    check_pair(true, unit, ball(murk_vec(0.5, 0.5, 0.5), 0.5, 1.3));
    check_pair(false, unit, ball(murk_vec(0.5, 0.5, 0.5), 0.6, 1.3));
    check_pair(true, unit, ball(murk_vec(0.5, 0.5, 0.5), 0.9, 1.3));
    check_pair(false, unit, ball(murk_vec(1.5, 1.5, 1.5), 0.9, 1.3));
    check_pair(true, unit, ball(murk_vec(1.5, 1.5, 1.5), 0.86, 1.3));

    murk_error err;
    murk_region sea = below(0.5, 1.3), block = unit;
    block.where = "fog.yaml:9:5: regions.1";
    CHECK(!is_allowed(sea, block, &err));
    CHECK_TEXT(err.where, "fog.yaml:9:5: regions.1");
    CHECK_TEXT(err.text, "crosses sea, must lie in it, hold it or lie apart: "
                         "both have an index of refraction");
}

static void test_bad_indices_are_named(void)
{
    const double bad[] = {0.99, -1, 10.5, NAN, INFINITY};
    murk_error err;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        CHECK(!is_allowed(everywhere(0), below(0, bad[i]), &err));
        CHECK_TEXT(err.where, "sea");
        CHECK_MENTIONS(err.text, "must be 1..10");
    }
    CHECK(!is_allowed(everywhere(0), below(NAN, 1.3), &err));
    CHECK_MENTIONS(err.text, "below_z_m is nan m, must be finite");
    murk_region flat = ball(murk_vec(0, 0, 0), 1, 1.3);
    flat.to_world.matrix[2][2] = 0.5;
    CHECK(!is_allowed(everywhere(0), flat, &err));
    CHECK_MENTIONS(err.text, "must keep its shape");
}

int main(void)
{
    murk_warn_to(NULL); /* of what lies in a region listed later */
    test_crossing_is_refused();
    test_bad_indices_are_named();
    return check_done();
}
