/* Feet on spheres. */
#include "geometry/laying.h"
#include "geometry/polygon.h"

static bool is_laid_over(const murk_laying *l, const murk_ball *b)
{
    return !l->lay->materials || l->lay->materials[b->material];
}

static void lay_poles(murk_laying *l, const murk_ball *b)
{
    const murk_vec3 center = murk_add(b->center, l->surfaces->soup.anchor);
    for (int i = 0; i < 6; ++i) {
        murk_vec3 pole = {0, 0, 0};
        murk_component_set(&pole, i / 2, i % 2 ? 1 : -1);
        murk_laying_offer(l, murk_along(center, b->radius, pole), pole);
    }
}

/* Distance from a point to a box. */
static double distance_to(const murk_box *box, murk_vec3 p)
{
    return murk_length(
        murk_vec(fmax(0, fmax(box->min.x - p.x, p.x - box->max.x)),
                 fmax(0, fmax(box->min.y - p.y, p.y - box->max.y)),
                 fmax(0, fmax(box->min.z - p.z, p.z - box->max.z))));
}

/* As fill_gaps() over the part of a sphere between three directions, at most
 * an octant; parts that the box does not reach are left out whole. */
static void fill_octant(murk_laying *l, murk_vec3 center, double radius,
                        murk_vec3 a, murk_vec3 b, murk_vec3 c)
{
    const double ab = murk_length(murk_sub(b, a)),
                 bc = murk_length(murk_sub(c, b)),
                 ca = murk_length(murk_sub(a, c));
    const murk_vec3 mid = murk_unit(murk_add(a, murk_add(b, c)));
    const murk_vec3 place = murk_along(center, radius, mid);
    const double far = fmax(
        murk_length(murk_sub(a, mid)),
        fmax(murk_length(murk_sub(b, mid)), murk_length(murk_sub(c, mid))));
    if (l->status ||
        distance_to(&l->lay->within, place) > radius * far + l->slack_m) {
        return;
    }
    if (!(radius * fmax(ab, fmax(bc, ca)) >
          MURK_LAY_PIECE * l->lay->spacing_m)) {
        murk_laying_offer(l, place, mid);
    } else if (ab >= bc && ab >= ca) {
        const murk_vec3 m = murk_unit(murk_middle(a, b));
        fill_octant(l, center, radius, a, m, c);
        fill_octant(l, center, radius, m, b, c);
    } else if (bc >= ca) {
        const murk_vec3 m = murk_unit(murk_middle(b, c));
        fill_octant(l, center, radius, b, m, a);
        fill_octant(l, center, radius, m, c, a);
    } else {
        const murk_vec3 m = murk_unit(murk_middle(c, a));
        fill_octant(l, center, radius, c, m, b);
        fill_octant(l, center, radius, m, a, b);
    }
}

static void fill_ball(murk_laying *l, const murk_ball *b)
{
    const murk_vec3 center = murk_add(b->center, l->surfaces->soup.anchor);
    for (int i = 0; i < 8; ++i) {
        fill_octant(l, center, b->radius, murk_vec(i & 1 ? 1 : -1, 0, 0),
                    murk_vec(0, i & 2 ? 1 : -1, 0),
                    murk_vec(0, 0, i & 4 ? 1 : -1));
    }
}

bool murk_laying_any_ball(const murk_laying *l)
{
    for (size_t i = 0; i < l->surfaces->soup.balls; ++i) {
        if (is_laid_over(l, &l->surfaces->soup.ball[i])) {
            return true;
        }
    }
    return false;
}

void murk_laying_poles(murk_laying *l)
{
    for (size_t i = 0; i < l->surfaces->soup.balls && !l->status; ++i) {
        if (is_laid_over(l, &l->surfaces->soup.ball[i])) {
            lay_poles(l, &l->surfaces->soup.ball[i]);
        }
    }
}

void murk_laying_balls(murk_laying *l)
{
    for (size_t i = 0; i < l->surfaces->soup.balls && !l->status; ++i) {
        if (is_laid_over(l, &l->surfaces->soup.ball[i])) {
            fill_ball(l, &l->surfaces->soup.ball[i]);
        }
    }
}
