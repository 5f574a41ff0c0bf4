/* Light in clear air: what falls where, and how often it is reflected in a
 * closed room.
 *
 * Sources: of a point lamp's light a disc of half angle a takes (1 - cos a) / 2
 * (inverse square law), of a small lamp's that shines by cosine law sin^2 a
 * (Lambert, Photometria, 1760). In a closed room of diffuse reflectance d the
 * number of hits is geometric with mean 1 / (1 - d), whatever its shape.
 *
 * The z-tests of a run share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "worlds.h"

#include <stdlib.h>

#define PHOTONS 60000
#define Z_TESTS 12

static const murk_domain hall = {{{-8, -8, -8}, {8, 8, 8}}, false};

static double limit(void)
{
    return murk_sidak_limit(1e-6, Z_TESTS);
}

typedef struct hits {
    double n, above, in_disc[2], mean_z, mean_z2;
    double radius_m;
} hits;

static void note_hit(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    hits *h = context;
    if (event->kind == MURK_EVENT_SURFACE) {
        const murk_vec3 p = event->position;
        const double r = sqrt(p.x * p.x + p.y * p.y);
        h->n += 1;
        h->above += p.z > 1;
        h->in_disc[0] += r < 1;
        h->in_disc[1] += r < 3;
        h->mean_z += p.z / h->radius_m;
        h->mean_z2 += p.z * p.z / (h->radius_m * h->radius_m);
    }
}

static hits lit(const murk_source *lamp, const murk_surface_desc *surface,
                double radius_m, uint32_t seed)
{
    test_world w = test_world_made(&(test_setup){.domain = hall,
                                                 .lights = lamp,
                                                 .n_lights = 1,
                                                 .surfaces = surface,
                                                 .n_surfaces = 1});
    hits h = {.radius_m = radius_m};
    test_world_trace(&w, PHOTONS, seed, note_hit, &h);
    test_world_unmade(&w);
    return h;
}

static void check_share(double count, double share)
{
    CHECK_WITHIN(limit(), count / PHOTONS, share,
                 sqrt(share * (1 - share) / PHOTONS));
}

static murk_surface_desc floor_at(double z)
{
    return test_rect(murk_vec(-8, -8, z), murk_vec(16, 0, 0),
                     murk_vec(0, 16, 0), 0);
}

static void test_point_lamp_over_a_floor(uint32_t seed)
{
    const murk_source lamp = test_point(murk_vec(0, 0, 0));
    const double height[] = {2, 4};
    for (int i = 0; i < 2; ++i) {
        const double h = height[i];
        const murk_surface_desc floor = floor_at(-h);
        const hits got = lit(&lamp, &floor, 1, seed + (uint32_t)i);
        check_share(got.in_disc[0], (1 - h / sqrt(1 + h * h)) / 2);
        check_share(got.in_disc[1], (1 - h / sqrt(9 + h * h)) / 2);
        /* Teeth: the floor 15 % farther away. */
        const double far = 1.15 * h;
        const double share = (1 - far / sqrt(9 + far * far)) / 2;
        CHECK(sigmas_off(got.in_disc[1] / PHOTONS, share,
                         sqrt(share * (1 - share) / PHOTONS)) > limit());
    }
}

/* A lamp that lies on its own ceiling lights the room all the same. */
static void test_flat_lamp_over_a_floor(uint32_t seed)
{
    murk_source lamp = test_point(murk_vec(-1e-4, -1e-4, 2.7));
    lamp.type = MURK_SOURCE_RECT;
    lamp.edge1 = murk_vec(0, 2e-4, 0);
    lamp.edge2 = murk_vec(2e-4, 0, 0);
    const murk_surface_desc both[2] = {floor_at(0), floor_at(2.7)};
    test_world w = test_world_made(&(test_setup){.domain = hall,
                                                 .lights = &lamp,
                                                 .n_lights = 1,
                                                 .surfaces = both,
                                                 .n_surfaces = 2});
    hits h = {.radius_m = 1};
    test_world_trace(&w, PHOTONS, seed, note_hit, &h);
    check_share(h.in_disc[0], 1 / (1 + 2.7 * 2.7));
    check_share(h.in_disc[1], 9 / (9 + 2.7 * 2.7));
    CHECK(h.above == 0); /* none on the ceiling */
    test_world_unmade(&w);
}

static void test_point_lamp_in_a_sphere_is_even(uint32_t seed)
{
    const murk_source lamp = test_point(murk_vec(0, 0, 0));
    const murk_surface_desc ball = test_sphere(murk_vec(0, 0, 0), 5, 0);
    const hits h = lit(&lamp, &ball, 5, seed);
    CHECK(h.n == PHOTONS);
    CHECK_WITHIN(limit(), h.mean_z / PHOTONS, 0, sqrt(1. / 3 / PHOTONS));
    CHECK_WITHIN(limit(), h.mean_z2 / PHOTONS, 1. / 3,
                 sqrt((1. / 5 - 1. / 9) / PHOTONS));
}

static void count_hits(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    double *hits_of = context;
    if (event->kind == MURK_EVENT_SURFACE) {
        hits_of[0] += 1;
        hits_of[1] += murk_dot(event->normal, event->direction_in) < 0;
    }
}

/* The room is the domain's own box, and a smaller one; no light may leak. */
static void test_hits_in_a_closed_box(uint32_t seed)
{
    const double d = 0.8, mean = 1 / (1 - d);
    const double sigma = sqrt(d) / (1 - d) / sqrt(PHOTONS);
    const murk_material white = test_material(d, 0, 0, 0);
    const murk_source lamp = test_point(murk_vec(1, 2, 0.5));
    for (int i = 0; i < 2; ++i) {
        const double x = i == 0 ? 8 : 7.3;
        const murk_surface_desc walls =
            test_box(murk_vec(-x, -8, -x / 3), murk_vec(x, 8, x / 3), 0);
        murk_domain domain = hall;
        if (i == 0) {
            domain.box = walls.box;
        }
        test_world w = test_world_made(&(test_setup){.domain = domain,
                                                     .lights = &lamp,
                                                     .n_lights = 1,
                                                     .surfaces = &walls,
                                                     .n_surfaces = 1,
                                                     .materials = &white,
                                                     .n_materials = 1});
        double n[2] = {0};
        test_world_trace(&w, PHOTONS, seed + (uint32_t)i, count_hits, n);
        CHECK(test_photons(&w, w.ledger->absorbed_surfaces) == PHOTONS);
        CHECK(n[0] == n[1]); /* normals face the arriving light */
        CHECK_WITHIN(limit(), n[0] / PHOTONS, mean, sigma);
        /* Teeth: reflectance .78. */
        CHECK(sigmas_off(n[0] / PHOTONS, 1 / (1 - .78),
                         sqrt(.78) / (1 - .78) / sqrt(PHOTONS)) > limit());
        test_world_unmade(&w);
    }
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_point_lamp_over_a_floor(seed);
    test_flat_lamp_over_a_floor(seed);
    test_point_lamp_in_a_sphere_is_even(seed);
    test_hits_in_a_closed_box(seed);
    return check_done();
}
