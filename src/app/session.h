/* What murk render, which uses folders below the library instead of murk.h,
 * does first: it reads the scene, builds the world, and traces or reads light.
 */
#ifndef MURK_APP_SESSION_H
#define MURK_APP_SESSION_H

#include "app/options.h"
#include "results/session.h"

/* Silences warnings and progress as the options say. */
void murk_session_quiet(const murk_options *options);

/* Sets the settings of a session that has read nothing yet, and calls
 * murk_session_quiet(). */
void murk_session_set(murk_session *session, const murk_options *options);

/* murk_session_scene() sets the session and reads the scene;
 * murk_session_read() does the same and makes the folder of results.
 * murk_session_build() builds the world of a scene that is read, and
 * murk_session_light() traces light or reads it from the file of --light. Call
 * murk_session_end() also after a failure. */
murk_status murk_session_scene(murk_session *session,
                               const murk_options *options, murk_error *err);
murk_status murk_session_read(murk_session *session,
                              const murk_options *options, murk_error *err);
murk_status murk_session_build(murk_session *session, murk_error *err);
murk_status murk_session_light(murk_session *session, murk_error *err);

#endif
