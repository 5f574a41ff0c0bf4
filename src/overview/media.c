/* The media and regions of a scene as murk check reports them: coefficients,
 * grids, phase functions and bounds. */
#include "overview/parts.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/path.h"
#include "results/results.h"
#include "results/summary.h"
#include "scene/places.h"
#include "world/extent.h"

/* A table of a phase function is printed without a remark if its integral
 * differs from 1 by less than this, and if smaller shares than this lie before
 * its first and behind its last angle. Half a percent is below the accuracy of
 * published tables. */
#define TABLE_SLACK .005

/* The box around a region, in local coordinates. Of an unbounded region: the
 * part in the domain, within the heights of the profile; empty if nothing is
 * left. */
static murk_box local_box(const murk_stage *stage, size_t i)
{
    const murk_scene_region *r = &stage->scene->regions[i];
    murk_box box = stage->world.domain.box;
    if (murk_extent_is_bounded(r)) {
        return murk_extent_region(stage->scene, r, stage->grid[r->medium],
                                  stage->region_mesh[i]);
    }
    const murk_scene_numbers *z = &stage->scene->media[r->medium].profile_z_m;
    if (z->n > 0) {
        box.min.z = fmax(box.min.z, z->value[0]);
        box.max.z = fmin(box.max.z, z->value[z->n - 1]);
    }
    if (r->shape == MURK_REGION_BELOW && r->below_z_m < box.max.z) {
        box.max.z = r->below_z_m;
    }
    return box.min.z < box.max.z ? box : murk_box_empty();
}

static murk_box region_box(const murk_stage *stage, size_t i)
{
    return murk_scene_user_box(stage->scene, local_box(stage, i));
}

static const murk_phase *phase_of(const murk_stage *stage, size_t medium,
                                  int band)
{
    return &stage->phases->medium[medium][band];
}

/* The phase function of a band; if it is a table, with the facts that were
 * found when the table was normalised. */
static cJSON *phase_json(const murk_stage *stage, size_t medium, int band)
{
    const murk_scene_medium *m = stage->phases->source[medium];
    const murk_phase *phase = phase_of(stage, medium, band);
    cJSON *item = cJSON_CreateObject();
    cJSON_AddStringToObject(item, "kind", murk_phases_kind(m, band));
    murk_json_number(item, "mean_cosine", murk_phase_mean_cosine(phase));
    if (phase->table) {
        const murk_phase_facts *facts = murk_phase_table_facts(phase->table);
        murk_json_number(item, "backward", facts->backward);
        murk_json_number(item, "integral", facts->integral);
        murk_json_number(item, "before_first", facts->before_first);
        murk_json_number(item, "behind_last", facts->behind_last);
    }
    return item;
}

static void add_phases(cJSON *item, const murk_stage *stage, size_t medium)
{
    const int bands = stage->scene->bands;
    murk_spectrum mean = {{0}};
    cJSON *list = cJSON_AddArrayToObject(item, "phase");
    for (int band = 0; band < bands; ++band) {
        mean.band[band] = murk_phase_mean_cosine(phase_of(stage, medium, band));
        cJSON_AddItemToArray(list, phase_json(stage, medium, band));
    }
    murk_json_numbers(item, "mean_cosine", mean.band, bands);
}

static murk_spectrum profile_maximum(const murk_scene_medium *m)
{
    murk_spectrum upper = {{0}};
    for (size_t i = 0; i < m->profile_per_m.n; ++i) {
        for (int band = 0; band < MURK_BANDS_MAX; ++band) {
            upper.band[band] =
                fmax(upper.band[band], m->profile_per_m.value[i].band[band]);
        }
    }
    return upper;
}

/* up_m: the z of the local origin. */
static void add_profile(cJSON *item, const murk_scene_medium *m, double up_m,
                        int bands)
{
    const murk_scene_numbers *z = &m->profile_z_m;
    const double ends[] = {z->value[0] + up_m, z->value[z->n - 1] + up_m};
    const murk_spectrum upper = profile_maximum(m);
    cJSON *profile = cJSON_AddObjectToObject(item, "profile");
    murk_json_number(profile, "heights", (double)z->n);
    murk_json_numbers(profile, "z_m", ends, 2);
    murk_json_numbers(profile, "maximum_per_m", upper.band, bands);
}

static void add_grid(cJSON *item, const char *key, const murk_grid *grid)
{
    if (!grid) {
        return;
    }
    const murk_grid_facts *facts = murk_grid_describe(grid);
    cJSON *g = cJSON_AddObjectToObject(item, key);
    cJSON_AddStringToObject(g, "name", facts->name);
    murk_json_number(g, "active_voxels", (double)facts->active);
    murk_json_number(g, "minimum", facts->minimum);
    murk_json_number(g, "maximum", facts->maximum);
    murk_json_number(g, "sum", facts->sum);
    murk_json_numbers(g, "voxel_m", facts->voxel_m, 3);
    if (facts->blocks > 0) {
        murk_json_number(g, "meshes", (double)facts->blocks);
        cJSON_AddStringToObject(g, "note", facts->note);
    }
}

