/* Drawing targets evenly over area and volume.
 *
 * Draws are numbered and each is a function of its number alone. Waves of them
 * are judged in parallel, then taken up in order of their numbers until enough
 * are kept, so threads change nothing. The kept ones' powers add up to an
 * unbiased estimate of what lies in free space: of n draws each stands for size
 * / n; where it was the k-th kept that ended them, for size (k - 1) / (k (n -
 * 1)) (Haldane, Biometrika 33 (1945) 222, doi:10.1093/biomet/33.3.222). */
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

#define BATCH_DRAWS  256
#define WAVE_BATCHES 64
#define WAVE_DRAWS   (BATCH_DRAWS * WAVE_BATCHES)

/* Draws at most for one that is kept, and those beyond: then what is looked
 * for is too rare to be found. */
#define DRAWS_EACH  100
#define DRAWS_FIRST 100000

/* Draws judged at a time for one that is still to be kept. */
#define DRAWS_AHEAD 1.5

#define SIDES 2

/* What a draw leaves: a record for each side in free space. */
typedef struct found {
    int n;
    murk_photon photon[SIDES];
} found;

typedef struct drawing {
    const murk_target_source *source;
    murk_open_space *space;
    int band;
    /* one of them */
    murk_area *area;
    murk_box box;
    uint64_t first;   /* draw of the wave */
    uint64_t batches; /* in it */
    found *wave;      /* [WAVE_DRAWS] */
} drawing;

static murk_random4 draw_of(const drawing *d, uint64_t number, uint32_t event)
{
    return murk_random(d->source->stage->scene->seed,
                       MURK_TARGET + MURK_STREAM * d->source->stream, number,
                       event, 0);
}

static void keep(found *f, murk_vec3 place, murk_vec3 normal, int band,
                 uint8_t material)
{
    f->photon[f->n] = murk_target_of(place, normal, 0, band);
    murk_photon_set_material(&f->photon[f->n++], material);
}

/* ---- surfaces ---- */

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
        return murk_length(murk_sub(p, settings->center)) <= settings->radius_m;
    case MURK_REGION_MESH:
        return murk_boundary_meshes_at(murk_goals_target_mesh(stage->goals),
                                       p) != 0;
    default: /* drawn within the box, or everywhere */
        return true;
    }
}

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

/* How many draws at most, and how many of them are to be kept. */
typedef struct amount {
    uint64_t draws, keeps;
} amount;

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

/* Takes up a wave until enough are kept. *draws: those up to the last. */
static murk_status take_up(murk_target_buffer *buffer, const drawing *d,
                           const amount *a, uint64_t *points, uint64_t *draws,
                           murk_error *err)
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

/* Prices the records; of n draws each brings 0, 1 or 2 sides. */
static murk_estimate price(murk_target_buffer *buffer, uint64_t points,
                           uint64_t draws, bool is_ended_by_kept, double size)
{
    const double n = (double)draws, k = (double)points;
    const double each =
        is_ended_by_kept && k > 1 ? size * (k - 1) / (k * (n - 1)) : size / n;
    const double sides = (double)buffer->n, both = sides - k;
    const double variance =
        (k - both + 4 * both) / n - (sides / n) * (sides / n);
    for (size_t i = 0; i < buffer->n; ++i) {
        murk_photon_set_power_w(&buffer->photon[i], each);
    }
    return (murk_estimate){
        sides * each, n > 1 ? size * sqrt(fmax(0, variance) / (n - 1)) : NAN};
}

/* Records grow by half their room, and move. */
#define ROOM_TIMES 2.5

static murk_status check_memory(const amount *a, const char *where,
                                murk_error *err)
{
    const double points = (double)(a->keeps < a->draws ? a->keeps : a->draws);
    const double bytes = ROOM_TIMES * sizeof(murk_photon) * points;
    const double have = murk_machine_memory_bytes();
    return bytes <= have
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, where,
                           "%.3g points take about %.3g GB; this machine has "
                           "%.3g GB free",
                           points, bytes / 1e9, have / 1e9);
}

static murk_status draw_all(murk_target_buffer *buffer, murk_target_draw *out,
                            drawing *d, const amount *a, double size,
                            const char *where, murk_error *err)
{
    murk_status status = check_memory(a, where, err);
    uint64_t draws = 0;
    uint64_t *points = &out->points;
    *out = (murk_target_draw){0};
    murk_progress_begin("targets", a->keeps < a->draws ? a->keeps : a->draws,
                        "points");
    while (!status && draws < a->draws && *points < a->keeps) {
        const uint64_t before = *points;
        const double left = fmin((double)(a->draws - draws),
                                 DRAWS_AHEAD * (double)(a->keeps - *points));
        d->first = draws;
        d->batches = (uint64_t)fmin(WAVE_BATCHES, ceil(left / BATCH_DRAWS));
        murk_pool_run(d->source->threads, d->batches, draw_batch, d);
        status = murk_interrupted()
                     ? murk_fail(err, MURK_INTERRUPTED, "", "interrupted")
                     : take_up(buffer, d, a, points, &draws, err);
        murk_progress_add(*points - before);
    }
    murk_progress_end();
    if (!status && *points == 0) {
        status = murk_fail(err, MURK_BAD_VALUE, where,
                           "none of %llu points drawn lies in free space",
                           (unsigned long long)draws);
    }
    if (!status) {
        out->size = price(buffer, *points, draws, *points == a->keeps, size);
    }
    return status;
}

static void release(drawing *d)
{
    murk_open_space_destroy(d->space);
    murk_area_destroy(d->area);
    free(d->wave);
}

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
    bool wanted[MURK_MATERIALS_MAX] = {false};
    for (size_t i = 0; i < settings->materials.n; ++i) {
        wanted[settings->materials.index[i]] = true;
    }
    murk_status status =
        murk_area_create(&d.area, stage->surfaces,
                         settings->materials.n > 0 ? wanted : NULL, where, err);
    if (!status) {
        const double s = settings->surface_spacing_m;
        status = amount_of(&a, source, settings->surface_points,
                           murk_area_m2(d.area) / (s * s), where, err);
    }
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

/* What holds all of a medium. */
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

static murk_box box_to_draw_from(const murk_stage *stage)
{
    const murk_scene_targets *settings = &stage->scene->placement.targets;
    const murk_vec3 r = {settings->radius_m, settings->radius_m,
                         settings->radius_m};
    murk_box box = stage->world.domain.box;
    if (settings->shape == MURK_REGION_BOX) {
        box = meet(box, settings->box);
    } else if (settings->shape == MURK_REGION_SPHERE) {
        box = meet(box, (murk_box){murk_sub(settings->center, r),
                                   murk_add(settings->center, r)});
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
    if (!(size.x > 0 && size.y > 0 && size.z > 0)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "holds none of the domain's space");
    }
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
