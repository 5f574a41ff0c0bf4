/* Assigns a slot to each photon: photons of one weight share 64-bit words, so
 * that most sums of weights are bit counts times a weight. A sort of the
 * photons by weight gives the slots. Photon i stays in slot i if there is only
 * one weight, or so many distinct weights that the unused slots would outweigh
 * the gain. */
#include "placement/layout.h"

#include "base/sort.h"

#include <stdlib.h>
#include <string.h>

/* Regrouping may leave at most one slot unused for every four photons. With
 * more distinct weights the longer rows cost more than bit counts save (a
 * choice). */
#define PHOTONS_PER_PADDING 4

uint32_t murk_common_divisor(const uint32_t *weight, size_t n)
{
    uint32_t weight_gcd = 0;
    for (size_t i = 0; i < n && weight_gcd != 1; ++i) {
        uint32_t a = weight_gcd, b = weight[i];
        while (b) {
            const uint32_t rest = a % b;
            a = b;
            b = rest;
        }
        weight_gcd = a;
    }
    return weight_gcd ? weight_gcd : 1;
}

/* Assigns the slots by weight, then by photon, each weight at a new word;
 * photon i keeps slot i if there is only one weight, or if the unused slots
 * would be too many. key[photons] is scratch. False when out of memory. */
static bool assign_slots(murk_layout *out, const uint32_t *weight,
                         uint64_t *key)
{
    const size_t n = out->photons;
    size_t distinct = n > 0;
    for (size_t i = 0; i < n; ++i) {
        key[i] = (uint64_t)weight[i] << 32 | i;
    }
    murk_sort_uint64(key, n);
    for (size_t k = 1; k < n; ++k) {
        distinct += key[k] >> 32 != key[k - 1] >> 32;
    }
    if (distinct < 2 || distinct * 63 > n / PHOTONS_PER_PADDING) {
        return true;
    }
    /* Photons of one weight follow each other. */
    out->slot = malloc(n * sizeof *out->slot);
    size_t next = 0;
    for (size_t k = 0; out->slot && k < n; ++k) {
        const bool is_new = k > 0 && key[k] >> 32 != key[k - 1] >> 32;
        next = is_new ? (next + 63) / 64 * 64 : next;
        out->slot[(uint32_t)key[k]] = (uint32_t)next++;
    }
    out->slots = (next + 63) / 64 * 64;
    return out->slot;
}

/* True if all photons of a word have the same weight, *weight. Unused slots do
 * not count. */
static bool is_uniform(const murk_layout *l, size_t word, uint32_t *weight)
{
    *weight = l->weight[64 * word];
    for (size_t i = 64 * word; i < 64 * (word + 1); ++i) {
        const bool is_padding = !l->slot && i >= l->photons;
        if (l->weight[i] != *weight && !is_padding &&
            !(l->slot && l->weight[i] == 0)) {
            return false;
        }
    }
    return true;
}

static void find_segments(murk_layout *l)
{
    l->segments = 0;
    for (size_t k = 0; k < l->words; ++k) {
        uint32_t weight = 0;
        const bool is_mixed = !is_uniform(l, k, &weight);
        murk_weight_run *last =
            l->segments ? &l->segment[l->segments - 1] : NULL;
        if (last && last->is_mixed == is_mixed &&
            (is_mixed || last->weight == weight)) {
            ++last->words;
        } else {
            l->segment[l->segments++] =
                (murk_weight_run){k, 1, weight, is_mixed};
        }
    }
}

void *murk_aligned_zeros(size_t n)
{
    const size_t size = (n / 64 + 1) * 64;
    void *out = aligned_alloc(64, size);
    if (out) {
        memset(out, 0, size);
    }
    return out;
}

/* Allocates the weights. Unused slots have weight 0. */
static bool allocate(murk_layout *l)
{
    l->weight = murk_aligned_zeros(l->slots * sizeof *l->weight);
    l->segment = malloc((l->words + 1) * sizeof *l->segment);
    return l->weight && l->segment;
}

static void set_weights(murk_layout *l, const uint32_t *weight)
{
    l->whole = 0;
    for (size_t i = 0; i < l->photons; ++i) {
        l->weight[murk_layout_slot(l, (uint32_t)i)] = weight[i];
        l->whole += (uint64_t)weight[i] * MURK_CLEAR * l->layers;
    }
    l->weight_gcd = murk_common_divisor(weight, l->photons);
}

murk_status murk_layout_init(murk_layout *out, const murk_problem *problem,
                             bool regroup, murk_error *err)
{
    const size_t photons = problem->photons;
    murk_layout l = {.photons = photons,
                     .slots = (photons + 63) / 64 * 64,
                     .layers = murk_problem_layers(problem),
                     .kernels = murk_kernels_fastest()};
    murk_status status = MURK_OK;
    if (regroup) {
        uint64_t *key = malloc((photons + 1) * sizeof *key);
        const bool has_slots = key && assign_slots(&l, problem->weight, key);
        free(key);
        if (!has_slots) {
            goto no_memory;
        }
    }
    /* Detection probabilities need the table of doses. */
    if (problem->combining == MURK_COMBINE_INDEPENDENT) {
        l.doses = malloc(sizeof *l.doses);
        if (!l.doses) {
            goto no_memory;
        }
        murk_doses_fill(l.doses);
    }
    /* Weights by slot, and the runs of equal weight. */
    l.words = l.slots / 64;
    if (!allocate(&l)) {
        goto no_memory;
    }
    set_weights(&l, problem->weight);
    find_segments(&l);
    *out = l;
    l = (murk_layout){0};
    goto done;
no_memory:
    status = murk_no_memory(err, "", "for the weights of %zu photons", photons);
done:
    murk_layout_release(&l);
    return status;
}

/* Sets the weight of each segment anew. The segments themselves stay, because
 * stored rows refer to them. If a segment of `from` has one weight above 0, its
 * slots of weight 0 are unused and do not make the segment mixed. */
static void update_segments(murk_layout *l, const murk_layout *from)
{
    for (size_t s = 0; s < from->segments; ++s) {
        const murk_weight_run *old = &from->segment[s];
        const bool has_padding = !old->is_mixed && old->weight > 0;
        const size_t first = 64 * old->first_word;
        const uint32_t weight = l->weight[first];
        bool is_mixed = false;
        for (size_t i = first; i < first + 64 * old->words && !is_mixed; ++i) {
            is_mixed = l->weight[i] != weight &&
                       !(has_padding && from->weight[i] == 0);
        }
        l->segment[s] =
            (murk_weight_run){old->first_word, old->words, weight, is_mixed};
    }
}

murk_status murk_layout_reweigh(murk_layout *out, const murk_layout *from,
                                const uint32_t *weight, murk_error *err)
{
    if (!out->weight) {
        *out = *from;
        out->is_borrowed = true;
        if (!allocate(out)) {
            murk_layout_release(out);
            return murk_no_memory(err, "", "for the weights of %zu photons",
                                  from->photons);
        }
    }
    set_weights(out, weight);
    update_segments(out, from);
    return MURK_OK;
}

void murk_layout_release(murk_layout *layout)
{
    if (!layout->is_borrowed) {
        free(layout->slot);
        free(layout->doses);
    }
    free(layout->weight);
    free(layout->segment);
    *layout = (murk_layout){0};
}
