/* Random numbers addressed by name instead of drawn from a moving state.
 *
 * A number is a pure function of (seed, purpose, photon, event, slot), so the
 * result of a run cannot depend on which thread traced a photon, and any
 * single photon can be replayed alone.
 *
 * Source: Salmon et al., "Parallel random numbers: as easy as 1, 2, 3",
 * SC'11, doi:10.1145/2063384.2063405 (Philox4x32-10). */
#ifndef MURK_BASE_RNG_H
#define MURK_BASE_RNG_H

#include <stdint.h>

/* One purpose for each independent use. Append only, never renumber. The
 * comments state the things whose numbers a use passes to murk_random() as
 * photon, event and slot. The first four purposes belong to the photon tracer.
 * MURK_STREAM * stream is added to these four purposes, and to TARGET, LENS and
 * SHINE, so that, for example, a held-out photon map (stream 1) is independent
 * of the map with which a plan was chosen (stream 0). */
typedef enum murk_purpose {
    MURK_EMIT = 1,
    MURK_FLIGHT,
    MURK_SCATTER,
    MURK_SURFACE,
    MURK_SPOQ_START = 16, /* photon: restart; event: draw */
    MURK_SPOQ_ORDER,      /* photon: restart; event: sweep; slot: position */
    MURK_SPOQ_TIE,        /* photon: restart; event: step */
    MURK_TARGET = 20,     /* photon: draw; event: 0 on surfaces, 1 in the volume
                           */
    MURK_JITTER = 24,     /* photon: draw; event: sensor */
    MURK_LENS = 26,       /* photon: ray of a camera; event 0 */
    MURK_SHINE = 27,      /* photon: ray of a camera; event: event of its
                           * path */
    MURK_FREE_SPACE = 28, /* photon: place; event: number of the box or ball */
    MURK_KERNEL = 29,     /* photon: record; event: kind of record; slot:
                           * band */
    MURK_FIT_START = 30,  /* photon: start; event: parameter */
    MURK_TEST = 31        /* for tests */
} murk_purpose;

#define MURK_STREAM 32u /* above all purposes, so that shifted ones differ */

typedef struct murk_random4 {
    double u[4];
} murk_random4;

/* Four numbers, uniform in the open interval (0, 1), so log(u) is finite. The
 * resolution is 2^-32. `purpose` is a murk_purpose, shifted for other
 * streams. */
murk_random4 murk_random(uint32_t seed, uint32_t purpose, uint64_t photon,
                         uint32_t event, uint32_t slot);

/* The address of a random number without the slot, for callers that draw slot
 * after slot. */
typedef struct murk_address {
    uint32_t seed, purpose;
    uint64_t photon;
    uint32_t event;
} murk_address;

static inline murk_random4 murk_random_at(const murk_address *address,
                                          uint32_t slot)
{
    return murk_random(address->seed, address->purpose, address->photon,
                       address->event, slot);
}

/* The four random words from which murk_random() makes numbers. */
void murk_random_words(uint32_t seed, uint32_t purpose, uint64_t photon,
                       uint32_t event, uint32_t slot, uint32_t word[4]);

/* A whole number in [0, n), n > 0, from one random word. The relative error of
 * each probability is at most n / 2^32. */
static inline uint32_t murk_random_below(uint32_t word, uint32_t n)
{
    return (uint32_t)(((uint64_t)word * n) >> 32);
}

#endif
