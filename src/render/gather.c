/* Density estimate on the photon maps: creates a kernel around each record that
 * counts, with the distance of the k-th nearest record as the radius, and sums
 * the kernels that contain a point. */
#include "render/gather.h"

#include <stdlib.h>

#include "base/pool.h"
#include "base/progress.h"
#include "render/balls.h"
#include "render/kernel.h"
#include "source/shine.h"

#define RECORDS_AT_ONCE 1024 /* that a thread takes at a time (a choice) */

/* Smallest radius as a share of the domain's diagonal: records that lie on one
 * spot, such as those of a beam without width, are spread at least so far (a
 * choice). */
#define MIN_RADIUS 1e-4

/* The records of one map and band that count, and their kernels. */
typedef struct layer {
    murk_photon_map *map;
    murk_kernel *kernel; /* [records], in the map's order */
    murk_balls *balls;
} layer;

struct murk_gather {
    const murk_scenery *scenery;
    double per_photon; /* groups per emitted photon */
    layer surface[MURK_BANDS_MAX], volume[MURK_BANDS_MAX];
};

size_t murk_gather_nearest(size_t records)
{
    const size_t k = (size_t)lround(sqrt((double)records) / 8);
    return k < MURK_GATHER_MIN   ? MURK_GATHER_MIN
           : k > MURK_GATHER_MAX ? MURK_GATHER_MAX
                                 : k;
}

/* ---- making ---- */

/* True for a surface record that faces the inside of a solid, where no shadow
 * ray is sent. */
static bool is_in_solid(const murk_scenery *scenery, const murk_photon *p)
{
    const murk_surfaces *surfaces = scenery->world->surfaces;
    return !murk_photon_is_volume(p) &&
           murk_surfaces_solid_at(
               surfaces, murk_along(murk_photon_place(p), scenery->margin_m,
                                    murk_photon_normal(p))) > 0;
}

static bool counts(const murk_gathering_desc *desc, const murk_photon *p,
                   int band)
{
    return murk_photon_band(p) == band &&
           (desc->takes_first || murk_photon_class(p) != 0 ||
            !murk_sources_can_shine(desc->scenery->world->lights,
                                    murk_photon_light(p)) ||
            is_in_solid(desc->scenery, p));
}

/* Copies the records of one map and band that count into a map of their own. */
static murk_status pick(murk_photon_map **out, const murk_gathering_desc *desc,
                        const murk_photon_map *map, int band, murk_error *err)
{
    const murk_photon *all = murk_photon_map_photons(map);
    const size_t n = murk_photon_map_count(map);
    size_t maximum = 0, picked = 0;
    for (size_t i = 0; i < n; ++i) {
        maximum += murk_photon_band(&all[i]) == band;
    }
    murk_photon *photons = malloc((maximum + 1) * sizeof *photons);
    if (!photons) {
        return murk_no_memory(err, "render", "for %zu photons", maximum);
    }
    for (size_t i = 0; i < n; ++i) {
        if (counts(desc, &all[i], band)) {
            photons[picked++] = all[i];
        }
    }
    murk_progress_add(maximum - picked);
    murk_photon *fitting = realloc(photons, (picked + 1) * sizeof *photons);
    return murk_photon_map_create(out, fitting ? fitting : photons, picked,
                                  desc->threads, err);
}

typedef struct laying {
    const murk_gathering_desc *desc;
    murk_probing probing;
    const layer *layer;
    murk_ball_extent *extent;
    double min_m;
} laying;

