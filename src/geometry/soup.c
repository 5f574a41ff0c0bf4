/* Builds the triangle soup: chooses the anchor, rounds the vertices to single
 * precision, finds solids and sheets, and sorts by kind of face.
 *
 * Vertices are rounded once. From then on the float vertices define the
 * geometry, and all later computations in double precision start from them. */
#include "geometry/soup.h"

#include "base/log.h"
#include "geometry/closed.h"
#include "geometry/placed_shapes.h"

#include <stdlib.h>
#include <string.h>

/* A scene is stored relative to its own middle if the middle is farther from
 * the origin than this many times half of the size. With 4, at most 2 to 3
 * of 24 bits of precision are lost to the distance. */
#define FAR_AWAY 4.0

static murk_box box_with_spheres(murk_box box, const murk_stored_sphere *sphere,
                                 size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        const double radius = sphere[i].radius;
        const murk_vec3 r = murk_vec(radius, radius, radius);
        box = murk_box_with(box, murk_add(sphere[i].center, r));
        box = murk_box_with(box, murk_sub(sphere[i].center, r));
    }
    return box;
}

static double largest(murk_vec3 v)
{
    return fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
}

/* The anchor: 0 unless the scene is far from the origin. Otherwise the middle
 * of the scene, rounded on each axis to a multiple of the largest power of two
 * that does not exceed half of the size of the scene, so that subtracting the
 * anchor loses no digits in double precision. */
static murk_vec3 choose_anchor(const murk_box *box)
{
    const murk_vec3 middle = murk_scale(0.5, murk_add(box->min, box->max));
    const double half = 0.5 * largest(murk_sub(box->max, box->min));
    if (!(largest(middle) > FAR_AWAY * half && half > 0)) {
        return murk_vec(0, 0, 0);
    }
    const double grid = exp2(floor(log2(half)));
    return murk_vec(grid * nearbyint(middle.x / grid),
                    grid * nearbyint(middle.y / grid),
                    grid * nearbyint(middle.z / grid));
}

static murk_status store_vertices(murk_soup *soup, const murk_placed_shapes *g,
                                  murk_error *err)
{
    murk_box box = murk_box_empty();
    for (size_t i = 0; i < g->vertices; ++i) {
        box = murk_box_with(box, g->vertex[i]);
    }
    box = box_with_spheres(box, g->sphere, g->spheres);
    soup->anchor = choose_anchor(&box);
    /* Round the vertices once. */
    soup->vertices = g->vertices;
    soup->vertex = malloc(3 * (g->vertices + 1) * sizeof *soup->vertex);
    if (!soup->vertex) {
        return murk_no_memory(err, "geometry", "for %zu vertices", g->vertices);
    }
    for (size_t i = 0; i < g->vertices; ++i) {
        const murk_vec3 p = murk_sub(g->vertex[i], soup->anchor);
        soup->vertex[3 * i] = (float)p.x;
        soup->vertex[3 * i + 1] = (float)p.y;
        soup->vertex[3 * i + 2] = (float)p.z;
    }
    memset(soup->vertex + 3 * g->vertices, 0, 3 * sizeof *soup->vertex);
    for (size_t i = 0; i < g->spheres; ++i) {
        g->sphere[i].center = murk_sub(g->sphere[i].center, soup->anchor);
    }
    return MURK_OK;
}

/* Removes triangles that have no area after rounding. */
static void drop_degenerate(murk_soup *soup, murk_placed_shapes *g)
{
    size_t remaining = 0;
    soup->degenerate = g->degenerate;
    for (size_t i = 0; i < g->triangles; ++i) {
        const murk_triangle t =
            murk_triangle_at(soup->vertex, g->triangle[i].corner);
        if (murk_triangle_is_degenerate(&t)) {
            ++soup->degenerate;
            continue;
        }
        g->triangle[remaining++] = g->triangle[i];
    }
    g->triangles = remaining;
}

/* The face of a surface that is not the boundary of a solid. */
static murk_face face_of(const murk_material *material)
{
    for (int i = 0; i < MURK_BANDS_MAX; ++i) {
        if (material->transmit.band[i] > 0) {
            return MURK_FACE_SHEET;
        }
    }
    return MURK_FACE_OPAQUE;
}

