/* Boundaries of refractive regions against closed forms: plates clear and
 * absorbing, stacks, the cone of light that leaves water, balls in balls, a
 * tank of glass that holds water, and slabs and a cube of fog in glass.
 *
 * Sources: Born and Wolf, Principles of Optics, 7th ed. (1999), 1.5.2 and 7.6
 * (plates whose beams add without interference: for a lossless stack R/(1 - R)
 * is the sum over its faces of r/(1 - r)); slabs of fog by adding-doubling (van
 * de Hulst, Multiple Light Scattering, 1980, ch. 4), good to the last digit,
 * among them Giovanelli's (Opt. Acta 2 (1955) 153, doi:10.1080/713821040); the
 * cube: the benchmark B1 of Fang and Boas, Opt. Express 17 (2009) 20178,
 * doi:10.1364/OE.17.020178, absorbed .27255 to some 1e-4.
 *
 * The z-tests of a run share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "worlds.h"

#include <stdlib.h>

#define PHOTONS 40000
#define Z_TESTS 56
#define WATER   1.34
#define GLASS   1.5
#define DENSE   1.8 /* flint */

static double limit(void)
{
    return murk_sidak_limit(1e-6, Z_TESTS);
}

static double error_of(double share, double n)
{
    return sqrt(share * (1 - share) / n);
}

static void check_share(double count, double share)
{
    CHECK_WITHIN(limit(), count / PHOTONS, share, error_of(share, PHOTONS));
}

/* Teeth: what was counted must not agree with this. */
static double sigmas_from(double count, double share)
{
    return sigmas_off(count / PHOTONS, share, error_of(share, PHOTONS));
}

/* ---- what is counted ---- */

#define REGIONS 4

typedef struct tale {
    double up, down, lateral; /* escaped through which side */
    double above;             /* escaped above z = 0 */
    double back;              /* escaped against the way `sent` */
    double met[REGIONS], mirrored[REGIONS];
    double at_surfaces, mirrored_at_surfaces;
    double snell_off, normal_off; /* worst */
    const murk_box *box;
    murk_vec3 sent; /* by the first light */
} tale;

static void note_interface(tale *t, const murk_event *event)
{
    const murk_vec3 n = event->normal;
    t->met[event->material_or_medium] += 1;
    t->mirrored[event->material_or_medium] += event->outcome == MURK_MIRRORED;
    CHECK(event->outcome == MURK_MIRRORED ||
          event->outcome == MURK_TRANSMITTED);
    const double in = murk_dot(event->direction_in, n);
    const double out = murk_dot(event->direction_out, n);
    t->normal_off = fmax(t->normal_off, in);
    t->normal_off = fmax(
        t->normal_off, event->outcome == MURK_MIRRORED ? fabs(in + out) : out);
    t->normal_off = fmax(t->normal_off, fabs(murk_length(n) - 1));
}

static void note(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    tale *t = context;
    if (event->kind == MURK_EVENT_ESCAPED) {
        const double z = event->position.z;
        t->up += z == t->box->max.z;
        t->down += z == t->box->min.z;
        t->lateral += z < t->box->max.z && z > t->box->min.z;
        t->above += z > 0;
        t->back += murk_dot(event->direction_out, t->sent) < 0;
    } else if (event->kind == MURK_EVENT_INTERFACE) {
        note_interface(t, event);
    } else if (event->kind == MURK_EVENT_SURFACE) {
        t->at_surfaces += 1;
        t->mirrored_at_surfaces += event->outcome == MURK_MIRRORED;
    }
}

static tale traced(const test_setup *setup, uint32_t seed)
{
    test_world w = test_world_made(setup);
    tale t = {.box = &setup->domain.box, .sent = setup->lights[0].direction};
    test_world_trace(&w, PHOTONS, seed, note, &t);
    CHECK(test_photons(&w, w.ledger->lost) == 0);
    CHECK(t.up + t.down + t.lateral +
              test_photons(&w, w.ledger->absorbed_media) +
              test_photons(&w, w.ledger->absorbed_surfaces) ==
          PHOTONS);
    CHECK(t.normal_off < 1e-14);
    test_world_unmade(&w);
    return t;
}

