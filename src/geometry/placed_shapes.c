/* Converts descriptions of surfaces (mesh, box, rectangle, sphere) into
 * triangles and spheres in world coordinates, resolves the material names of
 * meshes, and refuses shapes without extent and coordinates out of range. */
#include "geometry/placed_shapes.h"

#include "base/position.h"
#include "geometry/triangle.h"

#include <assert.h>
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Embree's own limit is 1.8e18. At 1e9 m single precision already has steps
 * of 60 m, so a larger scene is a mistake in units. */
#define COORDINATE_MAX_M 1e9

/* Allowed relative deviation of a sphere's transformation from a similarity:
 * some 1e6 times the rounding of double precision, far below any shape that
 * is meant. */
#define SIMILAR 1e-9

/* Triangles of a box, by corner numbers whose bits 0, 1 and 2 select the
 * maximum of x, y and z; and of a rectangle, by corner numbers around the
 * rectangle. */
static const uint32_t BOX_CORNER[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6,
                                        0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3,
                                        0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
static const uint32_t RECT_CORNER[6] = {0, 1, 2, 0, 2, 3};

static murk_status check_shape(const murk_surface_desc *d, murk_error *err)
{
    /* Each kind of shape must have an extent. */
    const char *where = murk_place_of(d);
    const murk_box *b = &d->box;
    if (d->shape == MURK_SHAPE_BOX &&
        !(b->min.x < b->max.x && b->min.y < b->max.y && b->min.z < b->max.z)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "box from (%g, %g, %g) to (%g, %g, %g) m: each "
                         "maximum must exceed its minimum",
                         b->min.x, b->min.y, b->min.z, b->max.x, b->max.y,
                         b->max.z);
    }
    if (d->shape == MURK_SHAPE_RECT &&
        !(murk_length(murk_cross(d->edge1, d->edge2)) > 0)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "edges (%g, %g, %g) and (%g, %g, %g) m span no area",
                         d->edge1.x, d->edge1.y, d->edge1.z, d->edge2.x,
                         d->edge2.y, d->edge2.z);
    }
    if (d->shape == MURK_SHAPE_SPHERE &&
        !(d->radius_m > 0 && d->radius_m <= COORDINATE_MAX_M)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "radius is %g m, must be above 0 and at most %g",
                         d->radius_m, COORDINATE_MAX_M);
    }
    if (d->shape == MURK_SHAPE_MESH && !d->mesh) {
        return murk_fail(err, MURK_BAD_VALUE, where, "no mesh given");
    }
    return MURK_OK;
}

/* Scale factor of a similarity; NaN if the transformation is not one. */
static double similarity_scale(const murk_affine *a)
{
    murk_vec3 axis[3];
    for (int j = 0; j < 3; ++j) {
        axis[j] = murk_vec(a->matrix[0][j], a->matrix[1][j], a->matrix[2][j]);
    }
    const double scale = murk_length(axis[0]);
    const double slack = SIMILAR * scale;
    const bool is_similar = fabs(murk_length(axis[1]) - scale) <= slack &&
                            fabs(murk_length(axis[2]) - scale) <= slack &&
                            fabs(murk_dot(axis[0], axis[1])) <= slack * scale &&
                            fabs(murk_dot(axis[1], axis[2])) <= slack * scale &&
                            fabs(murk_dot(axis[2], axis[0])) <= slack * scale;
    return is_similar && scale > 0 ? scale : NAN;
}

static void count_shape(const murk_surface_desc *d, murk_placed_shapes *g)
{
    /* Numbers of vertices, triangles and spheres, so that memory is reserved
     * once. */
    switch (d->shape) {
    case MURK_SHAPE_MESH:
        g->vertices += d->mesh->vertices;
        g->triangles += d->mesh->triangles;
        g->degenerate += d->mesh->degenerate;
        break;
    case MURK_SHAPE_BOX:
        g->vertices += 8;
        g->triangles += 12;
        break;
    case MURK_SHAPE_RECT:
        g->vertices += 4;
        g->triangles += 2;
        break;
    case MURK_SHAPE_SPHERE:
        g->spheres += 1;
        break;
    }
}

static murk_status allocate(murk_placed_shapes *g, murk_error *err)
{
    g->vertex = malloc((g->vertices + 1) * sizeof *g->vertex);
    g->triangle = malloc((g->triangles + 1) * sizeof *g->triangle);
    g->sphere = malloc((g->spheres + 1) * sizeof *g->sphere);
    if (!g->vertex || !g->triangle || !g->sphere) {
        return murk_no_memory(err, "geometry", "for %zu triangles",
                              g->triangles);
    }
    g->vertices = g->triangles = g->spheres = 0;
    return MURK_OK;
}

