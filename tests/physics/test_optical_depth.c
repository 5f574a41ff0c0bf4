/* Optical depths that have a closed form, through grids read trilinearly and
 * through profiles: exponential atmosphere, ramp, Gaussian puff, parabolic
 * sphere, the limb of an exponential atmosphere, one trilinear voxel.
 *
 * What a grid may be off by is known. Between samples h apart, linear
 * interpolation is off by at most h^2/8 max|f''| along each axis (Atkinson, An
 * Introduction to Numerical Analysis, 2nd ed. 1989, 3.1), and trilinear by the
 * sum over the axes; a sample stored as a float by 2^-24 of itself. Times the
 * length of the path that bounds the depth, and is all the tolerance there is.
 * Deterministic. Each case must reject a constant that is off by 0.1 %. */
#include "check.h"
#include "medium/media.h"

#include <float.h>
#include <stdlib.h>

static const murk_box WORLD = {{-1e5, -1e5, -1e5}, {1e5, 1e5, 1e5}};

typedef double (*field)(murk_vec3 p); /* extinction at a point */

/* A field sampled on a box of voxels, and a path through it. */
typedef struct probe {
    field extinction;
    murk_vec3 first, step_m; /* centre of voxel 0, 0, 0, and edges */
    size_t size[3];
    murk_vec3 from, to;
} probe;

static float *samples_of(const probe *p)
{
    float *value = malloc(p->size[0] * p->size[1] * p->size[2] * sizeof *value);
    size_t n = 0;
    for (size_t k = 0; k < p->size[2]; ++k) {
        for (size_t j = 0; j < p->size[1]; ++j) {
            for (size_t i = 0; i < p->size[0]; ++i, ++n) {
                const murk_vec3 at = {p->first.x + p->step_m.x * (double)i,
                                      p->first.y + p->step_m.y * (double)j,
                                      p->first.z + p->step_m.z * (double)k};
                value[n] = (float)p->extinction(at);
            }
        }
    }
    return value;
}

/* Optical depth along the path of the probe; grid and path are turned and
 * moved together, so that the path is oblique to the axes of the world. */
