/* Takes a picture: follows the rays of each pixel in every band, sums
 * radiances and their squares, and derives the standard errors. Pixels are
 * computed in square tiles; the sums of a tile are added in the order of the
 * tiles, so that the result does not depend on threads. */
#include "render/render.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "base/interrupt.h"
#include "base/pool.h"
#include "base/progress.h"
#include "base/ranks.h"
#include "render/colour.h"
#include "render/pooled_errors.h"

#define TILE 16 /* pixels on each side */

/* If at least this share of the rays of a pixel hits a light directly, the
 * samples of the pixel give the variance well enough, because the edge of a
 * lamp is no rare path; the pixel is then not pooled. */
#define LIT_SHARE 0.25

/* Different from the streams in which photons are traced. */
#define RENDER_STREAM 1000

/* Sums over the samples of a pixel in one band or colour. */
typedef struct sums {
    double sum, squares;
} sums;

/* Contributions of the maps to the samples of a pixel, by group of photons. */
typedef struct group_sums {
    double sum[MURK_GATHER_GROUPS], squares[MURK_GATHER_GROUPS];
    sums all;
} group_sums;

/* Sums over the pixels of a tile in one band: radiances, variances of the
 * samples, contributions of the maps by group, and in `noise` the part of the
 * variance between groups that comes from the samples (take_means()). */
typedef struct tile_sums {
    double radiance, variance, group[MURK_GATHER_GROUPS], noise;
} tile_sums;

typedef struct run {
    const murk_render *render;
    murk_image *picture;
    murk_scenery scenery;
    murk_gather *gather;
    murk_sampler **sampler; /* [threads] */
    size_t tiles_across;
    double colour[3][MURK_BANDS_MAX];
    tile_sums *tile; /* [tiles * bands] */
    uint8_t *is_lit; /* [pixels], by paths: lights are directly visible */
    float *scratch;  /* [pixels], by paths */
} run;

/* ---- a pixel ---- */

static void take(sums *s, double value)
{
    s->sum += value;
    s->squares += value * value;
}

static double mean_variance(const sums *s, double n)
{
    const double mean = s->sum / n;
    return n > 1 ? fmax(0, s->squares / n - mean * mean) / (n - 1) : INFINITY;
}

static void take_groups(group_sums *s, const double one[MURK_GATHER_GROUPS])
{
    double all = 0;
    for (int g = 0; g < MURK_GATHER_GROUPS; ++g) {
        s->sum[g] += one[g];
        s->squares[g] += one[g] * one[g];
        all += one[g];
    }
    take(&s->all, all);
}

/* Replaces s->sum by means over the samples. Returns the part of their variance
 * (murk_gather_variance()) that comes from the samples and is counted
 * separately. */
static double take_means(group_sums *s, double n)
{
    const double groups = MURK_GATHER_GROUPS;
    double noise = 0;
    for (int g = 0; g < MURK_GATHER_GROUPS; ++g) {
        s->sum[g] /= n;
        noise += fmax(0, s->squares[g] / n - s->sum[g] * s->sum[g]);
    }
    return n > 1 ? (noise / (n - 1) - mean_variance(&s->all, n) / groups) *
                       groups / (groups - 1)
                 : 0;
}

/* Distance, position and optical depth of the ray through the center of a
 * pixel. */
static void trace_center(const run *r, size_t x, size_t y, size_t at)
{
    const murk_camera *c = &r->render->camera;
    murk_image *p = r->picture;
    const murk_vec3 sight =
        murk_camera_sight(c, (double)x + 0.5, (double)y + 0.5);
    murk_camera_ray ray;
    if (!murk_scenery_begin(&r->scenery, &ray, c, (double)x + 0.5,
                            (double)y + 0.5, sight)) {
        p->distance_m[at] = NAN;
        p->position[0][at] = p->position[1][at] = p->position[2][at] = NAN;
        return;
    }
    const double reach =
        murk_scenery_find_end(&r->scenery, ray.origin, sight).distance_m;
    const murk_vec3 there = murk_along(ray.origin, reach, sight);
    p->distance_m[at] = (float)(ray.skipped_m + reach);
    p->position[0][at] = (float)there.x;
    p->position[1][at] = (float)there.y;
    p->position[2][at] = (float)there.z;
    for (int b = 0; b < p->bands; ++b) {
        p->depth[b][at] =
            (float)murk_scenery_depth(&r->scenery, b, ray.origin, sight, reach);
    }
}

/* The weight of a pixel in the mean of the picture; 1 on average. */
static double share_of_mean(const murk_camera *c, size_t x, size_t y)
{
    return c->projection == MURK_EQUIRECTANGULAR
               ? murk_camera_solid_angle(c, x, y) / (4 * MURK_PI) *
                     (double)c->width * (double)c->height
               : 1;
}

