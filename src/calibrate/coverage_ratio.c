/* Ratio estimator of coverage with derivatives and with the contributions of
 * batches and runs of photons, whose covariance is that of the coverage. */
#include "calibrate/coverage_ratio.h"

#include <math.h>

#define MAPS MURK_MAP_PARTS /* number of photon maps */

bool murk_coverage_mix_of(murk_coverage_mix *out,
                          const murk_map_weights *weights,
                          const double all[MURK_MAP_PARTS])
{
    const double surface = all[MURK_SURFACE_PART];
    const double volume = all[MURK_VOLUME_PART];
    if (!(isfinite(surface) && isfinite(volume))) {
        return false;
    }
    /* Balanced: each map with weight counts equally. */
    if (weights->balanced) {
        const double each = surface > 0 && volume > 0 ? 0.5 : 1;
        *out = (murk_coverage_mix){
            .part = {surface > 0 ? each : 0, volume > 0 ? each : 0},
            .whole = {surface, volume}};
        return surface > 0 || volume > 0;
    }
    const double whole = weights->surface * surface + weights->volume * volume;
    *out = (murk_coverage_mix){.part = {weights->surface, weights->volume},
                               .whole = {whole, whole},
                               .is_one = true};
    return whole > 0;
}

/* The contribution to C, to first order, of weights seen[] and all[] that are
 * added to X and Y of the maps. ratio[] is from find_ratios(). */
static double linearised(const murk_coverage_mix *mix, const double ratio[MAPS],
                         const double seen[MAPS], const double all[MAPS])
{
    double sum = 0;
    for (int map = 0; map < MAPS; ++map) {
        if (mix->part[map] > 0) {
            sum += mix->part[map] * (seen[map] - ratio[map] * all[map]) /
                   mix->whole[map];
        }
    }
    return sum;
}

/* Fills ratio[] with X / Y of each map, or with the common ratio of both maps
 * if mix->is_one, and returns the coverage. */
static double find_ratios(double ratio[MAPS], const double *seen,
                          size_t batches, const murk_coverage_mix *mix)
{
    double total[MAPS] = {0}, value = 0;
    for (size_t i = 0; i < batches * MAPS; ++i) {
        total[i % MAPS] += seen[i];
    }
    for (int map = 0; map < MAPS; ++map) {
        ratio[map] = mix->part[map] > 0 ? total[map] / mix->whole[map] : 0;
        value += mix->part[map] * ratio[map];
    }
    if (mix->is_one) {
        for (int map = 0; map < MAPS; ++map) {
            ratio[map] = value;
        }
    }
    return value;
}

void murk_coverage_ratio(double *value, double *slope, double *batch,
                         size_t stride, size_t group,
                         const murk_coverage_sums *sums,
                         const murk_coverage_mix *mix)
{
    /* The coverage. */
    const size_t keys = sums->keys, runs = sums->runs;
    const double *seen = sums->in_view + group * sums->batches * MAPS;
    const double *of = sums->in_view_slope + group * runs * MAPS * keys;
    double ratio[MAPS];
    *value = find_ratios(ratio, seen, sums->batches, mix);
    /* Derivatives: sums over the runs. */
    for (size_t k = 0; k < keys; ++k) {
        double seen_slope[MAPS] = {0}, all_slope[MAPS] = {0};
        for (size_t i = 0; i < runs * MAPS; ++i) {
            seen_slope[i % MAPS] += of[i * keys + k];
            all_slope[i % MAPS] += sums->all_slope[i * keys + k];
        }
        slope[k] = linearised(mix, ratio, seen_slope, all_slope);
    }
    /* Contributions of the batches. */
    for (size_t b = 0; batch && b < sums->batches; ++b) {
        batch[b * stride] =
            *value / (double)sums->batches +
            linearised(mix, ratio, seen + b * MAPS, sums->all + b * MAPS);
    }
}

