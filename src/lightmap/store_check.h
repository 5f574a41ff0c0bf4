/* Whether the contents of a light.murk can be what a run of this scene wrote.
 * Checksums say that a file is whole, not that its contents are possible. */
#ifndef MURK_LIGHTMAP_STORE_CHECK_H
#define MURK_LIGHTMAP_STORE_CHECK_H

#include "lightmap/lightmap.h"

#include <stdint.h>

/* The sections "facts", "packet_w", "ledger" and "absorbed" of a file. */
typedef struct murk_lightmap_numbers {
    uint64_t emitted;                        /* photons */
    uint64_t counted, collisions;            /* the ledger's plain counts */
    const uint64_t *lost_photons;            /* [MURK_LOSSES] */
    const double *packet_w;                  /* [channels] */
    const int64_t *emitted_quanta;           /* [channels] */
    const int64_t *absorbed_surfaces_quanta; /* [channels] */
    const int64_t *absorbed_media_quanta;    /* [channels] */
    const int64_t *escaped_quanta;           /* [channels] */
    const int64_t *lost_quanta;              /* [channels] */
    const int64_t *absorbed; /* [channels][materials, then media] */
} murk_lightmap_numbers;

/* MURK_BAD_FILE at `path` where a count, power or amount of energy is none that
 * a run of this scene with so many photons has. */
murk_status murk_lightmap_check_numbers(const murk_lightmap_numbers *numbers,
                                        const murk_stage *stage,
                                        const char *path, murk_error *err);

/* The same for the n records of the surface or the volume map. */
murk_status murk_lightmap_check_records(const murk_photon *photon, size_t n,
                                        bool is_volume, uint64_t emitted,
                                        const double *packet_w,
                                        const murk_stage *stage,
                                        const char *path, murk_error *err);

#endif
