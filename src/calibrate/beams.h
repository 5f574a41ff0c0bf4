/* Transmittance along segments: exact, without photons.
 *
 * The way is straight from one end to the other, in a periodic domain too.
 * Surfaces at its ends do not count: an instrument is mounted to something. */
#ifndef MURK_CALIBRATE_BEAMS_H
#define MURK_CALIBRATE_BEAMS_H

#include "calibrate/measurements.h"
#include "calibrate/optics.h"
#include "world/stage.h"

/* Refuses a segment that a surface stands across (a thin sheet too), that ends
 * in a solid, or on which the index of refraction changes, at the reading's
 * line; and an acceptance where an albedo is a grid. Once a condition. */
murk_status murk_beams_check(const murk_stage *stage,
                             const murk_measurements *measured,
                             size_t condition, murk_error *err);

/* The media of a scene that differs from the stage's in numbers alone, for
 * optical depths. */
typedef struct murk_beams murk_beams;

/* Of `optics` its scene and phase functions count; grids and meshes are the
 * stage's. All are borrowed. *out is the caller's: murk_beams_destroy(). */
murk_status murk_beams_create(murk_beams **out, const murk_stage *stage,
                              const murk_optics *optics, murk_error *err);
void murk_beams_destroy(murk_beams *beams); /* NULL is fine */

/* exp(-optical depth) of a reading, seen as its acceptance says
 * (medium/acceptance.h); all bands: the mean over them. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_beam_transmittance(double *out, const murk_beams *beams,
                                    const murk_reading *reading,
                                    murk_error *err);

#endif