static murk_region with_index(murk_region region, double ior)
{
    region.ior = ior;
    return region;
}

static murk_region below(size_t medium, double z, double ior)
{
    murk_region region = with_index(test_everywhere(medium), ior);
    region.shape = MURK_REGION_BELOW;
    region.below_z_m = z;
    return region;
}

static const murk_medium clear = {.where = "clear"};

/* ---- closed forms ---- */

/* Unpolarised reflectance, from the angle of incidence alone. */
static double reflectance(double radians, double n_from, double n_to)
{
    const double a = radians, b = asin(sin(a) * n_from / n_to);
    if (a == 0) {
        return pow((n_from - n_to) / (n_from + n_to), 2);
    }
    return (pow(sin(a - b) / sin(a + b), 2) + pow(tan(a - b) / tan(a + b), 2)) /
           2;
}

typedef struct ends {
    double back, through;
} ends;

/* A plate of faces that reflect r each and let the share a through from face
 * to face. */
static ends plate(double r, double a)
{
    const double round = 1 - r * r * a * a;
    return (ends){r + r * a * a * (1 - r) * (1 - r) / round,
                  a * (1 - r) * (1 - r) / round};
}

static double stack(const double *r, int n)
{
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        sum += r[i] / (1 - r[i]);
    }
    return sum / (1 + sum);
}

/* ---- plates ---- */

/* One metre of glass from side to side of a periodic domain. */
static tale through_plate(double degrees, double extinction_per_m, double ior,
                          uint32_t seed)
{
    const double a = degrees * MURK_PI / 180;
    const murk_light beam =
        test_beam(murk_vec(0.1, 0.1, 2), murk_vec(sin(a), 0, -cos(a)));
    const murk_medium glass = test_medium(extinction_per_m, 0, 0);
    const murk_region slab = with_index(
        test_box_region(0, murk_vec(-1, -1, 0), murk_vec(1, 1, 1)), ior);
    return traced(&(test_setup){.domain = {{{-1, -1, -1}, {1, 1, 3}}, true},
                                .lights = &beam,
                                .n_lights = 1,
                                .media = &glass,
                                .n_media = 1,
                                .regions = &slab,
                                .n_regions = 1},
                  seed);
}

static void test_plates(uint32_t seed)
{
    const double degrees[] = {0, 45, 70};
    for (uint32_t i = 0; i < 3; ++i) {
        const double a = degrees[i] * MURK_PI / 180;
        const double r = reflectance(a, 1, GLASS);
        const double path = 1 / sqrt(1 - pow(sin(a) / GLASS, 2));
        ends want = plate(r, 1);
        tale t = through_plate(degrees[i], 0, GLASS, seed + i);
        check_share(t.up, want.back);
        CHECK(t.up + t.down == PHOTONS);
        CHECK(sigmas_from(t.up, r) > limit());
        CHECK(sigmas_from(through_plate(degrees[i], 0, 1.7, seed + i).up,
                          want.back) > limit());
        want = plate(r, exp(-0.7 * path));
        t = through_plate(degrees[i], 0.7, GLASS, seed + i);
        check_share(t.up, want.back);
        check_share(t.down, want.through);
        /* a path not bent */
        if (i > 0) {
            CHECK(sigmas_from(t.down, plate(r, exp(-0.7 / cos(a))).through) >
                  limit());
        }
    }
}

/* Three layers that share their faces, turned together: a stack of four faces,
 * not of six. */
