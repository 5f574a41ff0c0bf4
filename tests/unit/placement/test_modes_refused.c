/* Modes of combining views that are refused. Nothing here is random. */
#include "placement/place.h"

#include "check.h"
#include "made_up.h"

static void check_refusal(murk_combining combining, unsigned redundancy,
                          const char *text)
{
    made_up *m = made_up_create(5, 20, 6, .3, 9, 1, 1);
    m->problem.combining = combining;
    m->problem.redundancy = redundancy;
    const murk_place_desc desc = murk_place_defaults();
    murk_place_result plan = {0};
    murk_error err = {0};
    CHECK(murk_place_sensors(&plan, &m->problem, NULL, &desc, &err) ==
          MURK_BAD_VALUE);
    CHECK_TEXT(err.text, text);
    made_up_destroy(m);
}

static void test_refusals(void)
{
    check_refusal(MURK_COMBINE_CLEAREST, 17, "redundancy is 17, must be 1..16");
    check_refusal(MURK_COMBINE_INDEPENDENT, 2,
                  "redundancy is 2, must be 1 where views are independent "
                  "chances: all of them count");
}

/* Weights whose worth 64 bits could not hold. */
static void test_heavy_weights_are_refused(void)
{
    static uint32_t weight[40000];
    for (size_t i = 0; i < 40000; ++i) {
        weight[i] = 1000000000;
    }
    made_up *m = made_up_create(5, 40000, 3, .1, 1, 1, 1);
    m->problem.weight = weight;
    m->problem.redundancy = 4;
    const murk_place_desc desc = murk_place_defaults();
    murk_place_result plan = {0};
    murk_error err = {0};
    CHECK(murk_place_sensors(&plan, &m->problem, NULL, &desc, &err) ==
          MURK_BAD_VALUE);
    CHECK_TEXT(err.text, "weights add up to 40000000000000, must be "
                         "35184372088831 at most with redundancy 4");
    m->problem.redundancy = 3;
    CHECK(murk_place_sensors(&plan, &m->problem, NULL, &desc, NULL) == MURK_OK);
    murk_place_release(&plan);
    made_up_destroy(m);
}

int main(void)
{
    test_refusals();
    test_heavy_weights_are_refused();
    return check_done();
}
