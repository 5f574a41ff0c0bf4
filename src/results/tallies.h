/* What the tallies measured, as files and as lines. */
#ifndef MURK_RESULTS_TALLIES_H
#define MURK_RESULTS_TALLIES_H

#include "results/fields.h"
#include "results/session.h"

/* Adds tallies.csv and, of each grid, NAME.vdb and NAME_error.vdb; nothing
 * where the scene has no tallies or the light came from a file. */
murk_status murk_add_tallies(murk_session *session, murk_error *err);

/* Adds light.murk, the resolved scene, ledger.json and the tallies. */
murk_status murk_session_add_all_of_light(murk_session *session,
                                          murk_error *err);

/* The summary of a trace; of: a murk_session. */
void murk_print_trace(const void *of);

/* Adds the files of --export fields: NAME_photons.vdb and NAME.vti of each grid
 * (results/voxel_fields.h). Files that cannot be had are told in *late. */
void murk_add_tally_fields(murk_session *session, murk_error *late);

/* Summary lines: the values of small tallies, and of large ones how well they
 * are known. */
void murk_print_tallies(const murk_session *session);

/* What check says of them. */
void murk_json_tallies(cJSON *root, const murk_session *session);
void murk_print_asked_tallies(const murk_session *session);

/* Columns of tallies.csv; of: one value of a tally. */
void murk_results_list_tally(murk_results_fields *f, const void *of, size_t i);

#endif
