/* The scores of a segment in planes, spheres and grids, against plain twins: a
 * plane by the signs of its two ends, a sphere by fine steps, a grid by
 * clipping the segment to every cell, a list that is joined by cell by one that
 * is summed in an array of all cells. Deterministic but for the drawn segments,
 * whose seed is fixed. */
#include <string.h>

#include "base/rng.h"
#include "check.h"
#include "transport/score.h"

static const murk_domain domain = {{{-1, -2, -3}, {5, 4, 3}}, false};

static const murk_tally_desc lattice = {.name = "grid",
                                        .type = MURK_TALLY_GRID,
                                        .box = {{0, -1, -2}, {4, 2, 2}},
                                        .size = {4, 6, 5}};

typedef struct scored {
    murk_tallies *tallies;
    murk_score_path *path;
    murk_tally emitted;
} scored;

static scored begun(const murk_tally_desc *descs, size_t n)
{
    scored s = {.emitted = 2 * MURK_PACKET};
    murk_error err = {0};
    CHECK(!murk_tallies_create(&s.tallies, descs, n, &domain, 1, 1, 1, INFINITY,
                               &err));
    s.path = &murk_tallies_scorer(s.tallies, 0)->path[0];
    return s;
}

/* The sum of a cell over the photons so far, in quanta for planes. */
static double sum_of(const scored *s, size_t tally, size_t cell)
{
    const double packet_w = (double)MURK_PACKET;
    return murk_tallies_read(s->tallies, tally, 0, cell, &s->emitted, &packet_w)
        .value;
}

static murk_station open_at(double x, double y, double z)
{
    return (murk_station){{x, y, z}, 0};
}

/* One photon along a broken line of open places. */
static void fly(const scored *s, const murk_vec3 *place, size_t n,
                double quanta)
{
    murk_score_start(s->path, 0, (murk_station){place[0], 0});
    for (size_t i = 1; i < n; ++i) {
        const murk_vec3 offset = murk_sub(place[i], place[i - 1]);
        murk_score_segment(s->path, place[i - 1], murk_unit(offset),
                           murk_length(offset), quanta,
                           (murk_station){place[i], 0});
    }
    murk_score_end(s->path, false);
}

/* ---- grids ---- */

static murk_box cell_box(const murk_tally_desc *d, size_t i, size_t j, size_t k)
{
    const murk_vec3 e =
        murk_vec((d->box.max.x - d->box.min.x) / (double)d->size[0],
                 (d->box.max.y - d->box.min.y) / (double)d->size[1],
                 (d->box.max.z - d->box.min.z) / (double)d->size[2]);
    const murk_vec3 a =
        murk_add(d->box.min,
                 murk_vec(e.x * (double)i, e.y * (double)j, e.z * (double)k));
    return (murk_box){a, murk_add(a, e)};
}

/* The length of the segment in one cell, each cut for itself. */
static double plain_length(const murk_tally_desc *d, size_t cell,
                           murk_vec3 from, murk_vec3 along, double length)
{
    const size_t i = cell % d->size[0], j = cell / d->size[0] % d->size[1],
                 k = cell / d->size[0] / d->size[1];
    const murk_box box = cell_box(d, i, j, k);
    double t0 = 0, t1 = length;
    return murk_box_clip(&box, from, along, &t0, &t1) ? t1 - t0 : 0;
}

/* Metres times packets in a cell: fluence is that over its volume. */
static double metres(const scored *s, const murk_tally_desc *d, size_t cell)
{
    const murk_box box = cell_box(d, 0, 0, 0);
    const murk_vec3 e = murk_sub(box.max, box.min);
    return sum_of(s, 0, cell) * e.x * e.y * e.z / (double)MURK_PACKET;
}