/* 0 if the names are equal but for blanks and the case of letters. */
static int compare_letters(const char *a, const char *b)
{
    for (;; ++a, ++b) {
        a += strspn(a, " \t");
        b += strspn(b, " \t");
        if (!*a || tolower((unsigned char)*a) != tolower((unsigned char)*b)) {
            return *a || *b;
        }
    }
}

size_t murk_material_named(const char *name, const murk_material *materials,
                           size_t n, bool *is_named)
{
    static int (*const compare[])(const char *, const char *) = {
        strcmp, strcasecmp, compare_letters};
    *is_named = true;
    for (size_t k = 0; k < sizeof compare / sizeof *compare; ++k) {
        for (size_t i = 0; i < n; ++i) {
            if (compare[k](materials[i].name, name) == 0) {
                return i;
            }
        }
    }
    *is_named = false;
    return 0;
}

/* Adds a triangle with corners that are numbered from `first` on. */
static void add_triangle(murk_placed_shapes *g, uint32_t first,
                         const uint32_t *corner, uint32_t item,
                         uint8_t material)
{
    g->triangle[g->triangles++] = (murk_placed_triangle){
        .corner = {first + corner[0], first + corner[1], first + corner[2]},
        .item = item,
        .material = material};
}

static murk_status add_mesh(murk_placed_shapes *g, const murk_surface_desc *d,
                            uint32_t item, const murk_material *materials,
                            size_t n_materials, murk_error *err)
{
    const murk_mesh *m = d->mesh;
    uint8_t *own = malloc(m->materials + 1);
    if (!own) {
        return murk_no_memory(err, murk_place_of(d), "for %zu materials",
                              m->materials);
    }
    for (size_t i = 0; i < m->materials; ++i) {
        bool is_named;
        own[i] =
            (uint8_t)(d->material >= 0
                          ? (size_t)d->material
                          : murk_material_named(m->material_name[i], materials,
                                                n_materials, &is_named));
    }
    const uint32_t base = (uint32_t)g->vertices;
    /* The origin of the mesh and the translation of the shape are both large
     * for a mesh far from the origin. These two are added first, then the small
     * vertices, so that no digits are lost. */
    murk_affine to_world = d->to_world;
    to_world.shift = murk_affine_point(&d->to_world, m->origin_m);
    for (size_t i = 0; i < m->vertices; ++i) {
        const murk_vec3 p = murk_vertex(m->vertex_m, (uint32_t)i);
        g->vertex[g->vertices++] = murk_affine_point(&to_world, p);
    }
    for (size_t i = 0; i < m->triangles; ++i) {
        add_triangle(g, base, m->corner + 3 * i, item, own[m->material[i]]);
    }
    free(own);
    return MURK_OK;
}

static void add_flat(murk_placed_shapes *g, const murk_surface_desc *d,
                     uint32_t item, const murk_vec3 *point, size_t points,
                     const uint32_t *corner, size_t triangles)
{
    const uint32_t base = (uint32_t)g->vertices;
    for (size_t i = 0; i < points; ++i) {
        g->vertex[g->vertices++] = murk_affine_point(&d->to_world, point[i]);
    }
    for (size_t i = 0; i < triangles; ++i) {
        add_triangle(g, base, corner + 3 * i, item,
                     (uint8_t)(d->material > 0 ? d->material : 0));
    }
}

static void add_box(murk_placed_shapes *g, const murk_surface_desc *d,
                    uint32_t item)
{
    murk_vec3 point[8];
    for (int i = 0; i < 8; ++i) {
        point[i] = murk_vec(i & 1 ? d->box.max.x : d->box.min.x,
                            i & 2 ? d->box.max.y : d->box.min.y,
                            i & 4 ? d->box.max.z : d->box.min.z);
    }
    add_flat(g, d, item, point, 8, BOX_CORNER, 12);
}

static void add_rect(murk_placed_shapes *g, const murk_surface_desc *d,
                     uint32_t item)
{
    const murk_vec3 along = murk_add(d->corner, d->edge1);
    const murk_vec3 point[4] = {d->corner, along, murk_add(along, d->edge2),
                                murk_add(d->corner, d->edge2)};
    add_flat(g, d, item, point, 4, RECT_CORNER, 2);
}

