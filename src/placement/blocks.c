/* Coverage of each scenario's block of photons: one layout for each block, with
 * the weights of the other blocks set to 0, so that an ordinary gain over such
 * a layout is the gain in that block. */
#include "placement/blocks.h"

#include <stdlib.h>

/* A value below 2^63 times 2^52. */
__extension__ typedef unsigned __int128 wide;

typedef struct gain_task {
    const murk_block_layouts *layouts;
    const murk_cover *cover;
    const uint32_t *candidate;
    uint64_t *gain;
} gain_task;

uint64_t murk_share_units(uint64_t part, uint64_t whole)
{
    return (uint64_t)((wide)part * MURK_SHARE_ONE / whole);
}

uint64_t murk_block_worth(const murk_block_layouts *layouts, size_t c,
                          uint64_t value)
{
    return murk_share_units(value, layouts->unit[c]) + layouts->offset[c];
}

static void gain_of_one(void *context, unsigned worker, uint64_t k)
{
    const gain_task *g = context;
    const size_t n = g->layouts->blocks->n;
    murk_row row;
    const bool has_row = murk_evaluator_own_row(&row, g->layouts->evaluator,
                                                worker, g->candidate[k]);
    for (size_t c = 0; c < n; ++c) {
        g->gain[k * n + c] =
            has_row ? murk_row_gain(&g->layouts->layout[c], &row, g->cover) : 0;
    }
}

void murk_block_gains(const murk_block_layouts *layouts,
                      const murk_cover *cover, const uint32_t *candidate,
                      size_t count, uint64_t *gain)
{
    gain_task g = {layouts, cover, candidate, gain};
    murk_evaluator_run(layouts->evaluator, count, gain_of_one, &g);
    murk_evaluator_complete(layouts->evaluator, gain,
                            count * layouts->blocks->n);
}

/* Makes the layout of one block, and the unit and offset of the block's worth.
 */
static murk_status view_block(murk_block_layouts *v, size_t c, uint32_t *weight,
                              murk_error *err)
{
    const murk_problem *problem = v->evaluator->problem;
    for (size_t i = 0; i < problem->photons; ++i) {
        const bool is_in =
            i >= v->blocks->first[c] && i < v->blocks->first[c + 1];
        weight[i] = is_in ? problem->weight[i] : 0;
    }
    const murk_status status =
        murk_layout_reweigh(&v->layout[c], v->evaluator->layout, weight, err);
    v->whole[c] = v->unit[c] = v->layout[c].whole;
    const uint64_t reference = v->blocks->reference[c];
    if (v->blocks->measure == MURK_BLOCK_REGRET && v->whole[c] > 0) {
        v->offset[c] =
            MURK_SHARE_ONE - murk_share_units(reference, v->whole[c]);
    } else if (v->blocks->measure == MURK_BLOCK_REGRET_RELATIVE) {
        v->unit[c] = reference > 0 ? reference : v->whole[c];
        v->offset[c] = reference > 0 ? 0 : MURK_SHARE_ONE;
    }
    return status || v->whole[c] > 0
               ? status
               : murk_fail(err, MURK_RUN_FAILED, "",
                           "nothing to see in condition %zu", c + 1);
}

static murk_status find_gain_bounds(murk_block_layouts *v, murk_error *err)
{
    const murk_evaluator *o = v->evaluator;
    murk_cover cover = {0};
    uint32_t *all = malloc((o->candidates + 1) * sizeof *all);
    if (!all || !murk_cover_init(&cover, o->layout, o->is_binary)) {
        free(all);
        return murk_no_memory(err, "", "for the coverage of %zu photons",
                              o->layout->photons);
    }
    for (uint32_t j = 0; j < o->candidates; ++j) {
        all[j] = j;
    }
    /* Values of single candidates bound their gains; the value of all is the
     * ceiling. */
    murk_block_gains(v, &cover, all, o->candidates, v->max);
    for (uint32_t j = 0; j < o->candidates; ++j) {
        for (size_t c = 0; o->slack && c < v->blocks->n; ++c) {
            v->max[j * v->blocks->n + c] += o->slack[j];
        }
    }
    const murk_status status = murk_evaluator_cover_all(o, &cover, err);
    for (size_t c = 0; c < v->blocks->n; ++c) {
        v->ceiling[c] = murk_cover_value(&cover, &v->layout[c]);
    }
    murk_cover_release(&cover);
    free(all);
    return status;
}

murk_status murk_block_layouts_init(murk_block_layouts *out,
                                    const murk_evaluator *evaluator,
                                    const murk_blocks *blocks, murk_error *err)
{
    const size_t photons = evaluator->problem->photons;
    *out = (murk_block_layouts){.blocks = blocks, .evaluator = evaluator};
    uint32_t *weight = calloc(photons + 1, sizeof *weight);
    out->max = calloc(evaluator->candidates * blocks->n + 1, sizeof *out->max);
    murk_status status =
        weight && out->max
            ? MURK_OK
            : murk_no_memory(err, "", "for %zu conditions of %zu candidates",
                             blocks->n, evaluator->candidates);
    for (size_t c = 0; !status && c < blocks->n; ++c) {
        status = view_block(out, c, weight, err);
    }
    free(weight);
    return status ? status : find_gain_bounds(out, err);
}

void murk_block_layouts_release(murk_block_layouts *layouts)
{
    for (size_t c = 0; c < MURK_BLOCKS_MAX; ++c) {
        murk_layout_release(&layouts->layout[c]);
    }
    free(layouts->max);
    *layouts = (murk_block_layouts){0};
}
