/* Glass: Fresnel's reflectances and Snell's law through a plate, total
 * reflection in a cube, a lamp inside a sphere, a sheet that does not bend.
 *
 * Source: Born and Wolf, Principles of Optics, 7th ed. (1999), 1.5.2 and 7.6:
 * a lossless plate whose faces reflect R each reflects 2 R / (1 + R) in all,
 * when the beams add without interference.
 *
 * The z-tests of a run share a 1e-6 chance of a false alarm (Sidak). */
#include "base/log.h"
#include "base/stats.h"
#include "check.h"
#include "worlds.h"

#include <stdlib.h>

#define PHOTONS 20000
#define Z_TESTS 12
#define INDEX   1.5

static double limit(void)
{
    return murk_sidak_limit(1e-6, Z_TESTS);
}

static void check_share(double count, double share)
{
    CHECK_WITHIN(limit(), count / PHOTONS, share,
                 sqrt(share * (1 - share) / PHOTONS));
}

typedef struct passage {
    double up, down;     /* escaped so */
    double snell_off;    /* worst |n sin - n' sin'| */
    double parallel_off; /* worst turn of what went through */
    murk_vec3 sent;
    double reflections; /* inside and out */
} passage;

static void note(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    passage *p = context;
    const murk_vec3 in = event->direction_in, out = event->direction_out;
    if (event->kind == MURK_EVENT_ESCAPED) {
        p->up += out.z > 0;
        p->down += out.z < 0;
        if (out.z * p->sent.z > 0) {
            p->parallel_off =
                fmax(p->parallel_off, murk_length(murk_sub(out, p->sent)));
        }
    } else if (event->kind == MURK_EVENT_SURFACE) {
        p->reflections += event->outcome == MURK_MIRRORED;
        if (event->outcome == MURK_TRANSMITTED) {
            const double a = murk_length(murk_cross(in, event->normal));
            const double b = murk_length(murk_cross(out, event->normal));
            p->snell_off = fmax(p->snell_off,
                                fmin(fabs(a - INDEX * b), fabs(INDEX * a - b)));
        }
    }
}

/* Closed forms, from the angle of incidence alone. */
static double fresnel(double degrees, double index)
{
    const double a = degrees * MURK_PI / 180, b = asin(sin(a) / index);
    if (degrees == 0) {
        return pow((index - 1) / (index + 1), 2);
    }
    return (pow(sin(a - b) / sin(a + b), 2) + pow(tan(a - b) / tan(a + b), 2)) /
           2;
}

static passage through_plate(double degrees, double index, uint32_t seed)
{
    const double a = degrees * MURK_PI / 180;
    const murk_source beam =
        test_beam(murk_vec(-3, 0.1, 2), murk_vec(sin(a), 0, -cos(a)));
    const murk_material glass = test_material(0, 0, 1, index);
    const murk_surface_desc plate =
        test_box(murk_vec(-500, -500, -1), murk_vec(500, 500, 0), 0);
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-400, -400, -3}, {400, 400, 3}}, false},
                      .lights = &beam,
                      .n_lights = 1,
                      .surfaces = &plate,
                      .n_surfaces = 1,
                      .materials = &glass,
                      .n_materials = 1});
    passage p = {.sent = murk_unit(beam.direction)};
    test_world_trace(&w, PHOTONS, seed, note, &p);
    CHECK(p.up + p.down == PHOTONS);
    test_world_unmade(&w);
    return p;
}

static void test_plate_reflects_and_bends(uint32_t seed)
{
    const double degrees[] = {0, 30, 56, 75};
    for (int i = 0; i < 4; ++i) {
        const passage p = through_plate(degrees[i], INDEX, seed + (uint32_t)i);
        const double r = fresnel(degrees[i], INDEX);
        check_share(p.up, 2 * r / (1 + r));
        /* Directions are rounded some ten times at most on most paths. */
        CHECK(p.snell_off < 1e-13);
        CHECK(p.parallel_off < 1e-12);
    }
    /* Teeth: glass of index 1.55. */
    const double r = fresnel(30, INDEX);
    const double want = 2 * r / (1 + r);
    CHECK(sigmas_off(through_plate(30, 1.55, seed).up / PHOTONS, want,
                     sqrt(want * (1 - want) / PHOTONS)) > limit());
}