static void test_segments_through_a_grid(uint32_t seed)
{
    const murk_tally_desc *d = &lattice;
    const size_t cells = murk_tally_cells(d);
    CHECK(cells == 120);
    double crossed = 0;
    for (uint64_t n = 0; n < 3000; ++n) {
        const murk_random4 a = murk_random(seed, MURK_TEST, n, 0, 0);
        const murk_random4 b = murk_random(seed, MURK_TEST, n, 1, 0);
        const murk_vec3 p[2] = {
            {6 * a.u[0] - 1, 6 * a.u[1] - 2, 6 * a.u[2] - 3},
            {6 * b.u[0] - 1, 6 * b.u[1] - 2, 6 * b.u[2] - 3}};
        const scored s = begun(d, 1);
        fly(&s, p, 2, (double)MURK_PACKET);
        const murk_vec3 offset = murk_sub(p[1], p[0]);
        const double length = murk_length(offset);
        double all = 0, want_all = 0;
        for (size_t c = 0; c < cells; ++c) {
            const double want =
                plain_length(d, c, p[0], murk_unit(offset), length);
            const double got = metres(&s, d, c);
            CHECK_NEAR(got, want, 2e-9); /* a quantum of a diagonal */
            crossed += got > 0;
            all += got;
            want_all += want;
        }
        CHECK_NEAR(all, want_all, 2e-8);
        murk_tallies_destroy(s.tallies);
    }
    CHECK(crossed > 6000);
}

/* Along an axis, on faces and edges between cells and on the grid's own sides:
 * all of the length is somewhere, once. */
static void test_segments_on_faces(void)
{
    const murk_tally_desc *d = &lattice;
    const murk_vec3 ends[][2] = {
        {{-1, 0, 0}, {5, 0, 0}},       {{5, 0, 0}, {-1, 0, 0}},
        {{2, -2, 0.4}, {2, 4, 0.4}},   {{2, 4, -2}, {2, -2, -2}},
        {{0, -1, -2}, {0, -1, 2}},     {{4, 2, 2}, {4, 2, -2}},
        {{4, 2, 2}, {0, 2, 2}},        {{0, -1, -2}, {4, 2, 2}},
        {{4, 2, 2}, {0, -1, -2}},      {{1, 0, 0.4}, {1, 0, 0.4 + 1e-13}},
        {{1, 0.5, 0.4}, {2, 0.5, 0.4}}};
    const double want[] = {4, 4, 3, 3, 4, 4, 4, sqrt(41), sqrt(41), 1e-13, 1};
    for (size_t n = 0; n < sizeof want / sizeof *want; ++n) {
        const scored s = begun(d, 1);
        fly(&s, ends[n], 2, (double)MURK_PACKET);
        double all = 0;
        for (size_t c = 0; c < murk_tally_cells(d); ++c) {
            all += metres(&s, d, c);
        }
        CHECK_NEAR(all, want[n], 1e-8);
        murk_tallies_destroy(s.tallies);
    }
    const scored s = begun(d, 1); /* a face belongs to the cell above it */
    fly(&s, ends[10], 2, (double)MURK_PACKET);
    CHECK_NEAR(metres(&s, d, (3 * 6 + 3) * 4 + 1), 1, 1e-8);
    murk_tallies_destroy(s.tallies);
}

/* Segments beside the grid, of no length, of no direction: nothing, and an
 * end. */
static void test_segments_that_score_nothing(void)
{
    const scored s = begun(&lattice, 1);
    const murk_vec3 beside[][2] = {{{-0.5, 0, 0}, {-1, 0, 0}},
                                   {{4.5, -1.5, 0}, {4.5, 3, 0}},
                                   {{1, 1, 1}, {1, 1, 1}}};
    for (size_t i = 0; i < 3; ++i) {
        fly(&s, beside[i], 2, (double)MURK_PACKET);
    }
    const double odd[] = {0, NAN, INFINITY, -INFINITY, 1e-308, 1e300};
    for (size_t i = 0; i < 6; ++i) {
        for (size_t j = 0; j < 6; ++j) {
            murk_score_start(s.path, 0, open_at(odd[i], 0, 0));
            murk_score_segment(s.path, murk_vec(odd[i], 9, 0),
                               murk_vec(0, odd[j], odd[i]), odd[j], 1,
                               open_at(odd[j], 9, 0));
            murk_score_end(s.path, false);
        }
    }
    for (size_t c = 0; c < murk_tally_cells(&lattice); ++c) {
        CHECK(sum_of(&s, 0, c) == 0);
    }
    murk_tallies_destroy(s.tallies);
}

