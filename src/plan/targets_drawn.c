/* Draws targets uniformly over area and volume by rejection.
 *
 * Draws are numbered, and each is a function of its number alone. A wave of
 * draws is tested in parallel; then the draws are accepted in the order of
 * their numbers until enough points are kept, so the result does not depend on
 * threads. The powers of the kept records add up to an unbiased estimate of the
 * size of the free space: of n draws each represents size / n. If sampling
 * stops at the k-th kept point, each represents size (k - 1) / (k (n - 1)) (J.
 * B. S. Haldane, Biometrika 33 (1945) 222, doi:10.1093/biomet/33.3.222). */
#include "plan/target_buffer.h"
#include "plan/targets.h"

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

/* Upper limit on draws: a first number, and a number for each point to keep. If
 * fewer than one draw in 100 is accepted, the requested space is too small to
 * be sampled by rejection. */
#define DRAWS_EACH  100
#define DRAWS_FIRST 100000

/* Draws tested at once for each point that is still missing: half more than
 * needed if all are accepted, so that few waves suffice. */
#define DRAWS_AHEAD 1.5

/* A surface has two sides. */
#define SIDES 2

/* The result of one draw: a record for each side in free space. */
typedef struct found {
    int n;
    murk_photon photon[SIDES];
} found;

typedef struct drawing {
    const murk_target_source *source;
    murk_open_space *space;
    int band;
    /* Area or box: one of them is used. */
    murk_area *area;
    murk_box box;
    uint64_t first;   /* number of the first draw of the wave */
    uint64_t batches; /* number of tasks in the wave */
    found *wave;      /* [WAVE_DRAWS] */
} drawing;

/* The random numbers of a draw; event keeps surfaces and volume independent. */
static murk_random4 draw_of(const drawing *d, uint64_t number, uint32_t event)
{
    return murk_random(d->source->stage->scene->seed,
                       MURK_TARGET + MURK_STREAM * d->source->stream, number,
                       event, 0);
}

/* Adds a record to the result of a draw. */
static void keep(found *f, murk_vec3 place, murk_vec3 normal, int band,
                 uint8_t material)
{
    f->photon[f->n] = murk_target_of(place, normal, 0, band);
    murk_photon_set_material(&f->photon[f->n++], material);
}

/* ---- surfaces ---- */

/* Draws a point on the surfaces and tests both sides. */
static void draw_on_surface(const drawing *d, uint64_t number, found *f)
{
    const murk_stage *stage = d->source->stage;
    const murk_random4 r = draw_of(d, number, 0);
    const murk_area_point point = murk_area_at(d->area, r.u);
    for (int side = 0; side < SIDES; ++side) {
        const murk_vec3 normal = murk_scale(side ? -1 : 1, point.normal);
        const murk_vec3 off =
            murk_surfaces_leave(stage->surfaces, point.place, normal);
        if (murk_box_contains(&stage->world.domain.box, off) &&
            murk_open_space_holds(d->space, off, normal)) {
            keep(f, point.place, normal, d->band, point.material);
        }
    }
}

/* ---- volume ---- */

/* True if the point lies in the shape and the medium that the scene asks for.
 */
