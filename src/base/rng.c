/* Random numbers by Philox4x32-10 of the package Random123 (Salmon et al. 2011,
 * base/rng.h). Seed and purpose are the key of the cipher; photon, event and
 * slot are the counter. */
#include "base/rng.h"

#include <Random123/philox.h>

static inline void words_at(uint32_t seed, uint32_t purpose, uint64_t photon,
                            uint32_t event, uint32_t slot, uint32_t word[4])
{
    const philox4x32_key_t key = {{seed, purpose}};
    const philox4x32_ctr_t counter = {
        {(uint32_t)photon, (uint32_t)(photon >> 32), event, slot}};
    const philox4x32_ctr_t bits = philox4x32(counter, key);
    for (int i = 0; i < 4; ++i) {
        word[i] = bits.v[i];
    }
}

void murk_random_words(uint32_t seed, uint32_t purpose, uint64_t photon,
                       uint32_t event, uint32_t slot, uint32_t word[4])
{
    words_at(seed, purpose, photon, event, slot, word);
}

murk_random4 murk_random(uint32_t seed, uint32_t purpose, uint64_t photon,
                         uint32_t event, uint32_t slot)
{
    uint32_t word[4];
    words_at(seed, purpose, photon, event, slot, word);
    murk_random4 out;
    for (int i = 0; i < 4; ++i) {
        out.u[i] = (word[i] + 0.5) * 0x1p-32; /* mid-bin: never 0 or 1 */
    }
    return out;
}
