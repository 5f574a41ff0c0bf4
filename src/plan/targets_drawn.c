/* Draws targets uniformly over area and volume by rejection.
 *
 * Draws are numbered, and each is a function of its number alone. A wave of
 * draws is tested in parallel; then the records of the draws are stored in the
 * order of the numbers until enough points are kept, so the result does not
 * depend on threads. A draw is accepted, and its point kept, if the draw gives
 * a record. The powers of the records add up to an unbiased estimate of the
 * size of the free space: after n draws each record has the power size / n,
 * where size is the area or volume that is drawn from. If sampling stops at the
 * k-th kept point, k > 1, each record has the power size (k - 1) / (k (n - 1))
 * (J. B. S. Haldane, Biometrika 33 (1945) 222, doi:10.1093/biomet/33.3.222). */
#include "plan/target_records.h"

#include "base/interrupt.h"
#include "base/machine.h"
#include "base/pool.h"
#include "base/progress.h"
#include "base/rng.h"
#include "geometry/area.h"
#include "plan/free_space.h"
#include "sensing/open_space.h"
#include "world/extent.h"

#include <stdlib.h>

/* Draws of one task, tasks of one wave, and draws of one wave: enough work for
 * the threads of a large machine, and 1 MB of results. */
#define BATCH_DRAWS  256
#define WAVE_BATCHES 64
#define WAVE_DRAWS   (BATCH_DRAWS * WAVE_BATCHES)

/* Upper limit on the draws if the scene asks for a number of points: a first
 * number of draws, and a number of draws for each point to keep. If many fewer
 * than one draw in 100 are accepted, the requested space is too small to be
 * sampled by rejection, and fewer points are kept than asked for. */
#define DRAWS_EACH  100
#define DRAWS_FIRST 100000

/* The number of draws that a wave tests for each point that is still missing,
 * up to WAVE_DRAWS in all: half more than needed if all draws are accepted, so
 * that few waves suffice. */
#define DRAWS_AHEAD 1.5

/* A surface has two sides. */
#define SIDES 2

/* The result of one draw: a record for each side in free space. */
typedef struct found {
    int n;
    murk_photon photon[SIDES];
} found;

typedef struct drawing {
    murk_target_records *to;
    murk_record_list *list; /* of `to`: the records of this kind */
    const char *where;
    murk_open_space *space;
    /* Points are drawn from the area; if area is NULL, from the box. */
    murk_area *area;
    murk_box box;
    double size;        /* area [m2] or volume [m3] that is drawn from */
    uint64_t draws_max; /* upper limit on draws */
    uint64_t keeps;     /* points to keep */
    uint64_t first;     /* number of the first draw of the wave */
    uint64_t batches;   /* number of tasks in the wave */
    found *wave;        /* [WAVE_DRAWS] */
} drawing;

/* The random numbers of a draw; `event` is 0 on surfaces and 1 in the volume,
 * so that these draws are independent. */
static murk_random4 draw_of(const drawing *d, uint64_t number, uint32_t event)
{
    return murk_random(d->to->stage->scene->seed,
                       MURK_TARGET + MURK_STREAM * d->to->stream, number, event,
                       0);
}

/* ---- surfaces ---- */

/* Draws a point on the surfaces, and adds a record to *f for each side that
 * lies in free space and in the domain. */
static void draw_on_surface(const drawing *d, uint64_t number, found *f)
{
    const murk_stage *stage = d->to->stage;
    const murk_random4 r = draw_of(d, number, 0);
    const murk_area_point point = murk_area_at(d->area, r.u);
    for (int side = 0; side < SIDES; ++side) {
        const murk_vec3 normal = murk_scale(side ? -1 : 1, point.normal);
        const murk_vec3 off =
            murk_surfaces_leave(stage->surfaces, point.place, normal);
        if (murk_box_contains(&stage->world.domain.box, off) &&
            murk_open_space_holds(d->space, off, normal)) {
            f->photon[f->n++] = murk_target_of(point.place, normal, d->to->band,
                                               point.material);
        }
    }
}

