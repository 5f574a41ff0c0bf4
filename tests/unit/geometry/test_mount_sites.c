/* Sites are spread over surfaces as evenly as geometry/mount_sites.h says: rows
 * and columns on walls along the axes, however these are cut into triangles;
 * elsewhere none nearer than 3/4 of the spacing and no place farther than 1.1
 * of it. And what stands near a mount is asked without the surface that it is
 * mounted on. Places whose answers are known exactly, and random ones that must
 * all hold; no false alarms. */
#include "check.h"
#include "closed_mesh.h"
#include "geometry/mount_sites.h"

#define SEED 11

static const murk_box EVERYWHERE = {{-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9}};

static murk_surfaces *create(const murk_surface_desc *desc, size_t n)
{
    const murk_material material[2] = {{.name = "default"}, {.name = "other"}};
    murk_surfaces *surfaces = NULL;
    murk_error err = {0};
    CHECK(murk_surfaces_create(&surfaces, desc, n, material, 2, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    return surfaces;
}

static murk_surface_desc box_of(murk_vec3 min, murk_vec3 max)
{
    return (murk_surface_desc){.shape = MURK_SHAPE_BOX,
                               .box = {min, max},
                               .to_world = murk_affine_identity()};
}

static murk_surface_desc sheet(murk_vec3 corner, murk_vec3 edge1,
                               murk_vec3 edge2)
{
    return (murk_surface_desc){.shape = MURK_SHAPE_RECT,
                               .corner = corner,
                               .edge1 = edge1,
                               .edge2 = edge2,
                               .to_world = murk_affine_identity()};
}

static murk_mount_search lay_of(double spacing_m)
{
    return (murk_mount_search){.spacing_m = spacing_m,
                               .within = EVERYWHERE,
                               .max_rise = 1,
                               .max = 1000000};
}

static murk_mount_site *sites_of(const murk_surfaces *s,
                                 const murk_mount_search *search, size_t *n)
{
    murk_mount_site *site = NULL;
    murk_error err = {0};
    *n = 0;
    CHECK(murk_surfaces_mount_sites(&site, n, s, search, "here", &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    return site;
}

static bool has(const murk_mount_site *site, size_t n, murk_vec3 p,
                double within)
{
    for (size_t i = 0; i < n; ++i) {
        if (murk_length(murk_sub(site[i].position, p)) <= within) {
            return true;
        }
    }
    return false;
}

/* Smallest distance between any two. */
static double min_gap(const murk_mount_site *site, size_t n)
{
    double minimum = INFINITY;
    for (size_t i = 0; i < n; ++i) {
        for (size_t k = 0; k < i; ++k) {
            minimum =
                fmin(minimum,
                     murk_length(murk_sub(site[i].position, site[k].position)));
        }
    }
    return minimum;
}

/* A room of 4 x 3 x 2.5 m: rows and columns half a metre apart, a quarter from
 * the edges, on six walls: 2 (8 x 6 + 8 x 5 + 6 x 5). */
static void check_walls(const murk_surfaces *s)
{
    const murk_mount_search search = lay_of(.5);
    size_t n;
    murk_mount_site *site = sites_of(s, &search, &n);
    CHECK(n == 236);
    for (size_t i = 0; i < n; ++i) {
        const double p[3] = {site[i].position.x, site[i].position.y,
                             site[i].position.z};
        const double size[3] = {4, 3, 2.5};
        const double normal[3] = {site[i].normal.x, site[i].normal.y,
                                  site[i].normal.z};
        int walls = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const bool is_wall = p[axis] == 0 || p[axis] == size[axis];
            walls += is_wall;
            CHECK(is_wall || fabs(fmod(p[axis], .5) - .25) < 1e-12);
            CHECK(fabs(normal[axis]) == (is_wall ? 1 : 0));
        }
        CHECK(walls == 1);
    }
    free(site);
}

static void test_walls_get_rows_and_columns(void)
{
    const murk_surface_desc capacity =
        box_of(murk_vec(0, 0, 0), murk_vec(4, 3, 2.5));
    murk_surfaces *s = create(&capacity, 1);
    check_walls(s);
    murk_surfaces_destroy(s);
}

/* One side of the room, as rows x rows x 2 triangles. */
static void add_wall(murk_mesh *m, murk_vec3 corner, murk_vec3 edge1,
                     murk_vec3 edge2, uint32_t rows)
{
    const uint32_t first = (uint32_t)m->vertices;
    for (uint32_t i = 0; i <= rows; ++i) {
        for (uint32_t k = 0; k <= rows; ++k) {
            closed_mesh_vertex(
                m, murk_along(murk_along(corner, (double)i / rows, edge1),
                              (double)k / rows, edge2));
        }
    }
    for (uint32_t i = 0; i < rows; ++i) {
        for (uint32_t k = 0; k < rows; ++k) {
            const uint32_t at = first + i * (rows + 1) + k;
            closed_mesh_triangle(m, at, at + 1, at + rows + 1);
            closed_mesh_triangle(m, at + 1, at + rows + 2, at + rows + 1);
        }
    }
}

static void test_how_walls_are_cut_changes_nothing(void)
{
    const uint32_t rows = 64;
    const murk_vec3 o = {0, 0, 0}, x = {4, 0, 0}, y = {0, 3, 0},
                    z = {0, 0, 2.5};
    murk_mesh *m = closed_mesh_empty(6 * 65 * 65, 12 * rows * rows);
    add_wall(m, o, x, y, rows);
    add_wall(m, z, x, y, rows);
    add_wall(m, o, x, z, rows);
    add_wall(m, y, x, z, rows);
    add_wall(m, o, y, z, rows);
    add_wall(m, x, y, z, rows);
    const murk_surface_desc desc = {.shape = MURK_SHAPE_MESH,
                                    .mesh = m,
                                    .to_world = murk_affine_identity()};
    murk_surfaces *s = create(&desc, 1);
    check_walls(s);
    murk_surfaces_destroy(s);
    murk_mesh_destroy(m);
}

/* Packing and covering of one smooth surface, and so its number of sites: each
 * stands for no more than a disc of 1.1 spacings, and discs of half of 3/4 do
 * not overlap (at most .9069 of the area). */
static void check_even(const murk_surfaces *s, double spacing_m, double area_m2,
                       const murk_vec3 *place, size_t places)
{
    const murk_mount_search search = lay_of(spacing_m);
    size_t n;
    murk_mount_site *site = sites_of(s, &search, &n);
    CHECK(min_gap(site, n) >= .75 * spacing_m);
    for (size_t i = 0; i < places; ++i) {
        CHECK(has(site, n, place[i], 1.1 * spacing_m));
    }
    const double squares = area_m2 / (spacing_m * spacing_m);
    CHECK((double)n >= squares / 3.8);
    CHECK((double)n <= .9069 * squares / (MURK_PI * .375 * .375) * 1.05);
    free(site);
}

static void test_sites_on_slanting_sheets_are_even(void)
{
    static const murk_vec3 edge[3][2] = {{{8, 0, 6}, {0, 10, 0}},
                                         {{7, 0, 7}, {0, 10, 0}},
                                         {{6, -6, 0}, {4, 4, -8}}};
    for (int k = 0; k < 3; ++k) {
        const murk_surface_desc desc =
            sheet(murk_vec(1, 2, 3), edge[k][0], edge[k][1]);
        murk_surfaces *s = create(&desc, 1);
        murk_vec3 place[300];
        for (size_t i = 0; i < 300; ++i) {
            const murk_random4 r = murk_random(SEED, MURK_TEST, i, 0, 0);
            place[i] = murk_along(murk_along(desc.corner, r.u[0], edge[k][0]),
                                  r.u[1], edge[k][1]);
        }
        check_even(s, .6, murk_length(murk_cross(edge[k][0], edge[k][1])),
                   place, 300);
        murk_surfaces_destroy(s);
    }
}

/* A ball of radius 2 m, once as a sphere and once as thousands of triangles
 * much smaller than the spacing. */
static void test_sites_on_round_surfaces_are_even(void)
{
    murk_mesh *m = closed_star(murk_vec(1, 1, 1), 2, 0, 24, SEED);
    const murk_surface_desc desc[2] = {{.shape = MURK_SHAPE_MESH,
                                        .mesh = m,
                                        .to_world = murk_affine_identity()},
                                       {.shape = MURK_SHAPE_SPHERE,
                                        .center = {1, 1, 1},
                                        .radius_m = 2,
                                        .to_world = murk_affine_identity()}};
    murk_vec3 place[300];
    for (size_t i = 0; i < 300; ++i) {
        const murk_random4 r = murk_random(SEED, MURK_TEST, i, 1, 0);
        place[i] = murk_along(
            murk_vec(1, 1, 1), 2,
            murk_about(murk_vec(0, 0, 1), 2 * r.u[0] - 1, 6.28 * r.u[1]));
    }
    for (int k = 0; k < 2; ++k) {
        murk_surfaces *s = create(&desc[k], 1);
        check_even(s, .5, 16 * MURK_PI, place, 300);
        murk_surfaces_destroy(s);
    }
    murk_mesh_destroy(m);
}

/* Two faces 5 cm apart, and shelves 20 cm apart, each get sites of their
 * own although the spacing is 1 m; a beam of 10 cm gets sites along its
 * length. */
static void test_neighbours_and_small_parts_get_sites(void)
{
    /* Four sheets of 4 m. */
    const murk_vec3 x = {4, 0, 0}, z = {0, 0, 4}, y = {0, 4, 0};
    const murk_surface_desc desc[4] = {
        sheet(murk_vec(0, 0, 0), x, z), sheet(murk_vec(0, .05, 0), x, z),
        sheet(murk_vec(0, 1, 9), x, y), sheet(murk_vec(0, 1, 9.2), x, y)};
    murk_surfaces *s = create(desc, 4);
    const murk_mount_search search = lay_of(1);
    size_t n;
    murk_mount_site *site = sites_of(s, &search, &n);
    /* Count the sites of each sheet: about one per square metre. */
    size_t on[4] = {0};
    for (size_t i = 0; i < n; ++i) {
        on[0] += site[i].position.y == 0;
        on[1] += fabs(site[i].position.y - .05) < 1e-7;
        on[2] += site[i].position.z == 9;
        on[3] += fabs(site[i].position.z - 9.2) < 1e-6;
    }
    for (int k = 0; k < 4; ++k) {
        CHECK(on[k] >= 16 && on[k] <= 25);
    }
    CHECK(on[0] + on[1] + on[2] + on[3] == n);
    free(site);
    murk_surfaces_destroy(s);

    /* Count the sites on the lower side of the beam: about one per metre. */
    const murk_surface_desc beam =
        box_of(murk_vec(.31, .31, 3), murk_vec(8, .41, 3.1));
    s = create(&beam, 1);
    site = sites_of(s, &search, &n);
    size_t under = 0;
    for (size_t i = 0; i < n; ++i) {
        under += site[i].position.z == 3;
    }
    CHECK(under >= 6 && under <= 11);
    free(site);
    murk_surfaces_destroy(s);
}

static void test_what_is_not_wanted_gets_none(void)
{
    murk_surface_desc desc[2] = {
        box_of(murk_vec(0, 0, 0), murk_vec(4, 3, 2.5)),
        sheet(murk_vec(1, 1, 1), murk_vec(1, 0, 0), murk_vec(0, 1, 0))};
    desc[1].material = 1;
    murk_surfaces *s = create(desc, 2);
    const bool other[2] = {false, true};
    murk_mount_search search = lay_of(.5);
    size_t n;
    search.materials = other;
    free(sites_of(s, &search, &n));
    CHECK(n == 4);
    search = lay_of(.5);
    search.min_rise = .8; /* floor, ceiling and sheet */
    free(sites_of(s, &search, &n));
    CHECK(n == 2 * 48 + 4);
    search = lay_of(.5);
    search.max_rise = .6; /* walls, from 2 m on: one row */
    search.within.min.z = 2;
    free(sites_of(s, &search, &n));
    CHECK(n == 2 * (8 + 6));
    search.within.min.z = search.within.max.z = 1.5; /* a height */
    murk_mount_site *site = sites_of(s, &search, &n);
    CHECK(n == 2 * (8 + 6));
    for (size_t i = 0; i < n; ++i) {
        CHECK(site[i].position.z == 1.5);
    }
    free(site);
    search = lay_of(.5);
    search.within.min.z = 7;
    site = sites_of(s, &search, &n);
    CHECK(n == 0 && site == NULL);
    murk_surfaces_destroy(s);
}

/* Of ground of ten thousand square kilometres, a hundred square metres are
 * searched; too many sites are refused. */
static void test_great_surfaces_are_cut_off(void)
{
    /* A plane and a very large sphere. */
    const murk_surface_desc desc[2] = {sheet(murk_vec(-5e4, -5e4, 0),
                                             murk_vec(1e5, 0, 0),
                                             murk_vec(0, 1e5, 0)),
                                       {.shape = MURK_SHAPE_SPHERE,
                                        .center = {0, 0, -9e4},
                                        .radius_m = 9e4 + 20,
                                        .to_world = murk_affine_identity()}};
    murk_surfaces *s = create(desc, 2);
    /* Search a small box on each. */
    murk_mount_search search = lay_of(2);
    search.within = (murk_box){{-5, -5, -1}, {5, 5, 1}};
    size_t n;
    free(sites_of(s, &search, &n));
    CHECK(n == 25);
    search.within = (murk_box){{-5, -5, 19}, {5, 5, 21}};
    free(sites_of(s, &search, &n));
    CHECK(n >= 9 && n <= 49);
    /* Refuse all of the ground, and a maximum that is one site too low. */
    murk_mount_site *site = NULL;
    murk_error err = {0};
    search.within = EVERYWHERE;
    CHECK(murk_surfaces_mount_sites(&site, &n, s, &search, "here", &err) ==
          MURK_BAD_VALUE);
    CHECK(site == NULL);
    CHECK_TEXT(err.where, "here");
    CHECK_MENTIONS(err.text, "spacing_m is 2 m");
    search.within = (murk_box){{-5, -5, -1}, {5, 5, 1}};
    search.max = 24;
    CHECK(murk_surfaces_mount_sites(&site, &n, s, &search, "here", &err) ==
          MURK_BAD_VALUE);
    murk_surfaces_destroy(s);
}

/* Floors in one place share sites. Each floor is 10 m x 10 m of a larger
 * triangle, or 25 squares of the spacing, and gets 25 sites; 25 sites may
 * represent at most 7.4 times as many squares, which is enough for 7 floors
 * and not for 8. */
static void test_area_beyond_all_sites_is_refused(void)
{
    /* One triangle as eight floors in one place. */
    enum { FLOORS = 8 };
    murk_mesh *m = closed_mesh_empty(3, 1);
    closed_mesh_vertex(m, murk_vec(-50, -50, 0));
    closed_mesh_vertex(m, murk_vec(150, -50, 0));
    closed_mesh_vertex(m, murk_vec(-50, 150, 0));
    closed_mesh_triangle(m, 0, 1, 2);
    murk_surface_desc desc[FLOORS];
    for (int i = 0; i < FLOORS; ++i) {
        desc[i] = (murk_surface_desc){.shape = MURK_SHAPE_MESH,
                                      .mesh = m,
                                      .to_world = murk_affine_identity()};
    }
    /* Seven floors get the sites of one; eight are refused. */
    for (size_t floors = FLOORS - 1; floors <= FLOORS; ++floors) {
        murk_surfaces *s = create(desc, floors);
        murk_mount_search search = lay_of(2);
        search.within = (murk_box){{-5, -5, -1}, {5, 5, 1}};
        search.max = 25;
        murk_mount_site *site = NULL;
        size_t n = 0;
        CHECK(murk_surfaces_mount_sites(&site, &n, s, &search, "here", NULL) ==
              (floors == FLOORS ? MURK_BAD_VALUE : MURK_OK));
        CHECK(n == (floors == FLOORS ? 0 : 25));
        free(site);
        murk_surfaces_destroy(s);
    }
    murk_mesh_destroy(m);
}

/* Of a stack of small sheets within one spacing, each gets a site until one
 * would have to be compared with more than 4096 others. */
static void test_stacks_are_cut_off(void)
{
    enum { SHEETS = 4200, MAX = 4097 };
    murk_mesh *m = closed_mesh_empty(3 * SHEETS, SHEETS);
    for (uint32_t i = 0; i < SHEETS; ++i) {
        const double z = 1e-4 * i;
        const uint32_t first = closed_mesh_vertex(m, murk_vec(0, 0, z));
        closed_mesh_vertex(m, murk_vec(0.02, 0, z));
        closed_mesh_vertex(m, murk_vec(0, 0.02, z));
        closed_mesh_triangle(m, first, first + 1, first + 2);
    }
    const murk_surface_desc desc = {.shape = MURK_SHAPE_MESH,
                                    .mesh = m,
                                    .to_world = murk_affine_identity()};
    murk_surfaces *s = create(&desc, 1);
    const murk_mount_search search = lay_of(1);
    size_t n;
    free(sites_of(s, &search, &n));
    CHECK(n == MAX);
    murk_surfaces_destroy(s);
    murk_mesh_destroy(m);
}

/* ---- near a mount ---- */

static bool is_near(const murk_surfaces *s, murk_vec3 at, murk_vec3 normal,
                    double radius_m)
{
    const murk_mount_site site = {at, normal};
    return murk_surfaces_near_mount(s, murk_along(at, .05, normal), radius_m,
                                    &site, .025);
}

static void test_own_wall_does_not_count(void)
{
    const murk_surface_desc desc[3] = {
        box_of(murk_vec(0, 0, 0), murk_vec(4, 3, 2.5)),
        box_of(murk_vec(3, 1, 0), murk_vec(3.5, 2, .02)), /* a sill */
        sheet(murk_vec(.3, .7, .7), murk_vec(0, .6, 0), murk_vec(0, 0, .6))};
    murk_surfaces *s = create(desc, 3);
    const murk_vec3 up = {0, 0, 1};
    CHECK(!is_near(s, murk_vec(2, 1.5, 0), up, 1));
    CHECK(is_near(s, murk_vec(.2, 1.5, 0), up, .2 + 1e-5));
    CHECK(!is_near(s, murk_vec(.2, 1.5, 0), up, .2 - 1e-5));
    CHECK(!is_near(s, murk_vec(3.25, .9, 0), up, .5));
    /* before the wall x = 0 stands a sheet at .3 */
    CHECK(is_near(s, murk_vec(0, 1, 1), murk_vec(1, 0, 0), .25 + 1e-5));
    CHECK(!is_near(s, murk_vec(0, 1, 1), murk_vec(1, 0, 0), .25 - 1e-5));
    CHECK(murk_surfaces_near(s, murk_vec(2, 1.5, .05), .05 + 1e-5));
    murk_surfaces_destroy(s);
}

/* A tunnel of 24 sides: on its inside only what is not the tunnel counts, on
 * the outside nothing; a ramp of 60 degrees counts. */
static void test_own_curved_wall_does_not_count(void)
{
    enum { SIDES = 24 };
    murk_mesh *m = closed_mesh_empty(2 * SIDES, 2 * SIDES);
    for (uint32_t i = 0; i < 2 * SIDES; ++i) {
        const double turn = 2 * MURK_PI * (i % SIDES) / SIDES;
        closed_mesh_vertex(m,
                           murk_vec(cos(turn), i < SIDES ? -9 : 9, sin(turn)));
    }
    for (uint32_t i = 0; i < SIDES; ++i) {
        const uint32_t next = (i + 1) % SIDES;
        closed_mesh_triangle(m, i, next, SIDES + i);
        closed_mesh_triangle(m, next, SIDES + next, SIDES + i);
    }
    const murk_surface_desc desc[2] = {{.shape = MURK_SHAPE_MESH,
                                        .mesh = m,
                                        .to_world = murk_affine_identity()},
                                       sheet(murk_vec(-2, 4, -.8),
                                             murk_vec(4, 0, 0),
                                             murk_vec(0, 1, sqrt(3)))};
    murk_surfaces *s = create(desc, 2);
    const double low = -cos(MURK_PI / SIDES); /* of the facet below */
    for (int i = -4; i <= 4; ++i) {
        const double turn = 2 * MURK_PI * (.5 + i) / SIDES;
        const murk_vec3 out = {sin(turn), 0, -cos(turn)};
        const murk_vec3 site = murk_scale(-low, out);
        CHECK(!is_near(s, site, murk_scale(-1, out), .6));
        CHECK(!is_near(s, site, out, .6));
    }
    const double turn = MURK_PI / SIDES;
    const murk_vec3 out = {sin(turn), 0, -cos(turn)};
    const murk_vec3 site = murk_add(murk_scale(-low, out), murk_vec(0, 3.6, 0));
    CHECK(is_near(s, site, murk_scale(-1, out), .6));
    murk_surfaces_destroy(s);
    murk_mesh_destroy(m);
}

static void test_own_sphere_does_not_count(void)
{
    const murk_surface_desc desc[2] = {{.shape = MURK_SHAPE_SPHERE,
                                        .center = {0, 0, 0},
                                        .radius_m = 2,
                                        .to_world = murk_affine_identity()},
                                       {.shape = MURK_SHAPE_SPHERE,
                                        .center = {0, 1, -1},
                                        .radius_m = .5,
                                        .to_world = murk_affine_identity()}};
    murk_surfaces *s = create(desc, 2);
    const murk_vec3 site = {0, 0, -2}, up = {0, 0, 1}, down = {0, 0, -1};
    CHECK(!is_near(s, site, down, 9));
    /* from (0, 0, -1.95) to the other's center less its radius */
    const double gap = hypot(1, .95) - .5;
    CHECK(!is_near(s, site, up, gap - 1e-5));
    CHECK(is_near(s, site, up, gap + 1e-5));
    /* on the small one, to its side: of the great one what is beyond counts */
    CHECK(is_near(s, murk_vec(0, 1.5, -1), murk_vec(0, 1, 0), .5));
    murk_surfaces_destroy(s);
}

int main(void)
{
    test_walls_get_rows_and_columns();
    test_how_walls_are_cut_changes_nothing();
    test_sites_on_slanting_sheets_are_even();
    test_sites_on_round_surfaces_are_even();
    test_neighbours_and_small_parts_get_sites();
    test_what_is_not_wanted_gets_none();
    test_great_surfaces_are_cut_off();
    test_area_beyond_all_sites_is_refused();
    test_stacks_are_cut_off();
    test_own_wall_does_not_count();
    test_own_curved_wall_does_not_count();
    test_own_sphere_does_not_count();
    return check_done();
}