/* A photon with more contributions than its list holds, back and forth between
 * the middles of two cells: each cell has half of every segment. */
static void test_more_contributions_than_the_list_holds(void)
{
    const scored s = begun(&lattice, 1);
    const murk_vec3 from = {0.5, 0, 0.05}, to = {1.5, 0, 0.05};
    const size_t trips = 2 * MURK_SCORE_ENTRIES;
    murk_score_start(s.path, 0, (murk_station){from, 0});
    for (size_t i = 0; i < trips; ++i) {
        const bool is_back = i % 2;
        murk_score_segment(s.path, is_back ? to : from,
                           murk_vec(is_back ? -1 : 1, 0, 0), 1, MURK_PACKET,
                           (murk_station){is_back ? from : to, 0});
    }
    CHECK(s.path->has_sums);
    murk_score_end(s.path, false);
    CHECK(!s.path->has_sums);
    double other = 0, scored_cells = 0, first = 0;
    for (size_t c = 0; c < murk_tally_cells(&lattice); ++c) {
        const double value = sum_of(&s, 0, c);
        first = first == 0 ? value : first;
        scored_cells += value == first && value > 0;
        other += value != first ? value : 0;
    }
    CHECK(scored_cells == 2 && other == 0);
    murk_tallies_destroy(s.tallies);
}

/* Lists a photon that is in many cells, in many of them several times. */
static void list_photon(murk_score_path *path, uint64_t photon, size_t cells)
{
    murk_score_start(path, 0, open_at(0, 0, 0));
    for (uint32_t i = 0; i < MURK_SCORE_ENTRIES / 8 * 5; ++i) {
        const murk_random4 r = murk_random(7, MURK_TEST, photon, i, 0);
        /* values of 0, of many packets, and all between */
        const double value = r.u[0] < 0.1 ? 0 : pow(2, 40 * r.u[1]);
        murk_score_list(path, (uint32_t)(r.u[2] * (double)cells), value);
    }
}

/* A list whose cells are joined at the end of the photon gives the sums of a
 * list that is emptied into the sums of the scorer, to the bit, also if photons
 * are taken back. Most of the slots in which cells are looked up are needed. */
static void test_joined_lists(void)
{
    murk_tally_desc d = lattice;
    d.size[0] = d.size[1] = d.size[2] = 24;
    const size_t cells = murk_tally_cells(&d);
    const scored joined = begun(&d, 1), emptied = begun(&d, 1);
    const murk_tallies *a = joined.tallies, *b = emptied.tallies;
    /* The same photons in both. */
    for (uint64_t photon = 0; photon < 40; ++photon) {
        const bool takes_back = photon % 5 == 4;
        list_photon(joined.path, photon, cells);
        CHECK(!joined.path->has_sums);
        murk_score_end(joined.path, takes_back);
        list_photon(emptied.path, photon, cells);
        murk_score_spill(emptied.path);
        CHECK(emptied.path->has_sums);
        murk_score_end(emptied.path, takes_back);
    }
    /* Equal sums, some of them beyond 64 bits, and no slot in use. */
    CHECK(memcmp(a->low, b->low, cells * sizeof *a->low) == 0);
    CHECK(memcmp(a->high, b->high, cells * sizeof *a->high) == 0);
    size_t carried = 0;
    for (size_t i = 0; i < cells; ++i) {
        carried += murk_wide_read(&a->low[i].squares, &a->high[i].squares) >> 64
                       ? 1
                       : 0;
    }
    CHECK(carried > cells / 10);
    for (size_t i = 0; i < MURK_SCORE_SLOTS; ++i) {
        CHECK(joined.path->scorer->slot[i] == 0);
    }
    murk_tallies_destroy(joined.tallies);
    murk_tallies_destroy(emptied.tallies);
}

