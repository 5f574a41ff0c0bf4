/* A region does the same to light however it is described: as a half space cut
 * by the domain, a box, a grid, a closed mesh; as a sphere or a mesh of many
 * facets; in one piece or in two that share a face; with an index of refraction
 * or without; and wherever a thin sheet or a floor lies in its face.
 *
 * Shares of photons from two runs of different seeds are compared; the z-tests
 * share a 1e-6 chance of a false alarm (Sidak). The mesh of the sphere has
 * corners on it and lies up to 8e-5 of the radius within, which moves no share
 * by a tenth of its error. */
#include "base/stats.h"
#include "check.h"
#include "closed_mesh.h"
#include "worlds.h"

#define PHOTONS 60000
#define SHARES  3
#define Z_TESTS 66

/* What became of the photons. */
typedef struct ends {
    double share[SHARES]; /* absorbed in media, out at the top, elsewhere */
} ends;

static void count_end(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    ends *e = context;
    if (event->kind == MURK_EVENT_ESCAPED) {
        e->share[event->position.z > 0.999 ? 1 : 2] += 1.0 / PHOTONS;
    }
}

/* A world and the light that it gets. */
typedef struct layout {
    test_setup setup;
    murk_region region[3];
    murk_mesh *mesh[3];
    murk_medium medium[2]; /* fog, clear */
    murk_source light;
    murk_surface_desc surface[2];
    murk_material material[2];
} layout;

static ends traced(layout *l, uint32_t seed)
{
    l->setup.media = l->medium;
    l->setup.n_media = 2;
    l->setup.regions = l->region;
    l->setup.mesh = l->mesh;
    l->setup.lights = &l->light;
    l->setup.n_lights = 1;
    l->setup.surfaces = l->surface;
    l->setup.materials = l->material;
    l->setup.n_materials = l->setup.n_surfaces > 0 ? 2 : 0;
    test_world world = test_world_made(&l->setup);
    ends e = {0};
    test_world_trace(&world, PHOTONS, seed, count_end, &e);
    e.share[0] = test_photons(&world, world.ledger->absorbed_media) / PHOTONS;
    CHECK(test_photons(&world, world.ledger->lost) == 0);
    test_world_unmade(&world);
    for (int i = 0; i < 3; ++i) {
        if (l->mesh[i]) {
            murk_mesh_destroy(l->mesh[i]);
        }
    }
    return e;
}

static double limit(void)
{
    return murk_sidak_limit(1e-6, Z_TESTS);
}

static double sigma_of(double a, double b)
{
    return sqrt((a * (1 - a) + b * (1 - b)) / PHOTONS);
}

static void check_same(const ends *a, const ends *b)
{
    for (int i = 0; i < SHARES; ++i) {
        CHECK_WITHIN(limit(), a->share[i], b->share[i],
                     sigma_of(a->share[i], b->share[i]));
    }
}

static double max_off(const ends *a, const ends *b)
{
    double max = 0;
    for (int i = 0; i < SHARES; ++i) {
        max = fmax(max, sigmas_off(a->share[i], b->share[i],
                                   sigma_of(a->share[i], b->share[i])));
    }
    return max;
}

/* The domain is [-1, 1]^3; all regions start as boxes of fog. */
static layout empty_layout(void)
{
    layout l = {
        .setup = {.domain = {.box = {{-1, -1, -1}, {1, 1, 1}}}},
        .medium = {test_medium(2, 0.5, 0.3), test_medium(0, 1, 0)},
        .light = test_beam(murk_vec(-0.3, 0.1, 0.9),
                           murk_unit(murk_vec(0.4, 0.1, -1))),
        .material = {test_material(0.5, 0, 0, 0), test_material(0, 0, 1, 0)}};
    return l;
}

static murk_mesh *mesh_box(double low, double high, double top)
{
    return closed_box(murk_vec(low, low, low), murk_vec(high, high, top));
}

/* ---- the lower half of the domain, described in many ways ---- */

typedef enum form { BELOW, BOX, MESH, LARGE_MESH, TWO_MESHES, FORMS } form;