static void render_pixel(const run *r, murk_sampler *sampler, size_t x,
                         size_t y, tile_sums *tile)
{
    /* Sums of the pixel: by band, by colour, and by group of photons. */
    const murk_render *render = r->render;
    const murk_trace *trace = render->trace;
    murk_image *p = r->picture;
    const size_t at = y * p->width + x;
    const double n = (double)render->samples;
    sums band[MURK_BANDS_MAX] = {{0, 0}}, colour[3] = {{0, 0}};
    double part[MURK_BANDS_MAX][2] = {{0, 0}};
    group_sums group[MURK_BANDS_MAX], records[3] = {{.all = {0, 0}}};
    memset(group, 0, (size_t)p->bands * sizeof *group);
    size_t lit = 0; /* rays that hit a light directly */
    /* Follow the samples; all bands of a sample share a direction. */
    for (size_t i = 0; i < render->samples; ++i) {
        const uint64_t number = (uint64_t)at * render->samples + i;
        const murk_random4 u = murk_random(
            trace->seed, MURK_LENS + MURK_STREAM * RENDER_STREAM, number, 0, 0);
        const murk_vec3 sight =
            murk_camera_draw(&render->camera, x, y, u.u[0], u.u[1]);
        murk_camera_ray ray;
        const bool shows =
            murk_scenery_begin(&r->scenery, &ray, &render->camera,
                               (double)x + u.u[0], (double)y + u.u[1], sight);
        double rgb[3] = {0, 0, 0};
        /* contributions to colours */
        double own[3][MURK_GATHER_GROUPS] = {{0}};
        for (int b = 0; b < p->bands; ++b) {
            double one[MURK_GATHER_GROUPS] = {0}; /* contributions of the
                                                   * maps */
            murk_found found = {0};
            if (shows) {
                found = murk_sampler_trace(sampler, number, b, ray.origin,
                                           sight, one);
            }
            const double radiance = found.surface + found.volume;
            take(&band[b], radiance);
            lit += found.meets_light;
            part[b][0] += found.surface / n;
            part[b][1] += found.volume / n;
            for (int k = 0; k < 3; ++k) {
                rgb[k] += r->colour[k][b] * radiance;
                for (int g = 0; r->gather && g < MURK_GATHER_GROUPS; ++g) {
                    own[k][g] += r->colour[k][b] * one[g];
                }
            }
            if (r->gather) {
                take_groups(&group[b], one);
            }
        }
        for (int k = 0; k < 3; ++k) {
            take(&colour[k], rgb[k]);
            if (r->gather) {
                take_groups(&records[k], own[k]);
            }
        }
    }
    /* Radiances and errors of the bands, and their part in the mean of the
     * picture. */
    const double share = share_of_mean(&render->camera, x, y);
    for (int b = 0; b < p->bands; ++b) {
        const double variance = mean_variance(&band[b], n);
        const double noise = take_means(&group[b], n);
        for (int g = 0; g < MURK_GATHER_GROUPS; ++g) {
            tile[b].group[g] += share * group[b].sum[g];
        }
        tile[b].noise += share * share * noise;
        p->radiance[b][at] = (float)(band[b].sum / n);
        p->surface[b][at] = (float)part[b][0];
        p->volume[b][at] = (float)part[b][1];
        p->error[b][at] = (float)sqrt(
            variance + fmax(0, murk_gather_variance(group[b].sum) - noise));
        tile[b].radiance += share * (band[b].sum / n);
        tile[b].variance += share * share * variance;
    }
    /* Radiances and errors of the colours. */
    for (int k = 0; k < 3; ++k) {
        const double noise = take_means(&records[k], n);
        p->rgb[k][at] = (float)(colour[k].sum / n);
        p->rgb_error[k][at] =
            (float)sqrt(mean_variance(&colour[k], n) +
                        fmax(0, murk_gather_variance(records[k].sum) - noise));
    }
    if (r->is_lit) {
        r->is_lit[at] = (double)lit >= LIT_SHARE * n * p->bands;
    }
    trace_center(r, x, y, at);
}

static void render_tile(void *context, unsigned worker, uint64_t batch)
{
    const run *r = context;
    const murk_image *p = r->picture;
    const size_t left = batch % r->tiles_across * TILE;
    const size_t top = batch / r->tiles_across * TILE;
    for (size_t y = top; y < top + TILE && y < p->height; ++y) {
        for (size_t x = left; x < left + TILE && x < p->width; ++x) {
            if (murk_interrupted()) {
                return;
            }
            render_pixel(r, r->sampler[worker], x, y,
                         r->tile + batch * (size_t)p->bands);
            murk_progress_add(r->render->samples);
        }
    }
}

