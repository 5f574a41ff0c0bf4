/* The rule on moves from a start plan, by brute force on small made-up
 * problems: every method keeps the rule, no plan is better than the bound
 * allows, branch and bound finds the optimum, and a rule that allowed one more
 * move, or a bound that charged half a move too much, would be found out. All
 * randomness is that of the fixed seeds. */
#include "placement/place.h"

#include "check.h"
#include "made_up_rules.h"

#define MATRIX_MAX ((uint64_t)1 << 32)
#define PHOTONS    60
#define SENSORS    4
#define PROBLEMS   240

static const murk_place_method METHODS[] = {MURK_PLACE_SPOQ, MURK_PLACE_BEST,
                                            MURK_PLACE_EXACT};

static murk_status try_place(murk_place_result *out, const made_up *m,
                             const murk_place_desc *desc, bool known,
                             murk_error *err)
{
    murk_matrix *matrix = NULL;
    if (known) {
        CHECK(!murk_matrix_create(&matrix, &m->problem, MATRIX_MAX, err));
    }
    const murk_status status =
        murk_place_sensors(out, &m->problem, matrix, desc, err);
    murk_matrix_destroy(matrix);
    return status;
}

/* A start plan and a rule, by the plain meaning of the words. */
typedef struct rule {
    uint32_t start[MADE_UP_MAX];
    size_t size;
    uint32_t set; /* bit j: candidate j is in the start plan */
    uint32_t fixed;
    size_t moves_max;
    double cost; /* share of the whole */
} rule;

static int bits(uint32_t set)
{
    return __builtin_popcount(set);
}

/* Pairs of one sensor that comes and one that leaves. */
static size_t moves_of(const rule *r, uint32_t plan)
{
    const int come = bits(plan & ~r->set & ~r->fixed),
              leave = bits(r->set & ~plan & ~r->fixed);
    return (size_t)(come < leave ? come : leave);
}

static uint64_t whole_of(const made_up *m)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < m->problem.photons; ++i) {
        sum += m->weight[i];
    }
    return sum * MURK_CLEAR * murk_problem_layers(&m->problem);
}

/* The value less `moves` moves at a cost of the given share, rounded to a
 * multiple of the grain, which divides every weight: 3 here. */
static uint64_t less(const made_up *m, uint64_t value, double moves,
                     double share)
{
    const double grain = 3. * (m->is_binary ? MURK_CLEAR : 1);
    const double each = floor(share * (double)whole_of(m) / grain + .5) * grain;
    const double cost = floor(moves * each);
    return (double)value > cost ? value - (uint64_t)cost : 0;
}

static uint64_t objective(const made_up *m, const rule *r, uint32_t plan)
{
    return less(m, made_up_set_value(m, plan), (double)moves_of(r, plan),
                r->cost);
}

/* The best plan of n under the constraints and at most `moves_max` moves;
 * UINT64_MAX: there is none. */
static uint64_t best_of(const made_up *m, const made_up_constraints *c,
                        const rule *r, size_t n, size_t moves_max)
{
    uint64_t best = UINT64_MAX;
    for (uint32_t set = 1; set < 1u << m->problem.candidates; ++set) {
        if ((size_t)bits(set) == n && made_up_keeps(c, set) &&
            moves_of(r, set) <= moves_max) {
            const uint64_t value = objective(m, r, set);
            best = best == UINT64_MAX || value > best ? value : best;
        }
    }
    return best;
}

/* The value of the start plan and the `moves_max` largest gains over it. */
static uint64_t simple_bound(const made_up *m, const rule *r)
{
    const uint64_t at = made_up_set_value(m, r->set);
    uint64_t gain[MADE_UP_MAX], sum = at;
    for (size_t j = 0; j < MADE_UP_MAX; ++j) {
        gain[j] = made_up_set_value(m, r->set | 1u << j) - at;
    }
    for (size_t k = 0; k < r->moves_max && k < MADE_UP_MAX; ++k) {
        size_t top = k;
        for (size_t j = k + 1; j < MADE_UP_MAX; ++j) {
            top = gain[j] > gain[top] ? j : top;
        }
        sum += gain[top];
        gain[top] = gain[k];
    }
    return sum;
}

