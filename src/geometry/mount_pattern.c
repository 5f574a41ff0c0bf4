/* Finds candidate sites on triangles and spheres (geometry/mount_sites.h).
 *
 * Lattice: each face is intersected with the lines of a square lattice along
 * the axis closest to the face's normal. The sites then depend on the place of
 * the face, not on the triangles into which the face is cut. On slanting faces
 * the sites are up to sqrt(3) times too far apart. Gaps: all faces are halved
 * into small pieces, and the middle of a piece becomes a site if no other site
 * of the surface is near. A sphere has its six poles in place of the lattice,
 * and its octants are halved in the same way.
 *
 * Thinning by distance alone would take the far face of a thin wall for the
 * near one; geometry/mount_builder.c therefore compares planes, too. */
#include "geometry/mount_sites.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "geometry/mount_builder.h"
#include "geometry/polygon.h"

#include <assert.h>
#include <stdlib.h>

#define MIN_LEAVES                                                           \
    8 /* smallest spacing in steps of murk_surfaces_leave(): below, rounding \
         decides */
/* An interrupt is checked for every 4096 faces, so that the check costs
 * nothing. */
#define INTERRUPT_MASK 0xfff

/* Every place is within 3/4 + 1/3 of a spacing of a site, so a site stands
 * for up to pi (3/4 + 1/3)^2 = 3.7 squares of the spacing, and twice that if
 * surfaces folded by 60 degrees count as one. A larger area cannot be served
 * with the allowed number of sites, so the search is refused early. */
#define SQUARES_PER_SITE 7.4

double murk_mount_spacing_min_m(const murk_surfaces *surfaces)
{
    return MIN_LEAVES * surfaces->leave_m;
}

static bool is_searched(const murk_mount_builder *l, uint8_t material)
{
    return !l->search->materials || l->search->materials[material];
}

/* Triangle i in world coordinates, its normal, and the part inside the box;
 * false if the triangle is not searched or nothing is inside. */
static bool searched_face(const murk_mount_builder *l, size_t i,
                          murk_triangle *t, murk_vec3 *normal,
                          murk_polygon *part)
{
    const murk_soup *soup = &l->surfaces->soup;
    if (!is_searched(l, murk_soup_material(soup, i))) {
        return false;
    }
    *t = murk_soup_placed_triangle(soup, i);
    *normal = murk_unit(murk_triangle_normal(t));
    const double rise = fabs(normal->z);
    if (!(rise >= l->search->min_rise && rise <= l->search->max_rise)) {
        return false;
    }
    *part =
        murk_polygon_in_box(murk_polygon_of_triangle(t), &l->search->within);
    return part->n > 0;
}

/* The interval to[0]..to[1] on the axis `along` in which a row of the
 * lattice, at `row` on the axis `across`, intersects a polygon; to[0] >
 * to[1] if they do not intersect. */
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

