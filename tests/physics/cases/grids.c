/* A pencil of light through grids of extinction and of albedo, nearest and
 * linear, as they lie and turned: the share that passes, and the shares that
 * the first collision scatters and absorbs.
 *
 * The references are integrals along the ray that know the samples alone: the
 * ray is taken to the grid's own axes by undoing translation, scale and
 * rotations one by one, and is cut at every plane at which the field's formula
 * changes. Between two planes a nearest field is constant and a trilinear one
 * is a cubic, so Simpson's rule gives its optical depth exactly; the first
 * collision's albedo is summed over fine steps of that depth. */
#define _DEFAULT_SOURCE /* mkstemp */
#include <stdlib.h>
#include <unistd.h>

#include "cases/groups.h"
#include "cases/reference.h"
#include "medium/grid.h"
#include "medium/grid_write.h"
#include "worlds.h"

#define SOURCE "integral along the ray"

#define NX    5
#define NY    4
#define NZ    6
#define STEPS 400 /* between two planes; the sum is right to some 1e-7 */
#define CUTS  (3 * (NX + NY + NZ + 6))

enum { THROUGH, SCATTERED, ABSORBED, QUANTITIES };

/* Densities .4 to 1.6 and albedos .1 to .9, without order. */
static double density_of(int i, int j, int k)
{
    const int mixed = (7 * i + 5 * j + 11 * k + i * k) % 13;
    return .4 + .1 * mixed;
}

static double albedo_of(int i, int j, int k)
{
    const int mixed = (3 * i + 7 * j + 5 * k + j * k) % 9;
    return .1 + .1 * mixed;
}

/* So that an extinction off by 5 % is refused by the quick form, too. */
#define EXACTNESS 2.

typedef struct grid_case {
    const char *name, *is_wrong;
    bool is_linear, has_albedo_grid;
    murk_vec3 turned_deg;
    double scale;
    murk_vec3 moved_m;
    murk_vec3 from, to; /* the pencil's ends, outside the grid */
    double extinction_per_m;
    double wrong; /* 0, or a factor on the extinction that murk gets */
} grid_case;

/* ---- the reference ---- */

static bool is_in(int i, int j, int k)
{
    return i >= 0 && i < NX && j >= 0 && j < NY && k >= 0 && k < NZ;
}

/* The field at p, in units of voxels with centres at whole numbers. Linear: of
 * the corners that hold a value, with weights that sum to 1 for albedos. */
static double field_at(const grid_case *c, murk_vec3 p, bool is_albedo)
{
    double (*value)(int, int, int) = is_albedo ? albedo_of : density_of;
    if (!c->is_linear) {
        const int i = (int)floor(p.x + .5), j = (int)floor(p.y + .5);
        const int k = (int)floor(p.z + .5);
        return is_in(i, j, k) ? value(i, j, k) : 0;
    }
    const int i0 = (int)floor(p.x), j0 = (int)floor(p.y);
    const int k0 = (int)floor(p.z);
    double sum = 0, weights = 0;
    for (int n = 0; n < 8; ++n) {
        const int i = i0 + (n & 1), j = j0 + (n >> 1 & 1), k = k0 + (n >> 2);
        const double weight =
            (1 - fabs(p.x - i)) * (1 - fabs(p.y - j)) * (1 - fabs(p.z - k));
        if (is_in(i, j, k)) {
            sum += weight * value(i, j, k);
            weights += weight;
        }
    }
    return is_albedo && weights > 0 ? sum / weights : sum;
}

