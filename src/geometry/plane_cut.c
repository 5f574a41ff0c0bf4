/* Cuts surfaces with a plane. The heights of the three corners above the plane
 * decide whether a triangle is cut, and divide the two cut edges. */
#include "geometry/plane_cut.h"

#include <stdlib.h>

static double height_of(const murk_cut_plane *plane, murk_vec3 p)
{
    return murk_dot(murk_sub(p, plane->point), plane->normal);
}

/* The point of the plane on an edge. The edge is always divided from the lower
 * end, so that both triangles at the edge get the same point. */
static murk_vec3 divide(murk_vec3 low, double low_m, murk_vec3 high,
                        double high_m)
{
    const double share = low_m / (low_m - high_m);
    return high_m > 0 ? murk_along(low, share, murk_sub(high, low)) : high;
}

bool murk_plane_cut_triangle(const murk_cut_plane *plane,
                             const murk_vec3 corner[3], murk_vec3 end[2])
{
    double height_m[3];
    int below = 0;
    for (int k = 0; k < 3; ++k) {
        height_m[k] = height_of(plane, corner[k]);
        below += height_m[k] < 0;
    }
    if (below == 0 || below == 3) {
        return false;
    }
    /* One corner is alone on one side; the edges to the other two are cut. */
    int alone = 0;
    while ((height_m[alone] < 0) != (below == 1)) {
        ++alone;
    }
    for (int k = 0; k < 2; ++k) {
        const int other = (alone + 1 + k) % 3;
        const int low = below == 1 ? alone : other;
        const int high = below == 1 ? other : alone;
        end[k] =
            divide(corner[low], height_m[low], corner[high], height_m[high]);
    }
    return murk_length(murk_sub(end[1], end[0])) > 0;
}

static bool cut_sphere(const murk_cut_plane *plane, murk_vec3 center,
                       double radius_m, murk_cut_circle *out)
{
    const double height_m = height_of(plane, center);
    if (!(fabs(height_m) < radius_m)) {
        return false;
    }
    out->center = murk_along(center, -height_m, plane->normal);
    out->radius_m = sqrt((radius_m - height_m) * (radius_m + height_m));
    return true;
}

/* Fills the arrays of *out, or only counts if the arrays are NULL. */
static void cut_all(murk_plane_cut *out, const murk_surfaces *surfaces,
                    const murk_surfaces_facts *facts,
                    const murk_cut_plane *plane)
{
    out->segments = 0;
    out->circles = 0;
    /* Triangles, then spheres. */
    for (size_t i = 0; i < facts->triangles; ++i) {
        murk_cut_segment s = {.triangle = (uint32_t)i};
        murk_vec3 corner[3], end[2];
        murk_surfaces_triangle(surfaces, i, corner);
        if (murk_plane_cut_triangle(plane, corner, end)) {
            s.from = end[0];
            s.to = end[1];
            if (out->segment) {
                out->segment[out->segments] = s;
            }
            ++out->segments;
        }
    }
    for (size_t i = 0; i < facts->spheres; ++i) {
        murk_cut_circle c = {.sphere = (uint32_t)(facts->triangles + i)};
        murk_vec3 center;
        double radius_m;
        murk_surfaces_sphere(surfaces, i, &center, &radius_m);
        if (cut_sphere(plane, center, radius_m, &c)) {
            if (out->circle) {
                out->circle[out->circles] = c;
            }
            ++out->circles;
        }
    }
}

murk_status murk_plane_cut_surfaces(murk_plane_cut *out,
                                    const murk_surfaces *surfaces,
                                    const murk_cut_plane *plane,
                                    murk_error *err)
{
    const murk_surfaces_facts facts = murk_surfaces_describe(surfaces);
    *out = (murk_plane_cut){0};
    cut_all(out, surfaces, &facts, plane);
    murk_cut_segment *segment = malloc((out->segments + 1) * sizeof *segment);
    murk_cut_circle *circle = malloc((out->circles + 1) * sizeof *circle);
    if (!segment || !circle) {
        const size_t asked = out->segments + out->circles;
        free(segment);
        free(circle);
        *out = (murk_plane_cut){0};
        return murk_no_memory(err, "", "for a section of %zu lines", asked);
    }
    out->segment = segment;
    out->circle = circle;
    cut_all(out, surfaces, &facts, plane);
    return MURK_OK;
}

void murk_plane_cut_release(murk_plane_cut *cut)
{
    free(cut->segment);
    free(cut->circle);
    *cut = (murk_plane_cut){0};
}
