/* The fewest sensors for the strict question, against brute force over all
 * sets of candidates: hundreds of small random problems, with and without
 * rules, by every method. Nothing is random but the fixed seeds. */
#include "placement/at_least.h"

#include "check.h"
#include "made_up.h"
#include "made_up_rules.h"

#define MATRIX_MAX  UINT64_C(1000000000)
#define PHOTONS_MAX 130

/* The weight of photons seen by k or more of the set, times MURK_CLEAR;
 * seen_by[photons] are sets of candidates. */
static uint64_t weigh(const made_up *m, const uint32_t *seen_by, uint32_t set,
                      size_t k)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < m->problem.photons; ++i) {
        const bool is_seen = (size_t)__builtin_popcount(seen_by[i] & set) >= k;
        sum += is_seen ? m->weight[i] : 0;
    }
    return sum * MURK_CLEAR;
}

static void find_seen_by(const made_up *m, uint32_t *seen_by)
{
    const size_t photons = m->problem.photons;
    for (size_t i = 0; i < photons; ++i) {
        seen_by[i] = 0;
        for (size_t j = 0; j < m->problem.candidates; ++j) {
            seen_by[i] |= (uint32_t)(m->clarity[j * photons + i] > 0) << j;
        }
    }
}

static uint64_t strict_of(const made_up *m, uint32_t set, size_t k)
{
    uint32_t seen_by[PHOTONS_MAX];
    find_seen_by(m, seen_by);
    return weigh(m, seen_by, set, k);
}

/* best[n]: of all sets of n that keep the rules (NULL: of all); UINT64_MAX
 * where there is none. */
static void find_optima(const made_up *m, const made_up_constraints *r,
                        size_t k, uint64_t best[MADE_UP_MAX + 1])
{
    for (size_t n = 0; n <= MADE_UP_MAX; ++n) {
        best[n] = UINT64_MAX;
    }
    uint32_t seen_by[PHOTONS_MAX];
    find_seen_by(m, seen_by);
    for (uint32_t set = 0; set < UINT32_C(1) << m->problem.candidates; ++set) {
        if (r && !made_up_keeps(r, set)) {
            continue;
        }
        const uint64_t value = weigh(m, seen_by, set, k);
        const size_t n = (size_t)__builtin_popcount(set);
        best[n] = best[n] == UINT64_MAX || value > best[n] ? value : best[n];
    }
}

static size_t fewest_of(const uint64_t best[MADE_UP_MAX + 1], uint64_t target)
{
    for (size_t n = 1; n <= MADE_UP_MAX; ++n) {
        if (best[n] != UINT64_MAX && best[n] >= target) {
            return n;
        }
    }
    return 0;
}

/* How often each claim was put to the test. */
typedef struct tally {
    int solved, proven, unproven, refused;
} tally;

static void try_one(const made_up *m, const made_up_constraints *constraints,
                    size_t k, uint64_t target, murk_place_method method,
                    uint64_t nodes, tally *t)
{
    uint64_t best[MADE_UP_MAX + 1];
    find_optima(m, constraints, k, best);
    const size_t fewest = fewest_of(best, target);
    murk_at_least strict;
    murk_at_least_init(&strict, &m->problem, (unsigned)k);
    murk_matrix *matrix = NULL;
    murk_error err = {0};
    CHECK(murk_matrix_create(&matrix, &strict.problem, MATRIX_MAX, &err) ==
          MURK_OK);
    murk_place_desc desc = murk_place_defaults();
    desc.method = method;
    desc.count = m->problem.candidates;
    desc.target = target;
    desc.nodes = nodes;
    desc.constraints = constraints ? &constraints->constraints : NULL;
    murk_place_result found = {0};
    const murk_status status =
        murk_place_at_least(&found, &strict.problem, matrix, &desc, &err);
    if (fewest == 0) {
        CHECK(status != MURK_OK);
        ++t->refused;
    } else if (status != MURK_OK) {
        /* Only a search that is cut may miss a plan under rules. */
        CHECK(constraints && nodes == 0 && status == MURK_RUN_FAILED);
    } else {
        uint32_t set = 0;
        for (size_t i = 0; i < found.count; ++i) {
            set |= UINT32_C(1) << found.sensor[i];
        }
        CHECK((size_t)__builtin_popcount(set) == found.count);
        CHECK(!constraints || made_up_keeps(constraints, set));
        CHECK(found.value == strict_of(m, set, k));
        CHECK(found.value >= target);
        CHECK(found.count >= fewest);
        CHECK(found.fewest <= fewest);
        CHECK(found.upper >= best[found.count]);
        CHECK(!found.proven_optimal || found.value == best[found.count]);
        CHECK_TEXT(found.guarantee, "none");
        for (size_t i = 0; i < found.curve_points; ++i) {
            const murk_curve_point *p = &found.curve[i];
            CHECK(best[p->count] == UINT64_MAX || p->upper >= best[p->count]);
            CHECK(best[p->count] == UINT64_MAX || p->value <= best[p->count]);
        }
        if (found.count <= found.fewest) {
            CHECK(found.count == fewest);
            ++t->proven;
        } else {
            /* with enough work small problems always come out proven */
            CHECK(nodes == 0 || method == MURK_PLACE_GREEDY);
            ++t->unproven;
        }
        ++t->solved;
    }
    murk_place_release(&found);
    murk_matrix_destroy(matrix);
}

