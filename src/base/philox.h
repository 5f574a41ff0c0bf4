/* The words of murk_random() (base/rng.h), and what loops need that draw
 * numbers for several photons at once (transport/lanes_step.c). Philox4x32-10
 * of the package Random123 (Salmon et al. 2011, base/rng.h). Seed and purpose
 * are the key of the cipher; photon, event and slot are the counter. */
#ifndef MURK_BASE_PHILOX_H
#define MURK_BASE_PHILOX_H

#include <Random123/philox.h>
#include <stdint.h>

static inline void murk_philox(uint32_t seed, uint32_t purpose,
                               uint32_t photon_low, uint32_t photon_high,
                               uint32_t event, uint32_t slot, uint32_t word[4])
{
    const philox4x32_key_t key = {{seed, purpose}};
    const philox4x32_ctr_t counter = {{photon_low, photon_high, event, slot}};
    const philox4x32_ctr_t bits = philox4x32(counter, key);
    for (int i = 0; i < 4; ++i) {
        word[i] = bits.v[i];
    }
}

/* The constants of a round, for loops that compute several ciphers at once: the
 * factors of the first and the third word, and what is added to the words of
 * the key. */
#define MURK_PHILOX_ROUNDS   10
#define MURK_PHILOX_FACTOR_A PHILOX_M4x32_0
#define MURK_PHILOX_FACTOR_C PHILOX_M4x32_1
#define MURK_PHILOX_KEY_A    PHILOX_W32_0
#define MURK_PHILOX_KEY_C    PHILOX_W32_1

/* The number in (0, 1) that belongs to a random word, in the middle of its bin
 * of 2^-32: never 0 or 1. */
static inline double murk_uniform(uint32_t word)
{
    return (word + 0.5) * 0x1p-32;
}

#endif
