/* Segments that are scored side by side (transport/score_lanes.h) give the
 * lists of segments that are scored one by one, to the bit: drawn ones, ones
 * along axes, on faces and edges, of no length, with ends outside of the grid,
 * and lanes without a segment, for every vector instruction set of this
 * processor. So do lists that are added to the tallies side by side. Nothing
 * here is statistical. */
#include <stdlib.h>
#include <string.h>

#include "base/rng.h"
#include "check.h"
#include "lane_sets.h"
#include "transport/score_lanes.h"

#define STEPS 400

static const murk_domain domain = {{{-1, -2, -3}, {5, 4, 3}}, false};

static const murk_tally_desc grid = {.name = "grid",
                                     .type = MURK_TALLY_GRID,
                                     .box = {{0, -1, -2}, {4, 2, 2}},
                                     .size = {8, 6, 5}};

static murk_tallies *created(void)
{
    murk_tallies *t;
    murk_error err = {0};
    CHECK(!murk_tallies_create(&t, &grid, 1, &domain, 1, 1, 1, INFINITY, &err));
    return t;
}

/* A coordinate between two others; every third one is a multiple of .5, which
 * is a face in x and y. */
static double coordinate(double u, double low, double high)
{
    const double x = low + u * (high - low);
    return fmod(u * 1e6, 3) < 1 ? round(2 * x) / 2 : x;
}

/* The next segment of a lane: from the position of the lane, with some axes
 * that stand still; sometimes from elsewhere. */
static void fly(murk_lane_rays *rays, double *length_m, size_t i, uint64_t step)
{
    const murk_random4 a = murk_random(1, MURK_TEST, step, (uint32_t)i, 0);
    const murk_random4 b = murk_random(1, MURK_TEST, step, (uint32_t)i, 1);
    const murk_random4 c = murk_random(1, MURK_TEST, step, (uint32_t)i, 2);
    murk_vec3 from = {rays->x[i] + length_m[i] * rays->dx[i],
                      rays->y[i] + length_m[i] * rays->dy[i],
                      rays->z[i] + length_m[i] * rays->dz[i]};
    /* The start, sometimes beyond the grid. */
    if (step == 0 || c.u[0] < 0.3) {
        const double beyond = c.u[1] < 0.2 ? 1 : 0;
        from = murk_vec(coordinate(a.u[0], -beyond, 4 + beyond),
                        coordinate(a.u[1], -1 - beyond, 2 + beyond),
                        coordinate(a.u[2], -2, 2));
    }
    /* The end. */
    murk_vec3 to = {coordinate(b.u[0], 0, 4), coordinate(b.u[1], -1, 2),
                    coordinate(b.u[2], -2, 2)};
    to.x = b.u[3] < 0.2 ? from.x : to.x;
    to.y = c.u[2] < 0.2 ? from.y : to.y;
    to.z = c.u[1] > 0.7 ? from.z : to.z;
    const murk_vec3 offset = murk_sub(to, from);
    const double length = murk_length(offset);
    const murk_vec3 along = length > 0 ? murk_unit(offset) : murk_vec(0, 0, -1);
    const double share = a.u[3] < 0.5 ? 1 : c.u[3] < 0.1 ? 0 : c.u[3] / 4;
    rays->x[i] = from.x;
    rays->y[i] = from.y;
    rays->z[i] = from.z;
    rays->dx[i] = along.x;
    rays->dy[i] = along.y;
    rays->dz[i] = along.z;
    rays->quanta[i] = 1 + floor(c.u[3] * (double)MURK_PACKET);
    length_m[i] = length * share;
}

static bool are_equal(const murk_score_path *a, const murk_score_path *b)
{
    bool is_equal = a->last == b->last;
    for (size_t i = 0; is_equal && i <= a->last; ++i) {
        is_equal = memcmp(&a->list[i], &b->list[i], sizeof a->list[i]) == 0;
    }
    return is_equal;
}

