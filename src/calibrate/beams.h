/* Transmittance along segments: exact, without photons. */
#ifndef MURK_CALIBRATE_BEAMS_H
#define MURK_CALIBRATE_BEAMS_H

#include "calibrate/measurements.h"
#include "study/stage.h"

/* Refuses a segment that a surface stands across, or on which the index of
 * refraction changes, at the reading's line. Once a condition. */
murk_status murk_beams_check(const murk_stage *stage,
                             const murk_measurements *measured,
                             size_t condition, murk_error *err);

/* The media of a scene that differs from the stage's in scalar keys only, for
 * optical depths; grids are the stage's. *out is the caller's. */
murk_status murk_beams_media(murk_media **out, const murk_stage *stage,
                             const murk_scene *scene, murk_error *err);

/* exp(-optical depth) of a reading, seen as its acceptance says
 * (medium/acceptance.h); all bands: the mean over them. */
murk_status murk_beam_transmittance(double *out, const murk_stage *stage,
                                    const murk_media *media,
                                    const murk_reading *reading,
                                    murk_error *err);

#endif