void murk_overview_json_media(cJSON *root, const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    cJSON *media = cJSON_AddArrayToObject(root, "media");
    for (size_t i = 0; i < scene->n_media; ++i) {
        const murk_scene_medium *m = stage->phases->source[i];
        cJSON *item = murk_json_item(media);
        cJSON_AddStringToObject(item, "name", m->name);
        /* Coefficients: a profile, a spectrum or grids. */
        if (m->profile_z_m.n > 0) {
            add_profile(item, m, scene->origin.z, scene->bands);
        } else if (!murk_scene_states_extinction(m)) {
            murk_json_numbers(item, "extinction_per_m",
                              m->extinction_per_m.band, scene->bands);
        }
        if (!m->albedo_grid) {
            murk_json_numbers(item, "albedo", m->albedo.band, scene->bands);
        }
        if (m->effective_variance > 0) {
            murk_json_number(item, "effective_radius_um",
                             m->effective_radius_um);
            murk_json_number(item, "effective_variance", m->effective_variance);
        }
        add_phases(item, stage, i);
        add_grid(item, "grid", stage->fillings->grid[i]);
        add_grid(item, "albedo_grid", stage->fillings->albedo[i]);
    }
    cJSON *regions = cJSON_AddArrayToObject(root, "regions");
    for (size_t i = 0; i < scene->n_regions; ++i) {
        const murk_scene_region *r = &scene->regions[i];
        cJSON *item = murk_json_item(regions);
        cJSON_AddStringToObject(item, "medium", scene->media[r->medium].name);
        const murk_box box = region_box(stage, i);
        murk_json_box(item, "bounds", &box);
        if (r->shape == MURK_REGION_MESH) {
            const murk_boundary_mesh_facts mesh =
                murk_boundary_meshes_describe(stage->boundary_meshes, (int)i);
            murk_json_number(item, "triangles", (double)mesh.triangles);
            murk_json_number(item, "crossings", (double)mesh.crossings);
        }
        if (r->ior > 0) {
            murk_json_number(item, "ior", r->ior);
        }
        if (r->wind_m_per_s > 0) {
            murk_json_number(item, "wind_m_per_s", r->wind_m_per_s);
        }
    }
}

static void print_phase(const murk_stage *stage, size_t medium, int band)
{
    const murk_phase *phase = phase_of(stage, medium, band);
    const char *kind = murk_phases_kind(stage->phases->source[medium], band);
    murk_print("%s, mean cosine %.6g", kind, murk_phase_mean_cosine(phase));
    if (phase->table) {
        murk_print(", %.4g backward",
                   murk_phase_table_facts(phase->table)->backward);
    }
    if (strcmp(kind, "table") == 0) {
        const murk_phase_facts *facts = murk_phase_table_facts(phase->table);
        const bool is_whole = fabs(facts->integral - 1) < TABLE_SLACK &&
                              facts->before_first < TABLE_SLACK &&
                              facts->behind_last < TABLE_SLACK;
        if (is_whole) {
            return;
        }
        murk_print(" (integral %.6g before it became 1; share before the first "
                   "row %.3g, behind the last %.3g)",
                   facts->integral, facts->before_first, facts->behind_last);
    }
}

static bool is_same(const murk_phase *a, const murk_phase *b)
{
    return a->table == b->table && murk_phase_is_same(a, b);
}

/* Prints one line for all bands, or one for each band if the phase functions of
 * bands differ. */
static void print_phases(const murk_stage *stage, size_t medium)
{
    const murk_scene_desc *scene = stage->scene;
    bool are_equal = true;
    for (int band = 1; band < scene->bands; ++band) {
        are_equal = are_equal && is_same(phase_of(stage, medium, band),
                                         phase_of(stage, medium, 0));
    }
    for (int band = 0; band < (are_equal ? 1 : scene->bands); ++band) {
        murk_print("phase       %s: ", scene->media[medium].name);
        if (!are_equal) {
            murk_print("%.6g nm ", scene->band_nm[band]);
        }
        print_phase(stage, medium, band);
        murk_print("\n");
    }
}

