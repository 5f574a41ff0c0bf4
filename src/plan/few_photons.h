/* Warnings about coverage that depends on few photons of one map.
 *
 * With `weights: balanced` the surface map and the volume map have the same
 * total weight if neither is empty, however few records one of them has. A
 * handful of records in a plume may therefore be half of the coverage that a
 * plan maximises. A map is called thin if it has at least one and fewer than
 * MURK_THIN_MAP_PHOTONS records, the other map is not empty, and the mean
 * weight of the records of the thin map is more than ten times that of the
 * records of the other map. */
#ifndef MURK_PLAN_FEW_PHOTONS_H
#define MURK_PLAN_FEW_PHOTONS_H

#include "lightmap/lightmap.h"
#include "sensing/sight.h"

/* Only a map with fewer records than this can be thin. A share estimated from n
 * photons has a standard error of at most .5 / sqrt(n): 0.016 for 1000
 * photons. */
#define MURK_THIN_MAP_PHOTONS 1000

/* The map that is thin: 0 surface, 1 volume, -1 neither. Targets that stand in
 * for photons are as many as the user asked for, so no map of targets is thin.
 */
int murk_thin_map(const murk_scene_desc *scene,
                  const murk_coverage_result *coverage);

/* The share of the variance of the total coverage that comes from the records
 * of map 0 (surface) or 1 (volume); NaN if the standard errors of both maps are
 * 0 or if one of them is NaN. */
double murk_map_variance_share(const murk_coverage_result *coverage, int map);

/* Writes a clause that states the share of the coverage, and the share of the
 * variance of the coverage, that the thin map contributes, and returns true. If
 * no map is thin, returns false and writes nothing. condition is the name of a
 * condition, or NULL for the scene itself. */
#define MURK_THIN_MAP_SIZE 320 /* with the longest name of a condition */
bool murk_thin_map_text(char *out, size_t size, const murk_scene_desc *scene,
                        const murk_coverage_result *coverage,
                        const char *condition);

/* Warns if a map is thin. condition is the name of a condition, or NULL for the
 * scene itself. */
void murk_warn_of_thin_map(const murk_scene_desc *scene,
                           const murk_coverage_result *coverage,
                           const char *condition);

/* Warns of a map that will be thin by the forecast of the numbers of records,
 * before light is traced. Only for scenes with sensors that cover photons, not
 * targets, with `weights: balanced`. */
void murk_warn_of_thin_forecast(const murk_scene_desc *scene,
                                const murk_forecast *forecast);

#endif