static void draw_rule(rule *r, const made_up_constraints *c, uint32_t seed)
{
    *r = (rule){.size = made_up_draw(seed, 30, 0, 4) == 0
                            ? made_up_draw(seed, 31, 0, 7)
                            : SENSORS};
    for (uint32_t k = 0; k < MADE_UP_MAX; ++k) {
        const uint32_t at = made_up_draw(seed, 32, k, k + 1);
        r->start[k] = r->start[at];
        r->start[at] = k;
    }
    for (size_t k = 0; k < r->size; ++k) {
        r->set |= 1u << r->start[k];
    }
    for (size_t k = 0; k < c->constraints.fixed_count; ++k) {
        r->fixed |= 1u << c->fixed[k];
    }
    r->moves_max = made_up_draw(seed, 33, 0, 4) == 0
                       ? SIZE_MAX
                       : made_up_draw(seed, 34, 0, 4);
    r->cost = made_up_draw(seed, 35, 0, 2) * .001 *
              (1 + made_up_draw(seed, 36, 0, 90));
}

/* Makes each candidate of the last half see some of what one of the first half
 * sees. */
static void dominate(const made_up *m, uint32_t seed)
{
    for (size_t j = MADE_UP_MAX / 2; j < MADE_UP_MAX; ++j) {
        const uint16_t *from = m->clarity + (j - MADE_UP_MAX / 2) * PHOTONS;
        uint16_t *to = m->clarity + j * PHOTONS;
        for (uint32_t i = 0; i < PHOTONS; ++i) {
            to[i] = made_up_draw(seed, 50 + (uint32_t)j, i, 6) ? from[i] : 0;
        }
    }
}

typedef struct tally {
    int plans, proven, not_best, tight, charged, moved, simple, sharper;
} tally;

/* One problem, one method. `best`: brute force; `more`: with one more move. */
static void try_method(const made_up *m, const made_up_constraints *c,
                       const rule *r, murk_place_method method, uint64_t best,
                       uint64_t more, tally *t)
{
    murk_place_desc desc = murk_place_defaults();
    murk_constraints constraints = c->constraints;
    murk_place_result plan = {0};
    murk_error err = {0};
    constraints.start = desc.start_plan = r->start;
    constraints.start_count = desc.start_size = r->size;
    constraints.moves_max = r->moves_max;
    constraints.move_cost = r->cost;
    desc.constraints = &constraints;
    desc.method = method;
    desc.count = SENSORS;
    const murk_status status = try_place(&plan, m, &desc, true, &err);
    CHECK((status == MURK_OK) == (best != UINT64_MAX));
    if (status) {
        return;
    }
    /* The plan and its figures. */
    const uint32_t set = made_up_set(&plan);
    const uint64_t value = objective(m, r, set);
    CHECK(plan.count == SENSORS && made_up_keeps(c, set));
    CHECK(plan.has_moves && plan.moves == moves_of(r, set));
    CHECK(plan.moves <= r->moves_max);
    CHECK(plan.value == made_up_set_value(m, set));
    CHECK(value ==
          (plan.value > plan.move_cost ? plan.value - plan.move_cost : 0));
    /* The bound and the optimum. */
    CHECK(value <= best);
    CHECK(best <= plan.upper + made_up_rounding(m));
    CHECK(method != MURK_PLACE_EXACT ||
          (value + made_up_rounding(m) >= best && plan.proven_optimal));
    const bool is_start = (size_t)bits(r->set) == SENSORS &&
                          (r->set & r->fixed) == r->fixed &&
                          made_up_keeps(c, r->set);
    CHECK(!is_start || value >= made_up_set_value(m, r->set));
    if (is_start && r->moves_max < SIZE_MAX && r->fixed == 0) {
        CHECK(plan.upper <= simple_bound(m, r) + made_up_rounding(m));
        ++t->simple;
        t->sharper += plan.upper < simple_bound(m, r);
    }
    /* Points of the curve have bounds of their own. */
    for (size_t k = 0; k < plan.curve_points; ++k) {
        const uint64_t optimum =
            best_of(m, c, r, plan.curve[k].count, r->moves_max);
        CHECK(optimum == UINT64_MAX ||
              (plan.curve[k].value <= optimum &&
               optimum <= plan.curve[k].upper + made_up_rounding(m)));
    }
    ++t->plans;
    t->moved += plan.moves > 0;
    t->proven += plan.proven_optimal;
    t->not_best += value < best;
    /* Slightly wrong rules would show. */
    t->tight += more > plan.upper;
    t->charged +=
        plan.moves > 0 && plan.proven_optimal &&
        less(m, plan.value, (double)plan.moves - .5, r->cost) > plan.upper;
    murk_place_release(&plan);
}

