/* occlusion: what all candidates see, against raw Embree 16 wide.
 *
 * The 1188 candidates and 10000 stored photons of scenes/paper-room.yaml,
 * visibility only, so its glass is opaque here. Ours: range query, culling,
 * unpacking, and one shadow ray after another (an answer depends on the ray
 * alone). The reference casts exactly the sightlines that are left after range
 * and culling, packed 16 wide for each candidate beforehand, with the better of
 * Embree's two hints. Timings alternate; the figure is the median. Run from the
 * top folder. */
#include "base/pool.h"
#include "base/rng.h"
#include "peer_occlusion.h"
#include "sensing/candidates.h"
#include "sensing/sight.h"
#include "times.h"

#include <stdio.h>
#include <stdlib.h>

#define MESH    "scenes/meshes/paper-room.obj"
#define PHOTONS 10000
#define RANGE_M 7
#define THREADS 2
#define ALBEDO  0.6

/* Of the scene. */
static const murk_domain domain = {
    .box = {{-0.1, -0.1, -0.1}, {12.1, 10.1, 3.1}}};
static const murk_candidate_grid grid = {
    .min = {0.5, 0.45, 0.3}, .max = {11.5, 9.55, 2.7}, .size = {12, 11, 9}};
static const murk_vec3 lamps[] = {{3.6, 2.3, 2.4}, {9.5, 2.2, 2.4},
                                  {6.0, 5.2, 2.5}, {2.4, 8.0, 2.4},
                                  {5.9, 7.9, 2.5}, {9.4, 8.0, 2.4}};
#define LAMPS      (sizeof lamps / sizeof lamps[0])
#define CANDIDATES (12 * 11 * 9)

static _Noreturn void stop(const char *why)
{
    fprintf(stderr, "bench_occlusion: %s\n", why);
    exit(1);
}

static void require(murk_status status, const murk_error *err)
{
    if (status) {
        fprintf(stderr, "bench_occlusion: %s: %s\n", err->where, err->text);
        exit(1);
    }
}

static murk_surfaces *build_surfaces(const murk_mesh *mesh)
{
    const murk_material opaque = {.name = "default",
                                  .diffuse = murk_spectrum_flat(ALBEDO, 1)};
    const murk_surface_desc desc = {.shape = MURK_SHAPE_MESH,
                                    .mesh = mesh,
                                    .to_world = murk_affine_identity(),
                                    .where = MESH};
    murk_surfaces *surfaces;
    murk_error err = {0};
    require(murk_surfaces_create(&surfaces, &desc, 1, &opaque, 1, &err), &err);
    return surfaces;
}

/* One emitted photon: stored where it is reflected. Returns how many it stored,
 * `capacity` at most. */
static size_t trace(const murk_surfaces *surfaces, uint32_t emitted,
                    murk_photon *photon, size_t capacity)
{
    murk_random4 r = murk_random(1, MURK_TEST, emitted, 0, 0);
    murk_vec3 at = lamps[emitted % LAMPS];
    murk_vec3 direction =
        murk_about(murk_vec(0, 0, 1), 2 * r.u[0] - 1, 2 * MURK_PI * r.u[1]);
    size_t stored = 0;
    murk_hit hit;
    /* Follow the photon from surface to surface until it is absorbed. */
    for (uint32_t event = 1;
         stored < capacity &&
         murk_surfaces_hit(surfaces, at, direction, INFINITY, &hit);
         ++event) {
        r = murk_random(1, MURK_TEST, emitted, event, 0);
        at = murk_along(at, hit.distance_m, direction);
        if (r.u[0] > ALBEDO) {
            break;
        }
        /* Store the record, and leave along a cosine-distributed direction. */
        photon[stored++] =
            (murk_photon){.position_m = {(float)at.x, (float)at.y, (float)at.z},
                          .direction = murk_direction_pack(direction),
                          .normal = murk_direction_pack(hit.normal),
                          .power_w = 1,
                          .emitted = emitted};
        at = murk_surfaces_leave(surfaces, at, hit.normal);
        direction = murk_about(hit.normal, sqrt(r.u[1]), 2 * MURK_PI * r.u[2]);
    }
    return stored;
}

static murk_photon_map *store(const murk_surfaces *surfaces, size_t n)
{
    murk_photon *photon = malloc(n * sizeof *photon + 1);
    if (!photon) {
        stop("out of memory");
    }
    size_t stored = 0;
    for (uint32_t e = 0; stored < n; ++e) {
        stored += trace(surfaces, e, photon + stored, n - stored);
    }
    murk_photon_map *map;
    murk_error err = {0};
    require(murk_photon_map_create(&map, photon, n, 1, &err), &err);
    return map;
}

typedef struct contest {
    murk_surfaces *surfaces;
    murk_media *media;
    murk_photon_map *map, *empty;
    murk_vec3 candidate[CANDIDATES];
    murk_pose pose[CANDIDATES];
    peer_occlusion *peer;
    size_t rays;
} contest;

