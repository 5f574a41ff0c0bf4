/* Paths across boundaries: which there are is held against the least optical
 * length over each face of a box by itself (Fermat's principle on a rectangle:
 * a least that lies on the rim is no path of light). Deterministic. */
#include "sensing/refract.h"

#include "base/rng.h"
#include "closed_mesh.h"
#include "world.h"

#define SEED        11
#define PAIRS       600
#define GLASS_INDEX 1.5
#define WATER       1.34

static const murk_domain cube = {.box = {{-4, -4, -4}, {4, 4, 4}}};
static const murk_box tank = {{-1, -1.5, -1}, {1, 1.5, 0.5}};

static murk_vec3 point_in(const murk_box *box, uint64_t i, uint32_t slot)
{
    const murk_random4 r = murk_random(SEED, MURK_SCATTER, i, 0, slot);
    const murk_vec3 size = murk_sub(box->max, box->min);
    return murk_vec(box->min.x + r.u[0] * size.x, box->min.y + r.u[1] * size.y,
                    box->min.z + r.u[2] * size.z);
}

static murk_region region_of(murk_region_shape shape, double ior)
{
    return (murk_region){.shape = shape,
                         .to_world = murk_affine_identity(),
                         .ior = ior,
                         .where = "region"};
}

/* Media of one clear filling, or one extinction for each region. */
static murk_media *media_of(const murk_region *region, size_t n,
                            const double *per_m, const murk_domain *domain)
{
    murk_medium medium[5];
    murk_region placed[5];
    for (size_t i = 0; i < n; ++i) {
        medium[i] = (murk_medium){.extinction_per_m = {{per_m ? per_m[i] : 0}},
                                  .albedo = {{0.5}},
                                  .where = "medium"};
        placed[i] = region[i];
        placed[i].medium = i;
    }
    murk_media *media = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&media, medium, n, placed, n, &domain->box, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    return media;
}

typedef struct answer {
    size_t n;
    bool is_reflected;
    murk_refracted_path path[MURK_REFRACTED_PATHS_MAX];
} answer;

static answer ask(const murk_media *media,
                  const murk_boundary_meshes *boundary_meshes,
                  const murk_domain *domain, murk_vec3 sensor, murk_vec3 photon)
{
    const murk_path_space space =
        murk_path_space_of(NULL, media, boundary_meshes, domain);
    murk_interfaces at;
    murk_interfaces_find(&at, &space);
    const murk_path_viewpoint p = murk_path_viewpoint_at(&space, sensor);
    const murk_path_viewpoint q = murk_path_viewpoint_at(&space, photon);
    answer a = {0};
    a.n = murk_refracted_paths_find(&at, &p, photon, q.index, a.path,
                                    &a.is_reflected);
    return a;
}

static double nearest_crossing(const answer *a, murk_vec3 point)
{
    double nearest = INFINITY;
    for (size_t k = 0; k < a->n; ++k) {
        nearest = fmin(nearest,
                       murk_length(murk_sub(a->path[k].snell.crossing, point)));
    }
    return nearest;
}

/* ---- boxes against Fermat, face by face ---- */