static void test_moves(uint32_t seed)
{
    tally t[3] = {{0}};
    for (uint32_t k = 0; k < PROBLEMS; ++k) {
        /* Half of the problems have other constraints as well; some count
         * several sensors, or chances. */
        static const unsigned KIND[] = {CAPS, MIN, FIXED, SITES, SPACING, LIST};
        const unsigned kinds =
            k % 2 ? KIND[k / 2 % 6] | (k % 3 ? 0 : KIND[k / 12 % 6]) : 0;
        made_up *m =
            made_up_create(seed + k, PHOTONS, MADE_UP_MAX, k % 7 ? .25 : .1,
                           k % 5 ? 30 : 1, 3, k % 3 ? 1 : 2);
        made_up_constraints c;
        rule r;
        if (k % 11 == 3) {
            m->problem.redundancy = 2;
        } else if (k % 11 == 5 && k % 5) {
            m->problem.combining = MURK_COMBINE_INDEPENDENT;
        }
        if (k % 4 < 2) {
            dominate(m, seed + k);
        }
        made_up_constraints_fill(&c, seed + k, kinds, MADE_UP_MAX);
        draw_rule(&r, &c, seed + k);
        const uint64_t best = best_of(m, &c, &r, SENSORS, r.moves_max);
        const uint64_t more = r.moves_max < SIZE_MAX
                                  ? best_of(m, &c, &r, SENSORS, r.moves_max + 1)
                                  : best;
        for (size_t i = 0; i < 3; ++i) {
            try_method(m, &c, &r, METHODS[i], best, more, &t[i]);
        }
        made_up_destroy(m);
    }
    for (size_t i = 0; i < 3; ++i) {
        printf("%d plans, %d moved, %d proven, %d not the best; %d and %d of a "
               "slightly wrong rule; simple bound %d, of which sharper %d\n",
               t[i].plans, t[i].moved, t[i].proven, t[i].not_best, t[i].tight,
               t[i].charged, t[i].simple, t[i].sharper);
        CHECK(t[i].plans > PROBLEMS * 3 / 5 && t[i].moved > PROBLEMS / 4);
        CHECK(t[i].tight > PROBLEMS / 10);
    }
    CHECK(t[1].not_best <= t[0].not_best && t[2].charged > PROBLEMS / 20);
}

/* No cost and as many moves as sensors is no rule: the value of method exact is
 * that without it. */
static void test_no_rule(uint32_t seed)
{
    made_up *m = made_up_create(seed, PHOTONS, MADE_UP_MAX, .25, 30, 3, 1);
    static const uint32_t start[] = {0, 1, 2, 3};
    const murk_constraints free_moves = {
        .start = start, .start_count = SENSORS, .moves_max = SENSORS};
    for (int with = 0; with < 2; ++with) {
        murk_place_desc desc = murk_place_defaults();
        murk_place_result plan = {0};
        murk_error err = {0};
        desc.method = MURK_PLACE_EXACT;
        desc.count = SENSORS;
        desc.start_plan = start;
        desc.start_size = SENSORS;
        desc.constraints = with ? &free_moves : NULL;
        CHECK(!try_place(&plan, m, &desc, true, &err));
        CHECK(plan.value == made_up_optimum(m, SENSORS));
        CHECK(plan.has_moves == (with > 0) && plan.proven_optimal);
        murk_place_release(&plan);
    }
    made_up_destroy(m);
}

