/* Light followed for re-weighting: what of a path a fit needs, kept beside each
 * contribution that the path makes.
 *
 * A path's probability at other parameters is its own times
 *     prod over scatterings of (sigma_s' / sigma_s) (p'(mu) / p(mu))
 *     times exp(-sum over media (sigma_t' - sigma_t) density path)
 * (Hayakawa, Spanier, Bevilacqua, Dunn, You, Tromberg, Venugopalan, Opt. Lett.
 * 26 (2001) 1335, doi:10.1364/OL.26.001335), so density path and count of
 * scatterings are kept by medium, and the cosines where a phase function is
 * free. A contribution is a receiver's chord or a stored record.
 *
 * The same holds where packets are split instead of put to the roulette
 * (least_weight below 1): what roulette does by chance, a split's weight does,
 * and both times the product is sigma_s. Where albedo is a grid, sigma_s goes
 * by sigma_t alone, as the albedo of the place is the same in both.
 *
 * Contributions are in order of photons, whatever the threads did. */
#ifndef MURK_CALIBRATE_FOLLOWED_H
#define MURK_CALIBRATE_FOLLOWED_H

#include "photonmap/map.h"
#include "world/stage.h"

/* Fluence rate, or irradiance on a side, averaged over a sphere, which must lie
 * in the domain and clear of surfaces: what sticks out of it is dark. */
typedef struct murk_receiver {
    murk_vec3 center;
    double radius_m;
    murk_vec3 normal;  /* unit, outward of the receiving side; zero: fluence
                          rate */
    double min_cosine; /* between the normal and where light comes from: 0
                            takes all of the side, more is an acceptance cone */
    int band;          /* -1: all */
} murk_receiver;

typedef struct murk_followed_desc {
    const murk_stage *stage;
    uint32_t stream;
    uint64_t photons; /* 0: as many as the scene says */
    unsigned threads;
    const size_t *medium; /* [media] whose parts are kept */
    size_t media;
    bool keeps_cosines;
    const murk_receiver *receiver; /* [receivers] */
    size_t receivers;
    bool keeps_records;      /* of the photon maps, as the scene stores them */
    double memory_max_bytes; /* refused beyond; 0: what the machine has */
} murk_followed_desc;

/* Receivers with numbers as high stand for records. */
#define MURK_RECORD_OF_SURFACE UINT32_MAX
#define MURK_RECORD_OF_VOLUME  (UINT32_MAX - 1)

/* One chord or record. */
typedef struct murk_contribution {
    uint32_t photon;   /* emitted index */
    uint32_t receiver; /* or what it is a record of */
    uint32_t first;    /* of its photon's turns */
    uint32_t turns;    /* scatterings before it, of all kept media: its own are
                          turn[first .. first + turns) */
    uint16_t light;
    uint8_t band;
    uint8_t medium; /* records of the volume map: the medium it lies in, as a
                       number of the scene */
    float value; /* chord: length times weight [m], times cosine for irradiance;
                    record: share of a packet that leaves */
} murk_contribution;

static inline bool
murk_contribution_is_record(const murk_contribution *contribution)
{
    return contribution->receiver >= MURK_RECORD_OF_VOLUME;
}

typedef struct murk_followed {
    size_t media, *medium; /* [media] numbers of the scene */
    uint64_t emitted;      /* photons */
    size_t receivers;      /* that were asked for */
    int bands;
    size_t channels;      /* light * bands + band */
    uint64_t *emitted_in; /* [channels] photons */
    double *packet_w;     /* [channels] */
    size_t n;
    murk_contribution *contribution; /* [n] by photon, then along its way */
    float *path_m;   /* [n][media] density path up to it; chords: to where the
                        sphere is entered */
    float *chord_m;  /* [n][media] density path across the chord; records: 0 */
    uint32_t *count; /* [n][media] scatterings up to it; records in a medium
                        count their own */
    size_t turns;    /* 0: no cosines are kept */
    float *turn;     /* [turns] 1 - cosine, which keeps the
                        digits of small angles */
    uint8_t *turn_medium;              /* [turns] index into medium[] */
    murk_photon_map *surface, *volume; /* NULL: none kept. A record's `emitted`
                                          is the number of its contribution */
    double trace_s;
} murk_followed;

/* *out is the caller's: murk_followed_destroy(). Refused: a dark stage, losses
 * of more than the allowed share, more records than the scene allows, and, by
 * forecast from the first photons, more memory than allowed. */
murk_status murk_followed_trace(murk_followed **out,
                                const murk_followed_desc *desc,
                                murk_error *err);
void murk_followed_destroy(murk_followed *followed); /* NULL is fine */

#endif
