/* Assigns a slot to each photon: photons of one weight share 64-bit words, so
 * that most sums of weights are bit counts times a weight. A sort of the
 * photons by weight gives the slots. Photon i stays in slot i if there is only
 * one weight, or so many distinct weights that the unused slots would outweigh
 * the gain. */
#include "placement/layout.h"

#include "base/arena.h"
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
    out->is_grouped = true;
    return out->slot;
}

/* The weight of the photons of a word, that of the first one if they have
 * several. Slots of weight 0 may be unused. */
static uint32_t weight_of_word(const murk_layout *l, size_t word)
{
    size_t i = 64 * word;
    while (l->slot && i + 1 < 64 * (word + 1) && l->weight[i] == 0) {
        ++i;
    }
    return l->weight[i];
}

/* True if all photons of a word have the same weight, *weight. Unused slots do
 * not count. */
static bool is_uniform(const murk_layout *l, size_t word, uint32_t *weight)
{
    *weight = weight_of_word(l, word);
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

/* Completes a layout whose slots are assigned, if has_slots is true; fails
 * otherwise, for lack of memory. Takes *l over. */
static murk_status complete(murk_layout *out, murk_layout *l,
                            const murk_problem *problem, bool has_slots,
                            murk_error *err)
{
    /* Detection probabilities need the table of doses. */
    if (has_slots && problem->combining == MURK_COMBINE_INDEPENDENT) {
        l->doses = malloc(sizeof *l->doses);
        has_slots = l->doses;
    }
    l->words = l->slots / 64;
    if (!has_slots || !allocate(l)) {
        murk_layout_release(l);
        return murk_no_memory(err, "", "for the weights of %zu photons",
                              problem->photons);
    }
    if (l->doses) {
        murk_doses_fill(l->doses);
    }
    /* Weights by slot, and the runs of equal weight. */
    set_weights(l, problem->weight);
    find_segments(l);
    *out = *l;
    return MURK_OK;
}

static murk_layout begin(const murk_problem *problem)
{
    return (murk_layout){.photons = problem->photons,
                         .slots = (problem->photons + 63) / 64 * 64,
                         .layers = murk_problem_layers(problem),
                         .kernels = murk_kernels_fastest()};
}

murk_status murk_layout_init(murk_layout *out, const murk_problem *problem,
                             bool regroup, murk_error *err)
{
    murk_layout l = begin(problem);
    bool has_slots = true;
    if (regroup) {
        uint64_t *key = malloc((l.photons + 1) * sizeof *key);
        has_slots = key && assign_slots(&l, problem->weight, key);
        free(key);
    }
    return complete(out, &l, problem, has_slots, err);
}

/* ---- nearly the same photons ---- */

/* Lists the free slots, as weight of the word << 32 | slot, by weight, then by
 * slot; is_taken[words] has a bit for each other slot. weight[slots]: of the
 * photons in the others. Returns their number. */
static size_t list_free(uint64_t *key, const murk_layout *l,
                        const uint64_t *is_taken, const uint32_t *weight)
{
    size_t n = 0;
    for (size_t w = 0; w < l->slots / 64; ++w) {
        const uint64_t taken = is_taken[w];
        const size_t first =
            64 * w + (taken ? (size_t)__builtin_ctzll(taken) : 0);
        const uint64_t of_word = l->is_grouped ? weight[first] : 0;
        for (uint64_t left = ~taken; left; left &= left - 1) {
            const size_t slot = 64 * w + (size_t)__builtin_ctzll(left);
            key[n++] = of_word << 32 | slot;
        }
    }
    murk_sort_uint64(key, n);
    return n;
}

/* Gives n photons, weight << 32 | number by weight, then by number, the free
 * slots of their weight in order, and those that find none new slots; new slots
 * of another weight begin with a new word. */
static void fill_free(murk_layout *l, const uint64_t *added, size_t n,
                      const uint64_t *is_free, size_t n_free)
{
    size_t next = l->slots, k = 0;
    uint64_t last = UINT64_MAX; /* weight of the last new slot */
    for (size_t i = 0; i < n; ++i) {
        const uint64_t weight = added[i] >> 32;
        while (k < n_free && is_free[k] >> 32 < weight) {
            ++k;
        }
        if (k < n_free && is_free[k] >> 32 == weight) {
            l->slot[(uint32_t)added[i]] = (uint32_t)is_free[k++];
            continue;
        }
        next = last == weight ? next : (next + 63) / 64 * 64;
        last = weight;
        l->slot[(uint32_t)added[i]] = (uint32_t)next++;
    }
    l->slots = (next + 63) / 64 * 64;
}

/* Assigns the slots. False when out of memory. */
static bool assign_patched(murk_layout *l, const murk_layout *from,
                           const uint32_t *weight, const uint32_t *earlier)
{
    murk_arena scratch = {0};
    const size_t n = l->photons;
    uint64_t *is_taken =
        murk_arena_array(&scratch, from->words, sizeof *is_taken);
    uint32_t *of_slot = murk_arena_array(&scratch, from->slots, sizeof *weight);
    uint64_t *is_free =
        murk_arena_array(&scratch, from->slots, sizeof *is_free);
    uint64_t *added = murk_arena_array(&scratch, n, sizeof *added);
    l->slot = malloc(n * sizeof *l->slot + 1);
    l->slots = from->slots;
    l->is_grouped = from->is_grouped;
    if (scratch.is_short || !l->slot) {
        murk_arena_release(&scratch);
        return false;
    }
    /* Photons that were there keep their slots. */
    size_t n_added = 0;
    for (uint32_t i = 0; i < n; ++i) {
        if (earlier[i] == MURK_NO_PHOTON) {
            added[n_added++] =
                (uint64_t)(l->is_grouped ? weight[i] : 0) << 32 | i;
            continue;
        }
        const size_t slot = murk_layout_slot(from, earlier[i]);
        l->slot[i] = (uint32_t)slot;
        of_slot[slot] = weight[i];
        is_taken[slot / 64] |= UINT64_C(1) << (slot % 64);
    }
    /* The others fill the gaps. */
    murk_sort_uint64(added, n_added);
    fill_free(l, added, n_added, is_free,
              list_free(is_free, l, is_taken, of_slot));
    l->added = from->added + n_added;
    murk_arena_release(&scratch);
    return true;
}

murk_status murk_layout_patch(murk_layout *out, const murk_problem *problem,
                              const murk_layout *from, const uint32_t *earlier,
                              murk_error *err)
{
    murk_layout l = begin(problem);
    const bool has_slots = assign_patched(&l, from, problem->weight, earlier);
    return complete(out, &l, problem, has_slots, err);
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