static murk_vec3 turned_back(murk_vec3 p, int axis, double degrees)
{
    const double angle = -degrees * MURK_PI / 180;
    const double c = cos(angle), s = sin(angle);
    switch (axis) {
    case 0:
        return murk_vec(p.x, c * p.y - s * p.z, s * p.y + c * p.z);
    case 1:
        return murk_vec(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
    default:
        return murk_vec(c * p.x - s * p.y, s * p.x + c * p.y, p.z);
    }
}

/* A place of the world in the grid's own voxels. */
static murk_vec3 to_voxels(const grid_case *c, murk_vec3 p)
{
    murk_vec3 q = murk_scale(1 / c->scale, murk_sub(p, c->moved_m));
    q = turned_back(q, 2, c->turned_deg.z);
    q = turned_back(q, 1, c->turned_deg.y);
    return turned_back(q, 0, c->turned_deg.x);
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Fractions of the segment at which the field's formula may change. */
static size_t cuts_of(const grid_case *c, murk_vec3 a, murk_vec3 b,
                      double cut[CUTS])
{
    const double from[3] = {a.x, a.y, a.z}, to[3] = {b.x, b.y, b.z};
    const int size[3] = {NX, NY, NZ};
    const double shift = c->is_linear ? 0 : .5;
    size_t n = 0;
    cut[n++] = 0;
    cut[n++] = 1;
    for (int axis = 0; axis < 3; ++axis) {
        for (int plane = -1; plane <= size[axis]; ++plane) {
            const double t =
                (plane + shift - from[axis]) / (to[axis] - from[axis]);
            if (t > 0 && t < 1) {
                cut[n++] = t;
            }
        }
    }
    qsort(cut, n, sizeof *cut, by_size);
    return n;
}

static void integrate(const grid_case *c, double share[QUANTITIES])
{
    const murk_vec3 a = to_voxels(c, c->from), b = to_voxels(c, c->to);
    const murk_vec3 offset = murk_sub(b, a);
    const double per_share =
        c->extinction_per_m * murk_length(murk_sub(c->to, c->from));
    double cut[CUTS], tau = 0;
    const size_t n = cuts_of(c, a, b, cut);
    share[SCATTERED] = 0;
    for (size_t s = 0; s + 1 < n; ++s) {
        const double step = (cut[s + 1] - cut[s]) / STEPS;
        for (int i = 0; i < STEPS && step > 0; ++i) {
            /* just inside both ends, so that a nearest field knows its side */
            const double t = cut[s] + i * step;
            const double first =
                field_at(c, murk_along(a, t + 1e-9 * step, offset), false);
            const murk_vec3 middle = murk_along(a, t + step / 2, offset);
            const double last = field_at(
                c, murk_along(a, t + (1 - 1e-9) * step, offset), false);
            const double more = per_share * step / 6 *
                                (first + 4 * field_at(c, middle, false) + last);
            share[SCATTERED] +=
                exp(-tau) * -expm1(-more) *
                (c->has_albedo_grid ? field_at(c, middle, true) : 0);
            tau += more;
        }
    }
    share[THROUGH] = exp(-tau);
    share[ABSORBED] = 1 - share[THROUGH] - share[SCATTERED];
}

/* ---- murk ---- */

static void score(const void *context, const murk_event *before,
                  const murk_event *event, double *out)
{
    (void)context;
    if (before->kind == MURK_EVENT_EMITTED) {
        out[THROUGH] += event->kind == MURK_EVENT_ESCAPED ? event->weight : 0;
        if (event->kind == MURK_EVENT_MEDIUM) {
            out[SCATTERED] += event->leaving;
            out[ABSORBED] += event->weight - event->leaving;
        }
    }
}

static void score_through(const void *context, const murk_event *before,
                          const murk_event *event, double *out)
{
    (void)context;
    (void)before;
    out[THROUGH] += event->kind == MURK_EVENT_ESCAPED ? event->weight : 0;
}

static _Noreturn void die(const murk_error *err)
{
    fprintf(stderr, "%s: %s\n", err->where, err->text);
    exit(1);
}

/* Both grids by way of a .vdb file, as a scene has them. */
static void make_grids(murk_grid **density, murk_grid **albedo)
{
    const size_t size[3] = {NX, NY, NZ};
    const murk_affine identity = murk_affine_identity();
    float densities[NX * NY * NZ], albedos[NX * NY * NZ];
    for (int n = 0; n < NX * NY * NZ; ++n) {
        const int i = n % NX, j = n / NX % NY, k = n / (NX * NY);
        densities[n] = (float)density_of(i, j, k);
        albedos[n] = (float)albedo_of(i, j, k);
    }
    const murk_grid_field fields[] = {{"density", densities, NULL},
                                      {"albedo", albedos, NULL}};
    char path[] = "/tmp/murk_grids_XXXXXX";
    const int file = mkstemp(path);
    murk_error err = {0};
    if (file < 0 || close(file) ||
        murk_grid_write(path, fields, 2, size, &identity, &err) ||
        murk_grid_read(density, path, "density", "grid", &err) ||
        murk_grid_read_albedo(albedo, path, "albedo", "grid", &err)) {
        die(&err);
    }
    unlink(path);
}

static void run(validation *v, const grid_case *c)
{
    if (!validation_wants(v, c->name)) {
        return;
    }
    double share[QUANTITIES];
    integrate(c, share);
    /* samples are floats, which are right to 6e-8 of themselves */
    const validation_reference reference[QUANTITIES] = {
        {"passes", share[THROUGH], 1e-6},
        {"scattered at first", share[SCATTERED], 1e-6},
        {"absorbed at first", share[ABSORBED], 1e-6}};
    murk_grid *density = NULL, *albedo = NULL;
    make_grids(&density, &albedo);
    murk_medium medium =
        test_medium(c->extinction_per_m * (c->wrong > 0 ? c->wrong : 1), 0, 0);
    medium.grid = density;
    medium.albedo_grid = c->has_albedo_grid ? albedo : NULL;
    medium.interpolation = c->is_linear ? MURK_LINEAR : MURK_NEAREST;
    murk_region region = test_everywhere(0);
    region.shape = MURK_REGION_GRID;
    region.to_world = murk_affine_place(c->turned_deg, c->scale, c->moved_m);
    const murk_source beam =
        test_beam(c->from, murk_unit(murk_sub(c->to, c->from)));
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-40, -40, -40}, {40, 40, 40}}, false},
                      .lights = &beam,
                      .n_lights = 1,
                      .media = &medium,
                      .n_media = 1,
                      .regions = &region,
                      .n_regions = 1});
    const bool all = c->has_albedo_grid;
    const validation_reference passes = reference[THROUGH];
    validation_trace(v,
                     &(validation_case){.name = c->name,
                                        .source = SOURCE,
                                        .is_wrong = c->is_wrong,
                                        .world = &w.world,
                                        .reference = all ? reference : &passes,
                                        .quantities = all ? QUANTITIES : 1,
                                        .exactness = EXACTNESS,
                                        .score = all ? score : score_through});
    test_world_unmade(&w);
    murk_grid_destroy(density);
    murk_grid_destroy(albedo);
}