static void test_layers_share_faces(uint32_t seed)
{
    const murk_vec3 turn = {25, -40, 70}, shift = {0.1, 0.2, 0.3};
    const double z[] = {-0.9, -0.3, 0.1, 0.6}, ior[] = {1.6, 1.34, 2.2};
    murk_region layers[3];
    for (int i = 0; i < 3; ++i) {
        layers[i] = with_index(test_box_region(0, murk_vec(-2, -2, z[i]),
                                               murk_vec(2, 2, z[i + 1])),
                               ior[i]);
        layers[i].to_world = murk_affine_place(turn, 1, shift);
    }
    const murk_affine *placed = &layers[0].to_world;
    const murk_light beam =
        test_beam(murk_affine_point(placed, murk_vec(0.1, 0.2, 2)),
                  murk_affine_direction(placed, murk_vec(0, 0, -1)));
    const tale t =
        traced(&(test_setup){.domain = {{{-5, -5, -5}, {5, 5, 5}}, false},
                             .lights = &beam,
                             .n_lights = 1,
                             .media = &clear,
                             .n_media = 1,
                             .regions = layers,
                             .n_regions = 3},
               seed);
    const double r[] = {reflectance(0, 1, 2.2), reflectance(0, 2.2, 1.34),
                        reflectance(0, 1.34, 1.6), reflectance(0, 1.6, 1)};
    const double air = reflectance(0, 1, 1.34);
    const double gaps[] = {r[0], r[0], air, air, r[3], r[3]};
    check_share(t.back, stack(r, 4));
    CHECK(sigmas_from(t.back, stack(gaps, 6)) > limit());
}

/* A tank: panes of glass, as closed meshes, that hold water; their faces lie in
 * each other, or the water reaches into the glass, which counts for more. */
static void test_glass_holds_water(uint32_t seed)
{
    const murk_light beam =
        test_beam(murk_vec(0.13, 0.21, 2), murk_vec(0, 0, -1));
    const murk_material glass = test_material(0, 0, 1, GLASS);
    const murk_surface_desc panes[2] = {
        test_box(murk_vec(-3, -3, 0.7), murk_vec(3, 3, 0.8), 0),
        test_box(murk_vec(-3, -3, -0.9), murk_vec(3, 3, -0.7), 0)};
    const double r[] = {reflectance(0, 1, GLASS), reflectance(0, GLASS, WATER),
                        reflectance(0, GLASS, WATER), reflectance(0, 1, GLASS)};
    const double reaches[] = {0.7, 0.71};
    for (uint32_t i = 0; i < 2; ++i) {
        const double h = reaches[i];
        const murk_region water = with_index(
            test_box_region(0, murk_vec(-2, -2, -h), murk_vec(2, 2, h)), WATER);
        const tale t =
            traced(&(test_setup){.domain = {{{-5, -5, -5}, {5, 5, 5}}, false},
                                 .lights = &beam,
                                 .n_lights = 1,
                                 .surfaces = panes,
                                 .n_surfaces = 2,
                                 .materials = &glass,
                                 .n_materials = 1,
                                 .media = &clear,
                                 .n_media = 1,
                                 .regions = &water,
                                 .n_regions = 1},
                   seed + i);
        CHECK(t.met[0] == 0); /* all of it happens at the glass */
        check_share(t.up, stack(r, 4));
        /* a film of air between them */
        const double air[] = {r[0],
                              r[0],
                              r[0],
                              r[0],
                              reflectance(0, 1, WATER),
                              reflectance(0, 1, WATER)};
        CHECK(sigmas_from(t.up, stack(air, 6)) > limit());
    }
}

/* ---- a region is the same however it is described ---- */

static void test_descriptions_agree(uint32_t seed)
{
    const murk_light lamp = test_point(murk_vec(0.2, 0.1, -0.6));
    const murk_medium water = test_medium(1.5, 0.9, 0.6);
    murk_region same[4] = {
        below(0, 0, WATER),
        with_index(test_box_region(0, murk_vec(-2, -2, -2), murk_vec(2, 2, 0)),
                   WATER),
        with_index(test_box_region(0, murk_vec(-9, -30, -9), murk_vec(9, 4, 0)),
                   WATER),
        with_index(test_box_region(0, murk_vec(-1, 0, -1), murk_vec(1, 1, 1)),
                   WATER)};
    same[3].to_world =
        murk_affine_place(murk_vec(90, 0, 90), 2, murk_vec(-2, 0, -2));
    same[3].box = (murk_box){{-3, 0, -3}, {3, 1, 3}};
    tale t[4];
    for (int i = 0; i < 4; ++i) {
        t[i] =
            traced(&(test_setup){.domain = {{{-2, -2, -2}, {2, 2, 1}}, false},
                                 .lights = &lamp,
                                 .n_lights = 1,
                                 .media = &water,
                                 .n_media = 1,
                                 .regions = &same[i],
                                 .n_regions = 1},
                   seed);
        CHECK(t[i].up == t[0].up && t[i].down == t[0].down);
        CHECK(t[i].met[0] == t[0].met[0]);
        CHECK(t[i].mirrored[0] == t[0].mirrored[0]);
    }
    CHECK(t[0].met[0] > PHOTONS / 4.);
}

