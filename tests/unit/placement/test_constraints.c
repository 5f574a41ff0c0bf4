/* Plans under rules against brute force: every kind of rule, every pair of
 * kinds, all of them; each method, environment, with presolve and without.
 * Nothing is random but the fixed seeds. */
#include "placement/place.h"

#include "constrained_plans.h"

static void test_every_rule(uint32_t seed)
{
    for (unsigned kinds = 0; kinds < 1u << KINDS; ++kinds) {
        /* Every set of kinds is tried; single kinds and pairs get more
         * problems. */
        const int bits = __builtin_popcount(kinds);
        const uint32_t problems = bits == 1 ? 12 : bits == 2 ? 6 : 1;
        tally t = {0};
        for (uint32_t k = 0; k < problems; ++k) {
            /* Vary coverage, clarity levels, weights and dominance from
             * problem to problem. */
            const uint32_t own = seed + 1000 * kinds + k;
            made_up *m = made_up_create(own, 60, 10, k % 3 ? .25 : .07,
                                        k % 2 ? 1 : 40, 1 + k % 4, 1);
            if (k % 2 == k / 2 % 2) {
                let_half_see_no_more(m, own);
            }
            /* With a budget, some problems limit the cost alone and not the
             * count. */
            made_up_constraints r;
            made_up_constraints_fill(&r, own, kinds, 10);
            const size_t count =
                kinds & BUDGET && k % 3 ? 0 : 1 + made_up_draw(own, 20, 0, 5);
            try_all_methods(m, &r, own, count, &t);
            made_up_destroy(m);
        }
        /* A single kind must lead to plans, not only to refusals. */
        if (bits <= 1) {
            printf("kinds %u: %d plans, %d refusals, %d short of the best, "
                   "%d proven\n",
                   kinds, t.plans, t.refused, t.not_best, t.proven);
        }
        CHECK(bits != 1 || t.plans > 0);
    }
}

/* As few sensors as reach the target, under caps and with fixed ones. */
static void test_target_under_constraints(uint32_t seed)
{
    int reached = 0, missed = 0;
    for (uint32_t k = 0; k < 60; ++k) {
        const unsigned kinds[] = {CAPS, FIXED, CAPS | FIXED, MIN, SITES};
        made_up *m = made_up_create(seed + k, 60, 10, .2, k % 2 ? 1 : 40, 2, 1);
        made_up_constraints r;
        made_up_constraints_fill(&r, seed + k, kinds[k % 5], 10);
        uint64_t best[MADE_UP_MAX + 1];
        made_up_ruled_optima(m, &r, best);
        const size_t aim = 2 + k % 4;
        murk_place_desc desc = murk_place_defaults();
        desc.method = k % 3 ? MURK_PLACE_BEST : MURK_PLACE_EXACT;
        desc.count = 10;
        desc.restarts = 3;
        desc.constraints = &r.constraints;
        desc.target = made_up_set_value(m, (1u << (2 * aim)) - 1);
        size_t fewest = 0;
        bool is_possible = false;
        for (size_t n = 10; n >= 1; --n) {
            is_possible |= best[n] != UINT64_MAX;
            if (best[n] != UINT64_MAX && best[n] >= desc.target) {
                fewest = n;
            }
        }
        murk_error err = {0};
        murk_place_result plan = {0};
        const murk_status status = place_any(&plan, m, &desc, true, &err);
        CHECK((status == MURK_OK) == (fewest > 0));
        if (status) {
            CHECK_MENTIONS(err.text, is_possible ? "target" : "class");
            ++missed;
        } else {
            CHECK(plan.count == fewest && plan.fewest == fewest);
            CHECK(plan.value >= desc.target);
            CHECK(made_up_keeps(&r, made_up_set(&plan)));
            ++reached;
        }
        murk_place_release(&plan);
        made_up_destroy(m);
    }
    CHECK(reached > 10 && missed > 3); /* or one of them was not tested */
}

