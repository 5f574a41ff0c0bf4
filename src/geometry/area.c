/* Uniform sampling of surfaces by area.
 *
 * A table holds the running sum of the areas of all triangles and then of
 * all spheres. A binary search in the table selects the primitive (inverse
 * of the cumulative distribution), and two more numbers select the point on
 * it: on a triangle by folding a parallelogram, on a sphere by Archimedes'
 * theorem that zones of equal height have equal area. */
#include "geometry/area.h"

#include "geometry/ray_scene.h"
#include "geometry/triangle.h"

#include <stdlib.h>

struct murk_area {
    const murk_surfaces *surfaces;
    size_t n;         /* triangles, then spheres */
    double *up_to_m2; /* [n]: running sum of the areas, inclusive */
};

static double area_of(const murk_soup *soup, size_t i)
{
    if (i < soup->triangles) {
        const murk_triangle t = murk_soup_triangle(soup, i);
        return murk_triangle_area(&t);
    }
    const double radius = soup->sphere[i - soup->triangles].radius;
    return 4 * MURK_PI * radius * radius;
}

murk_status murk_area_create(murk_area **out, const murk_surfaces *surfaces,
                             const bool *wanted, const char *where,
                             murk_error *err)
{
    const murk_soup *soup = &surfaces->soup;
    murk_area *area = calloc(1, sizeof *area);
    double *up_to =
        malloc((soup->triangles + soup->spheres + 1) * sizeof *up_to);
    murk_status status = MURK_OK;
    if (!area || !up_to) {
        status = murk_no_memory(err, where, "for the area of %zu triangles",
                                soup->triangles);
        goto done;
    }
    area->surfaces = surfaces;
    area->n = soup->triangles + soup->spheres;
    area->up_to_m2 = up_to;
    up_to = NULL;
    /* Sum the areas; a primitive of another material adds 0, so the search
     * never selects it. */
    double sum = 0;
    for (size_t i = 0; i < area->n; ++i) {
        sum += !wanted || wanted[murk_soup_material(soup, i)] ? area_of(soup, i)
                                                              : 0;
        area->up_to_m2[i] = sum;
    }
    /* No selected material has any area: sampling would be undefined. */
    if (!(sum > 0)) {
        status = murk_fail(err, MURK_BAD_VALUE, where,
                           "no surface is of such a material");
        goto done;
    }
    *out = area;
    area = NULL;
done:
    free(up_to);
    murk_area_destroy(area);
    return status;
}

void murk_area_destroy(murk_area *area)
{
    if (area) {
        free(area->up_to_m2);
        free(area);
    }
}

double murk_area_m2(const murk_area *area)
{
    return area->up_to_m2[area->n - 1];
}

/* Index of the first primitive whose running sum exceeds x. A primitive of
 * area 0 is never selected. */
static size_t find(const murk_area *area, double x)
{
    size_t low = 0, high = area->n - 1;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (area->up_to_m2[middle] > x) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

/* The point a + u (b - a) + v (c - a). A triangle is half of a
 * parallelogram: a point in the other half is rotated by 180 degrees about
 * the middle. */
static murk_area_point on_triangle(const murk_triangle *t, double u, double v)
{
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    const murk_vec3 place = murk_along(
        murk_along(t->a, u, murk_sub(t->b, t->a)), v, murk_sub(t->c, t->a));
    return (murk_area_point){.place = place,
                             .normal = murk_unit(murk_triangle_normal(t))};
}

/* By Archimedes' theorem the height 2u - 1 of a uniform point is uniform. */
static murk_area_point on_sphere(const murk_stored_sphere *sphere, double u,
                                 double v)
{
    const murk_vec3 out =
        murk_about(murk_vec(0, 0, 1), 2 * u - 1, 2 * MURK_PI * v);
    return (murk_area_point){
        .place = murk_along(sphere->center, sphere->radius, out),
        .normal = out};
}

murk_area_point murk_area_at(const murk_area *area, const double u[3])
{
    const murk_soup *soup = &area->surfaces->soup;
    const size_t i = find(area, u[0] * murk_area_m2(area));
    murk_area_point point;
    if (i < soup->triangles) {
        const murk_triangle t = murk_soup_triangle(soup, i);
        point = on_triangle(&t, u[1], u[2]);
    } else {
        point = on_sphere(&soup->sphere[i - soup->triangles], u[1], u[2]);
    }
    point.place = murk_add(point.place, soup->anchor);
    point.material = murk_soup_material(soup, i);
    return point;
}
