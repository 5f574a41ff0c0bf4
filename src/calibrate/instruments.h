/* The instruments of one condition: the rows of the data as receivers, sensors
 * and beams. */
#ifndef MURK_CALIBRATE_INSTRUMENTS_H
#define MURK_CALIBRATE_INSTRUMENTS_H

#include "base/arena.h"
#include "calibrate/histories.h"
#include "readings/readings.h"

/* Rows that need photons are called light rows; receivers come first, then
 * groups of sensors. */
typedef struct murk_instruments {
    size_t receivers;
    murk_receiver *receiver; /* [receivers] */
    murk_quantity *quantity; /* [receivers]; whether the unit of a receiver
                              * counts watts, lux, photons or PAR */
    size_t groups, poses;
    murk_pose *pose;   /* [poses]; ordered by group */
    size_t *group;     /* [poses] */
    size_t lights;     /* receivers + groups */
    size_t *light_row; /* [lights]; numbers of the rows in the data */
    size_t beams;      /* transmittances and extinctions */
    size_t *beam_row;  /* [beams]; numbers of the rows in the data */
    murk_arena arena;  /* of all arrays */
} murk_instruments;

/* Lists the rows of a condition of the scene (SIZE_MAX: the scene without a
 * condition). Release also after a failure. */
murk_status murk_instruments_create(murk_instruments *out,
                                    const murk_readings *measured,
                                    size_t condition, murk_error *err);
void murk_instruments_release(murk_instruments *instruments);

/* Warns of receivers whose sphere is cut by a surface to more than a hundredth
 * of the radius, the first few by name: the part behind the surface is dark, so
 * the receiver reads low. */
void murk_instruments_warn_of_cut(const murk_instruments *instruments,
                                  const murk_readings *measured,
                                  const murk_surfaces *surfaces);

#endif