static murk_ball_extent extent_of(const murk_scenery *scenery,
                                  const murk_photon *p,
                                  const murk_kernel *kernel)
{
    const double r = kernel->radius_m;
    murk_ball_extent e = {.radius = (float)r};
    const murk_vec3 n = murk_photon_normal(p);
    const murk_vec3 center = murk_photon_place(p);
    /* A disc on a plane is flat, to rounding of places and normals. */
    const bool is_flat = !murk_photon_is_volume(p) && !kernel->is_cut;
    for (int axis = 0; axis < 3; ++axis) {
        const double along = murk_component(n, axis);
        const double flat =
            r * sqrt(fmax(0, 1 - along * along)) + 1e-3 * r + scenery->margin_m;
        e.center[axis] = (float)murk_component(center, axis);
        e.reach[axis] = (float)(is_flat ? fmin(flat, r) : r);
    }
    return e;
}

static void lay(void *context, uint64_t i)
{
    const laying *l = context;
    const murk_photon_map *map = l->layer->map;
    const murk_photon *p = murk_photon_map_photons(map) + i;
    /* The radius reaches the k-th nearest other record. */
    const size_t k = murk_gather_nearest(murk_photon_map_count(map)) + 1;
    uint32_t found[MURK_GATHER_MAX + 1];
    double square_m2[MURK_GATHER_MAX + 1];
    const size_t n =
        murk_photon_map_nearest(map, murk_photon_place(p), k, found, square_m2);
    const double radius = fmax(l->min_m, n > 0 ? sqrt(square_m2[n - 1]) : 0);
    murk_kernel *kernel = &l->layer->kernel[i];
    *kernel = murk_kernel_of(&l->probing, p, radius, i);
    l->extent[i] = extent_of(l->desc->scenery, p, kernel);
    murk_progress_add(1);
}

static murk_status make(layer *out, const murk_gathering_desc *desc,
                        const murk_photon_map *map, int band, murk_error *err)
{
    murk_status status = pick(&out->map, desc, map, band, err);
    if (status) {
        return status;
    }
    /* Allocate the kernels of the records that count. */
    const size_t n = murk_photon_map_count(out->map);
    const murk_box *box = &desc->scenery->world->domain.box;
    laying l = {.desc = desc,
                .probing = murk_probing_of(desc->scenery, desc->seed),
                .layer = out,
                .extent = calloc(n + 1, sizeof *l.extent),
                .min_m =
                    MIN_RADIUS * murk_length(murk_sub(box->max, box->min))};
    out->kernel = calloc(n + 1, sizeof *out->kernel);
    /* Compute the kernels, in parallel over the records, and build the
     * hierarchy that finds them. */
    if (!l.extent || !out->kernel) {
        status =
            murk_no_memory(err, "render", "for the kernels of %zu photons", n);
    } else {
        murk_pool_run_items(desc->threads, n, RECORDS_AT_ONCE, lay, &l);
        status = murk_balls_create(&out->balls, l.extent, n, err);
    }
    free(l.extent);
    return status;
}

static uint32_t last_emitted(const murk_photon_map *map)
{
    const murk_photon *photons = murk_photon_map_photons(map);
    uint32_t last = 0;
    for (size_t i = 0; i < murk_photon_map_count(map); ++i) {
        last = murk_photon_emitted(&photons[i]) > last
                   ? murk_photon_emitted(&photons[i])
                   : last;
    }
    return last;
}

murk_status murk_gather_create(murk_gather **out,
                               const murk_gathering_desc *desc, murk_error *err)
{
    murk_gather *g = calloc(1, sizeof *g);
    if (!g) {
        return murk_no_memory(err, "render", "for maps");
    }
    /* Groups of photons emitted one after the other. */
    g->scenery = desc->scenery;
    const double last =
        fmax(last_emitted(desc->surface), last_emitted(desc->volume));
    g->per_photon = MURK_GATHER_GROUPS / (last + 1);
    murk_status status = MURK_OK;
    murk_progress_begin("kernels",
                        murk_photon_map_count(desc->surface) +
                            murk_photon_map_count(desc->volume),
                        "photons");
    /* The kernels of both maps, band by band. */
    for (int band = 0; band < desc->scenery->world->bands && !status; ++band) {
        status = make(&g->surface[band], desc, desc->surface, band, err);
        if (!status) {
            status = make(&g->volume[band], desc, desc->volume, band, err);
        }
    }
    murk_progress_end();
    if (status) {
        murk_gather_destroy(g);
        return status;
    }
    *out = g;
    return MURK_OK;
}

