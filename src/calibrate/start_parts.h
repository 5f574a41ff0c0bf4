/* The searches that another process has run: in the file of a part of a fit
 * (murk fit --shard K/N), start 0, on which all other starts depend, and those
 * of the shard; or in another rank (base/ranks.h). For use inside src/calibrate
 * only. */
#ifndef MURK_CALIBRATE_START_PARTS_H
#define MURK_CALIBRATE_START_PARTS_H

#include "calibrate/search_state.h"

/* Fills out->start[] with the searches in the files desc->part[parts], and
 * warns of missing parts. Searches that are in no file stay as they are. Fails
 * with MURK_BAD_FILE for a file that is no part of a fit or is damaged, with
 * MURK_BAD_VALUE for a part of another scene, of other readings, options,
 * number of parts or version of murk, and for searches that differ between
 * parts, or with MURK_NO_MEMORY. */
murk_status murk_start_parts_read(murk_calibration *out,
                                  const murk_fit_search *search,
                                  murk_error *err);

/* Writes the searches of the shard desc->shard that have ended to a file. Fails
 * as murk_map_file_write(). */
murk_status murk_start_part_write(const murk_calibration *found,
                                  const murk_calibration_desc *desc,
                                  const char *path, murk_error *err);

/* Fills out->start[] with the searches that have ended in other ranks.
 * Collective. Fails with MURK_NO_MEMORY, or with the failure of a rank. */
murk_status murk_starts_exchange(murk_calibration *out,
                                 const murk_fit_search *search,
                                 murk_status status, murk_error *err);

#endif
