/* What fills a region, in the world: grids by nearest voxels and trilinear,
 * profiles, even media; placed, cut by boxes and spheres, overlapping, one in
 * place of another. The reference is a fine sum over the ray of a plain
 * extinction at points, cut where it is not smooth; or the twins of the walks
 * (plain_grid.h, plain_linear.h). Deterministic. */
#include "base/rng.h"
#include "check.h"
#include "medium/media.h"
#include "plain_linear.h"

#include <stdlib.h>

#define N      12
#define VOXELS (N * N * N)

static const murk_box DOMAIN = {{-50, -50, -50}, {50, 50, 50}};

static float density[2][VOXELS];
static murk_grid *grid[2];
static const double HEIGHTS[] = {-3, -1, -1, 2, 2.5};
static murk_spectrum heights_per_m[5];
static murk_profile profile = {5, HEIGHTS, heights_per_m};

static void make_parts(uint32_t seed)
{
    const size_t size[3] = {N, N, N};
    for (uint32_t g = 0; g < 2; ++g) {
        for (uint32_t i = 0; i < VOXELS; ++i) {
            const murk_random4 r = murk_random(seed, MURK_TEST, i, g, 0);
            density[g][i] = r.u[1] < 0.3 ? (float)r.u[0] : 0;
        }
        murk_affine own = murk_affine_place(murk_vec(10.0 * g, 20, 30), 1,
                                            murk_vec(-4, 1.0 * g, -3));
        for (int row = 0; row < 3; ++row) { /* voxels that are not cubes */
            own.matrix[row][0] *= 0.5;
        }
        murk_error err = {0};
        CHECK(murk_grid_from_samples(&grid[g], size, density[g], &own, "test",
                                     &err) == MURK_OK);
    }
    const double per_m[] = {0.1, 0.4, 0, 0.6, 0.2};
    for (int i = 0; i < 5; ++i) {
        heights_per_m[i] = murk_spectrum_flat(per_m[i], 1);
    }
}

static double plain_profile(double z)
{
    return z < -3    ? 0
           : z < -1  ? 0.1 + 0.15 * (z + 3)
           : z < 2   ? 0.2 * (z + 1)
           : z < 2.5 ? 0.6 - 0.8 * (z - 2)
                     : 0;
}

static murk_medium medium(double extinction_per_m)
{
    return (murk_medium){.extinction_per_m =
                             murk_spectrum_flat(extinction_per_m, 1),
                         .albedo = murk_spectrum_flat(0.5, 1)};
}

static murk_medium of_grid(int g, murk_interpolation interpolation,
                           double extinction_per_m)
{
    murk_medium m = medium(extinction_per_m);
    m.grid = grid[g];
    m.interpolation = interpolation;
    return m;
}

static murk_medium of_profile(double factor)
{
    murk_medium m = medium(factor);
    m.profile = &profile;
    return m;
}

static murk_region region(size_t number, murk_region_shape shape)
{
    return (murk_region){
        .medium = number, .shape = shape, .to_world = murk_affine_identity()};
}

static murk_media *build(const murk_medium *media, size_t n_media,
                         const murk_region *regions, size_t n)
{
    murk_media *out = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&out, media, n_media, regions, n, &DOMAIN, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    return out;
}

typedef struct line {
    murk_vec3 from, along;
    double length;
} line;

static line random_line(uint32_t seed, uint64_t i)
{
    const murk_random4 a = murk_random(seed, MURK_TEST, i, 10, 0);
    const murk_random4 b = murk_random(seed, MURK_TEST, i, 11, 0);
    const murk_vec3 from = {24 * a.u[0] - 12, 24 * a.u[1] - 12,
                            24 * a.u[2] - 12};
    const murk_vec3 to = {10 * b.u[0] - 5, 10 * b.u[1] - 2, 10 * b.u[2] - 3};
    const murk_vec3 offset = murk_sub(to, from);
    return (line){from, murk_unit(offset), 2 * murk_length(offset)};
}

static double depth(const murk_media *media, const line *l)
{
    return murk_media_optical_depth(media, 0, 0, l->from, l->along, l->length);
}

/* The twin of one grid in the world: the ray goes to index space, its
 * parameter stays. */