/* Clear glass as a region and as a closed mesh, lit aslant: the same random
 * numbers, so nearly every photon fares alike. */
static void test_region_is_like_a_solid(uint32_t seed)
{
    const murk_light beam =
        test_beam(murk_vec(-2, 0.1, 2), murk_vec(1, 0.05, -0.9));
    const murk_vec3 min = {-1, -1, -1}, max = {1, 1, 1};
    const murk_region cube = with_index(test_box_region(0, min, max), GLASS);
    const murk_material glass = test_material(0, 0, 1, GLASS);
    const murk_surface_desc solid = test_box(min, max, 0);
    test_setup setup = {.domain = {{{-4, -4, -4}, {4, 4, 4}}, false},
                        .lights = &beam,
                        .n_lights = 1,
                        .media = &clear,
                        .n_media = 1,
                        .regions = &cube,
                        .n_regions = 1};
    const tale region = traced(&setup, seed);
    setup.n_regions = 0;
    setup.surfaces = &solid;
    setup.n_surfaces = 1;
    setup.materials = &glass;
    setup.n_materials = 1;
    const tale mesh = traced(&setup, seed);
    CHECK(region.up == mesh.up && region.down == mesh.down);
    CHECK(region.lateral == mesh.lateral);
    CHECK(region.met[0] == mesh.at_surfaces && mesh.at_surfaces > PHOTONS);
}

/* ---- out of the water ---- */

/* Of a lamp's light the share that leaves water of that index upwards: the
 * integral over the cosine mu up to the critical angle of 1 - r, one half of it
 * going up. Substituting the cosine in air takes the root at the critical angle
 * out of the integrand. */
static double escaping(double index)
{
    const int n = 20000;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double cosine_air = (i + 0.5) / n;
        const double air = acos(cosine_air);
        const double sine = sin(air) / index;
        const double mu = sqrt(1 - sine * sine);
        const double dmu = cosine_air / (index * index * mu) / n;
        sum += (1 - reflectance(air, 1, index)) * dmu;
    }
    return sum / 2;
}

static tale from_under_water(double index, uint32_t seed)
{
    const murk_light lamp = test_point(murk_vec(0, 0, -1));
    const murk_region sea = below(0, 0, index);
    return traced(&(test_setup){.domain = {{{-9, -9, -3}, {9, 9, 3}}, false},
                                .lights = &lamp,
                                .n_lights = 1,
                                .media = &clear,
                                .n_media = 1,
                                .regions = &sea,
                                .n_regions = 1},
                  seed);
}

static void test_light_leaves_water_in_a_cone(uint32_t seed)
{
    const tale t = from_under_water(WATER, seed);
    check_share(t.above, escaping(WATER));
    CHECK(sigmas_from(t.above, escaping(1.4)) > limit());
    const tale u = from_under_water(GLASS, seed + 1);
    check_share(u.above, escaping(GLASS));
    /* the cone alone, without Fresnel */
    CHECK(sigmas_from(u.above, (1 - sqrt(1 - 1 / (GLASS * GLASS))) / 2) >
          limit());
}

/* ---- balls ---- */

/* From the middle of a ball light always meets it straight on. */
static void test_lamp_in_a_ball(uint32_t seed)
{
    const murk_vec3 middle = {5, 5, 5};
    const murk_light lamp = test_point(middle);
    const double tau = 0.4;
    const murk_medium murky = test_medium(tau / 2, 0, 0);
    const murk_region ball = with_index(test_ball_region(0, middle, 2), DENSE);
    const tale t =
        traced(&(test_setup){.domain = {{{0, 0, 0}, {10, 10, 10}}, false},
                             .lights = &lamp,
                             .n_lights = 1,
                             .media = &murky,
                             .n_media = 1,
                             .regions = &ball,
                             .n_regions = 1},
               seed);
    const double r = reflectance(0, DENSE, 1), a = exp(-tau);
    check_share(t.up + t.down + t.lateral, (1 - r) * a / (1 - r * a * a));
    CHECK(sigmas_from(t.up + t.down + t.lateral, a) > limit());
    CHECK_WITHIN(limit(), t.mirrored[0] / t.met[0], r, error_of(r, t.met[0]));
}

