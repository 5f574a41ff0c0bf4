/* murk media --profile: reads a measured profile of a coefficient from a CSV
 * file and writes it as a grid of layers. */
#include "app/identity.h"
#include "app/media_profile.h"
#include "base/number.h"
#include "medium/grid_write.h"
#include "results/results.h"
#include "results/summary.h"

#include <stdio.h>

/* An option that is a length, 0 where it is not given. */
static murk_status read_length(const char *name, const char *text,
                               double *length_m, murk_error *err)
{
    *length_m = 0;
    if (!text) {
        return MURK_OK;
    }
    if (!murk_number_parse(text, length_m) ||
        !(*length_m > 0 && *length_m <= MURK_PROFILE_LENGTH_MAX_M)) {
        return murk_fail(err, MURK_BAD_VALUE, name,
                         "%.80s, must be more than 0 and at most %g m", text,
                         MURK_PROFILE_LENGTH_MAX_M);
    }
    return MURK_OK;
}

static murk_status print_json(const murk_profile_layers *l,
                              const murk_options *options, murk_error *err)
{
    cJSON *root = murk_json_begin_murk();
    cJSON_AddStringToObject(root, "profile", l->csv);
    cJSON_AddStringToObject(root, "column", l->column);
    cJSON_AddNumberToObject(root, "rows", (double)l->rows);
    cJSON_AddStringToObject(root, "grid", options->out);
    cJSON_AddNumberToObject(root, "voxels", (double)l->n);
    murk_json_number(root, "voxel_m", l->voxel_m);
    murk_json_number(root, "width_m", l->width_m);
    murk_json_number(root, "top_m", l->top_m);
    murk_json_number(root, "optical_depth", l->depth);
    /* The identity and the checksum of the grid. */
    const murk_status status =
        murk_identify_alone(root, options, "", options->out, err);
    if (status) {
        cJSON_Delete(root);
        return status;
    }
    char *text = root ? cJSON_Print(root) : NULL;
    cJSON_Delete(root);
    if (!text) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the JSON");
    }
    murk_print_json(text);
    cJSON_free(text);
    return MURK_OK;
}

murk_status murk_command_media_profile(const murk_options *options,
                                       murk_error *err)
{
    murk_profile_settings settings = {
        .csv = options->profile,
        .column = murk_option_text(options, "--column"),
        .rows = murk_option_text(options, "--rows")};
    if (options->input) {
        return murk_fail(err, MURK_BAD_VALUE, "media",
                         "%.80s and --profile, must be one of them",
                         options->input);
    }
    if (!options->out) {
        return murk_fail(err, MURK_BAD_VALUE, "--profile",
                         "misses -o, must be the name of the grid's file");
    }
    /* Lengths that the user gives. */
    murk_status status =
        read_length("--voxel", options->voxel, &settings.voxel_m, err);
    if (!status) {
        status = read_length("--width", murk_option_text(options, "--width"),
                             &settings.width_m, err);
    }
    if (status) {
        return status;
    }
    /* Read the profile and write it as a grid. */
    murk_profile_layers layers;
    status = murk_profile_layers_read(&layers, &settings, err);
    if (!status) {
        status = murk_file_check_owner(options->out, MURK_GRID_MARK,
                                       sizeof MURK_GRID_MARK - 1,
                                       options->force, err);
    }
    if (!status) {
        status = murk_profile_layers_write(&layers, options->out, err);
    }
    /* Report the grid. */
    if (!status && options->json) {
        status = print_json(&layers, options, err);
    } else if (!status && !options->quiet) {
        murk_print(
            "%s: %s of %zu rows, %.6g down to %.6g m, optical depth %.7g\n"
            "%s: grid density [1/m], %zu voxels of %.6g m, %.6g m wide\n",
            layers.csv, layers.column, layers.rows, layers.top_m,
            layers.bottom_m, layers.depth, options->out, layers.n,
            layers.voxel_m, layers.width_m);
    }
    murk_profile_layers_release(&layers);
    return status;
}
