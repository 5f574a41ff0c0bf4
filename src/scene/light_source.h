/* The files and the power of lamps: photometric files of luminaires, spectra,
 * and arrays of lamps. */
#ifndef MURK_SCENE_LIGHT_SOURCE_H
#define MURK_SCENE_LIGHT_SOURCE_H

#include "scene/walk.h"

#include <stdio.h>

/* Reads the files that a lamp or directional light names, and sets the power
 * per band.
 *
 * A total (power_w, irradiance_w_per_m2) is spread over the bands by the
 * spectrum: by the integral over each band, for bands without edges by the
 * value at each wavelength; evenly without a spectrum. A luminaire without
 * power_w has the lumens of the key, or the integral of the file times the
 * factor of the TILT data. With a spectrum, a luminous flux becomes watts by
 * the integral of the spectrum times V over all wavelengths; for bands without
 * edges the wavelengths of the scene stand for the spectrum. Without a
 * spectrum, 683 lm are one watt, as at 555 nm. Fails with MURK_BAD_VALUE or as
 * the readers of the files do. */
murk_status murk_light_source_read(murk_key_reader *walk, const murk_yaml *map,
                                   murk_scene_light *light);

/* Replaces each light with an array by the lamps of the array, row by row, and
 * each light of type daylight by its parts, patches before places of the sun,
 * in the place of the light. Fails with MURK_BAD_VALUE if there are more than
 * MURK_SCENE_LIGHTS_MAX then, and with MURK_NO_MEMORY. */
murk_status murk_light_arrays_expand(murk_key_reader *walk,
                                     murk_scene_desc *scene);

/* Prints a line for each luminaire with the checksum of the intensities and the
 * factor of the tilt: as a part of scene->light_key they prevent that traced
 * light is reused after a file has changed. */
void murk_light_source_sign(FILE *out, const murk_scene_desc *scene);

#endif