/* X and Y of a run, and their derivatives with respect to a key. */
typedef struct run_sums {
    double seen[MAPS], all[MAPS], seen_slope[MAPS], all_slope[MAPS];
} run_sums;

/* Adds the batches of a run. */
static void add_run(run_sums *to, const murk_coverage_sums *sums, size_t group,
                    size_t run, size_t k)
{
    const double *seen = sums->in_view + group * sums->batches * MAPS;
    const double *of =
        sums->in_view_slope + group * sums->runs * MAPS * sums->keys;
    const size_t first = run * sums->batches / sums->runs;
    const size_t last = (run + 1) * sums->batches / sums->runs;
    for (size_t b = first; b < last; ++b) {
        for (int map = 0; map < MAPS; ++map) {
            to->seen[map] += seen[b * MAPS + (size_t)map];
            to->all[map] += sums->all[b * MAPS + (size_t)map];
        }
    }
    for (int map = 0; map < MAPS; ++map) {
        const size_t at = (run * MAPS + (size_t)map) * sums->keys + k;
        to->seen_slope[map] += of[at];
        to->all_slope[map] += sums->all_slope[at];
    }
}

/* The contribution of a run to the derivative of the coverage, without the
 * equal share that each run gets of that derivative. turn[] and by_whole[] are
 * from turns_of(). */
static double slope_part(const run_sums *run, const double ratio[MAPS],
                         const double turn[MAPS], const murk_coverage_mix *mix,
                         const double by_whole[MAPS])
{
    double sum = 0;
    for (int map = 0; map < MAPS; ++map) {
        if (mix->part[map] > 0) {
            const double off = run->seen[map] - ratio[map] * run->all[map];
            sum += mix->part[map] / mix->whole[map] *
                   (run->seen_slope[map] - ratio[map] * run->all_slope[map] -
                    turn[map] * run->all[map] - off * by_whole[map]);
        }
    }
    return sum;
}

/* For each map, from the sums over all runs: turn[], the derivative of the
 * ratio X / Y with respect to the key, and by_whole[], the derivative of Y
 * divided by Y. If mix->is_one, both maps have those of their joint ratio. */
static void turns_of(double turn[MAPS], double by_whole[MAPS],
                     const run_sums *total, const double ratio[MAPS],
                     const murk_coverage_mix *mix)
{
    double all_turn = 0, all_whole = 0;
    for (int map = 0; map < MAPS; ++map) {
        const bool counts = mix->part[map] > 0;
        turn[map] = counts ? (total->seen_slope[map] -
                              ratio[map] * total->all_slope[map]) /
                                 mix->whole[map]
                           : 0;
        by_whole[map] = counts ? total->all_slope[map] / mix->whole[map] : 0;
        all_turn += mix->part[map] * turn[map];
        all_whole += mix->part[map] * by_whole[map];
    }
    for (int map = 0; map < MAPS && mix->is_one; ++map) {
        turn[map] = all_turn;
        by_whole[map] = all_whole;
    }
}

void murk_coverage_slope_parts(double *part, size_t stride, const double *slope,
                               size_t group, const murk_coverage_sums *sums,
                               const murk_coverage_mix *mix)
{
    double ratio[MAPS], turn[MAPS], by_whole[MAPS];
    (void)find_ratios(ratio, sums->in_view + group * sums->batches * MAPS,
                      sums->batches, mix);
    /* Sum over all runs, then the contribution of each. */
    for (size_t k = 0; k < sums->keys; ++k) {
        run_sums total = {{0}, {0}, {0}, {0}};
        for (size_t run = 0; run < sums->runs; ++run) {
            add_run(&total, sums, group, run, k);
        }
        turns_of(turn, by_whole, &total, ratio, mix);
        for (size_t run = 0; run < sums->runs; ++run) {
            run_sums one = {{0}, {0}, {0}, {0}};
            add_run(&one, sums, group, run, k);
            part[run * stride + k] =
                slope[k] / (double)sums->runs +
                slope_part(&one, ratio, turn, mix, by_whole);
        }
    }
}