static double plain_depth(const murk_medium *m, const murk_region *where, int g,
                          const line *l)
{
    const plain_grid plain = {{N, N, N}, density[g]};
    const murk_affine to_world = murk_affine_compose(
        &where->to_world, &murk_grid_describe(m->grid)->index_to_world);
    murk_affine to_index;
    CHECK(murk_affine_invert(&to_world, &to_index));
    const murk_vec3 from = murk_affine_point(&to_index, l->from);
    const murk_vec3 along = murk_affine_direction(&to_index, l->along);
    return m->extinction_per_m.band[0] *
           (m->interpolation == MURK_LINEAR
                ? plain_linear_integral(&plain, from, along, l->length)
                : plain_line_integral(&plain, from, along, l->length));
}

/* Optical depth of the line through the profile: between heights the mean
 * of the extinction is that in the middle. */
static double plain_profile_depth(const line *l)
{
    /* Both ends of the line, and where the line passes a height. */
    double ends[7] = {0, l->length};
    for (int i = 0; i < 5; ++i) {
        const double t = (HEIGHTS[i] - l->from.z) / l->along.z;
        ends[2 + i] = fmin(fmax(t, 0), l->length);
    }
    double sum = 0;
    for (int i = 0; i < 7; ++i) {
        /* The next end after this one. */
        double next = INFINITY;
        for (int k = 0; k < 7; ++k) {
            next = ends[k] > ends[i] && ends[k] < next ? ends[k] : next;
        }
        if (isfinite(next) && next > ends[i]) {
            /* Ends that coincide count once. */
            bool is_first = true;
            for (int k = 0; k < i; ++k) {
                is_first &= ends[k] != ends[i];
            }
            const double middle = (ends[i] + next) / 2;
            sum += is_first ? (next - ends[i]) *
                                  plain_profile(l->from.z + middle * l->along.z)
                            : 0;
        }
    }
    return sum;
}

/* Flights stop where depth says; sums at the place agree with them. */
static void check_flight(const murk_media *media, const line *l, uint32_t seed,
                         uint64_t i)
{
    const double whole = depth(media, l);
    const murk_random4 r = murk_random(seed, MURK_TEST, i, 12, 0);
    const double tau = r.u[0] * whole;
    murk_collision c;
    if (!(whole > 0)) {
        return;
    }
    CHECK(murk_media_fly(media, 0, 0, l->from, l->along, l->length, tau, r.u[1],
                         &c));
    const line before = {l->from, l->along, c.distance_m};
    CHECK_NEAR(depth(media, &before), tau, 1e-12);
    const murk_vec3 at = murk_along(l->from, c.distance_m, l->along);
    const line after = {at, l->along, l->length - c.distance_m};
    CHECK_NEAR(depth(media, &after), whole - tau, 1e-11);
    CHECK_NEAR(c.scattering_per_m, murk_media_scattering(media, 0, 0, at),
               1e-11);
    CHECK(c.scattering_per_m > 0);
    CHECK(!murk_media_fly(media, 0, 0, l->from, l->along, l->length,
                          whole * (1 + 1e-9), r.u[1], &c));
}

/* Nearest and linear grids, moved, turned and scaled, add up with haze and
 * layers. */
static void test_all_fillings_add(uint32_t seed)
{
    /* Five media in one world; two regions are placed elsewhere. */
    const murk_medium media[] = {of_grid(0, MURK_LINEAR, 0.5),
                                 of_grid(1, MURK_NEAREST, 1.5), medium(0.01),
                                 of_grid(1, MURK_LINEAR, 0.25), of_profile(2)};
    murk_region regions[] = {
        region(0, MURK_REGION_GRID), region(1, MURK_REGION_GRID),
        region(2, MURK_REGION_EVERYWHERE), region(3, MURK_REGION_GRID),
        region(4, MURK_REGION_EVERYWHERE)};
    regions[1].to_world =
        murk_affine_place(murk_vec(0, 0, 45), 1.5, murk_vec(1, 1, 0));
    regions[3].to_world =
        murk_affine_place(murk_vec(5, 0, 0), 0.75, murk_vec(0, 1, 0));
    murk_media *together = build(media, 5, regions, 5);
    double max = 0;
    for (uint64_t i = 0; i < 300; ++i) {
        /* Depth of a random line against the sum of the plain twins. */
        const line l = random_line(seed, i);
        const double clear = 0.01 * l.length + 2 * plain_profile_depth(&l);
        const double want = clear + plain_depth(&media[0], &regions[0], 0, &l) +
                            plain_depth(&media[1], &regions[1], 1, &l) +
                            plain_depth(&media[3], &regions[3], 1, &l);
        CHECK_NEAR(depth(together, &l), want, 1e-11);
        /* Free flights along the line agree. */
        check_flight(together, &l, seed, i);
        max = fmax(max, want - clear);
    }
    /* The grids counted on some line. */
    CHECK(max > 1);
    murk_media_destroy(together);
}

