/* Bounding boxes of the items of a scene: each shape other than a sphere is
 * bounded in local coordinates, and the corners of that box are transformed
 * into the world. The box of a rotated item is therefore an upper bound, not
 * the smallest one. */
#include "world/extent.h"

#include "world/sky.h"

/* Margin as a fraction of the longest edge: 1 % by the manual of scene files.
 */
#define DOMAIN_MARGIN 0.01

bool murk_extent_is_box(const murk_box *box)
{
    return box->min.x <= box->max.x && box->min.y <= box->max.y &&
           box->min.z <= box->max.z;
}

murk_box murk_extent_join(murk_box a, murk_box b)
{
    return murk_extent_is_box(&b)
               ? murk_box_with(murk_box_with(a, b.min), b.max)
               : a;
}

/* The box of a placed sphere. */
static murk_box box_of_sphere(const murk_scene_solid *solid)
{
    const murk_affine placed = murk_scene_placed(solid);
    return murk_box_of_ball(murk_affine_point(&placed, solid->center),
                            solid->radius_m * solid->scale);
}

murk_box murk_extent_geometry(const murk_scene_geometry *g,
                              const murk_mesh *mesh)
{
    const murk_affine placed = murk_scene_placed(&g->solid);
    const murk_box box =
        g->shape == MURK_SHAPE_MESH ? mesh->bounds_m
        : g->shape == MURK_SHAPE_RECT
            ? murk_box_of_parallelogram(g->corner, g->edge1, g->edge2)
            : g->solid.box;
    return g->shape == MURK_SHAPE_SPHERE ? box_of_sphere(&g->solid)
                                         : murk_affine_box(&placed, &box);
}

bool murk_extent_is_bounded(const murk_scene_region *r)
{
    return r->shape != MURK_REGION_EVERYWHERE && r->shape != MURK_REGION_BELOW;
}

/* The part that two boxes have in common; empty if there is none. */
static murk_box meet(murk_box a, murk_box b)
{
    const murk_box both = murk_box_meet(a, b);
    return murk_extent_is_box(&both) ? both : murk_box_empty();
}

/* The box of the active voxels in world coordinates; empty if no voxel is
 * active. With nearest interpolation the density ends half a voxel beyond the
 * outermost voxel centres, with linear interpolation one voxel beyond them. */
static murk_box box_of_grid(const murk_affine *placed, const murk_grid *grid,
                            bool is_linear)
{
    const murk_grid_facts *facts = murk_grid_describe(grid);
    if (facts->active == 0) {
        return murk_box_empty();
    }
    if (facts->blocks > 0) {
        return murk_affine_box(placed, &facts->box);
    }
    const int64_t *low = facts->index_min, *high = facts->index_max;
    const double out = is_linear ? 1 : 0.5;
    const murk_box voxels = {
        {(double)low[0] - out, (double)low[1] - out, (double)low[2] - out},
        {(double)high[0] + out, (double)high[1] + out, (double)high[2] + out}};
    const murk_affine whole =
        murk_affine_compose(placed, &facts->index_to_world);
    return murk_affine_box(&whole, &voxels);
}

/* The intersection of the bounding box of a shape (sphere, mesh or box) with
 * the layers of a profile, whose heights are z_m, in the local coordinates of
 * the region; empty if the two are apart. */
static murk_box box_of_shape(const murk_scene_region *r, const murk_mesh *mesh,
                             const murk_scene_numbers *z_m)
{
    const murk_box layers = {{-INFINITY, -INFINITY, z_m->value[0]},
                             {INFINITY, INFINITY, z_m->value[z_m->n - 1]}};
    return meet(r->shape == MURK_REGION_SPHERE
                    ? murk_box_of_ball(r->solid.center, r->solid.radius_m)
                : r->shape == MURK_REGION_MESH ? mesh->bounds_m
                                               : r->solid.box,
                layers);
}

