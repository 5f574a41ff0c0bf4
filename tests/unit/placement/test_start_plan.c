/* Searches that begin at a given plan: by brute force on small made-up
 * problems. A good start stays, a poor one is improved, one that breaks
 * constraints is repaired, and no result depends on the threads. Nothing here
 * is random but the fixed seeds. */
#include "placement/at_least.h"
#include "placement/worst.h"

#include "check.h"
#include "made_up_rules.h"

#define MATRIX_MAX ((uint64_t)1 << 32)
#define PHOTONS    120
#define SENSORS    3

static const murk_place_method METHODS[] = {MURK_PLACE_SPOQ, MURK_PLACE_GREEDY,
                                            MURK_PLACE_BEST, MURK_PLACE_EXACT};

static murk_place_desc desc_of(murk_place_method method, size_t count,
                               const uint32_t *start, size_t size)
{
    murk_place_desc desc = murk_place_defaults();
    desc.method = method;
    desc.count = count;
    desc.start_plan = start;
    desc.start_size = size;
    return desc;
}

static murk_status try_place(murk_place_result *out, const made_up *m,
                             const murk_place_desc *desc, bool known)
{
    murk_error err = {0};
    murk_matrix *matrix = NULL;
    if (known) {
        CHECK(!murk_matrix_create(&matrix, &m->problem, MATRIX_MAX, &err));
    }
    const murk_status status =
        murk_place_sensors(out, &m->problem, matrix, desc, &err);
    murk_matrix_destroy(matrix);
    return status;
}

static murk_place_result place(const made_up *m, const murk_place_desc *desc,
                               bool known)
{
    murk_place_result result = {0};
    CHECK(try_place(&result, m, desc, known) == MURK_OK);
    return result;
}

/* The candidates of a set, in falling order. Returns their number. */
static size_t list_of(uint32_t set, uint32_t *list)
{
    size_t n = 0;
    for (uint32_t j = 32; j-- > 0;) {
        if (set >> j & 1) {
            list[n++] = j;
        }
    }
    return n;
}

/* A set of the largest value of all sets of n. */
static uint32_t best_set(const made_up *m, size_t n)
{
    uint32_t best = 0;
    uint64_t value = 0;
    for (uint32_t set = 1; set < 1u << m->problem.candidates; ++set) {
        if ((size_t)__builtin_popcount(set) == n &&
            (best == 0 || made_up_set_value(m, set) > value)) {
            best = set;
            value = made_up_set_value(m, set);
        }
    }
    return best;
}

/* A random order of all candidates. */
static void shuffled(uint32_t *list, size_t n, uint32_t seed)
{
    for (uint32_t k = 0; k < n; ++k) {
        const uint32_t at = made_up_draw(seed, 20, k, k + 1);
        list[k] = list[at];
        list[at] = k;
    }
}

/* The optimum as the start is the result, whatever greedy finds, and takes less
 * work than without a start. In some of these problems greedy alone finds a
 * plan of less value. */
static void test_a_good_start_stays(uint32_t seed)
{
    int better_than_greedy = 0;
    uint64_t work = 0, plain_work = 0;
    for (uint32_t k = 0; k < 30; ++k) {
        made_up *m = made_up_create(seed + k, PHOTONS, MADE_UP_MAX, 0.3,
                                    k % 2 ? 1 : 50, 3, 1);
        uint32_t start[SENSORS];
        const uint32_t best = best_set(m, SENSORS);
        const size_t n = list_of(best, start);
        /* With and without the start, in both environments. */
        for (int known = 0; known < 2; ++known) {
            const murk_place_desc from =
                desc_of(MURK_PLACE_BEST, SENSORS, start, n);
            const murk_place_desc plain =
                desc_of(MURK_PLACE_BEST, SENSORS, NULL, 0);
            murk_place_result a = place(m, &from, known);
            murk_place_result b = place(m, &plain, known);
            CHECK(made_up_set(&a) == best);
            CHECK(a.value == made_up_set_value(m, best));
            CHECK(a.upper >= a.value && a.started_from == n);
            CHECK(a.restarts == 0 && a.nodes == 0);
            work += a.evaluations;
            plain_work += b.evaluations;
            CHECK(b.started_from == 0);
            murk_place_release(&a);
            murk_place_release(&b);
        }
        const murk_place_desc alone =
            desc_of(MURK_PLACE_GREEDY, SENSORS, NULL, 0);
        murk_place_result greedy = place(m, &alone, true);
        better_than_greedy += greedy.value < made_up_set_value(m, best);
        murk_place_release(&greedy);
        made_up_destroy(m);
    }
    printf("greedy alone misses %d of 30 optima; %.2g of the work\n",
           better_than_greedy, (double)work / (double)plain_work);
    CHECK(better_than_greedy >= 3);
    CHECK(work < plain_work);
}

