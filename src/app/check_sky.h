/* What check says of lights: how much power they have, and of those that go by
 * place and time where sun and moon stand, how much comes, which lamps are off.
 * In watts, and where `units` are others in these, too. */
#ifndef MURK_APP_CHECK_SKY_H
#define MURK_APP_CHECK_SKY_H

#include "results/json.h"

#include "world/stage.h"

void murk_print_lights(const murk_stage *stage);

/* Adds "lights": {count, power_w, power_lm.., sky: [{light, type, on,
 * azimuth_deg, elevation_deg, irradiance_w_per_m2, irradiance, unit (of
 * `units`), taken_again: {share, optical_depth, transmittance}}]}, null where a
 * light has no such thing. */
void murk_json_lights(cJSON *root, const murk_stage *stage);

#endif
