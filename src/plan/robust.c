/* Robustness of a plan. The coverage that is left without a sensor is the total
 * minus the coverage that only this sensor adds. For the coverage of sensors
 * that are installed with errors, position and direction of each sensor are
 * drawn at random many times (sensing/jitter.h). The confidence interval of the
 * QUANTILE of these coverages assumes no distribution: its limits are two of
 * the sorted coverages, whose ranks follow from the binomial distribution
 * (base/quantile.h). The links between sensors are those of sensing/links.h. */
#include "plan/robust.h"

#include "base/progress.h"
#include "base/quantile.h"
#include "sensing/jitter.h"

#include <stdlib.h>

/* The reported quantile: one draw in twenty covers less. */
#define QUANTILE 0.05
/* Probability that the quantile lies beyond one limit: 95 % between both. */
#define MISS 0.025

static murk_status no_memory(size_t n, murk_error *err)
{
    return murk_no_memory(err, "", "for how robust %zu sensors are", n);
}

/* ---- each sensor ---- */

/* out[n]: the total without the share that only this sensor covers. NULL when
 * out of memory. */
static double *without_each(const murk_coverage_result *coverage, size_t n)
{
    double *out = malloc(n * sizeof *out + 1);
    for (size_t i = 0; out && i < n; ++i) {
        out[i] = coverage->total.value - coverage->only_it_covers[i];
    }
    return out;
}

murk_status murk_robust_begin(murk_robust *robust, const murk_stage *stage,
                              const murk_pose *pose, size_t n,
                              const murk_coverage_result *coverage,
                              murk_error *err)
{
    *robust = (murk_robust){.sensors = n,
                            .without = without_each(coverage, n),
                            .total = coverage->total.value,
                            .total_held_out = NAN};
    return robust->without
               ? murk_links_find(
                     &robust->links, pose, n, stage->surfaces,
                     &stage->world.domain,
                     stage->scene->placement.through != MURK_SCENE_BLOCK, err)
               : no_memory(n, err);
}

murk_status murk_robust_hold_out(murk_robust *robust,
                                 const murk_coverage_result *coverage,
                                 murk_error *err)
{
    robust->without_held_out = without_each(coverage, robust->sensors);
    robust->total_held_out = coverage->total.value;
    return robust->without_held_out ? MURK_OK : no_memory(robust->sensors, err);
}

murk_drop_one murk_robust_drop_one(const murk_robust *robust)
{
    const bool held_out = robust->without_held_out != NULL;
    const double *without =
        held_out ? robust->without_held_out : robust->without;
    const double total = held_out ? robust->total_held_out : robust->total;
    murk_drop_one out = {.worst_loss = NAN, .mean_loss = NAN};
    double sum = 0;
    for (size_t i = 0; i < robust->sensors; ++i) {
        const double loss = total - without[i];
        sum += loss;
        if (i == 0 || loss > out.worst_loss) {
            out.worst = i;
            out.worst_loss = loss;
        }
    }
    if (robust->sensors > 0) {
        out.mean_loss = sum / (double)robust->sensors;
    }
    return out;
}

/* ---- jitter ---- */

size_t murk_robust_draws(const murk_scene_desc *scene)
{
    const murk_scene_placement *settings = &scene->placement;
    return settings->jitter_m > 0 || settings->jitter_rad > 0
               ? (size_t)settings->jitter_draws
               : 0;
}

murk_status murk_robust_draw(murk_estimate *covered, size_t *unmoved,
                             const murk_stage *stage, murk_sight *sight,
                             const murk_pose *pose, size_t n, murk_error *err)
{
    const murk_scene_placement *settings = &stage->scene->placement;
    const murk_jitter jitter = {.step_m = settings->jitter_m,
                                .turn_rad = settings->jitter_rad,
                                .seed = stage->scene->seed,
                                .surfaces = stage->surfaces,
                                .domain = &stage->world.domain,
                                .north = stage->scene->north};
    const murk_sensor_type *type = murk_sight_described(sight)->type;
    const size_t draws = murk_robust_draws(stage->scene);
    murk_pose *moved = malloc(n * sizeof *moved + 1);
    murk_status status = moved ? MURK_OK : no_memory(n, err);
    *unmoved = 0;
    murk_progress_begin("jitter", draws, "draws");
    for (size_t d = 0; d < draws && !status; ++d) {
        murk_coverage_result c = {0};
        *unmoved += murk_jitter_draw(moved, pose, n, type, &jitter, d);
        status = murk_coverage_result_measure(&c, sight, moved, n, err);
        covered[d] = c.total;
        if (settings->targets.points) { /* a list is complete, not a sample */
            covered[d].standard_error = 0;
        }
        murk_coverage_result_release(&c);
        murk_progress_add(1);
    }
    murk_progress_end();
    free(moved);
    return status;
}

/* The error of the mean by photons is at most the mean of the errors of the
 * draws, because all draws use the same photons (Minkowski's inequality). */
murk_status murk_robust_summarise(murk_robust *robust,
                                  const murk_estimate *covered, size_t draws,
                                  size_t unmoved, double as_planned,
                                  bool on_held_out, murk_error *err)
{
    double *x = malloc(draws * sizeof *x), errors = 0;
    if (!x) {
        return no_memory(robust->sensors, err);
    }
    /* Collect the coverage of the draws and the sum of the standard errors. */
    for (size_t d = 0; d < draws; ++d) {
        x[d] = covered[d].value;
        errors += covered[d].standard_error;
    }
    /* Mean with both errors. */
    const murk_order_statistics rank =
        murk_quantile_ranks(draws, QUANTILE, MISS);
    murk_jittered out = {.draws = draws,
                         .on_held_out = on_held_out,
                         .as_planned = as_planned,
                         .mean = murk_mean_estimate(x, draws),
                         .unmoved = unmoved};
    out.mean.standard_error =
        hypot(out.mean.standard_error, errors / (double)draws);
    /* Quantile and confidence interval by rank. */
    murk_sort(x, draws);
    out.quantile = x[rank.value - 1];
    out.quantile_lower = rank.lower ? x[rank.lower - 1] : NAN;
    out.quantile_upper = rank.upper ? x[rank.upper - 1] : NAN;
    robust->jittered = out;
    free(x);
    return MURK_OK;
}

murk_status murk_robust_jitter(murk_robust *robust, const murk_stage *stage,
                               murk_sight *sight, const murk_pose *pose,
                               const murk_coverage_result *coverage,
                               bool on_held_out, murk_error *err)
{
    const size_t draws = murk_robust_draws(stage->scene);
    if (draws == 0 || robust->sensors == 0) {
        return MURK_OK;
    }
    murk_estimate *covered = malloc(draws * sizeof *covered);
    size_t unmoved = 0;
    murk_status status = covered
                             ? murk_robust_draw(covered, &unmoved, stage, sight,
                                                pose, robust->sensors, err)
                             : no_memory(robust->sensors, err);
    if (!status) {
        status = murk_robust_summarise(robust, covered, draws, unmoved,
                                       coverage->total.value, on_held_out, err);
    }
    free(covered);
    return status;
}

void murk_robust_release(murk_robust *robust)
{
    free(robust->without);
    free(robust->without_held_out);
    murk_links_release(&robust->links);
    *robust = (murk_robust){0};
}