/* Candidates 6..11 are copies of 0..5. A start among the copies is not moved to
 * the originals, which are worth as much. */
static void test_a_start_stays_on_ties(uint32_t seed)
{
    made_up *m = made_up_create(seed, PHOTONS, MADE_UP_MAX, 0.4, 50, 3, 1);
    for (size_t j = 6; j < MADE_UP_MAX; ++j) {
        memcpy(m->clarity + j * PHOTONS, m->clarity + (j - 6) * PHOTONS,
               PHOTONS * sizeof *m->clarity);
    }
    /* the best set of the originals, moved to the copies */
    uint32_t best = 0;
    for (uint32_t set = 1; set < 1u << 6; ++set) {
        if (__builtin_popcount(set) == SENSORS &&
            (!best || made_up_set_value(m, set) > made_up_set_value(m, best))) {
            best = set;
        }
    }
    uint32_t start[SENSORS];
    const size_t n = list_of(best << 6, start);
    const murk_place_desc desc = desc_of(MURK_PLACE_BEST, SENSORS, start, n);
    murk_place_result plan = place(m, &desc, true);
    CHECK(made_up_set(&plan) == best << 6);
    murk_place_release(&plan);
    made_up_destroy(m);
}

/* The largest value that moving one sensor of the set leads to. */
static uint64_t best_move(const made_up *m, uint32_t set)
{
    uint64_t best = 0;
    for (size_t i = 0; i < m->problem.candidates; ++i) {
        for (size_t j = 0; j < m->problem.candidates && (set >> i & 1); ++j) {
            const uint32_t moved = (set & ~(1u << i)) | 1u << j;
            const uint64_t value = made_up_set_value(m, moved);
            best = value > best ? value : best;
        }
    }
    return best;
}

/* From any start, of any length: the plan is worth at least the start and
 * greedy's plan, and no single move improves it. */
static void test_any_start_is_improved(uint32_t seed)
{
    int improved = 0;
    for (uint32_t k = 0; k < 20; ++k) {
        made_up *m =
            made_up_create(seed + k, PHOTONS, MADE_UP_MAX, 0.3, 50, 3, 1);
        const murk_place_desc alone =
            desc_of(MURK_PLACE_GREEDY, SENSORS, NULL, 0);
        murk_place_result greedy = place(m, &alone, true);
        uint32_t start[MADE_UP_MAX];
        shuffled(start, MADE_UP_MAX, seed + k);
        /* Starts that are too short, complete and too long. */
        for (size_t size = 0; size <= 5; ++size) {
            const size_t taken = size < SENSORS ? size : SENSORS;
            uint32_t begun = 0;
            for (size_t i = 0; i < taken; ++i) {
                begun |= 1u << start[i];
            }
            const murk_place_desc desc =
                desc_of(MURK_PLACE_BEST, SENSORS, start, size);
            murk_place_result known = place(m, &desc, true);
            murk_place_result unknown = place(m, &desc, false);
            const uint64_t first = made_up_set_value(m, begun);
            CHECK(known.started_from == taken);
            CHECK(known.value >= greedy.value && known.value >= first);
            CHECK(known.value == best_move(m, made_up_set(&known)));
            CHECK(made_up_set(&known) == made_up_set(&unknown));
            improved += taken == SENSORS && known.value > first;
            murk_place_release(&known);
            murk_place_release(&unknown);
        }
        murk_place_release(&greedy);
        made_up_destroy(m);
    }
    CHECK(improved > 20);
}

