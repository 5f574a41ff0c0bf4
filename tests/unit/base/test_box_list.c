/* Lists of boxes: what was added stays inside, segments are tested against a
 * dense sampling, and lists that are full stay valid. Seeds are fixed. */
#include "base/box_list.h"
#include "base/rng.h"
#include "check.h"

static double draw(uint32_t a, uint32_t b)
{
    uint32_t word[4];
    murk_random_words(1, 0, a, b, 0, word);
    return word[0] * 0x1p-32;
}

static murk_vec3 draw_point(uint32_t a, uint32_t b, double size)
{
    return murk_vec(size * draw(a, b), size * draw(a, b + 1),
                    size * draw(a, b + 2));
}

static murk_box draw_box(uint32_t a, double size)
{
    const murk_vec3 p = draw_point(a, 10, 10), edge = draw_point(a, 20, size);
    return (murk_box){p, murk_add(p, edge)};
}

/* True if one of many points of the segment is in the box. */
static bool has_point_in(const murk_box *box, murk_vec3 from, murk_vec3 along)
{
    bool has = false;
    for (int k = 0; k <= 2000 && !has; ++k) {
        has = murk_box_contains(box, murk_along(from, k / 2000.0, along));
    }
    return has;
}

static void test_segments(void)
{
    int met = 0, differ = 0;
    for (uint32_t i = 0; i < 3000; ++i) {
        const murk_box box = draw_box(i, 9);
        const murk_vec3 from = draw_point(i, 30, 12),
                        along = murk_sub(draw_point(i, 40, 12), from);
        const bool meets = murk_box_meets_segment(&box, from, along),
                   has = has_point_in(&box, from, along);
        met += meets;
        differ += meets != has;
        /* Sampling may miss a corner that is cut, the test nothing. */
        CHECK(meets || !has);
    }
    CHECK(met > 300 && met < 2700 && differ < 15);
}

static void test_axes(void)
{
    const murk_box box = {{0, 0, 0}, {1, 1, 1}};
    const murk_vec3 none = {0, 0, 0};
    CHECK(
        murk_box_meets_segment(&box, murk_vec(-1, .5, .5), murk_vec(3, 0, 0)));
    CHECK(murk_box_meets_segment(&box, murk_vec(-1, 1, 0), murk_vec(1, 0, 0)));
    CHECK(!murk_box_meets_segment(&box, murk_vec(-1, 2, 0), murk_vec(3, 0, 0)));
    CHECK(!murk_box_meets_segment(&box, murk_vec(-2, 0, 0), murk_vec(1, 0, 0)));
    CHECK(murk_box_meets_segment(&box, murk_vec(.2, .3, .4), none));
    CHECK(!murk_box_meets_segment(&box, murk_vec(.2, .3, 1.4), none));
}

static void test_what_is_added_stays_inside(void)
{
    murk_box_list list = {0};
    murk_box added[200];
    for (uint32_t i = 0; i < 200; ++i) {
        added[i] = draw_box(100000 + i, 0.3);
        murk_box_list_add(&list, added[i]);
        CHECK(list.n <= MURK_BOX_LIST_MAX && !list.are_all);
    }
    for (int i = 0; i < 200; ++i) {
        bool is_inside = false;
        for (size_t k = 0; k < list.n; ++k) {
            is_inside |= murk_box_contains(&list.box[k], added[i].min) &&
                         murk_box_contains(&list.box[k], added[i].max);
        }
        CHECK(is_inside);
    }
    for (size_t i = 0; i < list.n; ++i) {
        for (size_t k = 0; k < i; ++k) {
            CHECK(!murk_box_overlaps(&list.box[i], &list.box[k]));
        }
    }
}

static void test_special_cases(void)
{
    murk_box_list list = {0};
    murk_box_list_add(&list, murk_box_empty());
    CHECK(list.n == 0 && !list.are_all);
    CHECK(!murk_box_list_meet(&list, murk_vec(0, 0, 0), murk_vec(1, 1, 1)));
    /* Boxes far apart stay apart until they grow. */
    murk_box_list_add(&list, (murk_box){{0, 0, 0}, {1, 1, 1}});
    murk_box_list_add(&list, (murk_box){{3, 0, 0}, {4, 1, 1}});
    CHECK(list.n == 2);
    CHECK(!murk_box_list_meet(&list, murk_vec(2, 0, 0), murk_vec(0, 1, 1)));
    murk_box_list_grow(&list, 1.5);
    CHECK(list.n == 1 && list.box[0].min.x == -1.5 && list.box[0].max.x == 5.5);
    CHECK(murk_box_list_meet(&list, murk_vec(2, 0, 0), murk_vec(0, 1, 1)));
    murk_box_list_add(&list, (murk_box){{0, 0, 0}, {INFINITY, 1, 1}});
    CHECK(list.are_all);
    CHECK(murk_box_list_meet(&list, murk_vec(9, 9, 9), murk_vec(0, 1, 1)));
}

int main(void)
{
    test_segments();
    test_axes();
    test_what_is_added_stays_inside();
    test_special_cases();
    return check_done();
}