static layout lower_half(form how, double ior)
{
    /* Regions start as mesh regions without a mesh. */
    layout l = empty_layout();
    l.setup.n_regions = how == TWO_MESHES ? 2 : 1;
    l.region[0] = l.region[1] = test_mesh_region(0);
    /* Describe z < 0 by a half space, a box, a mesh as large as the domain,
     * a larger mesh, or two meshes side by side. */
    switch (how) {
    case BELOW:
        l.region[0].shape = MURK_REGION_BELOW;
        break;
    case BOX:
        l.region[0] =
            test_box_region(0, murk_vec(-1, -1, -1), murk_vec(1, 1, 0));
        break;
    case MESH:
        l.mesh[0] = mesh_box(-1, 1, 0);
        break;
    case LARGE_MESH:
        l.mesh[0] = mesh_box(-3, 3, 0);
        break;
    case TWO_MESHES:
        l.mesh[0] = closed_box(murk_vec(-1, -1, -1), murk_vec(0.1, 1, 0));
        l.mesh[1] = closed_box(murk_vec(0.1, -1, -1), murk_vec(1, 1, 0));
        break;
    case FORMS:
        break;
    }
    l.region[0].ior = l.region[1].ior = ior;
    return l;
}

static ends traced_half(form how, double ior, bool is_periodic, bool lamp_in,
                        uint32_t seed)
{
    layout l = lower_half(how, ior);
    l.setup.domain.is_periodic = is_periodic;
    if (lamp_in) {
        l.light = test_point(murk_vec(0.2, -0.3, -0.4));
    }
    return traced(&l, seed);
}

static void test_half_space_box_and_meshes(uint32_t seed)
{
    for (int kind = 0; kind < 8; ++kind) {
        const double ior = kind & 1 ? 1.33 : 0;
        const bool is_periodic = kind & 2, lamp_in = kind & 4;
        const ends truth = traced_half(BELOW, ior, is_periodic, lamp_in, seed);
        for (form how = BOX; how < FORMS; ++how) {
            /* Not every form in every kind: as many as keep this quick. */
            if ((kind + (int)how) % 2 == 0 || how == MESH) {
                const ends e = traced_half(how, ior, is_periodic, lamp_in,
                                           seed + 1 + (uint32_t)how);
                check_same(&e, &truth);
            }
        }
    }
}

static void test_a_grid_is_the_same_as_a_mesh(uint32_t seed)
{
    float one[64];
    for (int i = 0; i < 64; ++i) {
        one[i] = 1;
    }
    const size_t size[3] = {4, 4, 4};
    const murk_affine index_to_world = {
        {{0.25, 0, 0}, {0, 0.25, 0}, {0, 0, 0.25}}, {-0.375, -0.375, -0.375}};
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_from_samples(&grid, size, one, &index_to_world, "grid",
                                 &err) == MURK_OK);
    layout in_grid = empty_layout(), in_mesh = empty_layout();
    in_grid.setup.n_regions = in_mesh.setup.n_regions = 1;
    in_grid.medium[0].grid = grid;
    in_grid.region[0] = test_mesh_region(0);
    in_grid.region[0].shape = MURK_REGION_GRID;
    in_mesh.region[0] = test_mesh_region(0);
    in_mesh.mesh[0] = mesh_box(-0.5, 0.5, 0.5);
    const ends a = traced(&in_grid, seed), b = traced(&in_mesh, seed + 1);
    check_same(&a, &b);
    /* Of a grid, a box or a mesh leaves what lies inside. */
    const murk_vec3 low = {-0.2, -0.6, -0.3}, high = {0.7, 0.3, 0.4};
    in_mesh.medium[0].grid = grid;
    in_mesh.mesh[0] = closed_box(low, high);
    in_grid.region[0] = test_box_region(0, low, high);
    const ends c = traced(&in_grid, seed + 2), d = traced(&in_mesh, seed + 3);
    check_same(&c, &d);
    CHECK(max_off(&c, &a) > 2 * limit());
    murk_grid_destroy(grid);
}

/* ---- spheres ---- */

static ends traced_ball(bool is_mesh, double ior, double extinction_per_m,
                        uint32_t seed)
{
    layout l = empty_layout();
    l.setup.n_regions = 1;
    l.medium[0] = test_medium(extinction_per_m, 0.7, 0.3);
    l.region[0] = test_mesh_region(0);
    if (is_mesh) {
        l.mesh[0] = closed_star(murk_vec(0.1, 0, 0), 0.8, 0, 64, 1);
        closed_mesh_mix_winding(l.mesh[0], 5);
    } else {
        l.region[0].shape = MURK_REGION_SPHERE;
        l.region[0].center = murk_vec(0.1, 0, 0);
        l.region[0].radius_m = 0.8;
    }
    l.region[0].ior = ior;
    l.light = test_point(murk_vec(0.3, 0.2, 0.5));
    return traced(&l, seed);
}