/* ---- volume ---- */

/* True if the point lies in the shape and the medium that the scene asks for.
 */
static bool is_wanted(const drawing *d, murk_inside inside, murk_vec3 p)
{
    const murk_stage *stage = d->to->stage;
    const murk_scene_targets *settings = &stage->scene->placement.targets;
    if (settings->medium >= 0 &&
        !(murk_media_extinction_of(stage->media, (size_t)settings->medium,
                                   d->to->band, inside, p) > 0)) {
        return false;
    }
    switch (settings->shape) {
    case MURK_REGION_SPHERE:
        return murk_length(murk_sub(p, settings->solid.center)) <=
               settings->solid.radius_m;
    case MURK_REGION_MESH:
        return murk_boundary_meshes_at(murk_goals_target_mesh(stage->goals),
                                       p) != 0;
    default: /* drawn within the box, or everywhere */
        return true;
    }
}

/* Draws a point in the box, and adds a record to *f if the point is wanted and
 * lies in free space. */
static void draw_in_volume(const drawing *d, uint64_t number, found *f)
{
    const murk_stage *stage = d->to->stage;
    const murk_random4 r = draw_of(d, number, 1);
    const murk_vec3 a = d->box.min, size = murk_sub(d->box.max, a);
    const murk_vec3 p = {a.x + r.u[0] * size.x, a.y + r.u[1] * size.y,
                         a.z + r.u[2] * size.z};
    const murk_vec3 none = {0, 0, 0};
    const murk_inside inside =
        stage->boundary_meshes
            ? murk_boundary_meshes_at(stage->boundary_meshes, p)
            : 0;
    if (is_wanted(d, inside, p) && murk_open_space_holds(d->space, p, none)) {
        f->photon[f->n++] = murk_target_of(
            p, none, d->to->band, murk_target_medium(stage, d->to->band, p));
    }
}

/* ---- both ---- */

/* Tests the draws of one task. */
static void draw_batch(void *context, uint64_t batch)
{
    const drawing *d = context;
    for (uint64_t i = batch * BATCH_DRAWS; i < (batch + 1) * BATCH_DRAWS; ++i) {
        d->wave[i] = (found){0};
        if (d->area) {
            draw_on_surface(d, d->first + i, &d->wave[i]);
        } else {
            draw_in_volume(d, d->first + i, &d->wave[i]);
        }
    }
}

/* Sets d->keeps and d->draws_max: from a number of points, or, if `points` is
 * 0, from `spacings`, the number of draws that a spacing fixes. Fails if that
 * number exceeds MURK_TARGETS_MAX. */
static murk_status set_amount(drawing *d, uint64_t points, double spacings,
                              murk_error *err)
{
    const uint64_t max = d->to->max;
    if (points > 0) {
        d->keeps = points < max ? points : max;
        d->draws_max = DRAWS_FIRST + DRAWS_EACH * d->keeps;
        return MURK_OK;
    }
    if (!(spacings <= MURK_TARGETS_MAX)) {
        return murk_fail(err, MURK_BAD_VALUE, d->where,
                         "spacing_m makes %.3g points, must be at most %.3g",
                         spacings, MURK_TARGETS_MAX);
    }
    d->draws_max = (uint64_t)fmax(ceil(spacings), 1);
    d->keeps = max;
    return MURK_OK;
}

/* Goes through the draws of a wave in order and stores their records, until
 * enough points are kept. *draws grows by the number of draws gone through,
 * accepted or not. */
