/* Regions of interest in results and on the screen. */
#ifndef MURK_APP_REGIONS_OUT_H
#define MURK_APP_REGIONS_OUT_H

#include "app/results.h"

/* Adds "regions_of_interest": one item a region of the scene, none where it has
 * none. in_sample and held_out[regions]; held_out NULL: null. */
void murk_json_regions(cJSON *root, const murk_scene *scene,
                       const murk_region_coverage *in_sample,
                       const murk_region_coverage *held_out);

/* The table of them; nothing where there are none. */
void murk_print_regions(const murk_scene *scene,
                        const murk_region_coverage *in_sample,
                        const murk_region_coverage *held_out);

#endif
