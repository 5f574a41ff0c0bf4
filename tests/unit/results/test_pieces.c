/* Surfaces in pieces: they fill their triangles and spheres, no edge is longer
 * than asked, and a place is found on the piece that holds it.
 *
 * Deterministic: never cries wolf. */
#include "base/rng.h"
#include "check.h"
#include "results/pieces.h"

#define SEED 3

static murk_surfaces *make_world(void)
{
    /* A box, a tilted rectangle and two spheres of another material. */
    const murk_material materials[2] = {{.name = "default"}, {.name = "ball"}};
    const murk_affine as_is = murk_affine_identity();
    const murk_surface_desc shapes[4] = {{.shape = MURK_SHAPE_BOX,
                                          .box = {{-1, -1, 0}, {7, 3, 2.5}},
                                          .to_world = as_is,
                                          .where = "box"},
                                         {.shape = MURK_SHAPE_RECT,
                                          .corner = {0.3, 0.2, 1},
                                          .edge1 = {1, 0.2, 0.3},
                                          .edge2 = {-0.1, 0.9, 0.4},
                                          .to_world = as_is,
                                          .where = "rect"},
                                         {.shape = MURK_SHAPE_SPHERE,
                                          .center = {4, 1, 1.2},
                                          .radius_m = 0.7,
                                          .material = 1,
                                          .to_world = as_is,
                                          .where = "sphere"},
                                         {.shape = MURK_SHAPE_SPHERE,
                                          .center = {5.5, 0.5, 1},
                                          .radius_m = 0.25,
                                          .material = 1,
                                          .to_world = as_is,
                                          .where = "sphere"}};
    /* The surfaces without a scene file. */
    murk_surfaces *surfaces = NULL;
    murk_error err = {0};
    CHECK(!murk_surfaces_create(&surfaces, shapes, 4, materials, 2, &err));
    return surfaces;
}

static double edge_of(const murk_piece *p, int i)
{
    return murk_length(murk_sub(p->corner[(i + 1) % 3], p->corner[i]));
}

static void check_areas(const murk_surfaces *surfaces, double edge_m)
{
    murk_pieces pieces;
    murk_error err = {0};
    CHECK(!murk_pieces_create(&pieces, surfaces, edge_m, 0, "w", &err));
    double flat_m2 = 0, round_m2 = 0;
    for (size_t i = 0; i < pieces.n; ++i) {
        const murk_piece piece = murk_piece_of(&pieces, i);
        *(piece.material ? &round_m2 : &flat_m2) += piece.area_m2;
        for (int c = 0; c < 3; ++c) {
            CHECK(edge_of(&piece, c) < edge_m * (1 + 1e-5));
        }
        const murk_vec3 across =
            murk_cross(murk_sub(piece.corner[1], piece.corner[0]),
                       murk_sub(piece.corner[2], piece.corner[0]));
        CHECK(murk_dot(across, piece.normal) > 0.9 * murk_length(across));
        if (piece.material) { /* outward */
            const murk_vec3 center = piece.middle.x < 4.8
                                         ? murk_vec(4, 1, 1.2)
                                         : murk_vec(5.5, 0.5, 1);
            CHECK(murk_dot(piece.normal, murk_sub(piece.middle, center)) > 0);
        }
    }
    const double box_m2 = 2 * (8 * 4 + 8 * 2.5 + 4 * 2.5);
    const double rect_m2 = murk_length(
        murk_cross(murk_vec(1, 0.2, 0.3), murk_vec(-0.1, 0.9, 0.4)));
    CHECK_NEAR(flat_m2, box_m2 + rect_m2, 1e-5 * box_m2); /* floats */
    CHECK_NEAR(round_m2, 4 * MURK_PI * (0.49 + 0.0625), 1e-5);
    murk_pieces_release(&pieces);
}

/* Whether a point of the piece's plane lies within its three edges. */
static bool holds(const murk_piece *piece, murk_vec3 at, double slack)
{
    for (int i = 0; i < 3; ++i) {
        const murk_vec3 a = piece->corner[i], b = piece->corner[(i + 1) % 3];
        const murk_vec3 in =
            murk_cross(piece->normal, murk_unit(murk_sub(b, a)));
        if (murk_dot(in, murk_sub(at, a)) < -slack) {
            return false;
        }
    }
    return true;
}

/* Points of each piece are found on it, from either side. */
static void check_incumbent(const murk_surfaces *surfaces, double edge_m)
{
    murk_pieces pieces;
    murk_error err = {0};
    CHECK(!murk_pieces_create(&pieces, surfaces, edge_m, 0, "w", &err));
    size_t others = 0;
    for (size_t i = 0; i < pieces.n; ++i) {
        const murk_piece piece = murk_piece_of(&pieces, i);
        const murk_random4 r = murk_random(SEED, MURK_EMIT, i, 0, 0);
        const double s = sqrt(r.u[0]);
        murk_vec3 at = murk_along(murk_along(murk_scale(1 - s, piece.corner[0]),
                                             s * (1 - r.u[1]), piece.corner[1]),
                                  s * r.u[1], piece.corner[2]);
        if (piece.material) {
            at = piece.middle; /* other points leave the plane */
        }
        const murk_vec3 normal =
            murk_scale(r.u[2] < 0.5 ? -1 : 1, piece.normal);
        const uint32_t found = murk_pieces_at(&pieces, at, normal);
        CHECK(found != MURK_NO_PIECE);
        if (found != i && found != MURK_NO_PIECE) {
            const murk_piece other = murk_piece_of(&pieces, found);
            CHECK(holds(&other, at, 1e-5)); /* on an edge of both */
            ++others;
        }
    }
    CHECK(others <= pieces.n / 500);
    CHECK(murk_pieces_at(&pieces, murk_vec(2, 2, 1.9), murk_vec(0, 0, 1)) ==
          MURK_NO_PIECE);
    murk_pieces_release(&pieces);
}

static void test_sizes(const murk_surfaces *surfaces)
{
    murk_pieces pieces;
    murk_error err = {0};
    CHECK(!murk_pieces_create(&pieces, surfaces, 1000, 0, "w", &err));
    CHECK(pieces.n == 12 + 2 + 2 * 8); /* whole */
    murk_pieces_release(&pieces);
    CHECK(!murk_pieces_create(&pieces, surfaces, 0, 3, "w", &err));
    CHECK(pieces.n >= 30 && pieces.n <= 33);
    murk_pieces_release(&pieces);
    CHECK(!murk_pieces_create(&pieces, surfaces, 0, 20000, "w", &err));
    CHECK(pieces.n <= 20030 && pieces.n > 17000);
    murk_pieces_release(&pieces);
    CHECK(murk_pieces_create(&pieces, surfaces, 0.003, 0, "--voxel", &err) ==
          MURK_BAD_VALUE);
    CHECK(strcmp(err.where, "--voxel") == 0 &&
          strstr(err.text, "must be at most 10000000"));
    murk_pieces_release(&pieces);
    err = (murk_error){0};
    CHECK(murk_pieces_create(&pieces, surfaces, 1e-300, 0, "--voxel", &err) ==
          MURK_BAD_VALUE);
    murk_pieces_release(&pieces);
}

int main(void)
{
    murk_surfaces *surfaces = make_world();
    check_areas(surfaces, 0.9);
    check_areas(surfaces, 0.11);
    check_incumbent(surfaces, 5);
    check_incumbent(surfaces, 0.1);
    test_sizes(surfaces);
    murk_surfaces_destroy(surfaces);
    return check_done();
}
