/* Placed shapes are gathered in double, the anchor is chosen, the vertices are
 * rounded to float once, and from then on the floats are the truth. */
#include "geometry/soup.h"

#include "base/log.h"
#include "geometry/closed.h"
#include "geometry/triangle.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Embree's own limit is 1.8e18; float resolves 60 m there already. */
#define COORDINATE_MAX_M 1e9

/* A scene whose middle is further than this many times its half size from the
 * origin is stored about its own middle. */
#define FAR_AWAY 4.0

/* Relative departure from rotation times scale that a sphere may have. */
#define SIMILAR 1e-9

/* Shapes in the order of the descriptions, before sorting by face. */
typedef struct gathering {
    murk_vec3 *vertex;
    uint32_t *corner, *item; /* item: index of the description */
    uint8_t *material;
    uint16_t *solid;
    uint8_t *face;
    size_t vertices, triangles, balls;
    murk_ball *ball;
} gathering;

static const uint32_t BOX_CORNER[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6,
                                        0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3,
                                        0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
static const uint32_t RECT_CORNER[6] = {0, 1, 2, 0, 2, 3};

static const char *place_of(const murk_surface_desc *d)
{
    return d->where ? d->where : "geometry";
}

static murk_status check_shape(const murk_surface_desc *d, murk_error *err)
{
    const char *where = place_of(d);
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

/* The factor by which a similarity lengthens; NaN when it is none. */
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

static void count_shape(const murk_surface_desc *d, gathering *g)
{
    switch (d->shape) {
    case MURK_SHAPE_MESH:
        g->vertices += d->mesh->vertices;
        g->triangles += d->mesh->triangles;
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
        g->balls += 1;
        break;
    }
}

static murk_status allocate(gathering *g, murk_error *err)
{
    g->vertex = malloc((g->vertices + 1) * sizeof *g->vertex);
    g->corner = malloc((3 * g->triangles + 1) * sizeof *g->corner);
    g->item = malloc((g->triangles + 1) * sizeof *g->item);
    g->material = malloc(g->triangles + 1);
    g->solid = calloc(g->triangles + 1, sizeof *g->solid);
    g->face = calloc(g->triangles + 1, 1);
    g->ball = malloc((g->balls + 1) * sizeof *g->ball);
    if (!g->vertex || !g->corner || !g->item || !g->material || !g->solid ||
        !g->face || !g->ball) {
        return murk_fail(err, MURK_NO_MEMORY, "geometry",
                         "no memory for %zu triangles", g->triangles);
    }
    g->vertices = g->triangles = g->balls = 0;
    return MURK_OK;
}

static void release(gathering *g)
{
    free(g->vertex);
    free(g->corner);
    free(g->item);
    free(g->material);
    free(g->solid);
    free(g->face);
    free(g->ball);
}

/* The scene's material of that name: exactly, else whatever the case of its
 * letters, else `default`. */
static uint8_t material_named(const char *name, const murk_material *materials,
                              size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        if (strcmp(materials[i].name, name) == 0) {
            return (uint8_t)i;
        }
    }
    for (size_t i = 0; i < n; ++i) {
        if (strcasecmp(materials[i].name, name) == 0) {
            return (uint8_t)i;
        }
    }
    return 0;
}

static murk_status add_mesh(gathering *g, const murk_surface_desc *d,
                            uint32_t item, const murk_material *materials,
                            size_t n_materials, murk_error *err)
{
    const murk_mesh *m = d->mesh;
    uint8_t *own = malloc(m->materials + 1);
    if (!own) {
        return murk_fail(err, MURK_NO_MEMORY, place_of(d),
                         "no memory for %zu materials", m->materials);
    }
    for (size_t i = 0; i < m->materials; ++i) {
        own[i] = d->material >= 0 ? (uint8_t)d->material
                                  : material_named(m->material_name[i],
                                                   materials, n_materials);
    }
    const uint32_t base = (uint32_t)g->vertices;
    for (size_t i = 0; i < m->vertices; ++i) {
        const murk_vec3 p = murk_vertex(m->vertex_m, (uint32_t)i);
        g->vertex[g->vertices++] = murk_affine_point(&d->to_world, p);
    }
    for (size_t i = 0; i < m->triangles; ++i) {
        const size_t k = g->triangles++;
        for (size_t j = 0; j < 3; ++j) {
            assert(m->corner[3 * i + j] < m->vertices);
            g->corner[3 * k + j] = base + m->corner[3 * i + j];
        }
        g->item[k] = item;
        assert(m->material[i] < m->materials);
        g->material[k] = own[m->material[i]];
    }
    free(own);
    return MURK_OK;
}

static void add_flat(gathering *g, const murk_surface_desc *d, uint32_t item,
                     const murk_vec3 *point, size_t points,
                     const uint32_t *corner, size_t triangles)
{
    const uint32_t base = (uint32_t)g->vertices;
    for (size_t i = 0; i < points; ++i) {
        g->vertex[g->vertices++] = murk_affine_point(&d->to_world, point[i]);
    }
    for (size_t i = 0; i < triangles; ++i) {
        const size_t k = g->triangles++;
        for (size_t j = 0; j < 3; ++j) {
            g->corner[3 * k + j] = base + corner[3 * i + j];
        }
        g->item[k] = item;
        g->material[k] = (uint8_t)(d->material > 0 ? d->material : 0);
    }
}

static void add_box(gathering *g, const murk_surface_desc *d, uint32_t item)
{
    murk_vec3 point[8];
    for (int i = 0; i < 8; ++i) {
        point[i] = murk_vec(i & 1 ? d->box.max.x : d->box.min.x,
                            i & 2 ? d->box.max.y : d->box.min.y,
                            i & 4 ? d->box.max.z : d->box.min.z);
    }
    add_flat(g, d, item, point, 8, BOX_CORNER, 12);
}

static void add_rect(gathering *g, const murk_surface_desc *d, uint32_t item)
{
    const murk_vec3 along = murk_add(d->corner, d->edge1);
    const murk_vec3 point[4] = {d->corner, along, murk_add(along, d->edge2),
                                murk_add(d->corner, d->edge2)};
    add_flat(g, d, item, point, 4, RECT_CORNER, 2);
}

static murk_status add_sphere(gathering *g, const murk_surface_desc *d,
                              murk_error *err)
{
    const double scale = similarity_scale(&d->to_world);
    if (!(scale > 0)) {
        return murk_fail(err, MURK_BAD_VALUE, place_of(d),
                         "a sphere can be rotated, scaled alike in x, y, z, "
                         "and moved, nothing else");
    }
    g->ball[g->balls++] =
        (murk_ball){.center = murk_affine_point(&d->to_world, d->center),
                    .radius = scale * d->radius_m,
                    .material = (uint8_t)(d->material > 0 ? d->material : 0)};
    return MURK_OK;
}

static murk_status check_coordinates(const gathering *g, size_t first_vertex,
                                     size_t first_ball, const char *where,
                                     murk_error *err)
{
    const murk_vec3 limit =
        murk_vec(COORDINATE_MAX_M, COORDINATE_MAX_M, COORDINATE_MAX_M);
    const murk_box world = {murk_scale(-1, limit), limit};
    const murk_vec3 *bad = NULL;
    for (size_t i = first_vertex; i < g->vertices && !bad; ++i) {
        bad = murk_box_contains(&world, g->vertex[i]) ? NULL : &g->vertex[i];
    }
    for (size_t i = first_ball; i < g->balls && !bad; ++i) {
        const bool fits = murk_box_contains(&world, g->ball[i].center) &&
                          g->ball[i].radius <= COORDINATE_MAX_M;
        bad = fits ? NULL : &g->ball[i].center;
    }
    if (bad) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "a point is at (%g, %g, %g) m, coordinates must be "
                         "within %g m of the origin",
                         bad->x, bad->y, bad->z, COORDINATE_MAX_M);
    }
    return MURK_OK;
}

