/* The forward model of the example calibrations, of all kinds of rows: its
 * slopes are those of its re-weighted values. Differences are on the same
 * light, so they have no noise, and nothing here could cry wolf by chance. */
#include "base/log.h"
#include "check.h"
#include "planted.h"

#include <stdlib.h>

/* Central differences of fourth order by these steps are off by some 1e-11 of a
 * row's value, and by as much of it in rounding. */
#define STEP  1e-3
#define CLOSE 1e-6

/* d/dvalue[k] of all rows by four predictions; scratch[rows]. */
static bool differ(double *out, double *scratch, murk_model *model,
                   const double *value, size_t n, size_t k, size_t rows)
{
    static const double place[4] = {-2, -1, 1, 2};
    static const double weight[4] = {1. / 12, -8. / 12, 8. / 12, -1. / 12};
    double moved[PLANTED_KEYS_MAX], share;
    const double step = STEP * value[k];
    bool is_well = true;
    memcpy(moved, value, n * sizeof *moved);
    for (size_t i = 0; i < rows; ++i) {
        out[i] = 0;
    }
    for (size_t p = 0; p < 4 && is_well; ++p) {
        murk_error err = {0};
        moved[k] = value[k] + place[p] * step;
        is_well = planted_held(
            murk_model_predict(model, moved, scratch, NULL, &share, &err),
            &err);
        for (size_t i = 0; i < rows && is_well; ++i) {
            out[i] += weight[p] * scratch[i] / step;
        }
    }
    return is_well;
}

/* At some values; `spoil` is what slopes are taken times. Rows that are off. */
static size_t count_off(const planted_field *field, murk_model *model,
                        const double *value, double spoil)
{
    const size_t rows = field->measured->rows, n = field->of->n;
    double *workspace = calloc(rows * (n + 3), sizeof *workspace), share;
    double *predicted = workspace, *slope = workspace + rows,
           *by = slope + rows * n;
    double *work = by + rows;
    murk_error err = {0};
    bool is_well =
        workspace && planted_held(murk_model_predict(model, value, predicted,
                                                     slope, &share, &err),
                                  &err);
    CHECK(is_well && share > 0 && share <= 1);
    size_t off = 0;
    for (size_t k = 0; k < n && is_well; ++k) {
        is_well = differ(by, work, model, value, n, k, rows);
        for (size_t i = 0; i < rows && is_well; ++i) {
            /* against the slope, or the value by the key's own size */
            const double size =
                fabs(by[i]) + fabs(predicted[i] / value[k]) / 10;
            off += !(fabs(spoil * slope[i * n + k] - by[i]) <= CLOSE * size);
        }
    }
    CHECK(is_well);
    free(workspace);
    return off;
}

static void test_slopes_are_those_of_the_values(void)
{
    static const planted_case *const cases[] = {
        &planted_fog, &planted_smoke, &planted_water, &planted_coverage};
    static const unsigned emit[] = {3000, 4000, 6000, 500};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; ++c) {
        planted_field field;
        CHECK(planted_open(&field, cases[c]));
        murk_free_keys *keys = planted_keys(&field, emit[c], 1);
        murk_model *model = keys ? planted_model(&field, keys) : NULL;
        CHECK(model);
        double value[PLANTED_KEYS_MAX];
        murk_error err = {0};
        for (size_t k = 0; model && k < keys->n; ++k) {
            value[k] = keys->key[k].start;
        }
        if (model && planted_held(murk_model_trace(model, value, &err), &err)) {
            CHECK(count_off(&field, model, value, 1) == 0);
            for (size_t k = 0; k < keys->n; ++k) { /* away from the light */
                value[k] *= k % 2 ? .96 : 1.05;
            }
            CHECK(count_off(&field, model, value, 1) == 0);
            /* teeth */
            CHECK(count_off(&field, model, value, 1.00001) >
                  field.measured->rows / 2);
        }
        murk_model_destroy(model);
        murk_free_keys_destroy(keys);
        planted_close(&field);
    }
}

/* A lamp that does not burn in one of the conditions. */
static void test_slope_error_is_of_all_conditions(void)
{
    planted_case lamp = planted_fog;
    lamp.n = 1;
    lamp.key[0] = "lights.0.divergence_deg";
    planted_field field;
    CHECK(planted_open(&field, &lamp));
    murk_free_keys *keys = planted_keys(&field, 3000, 1);
    murk_model *model = keys ? planted_model(&field, keys) : NULL;
    murk_error err = {0};
    CHECK(model && isnan(murk_model_slope_error(model, 0)));
    const double divergence_deg = 2;
    if (model &&
        planted_held(murk_model_trace(model, &divergence_deg, &err), &err)) {
        const double error = murk_model_slope_error(model, 0);
        CHECK(error > 0 && isfinite(error));
    }
    murk_model_destroy(model);
    murk_free_keys_destroy(keys);
    planted_close(&field);
}

int main(void)
{
    (void)murk_warn_to(NULL);
    test_slopes_are_those_of_the_values();
    test_slope_error_is_of_all_conditions();
    return check_done();
}