/* A lamp in a bubble of air in a ball of water in a ball of glass, a mesh of
 * the geometry: each boundary splits light by its own two indices. */
static void test_balls_in_balls(uint32_t seed)
{
    const murk_vec3 middle = {0, 0, 0};
    const murk_light lamp = test_point(middle);
    const murk_region balls[3] = {
        with_index(test_ball_region(0, middle, 4), 1.2),
        with_index(test_ball_region(0, middle, 3), WATER),
        with_index(test_ball_region(0, middle, 1), 1)};
    const murk_material glass = test_material(0, 0, 1, GLASS);
    const murk_surface_desc globe = test_sphere(middle, 2, 0);
    test_setup setup = {.domain = {{{-5, -5, -5}, {5, 5, 5}}, false},
                        .lights = &lamp,
                        .n_lights = 1,
                        .materials = &glass,
                        .n_materials = 1,
                        .media = &clear,
                        .n_media = 1,
                        .regions = balls,
                        .n_regions = 3};
    const double want[3] = {reflectance(0, 1.2, 1), reflectance(0, WATER, 1.2),
                            reflectance(0, 1, WATER)};
    tale t = traced(&setup, seed);
    for (int i = 0; i < 3; ++i) {
        CHECK_WITHIN(limit(), t.mirrored[i] / t.met[i], want[i],
                     error_of(want[i], t.met[i]));
    }
    /* in the globe of glass its index holds, and the bubble is hidden */
    setup.surfaces = &globe;
    setup.n_surfaces = 1;
    t = traced(&setup, seed + 1);
    CHECK(t.met[2] == 0);
    CHECK_WITHIN(limit(), t.mirrored[1] / t.met[1], want[1],
                 error_of(want[1], t.met[1]));
    const double r = reflectance(0, GLASS, WATER);
    CHECK_WITHIN(limit(), t.mirrored_at_surfaces / t.at_surfaces, r,
                 error_of(r, t.at_surfaces));
    const double wrong = reflectance(0, GLASS, 1.2);
    CHECK(sigmas_off(t.mirrored_at_surfaces / t.at_surfaces, wrong,
                     error_of(wrong, t.at_surfaces)) > limit());
}

/* Light through a ball is turned twice by the difference of its two angles. */
typedef struct bow {
    double index, offset;
    double through, off;
} bow;

static void note_bow(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    bow *b = context;
    if (event->kind == MURK_EVENT_ESCAPED && event->number == 3) {
        const double in = asin(b->offset), out = asin(b->offset / b->index);
        const double turned = acos(event->direction_out.x);
        /* number 3: two boundaries; one that mirrors the first time leaves
         * after one, one that mirrors inside after three or more */
        b->through += 1;
        b->off = fmax(b->off, fabs(turned - 2 * (in - out)));
    }
}

static void test_ball_turns_light(uint32_t seed)
{
    bow b = {.index = WATER, .offset = 0.6};
    const murk_light beam =
        test_beam(murk_vec(-3, 0.36, 0.48), murk_vec(1, 0, 0));
    const murk_region ball =
        with_index(test_ball_region(0, murk_vec(0, 0, 0), 1), WATER);
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-4, -4, -4}, {4, 4, 4}}, false},
                      .lights = &beam,
                      .n_lights = 1,
                      .media = &clear,
                      .n_media = 1,
                      .regions = &ball,
                      .n_regions = 1});
    test_world_trace(&w, PHOTONS, seed, note_bow, &b);
    const double r = reflectance(asin(b.offset), 1, WATER);
    check_share(b.through, (1 - r) * (1 - r));
    CHECK(b.off < 1e-14);
    test_world_unmade(&w);
}

/* ---- fog in glass ---- */

