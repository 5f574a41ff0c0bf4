/* Straight segments in a periodic domain: pieces that lie in it and add up.
 *
 * Deterministic: never cries wolf. */
#include "base/rng.h"
#include "check.h"
#include "path/segment.h"

static const murk_domain around = {.box = {{-1, 2, 0}, {9, 8, 4}},
                                   .is_periodic = true};

static bool is_inside(murk_vec3 p)
{
    const double e = 1e-12;
    return p.x >= -1 - e && p.x <= 9 + e && p.y >= 2 - e && p.y <= 8 + e;
}

static void test_pieces_lie_inside_and_add_up(void)
{
    /* Random pairs of points in the domain. */
    int pieces[4] = {0};
    for (uint32_t i = 0; i < 500; ++i) {
        const murk_random4 r = murk_random(1, MURK_TEST, i, 0, 0);
        const murk_random4 q = murk_random(1, MURK_TEST, i, 0, 1);
        const murk_vec3 a = {-1 + 10 * r.u[0], 2 + 6 * r.u[1], 4 * r.u[2]};
        const murk_vec3 b = {-1 + 10 * q.u[0], 2 + 6 * q.u[1], 4 * q.u[2]};
        /* The nearest image is at most half a period away in x and y. */
        const murk_vec3 to = murk_path_nearest_image(&around, b, a);
        CHECK(fabs(to.x - a.x) <= 5 && fabs(to.y - a.y) <= 3 && to.z == b.z);
        /* Each piece lies in the domain and along the path; lengths add up. */
        murk_path_segment piece[MURK_PATH_SEGMENTS_MAX];
        const int n = murk_path_cut(&around, a, to, 0, piece);
        const murk_vec3 offset = murk_sub(to, a);
        double length = 0;
        for (int k = 0; k < n; ++k) {
            const murk_vec3 part = murk_sub(piece[k].to, piece[k].from);
            CHECK(is_inside(piece[k].from) && is_inside(piece[k].to));
            CHECK(murk_length(murk_cross(part, offset)) < 1e-12);
            length += murk_length(part);
        }
        CHECK_NEAR(length, murk_length(offset), 1e-12);
        /* The first piece begins at one point, and the last ends at the
         * other. */
        CHECK(murk_length(murk_sub(piece[0].from, a)) == 0);
        CHECK(murk_length(murk_sub(piece[n - 1].to, b)) < 1e-12);
        ++pieces[n];
    }
    /* Paths crossed no side, one, and two. */
    CHECK(pieces[1] > 10 && pieces[2] > 10 && pieces[3] > 10);
}

static void test_an_open_domain_is_never_cut(void)
{
    murk_domain open = around;
    open.is_periodic = false;
    const murk_vec3 a = {-0.9, 2.1, 1}, b = {8.9, 7.9, 3};
    const murk_vec3 to = murk_path_nearest_image(&open, b, a);
    murk_path_segment piece[MURK_PATH_SEGMENTS_MAX];
    CHECK(murk_path_cut(&open, a, to, 1, piece) == 1);
    CHECK(murk_length(murk_sub(piece[0].from, a)) == 0);
    CHECK(murk_length(murk_sub(piece[0].to, b)) == 0);
}

static void test_pieces_overlap_the_sides(void)
{
    const murk_vec3 a = {8, 5, 1}, to = {10, 5, 1};
    murk_path_segment piece[MURK_PATH_SEGMENTS_MAX];
    CHECK(murk_path_cut(&around, a, to, 0.25, piece) == 2);
    CHECK_NEAR(piece[0].to.x, 9.25, 1e-12);
    CHECK_NEAR(piece[1].from.x, -1.25, 1e-12);
    CHECK_NEAR(piece[1].to.x, 0, 1e-12);
}

/* The nearest image by rounding alone, at offsets of up to 3 periods and around
 * every half of a period: equal to the bit. */
static void test_nearest_image_is_that_by_rounding(void)
{
    const double period = around.box.max.x - around.box.min.x;
    const murk_vec3 to = {around.box.min.x + 0.3 * period, around.box.min.y, 0};
    for (int i = -3000; i <= 3000; ++i) {
        double x = to.x + i * period / 1000;
        for (int step = 0; step < 5; ++step) {
            const murk_vec3 found =
                murk_path_nearest_image(&around, murk_vec(x, to.y, 0), to);
            CHECK(found.x == x - period * floor((x - to.x) / period + 0.5));
            CHECK(found.y == to.y);
            x = nextafter(x, i % 2 == 0 ? INFINITY : -INFINITY);
        }
    }
}

int main(void)
{
    test_nearest_image_is_that_by_rounding();
    test_pieces_lie_inside_and_add_up();
    test_an_open_domain_is_never_cut();
    test_pieces_overlap_the_sides();
    return check_done();
}
