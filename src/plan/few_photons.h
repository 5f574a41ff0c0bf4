/* Warns where a map's share of the coverage rests on few photons.
 *
 * With `weights: balanced` both maps count alike, however few photons one of
 * them has: a handful in a faint plume may be half of what a plan is chosen
 * for. A map is thin where it has fewer than MURK_THIN_MAP_PHOTONS records and
 * each of them weighs more than ten of the other map's. */
#ifndef MURK_PLAN_FEW_PHOTONS_H
#define MURK_PLAN_FEW_PHOTONS_H

#include "lightmap/lightmap.h"
#include "sensing/sight.h"

/* A share seen of n photons is known to .5 / sqrt(n) at best: 1.6 points. */
#define MURK_THIN_MAP_PHOTONS 1000

/* The thin map of the coverage: 0 surface, 1 volume; -1: neither. Targets that
 * stand in place of photons are as many as were asked for: none is thin. */
int murk_thin_map(const murk_scene_desc *scene,
                  const murk_coverage_result *coverage);

/* Of the variance of the total, the share from this map's records. */
double murk_map_variance_share(const murk_coverage_result *coverage, int map);

/* Warns of it; condition NULL: the scene as it stands. */
void murk_warn_of_thin_map(const murk_scene_desc *scene,
                           const murk_coverage_result *coverage,
                           const char *condition);

/* Before light is traced, by the forecast. */
void murk_warn_of_thin_forecast(const murk_scene_desc *scene,
                                const murk_forecast *forecast);

#endif
