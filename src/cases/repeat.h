/* Repeats the whole job with other seeds: how much the result depends on
 * chance.
 *
 * Run k is the job with the seed of the first run plus k: `murk place --seed`
 * of that seed gives the same plan. The plan under test is the plan of the
 * first run, which was chosen before any other run.
 *
 * The coverage of the best plan of a sample in that sample is too large: over
 * many samples the mean of its coverage in the sample is at least the largest
 * true coverage of any plan. So the mean of the upper bounds of the runs less
 * the true coverage of a plan is at least the optimality gap of that plan. Both
 * are measured on the map of each run, so that their common noise cancels (Mak,
 * Morton, Wood, Oper. Res. Lett. 24 (1999) 47,
 * doi:10.1016/S0167-6377(98)00054-6). The map of the first run chose the plan,
 * so for that run the plan is measured on the held-out map instead. */
#ifndef MURK_CASES_REPEAT_H
#define MURK_CASES_REPEAT_H

#include "cases/condition_plans.h"

/* Far more runs than a confidence interval gains from. */
#define MURK_REPEATS_MAX 10000

typedef struct murk_repeat_run {
    uint32_t seed;
    size_t sensors;
    double in_sample, upper; /* upper: bound on any plan of this sample; with
                              * the objective regret that of read_regret() in
                              * cases/condition_plans_make.c */
    bool proven_optimal;
    murk_estimate held_out; /* NaN: none */
    murk_estimate plan;     /* the first run's plan, on a map of this run that
                               had no part in choosing it; NaN: none */
} murk_repeat_run;

typedef struct murk_repeat {
    murk_repeat_run *run; /* [asked], the first `runs` of them finished */
    size_t runs, asked;
    double target; /* asked of every run; 0: none */
    /* True if the bounds of the runs estimate a gap. They do not with a target,
     * because runs then take different numbers of sensors, nor for the worst
     * condition or the largest regret: the coverage of the best plan of a
     * sample in its worst condition is too small in the mean, and so may be its
     * bound. */
    bool has_gap;
} murk_repeat;

/* The first run: a plan for the scene as it stands, or over conditions. */
typedef struct murk_repeat_first {
    const murk_plan_result *plan;
    const murk_stage *stage; /* NULL: conditions */
    const murk_condition_plans *over;
} murk_repeat_first;

/* The scene of the first run. */
const murk_scene_desc *murk_repeat_scene(const murk_repeat_first *first);

/* Begins the runs with the first one, asked >= 1. Fails with MURK_NO_MEMORY.
 * Release *out also then. */
murk_status murk_repeat_begin(murk_repeat *out, const murk_repeat_first *first,
                              size_t asked, murk_error *err);

/* Makes the asked - 1 further runs, except those for which is_left_out[asked]
 * is true, which are in out->run already or belong to another shard; NULL:
 * none. After a failure of a run or MURK_INTERRUPTED *out holds the runs that
 * were finished before. */
murk_status murk_repeat_make(murk_repeat *out, const murk_repeat_first *first,
                             const bool *is_left_out, unsigned threads,
                             murk_error *err);
void murk_repeat_release(murk_repeat *repeat);

typedef struct murk_spread {
    double median, min, max; /* NaN if a run has no such value */
} murk_spread;

/* The optimality gap with a confidence interval of 95 %, for normal
 * differences. Differences are skewed if most samples choose the same plan: in
 * a test with such worlds, the interval of 12 runs held the mean in 91 of 100
 * cases, and the true gap was below the upper end in all of them. */
typedef struct murk_gap {
    size_t runs; /* number of runs that measured the first plan; 0 without
                  * murk_repeat.has_gap; below 2: no limits */
    double value, lower, upper; /* mean of upper - plan, +- Student's t for
                                   runs - 1 degrees of freedom */
} murk_gap;

typedef struct murk_repeat_summary {
    murk_spread sensors, in_sample, held_out, upper;
    murk_estimate upper_mean, plan; /* means over the runs that have them */
    murk_gap gap;
    size_t met;  /* runs whose held-out coverage meets the target; 0 without a
                  * target */
    size_t best; /* number of the run with the greatest held-out coverage; the
                  * number of runs, if no run has one */
} murk_repeat_summary;

/* Sums up the finished runs, at least one. Fails with MURK_NO_MEMORY. */
murk_status murk_repeat_sum_up(murk_repeat_summary *out,
                               const murk_repeat *repeat, murk_error *err);

#endif
