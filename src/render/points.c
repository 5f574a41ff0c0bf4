/* Finds the surface point that the middle of each pixel shows, row by row on
 * all threads, as photon records, for which the coverage by sensors can be
 * computed. */
#include "render/points.h"

#include <stdlib.h>

#include "base/interrupt.h"
#include "base/pool.h"

typedef struct search {
    const murk_scenery *scenery;
    const murk_camera *camera;
    size_t first_row;
    int band;
    murk_photon *point; /* [rows * width]; power 0 if the pixel shows no
                         * surface */
} search;

static murk_photon point_at(const search *s, size_t x, size_t y)
{
    const murk_camera *c = s->camera;
    const murk_vec3 sight =
        murk_camera_sight(c, (double)x + 0.5, (double)y + 0.5);
    murk_camera_ray ray;
    murk_scenery_end end = {.is_surface = false};
    if (murk_scenery_begin(s->scenery, &ray, c, (double)x + 0.5,
                           (double)y + 0.5, sight)) {
        end = murk_scenery_find_end(s->scenery, ray.origin, sight);
    }
    if (!end.is_surface) {
        return murk_photon_make(&(murk_photon_values){.power_w = 0});
    }
    return murk_photon_make(
        &(murk_photon_values){.position_m = end.position,
                              .direction = sight,
                              .normal = end.normal,
                              .power_w = 1,
                              .emitted = (uint32_t)(y * c->width + x),
                              .band = (uint8_t)s->band});
}

static void trace_row(void *context, uint64_t batch)
{
    const search *s = context;
    const size_t width = s->camera->width;
    for (size_t x = 0; x < width && !murk_interrupted(); ++x) {
        s->point[batch * width + x] = point_at(s, x, s->first_row + batch);
    }
}

murk_status murk_points_find(murk_photon **out, size_t *n,
                             const murk_scenery *scenery,
                             const murk_camera *camera, size_t first_row,
                             size_t rows, int band, unsigned threads,
                             murk_error *err)
{
    const size_t all = rows * camera->width;
    search s = {scenery, camera, first_row, band, calloc(all, sizeof *s.point)};
    if (!s.point) {
        return murk_no_memory(err, "render", "for %zu points", all);
    }
    murk_pool_run(threads, rows, trace_row, &s);
    size_t points = 0;
    for (size_t i = 0; i < all; ++i) {
        if (murk_photon_power_w(&s.point[i]) > 0) {
            s.point[points++] = s.point[i];
        }
    }
    *out = s.point;
    *n = points;
    return MURK_OK;
}
