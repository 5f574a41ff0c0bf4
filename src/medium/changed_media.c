/* Compares two sets of media, region by region, and the grids of regions that
 * are otherwise the same cell by cell. */
#include "medium/changed_media.h"

#include "medium/changed_grid.h"
#include "medium/grid_internal.h"
#include "medium/media_parts.h"

#include <string.h>

#define SAME(a, b, member) \
    (memcmp(&(a)->member, &(b)->member, sizeof(a)->member) == 0)

/* The cells of the grid of a medium that have changed. */
typedef struct changed_cells {
    bool are_all;        /* the regions of the medium have changed as a whole */
    murk_box_list cells; /* in index space where voxel i covers [i, i + 1); of a
                          * rectilinear grid in metres */
} changed_cells;

/* Walks through a grid begin at its box of active voxels, and round
 * accordingly: a grid of another box differs everywhere. */
static changed_cells compare_grids(const murk_grid *a, const murk_grid *b)
{
    changed_cells out = {0};
    if (a == b) {
        return out;
    }
    const murk_grid_facts *p = a ? murk_grid_describe(a) : NULL,
                          *q = b ? murk_grid_describe(b) : NULL;
    out.are_all = !p || !q || !SAME(p, q, index_min) ||
                  !SAME(p, q, index_max) || !SAME(p, q, index_to_world) ||
                  p->blocks != q->blocks;
    if (!out.are_all && p->blocks > 0) {
        murk_rectilinear_changes(&out.cells, murk_grid_rectilinear(a),
                                 murk_grid_rectilinear(b));
        out.are_all = out.cells.are_all;
    } else if (!out.are_all) {
        murk_changed_cells(&out.cells, murk_grid_tree(a), murk_grid_tree(b));
        out.are_all = out.cells.are_all;
    }
    return out;
}

static bool is_same_grid(const murk_grid *a, const murk_grid *b)
{
    const changed_cells changed = compare_grids(a, b);
    return !changed.are_all && changed.cells.n == 0;
}

static bool is_same_profile(const murk_profile *a, const murk_profile *b)
{
    if (a == b || !a || !b) {
        return a == b;
    }
    return a->n == b->n && memcmp(a->z_m, b->z_m, a->n * sizeof *a->z_m) == 0 &&
           memcmp(a->extinction_per_m, b->extinction_per_m,
                  a->n * sizeof *a->extinction_per_m) == 0;
}

/* The grid apart, compares all of a medium that optical depths depend on, and
 * with_scattering the rest. */
static bool is_same_medium(const murk_medium *a, const murk_medium *b,
                           bool with_scattering)
{
    bool is_same = SAME(a, b, extinction_per_m) &&
                   a->interpolation == b->interpolation &&
                   is_same_profile(a->profile, b->profile);
    if (with_scattering && is_same) {
        is_same =
            SAME(a, b, albedo) && is_same_grid(a->albedo_grid, b->albedo_grid);
        for (int band = 0; band < MURK_BANDS_MAX && is_same; ++band) {
            is_same = murk_phase_is_same(&a->phase[band], &b->phase[band]);
        }
    }
    return is_same;
}

static changed_cells compare_media(const murk_medium *a, const murk_medium *b,
                                   bool with_scattering)
{
    return is_same_medium(a, b, with_scattering)
               ? compare_grids(a->grid, b->grid)
               : (changed_cells){.are_all = true};
}

static bool is_same_place(const murk_place *a, const murk_place *b)
{
    return a->medium == b->medium && a->shape == b->shape &&
           a->filling == b->filling && a->replaces == b->replaces &&
           a->is_moved == b->is_moved && a->is_around == b->is_around &&
           SAME(a, b, box) && SAME(a, b, center) && SAME(a, b, radius) &&
           SAME(a, b, level) && SAME(a, b, to_local) && SAME(a, b, to_index) &&
           SAME(a, b, to_albedo);
}

/* True if the regions with an index of refraction are the same. */
static bool has_same_boundaries(const murk_media *a, const murk_media *b)
{
    bool has_same = a->n_boundaries == b->n_boundaries && SAME(a, b, near_m);
    for (size_t i = 0; i < a->n_boundaries && has_same; ++i) {
        const murk_region_boundary *p = &a->boundaries[i],
                                   *q = &b->boundaries[i];
        has_same = p->region == q->region && p->shape == q->shape &&
                   SAME(p, q, ior) && SAME(p, q, mean_square_slope) &&
                   SAME(p, q, to_local) && SAME(p, q, box) &&
                   SAME(p, q, center) && SAME(p, q, radius);
    }
    return has_same;
}

/* Adds the boxes of cells in the world. Interpolation between voxels reaches
 * one voxel further; the boxes of a rectilinear grid are complete. */
static void add_cells(murk_box_list *changed, const murk_place *place,
                      murk_box_list *cells)
{
    murk_affine to_world;
    if (!place->field) {
        murk_box_list_grow(cells, 2);
    }
    if (cells->n > 0 && !murk_affine_invert(&place->to_index, &to_world)) {
        changed->are_all = true;
        return;
    }
    for (size_t i = 0; i < cells->n; ++i) {
        murk_box_list_add(changed, murk_affine_box(&to_world, &cells->box[i]));
    }
}

void murk_changed_media(murk_box_list *changed, const murk_media *a,
                        const murk_media *b, bool with_scattering)
{
    /* The short cut of a medium that fills the domain rounds otherwise. */
    if (a->n_places != b->n_places || a->is_even != b->is_even ||
        a->n_media != b->n_media || !has_same_boundaries(a, b)) {
        changed->are_all = true;
        return;
    }
    for (size_t i = 0; i < a->n_places; ++i) {
        const murk_place *p = &a->places[i], *q = &b->places[i];
        changed_cells grid = {.are_all = true};
        if (is_same_place(p, q)) {
            grid = compare_media(&a->media[p->medium], &b->media[q->medium],
                                 with_scattering);
        }
        if (grid.are_all) {
            murk_box_list_add(changed, p->bounds);
            murk_box_list_add(changed, q->bounds);
        } else {
            add_cells(changed, p, &grid.cells);
        }
    }
}
