/* The pattern: each face is looked at along the axis that its normal is
 * longest along, and meets the lines of a square lattice along that axis. That
 * depends on where the face is and not on how it is cut into triangles, and is
 * up to sqrt(3) too sparse where the face slants. The gaps are then filled from
 * the middles of pieces that all faces are halved into. */
#include "geometry/lay.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "geometry/laying.h"
#include "geometry/polygon.h"

#include <assert.h>
#include <stdlib.h>

#define MIN_LEAVES     8 /* spacing, in steps off a surface */
#define INTERRUPT_MASK 0xfff

/* Every place is within 3/4 + 1/3 of a spacing of a foot, so a foot stands for
 * up to 3.7 squares of the spacing, and twice that where folds turned by 60
 * degrees are one surface: more area cannot do with as few feet as allowed. */
#define SQUARES_A_FOOT 7.4

double murk_lay_min_m(const murk_surfaces *surfaces)
{
    return MIN_LEAVES * surfaces->leave_m;
}

/* One triangle that is laid over, in the world; false where it is not. */
static bool face_of(const murk_laying *l, size_t i, murk_triangle *t,
                    murk_vec3 *normal, murk_polygon *part)
{
    const murk_soup *soup = &l->surfaces->soup;
    if (l->lay->materials && !l->lay->materials[soup->material[i]]) {
        return false;
    }
    *t = murk_soup_triangle(soup, i);
    t->a = murk_add(t->a, soup->anchor);
    t->b = murk_add(t->b, soup->anchor);
    t->c = murk_add(t->c, soup->anchor);
    *normal = murk_unit(murk_triangle_normal(t));
    const double rise = fabs(normal->z);
    if (!(rise >= l->lay->min_rise && rise <= l->lay->max_rise)) {
        return false;
    }
    *part = murk_triangle_in_box(t, &l->lay->within);
    return part->n > 0;
}

static double area_of(const murk_polygon *p)
{
    murk_vec3 twice = {0, 0, 0};
    for (size_t i = 2; i < p->n; ++i) {
        twice =
            murk_add(twice, murk_cross(murk_sub(p->corner[i - 1], p->corner[0]),
                                       murk_sub(p->corner[i], p->corner[0])));
    }
    return 0.5 * murk_length(twice);
}

/* What a row of the pattern, at `row` along the axis `across`, meets of a
 * polygon along another axis; to[0] > to[1] where it meets nothing. */
static void meet_row(const murk_polygon *p, int along, int across, double row,
                     double slack, double to[2])
{
    to[0] = INFINITY;
    to[1] = -INFINITY;
    for (size_t i = 0; i < p->n; ++i) {
        const murk_vec3 a = p->corner[i], b = p->corner[(i + 1) % p->n];
        const double low = murk_component(a, across),
                     high = murk_component(b, across);
        if (row < fmin(low, high) - slack || row > fmax(low, high) + slack) {
            continue;
        }
        const double x[2] = {murk_component(a, along),
                             murk_component(b, along)};
        const bool is_level = !(fabs(high - low) > slack);
        const double share =
            is_level ? 0 : fmin(1, fmax(0, (row - low) / (high - low)));
        const double met = x[0] + share * (x[1] - x[0]);
        to[0] = fmin(to[0], is_level ? fmin(x[0], x[1]) : met);
        to[1] = fmax(to[1], is_level ? fmax(x[0], x[1]) : met);
    }
}

static void lay_pattern(murk_laying *l, const murk_triangle *t,
                        murk_vec3 normal, const murk_polygon *p)
{
    const double n[3] = {fabs(normal.x), fabs(normal.y), fabs(normal.z)};
    const int look = n[0] >= n[1] && n[0] >= n[2] ? 0 : n[1] >= n[2] ? 1 : 2;
    const int along = (look + 1) % 3, across = (look + 2) % 3;
    const double step = l->lay->spacing_m, slack = l->slack_m;
    double low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < p->n; ++i) {
        low = fmin(low, murk_component(p->corner[i], across));
        high = fmax(high, murk_component(p->corner[i], across));
    }
    const double end = floor((high + slack - l->first[across]) / step);
    for (double row = ceil((low - slack - l->first[across]) / step);
         row <= end && !l->status; ++row) {
        murk_vec3 place = {0, 0, 0};
        double met[2];
        murk_component_set(&place, across, l->first[across] + row * step);
        meet_row(p, along, across, murk_component(place, across), slack, met);
        const double stop = floor((met[1] + slack - l->first[along]) / step);
        for (double k = ceil((met[0] - slack - l->first[along]) / step);
             k <= stop && !l->status; ++k) {
            murk_component_set(&place, along, l->first[along] + k * step);
            murk_component_set(&place, look, murk_component(t->a, look));
            const double off = murk_dot(murk_sub(place, t->a), normal);
            murk_component_set(&place, look,
                               murk_component(t->a, look) -
                                   off / murk_component(normal, look));
            murk_laying_offer(l, place, normal);
        }
    }
}

