/* Writing the results of a handle to a folder, as murk_save_options of the
 * caller say: the frame that all murk_<handle>_save() have in common. */
#ifndef MURK_API_SAVE_H
#define MURK_API_SAVE_H

#include "api/handles.h"

/* A session (results/session.h) that borrows scene and stage of a world. */
murk_session murk_world_session(const murk_world *world);

/* The options as this library knows them: the members that the struct of the
 * caller has, and zeros; NULL, and a struct that murk_save_check_options()
 * refuses: zeros. */
murk_save_options murk_save_known(const murk_save_options *options);

/* Fails as murk_options_copy() if the struct of options is refused. */
murk_status murk_save_check_options(const murk_save_options *options,
                                    murk_error *err);

/* Takes the options of the caller into the settings of a session; NULL: none.
 * The session borrows `folder` and the texts of the options. Fails with
 * MURK_BAD_VALUE if there is no such export, and as murk_options_copy(). */
murk_status murk_save_set(murk_session *session, const char *folder,
                          const murk_save_options *options, murk_error *err);

/* Fails if the settings of a session ask for exports, or for the size of their
 * voxels. of: what has none, "a study". */
murk_status murk_save_without_exports(const murk_session *session,
                                      const char *of, murk_error *err);

/* Checks that the results of a command ("trace", "sense" or "place") on the
 * scene of the session can be written: that the scene allows the command, the
 * exports and, for "place", the repeats (runs; 0: none), and that each result
 * file may replace the file of the same name in the folder. Needs no light, so
 * it is called before light is traced, and again when results are saved. Begins
 * the folder of session->results, which murk_results_end() ends, also after a
 * failure. Fails as murk_results_begin() and murk_results_expect(), and with
 * MURK_BAD_VALUE if the scene does not allow what is asked for. */
murk_status murk_save_check(murk_session *session, const char *command,
                            uint64_t runs, murk_error *err);

/* Sets the identity of the results of a command on the scene of the session.
 * of: further input, as in murk_identity_of(). */
murk_status murk_save_identify(murk_session *session, const char *command,
                               const murk_save_options *options, const char *of,
                               murk_error *err);

/* Refuses to save as murk_call_refuse() does, and leaves *fields NULL. */
murk_status murk_save_refuse(const murk_fields **fields, murk_error *error,
                             const char *text);

/* Makes root, which it takes in any case, the fields of a result that has no
 * scene, and adds `identity` and `files`. of: all input but options->asked;
 * file: the one that was written, or NULL. Fails with MURK_NO_MEMORY. */
murk_status murk_save_alone(murk_fields *fields, cJSON *root,
                            const char *command,
                            const murk_save_options *options, const char *of,
                            const char *file, murk_error *err);

/* Adds the results of a handle to the files of a session, the main JSON last by
 * murk_session_finish(). If an export cannot be made, *late has the error, and
 * the other files are added all the same. */
typedef murk_status murk_save_work(void *of, murk_session *session,
                                   const murk_save_options *options,
                                   murk_error *late, murk_error *err);

/* Writes the results of a handle by save(of, ...), in a session that borrows
 * scene, stage and light of the session `from` of the handle, and ends the
 * call. Makes *saved the fields of the main JSON. Sets *fields to `saved`, or
 * to NULL if no main JSON was made; `fields` may be NULL. Fails as
 * murk_save_set() and save() do, and with the error in *late. */
murk_status murk_save_results(murk_call *call, const murk_session *from,
                              murk_fields *saved, const char *folder,
                              const murk_save_options *options,
                              const murk_fields **fields, murk_save_work *save,
                              void *of);

#endif