/* Each alone is crossed by a segment of its own. */
static void test_each_filling_alone(uint32_t seed)
{
    const murk_medium linear = of_grid(0, MURK_LINEAR, 2);
    const murk_medium layers = of_profile(1);
    const murk_region lies = region(0, MURK_REGION_GRID);
    const murk_region all = region(0, MURK_REGION_EVERYWHERE);
    murk_media *grids = build(&linear, 1, &lies, 1);
    murk_media *heights = build(&layers, 1, &all, 1);
    for (uint64_t i = 0; i < 300; ++i) {
        const line l = random_line(seed, i);
        CHECK_NEAR(depth(grids, &l), plain_depth(&linear, &lies, 0, &l), 1e-12);
        CHECK_NEAR(depth(heights, &l), plain_profile_depth(&l), 1e-12);
        check_flight(grids, &l, seed, i);
        check_flight(heights, &l, seed, i);
    }
    const line flat = {{0, 0, 1}, {1, 0, 0}, 7};
    CHECK_NEAR(depth(heights, &flat), 7 * 0.4, 1e-14);
    const line on_jump = {{0, 0, -1}, {0, 1, 0}, 7}; /* the layer above: 0 */
    CHECK(depth(heights, &on_jump) == 0);
    CHECK_NEAR(murk_media_extinction(heights, 0, 0, murk_vec(0, 0, -1.5)),
               0.325, 1e-15);
    CHECK(murk_media_extinction(heights, 0, 0, murk_vec(0, 0, 2.5)) == 0);
    murk_media_destroy(grids);
    murk_media_destroy(heights);
}

/* A box cut out of a grid or a profile, and what is left of it outside, make
 * up the whole; a region that replaces does so in all of its shape. */
static void test_shapes_around_fillings(uint32_t seed)
{
    const murk_box box = {{-2, 0, -1.5}, {3, 4, 2.2}};
    for (int which = 0; which < 3; ++which) {
        const murk_medium filled = which == 0   ? of_grid(0, MURK_NEAREST, 2)
                                   : which == 1 ? of_grid(0, MURK_LINEAR, 2)
                                                : of_profile(2);
        const murk_medium media[] = {filled, filled, medium(0)};
        murk_region inside = region(0, MURK_REGION_BOX);
        inside.box = box;
        murk_region regions[] = {
            region(0, which == 2 ? MURK_REGION_EVERYWHERE : MURK_REGION_GRID),
            inside, inside};
        regions[2].medium = 2;
        regions[2].replaces = true; /* by nothing */
        murk_media *whole = build(media, 3, regions, 1);
        murk_media *part = build(media, 3, &inside, 1);
        const murk_region hole[] = {regions[0], regions[2], regions[1]};
        murk_media *rest = build(media, 3, hole, 2);
        murk_region instead[] = {region(0, MURK_REGION_EVERYWHERE), inside};
        const murk_medium both[] = {medium(0.25), filled};
        instead[1].medium = 1;
        instead[1].replaces = true;
        murk_media *replaced = build(both, 2, instead, 2);
        double max = 0;
        for (uint64_t i = 0; i < 300; ++i) {
            const line l = random_line(seed, i);
            double t0 = 0, t1 = l.length;
            const bool is_met = murk_box_clip(&box, l.from, l.along, &t0, &t1);
            const line in_box = {murk_along(l.from, t0, l.along), l.along,
                                 t1 - t0};
            const double want = is_met ? depth(whole, &in_box) : 0;
            CHECK_NEAR(depth(part, &l), want, 1e-11);
            CHECK_NEAR(depth(rest, &l) + want, depth(whole, &l), 1e-11);
            CHECK_NEAR(depth(replaced, &l),
                       want + 0.25 * (l.length - (is_met ? t1 - t0 : 0)),
                       1e-11);
            check_flight(part, &l, seed, i);
            check_flight(replaced, &l, seed, i);
            max = fmax(max, want);
        }
        CHECK(max > 1);
        murk_media_destroy(whole);
        murk_media_destroy(part);
        murk_media_destroy(rest);
        murk_media_destroy(replaced);
    }
}