/* ---- a picture ---- */

static size_t channels_of(int bands)
{
    return (size_t)bands * 5 + 10;
}

double murk_image_bytes(size_t width, size_t height, int bands)
{
    return (double)width * (double)height * (double)channels_of(bands) *
           sizeof(float);
}

static size_t tiles_along(size_t pixels)
{
    return (pixels + TILE - 1) / TILE;
}

double murk_render_bytes(size_t width, size_t height, int bands,
                         murk_render_method method)
{
    const double pooling =
        method == MURK_BY_PATHS ? sizeof(float) + sizeof(uint8_t) : 0;
    return murk_image_bytes(width, height, bands) +
           (double)width * (double)height * pooling +
           (double)tiles_along(width) * (double)tiles_along(height) *
               (double)bands * sizeof(tile_sums);
}

static murk_image *picture_create(size_t width, size_t height, int bands)
{
    murk_image *p = calloc(1, sizeof *p);
    const size_t n = width * height;
    float *value = p ? calloc(n * channels_of(bands), sizeof *value) : NULL;
    if (!value) {
        free(p);
        return NULL;
    }
    /* All channels are one piece of memory, one behind the other. */
    p->width = width;
    p->height = height;
    p->bands = bands;
    for (int b = 0; b < bands; ++b) {
        float **const channel[] = {&p->radiance[b], &p->error[b],
                                   &p->surface[b], &p->volume[b], &p->depth[b]};
        for (size_t i = 0; i < sizeof channel / sizeof *channel; ++i) {
            *channel[i] = value;
            value += n;
        }
    }
    for (int k = 0; k < 3; ++k) {
        p->rgb[k] = value;
        p->rgb_error[k] = value + n;
        p->position[k] = value + 2 * n;
        value += 3 * n;
    }
    p->distance_m = value;
    return p;
}

void murk_image_destroy(murk_image *picture)
{
    if (picture) {
        free(picture->radiance[0]); /* all channels are one block of memory, */
        free(picture->seen_by);     /* except for these two */
        free(picture);
    }
}

murk_status murk_image_add_coverage(murk_image *picture, murk_error *err)
{
    const size_t n = picture->width * picture->height;
    picture->seen_by = malloc(2 * n * sizeof *picture->seen_by);
    if (!picture->seen_by) {
        return murk_no_memory(err, "render", "for the coverage of %zu pixels",
                              n);
    }
    picture->clarity = picture->seen_by + n;
    for (size_t i = 0; i < 2 * n; ++i) {
        picture->seen_by[i] = NAN;
    }
    return MURK_OK;
}

static murk_status set_up(run *r, size_t tiles, murk_error *err)
{
    /* Allocate the picture and the sums. */
    const murk_render *render = r->render;
    const murk_transport_world *world = render->trace->world;
    const unsigned threads = render->threads;
    r->sampler = calloc(threads, sizeof *r->sampler);
    r->tile = calloc(tiles * (size_t)world->bands, sizeof *r->tile);
    r->picture = picture_create(render->camera.width, render->camera.height,
                                world->bands);
    const bool by_paths = render->method == MURK_BY_PATHS;
    const size_t pixels = render->camera.width * render->camera.height;
    if (by_paths) {
        r->is_lit = calloc(pixels, sizeof *r->is_lit);
        r->scratch = calloc(pixels, sizeof *r->scratch);
    }
    if (!r->sampler || !r->tile || !r->picture ||
        (by_paths && !(r->is_lit && r->scratch))) {
        return murk_no_memory(
            err, "render", "for a picture of %zu x %zu pixels in %d bands",
            render->camera.width, render->camera.height, world->bands);
    }
    /* Prepare the world for shadow rays, and the maps for density estimates. */
    murk_status status = murk_scenery_prepare(&r->scenery, world, err);
    if (!status && render->method != MURK_BY_PATHS) {
        const murk_gathering_desc desc = {.scenery = &r->scenery,
                                          .surface = render->surface,
                                          .volume = render->volume,
                                          .takes_first = render->method ==
                                                         MURK_BY_MAPS_ONLY,
                                          .seed = render->trace->seed,
                                          .threads = threads};
        status = murk_gather_create(&r->gather, &desc, err);
        for (int b = 0; b < world->bands && !status; ++b) {
            r->picture->records[0][b] =
                murk_gather_records(r->gather, false, b);
            r->picture->records[1][b] = murk_gather_records(r->gather, true, b);
        }
    }
    murk_trace trace = *render->trace;
    trace.stream = RENDER_STREAM;
    for (unsigned i = 0; i < threads && !status; ++i) {
        status = murk_sampler_create(&r->sampler[i], &r->scenery,
                                     render->method, r->gather, &trace, err);
    }
    murk_colour_weights(world->bands, render->from_nm, render->to_nm,
                        r->colour);
    return status;
}

