/* The coverage of a dark scene has no defined share. Nothing is random. */
#include "plan/plan.h"

#include "check.h"

#include <math.h>

static void check_undefined(murk_estimate share)
{
    CHECK(isnan(share.value) && isnan(share.standard_error));
}

int main(void)
{
    const murk_scene_desc scene = {.placement.n_interests = 1};
    const murk_stage stage = {.scene = &scene};
    murk_coverage_result dark = {0};
    murk_error err = {0};
    CHECK(murk_dark_coverage(&dark, &stage, 2, &err) == MURK_OK);
    check_undefined(dark.total);
    check_undefined(dark.surface);
    check_undefined(dark.volume);
    check_undefined(dark.at_least);
    check_undefined(dark.region[0].coverage);
    CHECK(isnan(dark.sum_of_views));
    for (size_t i = 0; i < 2; ++i) {
        CHECK(isnan(dark.covers[i]) && isnan(dark.only_it_covers[i]));
        CHECK(isnan(dark.seen_by_at_least[i]));
        CHECK(isnan(dark.map[i].weight) && isnan(dark.map[i].standard_error));
    }
    murk_coverage_result_release(&dark);
    return check_done();
}