/* Settings that the rule cannot be kept with are refused in one line. */
static void test_refusals(uint32_t seed)
{
    made_up *m = made_up_create(seed, PHOTONS, MADE_UP_MAX, .25, 30, 3, 1);
    static const uint32_t start[] = {0, 1, 2, 3};
    static const int64_t cost[MADE_UP_MAX] = {1, 1, 1};
    static const struct {
        bool known, has_start, has_budget, has_target;
        murk_place_method method;
        double move_cost;
        const char *word;
    } CASES[] = {
        {false, true, false, false, MURK_PLACE_BEST, 0, "known"},
        {true, false, false, false, MURK_PLACE_BEST, 0, "a start plan"},
        {true, true, true, false, MURK_PLACE_BEST, 0, "budget"},
        {true, true, false, false, MURK_PLACE_GREEDY, 0, "method"},
        {true, true, false, true, MURK_PLACE_BEST, .1, "target"},
        {true, true, false, false, MURK_PLACE_BEST, 1.5, "0..1"},
    };
    /* Place by each of them. */
    for (size_t i = 0; i < sizeof CASES / sizeof *CASES; ++i) {
        const murk_constraints rules = {.start = start,
                                        .start_count = 4,
                                        .moves_max = 1,
                                        .move_cost = CASES[i].move_cost,
                                        .cost = cost,
                                        .budget = CASES[i].has_budget ? 5 : 0};
        murk_place_desc desc = murk_place_defaults();
        murk_place_result plan = {0};
        murk_error err = {0};
        desc.constraints = &rules;
        desc.count = SENSORS;
        desc.method = CASES[i].method;
        desc.start_plan = CASES[i].has_start ? start : NULL;
        desc.start_size = CASES[i].has_start ? 4 : 0;
        desc.target = CASES[i].has_target ? 1 : 0;
        CHECK(try_place(&plan, m, &desc, CASES[i].known, &err) ==
              MURK_BAD_VALUE);
        CHECK(strstr(err.text, CASES[i].word) && !strchr(err.text, '\n'));
    }
    made_up_destroy(m);
}

/* The same plan, bound and counts for 1, 2 and 5 threads. */
static void test_threads(uint32_t seed)
{
    static const unsigned threads[] = {1, 2, 5};
    for (size_t i = 0; i < 3; ++i) {
        murk_place_result plan[3] = {{0}};
        for (size_t k = 0; k < 3; ++k) {
            made_up *m = made_up_create(seed, 600, 200, .1, 40, 3, threads[k]);
            static const uint32_t start[] = {7, 19, 50, 120, 121, 199};
            const murk_constraints rules = {.start = start,
                                            .start_count = 6,
                                            .moves_max = 2,
                                            .move_cost = .002};
            murk_place_desc desc = murk_place_defaults();
            murk_error err = {0};
            desc.constraints = &rules;
            desc.method = METHODS[i];
            desc.count = 6;
            desc.nodes = 20000;
            desc.start_plan = start;
            desc.start_size = 6;
            CHECK(!try_place(&plan[k], m, &desc, true, &err));
            made_up_destroy(m);
        }
        /* Compare all with the first. */
        for (size_t k = 0; k < 3; ++k) {
            CHECK(plan[k].moves == 2);
            CHECK(plan[k].value == plan[0].value &&
                  plan[k].upper == plan[0].upper &&
                  plan[k].evaluations == plan[0].evaluations &&
                  plan[k].nodes == plan[0].nodes);
            CHECK(!memcmp(plan[k].sensor, plan[0].sensor,
                          6 * sizeof *plan[k].sensor));
        }
        for (size_t k = 0; k < 3; ++k) {
            murk_place_release(&plan[k]);
        }
    }
}

int main(void)
{
    test_moves(1000);
    test_no_rule(1);
    test_refusals(2);
    test_threads(3);
    return check_done();
}
