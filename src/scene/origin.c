/* Chooses a scene's local origin by the rule in scene/origin.h, and makes every
 * position of the scene's structs relative to that origin. Rows of the key
 * table say which members are positions; solids are moved with their
 * placement. */
#include "scene/origin.h"

#include <math.h>

#include "scene/keys.h"

static double largest(murk_vec3 v)
{
    return fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
}

/* ---- bounding box of the scene ---- */

static murk_box with_box(murk_box box, murk_box other)
{
    return murk_box_with(murk_box_with(box, other.min), other.max);
}

static murk_box with_ball(murk_box box, murk_vec3 center, double radius)
{
    return with_box(box, murk_box_of_ball(center, radius));
}

static murk_box with_placed(murk_box box, const murk_affine *placed,
                            const murk_box *own)
{
    return with_box(box, murk_affine_box(placed, own));
}

static murk_box with_sphere(murk_box box, const murk_scene_solid *s)
{
    const murk_affine placed = murk_scene_placed(s);
    return with_ball(box, murk_affine_point(&placed, s->center),
                     s->radius_m * s->scale);
}

static murk_box with_geometry(murk_box box, const murk_scene_geometry *g)
{
    const murk_affine placed = murk_scene_placed(&g->solid);
    switch (g->shape) {
    case MURK_SHAPE_BOX:
        return with_placed(box, &placed, &g->solid.box);
    case MURK_SHAPE_SPHERE:
        return with_sphere(box, &g->solid);
    case MURK_SHAPE_RECT: {
        const murk_vec3 a = murk_add(g->corner, g->edge1),
                        b = murk_add(a, g->edge2);
        box = murk_box_with(box, murk_affine_point(&placed, g->corner));
        box = murk_box_with(box, murk_affine_point(&placed, a));
        return murk_box_with(box, murk_affine_point(&placed, b));
    }
    case MURK_SHAPE_MESH:
        break; /* the file has not been opened yet */
    }
    return box;
}

static murk_box with_region(murk_box box, const murk_scene_region *r)
{
    const murk_affine placed = murk_scene_placed(&r->solid);
    return r->shape == MURK_REGION_BOX
               ? with_placed(box, &placed, &r->solid.box)
           : r->shape == MURK_REGION_SPHERE ? with_sphere(box, &r->solid)
                                            : box;
}

static murk_box stated(const murk_scene_desc *s)
{
    murk_box box = murk_box_empty();
    for (size_t i = 0; i < s->geometries; ++i) {
        box = with_geometry(box, &s->geometry[i]);
    }
    for (size_t i = 0; i < s->n_regions; ++i) {
        box = with_region(box, &s->regions[i]);
    }
    for (size_t i = 0; i < s->n_lights; ++i) {
        const murk_scene_light *l = &s->lights[i];
        if (murk_source_type_group(l->type) == MURK_SOURCE_LAMP) {
            box = with_ball(box, l->position, l->radius_m);
        }
    }
    if (s->sensors.candidates.has_grid) {
        box = murk_box_with(box, s->sensors.candidates.grid_min);
        box = murk_box_with(box, s->sensors.candidates.grid_max);
    }
    for (size_t i = 0; i < s->sensors.n_fixed; ++i) {
        box = murk_box_with(box, s->sensors.fixed[i].position);
    }
    return box;
}

/* ---- the origin ---- */

/* True if a mesh bounds a profile in some region. Mesh and profile share one
 * frame, and profiles are moved in z; such scenes are not moved in z. */
static bool has_profile_in_mesh(const murk_scene_desc *s)
{
    bool has = false;
    for (size_t i = 0; i < s->n_regions; ++i) {
        const murk_scene_region *r = &s->regions[i];
        has = has || (r->shape == MURK_REGION_MESH &&
                      s->media[r->medium].profile_z_m.n > 0);
    }
    for (size_t i = 0; i < s->n_conditions; ++i) {
        has = has || has_profile_in_mesh(s->conditions[i].scene);
    }
    return has;
}

static murk_vec3 choose(const murk_scene_desc *s)
{
    const murk_vec3 none = {0, 0, 0};
    const murk_box box = s->has_domain ? s->domain.box : stated(s);
    const murk_vec3 size = murk_sub(box.max, box.min);
    const murk_vec3 middle = murk_scale(0.5, murk_add(box.min, box.max));
    const double longest = fmax(size.x, fmax(size.y, size.z));
    if (!(longest > 0 && isfinite(longest)) || !murk_is_finite(middle) ||
        !(largest(middle) > MURK_ORIGIN_FAR * longest / 2)) {
        return none;
    }
    const double grid = 2 * exp2(ceil(log2(longest)));
    return murk_vec(
        grid * nearbyint(middle.x / grid), grid * nearbyint(middle.y / grid),
        has_profile_in_mesh(s) ? 0 : grid * nearbyint(middle.z / grid));
}

/* ---- moving ---- */

static void move(murk_vec3 *p, murk_vec3 origin)
{
    *p = murk_sub(*p, origin);
}

static void move_box(murk_box *box, murk_vec3 origin)
{
    move(&box->min, origin);
    move(&box->max, origin);
}

/* The number that is subtracted from a coordinate of a shape along one axis:
 * the origin if this brings the coordinate closer to 0, otherwise 0. */
static double held_by(double own, double origin)
{
    return fabs(own - origin) < fabs(own) ? origin : 0;
}

