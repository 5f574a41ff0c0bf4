/* What becomes of photons at the boundaries of refractive regions, told by
 * their events: indices of nested regions and solids, floors and sheets that
 * lie in a boundary, sides of the domain. What is checked holds for every
 * photon, whatever the roulette says. */
#include "check.h"
#include "medium/fresnel.h"
#include "transport/bounce.h"
#include "worlds.h"

#define PHOTONS 400
#define NOTED   64
#define WATER   1.34
#define GLASS   1.5

typedef struct story {
    size_t n;
    murk_event event[NOTED];
} story;

/* The first events of each photon. */
static void note(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    story *s = &((story *)context)[event->photon];
    if (s->n < NOTED) {
        s->event[s->n++] = *event;
    }
}

static story stories[PHOTONS];

static void tell(const test_setup *setup)
{
    memset(stories, 0, sizeof stories);
    test_world w = test_world_made(setup);
    test_world_trace(&w, PHOTONS, 3, note, stories);
    CHECK(test_photons(&w, w.ledger->lost) == 0);
    test_world_unmade(&w);
}

static const murk_domain cell = {{{0, 0, 0}, {1, 1, 1}}, false};
static const murk_domain tile = {{{0, 0, 0}, {1, 1, 1}}, true};
static const murk_medium clear = {.where = "clear"};

static murk_region below(size_t medium, double z, double ior)
{
    murk_region region = test_everywhere(medium);
    region.shape = MURK_REGION_BELOW;
    region.below_z_m = z;
    region.ior = ior;
    return region;
}

static murk_region block(murk_vec3 min, murk_vec3 max, double ior)
{
    murk_region region = test_box_region(0, min, max);
    region.ior = ior;
    return region;
}

static bool is(const murk_event *e, murk_event_kind kind, murk_outcome outcome)
{
    return e->kind == kind && e->outcome == outcome;
}

static double sine(murk_vec3 d, murk_vec3 n)
{
    return murk_length(murk_cross(d, n));
}

/* The number that decides is Fresnel's reflectance. */
static void test_refraction_is_fresnels_roulette(void)
{
    const murk_vec3 n = {0, 0, 1}, d = murk_unit(murk_vec(1, 0, -1));
    double t;
    const double r = murk_fresnel(1, WATER, sqrt(0.5), &t);
    murk_bounce b = murk_refract(1, WATER, d, n, r - 1e-12);
    CHECK(b.outcome == MURK_MIRRORED);
    CHECK_NEAR(b.direction.z, sqrt(0.5), 1e-15);
    b = murk_refract(1, WATER, d, n, r + 1e-12);
    CHECK(b.outcome == MURK_TRANSMITTED);
    CHECK_NEAR(b.direction.x, sqrt(0.5) / WATER, 1e-15);
    CHECK_NEAR(b.direction.z, -t, 1e-15);
    /* beyond the critical angle, whatever the number */
    b = murk_refract(WATER, 1, murk_unit(murk_vec(1.2, 0, 1)),
                     murk_vec(0, 0, -1), 1 - 1e-10);
    CHECK(b.outcome == MURK_MIRRORED);
}

/* A beam through the surface of water to a black floor: the bottom of the
 * water coincides with the floor, which single precision puts elsewhere. */
static void test_floor_under_water_is_wet(void)
{
    const murk_source beam =
        test_beam(murk_vec(0.3, 0.5, 0.9), murk_vec(0.2, 0, -1));
    const murk_vec3 x = {1, 0, 0}, y = {0, 1, 0};
    /* The bottom lies in the floor, just above and just below. */
    const double bottoms[] = {0.1, 0.1 + 1e-7, 0.1 - 1e-7};
    for (int i = 0; i < 3; ++i) {
        /* Trace each, and note the events of all photons. */
        const double bottom = bottoms[i];
        const murk_surface_desc floor = test_rect(murk_vec(0, 0, 0.1), x, y, 0);
        const murk_region pool =
            block(murk_vec(0, 0, bottom), murk_vec(1, 1, 0.6), WATER);
        tell(&(test_setup){.domain = cell,
                           .lights = &beam,
                           .n_lights = 1,
                           .surfaces = &floor,
                           .n_surfaces = 1,
                           .media = &clear,
                           .n_media = 1,
                           .regions = &pool,
                           .n_regions = 1});
        int wet = 0;
        for (int k = 0; k < PHOTONS; ++k) {
            /* After emission, each photon meets the surface of the water. */
            const story *s = &stories[k];
            CHECK(s->n == 3);
            CHECK(s->event[1].kind == MURK_EVENT_INTERFACE);
            CHECK(s->event[1].material_or_medium == 0);
            CHECK(s->event[1].normal.z == 1);
            CHECK_NEAR(s->event[1].position.z, 0.6, 1e-16);
            /* Transmitted light is absorbed by the floor; mirrored light
             * escapes. */
            if (s->event[1].outcome == MURK_TRANSMITTED) {
                ++wet;
                CHECK(is(&s->event[2], MURK_EVENT_SURFACE, MURK_ABSORBED));
                CHECK_NEAR(s->event[2].position.z, 0.1, 1e-7);
                CHECK(s->event[2].event_class == MURK_CLASS_SPECULAR);
            } else {
                CHECK(s->event[2].kind == MURK_EVENT_ESCAPED);
            }
        }
        CHECK(wet > PHOTONS * 0.9);
    }
}

