/* Sessions of light handles. */
#ifndef MURK_API_LIGHT_H
#define MURK_API_LIGHT_H

#include "api/handles.h"
#include "results/identity.h"

/* A session (results/session.h) that borrows scene and stage of a world. */
murk_session murk_world_session(const murk_world *world);

/* Begins to write the results of a command to a folder, where files that murk
 * did not write are not replaced. murk_results_end() ends it, also after a
 * failure. */
murk_status murk_session_save_begin(murk_session *session, const char *command,
                                    const char *folder, murk_error *err);

#endif