/* A half space leaves of a grid what lies below. */
static void test_a_grid_cut_by_a_level(uint32_t seed)
{
    const murk_medium media = of_grid(0, MURK_LINEAR, 2);
    const murk_region lies = region(0, MURK_REGION_GRID);
    murk_region below = region(0, MURK_REGION_BELOW);
    below.below_z_m = 1;
    murk_media *whole = build(&media, 1, &lies, 1);
    murk_media *part = build(&media, 1, &below, 1);
    for (uint64_t i = 0; i < 100; ++i) {
        line l = random_line(seed, i), low = l;
        const double t = (1 - l.from.z) / l.along.z;
        if (l.along.z < 0) {
            low.from = murk_along(l.from, fmax(0, t), l.along);
            low.length = fmax(0, l.length - fmax(0, t));
        } else {
            low.length = fmin(l.length, fmax(0, t));
        }
        CHECK_NEAR(depth(part, &l), depth(whole, &low), 1e-11);
        check_flight(part, &l, seed, i);
    }
    murk_media_destroy(whole);
    murk_media_destroy(part);
}

/* A profile moves with its region: turned upside down in a moved sphere. */
static void test_a_profile_moves_with_its_region(void)
{
    const murk_medium layers = of_profile(1);
    murk_region ball = region(0, MURK_REGION_SPHERE);
    ball.radius_m = 2;
    ball.to_world =
        murk_affine_place(murk_vec(180, 0, 0), 2, murk_vec(10, 0, 5));
    murk_media *media = build(&layers, 1, &ball, 1);
    const murk_vec3 p = {10.5, 0, 3};
    CHECK_NEAR(murk_media_extinction(media, 0, 0, p), plain_profile(1), 1e-14);
    CHECK(murk_media_extinction(media, 0, 0, murk_vec(10.5, 0, 9.1)) == 0);
    /* down through the ball: heights 2 to -2, twice as long in the world */
    const line l = {{10, 0, 0}, {0, 0, 1}, 20};
    CHECK_NEAR(depth(media, &l), 2 * (0.5 * 3 * 0.6 + (0.25 + 0.4) / 2), 1e-13);
    murk_media_destroy(media);
}

/* A rising and a falling profile have a constant sum. */
static void test_slopes_that_cancel(void)
{
    /* The rising medium scatters only, the falling one absorbs only. */
    const double z[] = {0, 10};
    const murk_spectrum up[] = {murk_spectrum_flat(0, 1),
                                murk_spectrum_flat(1, 1)};
    const murk_spectrum down[] = {up[1], up[0]};
    const murk_profile rises = {2, z, up}, falls = {2, z, down};
    murk_medium media[] = {medium(1), medium(1)};
    media[0].profile = &rises;
    media[0].albedo = murk_spectrum_flat(1, 1);
    media[1].profile = &falls;
    media[1].albedo = murk_spectrum_flat(0, 1);
    const murk_region regions[] = {region(0, MURK_REGION_EVERYWHERE),
                                   region(1, MURK_REGION_EVERYWHERE)};
    murk_media *both = build(media, 2, regions, 2);
    /* At an extinction of 1, an optical depth of 7 is 7 m, and the rising
     * medium has a share of 0.7 there. */
    murk_collision c;
    CHECK(murk_media_fly(both, 0, 0, murk_vec(0, 0, 0), murk_vec(0, 0, 1), 20,
                         7, 0.69, &c));
    CHECK_NEAR(c.distance_m, 7, 1e-13);
    CHECK_NEAR(c.scattering_per_m, 0.7, 1e-13);
    CHECK(c.medium == 0);
    /* A number below this share has chosen the rising medium; a number above
     * the share chooses the falling one. */
    CHECK(murk_media_fly(both, 0, 0, murk_vec(0, 0, 0), murk_vec(0, 0, 1), 20,
                         7, 0.71, &c) &&
          c.medium == 1);
    murk_media_destroy(both);
}

/* The albedo's grid holds 0.25, 0.75, none, 0 along x and 0.5 elsewhere; it is
 * moved with the density, from which its transform may differ. */