/* A film on water: light passes the film, then meets the surface of the
 * water; light that is mirrored there meets the film again. */
static void test_sheet_on_the_water(void)
{
    /* The film coincides with the surface of the water. */
    const murk_material film = test_material(0, 0, 0.6, 0);
    const murk_vec3 x = {1, 0, 0}, y = {0, 1, 0};
    const murk_surface_desc sheet = test_rect(murk_vec(0, 0, 0.3), x, y, 0);
    const murk_region sea = below(0, 0.3, 3);
    const murk_vec3 from[] = {{0.3, 0.5, 0.8}, {0.3, 0.5, 0.1}};
    for (int i = 0; i < 2; ++i) {
        /* From above and from below. */
        const murk_source beam =
            test_beam(from[i], murk_vec(0.1, 0, i == 0 ? -1 : 1));
        tell(&(test_setup){.domain = cell,
                           .lights = &beam,
                           .n_lights = 1,
                           .surfaces = &sheet,
                           .n_surfaces = 1,
                           .materials = &film,
                           .n_materials = 1,
                           .media = &clear,
                           .n_media = 1,
                           .regions = &sea,
                           .n_regions = 1});
        int through = 0, mirrored = 0;
        for (int k = 0; k < PHOTONS; ++k) {
            /* The film comes first; light through the surface escapes, and
             * mirrored light meets the film. */
            const story *s = &stories[k];
            CHECK(s->event[1].kind == MURK_EVENT_SURFACE);
            for (size_t e = 1; e + 1 < s->n; ++e) {
                if (is(&s->event[e], MURK_EVENT_INTERFACE, MURK_TRANSMITTED)) {
                    ++through;
                    CHECK(s->event[e + 1].kind == MURK_EVENT_ESCAPED);
                } else if (s->event[e].kind == MURK_EVENT_INTERFACE) {
                    ++mirrored;
                    CHECK(s->event[e + 1].kind == MURK_EVENT_SURFACE);
                }
            }
        }
        CHECK(through > 0 && mirrored > 0);
    }
}

/* A block of glass stands half in water: in it the water's surface does
 * nothing, and below it leaves to water. */
static void test_glass_half_in_water(void)
{
    const murk_material glass = test_material(0, 0, 1, GLASS);
    const murk_surface_desc solid =
        test_box(murk_vec(.2, .2, .25), murk_vec(.8, .8, .75), 0);
    const murk_region sea = below(0, 0.5, WATER);
    const double from[] = {0.4, 0.6}, direction_z[] = {1, -1},
                 n_out[] = {1, WATER};
    for (int i = 0; i < 2; ++i) {
        const murk_source beam = test_beam(murk_vec(.5, .5, from[i]),
                                           murk_vec(.2, .1, direction_z[i]));
        tell(&(test_setup){.domain = cell,
                           .lights = &beam,
                           .n_lights = 1,
                           .surfaces = &solid,
                           .n_surfaces = 1,
                           .materials = &glass,
                           .n_materials = 1,
                           .media = &clear,
                           .n_media = 1,
                           .regions = &sea,
                           .n_regions = 1});
        int left = 0;
        for (int k = 0; k < PHOTONS; ++k) {
            const murk_event *e = stories[k].event;
            CHECK(e[1].kind == MURK_EVENT_SURFACE); /* not the level */
            /* the whole way to it, past the level */
            CHECK_NEAR(e[1].path_m, 0.35 * sqrt(1.05), 1e-6);
            if (e[1].outcome == MURK_TRANSMITTED) {
                ++left;
                CHECK_NEAR(sine(e[1].direction_out, e[1].normal) * n_out[i],
                           sine(e[1].direction_in, e[1].normal) * GLASS, 1e-14);
            }
        }
        CHECK(left > PHOTONS * 0.9);
    }
}

