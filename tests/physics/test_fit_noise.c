/* What a fit says of its photons' noise is what other photons show: values and
 * slopes of the rows of light spread from light to light as the runs of each
 * one's photons say, together too, and are off of the truth by what their
 * covariance allows. Limits share a chance of 1e-6 of a false alarm. */
#include "base/log.h"
#include "base/stats.h"
#include "check.h"
#include "fit/whitening.h"
#include "planted.h"

#include <stdlib.h>

#define BUDGET 1e-6
#define LIGHTS 80
#define EMIT   30000

/* Sums over lit rows in their measurement errors: of values, and of slopes by
 * each key; as predicted, and their covariance by runs of photons. */
typedef struct sums {
    double of[1 + PLANTED_KEYS_MAX];
    double covariance[1 + PLANTED_KEYS_MAX][1 + PLANTED_KEYS_MAX];
} sums;

typedef struct parts {
    size_t runs, lits, width;
    double *part;
} parts;

static void check_parts_add_up(const parts *p, const size_t *lit,
                               const double *predicted, const double *slope)
{
    const size_t n = p->width - 1;
    for (size_t i = 0; i < p->lits; ++i) {
        for (size_t k = 0; k < p->width; ++k) {
            double sum = 0, size = 0;
            for (size_t run = 0; run < p->runs; ++run) {
                const double x = p->part[(run * p->lits + i) * p->width + k];
                sum += x;
                size += fabs(x);
            }
            const double whole =
                k == 0 ? predicted[lit[i]] : slope[lit[i] * n + k - 1];
            CHECK_NEAR(sum, whole, 1e-11 * (size + fabs(whole)));
        }
    }
}

static void add_up(sums *out, const parts *p, const double *weight)
{
    double run_sum[1 + PLANTED_KEYS_MAX];
    *out = (sums){.of = {0}};
    for (int pass = 0; pass < 2; ++pass) {
        for (size_t run = 0; run < p->runs; ++run) {
            for (size_t k = 0; k < p->width; ++k) {
                run_sum[k] = pass ? -out->of[k] / (double)p->runs : 0;
                for (size_t i = 0; i < p->lits; ++i) {
                    run_sum[k] +=
                        weight[i] * p->part[(run * p->lits + i) * p->width + k];
                }
            }
            for (size_t k = 0; k < p->width; ++k) {
                out->of[k] += pass ? 0 : run_sum[k];
                for (size_t j = 0; j < p->width; ++j) {
                    out->covariance[k][j] += pass ? run_sum[k] * run_sum[j] *
                                                        (double)p->runs /
                                                        ((double)p->runs - 1)
                                                  : 0;
                }
            }
        }
    }
}

/* Traces light once: sums over the lit rows, and d^T C^-1 d with the
 * deviation d from the truth and the covariance C. */
static bool light_once(sums *out, double *square, planted_field *field,
                       unsigned emit, uint32_t seed)
{
    /* Trace the model at the true values with this seed, and predict the
     * readings, their slopes, and their parts by runs of photons. */
    const size_t rows = field->measured->rows, n = field->of->n;
    murk_free_keys *keys = planted_keys(field, emit, seed);
    murk_model *model = keys ? planted_model(field, keys) : NULL;
    double *predicted = calloc(rows * (n + 3), sizeof *predicted), share;
    double *slope = predicted + rows, *weight = slope + rows * n;
    double *off = weight + rows, *covariance = NULL;
    parts p = {.width = n + 1};
    murk_whitening *whitening = NULL;
    murk_error err = {0};
    bool is_well =
        model && predicted &&
        planted_held(murk_model_trace(model, field->of->truth, &err), &err) &&
        planted_held(murk_model_predict(model, field->of->truth, predicted,
                                        slope, &share, &err),
                     &err) &&
        planted_held(murk_model_parts(model, &p.part, &err), &err) &&
        planted_held(murk_model_noise(model, &covariance, &err), &err) &&
        planted_held(murk_whitening_create(&whitening, covariance,
                                           murk_model_facts_of(model)->lights,
                                           &err),
                     &err);
    const size_t *lit = is_well ? murk_model_facts_of(model)->light : NULL;
    p.lits = is_well ? murk_model_facts_of(model)->lights : 0;
    p.runs = is_well ? murk_model_facts_of(model)->runs : 0;
    /* Deviations from the truth; weights by the measurement errors. */
    for (size_t i = 0; i < p.lits && is_well; ++i) {
        const murk_reading_row *row = &field->measured->row[lit[i]];
        weight[i] = 1 / field->measured->reading[row->first].standard_error;
        off[i] = predicted[lit[i]] - field->truth[lit[i]];
    }
    /* Sums by runs, and the square of the whitened deviations per row. */
    *square = 0;
    if (is_well) {
        if (seed == 1) {
            check_parts_add_up(&p, lit, predicted, slope);
        }
        add_up(out, &p, weight);
        murk_whitening_apply(whitening, off, 1);
        for (size_t i = 0; i < p.lits; ++i) {
            *square += off[i] * off[i] / (double)p.lits;
        }
    }
    murk_whitening_destroy(whitening);
    free(covariance);
    free(p.part);
    free(predicted);
    murk_model_destroy(model);
    murk_free_keys_destroy(keys);
    return is_well;
}