/* ---- spheres ---- */

static void test_segments_through_spheres(uint32_t seed)
{
    const murk_tally_desc descs[2] = {{.name = "probe",
                                       .type = MURK_TALLY_SPHERE,
                                       .center = {2, 1, 0},
                                       .radius_m = 1.5,
                                       .hemispheres = true},
                                      {.name = "dot",
                                       .type = MURK_TALLY_SPHERE,
                                       .center = {-0.5, 3, 1},
                                       .radius_m = 0.25}};
    const int steps = 20000;
    for (uint64_t n = 0; n < 100; ++n) {
        const murk_random4 a = murk_random(seed, MURK_TEST, n, 2, 0);
        const murk_random4 b = murk_random(seed, MURK_TEST, n, 3, 0);
        murk_vec3 p[2] = {{6 * a.u[0] - 1, 6 * a.u[1] - 2, 6 * a.u[2] - 3},
                          {6 * b.u[0] - 1, 6 * b.u[1] - 2, 6 * b.u[2] - 3}};
        if (n % 2) { /* towards the small one */
            p[1] = murk_add(descs[1].center,
                            murk_scale(0.1, murk_sub(p[1], p[0])));
        }
        const scored s = begun(descs, 2);
        fly(&s, p, 2, (double)MURK_PACKET);
        const murk_vec3 offset = murk_sub(p[1], p[0]);
        const size_t down = offset.z < 0;
        CHECK(sum_of(&s, 0, !down) == 0);
        for (size_t i = 0; i < 2; ++i) {
            const double r = descs[i].radius_m;
            int inside = 0;
            for (int k = 0; k < steps; ++k) {
                inside += murk_length(murk_sub(
                              murk_along(p[0], (k + 0.5) / steps, offset),
                              descs[i].center)) < r;
            }
            const double step = murk_length(offset) / steps;
            const double got = sum_of(&s, i, i == 0 ? down : 0) /
                               (double)MURK_PACKET * 4 / 3 * MURK_PI * r * r *
                               r;
            CHECK_NEAR(got, inside * step, 1.01 * step);
        }
        murk_tallies_destroy(s.tallies);
    }
}

/* ---- planes ---- */

static murk_tally_desc plane_at(murk_vec3 point, murk_vec3 normal)
{
    return (murk_tally_desc){.name = "plane",
                             .type = MURK_TALLY_PLANE,
                             .point = point,
                             .normal = normal,
                             .bins = {3, 2},
                             .angle_bins = 4};
}

static void test_bins_of_a_plane(void)
{
    const murk_tally_desc d = plane_at(murk_vec(0, 0, 1), murk_vec(0, 0, 2));
    CHECK(murk_tally_cells(&d) == 48);
    const scored s = begun(&d, 1);
    /* up at x 2.5 of -1..5 and y 2.5 of -2..4, cosine 0.6: bins 1, 1, 2 */
    const murk_vec3 up[2] = {{2.1, 2.5, 0.7}, {2.9, 2.5, 1.3}};
    fly(&s, up, 2, 700);
    CHECK(sum_of(&s, 0, (2 * 2 + 1) * 3 + 1) == 700);
    /* straight down: the last bin of angles, backward */
    const murk_vec3 down[2] = {{-1, -2, 2}, {-1, -2, 0}};
    fly(&s, down, 2, 300);
    CHECK(sum_of(&s, 0, (4 + 3) * 2 * 3) == 300);
    double all = 0;
    for (size_t c = 0; c < 48; ++c) {
        all += sum_of(&s, 0, c);
    }
    CHECK(all == 1000);
    murk_tallies_destroy(s.tallies);
}