static void unmake(layer *l)
{
    murk_photon_map_destroy(l->map);
    free(l->kernel);
    murk_balls_destroy(l->balls);
}

void murk_gather_destroy(murk_gather *gather)
{
    if (gather) {
        for (int band = 0; band < MURK_BANDS_MAX; ++band) {
            unmake(&gather->surface[band]);
            unmake(&gather->volume[band]);
        }
        free(gather);
    }
}

size_t murk_gather_records(const murk_gather *gather, bool of_volume, int band)
{
    return murk_photon_map_count(of_volume ? gather->volume[band].map
                                           : gather->surface[band].map);
}

static double layer_bytes(double n)
{
    return murk_photon_map_memory_for(n) + n * sizeof(murk_kernel) +
           murk_balls_memory_for(n);
}

double murk_gather_memory_for(double surface, double volume)
{
    return sizeof(murk_gather) + layer_bytes(surface) + layer_bytes(volume) +
           fmax(surface, volume) * sizeof(murk_ball_extent);
}

/* ---- asking ---- */

typedef struct asking {
    const murk_gather *gather;
    const layer *layer;
    const murk_shading_point *place;
    double scale;
    double *group;
    double sum;
} asking;

/* Power per steradian [W/sr] that one record sends towards the viewer; on a
 * surface, by the cosine law, divided by the cosine of the direction. The power
 * is that of the record, the phase function that of the point. In a medium 0
 * for a later event within the cone of the point. */
static double sent(const murk_shading_point *place, const murk_photon *p)
{
    if (!place->phase) {
        return murk_photon_power_w(p) / MURK_PI;
    }
    const double mu = -murk_dot(murk_photon_direction(p), place->sight);
    if (mu > place->cone && murk_photon_class(p) == MURK_CLASS_LATER) {
        return 0;
    }
    return murk_photon_power_w(p) *
           murk_phase_density(place->phase, fmax(-1, fmin(1, mu)));
}

static void take(void *context, size_t record, double square)
{
    asking *a = context;
    const murk_kernel *kernel = &a->layer->kernel[record];
    const murk_photon *p = murk_photon_map_photons(a->layer->map) + record;
    /* kernel->index is that of the regions, without solids; so inside a solid
     * the indices are not compared */
    const double index =
        a->place->is_in_solid ? kernel->index : a->place->index;
    if (kernel->mass > 0 &&
        murk_kernel_holds(a->gather->scenery, p, kernel, a->place->position,
                          a->place->normal, index)) {
        const size_t group =
            (size_t)(murk_photon_emitted(p) * a->gather->per_photon);
        const double light =
            a->scale * (1 - square) / kernel->mass * sent(a->place, p);
        a->group[group] += light;
        a->sum += light;
    }
}

double murk_gather_light(const murk_gather *gather,
                         const murk_shading_point *place, double scale,
                         double group[MURK_GATHER_GROUPS])
{
    const layer *l = place->phase ? &gather->volume[place->band]
                                  : &gather->surface[place->band];
    asking a = {.gather = gather,
                .layer = l,
                .place = place,
                .scale = scale / (place->index * place->index),
                .group = group};
    murk_balls_at(l->balls, place->position, take, &a);
    return a.sum;
}

double murk_gather_variance(const double group[MURK_GATHER_GROUPS])
{
    const double n = MURK_GATHER_GROUPS;
    double sum = 0, squares = 0;
    for (int i = 0; i < MURK_GATHER_GROUPS; ++i) {
        sum += group[i];
        squares += group[i] * group[i];
    }
    return fmax(0, squares - sum * sum / n) * n / (n - 1);
}