static double part(murk_vec3 v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static murk_vec3 on_face(const murk_box *box, int face, double u, double v)
{
    const int axis = face / 2;
    const double low[3] = {box->min.x, box->min.y, box->min.z};
    const double high[3] = {box->max.x, box->max.y, box->max.z};
    double p[3];
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    p[axis] = face % 2 ? high[axis] : low[axis];
    p[a] = low[a] + u * (high[a] - low[a]);
    p[b] = low[b] + v * (high[b] - low[b]);
    return murk_vec(p[0], p[1], p[2]);
}

/* The least optical length over a face, found by search; false if the
 * minimum lies on the rim. All points are in the frame of the box, without
 * rotation. */
static bool min_on_face(const murk_box *box, int face, murk_vec3 outside,
                        murk_vec3 inside, double n_inside, murk_vec3 *at)
{
    /* Search on the face by steps along both edges. */
    double best[2] = {0.5, 0.5}, minimum = INFINITY;
    for (double step = 0.25; step > 1e-12;) {
        bool moved = false;
        for (int k = -1; k < 4; ++k) {
            /* Take a step that shortens the optical length. */
            double to[2] = {best[0], best[1]};
            if (k >= 0) {
                to[k / 2] += k % 2 ? step : -step;
            }
            to[k > 1] = fmin(1, fmax(0, to[k > 1]));
            const murk_vec3 x = on_face(box, face, to[0], to[1]);
            const double length = murk_length(murk_sub(x, outside)) +
                                  n_inside * murk_length(murk_sub(inside, x));
            if (length < minimum) {
                minimum = length;
                best[0] = to[0];
                best[1] = to[1];
                moved = true;
            }
        }
        /* Halve the step if none does. */
        step = moved ? step : step / 2;
    }
    /* A minimum on the rim is not a path through the face. */
    *at = on_face(box, face, best[0], best[1]);
    return fmin(fmin(best[0], 1 - best[0]), fmin(best[1], 1 - best[1])) > 1e-6;
}

/* Whether the straight line meets the box beyond the critical angle. */
static bool meets_beyond_critical(const murk_box *box, murk_vec3 out,
                                  murk_vec3 in, double ratio)
{
    const murk_vec3 offset = murk_sub(in, out);
    double last = -1;
    int axis = 0;
    for (int k = 0; k < 3; ++k) {
        const double face =
            part(offset, k) > 0 ? part(box->min, k) : part(box->max, k);
        const double t = (face - part(out, k)) / part(offset, k);
        if (t > last) {
            last = t;
            axis = k;
        }
    }
    const double cosine = fabs(part(offset, axis)) / murk_length(offset);
    return ratio * sqrt(1 - cosine * cosine) >= 1;
}

/* A block of glass in air, or of air in glass. */
static void check_paths_into_a_box(double n_around, double n_inside)
{
    murk_region region[2] = {region_of(MURK_REGION_EVERYWHERE, n_around),
                             region_of(MURK_REGION_BOX, n_inside)};
    region[1].box = tank;
    region[1].to_world =
        murk_affine_place(murk_vec(20, 40, 60), 1, murk_vec(0.2, -0.3, 0.1));
    murk_affine to_local;
    CHECK(murk_affine_invert(&region[1].to_world, &to_local));
    murk_media *media = media_of(region, 2, NULL, &cube);
    size_t paths = 0, several = 0, none[2] = {0, 0};
    for (uint64_t i = 0; i < PAIRS; ++i) {
        const murk_vec3 in = point_in(&tank, i, 0);
        const murk_vec3 photon = murk_affine_point(&region[1].to_world, in);
        const murk_vec3 sensor = point_in(&cube.box, i, 1);
        const murk_vec3 out = murk_affine_point(&to_local, sensor);
        if (murk_box_contains(&tank, out)) {
            continue;
        }
        const answer a = ask(media, NULL, &cube, sensor, photon);
        const answer back = ask(media, NULL, &cube, photon, sensor);
        CHECK(a.n == back.n);
        size_t want = 0;
        for (int face = 0; face < 6; ++face) {
            const double beyond =
                face % 2 ? part(out, face / 2) - part(tank.max, face / 2)
                         : part(tank.min, face / 2) - part(out, face / 2);
            murk_vec3 x;
            if (!(beyond > 0) ||
                !min_on_face(&tank, face, out, in, n_inside / n_around, &x)) {
                continue;
            }
            ++want;
            /* A least is flat, so its place is known to the root of rounding.
             */
            const murk_vec3 at = murk_affine_point(&region[1].to_world, x);
            CHECK(nearest_crossing(&a, at) < 1e-6);
        }
        CHECK(a.n == want);
        const bool is_beyond =
            meets_beyond_critical(&tank, out, in, n_around / n_inside);
        CHECK(a.is_reflected == (a.n == 0 && is_beyond));
        CHECK(a.is_reflected == back.is_reflected);
        paths += a.n;
        several += a.n > 1;
        none[is_beyond] += a.n == 0;
    }
    CHECK(paths > PAIRS / 2);
    if (n_inside > n_around) {
        CHECK(several > 0); /* a corner of glass shows things twice */
    } else {
        CHECK(none[0] > 0 && none[1] > 0); /* an edge of air hides them */
    }
    murk_media_destroy(media);
}

static void test_paths_into_a_box_are_fermats(void)
{
    check_paths_into_a_box(1, GLASS_INDEX);
    check_paths_into_a_box(GLASS_INDEX, 1);
}

/* ---- no path ---- */

static void test_two_boundaries_and_spheres_give_no_path(void)
{
    murk_region two[2] = {region_of(MURK_REGION_BELOW, WATER),
                          region_of(MURK_REGION_BOX, GLASS_INDEX)};
    two[1].box = (murk_box){{-1, -1, -3}, {1, 1, -2}};
    murk_media *media = media_of(two, 2, NULL, &cube);
    const murk_vec3 above = {0.5, 0.2, 1}, water = {0.5, 0, -1};
    const murk_vec3 glass = {0.5, 0, -2.5};
    CHECK(ask(media, NULL, &cube, above, water).n == 1);
    CHECK(ask(media, NULL, &cube, water, glass).n == 1);
    const answer through = ask(media, NULL, &cube, above, glass);
    CHECK(through.n == 0 && !through.is_reflected);
    murk_media_destroy(media);

    murk_region ball = region_of(MURK_REGION_SPHERE, WATER);
    ball.radius_m = 1;
    media = media_of(&ball, 1, NULL, &cube);
    const murk_vec3 middle = {0, 0, 0}, off = {0, 0.5, 0};
    CHECK(ask(media, NULL, &cube, above, middle).n == 0);
    CHECK(ask(media, NULL, &cube, above, off).n == 0);
    murk_media_destroy(media);
}

/* A region hidden in water of the same index is no boundary, and stacked layers
 * have one between them. */
static void test_boundaries_that_do_not_bend_are_passed(void)
{
    murk_region stack[3] = {region_of(MURK_REGION_BOX, WATER),
                            region_of(MURK_REGION_BOX, GLASS_INDEX),
                            region_of(MURK_REGION_BOX, WATER)};
    stack[0].box = (murk_box){{-4, -4, -4}, {4, 4, 0}};
    stack[1].box = (murk_box){{-4, -4, 0}, {4, 4, 2}};
    stack[2].box = (murk_box){{-1, -1, -2}, {1, 1, -1}};
    murk_media *media = media_of(stack, 3, NULL, &cube);
    const murk_vec3 sensor = {0.5, 0.2, 1};
    const answer a = ask(media, NULL, &cube, sensor, murk_vec(0, 0, -1.5));
    const answer b = ask(media, NULL, &cube, sensor, murk_vec(0, 0, -3));
    CHECK(a.n == 1 && b.n == 1);
    CHECK_NEAR(a.path[0].snell.crossing.z, 0, 1e-15);
    CHECK_NEAR(b.path[0].snell.crossing.z, 0, 1e-15);
    murk_media_destroy(media);
}

/* ---- meshes, periodic domains ---- */

static void test_a_box_of_triangles_is_a_box(void)
{
    const double at[4][2] = {{-1, -1.5}, {1, -1.5}, {1, 1.5}, {-1, 1.5}};
    const uint32_t cut[6] = {0, 1, 2, 0, 2, 3};
    murk_mesh *mesh = closed_prism(at, 4, cut, -1, 0.5);
    const murk_boundary_mesh_desc boundary_mesh = {
        .mesh = mesh, .to_world = murk_affine_identity()};
    murk_boundary_meshes *boundary_meshes = NULL;
    murk_error err = {0};
    CHECK(murk_boundary_meshes_create(&boundary_meshes, &boundary_mesh, 1,
                                      &err) == MURK_OK);
    murk_region region[2] = {region_of(MURK_REGION_MESH, GLASS_INDEX),
                             region_of(MURK_REGION_BOX, GLASS_INDEX)};
    region[0].box = region[1].box = tank;
    murk_media *meshed = media_of(&region[0], 1, NULL, &cube);
    murk_media *boxed = media_of(&region[1], 1, NULL, &cube);
    size_t found = 0, of = 0;
    for (uint64_t i = 0; i < PAIRS; ++i) {
        const murk_vec3 photon = point_in(&tank, i, 0);
        const murk_vec3 sensor = point_in(&cube.box, i, 1);
        if (murk_box_contains(&tank, sensor)) {
            continue;
        }
        const answer want = ask(boxed, NULL, &cube, sensor, photon);
        const answer got = ask(meshed, boundary_meshes, &cube, sensor, photon);
        CHECK(got.n <= want.n);
        of += want.n > 0;
        found += got.n;
        for (size_t k = 0; k < got.n; ++k) {
            CHECK(nearest_crossing(&want, got.path[k].snell.crossing) < 1e-9);
        }
    }
    /* It misses only those that go by another face than the straight line. */
    CHECK(found > of * 9 / 10);
    murk_media_destroy(meshed);
    murk_media_destroy(boxed);
    murk_boundary_meshes_destroy(boundary_meshes);
    murk_mesh_destroy(mesh);
}

/* Paths in a periodic domain are those in an open domain that holds copies
 * of the block. */
static void test_periodic_paths_are_those_to_the_nearest_image(void)
{
    /* A periodic domain with a sea and a block of glass, and an open domain
     * of three by three periods. */
    const murk_domain tiled = {.box = {{0, 0, -2}, {4, 4, 2}},
                               .is_periodic = true};
    const murk_domain wide = {.box = {{-4, -4, -2}, {8, 8, 2}}};
    murk_region one[2] = {region_of(MURK_REGION_BELOW, WATER),
                          region_of(MURK_REGION_BOX, GLASS_INDEX)};
    one[1].box = (murk_box){{0.5, 0.5, 0.5}, {1.5, 3.5, 1}};
    one[0].below_z_m = -0.5;
    murk_media *small = media_of(one, 2, NULL, &tiled);
    const murk_path_space space = murk_path_space_of(NULL, small, NULL, &tiled);
    size_t across = 0;
    for (uint64_t i = 0; i < PAIRS; ++i) {
        /* Random pairs in media of different index. */
        const murk_vec3 sensor = point_in(&tiled.box, i, 0);
        const murk_vec3 photon = point_in(&tiled.box, i, 1);
        const murk_vec3 image = murk_path_nearest_image(&tiled, photon, sensor);
        const murk_vec3 shift = murk_sub(image, photon);
        const murk_path_viewpoint p = murk_path_viewpoint_at(&space, sensor);
        const murk_path_viewpoint q = murk_path_viewpoint_at(&space, photon);
        if (p.index == q.index) {
            continue;
        }
        /* In the open domain, copies of the block stand up to the nearest
         * image of the photon. */
        murk_region all[5] = {one[0], one[1], one[1], one[1], one[1]};
        size_t n = 2;
        for (int k = 1; k < 4; ++k) {
            const murk_vec3 by = {k & 1 ? shift.x : 0, k & 2 ? shift.y : 0, 0};
            if ((!(k & 1) || shift.x != 0) && (!(k & 2) || shift.y != 0)) {
                all[n].box.min = murk_add(one[1].box.min, by);
                all[n++].box.max = murk_add(one[1].box.max, by);
            }
        }
        /* Paths to the image in the open domain are those in the periodic
         * one. */
        murk_media *large = media_of(all, n, NULL, &wide);
        const answer got = ask(small, NULL, &tiled, sensor, photon);
        const answer want = ask(large, NULL, &wide, sensor, image);
        CHECK(got.n == want.n);
        CHECK(got.is_reflected == want.is_reflected);
        for (size_t k = 0; k < got.n; ++k) {
            CHECK(nearest_crossing(&want, got.path[k].snell.crossing) < 1e-12);
        }
        across += murk_length(shift) > 0 && got.n > 0;
        murk_media_destroy(large);
    }
    /* Enough paths crossed a side. */
    CHECK(across > PAIRS / 20);
    murk_media_destroy(small);
}

/* ---- along a path ---- */

static void test_media_attenuate_along_both_segments(void)
{
    /* Absorbing air over absorbing water. */
    const double per_m[2] = {0.7, 0.3};
    murk_region two[2] = {region_of(MURK_REGION_EVERYWHERE, 0),
                          region_of(MURK_REGION_BELOW, WATER)};
    murk_media *media = media_of(two, 2, per_m, &cube);
    const murk_path_space space = murk_path_space_of(NULL, media, NULL, &cube);
    for (uint64_t i = 0; i < 100; ++i) {
        /* A random sensor above the water, and a photon below. */
        murk_vec3 sensor = point_in(&cube.box, i, 0);
        murk_vec3 photon = point_in(&cube.box, i, 1);
        sensor.z = fabs(sensor.z);
        photon.z = -fabs(photon.z);
        const answer there = ask(media, NULL, &cube, sensor, photon);
        const answer back = ask(media, NULL, &cube, photon, sensor);
        CHECK(there.n == 1 && back.n == 1);
        const murk_path_viewpoint p = murk_path_viewpoint_at(&space, sensor);
        const murk_path_viewpoint q = murk_path_viewpoint_at(&space, photon);
        /* The transmittance is that of both segments, and the same on the way
         * back. */
        const double got =
            murk_refracted_path_transmittance(&there.path[0], &p, 0);
        const double *length_m = there.path[0].snell.length_m;
        const double want = exp(-0.7 * length_m[0] - 0.3 * length_m[1]);
        CHECK_NEAR(got, want, 1e-14);
        CHECK_NEAR(murk_refracted_path_transmittance(&back.path[0], &q, 0), got,
                   1e-14);
        /* Another extinction of the water would be noticed. */
        CHECK(fabs(exp(-0.7 * length_m[0] - 0.301 * length_m[1]) - got) >
              1e-14);
    }
    murk_media_destroy(media);
}

/* A wall on either segment blocks the path although the straight line is open,
 * and a wall on the straight line alone does not. Glass dims the path, and only
 * once if it lies in the boundary. */
static void test_surfaces_count_along_both_segments(void)
{
    /* A path from air into water that bends away from the straight line. */
    murk_region water = region_of(MURK_REGION_BELOW, WATER);
    murk_media *media = media_of(&water, 1, NULL, &cube);
    const murk_path_space space = murk_path_space_of(NULL, media, NULL, &cube);
    const murk_vec3 sensor = {-2, 0, 1}, photon = {2, 0, -1};
    const answer a = ask(media, NULL, &cube, sensor, photon);
    CHECK(a.n == 1);
    const murk_refracted_path *path = &a.path[0];
    const murk_vec3 x = path->snell.crossing;
    const murk_path_viewpoint p = murk_path_viewpoint_at(&space, sensor);
    /* Positions on both segments, on the crossing, and on the straight line. */
    const murk_vec3 at[4] = {murk_scale(0.5, murk_add(sensor, x)),
                             murk_scale(0.5, murk_add(photon, x)), x,
                             murk_scale(0.5, murk_add(sensor, photon))};
    CHECK(murk_length(murk_sub(x, at[3])) > 0.3);
    for (int k = 0; k < 4; ++k) {
        for (int material = WALL; material <= GLASS; ++material) {
            /* A small wall or pane at one position. */
            const murk_surface_desc rect =
                k == 2
                    ? a_rect(murk_vec(x.x - 0.1, -1, 0), murk_vec(0.2, 0, 0),
                             murk_vec(0, 2, 0), material)
                    : a_rect(murk_vec(at[k].x, -1, at[k].z - 0.1),
                             murk_vec(0, 2, 0), murk_vec(0, 0, 0.2), material);
            murk_surfaces *s = surfaces_of(&rect, 1);
            /* A wall on the bent path blocks, and a pane dims once. */
            const bool is_between = k < 3;
            CHECK(murk_refracted_path_blocked(path, &p, s, false) ==
                  is_between);
            CHECK(murk_refracted_path_blocked(path, &p, s, true) ==
                  (is_between && material == WALL));
            CHECK_NEAR(murk_refracted_path_sheets(path, &p, s, 0),
                       is_between && material == GLASS ? GLASS_TRANSMIT : 1,
                       1e-15);
            murk_surfaces_destroy(s);
        }
    }
    murk_media_destroy(media);
}

static void test_reach_is_that_of_the_faces(void)
{
    murk_region water = region_of(MURK_REGION_BELOW, 4. / 3);
    murk_media *media = media_of(&water, 1, NULL, &cube);
    const murk_path_space space = murk_path_space_of(NULL, media, NULL, &cube);
    murk_interfaces at;
    murk_interfaces_find(&at, &space);
    const double n[2] = {1, 4. / 3}, back[2] = {4. / 3, 1};
    const murk_path_viewpoint above =
        murk_path_viewpoint_at(&space, murk_vec(0, 0, 2));
    const murk_path_viewpoint below =
        murk_path_viewpoint_at(&space, murk_vec(0, 0, -1));
    CHECK_NEAR(murk_refracted_paths_range(&at, &above, 3),
               murk_snell_reach(3, 2, n), 1e-12);
    CHECK_NEAR(murk_refracted_paths_range(&at, &below, 3),
               murk_snell_reach(3, 1, back), 1e-12);
    CHECK(murk_refracted_paths_range(&at, &above, 3) >= 4);
    murk_media_destroy(media);
}

int main(void)
{
    test_paths_into_a_box_are_fermats();
    test_two_boundaries_and_spheres_give_no_path();
    test_boundaries_that_do_not_bend_are_passed();
    test_a_box_of_triangles_is_a_box();
    test_periodic_paths_are_those_to_the_nearest_image();
    test_media_attenuate_along_both_segments();
    test_surfaces_count_along_both_segments();
    test_reach_is_that_of_the_faces();
    return check_done();
}