static void test_axes_of_a_plane(void)
{
    const murk_vec3 normal[] = {{0, 0, -1}, {1, 0, 0},  {0, 3, 0},
                                {1, 1, 1},  {-2, 2, 1}, {3, 1, -2}};
    const int want[][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 1}, {0, 2}, {1, 2}};
    for (size_t i = 0; i < 6; ++i) {
        const murk_tally_desc d = plane_at(murk_vec(0, 0, 0), normal[i]);
        int axes[2];
        murk_tally_axes(&d, axes);
        CHECK(axes[0] == want[i][0] && axes[1] == want[i][1]);
    }
}

/* Forward and backward power of an undivided plane. */
static void directions_of(const scored *s, double *forward, double *backward)
{
    *forward = *backward = 0;
    for (size_t c = 0; c < 24; ++c) {
        *forward += sum_of(s, 0, c);
        *backward += sum_of(s, 0, 24 + c);
    }
}

/* Each passage of a photon to and fro through a slanted plane counts; some
 * paths have a corner in the plane. */
static void test_every_passage_counts(uint32_t seed)
{
    /* An undivided plane. */
    const murk_tally_desc d =
        plane_at(murk_vec(1, 1, 0.5), murk_vec(1, -2, 0.5));
    const murk_vec3 unit = murk_unit(d.normal);
    const scored s = begun(&d, 1);
    double up = 0, down = 0;
    for (uint64_t n = 0; n < 200; ++n) {
        /* A random path of eleven segments; some corners lie in the plane. */
        murk_vec3 p[12];
        for (uint32_t i = 0; i < 12; ++i) {
            const murk_random4 a = murk_random(seed, MURK_TEST, n, 4 + i, 0);
            p[i] = murk_vec(6 * a.u[0] - 1, 6 * a.u[1] - 2, 6 * a.u[2] - 3);
            if (n % 4 == 0 && i % 3 == 0) {
                p[i] = d.point;
            }
        }
        for (size_t i = 1; i < 12; ++i) {
            /* Count the changes of side; a point in the plane is on the
             * side of the normal. */
            const bool from = murk_dot(unit, murk_sub(p[i - 1], d.point)) >= 0;
            const bool to = murk_dot(unit, murk_sub(p[i], d.point)) >= 0;
            up += 5.0 * (to && !from);
            down += 5.0 * (from && !to);
        }
        fly(&s, p, 12, 5);
    }
    /* The scores are the same. */
    double forward, backward;
    directions_of(&s, &forward, &backward);
    CHECK(forward == up && backward == down && up > 2000);
    murk_tallies_destroy(s.tallies);
}

/* A surface within the tolerance of a plane lies on the side to which the
 * normal of the plane points: light that comes back from the surface has
 * not passed the plane, and light through the surface has. */
static void test_a_plane_in_a_surface(void)
{
    /* The surface just below, in, and just above the plane; both normals. */
    const double off[] = {-1e-7, 0, 1e-7};
    for (int i = 0; i < 3; ++i) {
        for (int side = -1; side <= 1; side += 2) {
            const murk_tally_desc d =
                plane_at(murk_vec(0, 0, 0), murk_vec(0, 0, side));
            const scored s = begun(&d, 1);
            const murk_vec3 down = {0, 0, -1};
            /* Down to the surface, back, down again, and through the
             * surface, with less weight after each meeting. */
            murk_score_start(s.path, 0, open_at(0, 0, 1));
            murk_score_segment(s.path, murk_vec(0, 0, 1), down, 1, 100,
                               (murk_station){{0, 0, off[i]}, 2e-7});
            murk_score_segment(s.path, murk_vec(0, 0, 4e-7), murk_vec(0, 0, 1),
                               1, 40, open_at(0, 0, 1));
            murk_score_segment(s.path, murk_vec(0, 0, 1), down, 1, 40,
                               (murk_station){{0, 0, off[i]}, 2e-7});
            murk_score_segment(s.path, murk_vec(0, 0, -4e-7), down, 1, 10,
                               open_at(0, 0, -1));
            murk_score_end(s.path, false);
            /* With the normal up only the transmitted light has passed;
             * with the normal down all light to the surface has, and the
             * light that comes back. */
            double forward, backward;
            directions_of(&s, &forward, &backward);
            if (side > 0) {
                CHECK(forward == 0 && backward == 10);
            } else {
                CHECK(forward == 140 && backward == 40);
            }
            murk_tallies_destroy(s.tallies);
        }
    }
}

