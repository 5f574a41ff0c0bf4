/* The position of a reading and the properties of the instrument. Internal to
 * measurements. */
#ifndef MURK_CALIBRATE_READING_PLACE_H
#define MURK_CALIBRATE_READING_PLACE_H

#include "calibrate/reading_cells.h"

/* Reads position, band, acceptance, and the properties of the kind of reading:
 * a sensor, a sphere or a segment. Everything must lie in the domain. out->kind
 * must be set. */
murk_status murk_reading_place(murk_reading *out, const murk_reading_row *at);

#endif