static double depth_through_grid(const probe *p, double factor)
{
    /* A grid with the samples of the probe, interpolated linearly, in a
     * turned region. */
    float *value = samples_of(p);
    murk_affine to_field = murk_affine_identity();
    to_field.matrix[0][0] = p->step_m.x;
    to_field.matrix[1][1] = p->step_m.y;
    to_field.matrix[2][2] = p->step_m.z;
    to_field.shift = p->first;
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_from_samples(&grid, p->size, value, &to_field, "test",
                                 &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    const murk_medium medium = {.extinction_per_m =
                                    murk_spectrum_flat(factor, 1),
                                .grid = grid,
                                .interpolation = MURK_LINEAR};
    const murk_region region = {
        .shape = MURK_REGION_GRID,
        .to_world =
            murk_affine_place(murk_vec(10, 20, 30), 1, murk_vec(1, 2, 3))};
    murk_media *media = NULL;
    CHECK(murk_media_create(&media, &medium, 1, &region, 1, &WORLD, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    /* Move the path with the region; transmittance and optical depth agree. */
    const murk_vec3 from = murk_affine_point(&region.to_world, p->from);
    const murk_vec3 to = murk_affine_point(&region.to_world, p->to);
    const double through = murk_media_transmittance(media, 0, 0, from, to);
    const murk_vec3 offset = murk_sub(to, from);
    const double depth = murk_media_optical_depth(
        media, 0, 0, from, murk_unit(offset), murk_length(offset));
    CHECK_NEAR(through, exp(-depth), 4 * DBL_EPSILON * depth);
    murk_media_destroy(media);
    murk_grid_destroy(grid);
    free(value);
    return depth;
}

static double length_of(const probe *p)
{
    return murk_length(murk_sub(p->to, p->from));
}

/* curvature: the largest |second derivative| along each axis. */
static double bound_of(const probe *p, murk_vec3 curvature, double max)
{
    const murk_vec3 h = p->step_m;
    const double off = h.x * h.x / 8 * curvature.x +
                       h.y * h.y / 8 * curvature.y +
                       h.z * h.z / 8 * curvature.z;
    return length_of(p) * (off + 0x1p-24 * max);
}

/* Within the bound, and the same check would see 0.1 %. */
static void check_depth(double got, double want, double bound)
{
    CHECK_NEAR(got, want, bound);
    CHECK(fabs(got - want * 1.001) > 2 * bound);
}

static double exponential(murk_vec3 p)
{
    return 2 * exp(-p.z / 5);
}

static void test_exponential_atmosphere(void)
{
    const double want = 2 * 5 * (1 - exp(-4.0));
    CHECK_NEAR(want, 9.81684361111, 5e-12); /* as published */
    const probe p = {exponential,  {-1, -1, 0},   {1, 1, 0.02},
                     {3, 3, 1001}, {0.3, 0.4, 0}, {0.3, 0.4, 20}};
    check_depth(depth_through_grid(&p, 1), want,
                bound_of(&p, murk_vec(0, 0, 2 / 25.0), 2));
}

static double ramp(murk_vec3 p)
{
    return 0.2 + 0.4 * p.x;
}

/* Linear along x, so that interpolation is off by nothing at all. */
static void test_linear_ramp(void)
{
    const probe p = {ramp,      {0, -1, -1}, {3.5, 1, 1},
                     {3, 3, 3}, {0, 0.3, 0}, {7, 0.3, 0}};
    check_depth(depth_through_grid(&p, 1), 11.2,
                bound_of(&p, murk_vec(0, 0, 0), 3));
}

static double puff(murk_vec3 p)
{
    return 4 * exp(-murk_dot(p, p) / (2 * 1.5 * 1.5));
}

static void test_gaussian_puff(void)
{
    const double b = 0.7, s = 1.5, root2 = sqrt(2);
    const double want = 4 * exp(-b * b / (2 * s * s)) * s * sqrt(MURK_PI / 2) *
                        (erf(2.3 / s / root2) - erf(-1.2 / s / root2));
    CHECK_NEAR(want, 9.78627302413, 5e-12);
    const probe p = {puff,          {-1.25, 0.5, -0.21}, {0.02, 0.02, 0.02},
                     {190, 21, 21}, {-1.2, b, 0},        {2.3, b, 0}};
    const double max = 4 / (s * s); /* |f''| along any axis, at the centre */
    check_depth(depth_through_grid(&p, 1), want,
                bound_of(&p, murk_vec(max, max, max), 4));
}

#define BALL_STEP_M 0.004

static double ball(murk_vec3 p)
{
    return fmax(0, 5 * (1 - murk_dot(p, p) / 4));
}

/* The slope of 5 / m ends at the surface. In a cell that the surface cuts a
 * trilinear value is off by no more than slope times diagonal; such cells lie
 * within a diagonal of the surface, which the path meets twice at a cosine of
 * 0.8. */
static void test_parabolic_sphere(void)
{
    const double want = 5 * (4.0 / 3) * pow(4 - 1.44, 1.5) / 4;
    CHECK_NEAR(want, 6.82666666667, 5e-12);
    const double h = BALL_STEP_M, diagonal = sqrt(3) * h;
    const probe p = {ball,         {-2.05, 1.19, -0.01}, {h, h, h},
                     {1026, 7, 7}, {-2.04, 1.2, 0},      {2.04, 1.2, 0}};
    const double at_surface = 5 * diagonal * (2 * 2 * diagonal / 0.8);
    check_depth(depth_through_grid(&p, 1), want,
                bound_of(&p, murk_vec(2.5, 2.5, 2.5), 5) + at_surface);
}

static double limb(murk_vec3 p) /* in km and 1/km */
{
    const double r = sqrt(p.x * p.x + (p.y + 6371) * (p.y + 6371) + p.z * p.z);
    return 0.01 * exp(-(r - 6371) / 8);
}

/* Beyond 2000 km of the tangent point the extinction is below 1e-16 of that
 * there. f'' is at most k/(R H) along the path and across, and k/H^2 upwards,
 * k taken at the lowest row that counts. */
static void test_limb_of_an_exponential_atmosphere(void)
{
    const double want = 5.66165112283; /* 2 k R exp(R/H) K1(R/H) */
    const probe p = {limb,         {-2000, -0.05, -1}, {2, 0.1, 1.5},
                     {2001, 2, 3}, {-2000, 0, 0},      {2000, 0, 0}};
    const double k = 0.01 * exp(0.05 / 8);
    const murk_vec3 curvature = {k / (6371 * 8.0), k / (8 * 8.0),
                                 k / (6371 * 8.0)};
    check_depth(depth_through_grid(&p, 1), want, bound_of(&p, curvature, k));
}

static double corner(murk_vec3 p)
{
    static const double value[2][2][2] = {{{3, 11}, {7, 20}},
                                          {{14, 2}, {26, 9}}};
    return value[p.x > 0.5][p.y > 0.5][p.z > 0.5];
}

/* Samples that floats hold, times 0.1: exact but for rounding, here some ten
 * of doubles, and for the digits published. */
static void test_one_trilinear_voxel(void)
{
    const probe p = {corner,    {0, 0, 0},     {1, 1, 1},
                     {2, 2, 2}, {0, 0.1, 0.2}, {1, 0.9, 0.6}};
    check_depth(depth_through_grid(&p, 0.1), 1.49369340897,
                0.5e-11 + 16 * DBL_EPSILON);
}

/* The same laws in layers: exact where the profile is linear, else off by the
 * same h^2/8 max|f''| along the path. */
static double depth_through_layers(size_t n, const double *z_m,
                                   const murk_spectrum *extinction_per_m,
                                   murk_vec3 from, murk_vec3 to)
{
    const murk_profile profile = {n, z_m, extinction_per_m};
    const murk_medium medium = {.extinction_per_m = murk_spectrum_flat(1, 1),
                                .profile = &profile};
    const murk_region region = {.to_world = murk_affine_identity()};
    murk_media *media = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&media, &medium, 1, &region, 1, &WORLD, &err) ==
          MURK_OK);
    const murk_vec3 offset = murk_sub(to, from);
    const double depth = murk_media_optical_depth(
        media, 0, 0, from, murk_unit(offset), murk_length(offset));
    murk_media_destroy(media);
    return depth;
}

#define LAYERS 1000

static void test_layers(void)
{
    const double ends[] = {0, 7};
    const murk_spectrum ramp_per_m[] = {murk_spectrum_flat(0.2, 1),
                                        murk_spectrum_flat(3, 1)};
    check_depth(depth_through_layers(2, ends, ramp_per_m, murk_vec(0, 0, 0),
                                     murk_vec(0, 0, 7)),
                11.2, 16 * DBL_EPSILON * 11.2);

    static double z_m[LAYERS + 1];
    static murk_spectrum per_m[LAYERS + 1];
    for (int i = 0; i <= LAYERS; ++i) {
        z_m[i] = 20.0 * i / LAYERS;
        per_m[i] = murk_spectrum_flat(2 * exp(-z_m[i] / 5), 1);
    }
    const double want = 2 * 5 * (1 - exp(-4.0)), h = 20.0 / LAYERS;
    const double bound = 20 * h * h / 8 * (2 / 25.0);
    check_depth(depth_through_layers(LAYERS + 1, z_m, per_m, murk_vec(0, 0, 20),
                                     murk_vec(0, 0, 0)),
                want, bound);
    /* at 60 degrees, twice as long */
    check_depth(depth_through_layers(LAYERS + 1, z_m, per_m, murk_vec(3, 0, 0),
                                     murk_vec(3 + 20 * sqrt(3), 0, 20)),
                2 * want, 2 * bound);
}

int main(void)
{
    test_exponential_atmosphere();
    test_linear_ramp();
    test_gaussian_puff();
    test_parabolic_sphere();
    test_limb_of_an_exponential_atmosphere();
    test_one_trilinear_voxel();
    test_layers();
    return check_done();
}
