/* The search of a fit without any light: which rows it fits and how they
 * weigh, who hears of its steps, how far it leaps. All by hand, on plain
 * numbers; nothing is random. */
#include "calibrate/search_steps.h"

#include "check.h"

#define KEYS 3
#define ROWS 4

/* A scale, a number within bounds, and one without. The readings: light,
 * transmittance, one that is held out, light. */
typedef struct fit {
    murk_free_key key[KEYS];
    murk_free_keys keys;
    murk_reading reading[ROWS];
    murk_reading_row row[ROWS];
    murk_readings measured;
    murk_calibration_desc desc;
    murk_fit_search search;
} fit;

static void make(fit *f)
{
    /* Three keys, one of them logarithmic and one without bounds, and four
     * readings, one of them held out. */
    *f = (fit){
        .key = {{.is_log = true, .start = 2, .lower = 0, .upper = 1e6},
                {.start = 3, .lower = 1, .upper = 9},
                {.start = 0, .lower = -INFINITY, .upper = INFINITY}},
        .reading = {
            {.kind = MURK_READ_IRRADIANCE, .value = 10, .standard_error = 2},
            {.kind = MURK_READ_TRANSMITTANCE,
             .value = .5,
             .standard_error = .25},
            {.kind = MURK_READ_IRRADIANCE,
             .value = 20,
             .standard_error = 4,
             .is_held_out = true},
            {.kind = MURK_READ_IRRADIANCE, .value = 30, .standard_error = 5}}};
    /* A row for each reading. */
    for (size_t i = 0; i < ROWS; ++i) {
        f->row[i] = (murk_reading_row){.first = i};
    }
    /* Create the search of this fit. */
    f->keys = (murk_free_keys){.n = KEYS, .key = f->key};
    f->measured = (murk_readings){
        .reading = f->reading, .readings = ROWS, .row = f->row, .rows = ROWS};
    f->desc =
        (murk_calibration_desc){.keys = &f->keys, .measured = &f->measured};
    murk_error err = {0};
    CHECK(murk_fit_search_create(&f->search, &f->desc, NULL, &err) == MURK_OK);
}

/* Rows of light come first, then the others; what is held out does not. */
static void test_rows_that_are_fitted(void)
{
    fit f;
    make(&f);
    CHECK(f.search.n_fitted == 3 && f.search.n_light == 2);
    CHECK(f.search.fitted[0] == 0 && f.search.fitted[1] == 3 &&
          f.search.fitted[2] == 1);
    CHECK(f.search.measured[2] == 20 && f.search.error[3] == 5);
    murk_fit_search_release(&f.search);
}

/* Measured less predicted: of light as it is (the whitening divides), of
 * transmittance over its error, 4 times. Slopes turn their sign, and by the
 * logarithm of a key they are its value times those by the key. */
static void test_residuals_and_slopes(void)
{
    fit f;
    make(&f);
    const double predicted[] = {7, .25, 0, 31}, value[] = {2, 3, 5};
    memcpy(f.search.predicted, predicted, sizeof predicted);
    memcpy(f.search.value, value, sizeof value);
    for (size_t i = 0; i < ROWS * KEYS; ++i) {
        f.search.slope[i] = 1 + (double)i;
    }
    double residual[3], jacobian[3 * KEYS];
    murk_fit_search_residuals(&f.search, residual, jacobian);
    const double want[] = {3, -1, 1};
    const double slopes[] = {-2, -2, -3, -20, -11, -12, -32, -20, -24};
    for (size_t i = 0; i < 3; ++i) {
        CHECK(residual[i] == want[i]);
    }
    for (size_t i = 0; i < 3 * KEYS; ++i) {
        CHECK(jacobian[i] == slopes[i]);
    }
    CHECK(murk_fit_cost(&f.search, residual) == 11);
    /* Huber's loss of a residual 3 at width 1: 2 * 3 - 1 */
    f.desc.loss = MURK_LOSS_FUNCTION_HUBER;
    f.desc.loss_width = 1;
    CHECK_NEAR(murk_fit_cost(&f.search, residual), 5 + 1 + 1, 1e-14);
    murk_fit_search_release(&f.search);
}

/* A key that runs over its logarithm has that as its coordinate; values stay
 * within their bounds. */
static void test_coordinates(void)
{
    fit f;
    make(&f);
    const double value[] = {2, 3, -5}, far[] = {log(1e7), 10, -1e9};
    double x[KEYS], back[KEYS];
    murk_fit_search_coordinates(&f.search, value, x);
    CHECK(x[0] == log(2) && x[1] == 3 && x[2] == -5);
    murk_fit_search_values(&f.search, x, back);
    CHECK_NEAR(back[0], 2, 1e-15);
    murk_fit_search_values(&f.search, far, back);
    CHECK(back[0] == 1e6 && back[1] == 9 && back[2] == -1e9);
    /* the ends of a scale: its bounds, or 1e9 times its start */
    CHECK_NEAR(exp(murk_free_highest(&f.key[0])), 1e6, 1e-6);
    CHECK_NEAR(exp(murk_free_lowest(&f.key[0])) * 1e9, 2, 1e-12);
    CHECK(murk_free_lowest(&f.key[1]) == 1 &&
          murk_free_highest(&f.key[1]) == 9);
    murk_fit_search_release(&f.search);
}