/* Moves a solid. Changes the translation, and returns the vector that has been
 * subtracted from the coordinates of the solid itself, of which `at` is one
 * point. Without rotation and scale, the origin is subtracted from these
 * coordinates, too, if that makes them smaller (held_by()). is_file: the
 * coordinates are in a file and are not changed so. has_layers: the heights of
 * a profile share these coordinates; origin.z has been subtracted from the
 * heights and is subtracted from the coordinates in any case. */
static murk_vec3 move_solid(murk_scene_solid *s, murk_vec3 at, murk_vec3 origin,
                            bool is_file, bool has_layers)
{
    const bool is_plain = s->rotate_deg.x == 0 && s->rotate_deg.y == 0 &&
                          s->rotate_deg.z == 0 && s->scale == 1;
    murk_vec3 own = {0, 0, 0};
    if (is_plain && !is_file) {
        own = murk_vec(held_by(at.x, origin.x), held_by(at.y, origin.y),
                       held_by(at.z, origin.z));
    }
    if (has_layers) {
        own.z = origin.z;
    }
    /* A point q of the solid lies at p = M q + t. With q' = q - own for the
     * moved point, p - origin = M q' + (t + M own - origin): the last term is
     * the new translation. */
    const murk_vec3 none = {0, 0, 0};
    const murk_affine turn = murk_affine_place(s->rotate_deg, s->scale, none);
    const murk_vec3 back = is_plain ? own : murk_affine_direction(&turn, own);
    s->translate_m = murk_add(s->translate_m, murk_sub(back, origin));
    move_box(&s->box, own);
    move(&s->center, own);
    return own;
}

static void move_geometry(murk_scene_geometry *g, murk_vec3 origin)
{
    const murk_vec3 at = g->shape == MURK_SHAPE_BOX    ? g->solid.box.min
                         : g->shape == MURK_SHAPE_RECT ? g->corner
                                                       : g->solid.center;
    move(&g->corner,
         move_solid(&g->solid, at, origin, g->shape == MURK_SHAPE_MESH, false));
}

static void move_region(murk_scene_region *r, const murk_scene_medium *medium,
                        murk_vec3 origin)
{
    const bool is_file = r->shape == MURK_REGION_GRID ||
                         r->shape == MURK_REGION_MESH || medium->vdb ||
                         medium->fds || medium->netcdf || medium->albedo_vdb;
    move_solid(&r->solid,
               r->shape == MURK_REGION_BOX ? r->solid.box.min : r->solid.center,
               origin, is_file, medium->profile_z_m.n > 0);
}

static void move_zones(murk_scene_site_zone *zone, size_t n, murk_vec3 origin)
{
    for (size_t i = 0; i < n; ++i) {
        murk_scene_solid *s = &zone[i].solid;
        move_solid(s, zone[i].shape == MURK_REGION_BOX ? s->box.min : s->center,
                   origin, zone[i].shape == MURK_REGION_MESH, false);
    }
}

/* Moves the solid of a region of interest, or the volume of targets. A box or
 * a sphere there is in world coordinates; only a mesh is placed, by its
 * translation. */
static void move_in_world(murk_scene_solid *s, murk_vec3 origin)
{
    move_box(&s->box, origin);
    move(&s->center, origin);
    move(&s->translate_m, origin);
}

/* Moves the member of a row for a position: a vector, or heights. */
static void move_member(void *context, const murk_key *key, void *item)
{
    const murk_vec3 origin = *(const murk_vec3 *)context;
    void *const member = (char *)item + key->at;
    murk_scene_numbers z = {key->size / sizeof(double), member};
    if (!key->is_position) {
        return;
    }
    if (key->kind == MURK_KEY_VECTOR) {
        move(member, origin);
        return;
    }
    if (key->kind == MURK_KEY_NUMBER_LIST) {
        z = *(murk_scene_numbers *)member;
    }
    for (size_t i = 0; i < z.n; ++i) {
        z.value[i] -= origin.z;
    }
}

static void move_scene(murk_scene_desc *s, murk_vec3 origin)
{
    murk_scene_candidates *c = &s->sensors.candidates;
    s->origin = origin;
    murk_keys_visit(&murk_scene_keys, s, move_member, &origin);
    for (size_t i = 0; i < c->points.positions; ++i) {
        move(&c->points.position[i], origin);
    }
    /* Solids: some have coordinates of their own. */
    for (size_t i = 0; i < s->geometries; ++i) {
        move_geometry(&s->geometry[i], origin);
    }
    for (size_t i = 0; i < s->n_regions; ++i) {
        move_region(&s->regions[i], &s->media[s->regions[i].medium], origin);
    }
    move_zones(c->avoid, c->avoids, origin);
    move_zones(c->within, c->withins, origin);
    for (size_t i = 0; i < s->placement.n_interests; ++i) {
        move_in_world(&s->placement.interest[i].solid, origin);
    }
    move_in_world(&s->placement.targets.solid, origin);
}

void murk_origin_move(murk_scene_desc *scene)
{
    const murk_vec3 origin = choose(scene);
    if (origin.x == 0 && origin.y == 0 && origin.z == 0) {
        return;
    }
    move_scene(scene, origin);
    for (size_t i = 0; i < scene->n_conditions; ++i) {
        move_scene(scene->conditions[i].scene, origin);
    }
}
