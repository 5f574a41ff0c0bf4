/* The words of the column `unit`. Private to measurements. */
#ifndef MURK_CALIBRATE_READING_UNITS_H
#define MURK_CALIBRATE_READING_UNITS_H

#include "calibrate/measurements.h"

/* Which kinds of readings a unit is for, by bits of murk_reading_kind. */
unsigned murk_reading_unit_kinds(murk_reading_unit unit);

/* Whether a free factor of readings can have a say: fractions, percents and
 * light; what is per length is no multiple of anything that was read. */
bool murk_reading_unit_takes_gain(murk_reading_unit unit);
bool murk_reading_unit_needs_gain(murk_reading_unit unit,
                                  murk_reading_kind kind);

/* The unit that a word of the file means for a kind; empty: fraction, where the
 * kind has it. Fails at `where`. */
murk_status murk_reading_unit_find(murk_reading_unit *out, const char *word,
                                   murk_reading_kind kind, const char *where,
                                   murk_error *err);

/* Refuses what no instrument reads in that unit: a fraction of 87. */
murk_status murk_reading_unit_check(murk_reading_unit unit, double value,
                                    const char *where, murk_error *err);

/* How the unit compares with a transmittance T over L metres; NULL for those
 * that are read as they stand. */
const char *murk_reading_unit_law(murk_reading_unit unit);

#endif
