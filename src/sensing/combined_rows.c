/* Keeps the `layers` + 1 largest entries of each photon, so that the value
 * without any one sensor is known; or, for detection probabilities, the sum of
 * the doses of each photon (placement/dose.h). */
#include "sensing/combined_rows.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

bool murk_combined_rows_init(murk_combined_rows *out, size_t photons,
                             murk_combining combining, size_t layers)
{
    *out = (murk_combined_rows){.photons = photons,
                                .layers = layers,
                                .capacity = photons,
                                .sensors =
                                    calloc(photons + 1, sizeof *out->sensors)};
    if (combining == MURK_COMBINE_INDEPENDENT) {
        out->dose = calloc(photons + 1, sizeof *out->dose);
        out->doses = malloc(sizeof *out->doses);
        if (out->doses) {
            murk_doses_fill(out->doses);
        }
        return out->sensors && out->dose && out->doses;
    }
    out->clarity = calloc((photons + 1) * (layers + 1), sizeof *out->clarity);
    out->clearest = calloc((photons + 1) * layers, sizeof *out->clearest);
    return out->sensors && out->clarity && out->clearest;
}

void murk_combined_rows_release(murk_combined_rows *combined)
{
    free(combined->sensors);
    free(combined->clarity);
    free(combined->clearest);
    free(combined->dose);
    free(combined->doses);
    *combined = (murk_combined_rows){0};
}

/* Memory for n photons. False when out of memory; the arrays then have memory
 * for v->capacity photons at least. */
static bool resize(murk_combined_rows *v, size_t n)
{
    uint32_t *sensors = realloc(v->sensors, n * sizeof *sensors);
    if (!sensors) {
        return false;
    }
    v->sensors = sensors;
    uint16_t *clarity =
        realloc(v->clarity, n * (v->layers + 1) * sizeof *clarity);
    if (!clarity) {
        return false;
    }
    v->clarity = clarity;
    uint32_t *clearest = realloc(v->clearest, n * v->layers * sizeof *clearest);
    if (!clearest) {
        return false;
    }
    v->clearest = clearest;
    v->capacity = n;
    return true;
}

bool murk_combined_rows_extend(murk_combined_rows *v, size_t photons)
{
    assert(!v->dose && photons >= v->photons);
    const size_t layers = v->layers;
    /* Grow by half, so that all photons are moved only a few times. */
    if (photons > v->capacity) {
        const size_t half_more = v->capacity + v->capacity / 2;
        const size_t n = photons > half_more ? photons : half_more;
        if (!resize(v, n)) {
            return false;
        }
    }
    const size_t first = v->photons, added = photons - first;
    memset(v->sensors + first, 0, added * sizeof *v->sensors);
    memset(v->clarity + first * (layers + 1), 0,
           added * (layers + 1) * sizeof *v->clarity);
    memset(v->clearest + first * layers, 0,
           added * layers * sizeof *v->clearest);
    v->photons = photons;
    return true;
}

/* Inserts an entry among the `layers` + 1 largest ones of a photon, and drops
 * the smallest of them; nothing changes if the entry is not larger than the
 * smallest. */
static void keep_clearest(murk_combined_rows *v, size_t i, uint32_t sensor,
                          uint16_t clarity)
{
    uint16_t *at = v->clarity + i * (v->layers + 1);
    uint32_t *whose = v->clearest + i * v->layers;
    size_t k = v->layers;
    if (clarity <= at[k]) {
        return;
    }
    for (; k > 0 && clarity > at[k - 1]; --k) {
        at[k] = at[k - 1];
        if (k < v->layers) {
            whose[k] = whose[k - 1];
        }
    }
    at[k] = clarity;
    if (k < v->layers) {
        whose[k] = sensor;
    }
}

static uint16_t clarity_at(const murk_sparse_row *row, size_t k)
{
    return row->clarity ? row->clarity[k] : MURK_CLEAR;
}

void murk_combined_rows_add(murk_combined_rows *v, uint32_t sensor,
                            const murk_sparse_row *row)
{
    for (size_t k = 0; k < row->seen; ++k) {
        const uint32_t i = row->photon[k];
        ++v->sensors[i];
        if (v->dose) {
            v->dose[i] += v->doses->of[clarity_at(row, k)];
        } else {
            keep_clearest(v, i, sensor, clarity_at(row, k));
        }
    }
}

static uint16_t worth_of(const murk_combined_rows *v, uint64_t dose)
{
    return murk_dose_worth(v->doses, dose < MURK_DOSE_FULL ? (uint32_t)dose
                                                           : MURK_DOSE_FULL);
}

uint32_t murk_combined_rows_worth(const murk_combined_rows *v, size_t i)
{
    if (v->dose) {
        return worth_of(v, v->dose[i]);
    }
    uint32_t sum = 0;
    for (size_t k = 0; k < v->layers; ++k) {
        sum += v->clarity[i * (v->layers + 1) + k];
    }
    return sum;
}

/* Without one of the `layers` largest entries, entry `layers` + 1 counts
 * instead. */
void murk_combined_rows_only(const murk_combined_rows *v,
                             const uint32_t *weight, uint64_t *only)
{
    for (size_t i = 0; i < v->photons; ++i) {
        const uint16_t *at = v->clarity + i * (v->layers + 1);
        for (size_t k = 0; k < v->layers && at[k] > 0; ++k) {
            only[v->clearest[i * v->layers + k]] +=
                (uint64_t)weight[i] * (uint64_t)(at[k] - at[v->layers]);
        }
    }
}

uint64_t murk_combined_rows_only_of(const murk_combined_rows *v,
                                    const uint32_t *weight,
                                    const murk_sparse_row *row)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < row->seen; ++k) {
        const uint32_t i = row->photon[k];
        const uint64_t others = v->dose[i] - v->doses->of[clarity_at(row, k)];
        sum += (uint64_t)weight[i] *
               (uint64_t)(worth_of(v, v->dose[i]) - worth_of(v, others));
    }
    return sum;
}
