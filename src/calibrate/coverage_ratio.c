#include "calibrate/coverage_ratio.h"

#include <math.h>

#define MAPS MURK_MAP_PARTS

bool murk_coverage_mix_of(murk_coverage_mix *out,
                          const murk_map_weights *weights,
                          const double all[MURK_MAP_PARTS])
{
    const double surface = all[MURK_SURFACE_PART];
    const double volume = all[MURK_VOLUME_PART];
    if (!(isfinite(surface) && isfinite(volume))) {
        return false;
    }
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

/* What seen and all, added to X and Y by map, add to C to first order. ratio[]
 * are the fractions that Y counts for. */
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
    const size_t keys = sums->keys, runs = sums->runs;
    const double *seen = sums->in_view + group * sums->batches * MAPS;
    const double *of = sums->in_view_slope + group * runs * MAPS * keys;
    double ratio[MAPS];
    *value = find_ratios(ratio, seen, sums->batches, mix);
    for (size_t k = 0; k < keys; ++k) {
        double seen_slope[MAPS] = {0}, all_slope[MAPS] = {0};
        for (size_t i = 0; i < runs * MAPS; ++i) {
            seen_slope[i % MAPS] += of[i * keys + k];
            all_slope[i % MAPS] += sums->all_slope[i * keys + k];
        }
        slope[k] = linearised(mix, ratio, seen_slope, all_slope);
    }
    for (size_t b = 0; batch && b < sums->batches; ++b) {
        batch[b * stride] =
            *value / (double)sums->batches +
            linearised(mix, ratio, seen + b * MAPS, sums->all + b * MAPS);
    }
}
