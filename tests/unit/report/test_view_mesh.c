/* Surfaces for a view: all of them, where they may be, corners within half a
 * step; else at most as many as asked for, near where they were, each with an
 * area and there once. Nothing here is random. */
#include "check.h"
#include "report/view_mesh.h"

#include <stdlib.h>
#include <string.h>

#define WAVE 120 /* cells of a wavy sheet along a side */

static double height(double x, double y)
{
    return 0.2 * sin(3 * x) * cos(2 * y);
}

/* A wavy sheet over 0..4 by 0..4 as a mesh of 2 WAVE^2 triangles. */
static murk_surfaces *wave(void)
{
    /* Vertices on a regular grid, at the heights of the wave. */
    static char name[1][MURK_NAME_SIZE] = {"default"};
    const size_t along = WAVE + 1, triangles = 2 * WAVE * WAVE;
    float *vertex = calloc(3 * along * along, sizeof *vertex);
    uint32_t *corner = calloc(3 * triangles, sizeof *corner);
    uint32_t *material = calloc(triangles, sizeof *material);
    murk_surfaces *surfaces = NULL;
    CHECK(vertex && corner && material);
    for (size_t i = 0; i < along * along; ++i) {
        const double x = 4.0 * (double)(i % along) / WAVE;
        const double y = 4.0 * (double)(i / along) / WAVE;
        vertex[3 * i] = (float)x;
        vertex[3 * i + 1] = (float)y;
        vertex[3 * i + 2] = (float)height(x, y);
    }
    /* Two triangles for each cell of the grid. */
    for (size_t i = 0; i < (size_t)WAVE * WAVE; ++i) {
        const uint32_t a = (uint32_t)(i % WAVE + i / WAVE * along);
        const uint32_t b = a + 1, c = a + (uint32_t)along, d = c + 1;
        const uint32_t two[6] = {a, b, c, b, d, c};
        memcpy(corner + 6 * i, two, sizeof two);
    }
    /* The mesh as the one surface, without a transform. */
    const murk_mesh mesh = {.vertices = along * along,
                            .triangles = triangles,
                            .materials = 1,
                            .vertex_m = vertex,
                            .corner = corner,
                            .material = material,
                            .material_name = name};
    const murk_material paint = {.name = "default"};
    const murk_surface_desc desc = {
        .shape = MURK_SHAPE_MESH,
        .mesh = &mesh,
        .to_world = {.matrix = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
        .where = "wave"};
    CHECK(murk_surfaces_create(&surfaces, &desc, 1, &paint, 1, NULL) ==
          MURK_OK);
    free(vertex);
    free(corner);
    free(material);
    return surfaces;
}

static murk_vec3 place(const murk_view_mesh *m, size_t i)
{
    const murk_vec3 size = murk_sub(m->box.max, m->box.min);
    const uint16_t *p = m->place + 3 * i;
    return murk_add(m->box.min, murk_vec(size.x * p[0] / MURK_VIEW_STEPS,
                                         size.y * p[1] / MURK_VIEW_STEPS,
                                         size.z * p[2] / MURK_VIEW_STEPS));
}

/* How far the sheet's corners are off it, at most. */
static double farthest(const murk_view_mesh *m)
{
    double far = 0;
    for (size_t i = 0; i < m->vertices; ++i) {
        const murk_vec3 p = place(m, i);
        far = fmax(far, fabs(p.z - height(p.x, p.y)));
    }
    return far;
}

static void check_sound(const murk_view_mesh *m)
{
    size_t bad = 0;
    for (size_t i = 0; i < m->triangles; ++i) {
        const uint32_t *c = m->corner + 3 * i;
        bad += c[0] >= m->vertices || c[1] >= m->vertices ||
               c[2] >= m->vertices || c[0] == c[1] || c[1] == c[2] ||
               c[2] == c[0];
    }
    CHECK(bad == 0);
}

static double area(const murk_view_mesh *m)
{
    double sum = 0;
    for (size_t i = 0; i < m->triangles; ++i) {
        const uint32_t *c = m->corner + 3 * i;
        const murk_vec3 a = place(m, c[0]);
        sum += 0.5 * murk_length(murk_cross(murk_sub(place(m, c[1]), a),
                                            murk_sub(place(m, c[2]), a)));
    }
    return sum;
}

static void test_few_are_all_there(const murk_surfaces *surfaces)
{
    murk_view_mesh m;
    CHECK(murk_view_mesh_make(&m, surfaces, 2 * WAVE * WAVE, NULL) == MURK_OK);
    CHECK(!m.is_coarse && m.triangles == m.asked);
    CHECK(m.vertices == (WAVE + 1) * (WAVE + 1));
    check_sound(&m);
    /* half a step in z, and in x and y by the steepest slope, 0.6 and 0.4 */
    CHECK(farthest(&m) < 0.5 / MURK_VIEW_STEPS * (0.4 + 4 * 1.0) + 1e-6);
    murk_view_mesh_release(&m);
}

static void test_many_become_fewer(const murk_surfaces *surfaces)
{
    murk_view_mesh all;
    CHECK(murk_view_mesh_make(&all, surfaces, SIZE_MAX, NULL) == MURK_OK);
    for (size_t maximum = 60; maximum < 2 * WAVE * WAVE; maximum *= 6) {
        murk_view_mesh m;
        CHECK(murk_view_mesh_make(&m, surfaces, maximum, NULL) == MURK_OK);
        CHECK(m.is_coarse && m.triangles <= maximum &&
              m.triangles > maximum / 8);
        CHECK(m.asked == 2 * WAVE * WAVE);
        check_sound(&m);
        /* the middle of a cell's corners is off the sheet by what it bends
         * within the cell, and that is at most a wave's height */
        CHECK(farthest(&m) < 0.4);
        if (maximum > 5000) {
            CHECK(farthest(&m) < 0.01);
            CHECK(fabs(area(&m) / area(&all) - 1) < 0.05);
        }
        murk_view_mesh_release(&m);
    }
    murk_view_mesh_release(&all);
}

static void test_nothing(void)
{
    const murk_material paint = {.name = "default"};
    murk_surfaces *none = NULL;
    murk_view_mesh m;
    CHECK(murk_surfaces_create(&none, NULL, 0, &paint, 1, NULL) == MURK_OK);
    CHECK(murk_view_mesh_make(&m, none, 100, NULL) == MURK_OK);
    CHECK(m.triangles == 0 && m.vertices == 0 && !m.is_coarse);
    murk_view_mesh_release(&m);
    murk_surfaces_destroy(none);
}

int main(void)
{
    murk_surfaces *surfaces = wave();
    test_few_are_all_there(surfaces);
    test_many_become_fewer(surfaces);
    test_nothing();
    murk_surfaces_destroy(surfaces);
    return check_done();
}
