/* What stands in one condition to measure: the rows of the data as receivers,
 * sensors and beams. */
#ifndef MURK_CALIBRATE_INSTRUMENTS_H
#define MURK_CALIBRATE_INSTRUMENTS_H

#include "calibrate/followed.h"
#include "calibrate/measurements.h"

/* Rows that need photons are its lit rows: receivers first, then groups. */
typedef struct murk_instruments {
    size_t receivers;
    murk_receiver *receiver; /* [receivers] */
    murk_quantity *quantity; /* [receivers] that each one's unit is of */
    size_t groups, poses;
    murk_pose *pose; /* [poses] group by group */
    size_t *group;   /* [poses] */
    size_t lit;      /* receivers + groups */
    size_t *lit_row; /* [lit] numbers of the data's rows */
    size_t beams;
    size_t *beam_row; /* [beams] likewise */
} murk_instruments;

/* Of the rows in a condition of the scene (SIZE_MAX: as it stands). Release
 * also after a failure.
 */
murk_status murk_instruments_create(murk_instruments *out,
                                    const murk_measurements *measured,
                                    size_t condition, murk_error *err);
void murk_instruments_release(murk_instruments *instruments);

/* Warns of receivers whose sphere a surface crosses: what lies behind it is
 * dark, so they read low. */
void murk_instruments_warn_of_cut(const murk_instruments *instruments,
                                  const murk_measurements *measured,
                                  const murk_surfaces *surfaces);

#endif
