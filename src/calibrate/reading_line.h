/* One line of a file of readings. Internal to measurements. */
#ifndef MURK_CALIBRATE_READING_ROW_H
#define MURK_CALIBRATE_READING_ROW_H

#include "calibrate/reading_cells.h"

/* Reads one line. The factor is returned as a name, to be numbered later; both
 * names point into the table. */
murk_status murk_reading_read(murk_reading *out, const char **group,
                              const char **gain,
                              const murk_reading_source *source, size_t row,
                              murk_error *err);

#endif