static murk_sight *sight_of(const contest *c, murk_visibility visibility)
{
    const murk_sensor_type type = {.range_m = RANGE_M};
    const murk_sight_desc desc = {.surfaces = c->surfaces,
                                  .media = c->media,
                                  .domain = domain,
                                  .surface_map = c->map,
                                  .volume_map = c->empty,
                                  .photons_emitted = UINT32_MAX,
                                  .type = &type,
                                  .types = 1,
                                  .visibility = visibility,
                                  .through_sheets = true,
                                  .weights = {.balanced = true},
                                  .threads = THREADS};
    murk_sight *sight;
    murk_error err = {0};
    require(murk_sight_create(&sight, &desc, &err), &err);
    return sight;
}

/* What is left after range and culling: what the normal test alone sees. */
static void pack_rays(contest *c)
{
    murk_sight *facing = sight_of(c, MURK_VISIBILITY_NORMAL);
    const murk_photon *photon = murk_photon_map_photons(c->map);
    const murk_vec3 zero = {0, 0, 0}, up = {0, 0, 1};
    const double trim_m =
        murk_length(murk_surfaces_leave(c->surfaces, zero, up));
    static murk_vec3 from[PHOTONS];
    /* Sightlines start off the surface, as they do in murk. */
    for (size_t j = 0; j < CANDIDATES; ++j) {
        murk_sparse_row row;
        murk_sight_row(facing, 0, &c->pose[j], &row);
        for (size_t k = 0; k < row.seen; ++k) {
            const murk_photon *p = &photon[row.photon[k]];
            const float *x = p->position_m;
            from[k] = murk_surfaces_leave(
                c->surfaces, murk_vec((double)x[0], (double)x[1], (double)x[2]),
                murk_direction_unpack(p->normal));
        }
        if (!peer_occlusion_add(c->peer, from, row.seen, c->candidate[j],
                                trim_m)) {
            stop("out of memory");
        }
        c->rays += row.seen;
    }
    murk_sight_destroy(facing);
}

static void build(contest *c)
{
    const murk_mesh_import as_written = {0};
    murk_mesh *mesh;
    murk_error err = {0};
    require(murk_mesh_read(&mesh, MESH, &as_written, MESH, &err), &err);
    c->surfaces = build_surfaces(mesh);
    c->peer = peer_occlusion_create(mesh);
    murk_mesh_destroy(mesh);
    if (!c->peer) {
        stop("no raw Embree scene");
    }
    require(murk_media_create(&c->media, NULL, 0, NULL, 0, &domain.box, &err),
            &err);
    c->map = store(c->surfaces, PHOTONS);
    c->empty = store(c->surfaces, 0);
    for (size_t i = 0; i < CANDIDATES; ++i) {
        c->candidate[i] = murk_candidate_grid_point(&grid, i);
        c->pose[i] = (murk_pose){.position = c->candidate[i]};
    }
    pack_rays(c);
}

static void tear_down(contest *c)
{
    peer_occlusion_destroy(c->peer);
    murk_photon_map_destroy(c->map);
    murk_photon_map_destroy(c->empty);
    murk_media_destroy(c->media);
    murk_surfaces_destroy(c->surfaces);
}

typedef struct occlusion_queries {
    murk_sight *sight;
    const murk_pose *pose;
    size_t seen[CANDIDATES];
} occlusion_queries;

static void query_row(void *context, unsigned worker, uint64_t batch)
{
    occlusion_queries *l = context;
    murk_sparse_row row;
    murk_sight_row(l->sight, worker, &l->pose[batch], &row);
    l->seen[batch] = row.seen;
}

/* Both count what is open; a few grazing rays in a million may differ. */
static void compare(const contest *c, const occlusion_queries *l,
                    size_t blocked)
{
    size_t seen = 0;
    for (size_t j = 0; j < CANDIDATES; ++j) {
        seen += l->seen[j];
    }
    const double differ =
        fabs((double)c->rays - (double)blocked - (double)seen);
    if (!(differ <= 1e-4 * (double)c->rays)) {
        stop("ours and the reference see different photons");
    }
}

static void report(const contest *c, occlusion_queries *l, unsigned threads)
{
    bench_times ours = {0}, peer[2] = {0}; /* by Embree's hint */
    size_t blocked = 0;
    for (int i = 0; i < BENCH_REPEATS; ++i) {
        bench_moment begun = bench_now();
        murk_pool_run_workers(threads, CANDIDATES, query_row, l);
        bench_add(&ours, i, begun);
        for (int coherent = 0; coherent < 2; ++coherent) {
            begun = bench_now();
            blocked = peer_occlusion_cast(c->peer, threads, coherent);
            bench_add(&peer[coherent], i, begun);
        }
    }
    compare(c, l, blocked);
    const bool best = bench_median_s(&peer[1]) < bench_median_s(&peer[0]);
    bench_print(&(bench_row){.name = "occlusion",
                             .unit = "rays/s",
                             .reference = "Embree 16 wide, rays given",
                             .threads = threads,
                             .work = (double)c->rays,
                             .reference_work = (double)c->rays,
                             .ours = &ours,
                             .theirs = &peer[best]});
}

int main(void)
{
    static contest c;
    build(&c);
    static occlusion_queries l;
    l.sight = sight_of(&c, MURK_VISIBILITY_RAY);
    l.pose = c.pose;
    for (unsigned threads = 1; threads <= THREADS; ++threads) {
        report(&c, &l, threads);
    }
    murk_sight_destroy(l.sight);
    tear_down(&c);
    return 0;
}