static murk_status add_sphere(murk_placed_shapes *g, const murk_surface_desc *d,
                              murk_error *err)
{
    const double scale = similarity_scale(&d->to_world);
    if (!(scale > 0)) {
        return murk_fail(err, MURK_BAD_VALUE, murk_place_of(d),
                         "a sphere can be rotated, scaled alike in x, y, z, "
                         "and moved, nothing else");
    }
    g->sphere[g->spheres++] = (murk_stored_sphere){
        .center = murk_affine_point(&d->to_world, d->center),
        .radius = scale * d->radius_m,
        .material = (uint8_t)(d->material > 0 ? d->material : 0)};
    return MURK_OK;
}

static murk_status check_coordinates(const murk_placed_shapes *g,
                                     size_t first_vertex, size_t first_sphere,
                                     const char *where, murk_error *err)
{
    const murk_vec3 limit =
        murk_vec(COORDINATE_MAX_M, COORDINATE_MAX_M, COORDINATE_MAX_M);
    const murk_box world = {murk_scale(-1, limit), limit};
    const murk_vec3 *bad = NULL;
    for (size_t i = first_vertex; i < g->vertices && !bad; ++i) {
        bad = murk_box_contains(&world, g->vertex[i]) ? NULL : &g->vertex[i];
    }
    for (size_t i = first_sphere; i < g->spheres && !bad; ++i) {
        const bool fits = murk_box_contains(&world, g->sphere[i].center) &&
                          g->sphere[i].radius <= COORDINATE_MAX_M;
        bad = fits ? NULL : &g->sphere[i].center;
    }
    if (bad) {
        return murk_fail(
            err, MURK_BAD_VALUE, where,
            "a point is at %s m, coordinates must be within %g m of "
            "the origin",
            murk_position_show(*bad).text, COORDINATE_MAX_M);
    }
    return MURK_OK;
}

static murk_status add_all(murk_placed_shapes *g,
                           const murk_surface_desc *surfaces, size_t n,
                           const murk_material *materials, size_t n_materials,
                           murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < n && !status; ++i) {
        const murk_surface_desc *d = &surfaces[i];
        /* Remember the first vertex and sphere of this shape for the check
         * of coordinates. */
        const size_t first_vertex = g->vertices, first_sphere = g->spheres;
        switch (d->shape) {
        case MURK_SHAPE_MESH:
            status = add_mesh(g, d, (uint32_t)i, materials, n_materials, err);
            break;
        case MURK_SHAPE_BOX:
            add_box(g, d, (uint32_t)i);
            break;
        case MURK_SHAPE_RECT:
            add_rect(g, d, (uint32_t)i);
            break;
        case MURK_SHAPE_SPHERE:
            status = add_sphere(g, d, err);
            break;
        }
        if (!status) {
            status = check_coordinates(g, first_vertex, first_sphere,
                                       murk_place_of(d), err);
        }
    }
    return status;
}

murk_status murk_placed_shapes_build(murk_placed_shapes *g,
                                     const murk_surface_desc *surfaces,
                                     size_t n_surfaces,
                                     const murk_material *materials,
                                     size_t n_materials, murk_error *err)
{
    *g = (murk_placed_shapes){0};
    murk_status status = MURK_OK;
    /* Check each description and count vertices, triangles and spheres. */
    for (size_t i = 0; i < n_surfaces && !status; ++i) {
        assert(surfaces[i].material >= -1 &&
               surfaces[i].material < (int)n_materials);
        status = check_shape(&surfaces[i], err);
        if (!status) {
            count_shape(&surfaces[i], g);
        }
    }
    /* Indices have 32 bits. */
    if (!status && (g->vertices >= UINT32_MAX ||
                    g->triangles + g->spheres >= UINT32_MAX)) {
        status = murk_fail(err, MURK_BAD_VALUE, "geometry",
                           "%zu triangles with %zu vertices, must be fewer "
                           "than %u",
                           g->triangles, g->vertices, UINT32_MAX);
    }
    if (!status) {
        /* Reserve memory and convert the shapes. */
        status = allocate(g, err);
    }
    return status
               ? status
               : add_all(g, surfaces, n_surfaces, materials, n_materials, err);
}

void murk_placed_shapes_release(murk_placed_shapes *g)
{
    free(g->vertex);
    free(g->triangle);
    free(g->sphere);
}