/* Of a start that is too long the first sensors are taken: with the optimum
 * first, the rest is of no use. */
static void test_the_first_of_a_long_start_are_taken(uint32_t seed)
{
    made_up *m = made_up_create(seed, PHOTONS, MADE_UP_MAX, 0.3, 50, 3, 1);
    const uint32_t best = best_set(m, SENSORS);
    uint32_t start[MADE_UP_MAX];
    size_t n = list_of(best, start);
    n += list_of(~best & ((1u << MADE_UP_MAX) - 1), start + n);
    for (size_t i = 0; i < sizeof METHODS / sizeof *METHODS; ++i) {
        const murk_place_desc desc = desc_of(METHODS[i], SENSORS, start, n);
        murk_place_result plan = place(m, &desc, true);
        const bool is_greedy = METHODS[i] == MURK_PLACE_GREEDY;
        CHECK(plan.started_from == (is_greedy ? 0 : SENSORS));
        CHECK(is_greedy || plan.value == made_up_set_value(m, best));
        CHECK(plan.restarts == (METHODS[i] == MURK_PLACE_SPOQ ? 1 : 0));
        murk_place_release(&plan);
    }
    made_up_destroy(m);
}

/* Under constraints of every kind, from starts that break them: the plan keeps
 * them, is worth at least greedy's, and the bound holds. Exact finds the
 * optimum. */
static void try_constrained(const made_up *m, const made_up_constraints *r,
                            const uint64_t *best, const uint32_t *start,
                            size_t size, int *plans)
{
    const uint64_t optimum = made_up_ruled_optimum(r, best, SENSORS);
    murk_place_desc alone = desc_of(MURK_PLACE_GREEDY, SENSORS, NULL, 0);
    murk_place_result greedy = {0};
    alone.constraints = &r->constraints;
    if (try_place(&greedy, m, &alone, true)) {
        return; /* the constraints admit no plan */
    }
    for (size_t i = 0; i < sizeof METHODS / sizeof *METHODS; ++i) {
        murk_place_desc desc = desc_of(METHODS[i], SENSORS, start, size);
        desc.constraints = &r->constraints;
        murk_place_result plan = place(m, &desc, true);
        CHECK(made_up_keeps(r, made_up_set(&plan)));
        CHECK(plan.value == made_up_set_value(m, made_up_set(&plan)));
        CHECK(plan.value <= optimum && plan.upper >= optimum);
        CHECK(METHODS[i] == MURK_PLACE_SPOQ || plan.value >= greedy.value);
        CHECK(METHODS[i] != MURK_PLACE_EXACT || plan.value == optimum);
        CHECK(plan.started_from <= SENSORS);
        ++*plans;
        murk_place_release(&plan);
    }
    murk_place_release(&greedy);
}

static void test_constraints_hold(uint32_t seed)
{
    int plans = 0;
    for (uint32_t k = 0; k < 49; ++k) {
        const unsigned kinds =
            k < KINDS ? 1u << k : 1u << k % KINDS | 1u << k / KINDS;
        made_up *m =
            made_up_create(seed + k, PHOTONS / 2, MADE_UP_MAX, 0.3, 20, 3, 1);
        made_up_constraints r;
        uint64_t best[MADE_UP_MAX + 1];
        uint32_t start[MADE_UP_MAX];
        made_up_constraints_fill(&r, seed + k, kinds & ((1u << KINDS) - 1),
                                 MADE_UP_MAX);
        made_up_ruled_optima(m, &r, best);
        shuffled(start, MADE_UP_MAX, seed + k);
        try_constrained(m, &r, best, start, k % 2 ? SENSORS : MADE_UP_MAX,
                        &plans);
        made_up_destroy(m);
    }
    printf("%d plans under constraints\n", plans);
    CHECK(plans > 100);
}

