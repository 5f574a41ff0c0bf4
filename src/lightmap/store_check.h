/* Checks that the contents of a light.murk can have been written by a run of
 * this scene. Checksums show that a file is undamaged, not that the contents
 * are possible. */
#ifndef MURK_LIGHTMAP_STORE_CHECK_H
#define MURK_LIGHTMAP_STORE_CHECK_H

#include "lightmap/lightmap.h"

#include <stdint.h>

/* The sections "facts", "packet_w", "ledger" and "absorbed" of a file. */
typedef struct murk_lightmap_numbers {
    uint64_t emitted;                        /* number of photons */
    uint64_t counted, collisions;            /* counts of the ledger */
    const uint64_t *lost_photons;            /* [MURK_LOSSES] */
    const double *packet_w;                  /* [channels] */
    const int64_t *emitted_quanta;           /* [channels] */
    const int64_t *absorbed_surfaces_quanta; /* [channels] */
    const int64_t *absorbed_media_quanta;    /* [channels] */
    const int64_t *escaped_quanta;           /* [channels] */
    const int64_t *lost_quanta;              /* [channels] */
    const int64_t *absorbed; /* [channels][materials, then media] */
} murk_lightmap_numbers;

/* Fails with MURK_BAD_FILE at `path` if a count, a power or an amount of energy
 * cannot result from a run of this scene with that many photons, or with
 * MURK_NO_MEMORY. */
murk_status murk_lightmap_check_numbers(const murk_lightmap_numbers *numbers,
                                        const murk_stage *stage,
                                        const char *path, murk_error *err);

/* Fails with MURK_BAD_FILE at `path` if one of n records cannot belong to the
 * surface map (with is_volume: the volume map) of a run of this scene that
 * emitted that many photons. packet_w[channels] is the power of a photon packet
 * of each channel. */
murk_status murk_lightmap_check_records(const murk_photon *photon, size_t n,
                                        bool is_volume, uint64_t emitted,
                                        const double *packet_w,
                                        const murk_stage *stage,
                                        const char *path, murk_error *err);

#endif