/* Met a hair below the water's surface, a glass wall that stands upright in it
 * is in the water: what goes on in the glass comes out into water. */
static void test_walls_that_cross_the_level(void)
{
    const murk_material glass = test_material(0, 0, 1, GLASS);
    const murk_surface_desc solid =
        test_box(murk_vec(.2, .2, .25), murk_vec(.8, .8, .75), 0);
    const murk_region sea = below(0, 0.5, WATER);
    /* one in water all the way, one from the air through both at once */
    const murk_source beam =
        test_beam(murk_vec(.1, .5, .5 - 2e-7 + .02), murk_vec(1, 0, -.2));
    const murk_source level =
        test_beam(murk_vec(.1, .5, .5 - 2e-7), murk_vec(1, .1, 1e-7));
    const murk_source *lights[] = {&level, &beam};
    for (int i = 0; i < 2; ++i) {
        tell(&(test_setup){.domain = cell,
                           .lights = lights[i],
                           .n_lights = 1,
                           .surfaces = &solid,
                           .n_surfaces = 1,
                           .materials = &glass,
                           .n_materials = 1,
                           .media = &clear,
                           .n_media = 1,
                           .regions = &sea,
                           .n_regions = 1});
        int left = 0;
        for (int k = 0; k < PHOTONS; ++k) {
            const story *s = &stories[k];
            for (size_t e = 2; e < s->n; ++e) {
                const murk_event *out = &s->event[e];
                if (s->event[e - 1].kind != MURK_EVENT_SURFACE ||
                    s->event[e - 1].outcome != MURK_TRANSMITTED ||
                    !is(out, MURK_EVENT_SURFACE, MURK_TRANSMITTED)) {
                    continue;
                }
                ++left;
                const double n = out->position.z < 0.5 ? WATER : 1;
                CHECK_NEAR(sine(out->direction_out, out->normal) * n,
                           sine(out->direction_in, out->normal) * GLASS, 1e-14);
            }
        }
        CHECK(left > PHOTONS * 0.8);
    }
}

/* The same index inside and out is no event, and nothing is reflected. */
static void test_equal_indices_are_silent(void)
{
    const murk_source beam =
        test_beam(murk_vec(0.1, 0.2, 0.9), murk_vec(0.5, 0.4, -0.8));
    const murk_region regions[] = {
        below(0, 0.8, WATER),
        block(murk_vec(.1, .1, .1), murk_vec(.9, .9, .7), WATER),
        block(murk_vec(.2, .2, .2), murk_vec(.8, .8, .6), WATER)};
    tell(&(test_setup){.domain = cell,
                       .lights = &beam,
                       .n_lights = 1,
                       .media = &clear,
                       .n_media = 1,
                       .regions = regions,
                       .n_regions = 3});
    for (int k = 0; k < PHOTONS; ++k) {
        const story *s = &stories[k];
        CHECK(s->n == 3);
        CHECK(s->event[1].kind == MURK_EVENT_INTERFACE);
        CHECK(s->event[2].kind == MURK_EVENT_ESCAPED);
        const murk_vec3 offset =
            murk_sub(s->event[2].position, s->event[1].position);
        CHECK_NEAR(s->event[2].path_m, murk_length(offset), 1e-15);
    }
}

/* Light sources in water start there; light that enters through a side
 * under water does not pass the surface. */
