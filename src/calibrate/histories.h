/* Photon histories for re-weighting: for each contribution of a path, the
 * properties of the path that determine its probability.
 *
 * The probability of a path at other parameters is that of the traced
 * parameters times
 *
 * product over scatterings of (sigma_s' / sigma_s) (p'(mu) / p(mu)) times
 * exp(-sum over media of (sigma_t' - sigma_t) * density path)
 *
 * (perturbation Monte Carlo: Hayakawa, Spanier, Bevilacqua, Dunn, You,
 * Tromberg, Venugopalan, Opt. Lett. 26 (2001) 1335, doi:10.1364/OL.26.001335).
 * Here sigma_s is the scattering coefficient, sigma_t the extinction
 * coefficient, p the phase function, mu the cosine of the angle of a
 * scattering, and ' marks the other parameters. Density path (the optical depth
 * in a medium of extinction 1) and number of scatterings are therefore stored
 * for each medium that is re-weighted, and the cosines if a phase function is
 * free. A contribution is the chord of a path in a receiver, or a stored
 * record.
 *
 * The same formula holds if packets are weighted instead of absorbed by Russian
 * roulette (least_weight below 1): the factor sigma_s appears in the weight
 * instead of in the probability. If the albedo is a grid, sigma_s scales with
 * sigma_t alone, because the parameters do not change the albedo of a place.
 *
 * Contributions are ordered by photon for any number of threads. */
#ifndef MURK_CALIBRATE_HISTORIES_H
#define MURK_CALIBRATE_HISTORIES_H

#include "photonmap/map.h"
#include "world/stage.h"

/* A spherical receiver of fluence rate, or of irradiance on one side, averaged
 * over the sphere. The sphere must lie in the domain and should be clear of
 * surfaces: the part behind a surface is dark. */
typedef struct murk_receiver {
    murk_vec3 center;
    double radius_m;
    murk_vec3 normal;  /* unit normal of the receiving side; zero: fluence rate
                        */
    double min_cosine; /* smallest cosine of incidence: 0 accepts the whole
                        * side, more is an acceptance cone */
    int band;          /* -1: all bands */
} murk_receiver;

typedef struct murk_histories_desc {
    const murk_stage *stage;
    uint64_t photons; /* 0: the number of the scene */
    unsigned threads;
    const size_t *medium; /* [media]; the media that are re-weighted */
    size_t media;
    bool keeps_cosines;
    const murk_receiver *receiver; /* [receivers] */
    size_t receivers;
    bool keeps_records;      /* store records of the photon maps that the scene
                                asks for */
    double memory_max_bytes; /* fail if the forecast is more; 0: the memory of
                                the machine
                              */
} murk_histories_desc;

/* Receiver numbers that stand for records. */
#define MURK_RECORD_OF_SURFACE UINT32_MAX
#define MURK_RECORD_OF_VOLUME  (UINT32_MAX - 1)

/* One chord or record. */
typedef struct murk_contribution {
    uint32_t photon;   /* number of the emitted photon */
    uint32_t receiver; /* receiver, or kind of record */
    uint32_t first;    /* index in turn[] of the first stored cosine of the
                        * photon */
    uint32_t turns;    /* scatterings before the contribution in all re-weighted
                        * media: their cosines are turn[first .. first +
                        * turns) */
    uint16_t light;
    uint8_t band;
    uint8_t medium; /* record of the volume map: number of the medium in the
                     * scene */
    float value; /* chord: length times weight [m], times cosine for irradiance;
                  * record: share of the power of its packet that the record
                  * gets */
} murk_contribution;

static inline bool
murk_contribution_is_record(const murk_contribution *contribution)
{
    return contribution->receiver >= MURK_RECORD_OF_VOLUME;
}

typedef struct murk_histories {
    size_t media, *medium; /* [media]; numbers of the scene */
    uint64_t emitted;      /* photons */
    size_t receivers;      /* number of receivers */
    int bands;
    size_t channels;      /* light * bands + band */
    uint64_t *emitted_in; /* [channels]; photons */
    double *packet_w;     /* [channels] */
    size_t n;
    murk_contribution *contribution; /* [n]; by photon, then along the path */
    float *path_m;   /* [n][media]; density path before the contribution; for a
                      * chord, to the point of entry */
    float *chord_m;  /* [n][media]; density path across the chord; 0 for records
                      */
    uint32_t *count; /* [n][media]; scatterings before the contribution; a
                      * record in a medium includes its own scattering */
    size_t turns;    /* number of stored cosines; 0 if cosines are not stored */
    float *turn;     /* [turns]; 1 - cosine, which keeps the precision of small
                      * angles */
    uint8_t *turn_medium;              /* [turns]; index into medium[] */
    size_t capacity, turn_capacity;    /* of the arrays above */
    murk_photon_map *surface, *volume; /* NULL: not stored; `emitted` of a
                                        * record is the number of its
                                        * contribution */
    double trace_s;
} murk_histories;

/* Traces light and stores the histories. The caller owns *out
 * (murk_histories_destroy()). Fails with MURK_BAD_VALUE if no light source
 * emits, if more than 2^32 - 1 photons are asked for or if the forecast after a
 * wave of photons exceeds the memory limit. Also fails as murk_ending_check(),
 * murk_emission_check(), murk_emission_run() and murk_emission_check_losses()
 * (lightmap/emission.h), or with MURK_NO_MEMORY. */
murk_status murk_histories_trace(murk_histories **out,
                                 const murk_histories_desc *desc,
                                 murk_error *err);
void murk_histories_destroy(murk_histories *histories); /* NULL is fine */

/* The index of the first contribution whose photon lies in part `part` or a
 * later one; n if none does. The photons are divided into `parts` parts, and
 * photon p is in part p * parts / emitted, rounded down. */
size_t murk_histories_first(const murk_histories *histories, size_t parts,
                            size_t part);

/* Memory of a growing array relative to the content. The old array does not
 * exist beside the new one: the system moves arrays of this size by remapping
 * pages. */
#define MURK_WHILE_GROWING 1.5

/* Memory of n contributions and a number of cosines, in bytes. */
double murk_histories_bytes(size_t media, double n, double turns);

/* For the recorder. reserve: ensures capacity for further contributions and
 * cosines; false if out of memory. fit: gives unused capacity back. release:
 * frees all arrays. */
bool murk_histories_reserve(murk_histories *histories, size_t more,
                            size_t more_turns);
void murk_histories_fit(murk_histories *histories);
void murk_histories_release(murk_histories *histories);

#endif