static void test_a_jump_passes_nothing(void)
{
    const murk_tally_desc d = plane_at(murk_vec(0, 0, 0), murk_vec(1, 0, 0));
    const scored s = begun(&d, 1);
    murk_score_start(s.path, 0, open_at(-1, 0, 0));
    murk_score_jump(s.path, open_at(1, 0, 0));
    murk_score_segment(s.path, murk_vec(1, 0, 0), murk_vec(-1, 0, 0), 2, 7,
                       open_at(-1, 0, 0));
    murk_score_end(s.path, false);
    double forward, backward;
    directions_of(&s, &forward, &backward);
    CHECK(forward == 0 && backward == 7);
    murk_tallies_destroy(s.tallies);
}

/* ---- sums ---- */

static void test_taken_back_leaves_nothing(void)
{
    const scored s = begun(&lattice, 1);
    const murk_vec3 ends[2] = {{0.1, 0.2, 0.3}, {3.9, 1.1, -0.7}};
    const murk_vec3 gone[2] = {{0.3, 0.2, 1}, {3.1, 1.1, -1}};
    fly(&s, ends, 2, 12345);
    double before[120], after = 0;
    for (size_t c = 0; c < 120; ++c) {
        before[c] = sum_of(&s, 0, c);
    }
    for (int sign = 0; sign < 2; ++sign) {
        const murk_vec3 offset = murk_sub(gone[1], gone[0]);
        murk_score_start(s.path, 0, (murk_station){gone[0], 0});
        murk_score_segment(s.path, gone[0], murk_unit(offset),
                           murk_length(offset), 1e15,
                           (murk_station){gone[1], 0});
        murk_score_end(s.path, sign);
    }
    for (size_t c = 0; c < 120; ++c) {
        CHECK(sum_of(&s, 0, c) == before[c]);
        after += before[c];
    }
    CHECK(after > 0);
    murk_tallies_destroy(s.tallies);
}

/* n x^2 - (n x)^2 / n is 0; of {a, b} it is (a - b)^2 / 2: the widest numbers
 * that a run can bring, too. */
static void test_exact_spread(void)
{
    const uint64_t x[] = {1, 12345678901, (UINT64_C(1) << 47) - 3};
    for (int i = 0; i < 3; ++i) {
        murk_wide sum = 0, squares = 0;
        for (int k = 0; k < 1000; ++k) {
            sum += x[i];
            squares += (murk_wide)x[i] * x[i];
        }
        CHECK(murk_wide_spread(sum, squares, 1000) == 0);
        CHECK(murk_wide_value(sum) == 1000 * (double)x[i]);

        const uint64_t y = x[i] + 1000;
        const murk_wide both_squares =
            (murk_wide)x[i] * x[i] + (murk_wide)y * y;
        CHECK(murk_wide_spread((murk_wide)x[i] + y, both_squares, 2) == 500000);
    }
    /* all of 2^32 photons bring 2^47 - 1, but one that brings nothing */
    const uint64_t n = UINT32_MAX;
    const murk_wide one = (UINT64_C(1) << 47) - 1;
    const murk_wide sum = (n - 1) * one, squares = (n - 1) * (one * one);
    CHECK_NEAR(murk_wide_spread(sum, squares, n) / 0x1p94, 1, 1e-9);
}

