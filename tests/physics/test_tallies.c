/* What planes, grids and spheres measure is what theory says it is.
 *
 * Point lamp in clear air: power / (4 pi r^2), its mean over a ball by the
 * chords seen from the lamp, 2 pi / D (D r - a^2 ln((D + r) / a)) with a^2 =
 * D^2 - r^2, over a cell of a grid by quadrature.
 *
 * Closed diffuse sphere of reflectance rho, lamp at its centre: all of the wall
 * is lit alike after the first reflection and before, E = P / (A (1 - rho)), so
 * the reflected light has the radiance rho E / pi everywhere inside (Ulbricht,
 * 1900; Jacquez and Kuppenheim, J. Opt. Soc. Am. 45 (1955) 460): fluence rate
 * P / (4 pi r^2) + 4 rho E, and equal power in rings of equal mu^2 on any
 * plane.
 *
 * Fog: what a medium absorbs is the integral of its absorption coefficient
 * times fluence rate; the tally's mean over batches of photons against the
 * ledger's, two estimates with a common error.
 *
 * Each test also shows that a constant that is wrong by a few percent fails.
 * All z-tests share a 1e-6 false-alarm budget; seeds are fixed. */
#include "base/stats.h"
#include "check.h"
#include "worlds.h"

#define TALLIES_MAX 4
#define CHECKS      40

static double limit;

/* Estimates of all cells of a setup's tallies, one lamp, per watt of it. */
typedef struct measurement {
    test_world world;
    murk_tallies *tallies;
    double packet_w;
} measurement;

static measurement measured(const test_setup *setup,
                            const murk_tally_desc *descs, size_t n,
                            uint64_t photons, uint32_t seed,
                            double least_weight)
{
    measurement m = {.world = test_world_made(setup),
                     .packet_w = 1 / (double)photons};
    murk_error err = {0};
    CHECK(!murk_tallies_create(&m.tallies, descs, n, &setup->domain, 1, 1, 2,
                               INFINITY, &err));
    CHECK_TEXT(err.text, "");
    murk_trace trace = murk_trace_defaults();
    trace.world = &m.world.world;
    trace.seed = seed;
    trace.last = photons;
    trace.threads = 2;
    trace.tallies = m.tallies;
    trace.least_weight = least_weight;
    murk_trace_run(&trace, m.world.ledger);
    return m;
}

static murk_estimate cell_of(const measurement *m, size_t tally, size_t cell)
{
    return murk_tallies_read(m->tallies, tally, 0, cell,
                             m->world.ledger->emitted, &m->packet_w);
}

static void done(measurement *m)
{
    murk_tallies_destroy(m->tallies);
    test_world_unmade(&m->world);
}

static double sigmas(murk_estimate e, double want)
{
    return sigmas_off(e.value, want, e.standard_error);
}

static murk_tally_desc sphere_tally(murk_vec3 center, double radius_m)
{
    return (murk_tally_desc){.name = "sphere",
                             .type = MURK_TALLY_SPHERE,
                             .center = center,
                             .radius_m = radius_m};
}

/* ---- inverse square ---- */

/* Mean fluence rate in a ball of radius r at a distance of a 1 W lamp. */
static double in_ball(double distance, double r)
{
    const double a2 = distance * distance - r * r;
    const double chords = 2 * MURK_PI / distance *
                          (distance * r - a2 * log((distance + r) / sqrt(a2)));
    return chords / (4 * MURK_PI) / (4. / 3 * MURK_PI * r * r * r);
}

/* Mean over a box, by midpoints: far enough from the lamp, error ~ 1e-4. */
static double in_box(murk_box box, murk_vec3 lamp)
{
    const int n = 24;
    double sum = 0;
    for (int i = 0; i < n * n * n; ++i) {
        const murk_vec3 f = {(i % n + 0.5) / n, (i / n % n + 0.5) / n,
                             (i / n / n + 0.5) / n};
        const murk_vec3 e = murk_sub(box.max, box.min);
        const murk_vec3 to = murk_sub(
            murk_add(box.min, murk_vec(f.x * e.x, f.y * e.y, f.z * e.z)), lamp);
        sum += 1 / (4 * MURK_PI * murk_dot(to, to));
    }
    return sum / (n * n * n);
}