/* A job: the tiles are dealt to ranks in rounds. */
static void render_own_tile(void *context, unsigned worker, uint64_t k)
{
    render_tile(context, worker, murk_ranks_item(k));
}

/* Renders the tiles on all threads of all ranks. */
static murk_status render_tiles(run *r, size_t tiles, murk_error *err)
{
    murk_image *p = r->picture;
    const size_t pixels = p->width * p->height;
    murk_pool_run_workers(r->render->threads, murk_ranks_share(tiles),
                          render_own_tile, r);
    for (unsigned i = 0; i < r->render->threads; ++i) {
        p->lost += murk_sampler_lost(r->sampler[i]);
    }
    if (murk_ranks_count() == 1) {
        return MURK_OK;
    }
    /* All channels are one piece of memory. */
    murk_status status = murk_interrupt_check(err);
    status = murk_ranks_complete(p->radiance[0],
                                 pixels * channels_of(p->bands) * sizeof(float),
                                 status, err);
    status = murk_ranks_complete(
        r->tile, tiles * (size_t)p->bands * sizeof *r->tile, status, err);
    if (r->is_lit) {
        status = murk_ranks_complete(r->is_lit, pixels, status, err);
    }
    return murk_ranks_sum(&p->lost, 1, false, status, err);
}

static void add_up(run *r, size_t tiles)
{
    murk_image *p = r->picture;
    const double n = (double)(p->width * p->height);
    for (int b = 0; b < p->bands; ++b) {
        tile_sums all = {0};
        /* Sums in the order of the tiles. */
        for (size_t t = 0; t < tiles; ++t) {
            const tile_sums *tile = &r->tile[t * (size_t)p->bands + (size_t)b];
            all.radiance += tile->radiance;
            all.variance += tile->variance;
            all.noise += tile->noise;
            for (int g = 0; g < MURK_GATHER_GROUPS; ++g) {
                all.group[g] += tile->group[g];
            }
        }
        /* The error of the mean: noise of the samples, and noise of the
         * records, of which the part that the samples bring is counted once. */
        p->mean[b] = all.radiance / n;
        p->mean_error[b] =
            sqrt(all.variance +
                 fmax(0, murk_gather_variance(all.group) - all.noise)) /
            n;
    }
    p->rays = (uint64_t)n * r->render->samples * (uint64_t)p->bands;
}

/* Pools the errors of pixels (render/pooled_errors.h) of pictures by paths. By
 * maps, most of the noise of a pixel is that of the records, without rare
 * paths. */
static void pool_errors(run *r)
{
    murk_image *p = r->picture;
    const murk_render *render = r->render;
    const murk_pooling pooling = {.width = p->width,
                                  .height = p->height,
                                  .samples = render->samples,
                                  .is_round = render->camera.projection ==
                                              MURK_EQUIRECTANGULAR,
                                  .is_own = r->is_lit,
                                  .threads = render->threads};
    if (render->samples < 2 || murk_interrupted()) {
        return;
    }
    for (int b = 0; b < p->bands; ++b) {
        const size_t unsure =
            murk_pool_errors(&pooling, p->error[b], r->scratch);
        p->unsure = unsure > p->unsure ? unsure : p->unsure;
    }
    for (int k = 0; k < 3; ++k) {
        murk_pool_errors(&pooling, p->rgb_error[k], r->scratch);
    }
}

murk_status murk_render_run(murk_image **out, const murk_render *render,
                            murk_error *err)
{
    const murk_camera *c = &render->camera;
    assert(c->width > 0 && c->height > 0 && render->samples > 0);
    const size_t across = tiles_along(c->width);
    const size_t tiles = across * tiles_along(c->height);
    run r = {.render = render, .tiles_across = across};
    murk_status status = set_up(&r, tiles, err);
    /* Render the tiles, then sum them up. */
    if (!status) {
        murk_progress_begin("render", c->width * c->height * render->samples,
                            "rays");
        status = render_tiles(&r, tiles, err);
        murk_progress_end();
    }
    if (!status) {
        add_up(&r, tiles);
        if (r.is_lit) {
            pool_errors(&r);
        }
        *out = r.picture;
        r.picture = NULL;
    }
    /* Release everything but the picture that is handed over. */
    for (unsigned i = 0; r.sampler && i < render->threads; ++i) {
        murk_sampler_destroy(r.sampler[i]);
    }
    free(r.sampler);
    free(r.tile);
    free(r.is_lit);
    free(r.scratch);
    murk_gather_destroy(r.gather);
    murk_scenery_release(&r.scenery);
    murk_image_destroy(r.picture);
    return status;
}