static void check_refusal(const murk_constraints *constraints, size_t count,
                          uint64_t target, const char *text)
{
    made_up *m = made_up_create(5, 20, 6, .3, 1, 1, 1);
    murk_place_desc desc = murk_place_defaults();
    desc.count = count;
    desc.target = target;
    desc.constraints = constraints;
    murk_place_result plan = {0};
    murk_error err = {0};
    CHECK(murk_place_sensors(&plan, &m->problem, NULL, &desc, &err) != MURK_OK);
    CHECK_TEXT(err.text, text);
    CHECK(plan.sensor == NULL);
    made_up_destroy(m);
}

static void test_contradictions_are_refused(void)
{
    /* Classes, costs, sites and positions that the cases below share. */
    const uint32_t class_of[] = {0, 0, 1, 1, 1, 1};
    const uint32_t bad_class[] = {0, 0, 1, 2, 1, 1};
    const size_t two[] = {2, 0}, three[] = {3, 0}, ones[] = {1, 1};
    const size_t fixed[] = {0, 1}, twice[] = {4, 4}, outside[] = {6};
    const int64_t cost[] = {5, 7, 9, 5, 6, 8};
    const int64_t negative[] = {5, 7, -9, 5, 6, 8};
    const uint32_t site[] = {8, 8, 8, 9, 9, 9};
    const double place[6][3] = {{0}, {.5}, {1}, {1.5}, {2}, {2.5}};
    const size_t first[] = {0, 1, 1, 1, 1, 1, 1};
    const uint32_t unilateral[] = {3};
    /* Each case has one contradiction or one bad value, and a message that
     * names it. */
    const struct {
        murk_constraints constraints;
        size_t count;
        uint64_t target;
        const char *text;
    } bad[] = {
        {{.classes = 2, .class_of = bad_class},
         2,
         0,
         "class of candidate 3 is 2, must be below 2"},
        {{.classes = 2, .class_of = class_of, .min = two, .max = ones},
         2,
         0,
         "class 0 must have at least 2 sensors, but at most 1"},
        {{.classes = 2, .class_of = class_of, .min = three},
         4,
         0,
         "class 0 must have at least 3 sensors, but has only 2 usable "
         "candidates"},
        {{.classes = 2, .class_of = class_of, .min = two},
         1,
         0,
         "1 sensors asked for, but fixed sensors and least counts need 2"},
        {{.classes = 2, .class_of = class_of, .max = ones},
         3,
         0,
         "3 sensors asked for, but the classes' greatest counts allow only 2"},
        {{.classes = 2,
          .class_of = class_of,
          .max = ones,
          .fixed = fixed,
          .fixed_count = 2},
         2,
         0,
         "class 0 may have at most 1 sensors, but 2 are fixed"},
        {{.fixed = twice, .fixed_count = 2},
         3,
         0,
         "fixed sensor at candidate 4 is given twice"},
        {{.fixed = outside, .fixed_count = 1},
         3,
         0,
         "fixed sensor at candidate 6, must be below 6"},
        {{.fixed = fixed, .fixed_count = 2},
         1,
         0,
         "1 sensors asked for, but fixed sensors and least counts need 2"},
        {{.fixed = fixed, .fixed_count = 2, .site = site},
         2,
         0,
         "fixed sensors 0 and 1 exclude each other: one sensor may stand at a "
         "site"},
        {{.fixed = fixed,
          .fixed_count = 2,
          .position_m = place,
          .spacing_m = .6},
         2,
         0,
         "fixed sensors 0 and 1 exclude each other: they stand closer than the "
         "least spacing"},
        {{.cost = negative, .budget = 9},
         0,
         0,
         "cost of candidate 2 is -9, must be 0..1000000000000"},
        {{.cost = cost, .budget = -1}, 1, 0, "budget is -1, must be 0 or more"},
        {{.budget = 5}, 0, 0, "budget is 5, but no candidate has a cost"},
        {{.cost = cost, .budget = 4},
         0,
         0,
         "budget is 4, but the cheapest candidate costs 5"},
        {{.cost = cost, .budget = 11, .fixed = fixed, .fixed_count = 2},
         0,
         0,
         "budget is 11, but fixed sensors and least counts cost 12 at least"},
        {{.classes = 2,
          .class_of = class_of,
          .min = two,
          .cost = cost,
          .budget = 11,
          .fixed = fixed,
          .fixed_count = 1},
         0,
         0,
         "budget is 11, but fixed sensors and least counts cost 12 at least"},
        {{.classes = 2,
          .class_of = class_of,
          .min = ones,
          .cost = cost,
          .budget = 9},
         0,
         0,
         "budget is 9, but fixed sensors and least counts cost 10 at least"},
        {{.cost = cost, .budget = 11},
         0,
         5,
         "a target and a budget are given, must be one"},
        {{.site = site},
         3,
         0,
         "3 sensors asked for, but only 2 sites, with one sensor each"},
        {{.position_m = place, .spacing_m = (double)NAN},
         1,
         0,
         "spacing is nan m, must be 0 or more"},
        {{.spacing_m = 1},
         1,
         0,
         "spacing is 1 m, but no candidate has a position"},
        {{.position_m = place, .spacing_m = 1.2},
         3,
         0,
         "no plan: no 3 of 6 usable candidates keep all rules"},
        {{.conflict_first = first, .conflict = unilateral},
         2,
         0,
         "conflict of candidate 0 with 3: must name another one below 6, "
         "once, rising, and be named there, too"},
    };
    /* Every case is refused with that message. */
    for (size_t k = 0; k < sizeof bad / sizeof bad[0]; ++k) {
        check_refusal(&bad[k].constraints, bad[k].count, bad[k].target,
                      bad[k].text);
    }
}