static void compare(murk_lane_set set)
{
    murk_tallies *plain = created(), *fast = created();
    murk_scorer *by_one = murk_tallies_scorer(plain, 0);
    murk_scorer *by_lanes = murk_tallies_scorer(fast, 0);
    const murk_lane_scoring *scoring = murk_lane_scoring_for(set);
    murk_lane_lists lists;
    murk_lane_lists_create(&lists, by_lanes);
    murk_lane_rays rays;
    memset(&rays, 0, sizeof rays);
    double length_m[MURK_LANE_COUNT] = {0};
    size_t entries = 0, joined = 0;
    for (uint64_t step = 0; step < STEPS; ++step) {
        murk_lane_segments segments = {.n = MURK_LANE_COUNT - step % 9,
                                       .from = &rays};
        for (size_t i = 0; i < MURK_LANE_COUNT; ++i) {
            fly(&rays, length_m, i, step);
            /* Some lanes have no segment. */
            if (i >= segments.n || (i + step) % 5 == 0) {
                continue;
            }
            murk_lane_lists_open(&lists, i, &by_lanes->path[i]);
            CHECK(lists.last[i] < lists.limit[i]);
            segments.length_m[i] = length_m[i];
            const size_t before = by_one->path[i].last;
            murk_score_lattice(&by_one->path[i], &plain->lattice[0],
                               murk_vec(rays.x[i], rays.y[i], rays.z[i]),
                               murk_vec(rays.dx[i], rays.dy[i], rays.dz[i]),
                               length_m[i], rays.quanta[i]);
            entries += by_one->path[i].last - before;
            joined += by_one->path[i].last == before;
        }
        scoring->score(&fast->lattice[0], &segments, &lists);
        for (size_t i = 0; i < MURK_LANE_COUNT; ++i) {
            if (lists.path[i]) {
                murk_lane_lists_close(&lists, i);
            }
            CHECK(are_equal(&by_one->path[i], &by_lanes->path[i]));
            /* Begin anew before a list is full. */
            if (by_one->path[i].last > MURK_SCORE_ENTRIES / 2) {
                by_one->path[i].last = by_lanes->path[i].last = 0;
            }
        }
    }
    CHECK(entries > STEPS * MURK_LANE_COUNT && joined > STEPS);
    murk_tallies_destroy(plain);
    murk_tallies_destroy(fast);
}

#define CELLS  300
#define ROUNDS 200

/* Values from 0 to 2^36, whose squares fill 72 bits, one for each of n cells in
 * mixed order. */
static void list_values(murk_score_entry *entry, uint32_t n, uint64_t round)
{
    for (uint32_t i = 0; i < n; ++i) {
        const murk_random4 r = murk_random(2, MURK_TEST, round, i, 0);
        const uint64_t cell = (i * UINT64_C(7) + round) % CELLS;
        entry[i] = (murk_score_entry){r.u[0] < 0.1 ? 0 : pow(2, 36 * r.u[1]),
                                      cell * sizeof(murk_tally_bin)};
    }
}

static void compare_adders(murk_lane_set set)
{
    static murk_tally_bin low[2][CELLS], high[2][CELLS];
    memset(low, 0, sizeof low);
    memset(high, 0, sizeof high);
    murk_score_entry entry[CELLS];
    for (uint64_t round = 0; round < ROUNDS; ++round) {
        const uint32_t n = (uint32_t)(round * 13 % (CELLS + 1));
        list_values(entry, n, round);
        murk_score_add_entries(low[0], high[0], entry, n);
        murk_lane_scoring_for(set)->add(low[1], high[1], entry, n);
    }
    CHECK(memcmp(low[0], low[1], sizeof low[0]) == 0);
    CHECK(memcmp(high[0], high[1], sizeof high[0]) == 0);
    size_t carried = 0;
    for (size_t i = 0; i < CELLS; ++i) {
        carried += high[0][i].squares > 0;
    }
    CHECK(carried > CELLS / 2);
}

int main(void)
{
    for (size_t i = 0; i < MURK_LANE_SETS; ++i) {
        const murk_lane_set set = (murk_lane_set)i;
        if (test_lane_set_forced(set)) {
            compare(set);
            compare_adders(set);
        }
    }
    return check_done();
}
