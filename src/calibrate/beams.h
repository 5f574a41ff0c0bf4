/* Transmittance along segments and extinction at points, computed exactly and
 * without photons.
 *
 * A segment is straight from one end to the other, in a periodic domain as
 * well. Surfaces that carry the ends do not block the segment, because an
 * instrument is mounted on something: a surface nearer to an end than the step
 * of murk_surfaces_leave() is not met. */
#ifndef MURK_CALIBRATE_BEAMS_H
#define MURK_CALIBRATE_BEAMS_H

#include "calibrate/optics.h"
#include "readings/readings.h"
#include "world/stage.h"

/* Checks the segments and points of the readings of one condition (as in
 * murk_reading.condition). Fails with MURK_BAD_VALUE at the line of a reading
 * if a surface blocks the segment (a thin sheet, too), if the segment ends or
 * the point lies in a solid, or if the index of refraction changes on it; at
 * the medium if the reading has an acceptance angle and an albedo is a grid. */
murk_status murk_beams_check(const murk_stage *stage,
                             const murk_readings *measured, size_t condition,
                             murk_error *err);

/* The media of a scene that differs from the scene of the stage in numbers
 * alone, for optical depths. */
typedef struct murk_beams murk_beams;

/* Creates the media from the scene and the phase functions of `optics`; grids
 * and meshes are those of the stage. Stage and optics are borrowed and must
 * outlive *out. Fails with MURK_NO_MEMORY, and as building media of a scene
 * does. The caller owns *out (murk_beams_destroy()). */
murk_status murk_beams_create(murk_beams **out, const murk_stage *stage,
                              const murk_optics *optics, murk_error *err);
void murk_beams_destroy(murk_beams *beams); /* NULL is fine */

/* The transmittance of a reading, exp(-optical depth), or the extinction
 * coefficient of all media at the point of a reading of extinction, in the unit
 * of the reading. Both are with the acceptance angle of the instrument
 * (medium/rescaled.h), and for a reading of all bands the mean over the bands
 * before it is converted to the unit. Fails with MURK_NO_MEMORY, and with
 * MURK_BAD_VALUE if there is an acceptance angle and an albedo is a grid. */
murk_status murk_beam_read(double *out, const murk_beams *beams,
                           const murk_reading *reading, murk_error *err);

#endif
