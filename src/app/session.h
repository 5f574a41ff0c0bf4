/* What every command does first: scene read, world built, light traced or
 * loaded. */
#ifndef MURK_APP_SESSION_H
#define MURK_APP_SESSION_H

#include "app/options.h"
#include "results/session.h"

/* Silences warnings and progress as the options say. */
void murk_session_quiet(const murk_options *options);

/* The same, and the session's settings, with nothing read yet. */
void murk_session_set(murk_session *session, const murk_options *options);

/* Reads and builds; makes the result folder. End it also after a failure.
 * read: the same without building, for who has other worlds to build; scene:
 * nor a folder yet, for who has more input to judge. */
murk_status murk_session_begin(murk_session *session,
                               const murk_options *options, murk_error *err);
murk_status murk_session_scene(murk_session *session,
                               const murk_options *options, murk_error *err);
murk_status murk_session_read(murk_session *session,
                              const murk_options *options, murk_error *err);
murk_status murk_session_build(murk_session *session, murk_error *err);
murk_status murk_session_light(murk_session *session, murk_error *err);

#endif