static murk_status number_solid(murk_soup *soup, const char *where,
                                murk_error *err)
{
    if (soup->solids >= UINT16_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "more than %d closed shapes with an ior", UINT16_MAX);
    }
    ++soup->solids;
    return MURK_OK;
}

/* Finds the solid made of the triangles first..last-1 of one description
 * that have one material. All closed parts together are one solid, so that a
 * hollow shape of two closed surfaces is one object. Triangles that are not
 * closed are reported in a warning. */
static murk_status find_solid(murk_soup *soup, murk_placed_shapes *g,
                              size_t first, size_t last, uint8_t material,
                              const murk_surface_desc *d,
                              const char *material_name, murk_error *err)
{
    murk_status status = MURK_OK;
    size_t n = 0, n_closed = 0;
    uint32_t *index = malloc((last - first) * sizeof *index);
    uint32_t *corner = malloc(3 * (last - first) * sizeof *corner);
    bool *is_closed = malloc((last - first) * sizeof *is_closed);
    if (!index || !corner || !is_closed) {
        status =
            murk_no_memory(err, murk_place_of(d), "to look for closed parts");
        goto done;
    }
    /* Collect the triangles of this material, with vertices numbered from
     * the lowest one used. */
    uint32_t low = UINT32_MAX, high = 0;
    for (size_t i = first; i < last; ++i) {
        if (g->triangle[i].material == material) {
            memcpy(corner + 3 * n, g->triangle[i].corner, 3 * sizeof *corner);
            index[n++] = (uint32_t)i;
        }
    }
    for (size_t i = 0; i < 3 * n; ++i) {
        low = corner[i] < low ? corner[i] : low;
        high = corner[i] > high ? corner[i] : high;
    }
    for (size_t i = 0; i < 3 * n; ++i) {
        corner[i] -= low;
    }
    status =
        murk_closed_parts(soup->vertex + 3 * (size_t)low,
                          (size_t)high - low + 1, corner, n, is_closed, err);
    if (status) {
        goto done;
    }
    /* Closed triangles become the boundary of a new solid. */
    for (size_t i = 0; i < n; ++i) {
        n_closed += is_closed[i];
    }
    if (n_closed > 0) {
        status = number_solid(soup, murk_place_of(d), err);
    }
    for (size_t i = 0; i < n; ++i) {
        if (is_closed[i]) {
            g->triangle[index[i]].solid = (uint16_t)soup->solids;
            g->triangle[index[i]].face = MURK_FACE_SOLID;
        }
    }
    /* The open rest does not refract. */
    if (n_closed < n) {
        murk_warn(murk_place_of(d),
                  "material %s has an ior, but %zu of its %zu triangles are "
                  "not part of a closed surface: there it does not bend light",
                  material_name, n - n_closed, n);
    }
done:
    free(is_closed);
    free(corner);
    free(index);
    return status;
}

static murk_status classify(murk_soup *soup, murk_placed_shapes *g,
                            const murk_surface_desc *surfaces,
                            const murk_material *materials, size_t n_materials,
                            murk_error *err)
{
    /* Without an index of refraction a face is opaque or a sheet. */
    for (size_t i = 0; i < g->triangles; ++i) {
        g->triangle[i].face =
            (uint8_t)face_of(&materials[g->triangle[i].material]);
    }
    /* Each description and each of its materials with an index of refraction
     * may form a solid. */
    for (size_t first = 0, last; first < g->triangles; first = last) {
        bool has[MURK_MATERIALS_MAX] = {false};
        const uint32_t item = g->triangle[first].item;
        for (last = first;
             last < g->triangles && g->triangle[last].item == item; ++last) {
            has[g->triangle[last].material] = true;
        }
        for (size_t m = 0; m < n_materials; ++m) {
            if (has[m] && materials[m].ior > 0) {
                const murk_status status =
                    find_solid(soup, g, first, last, (uint8_t)m,
                               &surfaces[item], materials[m].name, err);
                if (status) {
                    return status;
                }
            }
        }
    }
    /* A sphere is always closed. */
    for (size_t i = 0; i < g->spheres; ++i) {
        murk_stored_sphere *b = &g->sphere[i];
        const murk_material *m = &materials[b->material];
        b->face = face_of(m);
        if (m->ior > 0) {
            const murk_status status = number_solid(soup, "geometry", err);
            if (status) {
                return status;
            }
            b->face = MURK_FACE_SOLID;
            b->solid = (uint16_t)soup->solids;
        }
    }
    return MURK_OK;
}

