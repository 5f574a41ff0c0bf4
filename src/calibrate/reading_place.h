/* Where and how a reading was taken. Private to measurements. */
#ifndef MURK_CALIBRATE_READING_PLACE_H
#define MURK_CALIBRATE_READING_PLACE_H

#include "calibrate/reading_cells.h"

/* Position, band, acceptance and what its kind has: a sensor, a sphere or a
 * segment; all of it within the domain. out->kind is set. */
murk_status murk_reading_place(murk_reading *out, const murk_reading_row *at);

#endif
