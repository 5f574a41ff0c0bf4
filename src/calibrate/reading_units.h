/* The units of readings: names, ranges and laws. Internal to measurements. */
#ifndef MURK_CALIBRATE_READING_UNITS_H
#define MURK_CALIBRATE_READING_UNITS_H

#include "calibrate/measurements.h"

/* The kinds of readings that a unit is for, as bits of murk_reading_kind. */
unsigned murk_reading_unit_kinds(murk_reading_unit unit);

/* True if a free factor may multiply readings of this unit: fractions, percents
 * and light. A value per length is not proportional to anything that an
 * instrument measured. */
bool murk_reading_unit_takes_gain(murk_reading_unit unit);
bool murk_reading_unit_needs_gain(murk_reading_unit unit,
                                  murk_reading_kind kind);

/* Finds the unit of a word in the file for a kind of reading; an empty word
 * means fraction, if the kind has it. Fails at `where`. */
murk_status murk_reading_unit_find(murk_reading_unit *out, const char *word,
                                   murk_reading_kind kind, const char *where,
                                   murk_error *err);

/* Fails for a value that no instrument reads in that unit, such as a fraction
 * of 87. */
murk_status murk_reading_unit_check(murk_reading_unit unit, double value,
                                    const char *where, murk_error *err);

/* The law that relates the unit to a transmittance T over L metres; NULL for
 * units that are used as they are. */
const char *murk_reading_unit_law(murk_reading_unit unit);

#endif
