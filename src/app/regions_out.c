#include "app/regions_out.h"

#include <math.h>

void murk_json_regions(cJSON *root, const murk_scene *scene,
                       const murk_region_coverage *in_sample,
                       const murk_region_coverage *held_out)
{
    const murk_scene_placement *wish = &scene->placement;
    cJSON *list = cJSON_AddArrayToObject(root, "regions_of_interest");
    for (size_t i = 0; i < wish->n_interests; ++i) {
        const murk_estimate seen = in_sample[i].coverage;
        const murk_estimate held =
            held_out ? held_out[i].coverage : (murk_estimate){NAN, NAN};
        cJSON *item = cJSON_CreateObject();
        cJSON_AddStringToObject(item, "name", wish->interest[i].name);
        murk_json_number(item, "weight", wish->interest[i].weight);
        cJSON_AddNumberToObject(item, "stored_photons",
                                (double)in_sample[i].photons);
        murk_json_number(item, "coverage", seen.value);
        murk_json_number(item, "standard_error", seen.standard_error);
        murk_json_number(item, "held_out", held.value);
        murk_json_number(item, "held_out_standard_error", held.standard_error);
        cJSON_AddItemToArray(list, item);
    }
}

void murk_print_regions(const murk_scene *scene,
                        const murk_region_coverage *in_sample,
                        const murk_region_coverage *held_out)
{
    const murk_scene_placement *wish = &scene->placement;
    if (wish->n_interests == 0) {
        return;
    }
    printf("regions     %-16s %8s %9s  %18s", "of interest", "weight",
           "photons", "in view");
    printf(held_out ? "  %18s\n" : "\n", "held out");
    for (size_t i = 0; i < wish->n_interests; ++i) {
        printf("            %-16s %8.4g %9zu", wish->interest[i].name,
               wish->interest[i].weight, in_sample[i].photons);
        printf("  %.4f +- %-8.4f", in_sample[i].coverage.value,
               in_sample[i].coverage.standard_error);
        if (held_out) {
            printf("  %.4f +- %-8.4f", held_out[i].coverage.value,
                   held_out[i].coverage.standard_error);
        }
        printf("\n");
    }
}
