/* What check says of lights that go by place and time: where sun and moon
 * stand, how much comes, which lamps are off. */
#ifndef MURK_APP_CHECK_SKY_H
#define MURK_APP_CHECK_SKY_H

#include <cjson/cJSON.h>

#include "study/stage.h"

void murk_print_sky(const murk_stage *stage);

/* Adds "sky", a list: {light, type, on, azimuth_deg, elevation_deg,
 * irradiance_w_per_m2, taken_again: {share, optical_depth, transmittance}},
 * null where a light has no such thing. */
void murk_json_sky(cJSON *lights, const murk_stage *stage);

#endif
