/* Regions placed in the world (medium/place.h). Rays and points are
 * transformed into the frame of the shape, or into the index space of the
 * grid, and tested there. */
#include "medium/place.h"

#include "medium/clip.h"
#include "medium/grid_internal.h"
#include "medium/layers.h"
#include "medium/linear.h"

#include <math.h>
#include <string.h>

/* Bounding box of the image of a sphere. An affine map takes a sphere to an
 * ellipsoid. Half of the extent of the ellipsoid along the axis i is the radius
 * times the length of row i of the matrix. */
static murk_box sphere_bounds(const murk_affine *map, murk_vec3 center,
                              double radius)
{
    const double(*m)[3] = map->matrix;
    const murk_vec3 reach = {
        radius *
            sqrt(m[0][0] * m[0][0] + m[0][1] * m[0][1] + m[0][2] * m[0][2]),
        radius *
            sqrt(m[1][0] * m[1][0] + m[1][1] * m[1][1] + m[1][2] * m[1][2]),
        radius *
            sqrt(m[2][0] * m[2][0] + m[2][1] * m[2][1] + m[2][2] * m[2][2])};
    const murk_vec3 middle = murk_affine_point(map, center);
    return (murk_box){murk_sub(middle, reach), murk_add(middle, reach)};
}

/* Places a grid. The density is 0 beyond the voxels; a trilinear field
 * extends one voxel beyond the outermost centres. */
static bool place_grid(murk_place *place, const murk_region *region,
                       const murk_medium *medium)
{
    const murk_affine to_world = murk_affine_compose(
        &region->to_world, &murk_grid_describe(medium->grid)->index_to_world);
    const bool is_linear = medium->interpolation == MURK_LINEAR;
    place->field = murk_grid_rectilinear(medium->grid);
    if (!murk_affine_invert(&to_world, &place->to_index)) {
        return false;
    }
    if (place->field) {
        place->filling = MURK_FILLED_BY_RECTILINEAR;
        if (place->shape == MURK_REGION_GRID) {
            place->to_local = place->to_index;
            place->is_moved = true;
            place->bounds = murk_affine_box(&to_world, &place->field->box);
        }
        return true;
    }
    /* Index space; shifted by one half for nearest-neighbour interpolation. */
    place->filling = is_linear ? MURK_FILLED_BY_LINEAR : MURK_FILLED_BY_NEAREST;
    if (!is_linear) {
        place->to_index.shift =
            murk_add(place->to_index.shift, murk_vec(0.5, 0.5, 0.5));
    }
    place->tree = murk_grid_tree(medium->grid);
    if (place->shape != MURK_REGION_GRID) {
        return true;
    }
    /* The grid is the shape: its box bounds the region. */
    place->to_local = place->to_index;
    place->is_moved = true;
    const int32_t *first = place->tree->first, *last = place->tree->last;
    if (place->tree->n_cells > 0) {
        const double out = is_linear ? 1 : 0.5;
        const murk_box voxels = {
            {first[0] - out, first[1] - out, first[2] - out},
            {last[0] + out, last[1] + out, last[2] + out}};
        place->bounds = murk_affine_box(&to_world, &voxels);
    }
    return true;
}

bool murk_place_make(murk_place *place, const murk_region *region,
                     const murk_medium *medium)
{
    const murk_affine identity = murk_affine_identity();
    murk_place made = {.medium = region->medium,
                       .shape = region->shape,
                       .replaces = region->replaces || region->ior > 0,
                       .box = region->box,
                       .center = region->center,
                       .radius = region->radius_m,
                       .level = region->below_z_m,
                       .profile = medium->profile,
                       .filling = medium->profile ? MURK_FILLED_BY_LAYERS
                                                  : MURK_FILLED_EVENLY,
                       .bounds = murk_box_empty()};
    /* The frame of the shape. */
    const bool is_movable = region->shape != MURK_REGION_EVERYWHERE &&
                            region->shape != MURK_REGION_BELOW;
    const murk_affine *to_world = is_movable ? &region->to_world : &identity;
    if (!murk_affine_invert(to_world, &made.to_local)) {
        return false;
    }
    made.is_moved = memcmp(to_world, &identity, sizeof identity) != 0;
    /* The bounding box in world coordinates. */
    switch (region->shape) {
    case MURK_REGION_EVERYWHERE:
        made.bounds = (murk_box){{-INFINITY, -INFINITY, -INFINITY},
                                 {INFINITY, INFINITY, INFINITY}};
        break;
    case MURK_REGION_BELOW:
        made.bounds = (murk_box){{-INFINITY, -INFINITY, -INFINITY},
                                 {INFINITY, INFINITY, region->below_z_m}};
        break;
    case MURK_REGION_MESH:
        made.bounds = region->box;
        break;
    case MURK_REGION_BOX:
        made.bounds = murk_affine_box(&region->to_world, &region->box);
        break;
    case MURK_REGION_SPHERE:
        made.bounds =
            sphere_bounds(&region->to_world, region->center, region->radius_m);
        break;
    case MURK_REGION_GRID:
        break; /* below */
    }
    /* Grids of density and albedo. */
    if (medium->grid && !place_grid(&made, region, medium)) {
        return false;
    }
    if (medium->albedo_grid) {
        const murk_affine albedo_to_world = murk_affine_compose(
            &region->to_world,
            &murk_grid_describe(medium->albedo_grid)->index_to_world);
        if (!murk_affine_invert(&albedo_to_world, &made.to_albedo)) {
            return false;
        }
    }
    const bool is_bounded = made.shape != MURK_REGION_EVERYWHERE &&
                            made.shape != MURK_REGION_BELOW &&
                            !(made.shape == MURK_REGION_GRID && !made.field &&
                              made.tree->n_cells == 0);
    if (is_bounded &&
        !(murk_is_finite(made.bounds.min) && murk_is_finite(made.bounds.max))) {
        return false; /* overflow or NaN in the placement */
    }
    *place = made;
    return true;
}

