/* What a mount stands near to, face by face and sphere by sphere, against
 * points drawn on them. Nothing here is random. */
#include "geometry/mount_clearance.h"

#include "check.h"

#define FINE 200 /* points along each side */

static murk_mount_clearance upright(double above_m, double slack_m)
{
    return (murk_mount_clearance){.site = {0, 0, 0},
                                  .normal = {0, 0, 1},
                                  .above_m = above_m,
                                  .slack_m = slack_m};
}

/* A face that rises with `slope` from its low edge, which is at height `rise`
 * and 1 m off along x or y, either way round. */
static murk_triangle rising(double slope, double rise, bool along_y,
                            bool turned)
{
    murk_vec3 a = {1, -3, rise}, b = {1, 3, rise}, c = {3, 0, rise + 2 * slope};
    if (along_y) {
        a = murk_vec(-3, 1, rise);
        b = murk_vec(3, 1, rise);
        c = murk_vec(0, 3, rise + 2 * slope);
    }
    return turned ? (murk_triangle){b, a, c} : (murk_triangle){a, b, c};
}

/* A surface that bends as far as its slope says goes on; one that bends more,
 * or stands at more than 45 degrees, is another. */
static void test_smooth_surfaces_go_on(void)
{
    static const struct {
        double slope, rise, slack_m;
        bool counts;
    } table[] = {
        {0.5, 0.49, 0, false}, {0.5, 0.51, 0, true},   {0.5, 0.59, .1, false},
        {0.5, 0.61, .1, true}, {0.2, 0.199, 0, false}, {0.2, 0.201, 0, true},
        {0, 0.099, .1, false}, {0, 0.101, .1, true},   {0.99, 0.1, 0, false},
        {1.01, 0.1, 0, true},  {30, 0.1, 0, true},
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; ++i) {
        const murk_mount_clearance m = upright(0, table[i].slack_m);
        for (int turn = 0; turn < 4; ++turn) {
            const murk_triangle t =
                rising(table[i].slope, table[i].rise, turn & 1, turn & 2);
            const double got =
                murk_mount_clearance_to_face(&m, &t, murk_vec(0, 0, 0));
            const double edge = hypot(1, table[i].rise);
            CHECK(table[i].counts ? fabs(got - edge) < 1e-12 : isinf(got));
        }
    }
}

static double min_of_face(const murk_mount_clearance *m, const murk_triangle *t,
                          murk_vec3 point)
{
    double min = INFINITY;
    for (int i = 0; i <= FINE; ++i) {
        for (int j = 0; i + j <= FINE; ++j) {
            murk_vec3 p =
                murk_along(t->a, (double)i / FINE, murk_sub(t->b, t->a));
            p = murk_along(p, (double)j / FINE, murk_sub(t->c, t->a));
            if (p.z >= m->above_m) {
                min = fmin(min, murk_length(murk_sub(p, point)));
            }
        }
    }
    return min;
}

/* Of a steep face what is above the floor counts. */
static void test_faces_by_points_on_them(void)
{
    const murk_triangle t = {{2, -1, -1}, {2, 2, -0.5}, {2.25, 0, 3}};
    const double above_m[] = {-2, -0.75, 0, 0.5, 2.5};
    const murk_vec3 point[] = {{0, 0, 0},    {0, 0, 1},  {1, 3, 0.5},
                               {2, -4, 0.5}, {3, 0, 5},  {2.1, 0, 0.25},
                               {5, 1, 1},    {2, 0, -3}, {2, 2, -0.5}};
    for (size_t i = 0; i < sizeof above_m / sizeof *above_m; ++i) {
        const murk_mount_clearance m = upright(above_m[i], 1e-9);
        for (size_t k = 0; k < sizeof point / sizeof *point; ++k) {
            const double min = min_of_face(&m, &t, point[k]);
            const double got = murk_mount_clearance_to_face(&m, &t, point[k]);
            CHECK(got <= min + 1e-12 && got >= min - 0.025);
            const murk_triangle turned = {t.c, t.b, t.a};
            CHECK(fabs(murk_mount_clearance_to_face(&m, &turned, point[k]) -
                       got) < 1e-12);
        }
    }
    const murk_mount_clearance over = upright(3.01, 1e-9);
    CHECK(isinf(murk_mount_clearance_to_face(&over, &t, point[0])));
}

static double min_of_ball(const murk_mount_clearance *m,
                          const murk_stored_sphere *b, murk_vec3 point)
{
    double min = INFINITY;
    for (int i = 0; i <= FINE; ++i) {
        for (int j = 0; j < FINE; ++j) {
            const murk_vec3 p =
                murk_along(b->center, b->radius,
                           murk_about(murk_vec(0, 0, 1), -1 + 2.0 * i / FINE,
                                      2 * MURK_PI * j / FINE));
            if (p.z >= m->above_m) {
                min = fmin(min, murk_length(murk_sub(p, point)));
            }
        }
    }
    return min;
}

/* The clearance to a sphere on which the mount does not stand is the
 * minimum over points of the sphere above the given height. */
static void test_balls_by_points_on_them(void)
{
    /* Several heights, and points around and within the sphere. */
    const murk_stored_sphere b = {.center = {0.5, -0.25, 1}, .radius = 1.5};
    const double above_m[] = {-1, -0.25, 0.25, 1, 1.75, 2.25};
    const murk_vec3 point[] = {{0, 0, 0},        {0.5, -0.25, 1}, {4, 2, 1},
                               {0.5, -0.25, -3}, {0, 3, -1},      {1, 0, 5},
                               {0.5, 0.25, 1.5}, {2.25, 0, 0.5}};
    for (size_t i = 0; i < sizeof above_m / sizeof *above_m; ++i) {
        const murk_mount_clearance m = upright(above_m[i], 1e-9);
        for (size_t k = 0; k < sizeof point / sizeof *point; ++k) {
            const double min = min_of_ball(&m, &b, point[k]);
            const double got = murk_mount_clearance_to_sphere(&m, &b, point[k]);
            CHECK(fabs(got - min) < 0.025);
        }
    }
    /* A sphere that is wholly below the height does not count. */
    const murk_mount_clearance over = upright(2.51, 1e-9);
    CHECK(isinf(murk_mount_clearance_to_sphere(&over, &b, point[0])));
    /* A sphere through the site does not count, nor does a sphere that
     * passes the site within the slack; beyond the slack a sphere counts. */
    const murk_stored_sphere own[] = {{.center = {0, 0, -2}, .radius = 2},
                                      {.center = {0, 0, -2}, .radius = 2.099},
                                      {.center = {0, 0, -2}, .radius = 2.101}};
    const murk_mount_clearance slack = upright(-1, 0.1);
    CHECK(isinf(
        murk_mount_clearance_to_sphere(&slack, &own[0], murk_vec(0, 0, 1))));
    CHECK(isinf(
        murk_mount_clearance_to_sphere(&slack, &own[1], murk_vec(0, 0, 1))));
    CHECK(fabs(murk_mount_clearance_to_sphere(&slack, &own[2],
                                              murk_vec(0, 0, 1)) -
               0.899) < 1e-12);
}

int main(void)
{
    test_smooth_surfaces_go_on();
    test_faces_by_points_on_them();
    test_balls_by_points_on_them();
    return check_done();
}
