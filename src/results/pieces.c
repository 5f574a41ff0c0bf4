/* Cuts the triangles of a scene into k^2 triangles of the same shape, k by the
 * longest edge, so that a photon finds the piece from the barycentric
 * coordinates of its place alone. A sphere is cut into octants first. */
#include "results/pieces.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

#define OCTANTS       8 /* of a sphere */
#define LEAVES_BEFORE 2 /* steps of murk_surfaces_leave() */
#define CORNER        6 /* times as far, for photons in corners */

/* ---- cutting ---- */

typedef struct ball {
    murk_vec3 center;
    double radius_m;
} ball;

static ball ball_of(const murk_pieces *p, size_t whole)
{
    ball b;
    murk_surfaces_sphere(p->surfaces, (whole - p->triangles) / OCTANTS,
                         &b.center, &b.radius_m);
    return b;
}

static double longest_edge_m(const murk_pieces *p, size_t whole)
{
    if (whole >= p->triangles) {
        /* the edge sqrt(2) r of the flat octant, times sqrt(3), the stretch of
         * the octant's middle when this point is moved to the sphere, which is
         * the largest */
        return ball_of(p, whole).radius_m * sqrt(6);
    }
    murk_vec3 c[3];
    murk_surfaces_triangle(p->surfaces, whole, c);
    return fmax(fmax(murk_length(murk_sub(c[1], c[0])),
                     murk_length(murk_sub(c[2], c[1]))),
                murk_length(murk_sub(c[0], c[2])));
}

/* The number k of parts into which each edge is cut. If the longest edge is a
 * multiple of edge_m within rounding, k is that multiple. */
static double cuts(double longest_m, double edge_m)
{
    return fmax(1, ceil(longest_m / edge_m * (1 - 1e-6)));
}

static double pieces_by(const murk_pieces *p, const double *longest_m,
                        double edge_m)
{
    double n = 0;
    for (size_t i = 0; i < p->wholes; ++i) {
        const double k = cuts(longest_m[i], edge_m);
        n += k * k;
    }
    return n;
}

/* About the shortest edge (to 3 %) with which there are at most `pieces`
 * pieces. */
static double edge_for(const murk_pieces *p, const double *longest_m,
                       double pieces)
{
    double sum = 0, max = 0;
    for (size_t i = 0; i < p->wholes; ++i) {
        sum += longest_m[i] * longest_m[i];
        max = fmax(max, longest_m[i]);
    }
    double edge_m = sqrt(sum / pieces);
    while (edge_m < max && !(pieces_by(p, longest_m, edge_m) <= pieces)) {
        edge_m *= 1.03;
    }
    return edge_m;
}

static murk_status cut_all(murk_pieces *p, const double *longest_m,
                           double edge_m, const char *where, murk_error *err)
{
    const double n = pieces_by(p, longest_m, edge_m);
    const double max = fmax(MURK_PIECES_MAX, (double)p->wholes);
    if (!(n <= max)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "%g m: %.3g pieces of surfaces, must be at most %.9g: "
                         "%.2g m would do",
                         edge_m, n, max, 1.05 * edge_for(p, longest_m, max));
    }
    for (size_t i = 0; i < p->wholes; ++i) {
        p->cut[i] = (uint32_t)cuts(longest_m[i], edge_m);
        p->first[i] = (uint32_t)p->n;
        p->n += (size_t)p->cut[i] * p->cut[i];
    }
    p->first[p->wholes] = (uint32_t)p->n;
    return MURK_OK;
}

murk_status murk_pieces_create(murk_pieces *out, const murk_surfaces *surfaces,
                               double edge_m, double usual, const char *where,
                               murk_error *err)
{
    const murk_surfaces_facts facts = murk_surfaces_describe(surfaces);
    *out = (murk_pieces){.surfaces = surfaces,
                         .triangles = facts.triangles,
                         .spheres = facts.spheres,
                         .wholes = facts.triangles + OCTANTS * facts.spheres,
                         .step_m = LEAVES_BEFORE *
                                   murk_surfaces_leave_step_m(surfaces)};
    /* Cut by the longest edge of each triangle or octant. */
    double *longest_m = calloc(out->wholes + 1, sizeof *longest_m);
    out->cut = malloc(out->wholes * sizeof *out->cut + 1);
    out->first = malloc((out->wholes + 1) * sizeof *out->first);
    murk_status status = MURK_OK;
    if (!longest_m || !out->cut || !out->first) {
        status = murk_no_memory(err, where, "for %zu triangles", out->wholes);
    }
    for (size_t i = 0; !status && i < out->wholes; ++i) {
        longest_m[i] = longest_edge_m(out, i);
    }
    if (!status) {
        status = cut_all(
            out, longest_m,
            edge_m > 0 ? edge_m
                       : edge_for(out, longest_m, (double)out->wholes + usual),
            where, err);
    }
    free(longest_m);
    return status;
}

