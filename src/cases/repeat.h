/* The whole job again with other seeds: how far its result hangs on chance.
 *
 * Run k is the job of seed + k, by itself: `murk place --seed` of it gives the
 * same. The plan is that of the first run, chosen before any other was seen.
 *
 * The best plan of a sample reads high, in the mean over samples at least as
 * high as the best plan truly covers; so the mean of the runs' upper bounds
 * less what the plan truly covers is at least the plan's distance from the
 * best. Both are measured on each run's map, so that the noise they share goes
 * (Mak, Morton, Wood, Oper. Res. Lett. 24 (1999) 47,
 * doi:10.1016/S0167-6377(98)00054-6). The first run's own map chose the plan:
 * its held-out map stands in there. */
#ifndef MURK_CASES_REPEAT_H
#define MURK_CASES_REPEAT_H

#include "cases/condition_plans.h"

#define MURK_REPEATS_MAX 10000

typedef struct murk_repeat_run {
    uint32_t seed;
    size_t sensors;
    double in_sample, upper; /* bound on any plan of this sample */
    bool proven_optimal;
    murk_estimate held_out; /* NaN: none */
    murk_estimate plan;     /* the first run's plan, on a map of this run that
                               had no part in choosing it; NaN: none */
} murk_repeat_run;

typedef struct murk_repeat {
    murk_repeat_run *run; /* [asked], the first `runs` of them finished */
    size_t runs, asked;
    double target; /* asked of every run; 0: none */
    bool has_gap;  /* a run's bound says what plans are truly worth: not with a
                      target, where runs take different numbers of sensors; nor
                      for the worst of conditions, where the best of a sample
                      may read low */
} murk_repeat;

/* The first run: a plan in a stage, or over conditions. */
typedef struct murk_repeat_first {
    const murk_plan_result *plan;
    const murk_stage *stage; /* NULL: conditions */
    const murk_condition_plans *over;
} murk_repeat_first;

/* Runs asked - 1 more jobs, asked >= 1. On a failure (of a run, or
 * MURK_INTERRUPTED) *out has what was finished before. Release it also then. */
murk_status murk_repeat_make(murk_repeat *out, const murk_repeat_first *first,
                             size_t asked, unsigned threads, murk_error *err);
void murk_repeat_release(murk_repeat *repeat);

typedef struct murk_spread {
    double median, min, max; /* NaN where a run has no such value */
} murk_spread;

/* 95 % confidence, if differences are normal. They are skewed where most
 * samples choose the same plan: 12 runs of such worlds held the mean 91 times
 * in a hundred, and the best plan lay below the upper end every time. */
typedef struct murk_gap {
    size_t runs; /* that have both of its parts; below 2 there are no limits */
    double value, lower, upper; /* mean of upper - plan, +- Student's t for
                                   runs - 1 degrees of freedom */
} murk_gap;

typedef struct murk_repeat_summary {
    murk_spread sensors, in_sample, held_out, upper;
    murk_estimate upper_mean, plan; /* means over the runs that have them */
    murk_gap gap;
    size_t met;  /* runs whose held-out coverage meets the target */
    size_t best; /* run of the greatest held-out coverage; runs: none */
} murk_repeat_summary;

/* Of the finished runs, at least one. */
murk_status murk_repeat_sum_up(murk_repeat_summary *out,
                               const murk_repeat *repeat, murk_error *err);

#endif