static murk_status accept_wave(drawing *d, uint64_t *points, uint64_t *draws,
                               murk_error *err)
{
    for (uint64_t i = 0; i < d->batches * BATCH_DRAWS &&
                         *draws < d->draws_max && *points < d->keeps;
         ++i) {
        found *f = &d->wave[i];
        for (int k = 0; k < f->n; ++k) {
            murk_photon_set_emitted(&f->photon[k],
                                    (uint32_t)(d->to->facts.points + *points));
            const murk_status status =
                murk_record_list_put(d->list, &f->photon[k], err);
            if (status) {
                return status;
            }
        }
        *points += f->n > 0;
        ++*draws;
    }
    return MURK_OK;
}

/* Sets the power of the records, and returns the size of the free space with
 * standard error. A draw contributes 0, 1 or 2 records; the variance of this
 * number over the draws gives the standard error. */
static murk_estimate set_powers(const drawing *d, uint64_t points,
                                uint64_t draws)
{
    const double n = (double)draws, k = (double)points, size = d->size;
    const double each =
        points == d->keeps && k > 1 ? size * (k - 1) / (k * (n - 1)) : size / n;
    const double sides = (double)d->list->n, both = sides - k;
    const double variance =
        (k - both + 4 * both) / n - (sides / n) * (sides / n);
    for (size_t i = 0; i < d->list->n; ++i) {
        murk_photon_set_power_w(&d->list->photon[i], each);
    }
    return (murk_estimate){
        sides * each, n > 1 ? size * sqrt(fmax(0, variance) / (n - 1)) : NAN};
}

/* Memory of a growing list relative to the content: capacity grows by half, and
 * old and new array exist while it moves. */
#define GROWTH_FACTOR 2.5

/* Fails if the points, counted as one record each, do not fit in the free
 * memory. */
static murk_status check_memory(const drawing *d, murk_error *err)
{
    const double points =
        (double)(d->keeps < d->draws_max ? d->keeps : d->draws_max);
    const double bytes = GROWTH_FACTOR * sizeof(murk_photon) * points;
    const double have = murk_machine_memory_bytes();
    return bytes <= have
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, d->where,
                           "%.3g points take about %.3g GB; this machine has "
                           "%.3g GB free",
                           points, bytes / 1e9, have / 1e9);
}

/* Allocates a wave and sets up the test of free space. */
static murk_status begin(drawing *d, murk_error *err)
{
    d->wave = malloc(WAVE_DRAWS * sizeof *d->wave);
    if (!d->wave) {
        return murk_no_memory(err, d->where, "to draw");
    }
    const murk_status status =
        murk_stage_free_space(&d->space, d->to->stage, d->to->threads, err);
    return status ? status : check_memory(d, err);
}

/* Draws in waves until d->keeps points are kept or d->draws_max draws are made;
 * a spacing fixes d->draws_max as the number of draws to make. Fails if no
 * point is kept; fewer than d->keeps points are no failure. */
static murk_status draw_waves(drawing *d, murk_estimate *size, murk_error *err)
{
    murk_status status = MURK_OK;
    uint64_t draws = 0, points = 0;
    murk_progress_begin(
        "targets", d->keeps < d->draws_max ? d->keeps : d->draws_max, "points");
    /* Test a wave, then accept in order. */
    while (!status && draws < d->draws_max && points < d->keeps) {
        const uint64_t before = points;
        const double left = fmin((double)(d->draws_max - draws),
                                 DRAWS_AHEAD * (double)(d->keeps - points));
        d->first = draws;
        d->batches = (uint64_t)fmin(WAVE_BATCHES, ceil(left / BATCH_DRAWS));
        murk_pool_run(d->to->threads, d->batches, draw_batch, d);
        status = murk_interrupt_check(err);
        status = status ? status : accept_wave(d, &points, &draws, err);
        murk_progress_add(points - before);
    }
    murk_progress_end();
    /* At least one point must lie in free space. */
    if (!status && points == 0) {
        status = murk_fail(err, MURK_BAD_VALUE, d->where,
                           "none of %llu points drawn lies in free space",
                           (unsigned long long)draws);
    }
    if (!status) {
        *size = set_powers(d, points, draws);
    }
    d->to->facts.points += points;
    return status;
}