typedef struct slab {
    double index, albedo, g, tau;
    double back, through; /* lit along the normal */
    double diffuse_back, diffuse_through;
} slab;

/* 60 optical depths stand for a half space: with an albedo of .9 nothing comes
 * back from there. */
static const slab slabs[] = {
    {1.5, .9, .75, 1, .115166, .681225, .186859, .567169},
    {1.5, .99, .5, 5, .442139, .365648, .484963, .332178},
    {1.5, .9, 0, 60, .259919, 0, .307890, 0}, /* Giovanelli */
};

static tale through_slab(const slab *s, bool is_diffuse, uint32_t seed)
{
    murk_light light = test_beam(murk_vec(0, 0, -0.5), murk_vec(0, 0, 1));
    if (is_diffuse) {
        light.type = MURK_LIGHT_RECT;
        light.position = murk_vec(-1, -1, -0.5);
        light.edge1 = murk_vec(2, 0, 0);
        light.edge2 = murk_vec(0, 2, 0);
    }
    const murk_medium fog = test_medium(s->tau, s->albedo, s->g);
    const murk_region region = with_index(
        test_box_region(0, murk_vec(-1, -1, 0), murk_vec(1, 1, 1)), s->index);
    return traced(&(test_setup){.domain = {{{-1, -1, -1}, {1, 1, 2}}, true},
                                .lights = &light,
                                .n_lights = 1,
                                .media = &fog,
                                .n_media = 1,
                                .regions = &region,
                                .n_regions = 1},
                  seed);
}

static void check_slab(const tale *t, double back, double through)
{
    check_share(t->down, back);
    if (through > 0) {
        check_share(t->up, through);
    } else {
        CHECK(t->up == 0);
    }
}

static void test_slabs(uint32_t seed)
{
    for (size_t i = 0; i < sizeof slabs / sizeof *slabs; ++i) {
        const slab *s = &slabs[i];
        tale t = through_slab(s, false, seed + (uint32_t)i);
        check_slab(&t, s->back, s->through);
        t = through_slab(s, true, seed + (uint32_t)i);
        check_slab(&t, s->diffuse_back, s->diffuse_through);
        slab wrong = *s;
        wrong.index = 1.33;
        t = through_slab(&wrong, true, seed + (uint32_t)i);
        CHECK(i == 0 ||
              sigmas_off(t.down / PHOTONS, s->diffuse_back,
                         error_of(s->diffuse_back, PHOTONS)) > limit());
    }
}

/* Light starts in the face of a cube of index 1.37, 60 mm wide. */
static tale in_cube(double index, uint32_t seed)
{
    const murk_light beam =
        test_beam(murk_vec(30.1, 30.2, 0), murk_vec(0, 0, 1));
    const murk_medium fog = test_medium(1.005, 1 / 1.005, .01);
    const murk_region cube = with_index(
        test_box_region(0, murk_vec(0, 0, 0), murk_vec(60, 60, 60)), index);
    return traced(&(test_setup){.domain = {{{-1, -1, -1}, {61, 61, 61}}, false},
                                .lights = &beam,
                                .n_lights = 1,
                                .media = &fog,
                                .n_media = 1,
                                .regions = &cube,
                                .n_regions = 1},
                  seed);
}

static void test_cube(uint32_t seed)
{
    const double want = .27255, known_to = 1e-4;
    const tale t = in_cube(1.37, seed);
    const double got = 1 - (t.up + t.down + t.lateral) / PHOTONS;
    CHECK_WITHIN(limit(), got, want, hypot(error_of(want, PHOTONS), known_to));
    const tale u = in_cube(1.3, seed);
    const double off = 1 - (u.up + u.down + u.lateral) / PHOTONS;
    CHECK(sigmas_off(off, want, error_of(want, PHOTONS)) > limit());
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_plates(seed);
    test_layers_share_faces(seed);
    test_glass_holds_water(seed);
    test_descriptions_agree(seed);
    test_region_is_like_a_solid(seed);
    test_light_leaves_water_in_a_cone(seed);
    test_lamp_in_a_ball(seed);
    test_balls_in_balls(seed);
    test_ball_turns_light(seed);
    test_slabs(seed);
    test_cube(seed);
    return check_done();
}