static void test_where_light_starts(void)
{
    /* A point source just below the surface of black water. */
    const murk_medium ink = test_medium(1e4, 0, 0);
    const murk_region sea = below(0, 0.5, WATER);
    murk_source light = test_point(murk_vec(0.5, 0.5, 0.4999));
    test_setup setup = {.domain = cell,
                        .lights = &light,
                        .n_lights = 1,
                        .media = &ink,
                        .n_media = 1,
                        .regions = &sea,
                        .n_regions = 1};
    /* Photons are absorbed first, or meet the surface from below. */
    tell(&setup);
    int first = 0;
    for (int k = 0; k < PHOTONS; ++k) {
        const murk_event *e = stories[k].event;
        if (e[1].kind == MURK_EVENT_MEDIUM) {
            ++first;
            CHECK(e[1].event_class == MURK_CLASS_FIRST);
        } else {
            CHECK(e[1].kind == MURK_EVENT_INTERFACE);
            CHECK(e[1].direction_in.z > 0 && e[1].normal.z == -1);
            CHECK(e[1].outcome == MURK_MIRRORED || e[1].direction_out.z > 0);
        }
    }
    CHECK(first > 0 && first < PHOTONS);

    /* A sun from the side: photons that enter under water are absorbed
     * without a boundary before; those from above are refracted first. */
    light.type = MURK_SOURCE_DIRECTIONAL;
    light.direction = murk_vec(1, 0, -0.1);
    tell(&setup);
    int beneath = 0;
    for (int k = 0; k < PHOTONS; ++k) {
        const murk_event *e = stories[k].event;
        if (e[0].position.z < 0.5) {
            ++beneath;
            CHECK(is(&e[1], MURK_EVENT_MEDIUM, MURK_ABSORBED));
            CHECK(e[1].event_class == MURK_CLASS_FIRST);
        } else if (is(&e[1], MURK_EVENT_INTERFACE, MURK_TRANSMITTED)) {
            CHECK(e[2].kind == MURK_EVENT_MEDIUM);
            CHECK(e[2].event_class == MURK_CLASS_SPECULAR);
        }
    }
    CHECK(beneath > PHOTONS / 4);
}

/* Light from a lamp in a boundary starts on the side that it heads for,
 * whichever side the region is on: it meets the sea or leaves it for good,
 * without a boundary between. */
static void test_lamp_in_a_boundary(void)
{
    const murk_medium ink = test_medium(1e4, 0, 0);
    const murk_region sea[] = {
        below(0, 0.5, WATER),
        block(murk_vec(-1, -1, -1), murk_vec(2, 2, 0.5), WATER),
        block(murk_vec(-1, -1, 0.5), murk_vec(2, 2, 2), WATER)};
    const murk_source light = test_point(murk_vec(0.5, 0.5, 0.5));
    for (int i = 0; i < 3; ++i) {
        tell(&(test_setup){.domain = cell,
                           .lights = &light,
                           .n_lights = 1,
                           .media = &ink,
                           .n_media = 1,
                           .regions = &sea[i],
                           .n_regions = 1});
        for (int k = 0; k < PHOTONS; ++k) {
            const murk_event *e = stories[k].event;
            const bool is_wet = (e[0].direction_out.z < 0) == (i < 2);
            CHECK(stories[k].n == 2);
            CHECK(e[1].kind ==
                  (is_wet ? MURK_EVENT_MEDIUM : MURK_EVENT_ESCAPED));
        }
    }
}

/* A layer from side to side has no edges: light totally reflected in it wraps
 * and never leaves it but at the bottom of the domain. */
static void test_layers_go_on_at_periodic_sides(void)
{
    const murk_source beam =
        test_beam(murk_vec(0.5, 0.5, 0.01), murk_vec(1, 0.3, 0.2));
    const murk_region layers[] = {
        below(0, 0.7, WATER),
        block(murk_vec(0, 0, 0), murk_vec(1, 1, 0.7), WATER),
        block(murk_vec(-5, -3, -1), murk_vec(4, 9, 0.7), WATER)};
    for (int i = 0; i < 3; ++i) {
        tell(&(test_setup){.domain = tile,
                           .lights = &beam,
                           .n_lights = 1,
                           .media = &clear,
                           .n_media = 1,
                           .regions = &layers[i],
                           .n_regions = 1});
        for (int k = 0; k < PHOTONS; ++k) {
            const story *s = &stories[k];
            int wraps = 0, mirrored = 0;
            for (size_t e = 1; e + 1 < s->n; ++e) {
                wraps += s->event[e].kind == MURK_EVENT_WRAPPED;
                mirrored +=
                    is(&s->event[e], MURK_EVENT_INTERFACE, MURK_MIRRORED);
            }
            CHECK(mirrored == 1 && wraps == (int)s->n - 3);
            CHECK(wraps >= 7); /* 6.9 m along x, 2.1 along y */
            CHECK(s->event[s->n - 1].kind == MURK_EVENT_ESCAPED);
            CHECK(s->event[s->n - 1].position.z == 0);
        }
    }
}

int main(void)
{
    test_refraction_is_fresnels_roulette();
    test_floor_under_water_is_wet();
    test_sheet_on_the_water();
    test_glass_half_in_water();
    test_walls_that_cross_the_level();
    test_equal_indices_are_silent();
    test_where_light_starts();
    test_lamp_in_a_boundary();
    test_layers_go_on_at_periodic_sides();
    return check_done();
}
