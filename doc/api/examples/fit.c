/* A fit: the extinction of a fog from three readings of transmittance, which
 * were made with 0.25 per metre. */
#include "example.h"

static const char readings[] =
    "kind,x_m,y_m,z_m,x2_m,y2_m,z2_m,value,standard_error\n"
    "transmittance,1,3,1,3,3,1,0.606531,0.006\n"
    "transmittance,1,3,1,5,3,1,0.367879,0.004\n"
    "transmittance,1,3,1,7,3,1,0.223130,0.002\n";

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_fit *fit = NULL;
    const murk_fields *fields = NULL;
    FILE *file = fopen("readings.csv", "w");
    if (!file || fputs(readings, file) < 0 || fclose(file) != 0) {
        return 1;
    }
    must(murk_context_create(&context, NULL, &error), &error);
    must(murk_scene_parse(&scene, context, room, "room.yaml", &error), &error);
    static const char *const keys[] = {"media.fog.extinction_per_m"};
    /* The folder is checked before any light is traced. */
    must(murk_fit_create(&fit, scene, "readings.csv", keys, 1, NULL, &error),
         &error);
    must(murk_fit_check_save(fit, "results", NULL, &error), &error);
    /* Two machines run the searches; both parts together are those of
     * murk_fit_run(). */
    static const char *const parts[] = {"starts-1.part", "starts-2.part"};
    must(murk_fit_run_part(fit, 1, 2, parts[0], &error), &error);
    must(murk_fit_run_part(fit, 2, 2, parts[1], &error), &error);
    must(murk_fit_merge(fit, parts, 2, &error), &error);
    double value = 0;
    must(murk_fit_fields(fit, &fields, &error), &error);
    must(murk_fields_double(fields, "parameters.0.value", &value, &error),
         &error);
    printf("extinction_per_m: %.3f\n", value);
    must(murk_fit_save(fit, "results", NULL, NULL, &error), &error);
    /* The scene with the values of the file that the fit has written. */
    const char *file_of_values = "results/calibrated.yaml";
    const char *key = NULL, *text = NULL;
    must(murk_context_read_keys(context, file_of_values, &fields, &error),
         &error);
    for (size_t i = 0; i < murk_fields_length(fields, "keys"); ++i) {
        char path[2][32];
        snprintf(path[0], sizeof path[0], "keys.%zu.key", i);
        snprintf(path[1], sizeof path[1], "keys.%zu.value", i);
        must(murk_fields_string(fields, path[0], &key, &error), &error);
        must(murk_fields_string(fields, path[1], &text, &error), &error);
        must(murk_scene_set(scene, key, text, &error), &error);
    }
    must(murk_scene_get(scene, "media.fog.extinction_per_m", &text, &error),
         &error);
    printf("in the scene: %.3f\n", strtod(text, NULL));
    murk_fit_destroy(fit);
    /* On one machine: all searches at once. */
    must(murk_fit_create(&fit, scene, "readings.csv", keys, 1, NULL, &error),
         &error);
    must(murk_fit_run(fit, &error), &error);
    must(murk_fit_fields(fit, &fields, &error), &error);
    must(murk_fields_double(fields, "parameters.0.value", &value, &error),
         &error);
    printf("on one machine: %.3f\n", value);
    murk_fit_destroy(fit);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * extinction_per_m: 0.250
 * in the scene: 0.250
 * on one machine: 0.250
 */
