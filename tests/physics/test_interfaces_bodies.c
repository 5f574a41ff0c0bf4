/* Boundaries of refractive regions against closed forms: balls in balls, and
 * slabs and a cube of fog in glass.
 *
 * Sources: slabs by adding-doubling (van de Hulst, Multiple Light Scattering,
 * 1980, ch. 4), good to the last digit, among them Giovanelli's (Opt. Acta 2
 * (1955) 153, doi:10.1080/713821040); the cube: the benchmark B1 of Fang and
 * Boas, Opt. Express 17 (2009) 20178, doi:10.1364/OE.17.020178, absorbed .27255
 * to some 1e-4.
 *
 * Its z-tests share a 1e-6 chance of a false alarm with those of
 * test_interfaces.c (Sidak). */
#include "interface_worlds.h"

/* ---- balls ---- */

/* From the middle of a ball light always meets it straight on. */
static void test_lamp_in_a_ball(uint32_t seed)
{
    const murk_vec3 middle = {5, 5, 5};
    const murk_source lamp = test_point(middle);
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
    const murk_source lamp = test_point(middle);
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
    const murk_source beam =
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
    murk_source light = test_beam(murk_vec(0, 0, -0.5), murk_vec(0, 0, 1));
    if (is_diffuse) {
        light.type = MURK_SOURCE_RECT;
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
    const murk_source beam =
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
    test_lamp_in_a_ball(seed);
    test_balls_in_balls(seed);
    test_ball_turns_light(seed);
    test_slabs(seed);
    test_cube(seed);
    return check_done();
}