/* In a lossless cube the absolute values of the components of a direction
 * never change. Light leaves if one of them is above cos(critical angle),
 * within six cones that do not overlap; all other light is trapped for
 * ever, and counted as lost. */
static void test_cube_traps_light(uint32_t seed)
{
    /* A point source within a glass cube, and photons with a limit of
     * events. */
    const murk_source lamp = test_point(murk_vec(0.1, 0.2, 0.3));
    const murk_material glass = test_material(0, 0.4, 0.6, INDEX);
    const murk_surface_desc cube =
        test_box(murk_vec(-1, -1, -1), murk_vec(1, 1, 1), 0);
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-2, -2, -2}, {2, 2, 2}}, false},
                      .lights = &lamp,
                      .n_lights = 1,
                      .surfaces = &cube,
                      .n_surfaces = 1,
                      .materials = &glass,
                      .n_materials = 1});
    murk_trace trace = murk_trace_defaults();
    trace.world = &w.world;
    trace.seed = seed;
    trace.last = PHOTONS;
    trace.events_max = 400;
    murk_trace_run(&trace, w.ledger);
    /* The lost share is the solid angle outside of the cones, and all of it
     * is lost by the limit of events. */
    const double trapped = 1 - 3 * (1 - sqrt(1 - 1 / (INDEX * INDEX)));
    const double lost = test_photons(&w, w.ledger->lost);
    check_share(lost, trapped);
    CHECK(lost ==
          (double)murk_tally_read(&w.ledger->lost_photons[MURK_LOSS_EVENTS]));
    CHECK(test_photons(&w, w.ledger->escaped) + lost == PHOTONS);
    CHECK(murk_ledger_imbalance(w.ledger) == 0);
    test_world_unmade(&w);
}

/* From the middle of a sphere light always meets it straight on: 4 % goes back,
 * through the middle, again and again. */
static void test_lamp_inside_a_sphere(uint32_t seed)
{
    const murk_source lamp = test_point(murk_vec(5, 5, 5));
    const murk_material glass = test_material(0, 0, 1, INDEX);
    const murk_surface_desc ball = test_sphere(murk_vec(5, 5, 5), 2, 0);
    test_world w = test_world_made(
        &(test_setup){.domain = {{{0, 0, 0}, {10, 10, 10}}, false},
                      .lights = &lamp,
                      .n_lights = 1,
                      .surfaces = &ball,
                      .n_surfaces = 1,
                      .materials = &glass,
                      .n_materials = 1});
    passage p = {.sent = {0, 0, 0}};
    test_world_trace(&w, PHOTONS, seed, note, &p);
    CHECK(p.up + p.down == PHOTONS);
    const double r = 0.04;
    CHECK_WITHIN(limit(), p.reflections / PHOTONS, r / (1 - r),
                 sqrt(r / ((1 - r) * (1 - r)) / PHOTONS));
    test_world_unmade(&w);
}

/* Open geometry splits light by its shares and never bends it, whatever its
 * index. */
static void test_sheet_does_not_bend(uint32_t seed)
{
    const murk_source beam = test_beam(murk_vec(0, 0, 2), murk_vec(1, 0.5, -1));
    const murk_material film = test_material(0, 0.3, 0.6, INDEX);
    const murk_surface_desc sheet = test_rect(
        murk_vec(-9, -9, 0), murk_vec(18, 0, 0), murk_vec(0, 18, 0), 0);
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-9, -9, -3}, {9, 9, 3}}, false},
                      .lights = &beam,
                      .n_lights = 1,
                      .surfaces = &sheet,
                      .n_surfaces = 1,
                      .materials = &film,
                      .n_materials = 1});
    passage p = {.sent = murk_unit(beam.direction)};
    test_world_trace(&w, PHOTONS, seed, note, &p);
    check_share(p.up, 0.3);
    check_share(p.down, 0.6);
    check_share(test_photons(&w, w.ledger->absorbed_surfaces), 0.1);
    CHECK(p.parallel_off == 0);
    test_world_unmade(&w);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_plate_reflects_and_bends(seed);
    test_cube_traps_light(seed);
    test_lamp_inside_a_sphere(seed);
    murk_warn_to(NULL); /* that an open sheet has an index */
    test_sheet_does_not_bend(seed);
    return check_done();
}
