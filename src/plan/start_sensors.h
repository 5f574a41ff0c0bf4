/* The sensors of the plan at which a search begins, as the file of
 * placement.start_plan has them, and those of them that have drifted. */
#ifndef MURK_PLAN_START_SENSORS_H
#define MURK_PLAN_START_SENSORS_H

#include "sensing/candidates.h"
#include "sensing/sensor.h"
#include "world/stage.h"

typedef struct murk_start_sensors {
    murk_pose *pose; /* [n] in the order of the file */
    size_t n;
    murk_pose *drifted; /* [n_drifted] of them: poses that are candidates,
                         * although they belong to none of the sites */
    size_t n_drifted;
} murk_start_sensors;

/* Reads the file. A sensor that has drifted out of the domain, or behind a
 * surface, so that no straight open line joins it to a usable site, is left
 * out, and a warning tells of it. Without the key there are no sensors. Fails
 * as murk_placement_read_start(). */
murk_status murk_start_sensors_read(murk_start_sensors *out,
                                    const murk_stage *stage,
                                    const murk_candidates *sites,
                                    murk_error *err);
void murk_start_sensors_release(murk_start_sensors *start);

#endif
