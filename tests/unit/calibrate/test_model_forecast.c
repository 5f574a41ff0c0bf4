/* Memory of fits, as foretold from few photons, against what is in use. The
 * one check by chance cries wolf once in a million seeds, and the seed is
 * fixed. */
#include "base/interrupt.h"
#include "base/stats.h"
#include "calibrate/model_parts.h"
#include "check.h"
#include "planted.h"

#include <malloc.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define BUDGET 1e-6

/* Sanitizers have heaps of their own, which mallinfo2() does not know. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define KNOWS_HEAP false
#else
#define KNOWS_HEAP true
#endif

/* Heads of blocks, and structs of fixed size, of one condition: less than any
 * part of what is foretold for coverage, the least of which is 9 bytes for each
 * of 3000 contributions. */
#define FIXED_BYTES 12000

static double bytes_in_use(void)
{
    const struct mallinfo2 info = mallinfo2();
    return (double)info.uordblks + (double)info.hblkhd;
}

/* A model that is lit and read with slopes, and what was foretold of it. */
typedef struct foretelling {
    planted_field field;
    murk_free_keys *keys;
    murk_model *model;
    murk_fit_forecast forecast;
    double contributions;   /* that there were, */
    double square, photons; /* of each photon's, and photons */
    double given_back;      /* by darkening */
} foretelling;

static bool light(foretelling *f, double *workspace)
{
    const size_t n = f->keys->n, rows = f->field.measured->rows;
    double value[PLANTED_KEYS_MAX], share;
    murk_error err = {0};
    for (size_t k = 0; k < n; ++k) {
        value[k] = f->keys->key[k].start;
    }
    return planted_held(murk_model_trace(f->model, value, &err), &err) &&
           planted_held(murk_model_predict(f->model, value, workspace,
                                           workspace + rows, &share, &err),
                        &err);
}

static void count(foretelling *f)
{
    for (size_t c = 0; c < f->model->worlds; ++c) {
        const murk_histories *lit = f->model->world[c].lighting.histories;
        if (!lit) {
            continue;
        }
        f->contributions += (double)lit->n;
        f->photons += (double)lit->emitted;
        for (size_t i = 0, first = 0; i <= lit->n; ++i) {
            if (i == lit->n || lit->contribution[i].photon !=
                                   lit->contribution[first].photon) {
                f->square += (double)((i - first) * (i - first));
                first = i;
            }
        }
    }
}

static void darken(foretelling *f)
{
    const double before = bytes_in_use();
    for (size_t c = 0; c < f->model->worlds; ++c) {
        murk_lighting_darken(&f->model->world[c].lighting);
        murk_reweighed_release(&f->model->world[c].rows.reweighed);
    }
    f->given_back = before - bytes_in_use();
}

static bool foretell(foretelling *f, const planted_case *of, unsigned emit)
{
    *f = (foretelling){0};
    bool is_well = planted_open(&f->field, of);
    f->keys = is_well ? planted_keys(&f->field, emit, 1) : NULL;
    f->model = f->keys ? planted_model(&f->field, f->keys) : NULL;
    double *workspace = f->model ? calloc(f->field.measured->rows * (of->n + 1),
                                          sizeof *workspace)
                                 : NULL;
    murk_error err = {0};
    is_well = workspace && light(f, workspace);
    free(workspace);
    if (is_well) {
        count(f);
        darken(f);
        is_well = planted_held(
            murk_model_forecast(&f->forecast, f->model, &err), &err);
    }
    CHECK(is_well);
    return is_well;
}

static void release(foretelling *f)
{
    murk_model_destroy(f->model);
    murk_free_keys_destroy(f->keys);
    planted_close(&f->field);
}

static const planted_case *const CASES[] = {&planted_fog, &planted_smoke,
                                            &planted_coverage};
#define N_CASES (sizeof CASES / sizeof *CASES)

