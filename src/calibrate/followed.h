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
 * Contributions are in order of photons, whatever the threads did. */
#ifndef MURK_CALIBRATE_FOLLOWED_H
#define MURK_CALIBRATE_FOLLOWED_H

#include "photonmap/map.h"
#include "study/stage.h"

/* Fluence rate, or irradiance on a side, averaged over a sphere. */
typedef struct murk_receiver {
    murk_vec3 center;
    double radius_m;
    murk_vec3 normal;    /* unit, outward of the receiving side; zero: fluence
                            rate */
    double least_cosine; /* between the normal and where light comes from: 0
                            takes all of the side, more is an acceptance cone */
    int band;            /* -1: all */
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
    bool keeps_records;       /* of the photon maps, as the scene stores them */
    double memory_most_bytes; /* refused beyond; 0: what the machine has */
} murk_followed_desc;

/* One chord or record. */
typedef struct murk_contribution {
    uint32_t photon;   /* emitted index */
    uint32_t receiver; /* or UINT32_MAX: a record */
    uint32_t first;    /* of its photon's cosines */
    uint32_t turns;    /* scatterings before it, of all kept media: its cosines
                          are cosine[first .. first + turns) */
    uint16_t light;
    uint8_t band;
    uint8_t medium; /* records of the volume map: the medium it lies in, as a
                       number of the scene */
    float value; /* chord: length times weight [m], times cosine for irradiance;
                    record: share of a packet that leaves */
} murk_contribution;

typedef struct murk_followed {
    size_t media, *medium; /* [media] numbers of the scene */
    uint64_t emitted;      /* photons */
    size_t channels;
    uint64_t *emitted_in; /* [channels] photons */
    double *packet_w;     /* [channels] */
    size_t n;
    murk_contribution *contribution; /* [n] by photon, then along its way */
    float *path_m;   /* [n][media] density path up to it; chords: to where the
                        sphere is entered */
    float *chord_m;  /* [n][media] density path across the chord; records: 0 */
    uint32_t *count; /* [n][media] scatterings up to it; records in a medium
                        count their own */
    size_t cosines;
    float *cosine;                     /* [cosines] 0 where none are kept */
    uint8_t *cosine_medium;            /* [cosines] index into medium[] */
    murk_photon_map *surface, *volume; /* NULL: none kept. A record's `emitted`
                                          is the number of its contribution */
    double trace_s;
} murk_followed;

/* *out is the caller's: murk_followed_destroy(). A photon loop that loses more
 * than the allowed share, or a dark stage, is refused. */
murk_status murk_followed_trace(murk_followed **out,
                                const murk_followed_desc *desc,
                                murk_error *err);
void murk_followed_destroy(murk_followed *followed); /* NULL is fine */

#endif