/* Sums of 64 bits carry into the upper half, and adding the complement takes a
 * number back, with and without other threads. */
static void test_wide_sums(void)
{
    const murk_wide big =
        (murk_wide)UINT64_C(0xfedcba9876543210) * UINT64_C(0xfedcba9876543210);
    /* the lower and the upper half */
    murk_wide_half shared[2] = {0, 0}, alone[2] = {0, 0};
    for (int i = 0; i < 5; ++i) {
        murk_wide_add(&shared[0], &shared[1], UINT64_MAX);
        murk_wide_add_alone(&alone[0], &alone[1], UINT64_MAX);
    }
    CHECK(murk_wide_read(&shared[0], &shared[1]) == (murk_wide)UINT64_MAX * 5);
    CHECK(murk_wide_read(&alone[0], &alone[1]) == (murk_wide)UINT64_MAX * 5);
    murk_wide_add(&shared[0], &shared[1], big);
    murk_wide_add_alone(&alone[0], &alone[1], big);
    murk_wide_add(&shared[0], &shared[1], -big);
    murk_wide_add_alone(&alone[0], &alone[1], -big);
    CHECK(murk_wide_read(&shared[0], &shared[1]) == (murk_wide)UINT64_MAX * 5);
    CHECK(murk_wide_read(&alone[0], &alone[1]) == (murk_wide)UINT64_MAX * 5);
}

/* Two photons in one channel: value a + b, variance 2/1 (a - b)^2 / 2. */
static void test_error_of_two_photons(void)
{
    const murk_tally_desc d = plane_at(murk_vec(0, 0, 0), murk_vec(0, 0, 1));
    const scored s = begun(&d, 1);
    const murk_vec3 up[2] = {{0, 0, -1}, {0, 0, 1}};
    fly(&s, up, 2, 0x1p30);
    fly(&s, up, 2, 0x1p29);
    const double packet_w = 3;
    const size_t cell = 3 * 6; /* x -1..5 and y -2..4 about 0 */
    const murk_estimate e =
        murk_tallies_read(s.tallies, 0, 0, cell, &s.emitted, &packet_w);
    CHECK_NEAR(e.value, 4.5, 1e-15);
    CHECK_NEAR(e.standard_error, 1.5, 1e-15);
    murk_tallies_destroy(s.tallies);
}

/* Nothing is known of how a lamp's photons differ when it has sent but one. */
static void test_error_of_one_photon(void)
{
    const murk_tally_desc d = plane_at(murk_vec(0, 0, 0), murk_vec(0, 0, 1));
    const scored s = begun(&d, 1);
    const murk_vec3 up[2] = {{0, 0, -1}, {0, 0, 1}};
    fly(&s, up, 2, 0x1p29);
    const double packet_w = 3;
    const murk_tally one = MURK_PACKET;
    const murk_estimate e =
        murk_tallies_read(s.tallies, 0, 0, 3 * 6, &one, &packet_w);
    CHECK(e.value == 1.5 && e.standard_error == 1.5);
    CHECK(
        murk_tallies_read(s.tallies, 0, 0, 0, &one, &packet_w).standard_error ==
        0);
    murk_tallies_destroy(s.tallies);
}

int main(void)
{
    test_segments_through_a_grid(1);
    test_segments_on_faces();
    test_segments_that_score_nothing();
    test_more_contributions_than_the_list_holds();
    test_joined_lists();
    test_segments_through_spheres(1);
    test_bins_of_a_plane();
    test_axes_of_a_plane();
    test_every_passage_counts(1);
    test_a_plane_in_a_surface();
    test_a_jump_passes_nothing();
    test_taken_back_leaves_nothing();
    test_exact_spread();
    test_wide_sums();
    test_error_of_two_photons();
    test_error_of_one_photon();
    return check_done();
}
