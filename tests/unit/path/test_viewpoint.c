/* Sightlines: through regions that are meshes their transmittance is exact, and
 * they end at changes of the index, as in regions of other shapes.
 *
 * Deterministic: no false alarms. */
#include "path/viewpoint.h"

#include "check.h"
#include "closed_mesh.h"
#include "plain_rays.h"
#include "random_mesh.h"

#define SEED  17
#define PAIRS 4000

static const murk_domain cube = {.box = {{-1, -1, -1}, {1, 1, 1}}};
static const murk_domain tiled = {.box = {{-1, -1, -1}, {1, 1, 1}},
                                  .is_periodic = true};

typedef struct place {
    murk_media *media;
    murk_boundary_meshes *boundary_meshes;
    murk_path_space space;
} place;

/* One region of extinction 2 per m: a mesh, or (NULL) the box. */
static place place_of(murk_mesh *mesh, murk_box box, double ior,
                      const murk_domain *domain)
{
    const murk_medium fog = {.extinction_per_m = {{2}}, .albedo = {{0.5}}};
    murk_region region = {.shape = mesh ? MURK_REGION_MESH : MURK_REGION_BOX,
                          .box = box,
                          .to_world = murk_affine_identity(),
                          .ior = ior};
    const murk_boundary_mesh_desc boundary_mesh = {
        .mesh = mesh, .to_world = murk_affine_identity()};
    place p = {0};
    murk_error err = {0};
    if (mesh) {
        CHECK(murk_boundary_meshes_create(&p.boundary_meshes, &boundary_mesh, 1,
                                          &err) == MURK_OK);
        region.box =
            murk_boundary_meshes_describe(p.boundary_meshes, 0).bounds_m;
    }
    CHECK(murk_media_create(&p.media, &fog, 1, &region, 1, &domain->box,
                            &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    p.space = murk_path_space_of(NULL, p.media, p.boundary_meshes, domain);
    return p;
}

static void leave(place *p)
{
    murk_media_destroy(p->media);
    murk_boundary_meshes_destroy(p->boundary_meshes);
}

static murk_mesh *letter_u(void)
{
    const double at[8][2] = {{-0.8, -0.8}, {0.8, -0.8}, {0.8, 0.8},
                             {0.4, 0.8},   {0.4, 0},    {-0.4, 0},
                             {-0.4, 0.8},  {-0.8, 0.8}};
    const uint32_t cut[18] = {0, 1, 5, 1, 4, 5, 1, 2, 4,
                              2, 3, 4, 0, 5, 7, 5, 6, 7};
    return closed_prism(at, 8, cut, -0.5, 0.5);
}

/* Length of the path inside, from the twin's crossings. */
static double length_inside(const murk_mesh *m, murk_vec3 from, murk_vec3 to)
{
    const murk_vec3 offset = murk_sub(to, from);
    const double length = murk_length(offset);
    const murk_vec3 d = murk_scale(1 / length, offset);
    double sum = 0;
    for (size_t i = 0; i < m->triangles; ++i) {
        murk_vec3 v[3];
        for (size_t k = 0; k < 3; ++k) {
            const float *f = m->vertex_m + 3 * (size_t)m->corner[3 * i + k];
            v[k] = murk_vec((double)f[0], (double)f[1], (double)f[2]);
        }
        double edge;
        const double t = plain_triangle(v[0], v[1], v[2], from, d, &edge);
        if (t < INFINITY) {
            /* Outward winding: what is left adds, what is entered takes. */
            const murk_vec3 n =
                murk_cross(murk_sub(v[1], v[0]), murk_sub(v[2], v[0]));
            sum += (murk_dot(n, d) > 0 ? 1 : -1) * fmin(t, length);
        }
    }
    return sum;
}

static void test_transmittance_through_a_concave_mesh_is_exact(void)
{
    murk_mesh *u = letter_u();
    place p = place_of(u, (murk_box){0}, 0, &cube);
    double maximum = 0, teeth = 0;
    for (uint64_t i = 0; i < PAIRS; ++i) {
        const murk_vec3 sensor = random_point(SEED, i / 8);
        const murk_vec3 photon = random_point(SEED + 1, i);
        const murk_path_viewpoint viewpoint =
            murk_path_viewpoint_at(&p.space, sensor);
        const double got = murk_path_transmittance_to(&viewpoint, 0, photon);
        const double inside = length_inside(u, sensor, photon);
        maximum = fmax(maximum, fabs(got - exp(-2 * inside)));
        teeth = fmax(teeth, fabs(got - exp(-2.001 * inside)));
        CHECK(!murk_path_bends_to(&viewpoint, photon));
    }
    /* Two crossings at most 16 float steps of 0.8 apart may cancel. */
    CHECK(maximum < 2 * 2 * 16 * 0x1p-23);
    CHECK(teeth > 10 * 2 * 2 * 16 * 0x1p-23);
    leave(&p);
    murk_mesh_destroy(u);
}

/* The same box as a mesh: sightlines dim and end alike, in periodic domains
 * across the sides. */
static void test_a_box_is_the_same_as_its_mesh(void)
{
    const murk_box box = {{-0.5, -1, -0.25}, {0.75, 0.5, 0.5}};
    const murk_domain *domains[2] = {&cube, &tiled};
    murk_mesh *mesh = closed_box(box.min, box.max);
    size_t wrong = 0, bent = 0;
    double maximum = 0;
    for (int kind = 0; kind < 4; ++kind) {
        const murk_domain *domain = domains[kind / 2];
        const double ior = kind % 2 ? 1.33 : 0;
        place plain = place_of(NULL, box, ior, domain);
        place meshed = place_of(mesh, box, ior, domain);
        for (uint64_t i = 0; i < PAIRS; ++i) {
            const murk_vec3 sensor = random_point(SEED + 2, i / 8);
            const murk_vec3 photon = random_point(SEED + 3, i);
            const murk_path_viewpoint a =
                murk_path_viewpoint_at(&plain.space, sensor);
            const murk_path_viewpoint b =
                murk_path_viewpoint_at(&meshed.space, sensor);
            maximum =
                fmax(maximum, fabs(murk_path_transmittance_to(&a, 0, photon) -
                                   murk_path_transmittance_to(&b, 0, photon)));
            /* The box goes on beyond the side that its face lies in; in the
             * periodic domain the mesh ends there, and another begins. */
            if (domain == &cube) {
                const bool bends = murk_path_bends_to(&a, photon);
                wrong += bends != murk_path_bends_to(&b, photon);
                bent += bends;
            }
        }
        leave(&plain);
        leave(&meshed);
    }
    CHECK(wrong == 0);
    CHECK(bent > PAIRS / 4 && bent < PAIRS);
    CHECK(maximum < 2 * 2 * 16 * 0x1p-23);
    murk_mesh_destroy(mesh);
}

/* Water from side to side of a periodic domain has no edges, as a box and
 * as a mesh. */
static void test_a_slab_across_a_periodic_domain(void)
{
    /* The slab by both descriptions. */
    const murk_box slab = {{-1, -1, -0.5}, {1, 1, 0.5}};
    murk_mesh *mesh = closed_box(slab.min, slab.max);
    place plain = place_of(NULL, slab, 1.33, &tiled);
    place meshed = place_of(mesh, slab, 1.33, &tiled);
    size_t wrong = 0, bent = 0;
    double maximum = 0;
    for (uint64_t i = 0; i < PAIRS; ++i) {
        /* Each sensor sees eight photons. */
        const murk_vec3 sensor = random_point(SEED + 4, i / 8);
        const murk_vec3 photon = random_point(SEED + 5, i);
        const murk_path_viewpoint a =
            murk_path_viewpoint_at(&plain.space, sensor);
        const murk_path_viewpoint b =
            murk_path_viewpoint_at(&meshed.space, sensor);
        /* Both descriptions agree on refraction and on transmittance. */
        const bool bends = murk_path_bends_to(&a, photon);
        wrong += bends != murk_path_bends_to(&b, photon);
        bent += bends;
        maximum =
            fmax(maximum, fabs(murk_path_transmittance_to(&a, 0, photon) -
                               murk_path_transmittance_to(&b, 0, photon)));
    }
    /* Some paths bend and some do not; transmittances agree to single
     * precision. */
    CHECK(wrong == 0);
    CHECK(bent > PAIRS / 4 && bent < PAIRS);
    CHECK(maximum < 2 * 2 * 16 * 0x1p-23);
    leave(&plain);
    leave(&meshed);
    murk_mesh_destroy(mesh);
}

/* The floor of a tank lies in the water's face, and is seen all the same. */
static void test_the_floor_under_water_is_seen(void)
{
    murk_mesh *mesh =
        closed_box(murk_vec(-0.7, -0.7, -0.7), murk_vec(0.7, 0.7, 0.1));
    place p = place_of(mesh, (murk_box){0}, 1.33, &cube);
    const murk_vec3 wet = {0.3, 0.1, 0}, dry = {0.3, 0.1, 0.5};
    const murk_path_viewpoint from_wet = murk_path_viewpoint_at(&p.space, wet);
    const murk_path_viewpoint from_dry = murk_path_viewpoint_at(&p.space, dry);
    for (int i = -1; i <= 1; ++i) {
        const murk_vec3 floor = {-0.2, 0.3, -0.7 + i * 1e-7};
        CHECK(!murk_path_bends_to(&from_wet, floor));
        CHECK(murk_path_bends_to(&from_dry, floor));
    }
    leave(&p);
    murk_mesh_destroy(mesh);
}

/* ---- regions of other shapes ---- */

static bool bends(const murk_path_space *space, murk_vec3 from, murk_vec3 to)
{
    const murk_path_viewpoint viewpoint = murk_path_viewpoint_at(space, from);
    return murk_path_bends_to(&viewpoint, to);
}

/* Water below z = 0, with a ball of air and a ball of the water's own index. */
static void test_a_path_bends_at_changes_of_the_index_alone(void)
{
    const murk_domain domain = {.box = {{-10, -10, -10}, {10, 10, 10}}};
    const murk_medium clear = {.albedo = {{0.5}}};
    const murk_region regions[] = {
        {.shape = MURK_REGION_BELOW, .below_z_m = 0, .ior = 1.34},
        {.shape = MURK_REGION_SPHERE,
         .center = {0, 0, -5},
         .radius_m = 1,
         .to_world = murk_affine_identity(),
         .ior = 1},
        {.shape = MURK_REGION_SPHERE,
         .center = {9, 0, -5},
         .radius_m = 1,
         .to_world = murk_affine_identity(),
         .ior = 1.34}};
    for (size_t n = 0; n <= 3; n += 3) {
        murk_media *media = NULL;
        CHECK(murk_media_create(&media, &clear, 1, regions, n, &domain.box,
                                NULL) == MURK_OK);
        const murk_path_space space =
            murk_path_space_of(NULL, media, NULL, &domain);
        const murk_vec3 deep = {0, 0, -9}, high = {0, 0, 3}, flat = {4, 0, -1};
        CHECK(bends(&space, deep, high) == (n > 0));
        CHECK(bends(&space, high, flat) == (n > 0));
        CHECK(bends(&space, deep, murk_vec(0, 0, -1)) == (n > 0));
        CHECK(!bends(&space, deep, flat));
        CHECK(!bends(&space, high, murk_vec(3, 0, 0.01)));
        CHECK(!bends(&space, deep, deep));
        /* A boundary between equal indices bends nothing. */
        CHECK(!bends(&space, murk_vec(9, 0, -9), murk_vec(9, 0, -1)));
        murk_media_destroy(media);
    }
}

int main(void)
{
    test_a_path_bends_at_changes_of_the_index_alone();
    test_transmittance_through_a_concave_mesh_is_exact();
    test_a_box_is_the_same_as_its_mesh();
    test_a_slab_across_a_periodic_domain();
    test_the_floor_under_water_is_seen();
    return check_done();
}