/* From all photons there is nothing to guess. */
static void test_bytes_are_those_in_use(void)
{
    for (size_t i = 0; i < N_CASES; ++i) {
        foretelling f;
        if (foretell(&f, CASES[i], MURK_FIT_FORECAST_FROM)) {
            const double beside = f.given_back - f.forecast.light_bytes;
            CHECK(f.forecast.contributions == f.contributions);
            CHECK(f.forecast.bytes > f.forecast.light_bytes);
            CHECK(f.model->facts.memory_bytes == f.forecast.bytes);
            CHECK(!KNOWS_HEAP ||
                  (beside >= 0 &&
                   beside < FIXED_BYTES * (double)f.model->worlds));
        }
        release(&f);
    }
}

/* The pilot's photons are the first of all: off is three times their sum less
 * that of the three quarters that follow. */
static void test_more_photons_are_guessed(void)
{
    for (size_t i = 0; i < N_CASES; ++i) {
        foretelling f;
        if (foretell(&f, CASES[i], 4 * MURK_FIT_FORECAST_FROM)) {
            const double mean = f.contributions / f.photons;
            const double variance = f.square / f.photons - mean * mean;
            const double sigma = sqrt((9. / 4 + 3. / 4) * f.photons * variance);
            const double limit = murk_sidak_limit(BUDGET, N_CASES) * sigma;
            CHECK(fabs(f.forecast.contributions - f.contributions) < limit);
            /* teeth: as if there were no more photons */
            CHECK(fabs(f.forecast.contributions / 4 - f.contributions) > limit);
        }
        release(&f);
    }
}

static void test_what_cannot_fit_is_refused_at_once(void)
{
    planted_field field;
    CHECK(planted_open(&field, &planted_coverage));
    murk_free_keys *keys = planted_keys(&field, 4000000000U, 1);
    murk_model *model = keys ? planted_model(&field, keys) : NULL;
    CHECK(model);
    if (model) {
        murk_error err = {0};
        const double value = keys->key[0].start;
        CHECK(murk_model_trace(model, &value, &err) == MURK_BAD_VALUE);
        CHECK(strstr(err.text, "the fit would keep about 5."));
        CHECK(strstr(err.text, "GB that are free: fewer photons"));
        CHECK(model->facts.traces == 0);
    }
    murk_model_destroy(model);
    murk_free_keys_destroy(keys);
    planted_close(&field);
}

/* Ctrl-C while the pilot is traced ends the fit there, with nothing foretold
 * and no light. Last: the flag stays up. */
static void test_interrupt_in_the_pilot(void)
{
    planted_field field;
    CHECK(planted_open(&field, &planted_coverage));
    murk_free_keys *keys = planted_keys(&field, MURK_FIT_FORECAST_FROM, 1);
    murk_model *model = keys ? planted_model(&field, keys) : NULL;
    foretelling lit; /* its world is there, its light no longer */
    const bool is_lit =
        foretell(&lit, &planted_coverage, MURK_FIT_FORECAST_FROM);
    CHECK(model && is_lit);
    murk_interrupt_request();
    if (model && is_lit) {
        murk_error err = {0};
        const double value = keys->key[0].start;
        CHECK(murk_model_trace(model, &value, &err) == MURK_INTERRUPTED);
        CHECK_TEXT(err.text, "interrupted");
        CHECK(model->facts.traces == 0);
        CHECK(model->facts.memory_bytes == 0);
        err = (murk_error){0};
        CHECK(murk_model_forecast(&lit.forecast, lit.model, &err) ==
              MURK_INTERRUPTED);
        CHECK_TEXT(err.text, "interrupted");
    }
    release(&lit);
    murk_model_destroy(model);
    murk_free_keys_destroy(keys);
    planted_close(&field);
}

int main(void)
{
    /* so that blocks are of their own size, not of whole pages */
    mallopt(M_MMAP_THRESHOLD, 1 << 28);
    test_bytes_are_those_in_use();
    test_more_photons_are_guessed();
    test_what_cannot_fit_is_refused_at_once();
    test_interrupt_in_the_pilot();
    return check_done();
}