static murk_status gather(gathering *g, const murk_surface_desc *surfaces,
                          size_t n, const murk_material *materials,
                          size_t n_materials, murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < n && !status; ++i) {
        const murk_surface_desc *d = &surfaces[i];
        const size_t first_vertex = g->vertices, first_ball = g->balls;
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
            status = check_coordinates(g, first_vertex, first_ball, place_of(d),
                                       err);
        }
    }
    return status;
}

static murk_box bounds(const gathering *g)
{
    murk_box box = murk_box_empty();
    for (size_t i = 0; i < g->vertices; ++i) {
        box = murk_box_with(box, g->vertex[i]);
    }
    for (size_t i = 0; i < g->balls; ++i) {
        const murk_ball *b = &g->ball[i];
        const murk_vec3 r = murk_vec(b->radius, b->radius, b->radius);
        box = murk_box_with(murk_box_with(box, murk_add(b->center, r)),
                            murk_sub(b->center, r));
    }
    return box;
}

static double largest(murk_vec3 v)
{
    return fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
}

/* 0 unless the scene is far from the origin; then its middle, on a grid as
 * coarse as the scene, so that subtracting it loses nothing in double. */
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

static murk_status store_vertices(murk_soup *soup, const gathering *g,
                                  murk_error *err)
{
    const murk_box box = bounds(g);
    soup->anchor = choose_anchor(&box);
    soup->vertices = g->vertices;
    soup->vertex = malloc(3 * (g->vertices + 1) * sizeof *soup->vertex);
    if (!soup->vertex) {
        return murk_fail(err, MURK_NO_MEMORY, "geometry",
                         "no memory for %zu vertices", g->vertices);
    }
    for (size_t i = 0; i < g->vertices; ++i) {
        const murk_vec3 p = murk_sub(g->vertex[i], soup->anchor);
        soup->vertex[3 * i] = (float)p.x;
        soup->vertex[3 * i + 1] = (float)p.y;
        soup->vertex[3 * i + 2] = (float)p.z;
    }
    memset(soup->vertex + 3 * g->vertices, 0, 3 * sizeof *soup->vertex);
    for (size_t i = 0; i < g->balls; ++i) {
        g->ball[i].center = murk_sub(g->ball[i].center, soup->anchor);
    }
    return MURK_OK;
}