static void test_inverse_square(void)
{
    const murk_domain domain = {{{-4, -4, -4}, {4, 4, 4}}, false};
    const murk_vec3 lamp = {0.3, -0.2, 0.1};
    const murk_source light = test_point(lamp);
    murk_tally_desc d[TALLIES_MAX] = {
        sphere_tally(murk_add(lamp, murk_vec(0, 0.6, 0.8)), 0.7),
        sphere_tally(murk_add(lamp, murk_vec(2, -2, 1)), 0.7),
        sphere_tally(murk_add(lamp, murk_vec(-2.4, 0, -1.8)), 0.2),
        {.name = "grid",
         .type = MURK_TALLY_GRID,
         .box = {{1, 1, 1}, {4, 3, 2}},
         .size = {2, 2, 1}}};
    strcpy(d[1].name, "further");
    strcpy(d[2].name, "small");
    measurement m = measured(
        &(test_setup){.domain = domain, .lights = &light, .n_lights = 1}, d, 4,
        200000, 1, 1);
    const double distance[] = {1, 3, 3};
    for (size_t i = 0; i < 3; ++i) {
        const murk_estimate e = cell_of(&m, i, 0);
        const double want = in_ball(distance[i], d[i].radius_m);
        CHECK_WITHIN(limit, e.value, want, e.standard_error);
        CHECK(e.standard_error < 0.1 * want);
    }
    for (size_t c = 0; c < 4; ++c) {
        const murk_estimate e = cell_of(&m, 3, c);
        const murk_vec3 at = {1 + 1.5 * (double)(c % 2), 1 + (double)(c / 2),
                              1};
        const double want =
            in_box((murk_box){at, murk_add(at, murk_vec(1.5, 1, 1))}, lamp);
        CHECK_WITHIN(limit, e.value, want, e.standard_error);
    }
    /* teeth: the value at the middle alone is not the mean over the ball */
    CHECK(sigmas(cell_of(&m, 0, 0), 1 / (4 * MURK_PI)) > limit);
    done(&m);
}

/* ---- closed diffuse sphere ---- */

#define RING_BINS 5

static void test_closed_sphere(double least_weight)
{
    const double rho = 0.8, radius = 2, height = 0.5;
    const murk_domain domain = {{{-2.1, -2.1, -2.1}, {2.1, 2.1, 2.1}}, false};
    const murk_source light = test_point(murk_vec(0, 0, 0));
    const murk_material wall = test_material(rho, 0, 0, 0);
    const murk_surface_desc ball = test_sphere(murk_vec(0, 0, 0), radius, 0);
    const murk_tally_desc d[TALLIES_MAX] = {
        sphere_tally(murk_vec(0, 0, 0), radius),
        {.name = "off",
         .type = MURK_TALLY_SPHERE,
         .center = {0, 1.2, 0.5},
         .radius_m = 0.6,
         .hemispheres = true},
        {.name = "plane",
         .type = MURK_TALLY_PLANE,
         .point = {0, 0, height},
         .normal = {0, 0, 1},
         .bins = {1, 1},
         .angle_bins = RING_BINS},
        {.name = "grid",
         .type = MURK_TALLY_GRID,
         .box = {{0.5, 0.5, -1.1}, {1.1, 1.1, 1.1}},
         .size = {1, 1, 2}}};
    measurement m = measured(&(test_setup){.domain = domain,
                                           .lights = &light,
                                           .n_lights = 1,
                                           .surfaces = &ball,
                                           .n_surfaces = 1,
                                           .materials = &wall,
                                           .n_materials = 1},
                             d, 4, 60000, 2, least_weight);
    const double area = 4 * MURK_PI * radius * radius;
    const double lit = 1 / (area * (1 - rho)); /* W/m2 of the wall */
    const double reflected = 4 * rho * lit;

    /* all of it: every direct chord is a radius long */
    const double direct = radius / (4. / 3 * MURK_PI * pow(radius, 3));
    const murk_estimate all = cell_of(&m, 0, 0);
    CHECK_WITHIN(limit, all.value, direct + reflected, all.standard_error);
    CHECK(sigmas(all, direct + 1.04 * reflected) > limit);

    /* off the middle: upward light is half of the reflected and all direct
     * light that goes up, which is nearly all of it */
    const murk_estimate up = cell_of(&m, 1, 0), down = cell_of(&m, 1, 1);
    CHECK_WITHIN(limit, up.value + down.value, in_ball(1.3, 0.6) + reflected,
                 up.standard_error + down.standard_error);
    CHECK(down.value > reflected / 2 - 5 * down.standard_error);
    CHECK(up.value - down.value > 0.5 * in_ball(1.3, 0.6));

    /* a plane: reflected light by equal radiance; direct light forward only,
     * at cosines above height / radius */
    const double disc = MURK_PI * (radius * radius - height * height);
    for (size_t k = 0; k < RING_BINS; ++k) {
        const double low = (double)k / RING_BINS;
        const double high = (double)(k + 1) / RING_BINS;
        const double ring = rho * lit * disc * (high * high - low * low);
        const double from = fmax(low, height / radius);
        const double straight = high > from ? (high - from) / 2 : 0;
        const murk_estimate forward = cell_of(&m, 2, k);
        const murk_estimate backward = cell_of(&m, 2, RING_BINS + k);
        CHECK_WITHIN(limit, forward.value, ring + straight,
                     forward.standard_error);
        CHECK_WITHIN(limit, backward.value, ring, backward.standard_error);
        if (k == RING_BINS - 1) {
            CHECK(sigmas(backward, 1.1 * ring) > limit);
        }
    }
    for (size_t c = 0; c < 2; ++c) {
        const murk_vec3 at = {0.5, 0.5, c ? 0 : -1.1};
        const murk_estimate e = cell_of(&m, 3, c);
        const double want =
            reflected +
            in_box((murk_box){at, murk_add(at, murk_vec(0.6, 0.6, 1.1))},
                   murk_vec(0, 0, 0));
        CHECK_WITHIN(limit, e.value, want, e.standard_error);
    }
    done(&m);
}

