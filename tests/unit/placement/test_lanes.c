/* Gains over many covers at once are those over each cover alone, and starts
 * that share the passes over the rows give the same as one start after the
 * other, the work included. */
#include "placement/lanes.h"
#include "placement/matrix.h"
#include "placement/starts.h"

#include "check.h"
#include "made_up.h"

#include <string.h>

#define SENSORS 4

/* Rows in every format: of seven rows one sees everything, one very little, and
 * one everything it sees clearly. */
static made_up *make_mixed(uint32_t seed, uint32_t weights, unsigned redundancy)
{
    made_up *m = made_up_create(seed, 640, 500, .25, 9, weights, 2);
    const size_t n = m->problem.photons;
    for (size_t j = 0; j < m->problem.candidates; ++j) {
        for (size_t i = 0; i < n; ++i) {
            uint16_t *clarity = &m->clarity[j * n + i];
            if (j % 7 == 0) {
                *clarity = (uint16_t)(*clarity / 3 + 1);
            } else if (j % 7 == 1) {
                *clarity = i % 97 == j % 5 ? *clarity : 0;
            } else if (j % 7 == 2) {
                *clarity = *clarity ? MURK_CLEAR : 0;
            }
        }
    }
    m->problem.redundancy = redundancy;
    return m;
}

static murk_matrix *matrix_of(const made_up *m)
{
    murk_matrix *matrix = NULL;
    murk_error err = {0};
    CHECK(murk_matrix_create(&matrix, &m->problem, UINT64_MAX, &err) ==
          MURK_OK);
    return matrix;
}

/* Over 1 to MURK_COVER_LANES covers of up to five rows each. */
static void check_gains(const murk_evaluator *o)
{
    const murk_layout *layout = o->layout;
    const murk_row *row = o->matrix->row;
    murk_lanes lanes;
    murk_error err = {0};
    CHECK(murk_lanes_init(&lanes, o, &err) == MURK_OK);
    murk_cover cover[MURK_COVER_LANES];
    const murk_cover *borrowed[MURK_COVER_LANES];
    for (size_t k = 0; k < MURK_COVER_LANES; ++k) {
        CHECK(murk_cover_init(&cover[k], layout, o->is_binary));
        borrowed[k] = &cover[k];
        for (size_t n = 0; n < k % 6; ++n) {
            murk_cover_add(&cover[k], layout,
                           &row[(37 * k + 11 * n) % o->candidates]);
        }
    }
    /* Compare all gains over the first n covers with those over one cover. */
    size_t off = 0;
    for (size_t n = 1; n <= MURK_COVER_LANES; n += 5) {
        murk_lanes_gains(&lanes, borrowed, n);
        for (size_t j = 0; j < o->candidates; ++j) {
            for (size_t k = 0; k < n; ++k) {
                off += lanes.gain[j * MURK_COVER_LANES + k] !=
                       murk_row_gain(layout, &row[j], &cover[k]);
            }
        }
    }
    CHECK(off == 0);
    for (size_t k = 0; k < MURK_COVER_LANES; ++k) {
        murk_cover_release(&cover[k]);
    }
    murk_lanes_release(&lanes);
}

/* What the starts give. */
typedef struct outcome {
    uint32_t plan[SENSORS];
    uint64_t value, evaluations, rows;
    size_t made;
} outcome;

static outcome try_shared(const murk_evaluator *o, size_t max)
{
    outcome r = {.value = 0};
    murk_starts starts;
    murk_gain_scan scan;
    murk_error err = {0};
    CHECK(murk_starts_init(&starts, o, SENSORS, 5, &err) == MURK_OK);
    CHECK(murk_gain_scan_init(&scan, o, 0, 1, &err) == MURK_OK);
    CHECK(starts.has_lanes);
    size_t size = 0;
    r.value = murk_starts_try(&starts, &scan, r.plan, &size, SENSORS, 0,
                              UINT64_MAX, max, &r.made);
    r.evaluations = starts.all_evaluations;
    r.rows = starts.all_rows;
    murk_gain_scan_release(&scan);
    murk_starts_release(&starts);
    return r;
}

/* One start after the other, with the same stop rule and the same limits on
 * work: an eighth of the whole for each start. */
static outcome try_singly(const murk_evaluator *o, size_t max)
{
    outcome r = {.value = 0};
    murk_gain_scan scan;
    murk_error err = {0};
    CHECK(murk_gain_scan_init(&scan, o, 0, 1, &err) == MURK_OK);
    const uint64_t rows_max = murk_gain_scan_rows_max(o);
    scan.rows_max = rows_max / 8;
    size_t without_gain = 0;
    while (r.made < max && without_gain < MURK_STARTS_WITHOUT_GAIN &&
           r.rows <= rows_max) {
        /* Make a start, and accept the plan if it is better. */
        uint32_t plan[SENSORS];
        scan.rows = 0;
        scan.is_cut = false;
        murk_search_spoq(&scan, plan, SENSORS, 5, r.made);
        const uint64_t value = murk_search_relocate(&scan, plan, SENSORS);
        ++r.made;
        ++without_gain;
        r.rows += scan.rows;
        if (value > r.value) {
            r.value = value;
            memcpy(r.plan, plan, sizeof plan);
            without_gain = 0;
        }
    }
    r.evaluations = scan.evaluations;
    murk_gain_scan_release(&scan);
    return r;
}

static void check_starts(murk_evaluator *o)
{
    const uint64_t row = murk_evaluator_work(o, 1);
    const struct {
        size_t max;
        uint64_t rows; /* 0: the usual limit on work */
    } limit[] = {{40, 0}, {3, 0}, {40, 40000}, {40, 150000}};
    for (size_t k = 0; k < sizeof limit / sizeof limit[0]; ++k) {
        o->search_work = limit[k].rows * row;
        const outcome a = try_singly(o, limit[k].max);
        const outcome b = try_shared(o, limit[k].max);
        CHECK(a.made > 0 && a.made == b.made && a.value == b.value);
        CHECK(a.rows == b.rows && a.evaluations == b.evaluations);
        CHECK(memcmp(a.plan, b.plan, sizeof a.plan) == 0);
    }
}

int main(void)
{
    for (uint32_t k = 0; k < 4; ++k) {
        made_up *m = make_mixed(k, k % 2 ? 500 : 2, k < 2 ? 1 : 2);
        murk_matrix *matrix = matrix_of(m);
        murk_evaluator evaluator;
        murk_error err = {0};
        CHECK(murk_evaluator_init(&evaluator, &m->problem, matrix, NULL,
                                  SENSORS, 0, true, &err) == MURK_OK);
        CHECK(murk_lanes_pay(&evaluator));
        CHECK(matrix->layout.segment[0].is_mixed == (k % 2 == 1));
        for (size_t set = 0; murk_kernels_number(set); ++set) {
            matrix->layout.kernels = murk_kernels_number(set);
            check_gains(&evaluator);
        }
        if (k == 0 || k == 3) {
            check_starts(&evaluator);
        }
        murk_evaluator_release(&evaluator);
        murk_matrix_destroy(matrix);
        made_up_destroy(m);
    }
    return check_done();
}