bool murk_place_clip(const murk_place *place, const murk_vec3 *origin,
                     const murk_vec3 *direction, double *t0, double *t1)
{
    const murk_vec3 *o = origin, *d = direction;
    murk_vec3 moved_o, moved_d;
    if (place->is_moved) {
        moved_o = murk_affine_point(&place->to_local, *origin);
        moved_d = murk_affine_direction(&place->to_local, *direction);
        o = &moved_o;
        d = &moved_d;
    }
    switch (place->shape) {
    case MURK_REGION_EVERYWHERE:
    case MURK_REGION_MESH: /* the caller knows that the ray is inside */
        return *t0 < *t1;
    case MURK_REGION_BELOW:
        murk_clip_coordinate(-INFINITY, place->level, o->z, d->z, t0, t1);
        return *t0 < *t1;
    case MURK_REGION_BOX:
        murk_clip_box(&place->box, *o, *d, t0, t1);
        return *t0 < *t1;
    case MURK_REGION_SPHERE:
        murk_clip_sphere(place->center, place->radius, *o, *d, t0, t1);
        return *t0 < *t1;
    case MURK_REGION_GRID:
        if (place->field) {
            murk_clip_box(&place->field->box, *o, *d, t0, t1);
            return *t0 < *t1;
        }
        return murk_grid_clip(place->tree,
                              place->filling == MURK_FILLED_BY_LINEAR, *o, *d,
                              t0, t1);
    }
    return false;
}

bool murk_place_clip_filling(const murk_place *place, const murk_vec3 *origin,
                             const murk_vec3 *direction, double *t0, double *t1)
{
    if (place->filling == MURK_FILLED_BY_LAYERS) {
        murk_vec3 o = *origin, d = *direction;
        if (place->is_moved) {
            o = murk_affine_point(&place->to_local, *origin);
            d = murk_affine_direction(&place->to_local, *direction);
        }
        return murk_layers_clip(place->profile, o.z, d.z, t0, t1);
    }
    if (place->filling == MURK_FILLED_EVENLY ||
        place->shape == MURK_REGION_GRID) {
        return *t0 < *t1;
    }
    const murk_vec3 o = murk_affine_point(&place->to_index, *origin);
    const murk_vec3 d = murk_affine_direction(&place->to_index, *direction);
    if (place->field) {
        murk_clip_box(&place->field->box, o, d, t0, t1);
        return *t0 < *t1;
    }
    return murk_grid_clip(place->tree, place->filling == MURK_FILLED_BY_LINEAR,
                          o, d, t0, t1);
}

/* True if the world point p, which is `at` in the frame of the region, is
 * inside the filling; *density is then the density there. */
static bool filling_at(const murk_place *place, int band, murk_vec3 at,
                       murk_vec3 p, double *density)
{
    const bool is_grid = place->shape == MURK_REGION_GRID;
    switch (place->filling) {
    case MURK_FILLED_EVENLY:
        *density = 1;
        return true;
    case MURK_FILLED_BY_NEAREST:
    case MURK_FILLED_BY_LINEAR:
        at = is_grid ? at : murk_affine_point(&place->to_index, p);
        return place->filling == MURK_FILLED_BY_LINEAR
                   ? murk_linear_density(place->blocks, at, density)
                   : murk_tree_density(place->tree, at, density);
    case MURK_FILLED_BY_RECTILINEAR:
        at = is_grid ? at : murk_affine_point(&place->to_index, p);
        return murk_rectilinear_density(place->field, at, density);
    case MURK_FILLED_BY_LAYERS:
        return murk_layers_density(place->profile, band, at.z, density);
    }
    return false;
}

static bool shape_holds(const murk_place *place, murk_vec3 at)
{
    const murk_vec3 off = murk_sub(at, place->center);
    switch (place->shape) {
    case MURK_REGION_EVERYWHERE:
    case MURK_REGION_GRID: /* decided by the filling */
    case MURK_REGION_MESH: /* the caller knows that the point is inside */
        return true;
    case MURK_REGION_BELOW:
        return at.z < place->level;
    case MURK_REGION_BOX:
        return murk_box_holds(&place->box, at);
    case MURK_REGION_SPHERE:
        return murk_dot(off, off) < place->radius * place->radius;
    }
    return false;
}

bool murk_place_density(const murk_place *place, int band, murk_vec3 p,
                        double *density)
{
    const murk_vec3 at =
        place->is_moved ? murk_affine_point(&place->to_local, p) : p;
    if (!shape_holds(place, at)) {
        return false;
    }
    *density = 0;
    return filling_at(place, band, at, p, density) ||
           place->shape != MURK_REGION_GRID;
}