/* What a plan promises, by name. */
static void test_guarantees_are_named(void)
{
    static const struct {
        unsigned kinds;
        const char *name;
    } all[] = {{0, "1 - (1 - 1/n)^n"},
               {FIXED, "1 - (1 - 1/n)^n"},
               {CAPS, "1/2"},
               {MIN, "1/2"},
               {SITES, "1/2"},
               {SITES | CAPS, "1/3"},
               {SPACING, "1/13"},
               {SPACING | CAPS, "1/14"},
               {SPACING | SITES, "1/14"},
               {LIST, "none"},
               {BUDGET, ".405"},
               {BUDGET | FIXED, ".405"},
               {BUDGET | CAPS, "none"},
               {BUDGET | SPACING, "none"}};
    made_up *m = made_up_create(5, 20, 10, .3, 1, 1, 1);
    for (size_t k = 0; k < sizeof all / sizeof all[0]; ++k) {
        made_up_constraints r;
        made_up_constraints_fill(&r, 11, all[k].kinds, 10);
        for (size_t c = 0; c < 3; ++c) {
            r.max[c] = 1; /* a cap that says something */
            r.min[c] = c == 0;
        }
        murk_place_desc desc = murk_place_defaults();
        desc.count = all[k].kinds & BUDGET ? 0 : 2;
        desc.method = MURK_PLACE_GREEDY;
        desc.constraints = &r.constraints;
        murk_place_result plan = {0};
        murk_error err = {0};
        CHECK(place_any(&plan, m, &desc, true, &err) == MURK_OK);
        CHECK_TEXT(err.text, "");
        CHECK_TEXT(plan.guarantee ? plan.guarantee : "", all[k].name);
        murk_place_release(&plan);
        desc.method = MURK_PLACE_SPOQ;
        CHECK(place_any(&plan, m, &desc, true, &err) == MURK_OK);
        CHECK_TEXT(plan.guarantee ? plan.guarantee : "", "none");
        murk_place_release(&plan);
    }
    made_up_destroy(m);
}

/* Gain per cost alone may be arbitrarily bad: a cheap candidate that sees
 * little keeps the dear one out, which sees all. Greedy tries both. */
