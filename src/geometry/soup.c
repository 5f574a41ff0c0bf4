/* The anchor is chosen, the vertices are rounded to float once, and from then
 * on the floats are the truth. */
#include "geometry/soup.h"

#include "base/log.h"
#include "geometry/closed.h"
#include "geometry/gather.h"

#include <stdlib.h>
#include <string.h>

/* A scene whose middle is further than this many times its half size from the
 * origin is stored about its own middle. */
#define FAR_AWAY 4.0

static murk_box bounds(const murk_gathering *g)
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

static murk_status store_vertices(murk_soup *soup, const murk_gathering *g,
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
static void drop_degenerate(murk_soup *soup, murk_gathering *g)
{
    size_t kept = 0;
    soup->degenerate = g->degenerate;
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
static murk_status find_solid(murk_soup *soup, murk_gathering *g, size_t first,
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
        status = murk_fail(err, MURK_NO_MEMORY, murk_place_of(d),
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
        status = number_solid(soup, murk_place_of(d), err);
    }
    for (size_t i = 0; i < n; ++i) {
        if (is_closed[i]) {
            g->solid[index[i]] = (uint16_t)soup->solids;
            g->face[index[i]] = MURK_FACE_SOLID;
        }
    }
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

static murk_status classify(murk_soup *soup, murk_gathering *g,
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
static murk_status store_faces(murk_soup *soup, const murk_gathering *g,
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
    murk_gathering g;
    murk_status status = murk_gather_triangles(&g, surfaces, n_surfaces,
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
    murk_gathering_release(&g);
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