static murk_plane plane_of(const murk_soup *soup, const murk_placed_triangle *p)
{
    const murk_triangle t = murk_triangle_at(soup->vertex, p->corner);
    const murk_vec3 normal = murk_triangle_normal(&t);
    return (murk_plane){.point = t.a,
                        .normal = normal,
                        .inverse_length = 1 / murk_length(normal),
                        .solid = p->solid,
                        .material = p->material};
}

/* Stores triangles and spheres sorted by kind of face; the order within a
 * kind is kept. */
static murk_status store_faces(murk_soup *soup, const murk_placed_shapes *g,
                               murk_error *err)
{
    soup->corner = malloc((3 * g->triangles + 1) * sizeof *soup->corner);
    soup->plane = aligned_alloc(sizeof *soup->plane,
                                (g->triangles + 1) * sizeof *soup->plane);
    soup->sphere = malloc((g->spheres + 1) * sizeof *soup->sphere);
    if (!soup->corner || !soup->plane || !soup->sphere) {
        return murk_no_memory(err, "geometry", "for %zu triangles",
                              g->triangles);
    }
    /* One pass for each kind of face. */
    for (int face = 0; face < MURK_FACES; ++face) {
        soup->first_triangle[face] = soup->triangles;
        for (size_t i = 0; i < g->triangles; ++i) {
            const murk_placed_triangle *t = &g->triangle[i];
            if (t->face == face) {
                const size_t k = soup->triangles++;
                memcpy(soup->corner + 3 * k, t->corner, sizeof t->corner);
                soup->plane[k] = plane_of(soup, t);
            }
        }
        soup->first_sphere[face] = soup->spheres;
        for (size_t i = 0; i < g->spheres; ++i) {
            if (g->sphere[i].face == (murk_face)face) {
                soup->sphere[soup->spheres++] = g->sphere[i];
            }
        }
    }
    soup->first_triangle[MURK_FACES] = soup->triangles;
    soup->first_sphere[MURK_FACES] = soup->spheres;
    return MURK_OK;
}

static void measure(murk_soup *soup)
{
    soup->box = murk_box_empty();
    for (size_t i = 0; i < 3 * soup->triangles; ++i) {
        soup->box = murk_box_with(soup->box,
                                  murk_vertex(soup->vertex, soup->corner[i]));
    }
    soup->box = box_with_spheres(soup->box, soup->sphere, soup->spheres);
    soup->extent = soup->triangles + soup->spheres == 0
                       ? 0
                       : murk_box_largest_coordinate(&soup->box);
}

murk_status murk_soup_build(murk_soup *soup, const murk_surface_desc *surfaces,
                            size_t n_surfaces, const murk_material *materials,
                            size_t n_materials, murk_error *err)
{
    *soup = (murk_soup){0};
    murk_placed_shapes g;
    murk_status status = murk_placed_shapes_build(&g, surfaces, n_surfaces,
                                                  materials, n_materials, err);
    if (!status) {
        status = store_vertices(soup, &g, err);
    }
    if (!status) {
        drop_degenerate(soup, &g);
        status = classify(soup, &g, surfaces, materials, n_materials, err);
    }
    if (!status) {
        status = store_faces(soup, &g, err);
    }
    if (!status) {
        measure(soup);
    }
    murk_placed_shapes_release(&g);
    return status;
}

void murk_soup_release(murk_soup *soup)
{
    free(soup->vertex);
    free(soup->corner);
    free(soup->plane);
    free(soup->sphere);
    *soup = (murk_soup){0};
}

size_t murk_soup_bytes(const murk_soup *soup)
{
    return 3 * (soup->vertices + 1) * sizeof *soup->vertex +
           soup->triangles * (3 * sizeof *soup->corner + sizeof *soup->plane) +
           soup->spheres * sizeof *soup->sphere;
}