static void add_pattern(murk_mount_builder *l, const murk_triangle *t,
                        murk_vec3 normal, const murk_polygon *p)
{
    /* The axis closest to the normal, and the two axes of the lattice. */
    const double n[3] = {fabs(normal.x), fabs(normal.y), fabs(normal.z)};
    const int facing = n[0] >= n[1] && n[0] >= n[2] ? 0 : n[1] >= n[2] ? 1 : 2;
    const int along = (facing + 1) % 3, across = (facing + 2) % 3;
    const double step = l->search->spacing_m, slack = l->slack_m;
    /* The rows that the polygon spans. */
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
        /* The lattice points of the row that are inside the polygon. */
        const double stop = floor((met[1] + slack - l->first[along]) / step);
        for (double k = ceil((met[0] - slack - l->first[along]) / step);
             k <= stop && !l->status; ++k) {
            murk_component_set(&place, along, l->first[along] + k * step);
            murk_component_set(&place, facing, murk_component(t->a, facing));
            /* Move the lattice point along the axis into the plane of the
             * triangle. */
            const double off = murk_dot(murk_sub(place, t->a), normal);
            murk_component_set(&place, facing,
                               murk_component(t->a, facing) -
                                   off / murk_component(normal, facing));
            murk_mount_builder_offer(l, place, normal);
        }
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

/* A piece of a surface to be halved: a flat triangle, or the part of a sphere
 * between three directions, at most an octant. */
typedef struct piece {
    murk_mount_builder *l;
    murk_vec3 normal; /* of a triangle */
    bool is_sphere;
    murk_vec3 center; /* of a sphere */
    double radius;    /* 1 for a triangle */
} piece;

static murk_vec3 halfway(const piece *p, murk_vec3 a, murk_vec3 b)
{
    const murk_vec3 middle = murk_scale(0.5, murk_add(a, b));
    return p->is_sphere ? murk_unit(middle) : middle;
}

/* Halves the longest side of a piece recursively until all sides are short; the
 * middle of each piece is offered as a site. Parts of a sphere out of reach of
 * the box are skipped. */
static void fill_gaps(const piece *p, murk_vec3 a, murk_vec3 b, murk_vec3 c)
{
    murk_mount_builder *l = p->l;
    const double ab = murk_length(murk_sub(b, a)),
                 bc = murk_length(murk_sub(c, b)),
                 ca = murk_length(murk_sub(a, c));
    const murk_vec3 sum = murk_add(a, murk_add(b, c));
    murk_vec3 place = murk_scale(1.0 / 3, sum), normal = p->normal;
    if (l->status) {
        return;
    }
    if (p->is_sphere) {
        /* The middle of the part, and the largest distance of a corner. */
        normal = murk_unit(sum);
        place = murk_along(p->center, p->radius, normal);
        const double far = fmax(murk_length(murk_sub(a, normal)),
                                fmax(murk_length(murk_sub(b, normal)),
                                     murk_length(murk_sub(c, normal))));
        if (distance_to(&l->search->within, place) >
            p->radius * far + l->slack_m) {
            return;
        }
    }
    /* A small piece offers a site; otherwise halve the longest side. */
    if (!(p->radius * fmax(ab, fmax(bc, ca)) >
          MURK_MOUNT_PIECE * l->search->spacing_m)) {
        murk_mount_builder_offer(l, place, normal);
    } else if (ab >= bc && ab >= ca) {
        fill_gaps(p, a, halfway(p, a, b), c);
        fill_gaps(p, halfway(p, a, b), b, c);
    } else if (bc >= ca) {
        fill_gaps(p, b, halfway(p, b, c), a);
        fill_gaps(p, halfway(p, b, c), c, a);
    } else {
        fill_gaps(p, c, halfway(p, c, a), b);
        fill_gaps(p, halfway(p, c, a), a, b);
    }
}

/* Fills the part of a triangle in the box, divided into a fan of triangles. A
 * flat box may leave only a segment or a point of a triangle. */
static void fill_part(murk_mount_builder *l, const murk_polygon *p,
                      murk_vec3 normal)
{
    const piece flat = {.l = l, .normal = normal, .radius = 1};
    if (p->n < 3) {
        fill_gaps(&flat, p->corner[0], p->corner[0], p->corner[p->n - 1]);
    }
    for (size_t k = 2; k < p->n; ++k) {
        fill_gaps(&flat, p->corner[0], p->corner[k - 1], p->corner[k]);
    }
}

/* ---- spheres ---- */

typedef enum sphere_part { NOTHING, POLES, GAPS } sphere_part;

/* Offers the points of the searched spheres on the six half axes (POLES), fills
 * the gaps between these points octant by octant (GAPS), or does neither
 * (NOTHING). True if any sphere is searched. */
static bool search_spheres(murk_mount_builder *l, sphere_part part)
{
    const murk_soup *soup = &l->surfaces->soup;
    bool any = false;
    for (size_t i = 0; i < soup->spheres && !l->status; ++i) {
        const murk_stored_sphere *b = &soup->sphere[i];
        const piece round = {.l = l,
                             .is_sphere = true,
                             .center = murk_add(b->center, soup->anchor),
                             .radius = b->radius};
        if (!is_searched(l, b->material)) {
            continue;
        }
        any = true;
        /* The six poles, or the eight octants. */
        for (int k = 0; part == POLES && k < 6; ++k) {
            murk_vec3 pole = {0, 0, 0};
            murk_component_set(&pole, k / 2, k % 2 ? 1 : -1);
            murk_mount_builder_offer(
                l, murk_along(round.center, b->radius, pole), pole);
        }
        for (int k = 0; part == GAPS && k < 8; ++k) {
            fill_gaps(&round, murk_vec(k & 1 ? 1 : -1, 0, 0),
                      murk_vec(0, k & 2 ? 1 : -1, 0),
                      murk_vec(0, 0, k & 4 ? 1 : -1));
        }
    }
    return any;
}

/* ---- the search ---- */

/* Advances the progress by one face and, if i is a multiple of 4096, checks for
 * an interrupt. False if the search has failed or was interrupted. */
static bool goes_on(murk_mount_builder *l, size_t i)
{
    murk_progress_add(1);
    if (!l->status && (i & INTERRUPT_MASK) == 0) {
        l->status = murk_interrupt_check(l->err);
    }
    return !l->status;
}

/* Measures bounding box and area of all searched faces and centres the
 * lattice in the box. False if nothing is searched. */
static bool measure(murk_mount_builder *l)
{
    const murk_soup *soup = &l->surfaces->soup;
    const double square = l->search->spacing_m * l->search->spacing_m;
    murk_box box = murk_box_empty();
    for (size_t i = 0; i < soup->triangles && goes_on(l, i); ++i) {
        murk_triangle t;
        murk_vec3 normal;
        murk_polygon part;
        if (searched_face(l, i, &t, &normal, &part)) {
            l->squares += murk_polygon_area_m2(&part) / square;
            for (size_t k = 0; k < part.n; ++k) {
                box = murk_box_with(box, part.corner[k]);
            }
        }
    }
    const double min[3] = {box.min.x, box.min.y, box.min.z};
    const double max[3] = {box.max.x, box.max.y, box.max.z};
    for (int axis = 0; axis < 3 && box.min.x <= box.max.x; ++axis) {
        /* The number of lines that fit, without a last one that fits only by
         * rounding. */
        const double steps =
            (max[axis] - min[axis] - l->slack_m) / l->search->spacing_m;
        const double lines = fmax(1, ceil(steps));
        l->first[axis] =
            min[axis] +
            (max[axis] - min[axis] - (lines - 1) * l->search->spacing_m) / 2;
    }
    return box.min.x <= box.max.x || search_spheres(l, NOTHING);
}

static void add_all_sites(murk_mount_builder *l)
{
    const murk_soup *soup = &l->surfaces->soup;
    murk_triangle t;
    murk_vec3 normal;
    murk_polygon part;
    for (size_t i = 0; i < soup->triangles && goes_on(l, i); ++i) {
        if (searched_face(l, i, &t, &normal, &part)) {
            add_pattern(l, &t, normal, &part);
        }
    }
    /* Lattice points on triangles come first, then poles of spheres, then
     * the gaps. */
    search_spheres(l, POLES);
    for (size_t i = 0; i < soup->triangles && goes_on(l, i); ++i) {
        if (searched_face(l, i, &t, &normal, &part)) {
            fill_part(l, &part, normal);
        }
    }
    search_spheres(l, GAPS);
}

murk_status murk_surfaces_mount_sites(murk_mount_site **out, size_t *n,
                                      const murk_surfaces *surfaces,
                                      const murk_mount_search *search,
                                      const char *where, murk_error *err)
{
    assert(out && n && surfaces && search && where);
    assert(search->spacing_m > murk_mount_spacing_min_m(surfaces));
    murk_mount_builder l = {.surfaces = surfaces,
                            .search = search,
                            .where = where,
                            .err = err,
                            .slack_m = 2 * surfaces->leave_m};
    /* The grid of cells finds neighbours of a site. */
    l.status = murk_cells_create(&l.cells, search->spacing_m, err);
    if (l.status) {
        return l.status;
    }
    murk_progress_begin("mounts", 3 * (uint64_t)surfaces->soup.triangles,
                        "faces");
    /* Refuse an area that is too large; otherwise search. */
    if (measure(&l)) {
        if (l.squares > SQUARES_PER_SITE * (double)search->max) {
            l.status = murk_mount_builder_refuse(&l);
        }
        add_all_sites(&l);
    }
    murk_progress_end();
    murk_cells_destroy(l.cells);
    if (l.status) {
        free(l.site);
        return l.status;
    }
    *out = l.site;
    *n = l.n;
    return MURK_OK;
}