static void test_albedo_by_a_grid(void)
{
    murk_grid *albedo = NULL;
    murk_error err = {0};
    CHECK(murk_grid_read_albedo(&albedo, "tests/unit/medium/grids/albedo.vdb",
                                NULL, "test", &err) == MURK_OK);
    for (int is_linear = 0; is_linear < 2; ++is_linear) {
        murk_medium media[] = {medium(2), medium(1)};
        media[0].albedo_grid = albedo;
        media[0].interpolation = is_linear ? MURK_LINEAR : MURK_NEAREST;
        murk_region regions[] = {region(0, MURK_REGION_BOX),
                                 region(1, MURK_REGION_EVERYWHERE)};
        regions[0].box = (murk_box){{-3, -3, -3}, {6, 3, 3}};
        regions[0].to_world =
            murk_affine_place(murk_vec(0, 0, 90), 2, murk_vec(5, 0, 0));
        murk_media *made = build(media, 2, regions, 2);
        /* x of the grid is y of the world, at half the scale */
        static const double at[] = {-1, -0.4, 0.2, 0.8, 1.2, 2.6, 3.2, 4.1};
        static const double nearest[] = {0.5,  0.25, 0.25, 0.75,
                                         0.75, 0,    0,    0.5};
        /* none of the neighbours but one counts next to the gap at 2 */
        static const double linear[] = {0.5, 0.25, 0.35, 0.65, 0.75, 0, 0, 0.5};
        for (int i = 0; i < 8; ++i) {
            const murk_vec3 p = {5, 2 * at[i], 0};
            const double want = is_linear ? linear[i] : nearest[i];
            CHECK_NEAR(murk_media_scattering(made, 0, 0, p), 2 * want + 0.5,
                       1e-14);
            murk_collision c;
            const murk_vec3 from = {p.x - 0.1, p.y, p.z};
            CHECK(murk_media_fly(made, 0, 0, from, murk_vec(1, 0, 0), 1, 0.3,
                                 0.1, &c));
            CHECK(c.medium == 0);
            CHECK_NEAR(c.distance_m, 0.1, 1e-15);
            CHECK_NEAR(c.albedo, want, 1e-14);
            CHECK_NEAR(c.scattering_per_m, 2 * want + 0.5, 1e-14);
        }
        murk_media_destroy(made);
    }
    murk_grid_destroy(albedo);
}

static void refuses(const murk_medium *m, murk_region_shape shape,
                    const char *part)
{
    murk_region r = region(0, shape);
    r.box = (murk_box){{0, 0, 0}, {1, 1, 1}};
    murk_media *out = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&out, m, 1, &r, 1, &DOMAIN, &err) ==
          MURK_BAD_VALUE);
    CHECK(out == NULL);
    CHECK_MENTIONS(err.text, part);
}

static void test_refusals(void)
{
    /* Heights that are not in order, not a number, equal too often, or too
     * few. */
    const murk_spectrum per_m[3] = {{{0}}}, wrong[3] = {{{NAN}}, {{-1}}};
    const double z[][3] = {{0, 1, 0.5}, {0, NAN, 1}, {0, 0, 0}, {1, 1, 1}};
    murk_profile p = {3, z[0], per_m};
    murk_medium m = medium(1);
    m.profile = &p;
    refuses(&m, MURK_REGION_BOX, "profile height 2 is 0.5 m");
    p.z_m = z[1];
    refuses(&m, MURK_REGION_BOX, "profile height 1 is nan m");
    p.z_m = z[2];
    refuses(&m, MURK_REGION_BOX, "each given twice at most");
    p.n = 2;
    refuses(&m, MURK_REGION_BOX, "must span a layer");
    p.n = 1;
    refuses(&m, MURK_REGION_BOX, "a profile of 1 heights, must be 2 or more");
    /* Extinctions that are not a number or negative. */
    p = (murk_profile){2, z[0], wrong};
    refuses(&m, MURK_REGION_BOX, "profile extinction 0 is nan");
    p.extinction_per_m = &wrong[1];
    refuses(&m, MURK_REGION_BOX, "profile extinction 0 is -1");
    /* Media with two fillings, and regions that do not suit the filling. */
    m.grid = grid[0];
    refuses(&m, MURK_REGION_BOX, "has a grid and a profile");
    m.profile = NULL;
    refuses(&m, MURK_REGION_EVERYWHERE, "nowhere beyond its grid");
    m.grid = NULL;
    refuses(&m, MURK_REGION_GRID, "no grid that says where it lies");
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    make_parts(seed);
    test_all_fillings_add(seed);
    test_each_filling_alone(seed);
    test_shapes_around_fillings(seed);
    test_a_grid_cut_by_a_level(seed);
    test_a_profile_moves_with_its_region();
    test_slopes_that_cancel();
    test_albedo_by_a_grid();
    test_refusals();
    murk_grid_destroy(grid[0]);
    murk_grid_destroy(grid[1]);
    return check_done();
}