static void print_medium(const murk_stage *stage, size_t medium)
{
    const murk_scene_desc *scene = stage->scene;
    const murk_scene_medium *m = stage->phases->source[medium];
    const murk_fillings *fillings = stage->fillings;
    const murk_grid *grid = fillings->grid[medium];
    const murk_grid *albedo = fillings->albedo[medium];
    /* The extinction of a profile or of an even medium, then albedo and grid.
     */
    if (m->profile_z_m.n > 0) {
        murk_print(
            "medium      %s: %zu heights, %.4g to %.4g m, extinction up to "
            "%.6g /m",
            m->name, m->profile_z_m.n,
            m->profile_z_m.value[0] + scene->origin.z,
            m->profile_z_m.value[m->profile_z_m.n - 1] + scene->origin.z,
            profile_maximum(m).band[0]);
    } else if (m->netcdf && m->by_word) {
        murk_print("medium      %s: extinction %.6g /m times the density of %s",
                   m->name, m->extinction_per_m.band[0],
                   murk_path_name(m->netcdf));
    } else if (murk_scene_states_extinction(m)) {
        murk_print("medium      %s: extinction of %s", m->name,
                   murk_path_name(m->fds ? m->fds : m->netcdf));
    } else {
        murk_print("medium      %s: extinction %.6g /m", m->name,
                   m->extinction_per_m.band[0]);
    }
    if (albedo) {
        const murk_grid_facts *facts = murk_grid_describe(albedo);
        murk_print(", albedo %.4g..%.4g by grid %s, %.4g elsewhere",
                   facts->minimum, facts->maximum, facts->name,
                   facts->background);
    } else {
        murk_print(", albedo %.4g", m->albedo.band[0]);
    }
    if (m->effective_variance > 0) {
        murk_print(" of droplets, r %.4g um, variance %.4g",
                   m->effective_radius_um, m->effective_variance);
    }
    const murk_grid_facts *facts = grid ? murk_grid_describe(grid) : NULL;
    if (facts && facts->blocks > 0) {
        murk_print(
            "; %s: %llu values %s %zu %s%s, cells from %.4g m, "
            "%s %.4g..%.4g%s; %s",
            facts->name, (unsigned long long)facts->active,
            facts->has_nodes ? "at nodes of" : "of cells of", facts->blocks,
            m->fds ? "mesh" : "block",
            facts->blocks == 1 ? ""
            : m->fds           ? "es"
                               : "s",
            fmin(fmin(facts->voxel_m[0], facts->voxel_m[1]), facts->voxel_m[2]),
            m->by_word ? "density" : "extinction", facts->minimum,
            facts->maximum, m->by_word ? "" : " /m", facts->note);
    } else if (facts) {
        murk_print("; %sgrid %s: %llu voxels of %.4g m, density %.4g..%.4g",
                   m->is_linear ? "linear " : "", facts->name,
                   (unsigned long long)facts->active, facts->voxel_m[0],
                   facts->minimum, facts->maximum);
    }
}

void murk_overview_print_media(const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    const int digits = murk_coordinate_digits(scene, 4);
    /* The media. */
    for (size_t i = 0; i < scene->n_media; ++i) {
        print_medium(stage, i);
        murk_print("%s\n", scene->bands > 1 ? " (first band)" : "");
        print_phases(stage, i);
    }
    /* The regions: shape, bounds, index and waves. */
    for (size_t i = 0; i < scene->n_regions; ++i) {
        const murk_scene_region *r = &scene->regions[i];
        const murk_box box = region_box(stage, i);
        murk_print("region      %s", scene->media[r->medium].name);
        if (r->shape == MURK_REGION_EVERYWHERE) {
            murk_print(" everywhere");
            if (scene->media[r->medium].profile_z_m.n > 0) {
                murk_print(" at %.*g to %.*g m", digits, box.min.z, digits,
                           box.max.z);
            }
        } else if (r->shape == MURK_REGION_BELOW) {
            murk_print(" below z = %.*g m", digits,
                       r->below_z_m + scene->origin.z);
        } else if (!(box.min.x <= box.max.x)) {
            murk_print(", empty: %s", stage->grid[r->medium]
                                          ? "its grid has no active voxels"
                                            " in it"
                                          : "it holds no point");
        } else {
            murk_print(" in %.*g %.*g %.*g to %.*g %.*g %.*g m", digits,
                       box.min.x, digits, box.min.y, digits, box.min.z, digits,
                       box.max.x, digits, box.max.y, digits, box.max.z);
        }
        if (r->shape == MURK_REGION_MESH) {
            murk_print(
                ", a mesh of %zu triangles",
                murk_boundary_meshes_describe(stage->boundary_meshes, (int)i)
                    .triangles);
        }
        if (r->ior > 0) {
            murk_print(", index %.5g", r->ior);
        }
        if (r->wind_m_per_s > 0) {
            murk_print(", waves of %.3g m/s wind", r->wind_m_per_s);
        }
        murk_print("\n");
    }
}
