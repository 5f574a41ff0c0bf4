/* Checks that the contents of a light.murk, or of parts of a run, can have been
 * written by a run of this scene. Checksums show that a file is undamaged, not
 * that the contents are possible. */
#ifndef MURK_LIGHTMAP_STORE_CHECK_H
#define MURK_LIGHTMAP_STORE_CHECK_H

#include "photonmap/photon.h"
#include "world/stage.h"

#include <stdint.h>

/* Fails with MURK_BAD_FILE at `path` if a count, a power or an amount of energy
 * cannot result from a run of this scene with `emitted` photons, or with
 * MURK_NO_MEMORY. cell[] are the sums of the ledger (murk_ledger_read()), and
 * packet_w[channels] the powers of the packets. */
murk_status murk_lightmap_check_ledger(const int64_t *cell, uint64_t emitted,
                                       const double *packet_w,
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