/* ---- absorbed in fog ---- */

#define BATCHES 40

static void test_absorbed_is_fluence(double least_weight)
{
    /* A grid tally of one cell that is the whole domain, filled with fog. */
    const double extinction = 2, albedo = 0.9;
    const murk_domain domain = {{{0, 0, 0}, {2, 2, 2}}, false};
    const murk_source light = test_point(murk_vec(0.5, 1, 1.2));
    const murk_medium fog = test_medium(extinction, albedo, 0.6);
    const murk_region region = test_everywhere(0);
    const test_setup setup = {.domain = domain,
                              .lights = &light,
                              .n_lights = 1,
                              .media = &fog,
                              .n_media = 1,
                              .regions = &region,
                              .n_regions = 1};
    const murk_tally_desc d = {.name = "grid",
                               .type = MURK_TALLY_GRID,
                               .box = domain.box,
                               .size = {1, 1, 1}};
    /* The fluence rate times volume and absorption coefficient is the
     * absorbed power of the ledger, in each batch. */
    double off[BATCHES], slip[BATCHES];
    for (uint32_t i = 0; i < BATCHES; ++i) {
        measurement m = measured(&setup, &d, 1, 3000, 10 + i, least_weight);
        const double by_fluence =
            cell_of(&m, 0, 0).value * 8 * extinction * (1 - albedo);
        const double absorbed =
            (double)murk_tally_read(m.world.ledger->absorbed_media) /
            (double)MURK_PACKET * m.packet_w;
        off[i] = by_fluence - absorbed;
        slip[i] = 1.06 * by_fluence - absorbed;
        done(&m);
    }
    /* The mean deviation is zero; a fluence rate that is 6 % larger is
     * refused. */
    const murk_estimate mean = murk_mean_estimate(off, BATCHES);
    const murk_estimate wrong = murk_mean_estimate(slip, BATCHES);
    CHECK_WITHIN(limit, mean.value, 0, mean.standard_error);
    CHECK(sigmas(wrong, 0) > limit);
}

int main(void)
{
    limit = murk_sidak_limit(1e-6, CHECKS);
    test_inverse_square();
    test_closed_sphere(1);
    test_closed_sphere(0.01);
    test_absorbed_is_fluence(1);
    test_absorbed_is_fluence(0.01);
    return check_done();
}
