/* Builds the boundary meshes of the regions of a scene and refuses pairs of
 * regions with an index of refraction whose boundaries cross, if at least one
 * of the two is a mesh. Such regions must be nested or disjoint, because the
 * index at a place would be ambiguous otherwise. The geometric test of a mesh
 * against a mesh, a box, a sphere or a half space is in
 * geometry/boundary_meshes.h. */
#include "world/stage_build.h"

#include "base/position.h"

/* A face of a box region that lies in a side of the domain or beyond that side
 * is moved outwards before the box is tested against a mesh (open_faces()): to
 * this multiple of the largest absolute coordinate of the domain and the mesh.
 * Any factor above 1 keeps the face clear of both; 4 leaves a margin for
 * rounding. */
#define FAR_TIMES 4

static murk_affine placed(const murk_scene_region *r)
{
    return murk_scene_placed(&r->solid);
}

/* Moves outwards, to the coordinate far_m or -far_m, those faces of a box
 * region that lie in a side of the domain or beyond that side. The shape is in
 * world coordinates afterwards. A rotated box stays as it is. */
static void open_faces(murk_plain_shape *shape, const murk_scene_region *r,
                       const murk_box *domain, double far_m)
{
    const murk_vec3 turn = r->solid.rotate_deg;
    if (turn.x != 0 || turn.y != 0 || turn.z != 0) {
        return;
    }
    const murk_vec3 low = murk_affine_point(&shape->to_world, r->solid.box.min);
    const murk_vec3 high =
        murk_affine_point(&shape->to_world, r->solid.box.max);
    shape->to_world = murk_affine_identity();
    shape->box = (murk_box){{low.x <= domain->min.x ? -far_m : low.x,
                             low.y <= domain->min.y ? -far_m : low.y,
                             low.z <= domain->min.z ? -far_m : low.z},
                            {high.x >= domain->max.x ? far_m : high.x,
                             high.y >= domain->max.y ? far_m : high.y,
                             high.z >= domain->max.z ? far_m : high.z}};
}

/* True if the boundary of a region r that is no mesh crosses the boundary mesh
 * of the region with the number `mesh`; *place then receives a corner of a
 * triangle of the mesh, for the message. */
static bool crosses_plain(const murk_boundary_meshes *boundary_meshes, int mesh,
                          const murk_scene_region *r, const murk_box *domain,
                          murk_vec3 *place)
{
    murk_plain_shape shape = {.shape = r->shape,
                              .box = r->solid.box,
                              .center = r->solid.center,
                              .radius_m = r->solid.radius_m,
                              .to_world = placed(r)};
    const murk_box bounds =
        murk_boundary_meshes_describe(boundary_meshes, mesh).bounds_m;
    if (r->shape == MURK_REGION_BOX) {
        open_faces(&shape, r, domain,
                   FAR_TIMES * fmax(murk_box_largest_coordinate(domain),
                                    murk_box_largest_coordinate(&bounds)));
    } else if (r->shape == MURK_REGION_BELOW) {
        shape.box.max.z = r->below_z_m;
    } else if (r->shape != MURK_REGION_SPHERE) {
        return false; /* everywhere contains all regions; a region with the
                       * shape of a grid has no index of refraction */
    }
    return murk_boundary_meshes_meet_plain(boundary_meshes, mesh, &shape,
                                           place);
}

/* True if the boundaries of the regions a and b cross, both regions have an
 * index of refraction, and at least one of the two is a mesh; *place then
 * receives a point for the message (geometry/boundary_meshes.h). */
static bool cross(const murk_boundary_meshes *boundary_meshes,
                  const murk_scene_desc *scene, size_t a, size_t b,
                  const murk_box *domain, murk_vec3 *place)
{
    const murk_scene_region *one = &scene->regions[a];
    const murk_scene_region *other = &scene->regions[b];
    const bool is_mesh = one->shape == MURK_REGION_MESH;
    const bool other_is_mesh = other->shape == MURK_REGION_MESH;
    if (!(one->ior > 0 && other->ior > 0)) {
        return false;
    }
    if (is_mesh && other_is_mesh) {
        return murk_boundary_meshes_meet(boundary_meshes, (int)a, (int)b,
                                         place);
    }
    return is_mesh
               ? crosses_plain(boundary_meshes, (int)a, other, domain, place)
           : other_is_mesh
               ? crosses_plain(boundary_meshes, (int)b, one, domain, place)
               : false;
}

static murk_status check_pairs(const murk_boundary_meshes *boundary_meshes,
                               const murk_scene_desc *scene,
                               const murk_box *domain, murk_error *err)
{
    for (size_t later = 0; later < scene->n_regions; ++later) {
        for (size_t i = 0; i < later; ++i) {
            murk_vec3 p;
            if (cross(boundary_meshes, scene, i, later, domain, &p)) {
                return murk_fail(
                    err, MURK_BAD_VALUE, scene->regions[later].where,
                    "crosses %s near %s m, must lie in it, hold it or lie "
                    "apart: both have an index of refraction",
                    scene->regions[i].where, murk_position_show(p).text);
            }
        }
    }
    return MURK_OK;
}

murk_status murk_stage_boundary_meshes(murk_boundary_meshes **out,
                                       const murk_scene_desc *scene,
                                       murk_mesh *const *mesh,
                                       const murk_box *domain, murk_error *err)
{
    murk_boundary_mesh_desc desc[MURK_BOUNDARY_MESHES_MAX];
    murk_boundary_meshes *made = NULL;
    /* Describe the regions that are meshes. */
    size_t n = 0;
    for (size_t i = 0; i < scene->n_regions; ++i) {
        const murk_scene_region *r = &scene->regions[i];
        if (r->shape == MURK_REGION_MESH) {
            desc[n++] = (murk_boundary_mesh_desc){.region = (int)i,
                                                  .mesh = mesh[i],
                                                  .to_world = placed(r),
                                                  .where = r->where};
        }
    }
    /* Build the meshes; if there are any, test every pair of regions. */
    murk_status status = murk_boundary_meshes_create(&made, desc, n, err);
    if (!status && made) {
        status = check_pairs(made, scene, domain, err);
    }
    if (status) {
        murk_boundary_meshes_destroy(made);
        return status;
    }
    *out = made;
    return MURK_OK;
}