/* After rounding some triangles may have no area left. */
static void drop_degenerate(murk_soup *soup, gathering *g)
{
    size_t kept = 0;
    for (size_t i = 0; i < g->triangles; ++i) {
        const murk_triangle t =
            murk_triangle_at(soup->vertex, g->corner + 3 * i);
        if (murk_triangle_is_degenerate(&t)) {
            ++soup->degenerate;
            continue;
        }
        memmove(g->corner + 3 * kept, g->corner + 3 * i, 3 * sizeof *g->corner);
        g->item[kept] = g->item[i];
        g->material[kept] = g->material[i];
        ++kept;
    }
    g->triangles = kept;
}

static bool transmits(const murk_material *material)
{
    for (int i = 0; i < MURK_BANDS_MAX; ++i) {
        if (material->transmit.band[i] > 0) {
            return true;
        }
    }
    return false;
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

/* The triangles of one description and one material: its closed parts together
 * are one solid, so that a hollow shape (two shells) is one thing. */
static murk_status find_solid(murk_soup *soup, gathering *g, size_t first,
                              size_t last, uint8_t material,
                              const murk_surface_desc *d,
                              const char *material_name, murk_error *err)
{
    murk_status status = MURK_OK;
    size_t n = 0, n_closed = 0;
    uint32_t *index = malloc((last - first) * sizeof *index);
    uint32_t *corner = malloc(3 * (last - first) * sizeof *corner);
    bool *is_closed = malloc((last - first) * sizeof *is_closed);
    if (!index || !corner || !is_closed) {
        status = murk_fail(err, MURK_NO_MEMORY, place_of(d),
                           "no memory to look for closed parts");
        goto done;
    }
    uint32_t low = UINT32_MAX, high = 0;
    for (size_t i = first; i < last; ++i) {
        if (g->material[i] == material) {
            memcpy(corner + 3 * n, g->corner + 3 * i, 3 * sizeof *corner);
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
    for (size_t i = 0; i < n; ++i) {
        n_closed += is_closed[i];
    }
    if (n_closed > 0) {
        status = number_solid(soup, place_of(d), err);
    }
    for (size_t i = 0; i < n; ++i) {
        if (is_closed[i]) {
            g->solid[index[i]] = (uint16_t)soup->solids;
            g->face[index[i]] = MURK_FACE_SOLID;
        }
    }
    if (n_closed < n) {
        murk_warn(place_of(d),
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

static murk_status classify(murk_soup *soup, gathering *g,
                            const murk_surface_desc *surfaces,
                            const murk_material *materials, size_t n_materials,
                            murk_error *err)
{
    for (size_t i = 0; i < g->triangles; ++i) {
        g->face[i] = transmits(&materials[g->material[i]]) ? MURK_FACE_SHEET
                                                           : MURK_FACE_OPAQUE;
    }
    for (size_t first = 0, last; first < g->triangles; first = last) {
        bool has[MURK_MATERIALS_MAX] = {false};
        for (last = first;
             last < g->triangles && g->item[last] == g->item[first]; ++last) {
            has[g->material[last]] = true;
        }
        for (size_t m = 0; m < n_materials; ++m) {
            if (has[m] && materials[m].ior > 0) {
                const murk_status status = find_solid(
                    soup, g, first, last, (uint8_t)m, &surfaces[g->item[first]],
                    materials[m].name, err);
                if (status) {
                    return status;
                }
            }
        }
    }
    for (size_t i = 0; i < g->balls; ++i) {
        murk_ball *b = &g->ball[i];
        const murk_material *m = &materials[b->material];
        b->face = transmits(m) ? MURK_FACE_SHEET : MURK_FACE_OPAQUE;
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

/* A stable sort into the three faces. */
static murk_status store_faces(murk_soup *soup, const gathering *g,
                               murk_error *err)
{
    soup->corner = malloc((3 * g->triangles + 1) * sizeof *soup->corner);
    soup->material = malloc(g->triangles + 1);
    soup->solid = malloc((g->triangles + 1) * sizeof *soup->solid);
    soup->ball = malloc((g->balls + 1) * sizeof *soup->ball);
    if (!soup->corner || !soup->material || !soup->solid || !soup->ball) {
        return murk_fail(err, MURK_NO_MEMORY, "geometry",
                         "no memory for %zu triangles", g->triangles);
    }
    for (int face = 0; face < MURK_FACES; ++face) {
        soup->first_triangle[face] = soup->triangles;
        for (size_t i = 0; i < g->triangles; ++i) {
            if (g->face[i] == face) {
                const size_t k = soup->triangles++;
                memcpy(soup->corner + 3 * k, g->corner + 3 * i,
                       3 * sizeof *soup->corner);
                soup->material[k] = g->material[i];
                soup->solid[k] = g->solid[i];
            }
        }
        soup->first_ball[face] = soup->balls;
        for (size_t i = 0; i < g->balls; ++i) {
            if ((int)g->ball[i].face == face) {
                soup->ball[soup->balls++] = g->ball[i];
            }
        }
    }
    soup->first_triangle[MURK_FACES] = soup->triangles;
    soup->first_ball[MURK_FACES] = soup->balls;
    return MURK_OK;
}

static void measure(murk_soup *soup)
{
    soup->box = murk_box_empty();
    for (size_t i = 0; i < 3 * soup->triangles; ++i) {
        soup->box = murk_box_with(soup->box,
                                  murk_vertex(soup->vertex, soup->corner[i]));
    }
    for (size_t i = 0; i < soup->balls; ++i) {
        const murk_ball *b = &soup->ball[i];
        const murk_vec3 r = murk_vec(b->radius, b->radius, b->radius);
        soup->box = murk_box_with(soup->box, murk_add(b->center, r));
        soup->box = murk_box_with(soup->box, murk_sub(b->center, r));
    }
    soup->extent = soup->triangles + soup->balls == 0
                       ? 0
                       : fmax(largest(soup->box.min), largest(soup->box.max));
}

murk_status murk_soup_build(murk_soup *soup, const murk_surface_desc *surfaces,
                            size_t n_surfaces, const murk_material *materials,
                            size_t n_materials, murk_error *err)
{
    *soup = (murk_soup){0};
    gathering g = {0};
    murk_status status = MURK_OK;
    for (size_t i = 0; i < n_surfaces; ++i) {
        assert(surfaces[i].material >= -1 &&
               surfaces[i].material < (int)n_materials);
        status = check_shape(&surfaces[i], err);
        if (status) {
            return status;
        }
        count_shape(&surfaces[i], &g);
        soup->degenerate += surfaces[i].shape == MURK_SHAPE_MESH
                                ? surfaces[i].mesh->degenerate
                                : 0;
    }
    if (g.vertices >= UINT32_MAX || g.triangles + g.balls >= UINT32_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, "geometry",
                         "%zu triangles with %zu vertices, must be fewer than "
                         "%u",
                         g.triangles, g.vertices, UINT32_MAX);
    }
    status = allocate(&g, err);
    if (!status) {
        status = gather(&g, surfaces, n_surfaces, materials, n_materials, err);
    }
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
    release(&g);
    return status;
}

void murk_soup_release(murk_soup *soup)
{
    free(soup->vertex);
    free(soup->corner);
    free(soup->material);
    free(soup->solid);
    free(soup->ball);
    *soup = (murk_soup){0};
}

size_t murk_soup_bytes(const murk_soup *soup)
{
    return 3 * (soup->vertices + 1) * sizeof *soup->vertex +
           soup->triangles * (3 * sizeof *soup->corner +
                              sizeof *soup->material + sizeof *soup->solid) +
           soup->balls * sizeof *soup->ball;
}