static bool is_wanted(const drawing *d, murk_inside inside, murk_vec3 p)
{
    const murk_stage *stage = d->source->stage;
    const murk_scene_targets *settings = &stage->scene->placement.targets;
    if (settings->medium >= 0 &&
        !(murk_media_extinction_of(stage->media, (size_t)settings->medium,
                                   d->band, inside, p) > 0)) {
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

/* Draws a point in the box and tests it. */
static void draw_in_volume(const drawing *d, uint64_t number, found *f)
{
    const murk_stage *stage = d->source->stage;
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
        keep(f, p, none, d->band, murk_target_medium(stage, d->band, p));
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

/* Upper limit on draws, and the number of points to keep. */
typedef struct amount {
    uint64_t draws, keeps;
} amount;

/* Determines both numbers: from a number of points, or from a spacing, which
 * fixes the number of draws. */
static murk_status amount_of(amount *out, const murk_target_source *source,
                             uint64_t points, double spacings,
                             const char *where, murk_error *err)
{
    if (points > 0) {
        const uint64_t keeps = points < source->max ? points : source->max;
        *out = (amount){DRAWS_FIRST + DRAWS_EACH * keeps, keeps};
        return MURK_OK;
    }
    if (!(spacings <= MURK_TARGETS_MAX)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "spacing_m makes %.3g points, must be at most %.3g",
                         spacings, MURK_TARGETS_MAX);
    }
    *out = (amount){(uint64_t)fmax(ceil(spacings), 1), source->max};
    return MURK_OK;
}

/* Accepts the draws of a wave in order until enough points are kept. *draws
 * counts draws up to the last accepted one. */
static murk_status accept_wave(murk_target_buffer *buffer, const drawing *d,
                               const amount *a, uint64_t *points,
                               uint64_t *draws, murk_error *err)
{
    for (uint64_t i = 0; i < d->batches * BATCH_DRAWS && *draws < a->draws &&
                         *points < a->keeps;
         ++i) {
        found *f = &d->wave[i];
        for (int k = 0; k < f->n; ++k) {
            murk_photon_set_emitted(
                &f->photon[k], (uint32_t)(d->source->first_number + *points));
            if (!murk_target_buffer_put(buffer, &f->photon[k])) {
                return murk_fail(err, MURK_NO_MEMORY, "placement.targets",
                                 "no memory for more than %zu targets",
                                 buffer->n);
            }
        }
        *points += f->n > 0;
        ++*draws;
    }
    return MURK_OK;
}

/* Sets the power of the records, and returns the size of the free space with
 * standard error. A draw contributes 0, 1 or 2 sides; the variance of that
 * number over n draws gives the error. */
static murk_estimate set_powers(murk_target_buffer *buffer, uint64_t points,
                                uint64_t draws, bool is_ended_by_count,
                                double size)
{
    const double n = (double)draws, k = (double)points;
    const double each =
        is_ended_by_count && k > 1 ? size * (k - 1) / (k * (n - 1)) : size / n;
    const double sides = (double)buffer->n, both = sides - k;
    const double variance =
        (k - both + 4 * both) / n - (sides / n) * (sides / n);
    for (size_t i = 0; i < buffer->n; ++i) {
        murk_photon_set_power_w(&buffer->photon[i], each);
    }
    return (murk_estimate){
        sides * each, n > 1 ? size * sqrt(fmax(0, variance) / (n - 1)) : NAN};
}

/* Memory of a growing list relative to the content: capacity grows by half, and
 * old and new array exist while it moves. */
#define GROWTH_FACTOR 2.5

/* Fails if the points do not fit in memory. */
static murk_status check_memory(const amount *a, const char *where,
                                murk_error *err)
{
    const double points = (double)(a->keeps < a->draws ? a->keeps : a->draws);
    const double bytes = GROWTH_FACTOR * sizeof(murk_photon) * points;
    const double have = murk_machine_memory_bytes();
    return bytes <= have
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, where,
                           "%.3g points take about %.3g GB; this machine has "
                           "%.3g GB free",
                           points, bytes / 1e9, have / 1e9);
}

/* Draws in waves until enough points are kept or the limit is reached. */
static murk_status draw_all(murk_target_buffer *buffer, murk_target_draw *out,
                            drawing *d, const amount *a, double size,
                            const char *where, murk_error *err)
{
    murk_status status = check_memory(a, where, err);
    /* Start with empty counts. */
    uint64_t draws = 0;
    uint64_t *points = &out->points;
    *out = (murk_target_draw){0};
    murk_progress_begin("targets", a->keeps < a->draws ? a->keeps : a->draws,
                        "points");
    /* Test a wave, then accept in order. */
    while (!status && draws < a->draws && *points < a->keeps) {
        const uint64_t before = *points;
        const double left = fmin((double)(a->draws - draws),
                                 DRAWS_AHEAD * (double)(a->keeps - *points));
        d->first = draws;
        d->batches = (uint64_t)fmin(WAVE_BATCHES, ceil(left / BATCH_DRAWS));
        murk_pool_run(d->source->threads, d->batches, draw_batch, d);
        status = murk_interrupted()
                     ? murk_fail(err, MURK_INTERRUPTED, "", "interrupted")
                     : accept_wave(buffer, d, a, points, &draws, err);
        murk_progress_add(*points - before);
    }
    murk_progress_end();
    /* At least one point must lie in free space. */
    if (!status && *points == 0) {
        status = murk_fail(err, MURK_BAD_VALUE, where,
                           "none of %llu points drawn lies in free space",
                           (unsigned long long)draws);
    }
    if (!status) {
        out->size =
            set_powers(buffer, *points, draws, *points == a->keeps, size);
    }
    return status;
}

static void release(drawing *d)
{
    murk_open_space_destroy(d->space);
    murk_area_destroy(d->area);
    free(d->wave);
}

/* Allocates a wave and sets up the test of free space. */
static murk_status begin(drawing *d, const char *where, murk_error *err)
{
    d->band = murk_targets_band(d->source->stage->scene);
    d->wave = malloc(WAVE_DRAWS * sizeof *d->wave);
    if (!d->wave) {
        return murk_fail(err, MURK_NO_MEMORY, where, "no memory to draw");
    }
    return murk_stage_free_space(&d->space, d->source->stage,
                                 d->source->threads, err);
}

murk_status murk_targets_draw_surfaces(murk_target_buffer *buffer,
                                       murk_target_draw *out,
                                       const murk_target_source *source,
                                       murk_error *err)
{
    const murk_stage *stage = source->stage;
    const murk_scene_targets *settings = &stage->scene->placement.targets;
    const char *where = settings->surfaces_where;
    drawing d = {.source = source};
    amount a = {0};
    /* Select the materials. */
    bool wanted[MURK_MATERIALS_MAX] = {false};
    for (size_t i = 0; i < settings->materials.n; ++i) {
        wanted[settings->materials.index[i]] = true;
    }
    murk_status status =
        murk_area_create(&d.area, stage->surfaces,
                         settings->materials.n > 0 ? wanted : NULL, where, err);
    if (!status) {
        /* Determine the number of points. */
        const double s = settings->surface_spacing_m;
        status = amount_of(&a, source, settings->surface_points,
                           murk_area_m2(d.area) / (s * s), where, err);
    }
    /* Draw. */
    if (!status) {
        status = begin(&d, where, err);
    }
    if (!status) {
        status =
            draw_all(buffer, out, &d, &a, murk_area_m2(d.area), where, err);
    }
    release(&d);
    return status;
}

static murk_box meet(murk_box a, murk_box b)
{
    return (murk_box){{fmax(a.min.x, b.min.x), fmax(a.min.y, b.min.y),
                       fmax(a.min.z, b.min.z)},
                      {fmin(a.max.x, b.max.x), fmin(a.max.y, b.max.y),
                       fmin(a.max.z, b.max.z)}};
}

/* A box that contains all regions of a medium. */
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

/* The box that points are drawn from: domain, shape and medium. */
static murk_box box_to_draw_from(const murk_stage *stage)
{
    const murk_scene_targets *settings = &stage->scene->placement.targets;
    const murk_vec3 r = {settings->solid.radius_m, settings->solid.radius_m,
                         settings->solid.radius_m};
    murk_box box = stage->world.domain.box;
    if (settings->shape == MURK_REGION_BOX) {
        box = meet(box, settings->solid.box);
    } else if (settings->shape == MURK_REGION_SPHERE) {
        box = meet(box, (murk_box){murk_sub(settings->solid.center, r),
                                   murk_add(settings->solid.center, r)});
    } else if (settings->shape == MURK_REGION_MESH) {
        box = meet(box, murk_boundary_meshes_describe(
                            murk_goals_target_mesh(stage->goals), 0)
                            .bounds_m);
    }
    return settings->medium >= 0
               ? meet(box, box_of_medium(stage, settings->medium))
               : box;
}

murk_status murk_targets_draw_volume(murk_target_buffer *buffer,
                                     murk_target_draw *out,
                                     const murk_target_source *source,
                                     murk_error *err)
{
    const murk_scene_targets *settings =
        &source->stage->scene->placement.targets;
    const char *where = settings->volume_where;
    drawing d = {.source = source, .box = box_to_draw_from(source->stage)};
    amount a = {0};
    const murk_vec3 size = murk_sub(d.box.max, d.box.min);
    /* The box must have a volume. */
    if (!(size.x > 0 && size.y > 0 && size.z > 0)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "holds none of the domain's space");
    }
    /* Determine the number of points, then draw. */
    const double s = settings->volume_spacing_m, all = size.x * size.y * size.z;
    murk_status status = amount_of(&a, source, settings->volume_points,
                                   all / (s * s * s), where, err);
    if (!status) {
        status = begin(&d, where, err);
    }
    if (!status) {
        status = draw_all(buffer, out, &d, &a, all, where, err);
    }
    release(&d);
    return status;
}
