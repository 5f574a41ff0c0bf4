/* The JSON of one photon that is traced again: `events` of murk replay. */
#ifndef MURK_RESULTS_REPLAY_H
#define MURK_RESULTS_REPLAY_H

#include "results/json.h"
#include "world/stage.h"

/* Traces the photon of this number again. *out: the first keys of a main JSON,
 * `photon`, and `events` in the order along the path; the caller deletes it, or
 * hands it to murk_session_finish(). Fails with MURK_BAD_VALUE, at the place
 * "photon", if the scene emits no photon of this number, or with
 * MURK_NO_MEMORY. */
murk_status murk_replay_json(cJSON **out, const murk_stage *stage,
                             uint64_t photon, murk_error *err);

#endif