/* Draws `points` points, or, if `points` is 0, makes the number of draws
 * `spacings` that a spacing fixes; *size receives the size of the free space.
 */
static murk_status draw(drawing *d, uint64_t points, double spacings,
                        murk_estimate *size, murk_error *err)
{
    murk_status status = set_amount(d, points, spacings, err);
    if (!status) {
        status = begin(d, err);
    }
    return status ? status : draw_waves(d, size, err);
}

static void release(drawing *d)
{
    murk_open_space_destroy(d->space);
    murk_area_destroy(d->area);
    free(d->wave);
}

murk_status murk_targets_draw_surfaces(murk_target_records *records,
                                       murk_error *err)
{
    const murk_stage *stage = records->stage;
    const murk_scene_targets *settings = &stage->scene->placement.targets;
    drawing d = {.to = records,
                 .list = &records->surface,
                 .where = settings->surfaces_where};
    /* Select the materials. */
    bool wanted[MURK_MATERIALS_MAX] = {false};
    for (size_t i = 0; i < settings->materials.n; ++i) {
        wanted[settings->materials.index[i]] = true;
    }
    murk_status status = murk_area_create(
        &d.area, stage->surfaces, settings->materials.n > 0 ? wanted : NULL,
        d.where, err);
    if (!status) {
        const double s = settings->surface_spacing_m;
        d.size = murk_area_m2(d.area);
        status = draw(&d, settings->surface_points, d.size / (s * s),
                      &records->facts.area_m2, err);
    }
    release(&d);
    return status;
}

/* A box that contains all regions of a medium; an unbounded region counts with
 * the domain. Empty if the medium has no region. */
static murk_box box_of_medium(const murk_stage *stage, int medium)
{
    murk_box box = murk_box_empty();
    for (size_t i = 0; i < stage->scene->n_regions; ++i) {
        const murk_scene_region *r = &stage->scene->regions[i];
        if (r->medium != (size_t)medium) {
            continue;
        }
        const murk_box one =
            murk_extent_is_bounded(r)
                ? murk_extent_region(stage->scene, r, stage->grid[r->medium],
                                     stage->region_mesh[i])
                : stage->world.domain.box;
        if (one.min.x <= one.max.x) {
            box = murk_box_with(murk_box_with(box, one.min), one.max);
        }
    }
    return box;
}

/* The box that points are drawn from: the part common to the domain and the
 * boxes of the shape and the medium that the scene asks for. */
static murk_box box_to_draw_from(const murk_stage *stage)
{
    const murk_scene_targets *settings = &stage->scene->placement.targets;
    const murk_box box =
        murk_box_meet(stage->world.domain.box,
                      murk_goals_box(settings->shape, &settings->solid,
                                     murk_goals_target_mesh(stage->goals), 0));
    return settings->medium >= 0
               ? murk_box_meet(box, box_of_medium(stage, settings->medium))
               : box;
}

murk_status murk_targets_draw_volume(murk_target_records *records,
                                     murk_error *err)
{
    const murk_scene_targets *settings =
        &records->stage->scene->placement.targets;
    drawing d = {.to = records,
                 .list = &records->volume,
                 .where = settings->volume_where,
                 .box = box_to_draw_from(records->stage)};
    const murk_vec3 size = murk_sub(d.box.max, d.box.min);
    if (!(size.x > 0 && size.y > 0 && size.z > 0)) {
        return murk_fail(err, MURK_BAD_VALUE, d.where,
                         "holds none of the domain's space");
    }
    const double s = settings->volume_spacing_m;
    d.size = size.x * size.y * size.z;
    const murk_status status =
        draw(&d, settings->volume_points, d.size / (s * s * s),
             &records->facts.volume_m3, err);
    release(&d);
    return status;
}