void cases_grids(validation *v)
{
    const murk_vec3 none = {0, 0, 0}, turned = {25, -40, 70};
    const murk_vec3 moved = {3, -2, 5};
    /* along z through the column 2, 1, and across a turned and grown grid */
    const murk_vec3 below = {2.1, 1.2, -9}, above = {2.1, 1.2, 20};
    const murk_vec3 far = {-11, -12, -7}, near = {15, 9, 16};
    const grid_case cases[] = {
        {"nearest", NULL, false, false, none, 1, none, below, above, .2, 0},
        {"nearest, turned", NULL, false, false, turned, 2.5, moved, far, near,
         .1, 0},
        {"linear", NULL, true, false, none, 1, none, below, above, .2, 0},
        {"linear, turned", NULL, true, false, turned, 2.5, moved, far, near, .1,
         0},
        {"albedo grid, nearest, turned", NULL, false, true, turned, 2.5, moved,
         far, near, .1, 0},
        {"albedo grid, linear, turned", NULL, true, true, turned, 2.5, moved,
         far, near, .1, 0},
        {"linear, turned", "extinction 5 % up", true, false, turned, 2.5, moved,
         far, near, .1, 1.05},
        {"albedo grid, linear, turned", "extinction 5 % up", true, true, turned,
         2.5, moved, far, near, .1, 1.05}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        run(v, &cases[i]);
    }
}