static void test_budget_is_not_spent_on_crumbs(void)
{
    made_up *m = made_up_create(1, 100, 2, 0, 1, 1, 1);
    for (size_t i = 0; i < 100; ++i) {
        m->clarity[i] = MURK_CLEAR;
        m->clarity[100 + i] = i < 2 ? MURK_CLEAR : 0;
    }
    const int64_t cost[] = {100, 1};
    const murk_constraints constraints = {.cost = cost, .budget = 100};
    murk_place_desc desc = murk_place_defaults();
    desc.method = MURK_PLACE_GREEDY;
    desc.count = 0;
    desc.constraints = &constraints;
    murk_place_result plan = {0};
    murk_error err = {0};
    CHECK(place_any(&plan, m, &desc, false, &err) == MURK_OK);
    CHECK(plan.count == 1 && plan.sensor[0] == 0 && plan.cost == 100);
    murk_place_release(&plan);
    made_up_destroy(m);
}

/* Candidates 0, 1, 3 exclude 2, 4, 5. Of three sensors 0, 1, 3 are best, though
 * 3 sees nothing that 0 does not: presolve may not take it away, for there is
 * nobody else to fill the plan. */
static void test_presolve_leaves_who_fills_the_plan(void)
{
    made_up *m = made_up_create(1, 30, 6, 0, 1, 1, 1);
    for (size_t i = 0; i < 10; ++i) {
        m->clarity[i] = m->clarity[30 + 10 + i] = MURK_CLEAR;
        m->clarity[60 + 5 + i] = m->clarity[60 + 20] = MURK_CLEAR;
        m->clarity[90 + i] = i < 3 ? MURK_CLEAR : 0;
    }
    const size_t first[] = {0, 3, 6, 9, 12, 15, 18};
    const uint32_t conflict[] = {2, 4, 5, 2, 4, 5, 0, 1, 3,
                                 2, 4, 5, 0, 1, 3, 0, 1, 3};
    const murk_constraints constraints = {.conflict_first = first,
                                          .conflict = conflict};
    murk_place_desc desc = murk_place_defaults();
    desc.method = MURK_PLACE_EXACT;
    desc.count = 3;
    desc.constraints = &constraints;
    murk_place_result plan = {0};
    murk_error err = {0};
    CHECK(place_any(&plan, m, &desc, true, &err) == MURK_OK);
    CHECK(made_up_set(&plan) == (1 | 2 | 8));
    CHECK(plan.proven_optimal);
    murk_place_release(&plan);
    made_up_destroy(m);
}

/* Of candidates a and b, of which a sees all that b does: whether b may be left
 * out beforehand, under each rule. */
static void test_who_may_be_dropped(void)
{
    /* 0 and 1 exclude each other */
    static const size_t conflict_first[] = {0, 1, 2, 2, 2};
    static const uint32_t conflict[] = {1, 0};
    static const struct {
        uint32_t class_of[4];
        size_t min;      /* of class 0 */
        int64_t cost[4]; /* no costs where the first is 0 */
        bool has_conflict;
        uint32_t a, b;
        bool may;
    } table[] = {
        {{0, 0, 0, 0}, 0, {0}, false, 0, 1, true},
        {{0, 1, 0, 0}, 0, {0}, false, 0, 1, false}, /* of another class */
        {{0, 0, 0, 1}, 1, {0}, false, 0, 1, true},  /* others may fill up */
        {{0, 0, 0, 0}, 0, {0}, true, 0, 1, true},   /* never stand together */
        {{0, 0, 0, 0}, 0, {0}, true, 2, 3, false},  /* who fills up may lack */
        {{0, 0, 0, 0}, 0, {0}, true, 2, 0, false},
        {{0, 0, 0, 0}, 0, {0}, true, 0, 2, false}, /* less free */
        {{0, 0, 0, 0}, 0, {2, 2, 3, 1}, false, 0, 1, true},
        {{0, 0, 0, 0}, 0, {2, 2, 3, 1}, false, 0, 2, true},
        {{0, 0, 0, 0}, 0, {2, 2, 3, 1}, false, 0, 3, false}, /* dearer */
        {{0, 0, 0, 0}, 1, {2, 2, 3, 1}, false, 0, 1, false}, /* least count */
        {{1, 1, 0, 0}, 1, {2, 2, 3, 1}, false, 0, 1, true},  /* another's */
        {{0, 0, 0, 0}, 1, {2, 2, 3, 1}, true, 0, 1, true},
        {{0, 0, 0, 0}, 0, {2, 2, 3, 1}, true, 3, 2, true},
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; ++i) {
        const bool has_costs = table[i].cost[0] > 0;
        const size_t min[] = {table[i].min, 0}, max[] = {4, 4};
        murk_constraints constraints = {.classes = 2,
                                        .class_of = table[i].class_of,
                                        .min = min,
                                        .max = max};
        if (has_costs) {
            constraints.cost = table[i].cost;
            constraints.budget = 8;
        }
        if (table[i].has_conflict) {
            constraints.conflict_first = conflict_first;
            constraints.conflict = conflict;
        }
        murk_constraint_set set = {0};
        murk_error err = {0};
        CHECK(murk_constraint_set_init(&set, &constraints, 4, 2, has_costs,
                                       &err) == MURK_OK);
        CHECK_TEXT(err.text, "");
        const bool may =
            murk_constraint_set_may_drop(&set, table[i].a, table[i].b);
        if (may != table[i].may) {
            printf("row %zu of the table\n", i);
        }
        CHECK(may == table[i].may);
        murk_constraint_set_release(&set);
    }
    const size_t fixed[] = {1};
    const murk_constraints constraints = {.fixed = fixed, .fixed_count = 1};
    murk_constraint_set set = {0};
    CHECK(murk_constraint_set_init(&set, &constraints, 4, 2, false, NULL) ==
          MURK_OK);
    CHECK(!murk_constraint_set_may_drop(&set, 0, 1));
    CHECK(murk_constraint_set_may_drop(&set, 1, 0));
    murk_constraint_set_release(&set);
}