void murk_pieces_release(murk_pieces *pieces)
{
    free(pieces->cut);
    free(pieces->first);
    *pieces = (murk_pieces){0};
}

/* ---- one piece ---- */

/* The corners of a triangle, or of an octant of the sphere of radius 1 about
 * the origin, wound so that the normal points outward. */
static void corners_of(const murk_pieces *p, size_t whole, murk_vec3 c[3])
{
    if (whole < p->triangles) {
        murk_surfaces_triangle(p->surfaces, whole, c);
        return;
    }
    const size_t octant = (whole - p->triangles) % OCTANTS;
    const bool turned = (octant ^ octant >> 1 ^ octant >> 2) & 1;
    c[0] = murk_vec(octant & 1 ? -1 : 1, 0, 0);
    c[turned ? 2 : 1] = murk_vec(0, octant & 2 ? -1 : 1, 0);
    c[turned ? 1 : 2] = murk_vec(0, 0, octant & 4 ? -1 : 1);
}

/* The place of a piece in a triangle a, b, c that is cut into k^2. Row i,
 * counted from side a..c towards b, has 2 (k - i) - 1 pieces, so i (2 k - i)
 * pieces lie in earlier rows. */
typedef struct spot {
    uint32_t row, column;
    bool is_turned;
} spot;

static spot spot_of(uint32_t k, uint32_t number)
{
    const double all = (double)k * k;
    uint32_t i = (uint32_t)((double)k - sqrt(all - (double)number));
    while (i > 0 && (uint64_t)i * (2 * (uint64_t)k - i) > number) {
        --i;
    }
    while ((uint64_t)(i + 1) * (2 * (uint64_t)k - i - 1) <= number) {
        ++i;
    }
    const uint32_t rest =
        number - (uint32_t)((uint64_t)i * (2 * (uint64_t)k - i));
    return (spot){i, rest / 2, rest % 2 == 1};
}

static uint32_t number_of(uint32_t k, double u, double v)
{
    const double max = k;
    const double a = fmin(fmax(u, 0), 1) * max, b = fmin(fmax(v, 0), 1) * max;
    double i = fmin(floor(a), max - 1);
    double j = fmin(floor(b), max - 1 - i);
    const bool is_turned = a - i + (b - j) > 1 && i + j < max - 1;
    const uint32_t row = (uint32_t)i;
    return row * (2 * k - row) + 2 * (uint32_t)j + (is_turned ? 1 : 0);
}

static murk_vec3 mixed(const murk_vec3 c[3], double u, double v)
{
    return murk_along(murk_along(c[0], u, murk_sub(c[1], c[0])), v,
                      murk_sub(c[2], c[0]));
}

