/* Coverage of a picture: turns the surface points that the pixels show into
 * records of a map, and counts for each the sensors that see it and the
 * largest clarity. */
#include "pictures/coverage.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "base/progress.h"
#include "plan/plan.h"
#include "plan/targets.h"
#include "render/points.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

/* Pixels that are processed together, and the memory of one of them meanwhile
 * [bytes]: its record, its part of the tree, the sums, and entries of the rows
 * of sensors. */
#define PIXELS_TOGETHER ((size_t)1 << 20)
#define BYTES_EACH      128

/* What the sensors see of the pixels of some rows. Counts and clarities are
 * whole numbers, added and compared in any order, so they are the same for any
 * number of threads. */
typedef struct strip {
    murk_image *picture;
    const murk_stage *stage;
    const murk_viewpoint *viewpoint;
    const murk_scenery *scenery;
    size_t first_row, rows;
    int band;
    unsigned threads;
    murk_sight *sight;
    _Atomic uint32_t *count, *clearest; /* [rows * width] */
} strip;

static int band_of(const murk_scene_desc *scene, uint32_t type)
{
    const uint32_t bands = scene->sensors.type[type].bands;
    int band = murk_targets_band(scene);
    if (bands && !(bands >> band & 1)) {
        for (band = 0; !(bands >> band & 1); ++band) {
        }
    }
    return band;
}

static size_t rows_together(size_t width)
{
    return width < PIXELS_TOGETHER ? PIXELS_TOGETHER / width : 1;
}

double murk_picture_coverage_bytes(size_t width, size_t height)
{
    const double rows = fmin((double)height, (double)rows_together(width));
    return (double)width *
           ((double)height * 2 * sizeof(float) + rows * BYTES_EACH);
}

static void raise(_Atomic uint32_t *cell, uint32_t value)
{
    uint32_t there = atomic_load_explicit(cell, memory_order_relaxed);
    while (there < value &&
           !atomic_compare_exchange_weak_explicit(
               cell, &there, value, memory_order_relaxed, memory_order_relaxed))
        ;
}

static void cover_by_sensor(void *context, unsigned worker, uint64_t batch)
{
    strip *s = context;
    const murk_pose *pose = &s->viewpoint->sensor[batch];
    if (murk_interrupted() || band_of(s->stage->scene, pose->type) != s->band) {
        return;
    }
    const size_t first = s->first_row * s->picture->width;
    murk_sparse_row row;
    murk_sight_row(s->sight, worker, pose, &row);
    for (size_t i = 0; i < row.seen; ++i) {
        const size_t at =
            murk_photon_emitted(murk_sight_photon(s->sight, row.photon[i])) -
            first;
        atomic_fetch_add_explicit(&s->count[at], 1, memory_order_relaxed);
        raise(&s->clearest[at], row.clarity ? row.clarity[i] : MURK_CLEAR);
    }
    murk_progress_add(1);
}

/* Copies counts and clarities to the picture, for the pixels that show a
 * surface. */
static void keep(const strip *s, const murk_photon_map *points)
{
    murk_image *p = s->picture;
    const murk_photon *point = murk_photon_map_photons(points);
    const size_t n = murk_photon_map_count(points);
    for (size_t i = 0; i < n; ++i) {
        const size_t pixel = murk_photon_emitted(&point[i]);
        const size_t at = pixel - s->first_row * p->width;
        p->seen_by[pixel] = (float)s->count[at];
        p->clarity[pixel] = (float)s->clearest[at] / MURK_CLEAR;
    }
}

static size_t sensors_of_band(const strip *s)
{
    size_t n = 0;
    for (size_t i = 0; i < s->viewpoint->sensors; ++i) {
        n += band_of(s->stage->scene, s->viewpoint->sensor[i].type) == s->band;
    }
    return n;
}

/* Adds the coverage of a strip by the sensors that look in the band s->band. */
static murk_status cover_strip(strip *s, murk_error *err)
{
    const murk_image *p = s->picture;
    murk_photon *point = NULL;
    size_t n = 0;
    murk_photon_map *points = NULL, *none = NULL;
    murk_status status =
        murk_points_find(&point, &n, s->scenery, &s->viewpoint->camera,
                         s->first_row, s->rows, s->band, s->threads, err);
    if (!status) { /* takes the points over */
        status = murk_photon_map_create(&points, point, n, s->threads, err);
    }
    if (!status) {
        status = murk_photon_map_create(&none, NULL, 0, 1, err);
    }
    if (!status && n > 0) {
        status = murk_plan_sight_points(&s->sight, s->stage, points, none,
                                        p->width * p->height, s->threads, err);
    }
    if (!status && n > 0) {
        murk_pool_run_workers(s->threads, s->viewpoint->sensors,
                              cover_by_sensor, s);
        keep(s, points);
    } else if (!status) { /* no pixel shows a surface: these sensors are done */
        murk_progress_add(sensors_of_band(s));
    }
    murk_sight_destroy(s->sight);
    s->sight = NULL;
    murk_photon_map_destroy(points);
    murk_photon_map_destroy(none);
    return status;
}

static murk_status cover_all(strip *s, murk_error *err)
{
    const murk_image *p = s->picture;
    const size_t together = rows_together(p->width);
    const size_t cells = together * p->width;
    /* Counts and clarities of the rows that are processed together. */
    s->count = calloc(2 * cells, sizeof *s->count);
    if (!s->count) {
        return murk_no_memory(err, "render", "for the coverage of %zu pixels",
                              cells);
    }
    s->clearest = s->count + cells;
    murk_status status = MURK_OK;
    /* Strip by strip; in each strip the bands that sensors use. */
    for (size_t y = 0; y < p->height && !status; y += together) {
        s->first_row = y;
        s->rows = p->height - y < together ? p->height - y : together;
        for (size_t i = 0; i < 2 * cells; ++i) {
            s->count[i] = 0;
        }
        for (int b = 0; b < p->bands && !status; ++b) {
            s->band = b;
            status = sensors_of_band(s) > 0 ? cover_strip(s, err) : MURK_OK;
        }
        status = status ? status : murk_interrupt_check(err);
    }
    free((void *)s->count);
    return status;
}

murk_status murk_picture_cover(murk_image *picture,
                               const murk_viewpoint *viewpoint,
                               const murk_stage *stage, unsigned threads,
                               murk_error *err)
{
    murk_scenery scenery = {0};
    strip s = {.picture = picture,
               .stage = stage,
               .viewpoint = viewpoint,
               .scenery = &scenery,
               .threads = threads};
    murk_status status = murk_image_add_coverage(picture, err);
    if (!status) {
        status = murk_scenery_prepare(&scenery, &stage->world, err);
    }
    if (!status) {
        const size_t together = rows_together(picture->width);
        const size_t strips = (picture->height + together - 1) / together;
        murk_progress_begin("coverage", strips * viewpoint->sensors, "looks");
        status = cover_all(&s, err);
        murk_progress_end();
    }
    murk_scenery_release(&scenery);
    return status;
}