static struct {
    int calls, iteration;
    size_t start, traces;
    double chi2, value;
} reported;

static void tell(void *context, size_t start, size_t traces, int iteration,
                 double chi2, const double *value)
{
    (void)context;
    ++reported.calls;
    reported.start = start;
    reported.traces = traces;
    reported.iteration = iteration;
    reported.chi2 = chi2;
    reported.value = value[0];
}

/* Steps that succeed are told, with chi2, which is twice the cost, and values;
 * each step counts. A search ends where less than half of the light is left,
 * after a step that succeeds, and not while it scouts. */
static void test_steps_are_reported(void)
{
    fit f;
    make(&f);
    f.search.start = 4;
    f.search.traces = 7;
    f.search.share = .51;
    const double x[] = {log(2), 3, 0};
    murk_least_squares_step step = {
        .iteration = 6, .is_successful = true, .cost = 5, .x = x};
    const murk_least_squares p = murk_fit_problem(&f.search);
    CHECK(p.n == KEYS && p.rows == 3);
    CHECK(p.watch(p.context, &step)); /* nobody listens */
    f.desc.watch = tell;
    CHECK(p.watch(p.context, &step));
    CHECK(reported.calls == 1 && reported.start == 4 && reported.traces == 7 &&
          reported.iteration == 6 && reported.chi2 == 10);
    CHECK_NEAR(reported.value, 2, 1e-15);
    step.is_successful = false;
    f.search.share = .49;
    CHECK(p.watch(p.context, &step));
    CHECK(reported.calls == 1 && !f.search.is_undersampled);
    f.search.is_scouting = true;
    step.is_successful = true;
    CHECK(p.watch(p.context, &step));
    CHECK(reported.calls == 2 && !f.search.is_undersampled);
    f.search.is_scouting = false;
    CHECK(!p.watch(p.context, &step));
    CHECK(f.search.is_undersampled && f.search.iterations == 5);
    murk_fit_search_release(&f.search);
}

/* Where a leap from x ends along key k, with the model's best place at `to`. */
static double leap(fit *f, size_t k, double from, double to)
{
    double x[KEYS] = {log(2), 3, 0};
    double *residual = f->search.residual, *jacobian = f->search.jacobian;
    x[k] = from;
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < KEYS; ++j) {
            jacobian[i * KEYS + j] = i == j ? -2 : 0;
        }
        residual[i] = i == k ? 2 * (to - from) - .5 : -.5;
        f->search.offset[i] = .5; /* on top of the residuals */
    }
    murk_error err = {0};
    CHECK(murk_fit_leap(&f->search, x, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    for (size_t j = 0; j < KEYS;
         ++j) { /* the others are where they should be */
        CHECK_NEAR(j == k ? 0
                          : x[j] - (j == 0   ? log(2)
                                    : j == 1 ? 3
                                             : 0),
                   0, 1e-9);
    }
    return x[k];
}

/* To the model's best place, but by no more than a factor of 3, or half of the
 * width of bounds, and not beyond the bounds: where there are none, all the
 * way. */
static void test_leaps_have_an_end(void)
{
    fit f;
    make(&f);
    CHECK_NEAR(leap(&f, 0, 1, 1.5), 1.5, 1e-9);
    CHECK_NEAR(leap(&f, 0, 1, 9), 1 + log(3), 1e-9);
    CHECK_NEAR(leap(&f, 0, 1, -9), 1 - log(3), 1e-9);
    CHECK_NEAR(leap(&f, 0, log(1e6) - .5, 30), log(1e6), 1e-9);
    CHECK_NEAR(leap(&f, 1, 2, 2.5), 2.5, 1e-9);
    CHECK_NEAR(leap(&f, 1, 2, 100), 6, 1e-9);
    CHECK_NEAR(leap(&f, 1, 8, -100), 4, 1e-9);
    CHECK_NEAR(leap(&f, 1, 2, -100), 1, 1e-9);
    CHECK_NEAR(leap(&f, 2, 0, 100), 100, 1e-6);
    f.search.lower[2] = 0; /* one end is none */
    CHECK_NEAR(leap(&f, 2, 50, 100), 100, 1e-6);
    CHECK_NEAR(leap(&f, 2, 50, -100), 0, 1e-6);
    murk_fit_search_release(&f.search);
}

int main(void)
{
    test_rows_that_are_fitted();
    test_residuals_and_slopes();
    test_coordinates();
    test_steps_are_reported();
    test_leaps_have_an_end();
    return check_done();
}
