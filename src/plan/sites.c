/* Describes the candidate sites of a scene to sensing/candidates.h, which tests
 * them: the grid, listed points, and sites on mounting surfaces
 * (geometry/mount_sites.h). */
#include "plan/sites.h"

#include "plan/free_space.h"
#include "plan/poses.h"
#include "world/site_zones.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The approximate number of points of a grid that the scene leaves to murk: the
 * manual states about 1000. */
#define GRID_POINTS 1000

/* The grid of the scene, or one over the domain. */
static murk_candidate_grid grid_of(const murk_stage *stage)
{
    const murk_scene_candidates *settings = &stage->scene->sensors.candidates;
    if (settings->has_grid) {
        return (murk_candidate_grid){.min = settings->grid_min,
                                     .max = settings->grid_max,
                                     .size = {settings->grid_size[0],
                                              settings->grid_size[1],
                                              settings->grid_size[2]},
                                     .clearance_m = settings->clearance_m};
    }
    murk_candidate_grid grid =
        murk_candidate_grid_fill(&stage->world.domain.box, GRID_POINTS);
    grid.clearance_m = settings->clearance_m;
    return grid;
}

/* ---- mounts ---- */

/* cos 45 degrees: a normal within 45 degrees of vertical faces up or down, any
 * other faces sideways. */
#define LEVEL_COSINE 0.70710678118654752

/* Restricts the normals of surfaces, and the directions of mounts, by the key
 * `facing`. rise is the absolute z component of a normal, up the signed one. */
static void face(const murk_scene_mount *settings, murk_mount_search *search,
                 murk_candidate_mount *mount)
{
    mount->min_up = -1;
    mount->max_up = 1;
    search->max_rise = 1;
    switch (settings->facing) {
    case MURK_SCENE_FACING_ANY:
        break;
    case MURK_SCENE_FACING_UP:
        search->min_rise = mount->min_up = LEVEL_COSINE;
        break;
    case MURK_SCENE_FACING_DOWN:
        search->min_rise = LEVEL_COSINE;
        mount->max_up = -LEVEL_COSINE;
        break;
    case MURK_SCENE_FACING_SIDE:
        search->max_rise = mount->max_up = LEVEL_COSINE;
        mount->min_up = -LEVEL_COSINE;
        break;
    }
}

/* Finds the sites of a mount on the surfaces: fills *mount except for the array
 * of sites, which *foot receives; the caller frees *foot. Fails if the spacing
 * is lost in rounding or if no surface has a site. */
static murk_status find_mount(murk_candidate_mount *mount,
                              murk_mount_site **foot,
                              const murk_scene_mount *settings,
                              const murk_stage *stage, murk_error *err)
{
    /* Select materials and heights. */
    const double min_m = murk_mount_spacing_min_m(stage->surfaces);
    bool material[MURK_MATERIALS_MAX] = {false};
    for (size_t i = 0; i < settings->materials.n; ++i) {
        material[settings->materials.index[i]] = true;
    }
    murk_mount_search search = {.spacing_m = settings->spacing_m,
                                .within = stage->world.domain.box,
                                .materials =
                                    settings->materials.n > 0 ? material : NULL,
                                .max = MURK_CANDIDATES_MAX / 2};
    if (settings->has_band) {
        search.within.min.z = fmax(search.within.min.z, settings->band_m[0]);
        search.within.max.z = fmin(search.within.max.z, settings->band_m[1]);
    }
    /* The spacing must exceed the rounding of positions. */
    if (!(settings->spacing_m > min_m)) {
        return murk_fail(err, MURK_BAD_VALUE, settings->where,
                         "spacing_m is %g m, must be more than %.3g m: less is "
                         "lost in rounding",
                         settings->spacing_m, min_m);
    }
    /* Find the sites. */
    mount->offset_m = settings->offset_m;
    face(settings, &search, mount);
    const murk_status status = murk_surfaces_mount_sites(
        foot, &mount->sites, stage->surfaces, &search, settings->where, err);
    if (!status && mount->sites == 0) {
        return murk_fail(err, MURK_BAD_VALUE, settings->where,
                         "nothing to mount on: in the domain no surface of "
                         "these materials, heights and ways of facing");
    }
    return status;
}

/* ---- all of them ---- */

/* The description of all candidates, with the arrays that it points to. */
typedef struct asked_candidates {
    murk_candidate_desc desc;
    murk_vec3 *point;
    murk_mount_site **site; /* [mounts] */
    murk_candidate_mount *mount;
    murk_zones *avoid, *within;
    murk_vec3 *lamp;
} asked_candidates;