/* A sensor that breaks the spacing is left out, in the order of the list, and
 * greedy adds another. Candidates 0 and 1 are at one position. */
static void test_a_conflict_is_left_out(uint32_t seed)
{
    static const double position_m[4][3] = {{0}, {0}, {5}, {9}};
    const murk_constraints spaced = {.position_m = position_m, .spacing_m = 1};
    made_up *m = made_up_create(seed, PHOTONS, 4, 0.3, 50, 3, 1);
    static const uint32_t start[] = {1, 0, 3};
    murk_place_desc desc = desc_of(MURK_PLACE_BEST, SENSORS, start, 3);
    desc.constraints = &spaced;
    murk_place_result plan = place(m, &desc, true);
    CHECK(plan.started_from == 2);
    CHECK(plan.count == SENSORS && made_up_set(&plan) >> 2 == 3);
    murk_place_release(&plan);
    made_up_destroy(m);
}

/* With a target each count begins at the start. */
static void test_a_target(uint32_t seed)
{
    made_up *m = made_up_create(seed, PHOTONS, MADE_UP_MAX, 0.3, 50, 3, 1);
    const uint32_t best = best_set(m, SENSORS);
    uint32_t start[SENSORS];
    const size_t n = list_of(best, start);
    murk_place_desc desc = desc_of(MURK_PLACE_BEST, MADE_UP_MAX, start, n);
    desc.target = made_up_set_value(m, best);
    murk_place_result plan = place(m, &desc, true);
    CHECK(plan.count == SENSORS && plan.value == desc.target);
    CHECK(plan.started_from == SENSORS && plan.nodes == 0);
    murk_place_release(&plan);
    made_up_destroy(m);
}

/* The same result for 1, 2 and 5 threads. */
static void test_threads(uint32_t seed)
{
    static const unsigned threads[] = {1, 2, 5};
    for (size_t i = 0; i < sizeof METHODS / sizeof *METHODS; ++i) {
        murk_place_result plan[3];
        for (size_t k = 0; k < 3; ++k) {
            made_up *m = made_up_create(seed, 600, 200, 0.1, 40, 3, threads[k]);
            uint32_t start[200];
            shuffled(start, 200, seed);
            const murk_place_desc desc = desc_of(METHODS[i], 6, start, 5);
            plan[k] = place(m, &desc, true);
            made_up_destroy(m);
        }
        for (size_t k = 1; k < 3; ++k) {
            CHECK(plan[k].value == plan[0].value);
            CHECK(plan[k].upper == plan[0].upper);
            CHECK(plan[k].evaluations == plan[0].evaluations);
            CHECK(memcmp(plan[k].sensor, plan[0].sensor,
                         6 * sizeof *plan[0].sensor) == 0);
            murk_place_release(&plan[k]);
        }
        murk_place_release(&plan[0]);
    }
}

/* The smallest share of two halves of the photons that the set covers. */
static uint64_t min_share(const made_up *m, const murk_blocks *blocks,
                          uint32_t set)
{
    uint64_t min = UINT64_MAX;
    uint32_t weight[PHOTONS];
    made_up part = *m;
    part.weight = weight;
    for (size_t c = 0; c < blocks->n; ++c) {
        uint64_t whole = 0;
        for (size_t i = 0; i < PHOTONS; ++i) {
            const bool is_in =
                i >= blocks->first[c] && i < blocks->first[c + 1];
            weight[i] = is_in ? m->weight[i] : 0;
            whole += (uint64_t)weight[i] * MURK_CLEAR;
        }
        const uint64_t share =
            murk_share_units(made_up_set_value(&part, set), whole);
        min = share < min ? share : min;
    }
    return min;
}

