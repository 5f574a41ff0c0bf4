/* Area of the intersection of a plane and a box: a square in the plane that
 * contains the intersection is clipped by the six sides of the box. */
#include "world/plane_area.h"

#include "geometry/polygon.h"

double murk_plane_area(const murk_box *box, murk_vec3 point, murk_vec3 normal)
{
    /* Two unit vectors u, v span the plane. */
    const murk_vec3 n = murk_unit(normal);
    const murk_vec3 other =
        fabs(n.x) < .6 ? murk_vec(1, 0, 0) : murk_vec(0, 1, 0);
    const murk_vec3 u = murk_unit(murk_cross(n, other)), v = murk_cross(n, u);
    /* The middle of the square is the point. No point of the box is farther
     * from there than reach, half an edge of the square. */
    const murk_vec3 middle = murk_scale(.5, murk_add(box->min, box->max));
    const double reach = murk_length(murk_sub(box->max, box->min)) +
                         murk_length(murk_sub(point, middle));
    murk_polygon square = {.n = 4};
    for (int i = 0; i < 4; ++i) {
        const double s = i == 1 || i == 2 ? reach : -reach,
                     t = i >= 2 ? reach : -reach;
        square.corner[i] = murk_along(murk_along(point, s, u), t, v);
    }
    const murk_polygon part = murk_polygon_in_box(square, box);
    return murk_polygon_area_m2(&part);
}