static void test_a_ball_of_many_facets_is_a_sphere(uint32_t seed)
{
    for (int bends = 0; bends < 2; ++bends) {
        const double ior = bends ? 1.33 : 0;
        const ends ball = traced_ball(false, ior, 2, seed);
        const ends mesh = traced_ball(true, ior, 2, seed + 1);
        check_same(&mesh, &ball);
    }
}

/* Teeth: extinction off by a fifth or the index by a tenth must not get
 * through. */
static void test_would_notice_it(uint32_t seed)
{
    const ends ball = traced_ball(false, 1.33, 2, seed);
    const ends dense = traced_ball(true, 1.33, 2.4, seed + 1);
    const ends sharp = traced_ball(true, 1.46, 2, seed + 2);
    CHECK(max_off(&dense, &ball) > 2 * limit());
    CHECK(max_off(&sharp, &ball) > 2 * limit());
}

/* ---- one in another, and surfaces in the face ---- */

/* A bubble, or a glass block (index 1.6), in the water of the lower half. */
static ends traced_nested(bool outer_is_mesh, bool inner_is_mesh, double inner,
                          uint32_t seed)
{
    layout l = lower_half(outer_is_mesh ? MESH : BELOW, 1.33);
    const murk_vec3 low = {-0.5, -0.5, -0.8}, high = {0.5, 0.5, -0.3};
    l.setup.n_regions = 2;
    l.region[1] =
        inner_is_mesh ? test_mesh_region(1) : test_box_region(1, low, high);
    l.mesh[1] = inner_is_mesh ? closed_box(low, high) : NULL;
    l.region[1].ior = inner;
    return traced(&l, seed);
}

static void test_nested(uint32_t seed)
{
    for (int glass = 0; glass < 2; ++glass) {
        const double inner = glass ? 1.6 : 1;
        const ends truth = traced_nested(false, false, inner, seed);
        const ends both = traced_nested(true, true, inner, seed + 1);
        const ends one = traced_nested(false, true, inner, seed + 2);
        check_same(&both, &truth);
        check_same(&one, &truth);
    }
}

/* A clear sheet in the water's face changes nothing; a floor in the bottom's
 * face, of which the water is a box above, is a floor. */
static ends traced_with_surface(form how, bool sheet, bool floor, uint32_t seed)
{
    layout l = empty_layout();
    const murk_vec3 low = {-0.9, -0.9, -0.7}, high = {0.9, 0.9, 0};
    l.setup.n_regions = 1;
    l.region[0] =
        how == MESH ? test_mesh_region(0) : test_box_region(0, low, high);
    l.mesh[0] = how == MESH ? closed_box(low, high) : NULL;
    l.region[0].ior = 1.33;
    if (sheet) {
        l.surface[l.setup.n_surfaces++] =
            test_rect(murk_vec(-0.95, -0.95, 0), murk_vec(1.9, 0, 0),
                      murk_vec(0, 1.9, 0), 1);
    }
    if (floor) {
        l.surface[l.setup.n_surfaces++] =
            test_rect(murk_vec(-0.9, -0.9, -0.7), murk_vec(1.8, 0, 0),
                      murk_vec(0, 1.8, 0), 0);
    }
    return traced(&l, seed);
}

static void test_surfaces_in_the_face(uint32_t seed)
{
    const ends floor = traced_with_surface(BOX, false, true, seed);
    const ends mesh = traced_with_surface(MESH, false, true, seed + 1);
    const ends both = traced_with_surface(MESH, true, true, seed + 2);
    check_same(&mesh, &floor);
    check_same(&both, &floor);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_half_space_box_and_meshes(seed);
    test_a_grid_is_the_same_as_a_mesh(seed + 100);
    test_a_ball_of_many_facets_is_a_sphere(seed + 200);
    test_would_notice_it(seed + 300);
    test_nested(seed + 400);
    test_surfaces_in_the_face(seed + 500);
    return check_done();
}