static void release(asked_candidates *a)
{
    for (size_t i = 0; a->site && i < a->desc.mounts; ++i) {
        free(a->site[i]);
    }
    free(a->site);
    free(a->mount);
    free(a->point);
    free(a->lamp);
    murk_zones_destroy(a->avoid);
    murk_zones_destroy(a->within);
}

/* Fills the description: grid, listed points, mounts, zones. */
static murk_status describe_candidates(asked_candidates *a,
                                       const murk_stage *stage, murk_error *err)
{
    const murk_scene_candidates *settings = &stage->scene->sensors.candidates;
    /* The grid. */
    a->desc.grid = grid_of(stage);
    a->desc.is_reach_grid =
        !settings->has_grid && (settings->points.given || settings->mounts > 0);
    /* Listed points. */
    murk_status status = murk_site_points_read(&a->point, &a->desc.points,
                                               stage, MURK_CANDIDATES_MAX, err);
    if (status) {
        return status;
    }
    a->desc.point = a->point;
    /* Mounts. */
    a->mount = calloc(settings->mounts + 1, sizeof *a->mount);
    a->site = calloc(settings->mounts + 1, sizeof *a->site);
    if (!a->mount || !a->site) {
        return murk_no_memory(err, settings->where, "for its mounts");
    }
    a->desc.mount = a->mount;
    for (size_t i = 0; i < settings->mounts && !status; ++i) {
        ++a->desc.mounts;
        status = find_mount(&a->mount[i], &a->site[i], &settings->mount[i],
                            stage, err);
        a->mount[i].site = a->site[i];
    }
    /* Zones. */
    if (!status) {
        status = murk_site_zones_create(&a->avoid, &a->within, stage->scene,
                                        stage->zone_mesh, err);
    }
    a->desc.avoid = a->avoid;
    a->desc.within = a->within;
    return status;
}

murk_status murk_sites_find(murk_candidates **out, const murk_stage *stage,
                            unsigned threads, murk_error *err)
{
    const murk_scene_candidates *settings = &stage->scene->sensors.candidates;
    const bool is_grid_alone =
        settings->has_grid && !settings->points.given && settings->mounts == 0;
    asked_candidates a = {0};
    murk_reach reach;
    murk_status status =
        murk_entrances(&reach, &a.lamp, stage, settings->where, err);
    if (!status) {
        status = describe_candidates(&a, stage, err);
    }
    if (!status) {
        status = murk_candidates_create(
            out, &a.desc, stage->surfaces, &reach, threads,
            is_grid_alone ? settings->grid_where : settings->where, err);
    }
    release(&a);
    return status;
}

/* ---- several worlds ---- */

/* Removes from `all` the candidates that `other` does not have, and counts them
 * as unreached. Candidates are compared by exact position. Fails at `where` if
 * no candidate is left. */
static murk_status keep_common(murk_candidates *all,
                               const murk_candidates *other, const char *where,
                               murk_error *err)
{
    /* Sort the positions of the other. */
    murk_vec3 *sorted = malloc((other->usable + 1) * sizeof *sorted);
    if (!sorted) {
        return murk_no_memory(err, where, "for %zu candidates", other->usable);
    }
    memcpy(sorted, other->position, other->usable * sizeof *sorted);
    qsort(sorted, other->usable, sizeof *sorted, murk_by_position);
    /* Keep the candidates whose positions are in the sorted list. */
    size_t remaining = 0;
    for (size_t i = 0; i < all->usable; ++i) {
        if (bsearch(&all->position[i], sorted, other->usable, sizeof *sorted,
                    murk_by_position)) {
            all->position[remaining] = all->position[i];
            all->kind[remaining] = all->kind[i];
            if (all->normal) {
                all->normal[remaining] = all->normal[i];
            }
            ++remaining;
        }
    }
    free(sorted);
    all->unreached += all->usable - remaining;
    all->usable = remaining;
    return remaining > 0 ? MURK_OK
                         : murk_fail(err, MURK_BAD_VALUE, where,
                                     "no candidate is usable in it and in all "
                                     "conditions before it: of %zu usable here "
                                     "none",
                                     other->usable);
}

murk_status murk_sites_find_common(murk_candidates **out,
                                   const murk_stage *const *stage,
                                   const char *const *where, size_t n,
                                   unsigned threads, murk_error *err)
{
    murk_candidates *all = NULL;
    murk_status status = murk_sites_find(&all, stage[0], threads, err);
    for (size_t c = 1; !status && c < n; ++c) {
        murk_candidates *other = NULL;
        status = murk_sites_find(&other, stage[c], threads, err);
        if (!status) {
            status = keep_common(all, other, where[c], err);
        }
        murk_candidates_destroy(other);
    }
    if (status) {
        murk_candidates_destroy(all);
        return status;
    }
    *out = all;
    return MURK_OK;
}
