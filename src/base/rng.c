/* Random numbers addressed by name: the words of Philox4x32-10 (base/philox.h),
 * Salmon et al. 2011, and the numbers between 0 and 1 that are made of them. */
#include "base/rng.h"

#include "base/philox.h"

void murk_random_words(uint32_t seed, uint32_t purpose, uint64_t photon,
                       uint32_t event, uint32_t slot, uint32_t word[4])
{
    murk_philox(seed, purpose, (uint32_t)photon, (uint32_t)(photon >> 32),
                event, slot, word);
}

murk_random4 murk_random(uint32_t seed, uint32_t purpose, uint64_t photon,
                         uint32_t event, uint32_t slot)
{
    uint32_t word[4];
    murk_random_words(seed, purpose, photon, event, slot, word);
    murk_random4 out;
    for (int i = 0; i < 4; ++i) {
        out.u[i] = murk_uniform(word[i]);
    }
    return out;
}
