/* Finds thin maps, whose records are few and weigh far more each than those of
 * the other map, and warns about them (plan/few_photons.h). */
#include "plan/few_photons.h"

#include "base/log.h"

#include <math.h>
#include <stdio.h>

/* The mean weight of the records of a thin map is more than this number times
 * that of the other map. An order of magnitude is more than a difference that a
 * user sets on purpose. */
#define THIN_RATIO 10

/* What the warnings advise. */
#define MORE "more photons"
#define REMEDY                                                     \
    MORE ", or placement.weights: {surface: 1, volume: 1}, which " \
         "counts all photons alike"

static const char *const PLACE[] = {"on surfaces", "in media"};

/* True if a map of `photons` records with the share `weight` of the total
 * weight is thin beside a map of `others` records with the share
 * `others_weight`. */
static bool is_thin(double photons, double weight, double others,
                    double others_weight)
{
    return photons > 0 && others > 0 && photons < MURK_THIN_MAP_PHOTONS &&
           weight / photons > THIN_RATIO * others_weight / others;
}

int murk_thin_map(const murk_scene_desc *scene,
                  const murk_coverage_result *coverage)
{
    for (int p = 0; p < 2 && !scene->placement.targets.given; ++p) {
        const murk_map_share *map = &coverage->map[p];
        const murk_map_share *other = &coverage->map[1 - p];
        if (is_thin((double)map->photons, map->weight, (double)other->photons,
                    other->weight)) {
            return p;
        }
    }
    return -1;
}

double murk_map_variance_share(const murk_coverage_result *coverage, int map)
{
    const double of = coverage->map[map].standard_error;
    const double other = coverage->map[1 - map].standard_error;
    return of * of / (of * of + other * other);
}

bool murk_thin_map_text(char *out, size_t size, const murk_scene_desc *scene,
                        const murk_coverage_result *coverage,
                        const char *condition)
{
    const int p = murk_thin_map(scene, coverage);
    if (p < 0) {
        return false;
    }
    /* The share of the variance is NaN if neither map has a standard error
     * above 0, or if one standard error is NaN; the text then leaves the share
     * out. */
    const double variance = murk_map_variance_share(coverage, p);
    char error[64] = "";
    if (isfinite(variance)) {
        snprintf(error, sizeof error, " and for %.3g %% of its variance",
                 100 * variance);
    }
    snprintf(out, size,
             "the %zu photons stored %s%s%s stand for %.3g %% of the "
             "coverage%s, beside %zu %s",
             coverage->map[p].photons, PLACE[p],
             condition ? " in condition " : "", condition ? condition : "",
             100 * coverage->map[p].weight, error, coverage->map[1 - p].photons,
             PLACE[1 - p]);
    return true;
}

void murk_warn_of_thin_map(const murk_scene_desc *scene,
                           const murk_coverage_result *coverage,
                           const char *condition)
{
    char text[MURK_THIN_MAP_SIZE];
    if (murk_thin_map_text(text, sizeof text, scene, coverage, condition)) {
        /* Other weights change nothing if the other map does not count. */
        const int p = murk_thin_map(scene, coverage);
        const bool has_both =
            scene->placement.balanced && coverage->map[1 - p].weight > 0;
        murk_warn(scene->placement.where[0] ? scene->placement.where
                                            : scene->path,
                  "weights: %s: %s", text, has_both ? REMEDY : MORE);
    }
}

void murk_warn_of_thin_forecast(const murk_scene_desc *scene,
                                const murk_forecast *forecast)
{
    const double photons[] = {forecast->surface, forecast->volume};
    const murk_scene_placement *settings = &scene->placement;
    for (int p = 0; p < 2; ++p) {
        /* Weights other than balanced depend on power, which a forecast of
         * counts does not contain. */
        if (settings->balanced && !settings->targets.given &&
            scene->sensors.given &&
            is_thin(photons[p], .5, photons[1 - p], .5)) {
            murk_warn(settings->where[0] ? settings->where : scene->path,
                      "weights: some %.3g photons would be stored %s and stand "
                      "for 50 %% of the coverage, beside some %.3g %s: " REMEDY,
                      photons[p], PLACE[p], photons[1 - p], PLACE[1 - p]);
        }
    }
}
