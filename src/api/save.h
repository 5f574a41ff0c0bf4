/* Writing the results of a handle to a folder, as murk_save_options of the
 * caller say: the frame that all murk_<handle>_save() have in common. */
#ifndef MURK_API_SAVE_H
#define MURK_API_SAVE_H

#include "api/handles.h"

/* The options as this library knows them: the members that the struct of the
 * caller has, and zeros; NULL: zeros. */
murk_save_options murk_save_known(const murk_save_options *options);

/* Takes the options of the caller into the settings of a session; NULL: none.
 * The session borrows `folder` and the texts of the options. Fails with
 * MURK_BAD_VALUE if there is no such export. */
murk_status murk_save_set(murk_session *session, const char *folder,
                          const murk_save_options *options, murk_error *err);

/* Refuses what the results of a command ("trace", "sense", "place") on the
 * scene of the session cannot be written as, before any light is traced:
 * exports, the number of repeats, and files that may not be replaced. Begins
 * the folder; murk_save_end() ends it, also after a failure. */
murk_status murk_save_check(murk_session *session, const char *command,
                            uint64_t runs, murk_error *err);

/* Sets the identity of the results of a command on the scene of the session. */
murk_status murk_save_identify(murk_session *session, const char *command,
                               const murk_save_options *options,
                               murk_error *err);

/* Ends the folder of a session that borrows scene, stage and light, and ends
 * the call, which failed if status is not MURK_OK. Makes the text of the main
 * JSON, if it was made, the fields *saved, and returns them in *fields, which
 * may be NULL. An export that could not be made, told in *late, is an error
 * although the other files are written. */
murk_status murk_save_end(murk_call *call, murk_session *session,
                          murk_fields *saved, const murk_fields **fields,
                          murk_status status, const murk_error *late);

#endif
