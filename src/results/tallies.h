/* The results of tallies, as files and as lines. */
#ifndef MURK_RESULTS_TALLIES_H
#define MURK_RESULTS_TALLIES_H

#include "results/fields.h"
#include "results/session.h"

/* Adds tallies.csv and, for each grid, NAME.vdb and NAME_error.vdb. Adds
 * nothing if the scene has no tallies, or if the light is from a file; it warns
 * of the latter. Fails as murk_results_add() does. */
murk_status murk_add_tallies(murk_session *session, murk_error *err);

/* Adds light.murk, the resolved scene, ledger.json, and the files of
 * tallies. */
murk_status murk_session_add_all_of_light(murk_session *session,
                                          murk_error *err);

/* Prints the summary of a trace. `of` points to a murk_session. */
void murk_print_trace(const void *of);

/* Adds the files of --export fields for each grid: NAME_photons.vdb and
 * NAME.vti (results/voxel_fields.h). If a file cannot be made, *late has the
 * first reason. */
void murk_add_tally_fields(murk_session *session, murk_error *late);

/* Prints lines of the summary: all values of tallies with at most 4 values, and
 * for others the median relative error of the values above 0. With several
 * bands and at most 4 cells, also the sums over the bands. */
void murk_print_tallies(const murk_session *session);

/* For the command check: adds the tallies of the scene to the JSON, or prints
 * them as lines. */
void murk_json_tallies(cJSON *root, const murk_session *session);
void murk_print_asked_tallies(const murk_session *session);

/* Lists the columns of tallies.csv. `of` points to a struct internal to
 * tallies.c; NULL: the fields are only described (results/fields.h). */
void murk_results_list_tally(murk_results_fields *f, const void *of, size_t i);

#endif
