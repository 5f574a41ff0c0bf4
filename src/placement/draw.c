#include "placement/draw.h"

#include "base/rng.h"

void murk_draw_begin(uint32_t *shuffle, size_t m)
{
    for (uint32_t j = 0; j < m; ++j) {
        shuffle[j] = j;
    }
}

uint32_t murk_draw_next(uint32_t *shuffle, size_t m, uint32_t k, uint32_t seed,
                        uint64_t restart)
{
    uint32_t word[4];
    murk_random_words(seed, MURK_SPOQ_START, restart, k, 0, word);
    const uint32_t at = k + murk_random_below(word[0], (uint32_t)m - k);
    const uint32_t drawn = shuffle[at];
    shuffle[at] = shuffle[k];
    return drawn;
}

void murk_draw_order(uint32_t *order, size_t n, uint32_t seed, uint64_t restart,
                     uint32_t sweep)
{
    for (uint32_t k = 0; k < n; ++k) {
        order[k] = k;
    }
    for (uint32_t k = 0; k + 1 < n; ++k) {
        uint32_t word[4];
        murk_random_words(seed, MURK_SPOQ_ORDER, restart, sweep, k, word);
        const uint32_t at = k + murk_random_below(word[0], (uint32_t)n - k);
        const uint32_t held = order[at];
        order[at] = order[k];
        order[k] = held;
    }
}