/* Under constraints of every kind, and with more candidates than brute
 * force can try, the number of threads changes neither the plan nor the
 * bound. */
static void test_threads_change_nothing_under_constraints(void)
{
    enum { CANDIDATES = 80 };
    /* Three classes, two candidates for each site, and five different
     * costs. */
    uint32_t class_of[CANDIDATES], site[CANDIDATES];
    int64_t cost[CANDIDATES];
    for (uint32_t j = 0; j < CANDIDATES; ++j) {
        class_of[j] = j % 3;
        site[j] = j / 2;
        cost[j] = 2 + j % 5;
    }
    /* All constraints but the budget hold in the first round, and the
     * budget as well in the second. */
    const size_t min[] = {1, 0, 0}, max[] = {2, 2, 1}, fixed[] = {17};
    for (int with_budget = 0; with_budget < 2; ++with_budget) {
        const murk_constraints constraints = {.classes = 3,
                                              .class_of = class_of,
                                              .min = min,
                                              .max = max,
                                              .cost = cost,
                                              .budget = with_budget ? 14 : 0,
                                              .fixed = fixed,
                                              .fixed_count = 1,
                                              .site = site};
        /* Place with one thread and with four, and compare plan, upper
         * bound and numbers of steps. */
        murk_place_result was = {0};
        for (unsigned threads = 1; threads <= 4; threads += 3) {
            made_up *m = made_up_create(3, 700, CANDIDATES, .12, 9, 2, threads);
            murk_place_desc desc = murk_place_defaults();
            desc.count = 4;
            desc.restarts = 40;
            desc.nodes = 50;
            desc.constraints = &constraints;
            murk_place_result r = {0};
            murk_error err = {0};
            CHECK(place_any(&r, m, &desc, true, &err) == MURK_OK);
            if (threads > 1) {
                CHECK(r.count == was.count && r.value == was.value);
                CHECK(memcmp(r.sensor, was.sensor,
                             r.count * sizeof *r.sensor) == 0);
                CHECK(r.upper == was.upper && r.restarts == was.restarts);
                CHECK(r.evaluations == was.evaluations);
            }
            murk_place_release(&was);
            was = r;
            made_up_destroy(m);
        }
        murk_place_release(&was);
    }
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_every_rule(seed);
    test_target_under_constraints(seed);
    test_contradictions_are_refused();
    test_guarantees_are_named();
    test_budget_is_not_spent_on_crumbs();
    test_presolve_leaves_who_fills_the_plan();
    test_who_may_be_dropped();
    test_threads_change_nothing_under_constraints();
    return check_done();
}