/* Over lights: the spread of sums against the mean of what their runs said. */
static void check_spread(const sums *s, size_t width)
{
    const double limit = murk_sidak_limit(BUDGET, (double)(width * width + 1));
    double mean[1 + PLANTED_KEYS_MAX] = {0};
    double seen[1 + PLANTED_KEYS_MAX][1 + PLANTED_KEYS_MAX] = {{0}};
    double said[1 + PLANTED_KEYS_MAX][1 + PLANTED_KEYS_MAX] = {{0}};
    for (size_t i = 0; i < LIGHTS; ++i) {
        for (size_t k = 0; k < width; ++k) {
            mean[k] += s[i].of[k] / LIGHTS;
        }
    }
    for (size_t i = 0; i < LIGHTS; ++i) {
        for (size_t k = 0; k < width * width; ++k) {
            const size_t a = k / width, b = k % width;
            seen[a][b] +=
                (s[i].of[a] - mean[a]) * (s[i].of[b] - mean[b]) / (LIGHTS - 1);
            said[a][b] += s[i].covariance[a][b] / LIGHTS;
        }
    }
    /* of normal numbers a covariance is off by sqrt((c_ab^2 + c_aa c_bb) /
     * (n - 1)); what a run says is better known */
    for (size_t a = 0; a < width; ++a) {
        for (size_t b = 0; b <= a; ++b) {
            const double error =
                sqrt((said[a][b] * said[a][b] + said[a][a] * said[b][b]) /
                     (LIGHTS - 1));
            CHECK_WITHIN(limit, seen[a][b], said[a][b], error);
        }
        /* teeth: half the noise, in standard deviations */
        const double error = sqrt(2. / (LIGHTS - 1)) * said[a][a] / 4;
        CHECK(sigmas_off(seen[a][a], said[a][a] / 4, error) > limit);
    }
}

static void test_noise_is_that_between_lights(void)
{
    planted_field field;
    sums *all = calloc(LIGHTS, sizeof *all);
    CHECK(all && planted_open(&field, &planted_smoke) &&
          planted_light(&field, 4, 25 * EMIT, 2));
    double squares = 0;
    bool is_well = all != NULL;
    for (uint32_t i = 0; i < LIGHTS && is_well; ++i) {
        double square;
        is_well = light_once(&all[i], &square, &field, EMIT, i + 1);
        squares += square / LIGHTS;
    }
    CHECK(is_well);
    if (is_well) {
        check_spread(all, field.of->n + 1);
        printf("off of the truth by %.3f of what is said, squared\n", squares);
        /* 16 rows of light each */
        CHECK_WITHIN(murk_sidak_limit(BUDGET, 10), squares, 1,
                     sqrt(2. / (16 * LIGHTS)));
    }
    planted_close(&field);
    free(all);
}

int main(void)
{
    (void)murk_warn_to(NULL);
    test_noise_is_that_between_lights();
    return check_done();
}
