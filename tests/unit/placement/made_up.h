/* Made-up placement problems with known answers by brute force. */
#ifndef MURK_TESTS_MADE_UP_H
#define MURK_TESTS_MADE_UP_H

#include "base/rng.h"
#include "placement/dose.h"
#include "placement/place.h"

#include <stdlib.h>

typedef struct made_up {
    murk_problem problem;
    uint16_t *clarity; /* [candidates][photons] */
    uint32_t *weight;
    uint32_t *photon; /* [threads][photons] scratch for looks */
    uint16_t *seen_clarity;
    bool is_binary;
} made_up;

static void made_up_row(void *context, unsigned worker, size_t candidate,
                        murk_sparse_row *row)
{
    const made_up *m = context;
    const size_t n = m->problem.photons;
    uint32_t *photon = m->photon + worker * n;
    uint16_t *clarity = m->seen_clarity + worker * n;
    size_t seen = 0;
    for (size_t i = 0; i < n; ++i) {
        if (m->clarity[candidate * n + i] > 0) {
            photon[seen] = (uint32_t)i;
            clarity[seen++] = m->clarity[candidate * n + i];
        }
    }
    *row = (murk_sparse_row){seen, photon, m->is_binary ? NULL : clarity};
}

/* Makes a random problem. share: fraction of all pairs that are seen;
 * levels: number of distinct clarities (1: all clear); weights: number of
 * distinct weights. */
static made_up *made_up_create(uint32_t seed, size_t photons, size_t candidates,
                               double share, uint32_t levels, uint32_t weights,
                               unsigned threads)
{
    /* Allocate the coverage of all candidates, the weights, and a scratch
     * row for each thread. */
    made_up *m = calloc(1, sizeof *m);
    m->clarity = calloc(photons * candidates + 1, sizeof *m->clarity);
    m->weight = calloc(photons + 1, sizeof *m->weight);
    m->photon = calloc(photons * threads + 1, sizeof *m->photon);
    m->seen_clarity = calloc(photons * threads + 1, sizeof *m->seen_clarity);
    m->is_binary = levels == 1;
    /* Draw the seen pairs, each with one of the clarity levels. */
    for (size_t j = 0; j < candidates; ++j) {
        for (size_t i = 0; i < photons; ++i) {
            uint32_t word[4];
            murk_random_words(seed, MURK_TEST, i, (uint32_t)j, 0, word);
            if (word[0] < share * 0x1p32) {
                m->clarity[j * photons + i] =
                    (uint16_t)(MURK_CLEAR / levels * (1 + word[1] % levels));
            }
        }
    }
    /* Draw the weights. */
    for (size_t i = 0; i < photons; ++i) {
        uint32_t word[4];
        murk_random_words(seed, MURK_TEST, i, 0, 1, word);
        m->weight[i] = 3 * (1 + word[0] % weights);
    }
    m->problem = (murk_problem){.photons = photons,
                                .candidates = candidates,
                                .weight = m->weight,
                                .get_row = made_up_row,
                                .context = m,
                                .threads = threads};
    return m;
}

static void made_up_destroy(made_up *m)
{
    free(m->clarity);
    free(m->weight);
    free(m->photon);
    free(m->seen_clarity);
    free(m);
}

/* The k largest of clarity[n] added up, which it sorts. */
static uint64_t made_up_largest(uint16_t *clarity, size_t n, size_t k)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < k && i < n; ++i) {
        size_t at = i;
        for (size_t j = i + 1; j < n; ++j) {
            at = clarity[j] > clarity[at] ? j : at;
        }
        sum += clarity[at];
        clarity[at] = clarity[i];
    }
    return sum;
}

static const murk_doses *made_up_doses(void)
{
    static murk_doses doses;
    if (doses.of[MURK_CLEAR] == 0) {
        murk_doses_fill(&doses);
    }
    return &doses;
}

#define MADE_UP_SENSORS 64

static uint64_t made_up_value(const made_up *m, const size_t *plan, size_t n)
{
    const murk_doses *doses = made_up_doses();
    const bool is_chance = m->problem.combining == MURK_COMBINE_INDEPENDENT;
    uint64_t sum = 0;
    for (size_t i = 0; i < m->problem.photons; ++i) {
        uint16_t clarity[MADE_UP_SENSORS];
        uint32_t dose = 0;
        for (size_t k = 0; k < n; ++k) {
            clarity[k] = m->clarity[plan[k] * m->problem.photons + i];
            dose = murk_dose_add(dose, doses->of[clarity[k]]);
        }
        sum += m->weight[i] *
               (is_chance ? murk_dose_worth(doses, dose)
                          : made_up_largest(clarity, n,
                                            murk_problem_layers(&m->problem)));
    }
    return sum;
}

/* What rounding may take from a promise. */
static inline uint64_t made_up_rounding(const made_up *m)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < m->problem.photons; ++i) {
        sum += m->weight[i];
    }
    return m->problem.combining == MURK_COMBINE_INDEPENDENT
               ? MURK_WORTH_SLACK * sum
               : 0;
}

/* The best of all plans of n, by trying each. */
static inline uint64_t made_up_optimum(const made_up *m, size_t n)
{
    size_t plan[8];
    uint64_t best = 0;
    for (size_t k = 0; k < n; ++k) {
        plan[k] = k;
    }
    for (;;) {
        const uint64_t value = made_up_value(m, plan, n);
        best = value > best ? value : best;
        size_t k = n;
        while (k > 0 && plan[k - 1] == m->problem.candidates - n + k - 1) {
            --k;
        }
        if (k == 0) {
            return best;
        }
        ++plan[k - 1];
        for (; k < n; ++k) {
            plan[k] = plan[k - 1] + 1;
        }
    }
}

#endif
