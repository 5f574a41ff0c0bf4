/* Creates, describes and releases murk_surfaces. The functions that rays use
 * are in hit.c, occlusion.c and point_queries.c. */
#include "geometry/surfaces.h"

#include "geometry/placed_shapes.h"
#include "geometry/ray_scene.h"
#include "geometry/triangle.h"

#include <assert.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>

/* Areas, the lengths that rounding makes necessary, and the box that rays
 * are clipped to; these lengths and the box as if something reached up to the
 * box `within`, unless that is NULL or there are no surfaces. */
static void measure(murk_surfaces *s, const murk_box *within)
{
    murk_soup *soup = &s->soup;
    murk_box box = soup->box;
    if (within && soup->triangles + soup->spheres > 0) {
        box = murk_box_with(murk_box_with(box, within->min), within->max);
        soup->extent = murk_box_largest_coordinate(&box);
    }
    for (size_t i = 0; i < soup->triangles; ++i) {
        const murk_triangle t = murk_soup_triangle(soup, i);
        s->material_area_m2[murk_soup_material(soup, i)] +=
            murk_triangle_area(&t);
    }
    for (size_t i = 0; i < soup->spheres; ++i) {
        const murk_stored_sphere *b = &soup->sphere[i];
        s->material_area_m2[b->material] += 4 * MURK_PI * b->radius * b->radius;
    }
    for (size_t i = 0; i < s->n_materials; ++i) {
        s->area_m2 += s->material_area_m2[i];
    }
    s->unit_m = soup->extent * (double)FLT_EPSILON;
    s->leave_m = MURK_LEAVE_UNITS * s->unit_m;
    s->sheet_planes = murk_sheet_planes_of(soup, s->unit_m);
    const murk_vec3 margin = murk_vec(s->leave_m, s->leave_m, s->leave_m);
    s->reach = (murk_box){murk_sub(box.min, margin), murk_add(box.max, margin)};
    /* Half of the limit, so that differences of points are below it, too. */
    s->is_reach_sound =
        murk_box_largest_coordinate(&s->reach) < MURK_RAY_MAX_M / 2;
}

static murk_status prepare(murk_surfaces *s, const murk_surface_desc *surfaces,
                           size_t n_surfaces, const murk_material *materials,
                           const murk_box *within, murk_error *err)
{
    const size_t n = s->n_materials;
    s->material = malloc(n * sizeof *s->material);
    s->material_area_m2 = calloc(n, sizeof *s->material_area_m2);
    if (!s->material || !s->material_area_m2) {
        return murk_no_memory(err, "materials", "for %zu materials", n);
    }
    memcpy(s->material, materials, n * sizeof *s->material);
    const murk_status status =
        murk_soup_build(&s->soup, surfaces, n_surfaces, materials, n, err);
    if (status) {
        return status;
    }
    measure(s, within);
    return s->soup.triangles + s->soup.spheres > 0
               ? murk_ray_scene_commit(s, err)
               : MURK_OK;
}

murk_status murk_surfaces_create(murk_surfaces **out,
                                 const murk_surface_desc *surfaces,
                                 size_t n_surfaces,
                                 const murk_material *materials,
                                 size_t n_materials, murk_error *err)
{
    return murk_surfaces_create_within(out, surfaces, n_surfaces, materials,
                                       n_materials, NULL, err);
}

murk_status murk_surfaces_create_within(murk_surfaces **out,
                                        const murk_surface_desc *surfaces,
                                        size_t n_surfaces,
                                        const murk_material *materials,
                                        size_t n_materials,
                                        const murk_box *within, murk_error *err)
{
    assert(out && materials && n_materials >= 1);
    /* Material numbers have 8 bits. */
    if (n_materials > MURK_MATERIALS_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, "materials",
                         "%zu materials, must be at most %d", n_materials,
                         MURK_MATERIALS_MAX);
    }
    murk_surfaces *s = calloc(1, sizeof *s);
    if (!s) {
        return murk_no_memory(err, "geometry", "for surfaces");
    }
    /* Copy the materials, store the shapes and build the ray scene. */
    s->n_materials = n_materials;
    const murk_status status =
        prepare(s, surfaces, n_surfaces, materials, within, err);
    if (status) {
        murk_surfaces_destroy(s);
        return status;
    }
    *out = s;
    return MURK_OK;
}

void murk_surfaces_destroy(murk_surfaces *s)
{
    if (!s) {
        return;
    }
    murk_ray_scene_release(s);
    murk_soup_release(&s->soup);
    free(s->material_area_m2);
    free(s->material);
    free(s);
}

const murk_material *murk_surfaces_material(const murk_surfaces *s,
                                            size_t material)
{
    assert(material < s->n_materials);
    return &s->material[material];
}

size_t murk_surfaces_materials(const murk_surfaces *s)
{
    return s->n_materials;
}

murk_surfaces_facts murk_surfaces_describe(const murk_surfaces *s)
{
    const murk_soup *soup = &s->soup;
    const bool is_empty = soup->triangles + soup->spheres == 0;
    murk_surfaces_facts facts = {
        .triangles = soup->triangles,
        .spheres = soup->spheres,
        .degenerate = soup->degenerate,
        .solids = soup->solids,
        .sheets = soup->first_triangle[MURK_FACES] -
                  soup->first_triangle[MURK_FACE_SHEET] +
                  soup->first_sphere[MURK_FACES] -
                  soup->first_sphere[MURK_FACE_SHEET],
        .area_m2 = s->area_m2,
        .bounds_m = murk_box_empty(),
        .memory_bytes = sizeof *s + s->n_materials * sizeof *s->material +
                        murk_soup_bytes(soup) + s->embree_bytes};
    if (!is_empty) {
        facts.bounds_m = (murk_box){murk_add(soup->box.min, soup->anchor),
                                    murk_add(soup->box.max, soup->anchor)};
    }
    return facts;
}

void murk_surfaces_triangle(const murk_surfaces *s, size_t i,
                            murk_vec3 corner[3])
{
    assert(i < s->soup.triangles);
    const murk_triangle t = murk_soup_placed_triangle(&s->soup, i);
    corner[0] = t.a;
    corner[1] = t.b;
    corner[2] = t.c;
}

void murk_surfaces_sphere(const murk_surfaces *s, size_t i, murk_vec3 *center,
                          double *radius_m)
{
    assert(i < s->soup.spheres);
    *center = murk_add(s->soup.sphere[i].center, s->soup.anchor);
    *radius_m = s->soup.sphere[i].radius;
}

uint8_t murk_surfaces_material_of(const murk_surfaces *s, size_t i)
{
    assert(i < s->soup.triangles + s->soup.spheres);
    return murk_soup_material(&s->soup, i);
}

size_t murk_surfaces_material_named(const murk_surfaces *s, const char *name,
                                    bool *is_named)
{
    return murk_material_named(name, s->material, s->n_materials, is_named);
}

double murk_surfaces_material_area(const murk_surfaces *s, size_t material)
{
    assert(material < s->n_materials);
    return s->material_area_m2[material];
}
