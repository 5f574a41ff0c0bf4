/* Exchanges the photon histories of a wave between ranks (base/ranks.h), which
 * divide the batches of the wave. */
#ifndef MURK_CALIBRATE_HISTORY_EXCHANGE_H
#define MURK_CALIBRATE_HISTORY_EXCHANGE_H

#include "calibrate/recorder.h"

/* Gives all ranks the histories of the batches of a wave that belong to
 * place[n]: this rank has traced those of which it owns the place in place[]
 * (murk_ranks_owns()), the k-th of them as batch k. Collective. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_recorder_exchange(murk_recorder *recorder, const size_t *place,
                                   size_t n, murk_status status,
                                   murk_error *err);

#endif