/* Halves the longest side until all are short. */
static void fill_gaps(murk_laying *l, murk_vec3 a, murk_vec3 b, murk_vec3 c,
                      murk_vec3 normal)
{
    const double ab = murk_length(murk_sub(b, a)),
                 bc = murk_length(murk_sub(c, b)),
                 ca = murk_length(murk_sub(a, c));
    if (l->status) {
        return;
    }
    if (!(fmax(ab, fmax(bc, ca)) > MURK_LAY_PIECE * l->lay->spacing_m)) {
        const murk_vec3 sum = murk_add(a, murk_add(b, c));
        murk_laying_offer(l, murk_scale(1.0 / 3, sum), normal);
    } else if (ab >= bc && ab >= ca) {
        fill_gaps(l, a, murk_middle(a, b), c, normal);
        fill_gaps(l, murk_middle(a, b), b, c, normal);
    } else if (bc >= ca) {
        fill_gaps(l, b, murk_middle(b, c), a, normal);
        fill_gaps(l, murk_middle(b, c), c, a, normal);
    } else {
        fill_gaps(l, c, murk_middle(c, a), b, normal);
        fill_gaps(l, murk_middle(c, a), a, b, normal);
    }
}

/* A flat box leaves a segment or a point of some. */
static void fill_part(murk_laying *l, const murk_polygon *p, murk_vec3 normal)
{
    if (p->n < 3) {
        fill_gaps(l, p->corner[0], p->corner[0], p->corner[p->n - 1], normal);
    }
    for (size_t k = 2; k < p->n; ++k) {
        fill_gaps(l, p->corner[0], p->corner[k - 1], p->corner[k], normal);
    }
}

static bool goes_on(murk_laying *l, size_t i)
{
    murk_progress_add(1);
    if (!l->status && (i & INTERRUPT_MASK) == 0 && murk_interrupted()) {
        l->status = murk_fail(l->err, MURK_INTERRUPTED, "", "interrupted");
    }
    return !l->status;
}

/* Box and area of all that is laid over; false: nothing is. */
static bool measure(murk_laying *l)
{
    const murk_soup *soup = &l->surfaces->soup;
    const double square = l->lay->spacing_m * l->lay->spacing_m;
    murk_box box = murk_box_empty();
    for (size_t i = 0; i < soup->triangles && goes_on(l, i); ++i) {
        murk_triangle t;
        murk_vec3 normal;
        murk_polygon part;
        if (face_of(l, i, &t, &normal, &part)) {
            l->squares += area_of(&part) / square;
            for (size_t k = 0; k < part.n; ++k) {
                box = murk_box_with(box, part.corner[k]);
            }
        }
    }
    const double min[3] = {box.min.x, box.min.y, box.min.z};
    const double max[3] = {box.max.x, box.max.y, box.max.z};
    for (int axis = 0; axis < 3 && box.min.x <= box.max.x; ++axis) {
        /* no last line that rounding alone makes room for */
        const double steps =
            (max[axis] - min[axis] - l->slack_m) / l->lay->spacing_m;
        const double lines = fmax(1, ceil(steps));
        l->first[axis] =
            min[axis] +
            (max[axis] - min[axis] - (lines - 1) * l->lay->spacing_m) / 2;
    }
    return box.min.x <= box.max.x || murk_laying_any_ball(l);
}

static void lay_all(murk_laying *l)
{
    const murk_soup *soup = &l->surfaces->soup;
    murk_triangle t;
    murk_vec3 normal;
    murk_polygon part;
    for (size_t i = 0; i < soup->triangles && goes_on(l, i); ++i) {
        if (face_of(l, i, &t, &normal, &part)) {
            lay_pattern(l, &t, normal, &part);
        }
    }
    murk_laying_poles(l);
    for (size_t i = 0; i < soup->triangles && goes_on(l, i); ++i) {
        if (face_of(l, i, &t, &normal, &part)) {
            fill_part(l, &part, normal);
        }
    }
    murk_laying_balls(l);
}

murk_status murk_surfaces_lay(murk_foot **out, size_t *n,
                              const murk_surfaces *surfaces,
                              const murk_lay *lay, const char *where,
                              murk_error *err)
{
    assert(out && n && surfaces && lay && where);
    assert(lay->spacing_m > murk_lay_min_m(surfaces));
    murk_laying l = {.surfaces = surfaces,
                     .lay = lay,
                     .where = where,
                     .err = err,
                     .slack_m = 2 * surfaces->leave_m};
    l.status = murk_cells_create(&l.cells, lay->spacing_m, err);
    if (l.status) {
        return l.status;
    }
    murk_progress_begin("mounts", 3 * (uint64_t)surfaces->soup.triangles,
                        "faces");
    if (measure(&l)) {
        if (l.squares > SQUARES_A_FOOT * (double)lay->max) {
            l.status = murk_laying_refuse(&l);
        }
        lay_all(&l);
    }
    murk_progress_end();
    murk_cells_destroy(l.cells);
    if (l.status) {
        free(l.foot);
        return l.status;
    }
    *out = l.foot;
    *n = l.n;
    return MURK_OK;
}