/* For the worst of two scenarios: the best start stays, another start is never
 * worse than greedy. */
static void test_worst(uint32_t seed)
{
    const murk_blocks blocks = {.n = 2, .first = {0, PHOTONS / 2, PHOTONS}};
    made_up *m = made_up_create(seed, PHOTONS, MADE_UP_MAX, 0.3, 50, 3, 1);
    /* The best set by brute force. */
    uint32_t best = 0;
    for (uint32_t set = 1; set < 1u << MADE_UP_MAX; ++set) {
        if (__builtin_popcount(set) == SENSORS &&
            min_share(m, &blocks, set) > min_share(m, &blocks, best)) {
            best = set;
        }
    }
    uint32_t start[MADE_UP_MAX];
    const size_t n = list_of(best, start);
    murk_error err = {0};
    murk_matrix *matrix = NULL;
    CHECK(!murk_matrix_create(&matrix, &m->problem, MATRIX_MAX, &err));
    for (size_t i = 0; i < sizeof METHODS / sizeof *METHODS; ++i) {
        const murk_place_desc desc = desc_of(METHODS[i], SENSORS, start, n);
        murk_place_result plan = {0};
        CHECK(!murk_place_worst(&plan, &m->problem, matrix, &blocks, &desc,
                                &err));
        const bool is_greedy = METHODS[i] == MURK_PLACE_GREEDY;
        CHECK(is_greedy || plan.value == min_share(m, &blocks, best));
        CHECK(plan.upper >= min_share(m, &blocks, best));
        CHECK(plan.started_from == (is_greedy ? 0 : SENSORS));
        CHECK(METHODS[i] != MURK_PLACE_BEST || plan.nodes == 0);
        murk_place_release(&plan);
    }
    murk_matrix_destroy(matrix);
    made_up_destroy(m);
}

/* Seen by two sensors or more: a start that meets the target is found, though
 * branch and bound does not run. */
static void test_at_least(uint32_t seed)
{
    for (uint32_t k = 0; k < 10; ++k) {
        made_up *m =
            made_up_create(seed + k, PHOTONS, MADE_UP_MAX, 0.4, 1, 3, 1);
        murk_at_least strict;
        murk_error err = {0};
        murk_matrix *matrix = NULL;
        murk_at_least_init(&strict, &m->problem, 2);
        CHECK(!murk_matrix_create(&matrix, &strict.problem, MATRIX_MAX, &err));
        murk_place_desc exact = desc_of(MURK_PLACE_EXACT, MADE_UP_MAX, NULL, 0);
        uint64_t whole = 0;
        for (size_t i = 0; i < PHOTONS; ++i) {
            whole += (uint64_t)m->weight[i] * MURK_CLEAR;
        }
        exact.target = whole * 6 / 10;
        /* The fewest sensors by branch and bound are the start. */
        murk_place_result best = {0}, plan = {0};
        CHECK(
            !murk_place_at_least(&best, &strict.problem, matrix, &exact, &err));
        uint32_t start[MADE_UP_MAX];
        const size_t n = list_of(made_up_set(&best), start);
        murk_place_desc desc = desc_of(MURK_PLACE_BEST, MADE_UP_MAX, start, n);
        desc.target = exact.target;
        CHECK(
            !murk_place_at_least(&plan, &strict.problem, matrix, &desc, &err));
        CHECK(plan.count == best.count && plan.value >= desc.target);
        CHECK(plan.nodes == 0);
        murk_place_release(&best);
        murk_place_release(&plan);
        murk_matrix_destroy(matrix);
        made_up_destroy(m);
    }
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_a_good_start_stays(seed);
    test_a_start_stays_on_ties(seed);
    test_any_start_is_improved(seed);
    test_the_first_of_a_long_start_are_taken(seed);
    test_constraints_hold(seed);
    test_a_conflict_is_left_out(seed);
    test_a_target(seed);
    test_threads(seed);
    test_worst(seed);
    test_at_least(seed);
    return check_done();
}
