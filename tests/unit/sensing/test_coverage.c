/* Coverage and its error: counts by hand, the formula spelled out, and the
 * spread over many repetitions.
 *
 * The repetitions: 5 z-tests share a chance of 1e-6 of a false alarm per seed
 * (Sidak); the seed is fixed, so the verdict repeats. */
#include "base/rng.h"
#include "sensing/sight.h"
#include "world.h"

#define CHECKS 5
#define BUDGET 1e-6

static uint32_t seed = 5;

static const murk_domain hall = {.box = {{0, 0, 0}, {10, 8, 4}}};
static const murk_vec3 none = {0, 0, 0}, up = {0, 0, 1};

typedef struct world {
    murk_surfaces *surfaces;
    murk_media *media;
    murk_photon_map *surface_map, *volume_map;
    murk_sight *sight;
} world;

static const murk_map_weights balanced = {.balanced = true};
static const murk_map_weights plain_count = {.surface = 1, .volume = 1};

/* A hall with a wall across at x = 5. */
static world build(const murk_photon *surface, size_t n_surface,
                   const murk_photon *volume, size_t n_volume, uint64_t emitted,
                   murk_map_weights weights, double per_m, unsigned threads)
{
    /* A wall, mist and both maps. */
    const murk_surface_desc wall =
        a_rect(murk_vec(5, 0, 0), murk_vec(0, 8, 0), murk_vec(0, 0, 4), WALL);
    world w = {.surfaces = surfaces_of(&wall, 1),
               .media = mist(&hall, per_m, per_m),
               .surface_map = map_of(surface, n_surface),
               .volume_map = map_of(volume, n_volume)};
    /* A sight of one sensor type that sees far in all directions. */
    const murk_sensor_type far = all_round(100);
    const murk_sight_desc desc = {.surfaces = w.surfaces,
                                  .media = w.media,
                                  .domain = hall,
                                  .surface_map = w.surface_map,
                                  .volume_map = w.volume_map,
                                  .photons_emitted = emitted,
                                  .type = &far,
                                  .types = 1,
                                  .through_sheets = true,
                                  .weights = weights,
                                  .threads = threads};
    murk_error err = {0};
    CHECK(murk_sight_create(&w.sight, &desc, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return w;
}

static void tear_down(world *w)
{
    murk_sight_destroy(w->sight);
    murk_photon_map_destroy(w->surface_map);
    murk_photon_map_destroy(w->volume_map);
    murk_media_destroy(w->media);
    murk_surfaces_destroy(w->surfaces);
}

static murk_coverage_result measure(world *w, const murk_vec3 *sensor, size_t n)
{
    murk_coverage_result c = {0};
    murk_error err = {0};
    CHECK(murk_coverage_result_measure(&c, w->sight, partial_at(sensor, n), n,
                                       &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return c;
}

/* West of the wall 6 surface photons, east 2; west 1 volume photon, east 3.
 * Two sensors west, one east. */
static void test_counts_by_hand(void)
{
    murk_photon s[8], v[4];
    for (uint32_t i = 0; i < 8; ++i) {
        s[i] = a_photon(murk_vec(i < 6 ? 2 : 8, 1 + 0.5 * i, 1), up, i);
    }
    for (uint32_t i = 0; i < 4; ++i) {
        v[i] = a_photon(murk_vec(i < 1 ? 2 : 8, 1 + 0.5 * i, 1), none, i);
    }
    const murk_vec3 sensor[3] = {{1, 1, 3}, {3, 7, 3}, {9, 4, 3}};
    const double e = 1e-9; /* the two halves are equal to 2^-32 or so */
    world w = build(s, 8, v, 4, 100, balanced, 0, 1);
    murk_coverage_result c = measure(&w, sensor, 2);
    CHECK_NEAR(c.surface.value, 6.0 / 8, 1e-15);
    CHECK_NEAR(c.volume.value, 1.0 / 4, 1e-15);
    CHECK_NEAR(c.total.value, 0.5, e);
    CHECK_NEAR(c.covers[0], 0.5, e);
    CHECK_NEAR(c.only_it_covers[0], 0, 0);
    CHECK_NEAR(c.sum_of_views, 1, e);
    CHECK_NEAR(c.seen_by_at_least[0], 0.5, e);
    CHECK_NEAR(c.seen_by_at_least[1], 0.5, e);
    murk_coverage_result_release(&c);
    c = measure(&w, sensor, 3);
    CHECK_NEAR(c.total.value, 1, 0);
    CHECK_NEAR(c.total.standard_error, 0, 0);
    CHECK_NEAR(c.only_it_covers[2], 0.5, e);
    CHECK_NEAR(c.covers[2], 0.5, e);
    CHECK_NEAR(c.sum_of_views, 1.5, e);
    CHECK_NEAR(c.seen_by_at_least[0], 1, 0);
    CHECK_NEAR(c.seen_by_at_least[1], 0.5, e);
    CHECK_NEAR(c.seen_by_at_least[2], 0, 0);
    murk_coverage_result_release(&c);
    tear_down(&w);

    w = build(s, 8, v, 4, 100, plain_count, 0, 1);
    c = measure(&w, sensor, 1);
    CHECK_NEAR(c.total.value, 7.0 / 12, 1e-15);
    murk_coverage_result_release(&c);
    tear_down(&w);

    w = build(NULL, 0, v, 4, 100, balanced, 0, 1);
    c = measure(&w, sensor, 1);
    CHECK(isnan(c.surface.value) && isnan(c.surface.standard_error));
    CHECK_NEAR(c.total.value, 1.0 / 4, 1e-15);
    CHECK_NEAR(c.total.standard_error, c.volume.standard_error, 1e-15);
    murk_coverage_result_release(&c);
    tear_down(&w);
}

/* Of whatever weight a map is to the plan, down to none: its own fraction and
 * error are those of its own records. */
static void test_a_maps_own_fraction_knows_no_weights(void)
{
    murk_photon s[8], v[4];
    for (uint32_t i = 0; i < 8; ++i) {
        s[i] = a_photon(murk_vec(i < 6 ? 2 : 8, 1 + 0.5 * i, 1), up, i);
        s[i].power_w = i < 6 ? 1 : 3;
    }
    for (uint32_t i = 0; i < 4; ++i) {
        v[i] = a_photon(murk_vec(i < 1 ? 2 : 8, 1 + 0.5 * i, 1), none, i);
    }
    const murk_map_weights weights[5] = {{false, 0, 1},
                                         {false, 1, 0},
                                         {false, 1e-11, 1},
                                         {false, 1, 1e-11},
                                         {true, 0, 0}};
    /* By hand: sum of (power (seen - C))^2, over the square of all power. */
    const double c = 6.0 / 12;
    const double squares[2] = {
        (6 * (1 - c) * (1 - c) + 2 * 9 * c * c) / 144,
        (0.75 * 0.75 + 3 * 0.25 * 0.25) / 16,
    };
    const murk_vec3 sensor = {1, 1, 3};
    for (int k = 0; k < 5; ++k) {
        world w = build(s, 8, v, 4, 100, weights[k], 0, 1);
        murk_coverage_result got = measure(&w, &sensor, 1);
        CHECK_NEAR(got.surface.value, c, 1e-15);
        CHECK_NEAR(got.volume.value, 1.0 / 4, 1e-15);
        CHECK_NEAR(got.surface.standard_error, sqrt(100.0 / 99 * squares[0]),
                   1e-15);
        CHECK_NEAR(got.volume.standard_error, sqrt(100.0 / 99 * squares[1]),
                   1e-15);
        /* Teeth: a map of no weight is not in the total. */
        CHECK(k != 0 || got.total.value == 1.0 / 4);
        CHECK(k != 1 || got.total.value == c);
        murk_coverage_result_release(&got);
        tear_down(&w);
    }
}

/* Records of photons 0..n-1, each with some in either map, west or east. */
#define RECORDS 4000
typedef struct sample {
    murk_photon surface[RECORDS], volume[RECORDS];
    size_t n_surface, n_volume;
} sample;

static void store(sample *out, bool is_volume, bool is_west, uint32_t emitted,
                  double u)
{
    const murk_vec3 p = {is_west ? 2 : 8, 0.5 + 7 * u, 1};
    if (is_volume) {
        out->volume[out->n_volume++] = a_photon(p, none, emitted);
    } else {
        out->surface[out->n_surface++] = a_photon(p, up, emitted);
    }
}

/* A photon goes west with chance 0.4 and stays there. West it stores 1 surface
 * record and 1..2 in the volume, east 1..3 and 1..4; one in five leaves by a
 * window and stores nothing. */
#define WEST    0.4
#define SURFACE (WEST * 1 / (WEST * 1 + (1 - WEST) * 2))
#define VOLUME  (WEST * 1.5 / (WEST * 1.5 + (1 - WEST) * 2.5))

static void draw(sample *out, uint32_t n, uint32_t repetition)
{
    out->n_surface = out->n_volume = 0;
    for (uint32_t e = 0; e < n; ++e) {
        const murk_random4 r = murk_random(seed, MURK_TEST, e, repetition, 0);
        const murk_random4 q = murk_random(seed, MURK_TEST, e, repetition, 1);
        if (r.u[0] < 0.2) {
            continue;
        }
        const bool west = r.u[1] < WEST;
        const int surface = west ? 1 : 1 + (int)(3 * r.u[2]);
        const int volume = 1 + (int)((west ? 2 : 4) * r.u[3]);
        for (int k = 0; k < surface; ++k) {
            store(out, false, west, e, q.u[k]);
        }
        for (int k = 0; k < volume; ++k) {
            store(out, true, west, e, q.u[3 - k]);
        }
    }
}

typedef struct spread {
    double total, surface, volume, count; /* mean of squared pulls */
    double binomial, separate;            /* with wrong errors, for contrast */
} spread;

#define REPETITIONS 400
#define EMITTED     400

static double pull2(double got, double want, double error)
{
    const double z = (got - want) / error;
    return z * z / REPETITIONS;
}

static spread repeat(void)
{
    /* Independent samples of records, seen by one sensor. */
    static sample s;
    spread out = {0};
    const murk_vec3 sensor = {1, 4, 3};
    for (uint32_t k = 0; k < REPETITIONS; ++k) {
        draw(&s, EMITTED, k);
        world w = build(s.surface, s.n_surface, s.volume, s.n_volume, EMITTED,
                        balanced, 0, 1);
        murk_coverage_result c = measure(&w, &sensor, 1);
        /* Squared deviations in standard errors, for the total and both
         * maps under balanced weights. */
        const double total = (SURFACE + VOLUME) / 2;
        const murk_estimate a = c.surface, b = c.volume;
        out.total += pull2(c.total.value, total, c.total.standard_error);
        out.surface += pull2(a.value, SURFACE, a.standard_error);
        out.volume += pull2(b.value, VOLUME, b.standard_error);
        /* The same with wrong errors: of independent records, and of
         * independent maps. */
        out.binomial +=
            pull2(b.value, VOLUME,
                  sqrt(b.value * (1 - b.value) / (double)s.n_volume));
        out.separate += pull2(c.total.value, total,
                              hypot(a.standard_error, b.standard_error) / 2);
        murk_coverage_result_release(&c);
        tear_down(&w);

        /* The same where all records have one weight. */
        w = build(s.surface, s.n_surface, s.volume, s.n_volume, EMITTED,
                  plain_count, 0, 1);
        c = measure(&w, &sensor, 1);
        out.count +=
            pull2(c.total.value, WEST * 2.5 / (WEST * 2.5 + (1 - WEST) * 4.5),
                  c.total.standard_error);
        murk_coverage_result_release(&c);
        tear_down(&w);
    }
    return out;
}

/* A squared pull has mean 1 and variance 2. */
static void test_the_error_is_the_spread(void)
{
    const double limit = murk_sidak_limit(BUDGET, CHECKS);
    const double sigma = sqrt(2.0 / REPETITIONS);
    const spread s = repeat();
    CHECK_WITHIN(limit, s.total, 1, sigma);
    CHECK_WITHIN(limit, s.surface, 1, sigma);
    CHECK_WITHIN(limit, s.volume, 1, sigma);
    CHECK_WITHIN(limit, s.count, 1, sigma);
    /* Teeth: records taken as independent, and maps taken as independent,
     * must both be seen to claim too little. */
    CHECK(s.binomial > 1 + limit * sigma);
    CHECK(s.separate > 1 + limit * sigma);
}

/* se^2 = N / (N - 1) sum (X_e - C Y_e)^2 / (sum Y_e)^2, through mist and with
 * unequal powers. */
static void test_the_error_is_the_formula(void)
{
    static sample s;
    draw(&s, 300, 1000);
    double power[2] = {0, 0};
    for (size_t i = 0; i < s.n_surface; ++i) {
        s.surface[i].power_w = 0.5f + (float)(i % 7);
        power[0] += (double)s.surface[i].power_w;
    }
    for (size_t i = 0; i < s.n_volume; ++i) {
        s.volume[i].power_w = 2.5f + (float)(i % 3);
        power[1] += (double)s.volume[i].power_w;
    }
    const murk_vec3 sensor[2] = {{1, 4, 3}, {9, 1, 3}};
    world w = build(s.surface, s.n_surface, s.volume, s.n_volume, 300, balanced,
                    0.3, 2);
    murk_coverage_result c = measure(&w, sensor, 2);
    double x[2][300] = {{0}}, y[2][300] = {{0}}, r[300] = {0};
    for (int m = 0; m < 2; ++m) {
        const size_t n = m ? s.n_volume : s.n_surface;
        for (size_t i = 0; i < n; ++i) {
            const murk_photon *p = m ? &s.volume[i] : &s.surface[i];
            const bool is_west = p->position_m[0] < 5;
            const murk_vec3 at = {(double)p->position_m[0],
                                  (double)p->position_m[1],
                                  (double)p->position_m[2]};
            const double d = murk_length(murk_sub(sensor[is_west ? 0 : 1], at));
            x[m][p->emitted] += (double)p->power_w * exp(-0.3 * d);
            y[m][p->emitted] += (double)p->power_w;
        }
    }
    const murk_estimate want[2] = {murk_ratio_estimate(x[0], y[0], 300, 300),
                                   murk_ratio_estimate(x[1], y[1], 300, 300)};
    double squares = 0, sizes = 0;
    for (int e = 0; e < 300; ++e) {
        for (int m = 0; m < 2; ++m) {
            sizes += y[m][e] * y[m][e] / power[m] / power[m];
            r[e] += (x[m][e] - want[m].value * y[m][e]) / power[m] / 2;
        }
        squares += r[e] * r[e];
    }
    /* A stored clarity is off by half a unit: the sums by as much, the errors
     * by that times sqrt(sum Y_e^2) / sum Y_e. */
    const double unit = 1.0 / MURK_CLEAR, small = unit * sqrt(sizes);
    CHECK_NEAR(c.surface.value, want[0].value, unit);
    CHECK_NEAR(c.volume.value, want[1].value, unit);
    CHECK_NEAR(c.surface.standard_error, want[0].standard_error, small);
    CHECK_NEAR(c.volume.standard_error, want[1].standard_error, small);
    CHECK_NEAR(c.total.value, (want[0].value + want[1].value) / 2, unit);
    CHECK_NEAR(c.total.standard_error, sqrt(300.0 / 299 * squares), small);
    /* Teeth: the factor N / (N - 1) would be missed. */
    CHECK(c.total.standard_error / 600 > 2 * small);
    murk_coverage_result_release(&c);
    tear_down(&w);
}

/* The total coverage is the sum over the rows of the placement problem, in
 * whole numbers. */
static void test_total_is_the_plans_value(void)
{
    /* Three sensors in mist. */
    static sample s;
    draw(&s, 500, 2000);
    const murk_vec3 sensor[3] = {{1, 4, 3}, {9, 1, 3}, {4, 7, 2}};
    world w = build(s.surface, s.n_surface, s.volume, s.n_volume, 500, balanced,
                    0.2, 1);
    murk_sight_problem problem;
    murk_sight_problem_init(&problem, w.sight, partial_at(sensor, 3), 3);
    /* The largest clarity of each record over all rows of the problem. */
    const murk_problem *p = &problem.problem;
    CHECK(p->candidates == 3 && p->photons == s.n_surface + s.n_volume);
    int best[2 * RECORDS] = {0};
    for (size_t j = 0; j < 3; ++j) {
        murk_sparse_row row;
        p->get_row(p->context, 0, j, &row);
        for (size_t k = 0; k < row.seen; ++k) {
            int *b = &best[row.photon[k]];
            *b = row.clarity[k] > *b ? row.clarity[k] : *b;
        }
    }
    /* The sum of weights times clarity is the measured coverage. */
    uint64_t value = 0, whole = 0;
    for (size_t i = 0; i < p->photons; ++i) {
        value += (uint64_t)p->weight[i] * (uint64_t)best[i];
        whole += (uint64_t)p->weight[i] * MURK_CLEAR;
    }
    murk_coverage_result c = measure(&w, sensor, 3);
    CHECK(c.total.value == (double)value / (double)whole);
    murk_coverage_result_release(&c);
    tear_down(&w);
}

static void check_only(world *w, const murk_vec3 *sensor, size_t n)
{
    murk_coverage_result all = measure(w, sensor, n);
    for (size_t j = 0; j < n; ++j) {
        murk_vec3 others[4];
        for (size_t k = 0, m = 0; k < n; ++k) {
            if (k != j) {
                others[m++] = sensor[k];
            }
        }
        murk_coverage_result without = measure(w, others, n - 1);
        murk_coverage_result alone = measure(w, &sensor[j], 1);
        CHECK_NEAR(all.only_it_covers[j], all.total.value - without.total.value,
                   1e-12);
        CHECK_NEAR(all.covers[j], alone.total.value, 1e-12);
        murk_coverage_result_release(&without);
        murk_coverage_result_release(&alone);
    }
    /* Of two in one place neither is needed. */
    CHECK(all.only_it_covers[0] > 0);
    CHECK((all.only_it_covers[2] == 0) == (n == 4));
    murk_coverage_result_release(&all);
}

static void test_only_it_covers_is_total_less_total_without(void)
{
    static sample s;
    draw(&s, 500, 3000);
    const murk_vec3 sensor[4] = {{1, 4, 3}, {9, 1, 3}, {4, 7, 2}, {4, 7, 2}};
    world w = build(s.surface, s.n_surface, s.volume, s.n_volume, 500, balanced,
                    0.2, 1);
    check_only(&w, sensor, 3);
    check_only(&w, sensor, 4);
    tear_down(&w);
}

static void test_threads_change_nothing(void)
{
    static sample s;
    draw(&s, 500, 4000);
    murk_vec3 sensor[40];
    for (int j = 0; j < 40; ++j) {
        sensor[j] = murk_vec(0.1 + 0.24 * j, 4, 3);
    }
    murk_coverage_result c[3];
    const unsigned threads[3] = {1, 2, 5};
    for (int k = 0; k < 3; ++k) {
        world w = build(s.surface, s.n_surface, s.volume, s.n_volume, 500,
                        balanced, 0.2, threads[k]);
        c[k] = measure(&w, sensor, 40);
        CHECK(murk_sight_work_of(w.sight).queries == 40);
        tear_down(&w);
        CHECK(memcmp(&c[k].total, &c[0].total, sizeof c[k].total) == 0);
        CHECK(memcmp(c[k].covers, c[0].covers, 40 * sizeof(double)) == 0);
        CHECK(memcmp(c[k].only_it_covers, c[0].only_it_covers,
                     40 * sizeof(double)) == 0);
    }
    for (int k = 0; k < 3; ++k) {
        murk_coverage_result_release(&c[k]);
    }
}

static void test_a_sensor_outside_is_refused(void)
{
    static sample s;
    draw(&s, 10, 0);
    const murk_vec3 sensor[2] = {{1, 4, 3}, {10.5, 1, 3}};
    world w =
        build(s.surface, s.n_surface, s.volume, s.n_volume, 10, balanced, 0, 1);
    murk_coverage_result c = {0};
    murk_error err = {0};
    CHECK(murk_coverage_result_measure(&c, w.sight, partial_at(sensor, 2), 2,
                                       &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, "sensor 2 at [10.5, 1, 3] m is outside");
    tear_down(&w);
}

int main(int argc, char **argv)
{
    seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : seed;
    test_counts_by_hand();
    test_a_maps_own_fraction_knows_no_weights();
    test_the_error_is_the_spread();
    test_the_error_is_the_formula();
    test_total_is_the_plans_value();
    test_only_it_covers_is_total_less_total_without();
    test_threads_change_nothing();
    test_a_sensor_outside_is_refused();
    return check_done();
}