static const murk_place_method methods[] = {MURK_PLACE_BEST, MURK_PLACE_EXACT,
                                            MURK_PLACE_GREEDY};

static void test_brute_force(void)
{
    tally t = {0};
    for (uint32_t i = 0; i < 240; ++i) {
        made_up *m =
            made_up_create(100 + i, 40 + i % 90, 6 + i % 5, i % 3 ? .4 : .6,
                           i % 2 ? 1 : 900, 1 + i % 4, 1);
        const size_t k = 1 + i % 4;
        const uint64_t all =
            strict_of(m, (UINT32_C(1) << m->problem.candidates) - 1, k);
        const uint64_t target = all / 10 * (5 + i % 5) + 1;
        if (all > 0) {
            try_one(m, NULL, k, target, methods[i % 7 ? i % 2 : 2],
                    i % 5 ? 1000000 : 0, &t);
        }
        made_up_destroy(m);
    }
    CHECK(t.solved > 230);
    CHECK(t.proven > 180);
    CHECK(t.unproven > 0); /* the other branch is met, too */
}

static void test_constraints(void)
{
    static const unsigned kinds[] = {
        CAPS, MIN, FIXED, SITES, SPACING, LIST, CAPS | MIN | FIXED};
    tally t = {0};
    for (uint32_t i = 0; i < 140; ++i) {
        made_up *m = made_up_create(900 + i, 60, 8, .5, 1, 1 + i % 3, 1);
        made_up_constraints constraints;
        made_up_constraints_fill(&constraints, i, kinds[i % 7], 8);
        uint64_t best[MADE_UP_MAX + 1], max = 0;
        find_optima(m, &constraints, 2, best);
        for (size_t n = 0; n <= MADE_UP_MAX; ++n) {
            max = best[n] != UINT64_MAX && best[n] > max ? best[n] : max;
        }
        if (max > 0) {
            try_one(m, &constraints, 2,
                    i % 10 ? max / 10 * (6 + i % 4) + 1 : max, methods[i % 2],
                    i % 4 ? 1000000 : 0, &t);
        }
        made_up_destroy(m);
    }
    CHECK(t.solved > 70);
    CHECK(t.proven > 60);
}

/* What cannot be is refused, with what all see together. */
static void test_too_much(void)
{
    made_up *m = made_up_create(7, 50, 6, .3, 1, 1, 1);
    tally t = {0};
    const uint64_t all = strict_of(m, 63, 2);
    try_one(m, NULL, 2, all + 1, MURK_PLACE_BEST, 1000, &t);
    CHECK(t.refused == 1);
    try_one(m, NULL, 2, all, MURK_PLACE_BEST, 1000000, &t);
    CHECK(t.proven == 1);
    try_one(m, NULL, 9, 1, MURK_PLACE_BEST, 1000, &t); /* of 6 candidates */
    CHECK(t.refused == 2);
    made_up_destroy(m);
}

int main(void)
{
    test_brute_force();
    test_constraints();
    test_too_much();
    return check_done();
}