murk_box murk_extent_region(const murk_scene_desc *scene,
                            const murk_scene_region *r, const murk_grid *grid,
                            const murk_mesh *mesh)
{
    const murk_affine placed = murk_scene_placed(&r->solid);
    const bool is_linear = scene->media[r->medium].is_linear;
    /* The box of the shape alone. */
    murk_box box = murk_box_empty();
    switch (r->shape) {
    case MURK_REGION_SPHERE:
        box = box_of_sphere(&r->solid);
        break;
    case MURK_REGION_BOX:
        box = murk_affine_box(&placed, &r->solid.box);
        break;
    case MURK_REGION_MESH:
        box = murk_affine_box(&placed, &mesh->bounds_m);
        break;
    case MURK_REGION_GRID:
        return grid ? box_of_grid(&placed, grid, is_linear) : box;
    case MURK_REGION_EVERYWHERE:
    case MURK_REGION_BELOW:
        return box;
    }
    /* A region that replaces other media, or has an index of refraction, counts
     * with the whole shape. Otherwise the box is limited to the layers of a
     * profile or to the active voxels of a grid, if the medium has either. */
    const murk_scene_numbers *z_m = &scene->media[r->medium].profile_z_m;
    if (r->replaces || r->ior > 0) {
        return box;
    }
    if (z_m->n > 0) {
        const murk_box local = box_of_shape(r, mesh, z_m);
        return murk_extent_is_box(&local)
                   ? meet(box, murk_affine_box(&placed, &local))
                   : local;
    }
    return grid ? meet(box, box_of_grid(&placed, grid, is_linear)) : box;
}

murk_status murk_extent_domain(murk_domain *out, const murk_scene_desc *scene,
                               murk_mesh *const *mesh, murk_grid *const *grid,
                               murk_mesh *const *region_mesh, murk_error *err)
{
    if (scene->has_domain) {
        *out = scene->domain;
        return MURK_OK;
    }
    /* Bound the geometry alone: half spaces and distant light need it. */
    murk_box solid = murk_box_empty();
    for (size_t i = 0; i < scene->geometries; ++i) {
        solid = murk_extent_join(
            solid, murk_extent_geometry(&scene->geometry[i], mesh[i]));
    }
    /* Add the regions that are finite. */
    murk_box all = solid;
    for (size_t i = 0; i < scene->n_regions; ++i) {
        const murk_scene_region *r = &scene->regions[i];
        if (r->shape == MURK_REGION_BELOW && !murk_extent_is_box(&solid)) {
            return murk_fail(err, MURK_BAD_VALUE, r->where,
                             "a half space needs a domain or geometry");
        }
        if (murk_extent_is_bounded(r)) {
            all = murk_extent_join(
                all,
                murk_extent_region(scene, r, grid[r->medium], region_mesh[i]));
        }
    }
    /* Add the lamps. */
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const murk_scene_light *light = &scene->lights[i];
        if (murk_scene_light_is_distant(light) && !murk_extent_is_box(&solid)) {
            return murk_fail(err, MURK_BAD_VALUE, light->where,
                             "distant light needs a domain or geometry");
        }
        const murk_source lamp = murk_sky_lamp(light); /* empty if distant */
        all = murk_extent_join(all, murk_source_box(&lamp));
    }
    /* The box must have an edge longer than 0; then it is grown by the margin.
     */
    const murk_vec3 size = murk_sub(all.max, all.min);
    const double longest = fmax(size.x, fmax(size.y, size.z));
    if (!(longest > 0 && isfinite(longest))) {
        return murk_fail(err, MURK_BAD_VALUE, scene->path,
                         "domain: none given, and geometry, finite regions "
                         "and lamps span no space");
    }
    const double margin = DOMAIN_MARGIN * longest;
    const murk_vec3 grown = {margin, margin, margin};
    *out = (murk_domain){
        .box = {murk_sub(all.min, grown), murk_add(all.max, grown)}};
    return MURK_OK;
}