static void cut_out(const murk_vec3 whole[3], uint32_t k, spot at,
                    murk_vec3 c[3])
{
    /* Corners of the piece, in steps of 1 / k along the sides of the whole
     * triangle that meet at whole[0]. A turned piece is rotated by 180 degrees.
     */
    static const double plain[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    static const double turned[3][2] = {{1, 1}, {0, 1}, {1, 0}};
    for (int i = 0; i < 3; ++i) {
        const double *step = at.is_turned ? turned[i] : plain[i];
        c[i] = mixed(whole, (at.row + step[0]) / k, (at.column + step[1]) / k);
    }
}

static double solid_angle(const murk_vec3 c[3])
{
    const double volume = fabs(murk_dot(c[0], murk_cross(c[1], c[2])));
    return 2 * atan2(volume, 1 + murk_dot(c[0], c[1]) + murk_dot(c[1], c[2]) +
                                 murk_dot(c[2], c[0]));
}

static void make_round(murk_piece *piece, ball b)
{
    for (int i = 0; i < 3; ++i) {
        piece->corner[i] = murk_unit(piece->corner[i]);
    }
    piece->area_m2 = b.radius_m * b.radius_m * solid_angle(piece->corner);
    piece->normal = murk_unit(murk_add(
        piece->corner[0], murk_add(piece->corner[1], piece->corner[2])));
    piece->middle = murk_along(b.center, b.radius_m, piece->normal);
    for (int i = 0; i < 3; ++i) {
        piece->corner[i] = murk_along(b.center, b.radius_m, piece->corner[i]);
    }
}

static size_t whole_of(const murk_pieces *p, size_t piece)
{
    size_t low = 0, high = p->wholes;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (p->first[middle] <= piece) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

murk_piece murk_piece_of(const murk_pieces *p, size_t i)
{
    assert(i < p->n);
    const size_t whole = whole_of(p, i);
    const bool is_ball = whole >= p->triangles;
    murk_vec3 c[3];
    murk_piece out;
    /* The corners of the piece within its triangle or octant. */
    corners_of(p, whole, c);
    cut_out(c, p->cut[whole],
            spot_of(p->cut[whole], (uint32_t)(i - p->first[whole])),
            out.corner);
    out.material = murk_surfaces_material_of(
        p->surfaces,
        is_ball ? p->triangles + (whole - p->triangles) / OCTANTS : whole);
    if (is_ball) {
        make_round(&out, ball_of(p, whole));
        return out;
    }
    const murk_vec3 normal = murk_cross(murk_sub(out.corner[1], out.corner[0]),
                                        murk_sub(out.corner[2], out.corner[0]));
    out.area_m2 = murk_length(normal) / 2;
    out.normal = murk_unit(normal);
    out.middle =
        murk_scale(1.0 / 3, murk_add(out.corner[0],
                                     murk_add(out.corner[1], out.corner[2])));
    return out;
}

/* ---- where a photon lies ---- */

static uint32_t on_triangle(const murk_pieces *p, size_t whole, murk_vec3 at)
{
    murk_vec3 c[3];
    murk_surfaces_triangle(p->surfaces, whole, c);
    const murk_vec3 e = murk_sub(c[1], c[0]), f = murk_sub(c[2], c[0]);
    const murk_vec3 d = murk_sub(at, c[0]), n = murk_cross(e, f);
    const double all = murk_dot(n, n);
    return p->first[whole] + number_of(p->cut[whole],
                                       murk_dot(murk_cross(d, f), n) / all,
                                       murk_dot(murk_cross(e, d), n) / all);
}

static uint32_t on_ball(const murk_pieces *p, size_t sphere, murk_vec3 at)
{
    const size_t first = p->triangles + OCTANTS * sphere;
    const murk_vec3 d = murk_sub(at, ball_of(p, first).center);
    const size_t octant =
        (d.x < 0 ? 1U : 0U) | (d.y < 0 ? 2U : 0U) | (d.z < 0 ? 4U : 0U);
    const bool turned = (octant ^ octant >> 1 ^ octant >> 2) & 1;
    const double all = fabs(d.x) + fabs(d.y) + fabs(d.z);
    const double y = fabs(d.y) / all, z = fabs(d.z) / all;
    const size_t whole = first + octant;
    return p->first[whole] +
           number_of(p->cut[whole], turned ? z : y, turned ? y : z);
}

/* Rays back to the surface: a ray at an edge may miss both triangles, so rays
 * beside it are tried, too, and then rays from farther away, because in a
 * corner a photon is stored some way off its surface (murk_surfaces_hit()). */
uint32_t murk_pieces_at(const murk_pieces *p, murk_vec3 place, murk_vec3 normal)
{
    static const double tries[][3] = {
        {1, 0, 0},      {1, 1, 0},      {1, -1, 0},     {1, 0, 1},
        {1, 0, -1},     {CORNER, 0, 0}, {CORNER, 1, 0}, {CORNER, -1, 0},
        {CORNER, 0, 1}, {CORNER, 0, -1}};
    murk_vec3 side[2];
    murk_hit hit;
    murk_frame(normal, &side[0], &side[1]);
    for (size_t i = 0; i < sizeof tries / sizeof *tries; ++i) {
        const double before_m = tries[i][0] * p->step_m;
        murk_vec3 from = murk_along(place, before_m, normal);
        from = murk_along(from, tries[i][1] * p->step_m, side[0]);
        from = murk_along(from, tries[i][2] * p->step_m, side[1]);
        if (murk_surfaces_hit(p->surfaces, from, murk_scale(-1, normal),
                              2 * before_m, &hit)) {
            return hit.triangle < p->triangles
                       ? on_triangle(p, hit.triangle, place)
                       : on_ball(p, hit.triangle - p->triangles, place);
        }
    }
    return MURK_NO_PIECE;
}
