/* Measured profiles as grids: reads the CSV file, writes the grid, and makes
 * the fields that murk media --profile prints. */
#include "api/save.h"

#include "base/file.h"
#include "medium/grid_write.h"
#include "results/profile_grid.h"

#include <stdio.h>
#include <stdlib.h>

/* The arguments of the call, with options as this library knows them. */
typedef struct request {
    const char *csv, *grid;
    murk_profile_options options;
    murk_save_options save;
} request;

/* Fails unless a length is 0 or more and within the limit. */
static murk_status check_length(const char *name, double length_m,
                                murk_error *err)
{
    return length_m >= 0 && length_m <= MURK_PROFILE_LENGTH_MAX_M
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, name,
                           "%g, must be more than 0 and at most %g m, or 0 for "
                           "the usual length",
                           length_m, MURK_PROFILE_LENGTH_MAX_M);
}

static murk_status take_options(request *asked,
                                const murk_profile_options *options,
                                const murk_save_options *save, murk_error *err)
{
    murk_status status =
        murk_options_copy(&asked->options, sizeof asked->options, options,
                          "options", "murk_profile_options", err);
    if (!status) {
        status = murk_options_copy(&asked->save, sizeof asked->save, save,
                                   "save", "murk_save_options", err);
    }
    if (!status) {
        status = check_length("voxel_m", asked->options.voxel_m, err);
    }
    return status ? status
                  : check_length("width_m", asked->options.width_m, err);
}

/* *text: the text of all input, for the identity: the contents of the CSV file
 * and the options. The caller frees the text, also after a failure. */
static murk_status write_input(char **text, const request *asked,
                               murk_error *err)
{
    const murk_profile_options *o = &asked->options;
    char sum[65];
    size_t size = 0;
    murk_status status = murk_file_sha256(asked->csv, sum, err);
    if (status) {
        return status;
    }
    FILE *to = open_memstream(text, &size);
    if (to) {
        fprintf(to, "profile %s\ncolumn %s\nrows %s\n", sum,
                o->column ? o->column : "", o->rows ? o->rows : "");
        fprintf(to, "voxel_m %.17g\nwidth_m %.17g\n", o->voxel_m, o->width_m);
    }
    return to && fclose(to) == 0 ? MURK_OK
                                 : murk_no_memory(err, "", "for the identity");
}

static cJSON *layers_json(const request *asked, const murk_profile_layers *l)
{
    cJSON *root = murk_json_begin_murk();
    cJSON_AddStringToObject(root, "profile", asked->csv);
    cJSON_AddStringToObject(root, "column", l->column);
    murk_json_number(root, "rows", (double)l->rows);
    cJSON_AddStringToObject(root, "grid", asked->grid);
    murk_json_number(root, "voxels", (double)l->n);
    murk_json_number(root, "voxel_m", l->voxel_m);
    murk_json_number(root, "width_m", l->width_m);
    murk_json_number(root, "top_m", l->top_m);
    murk_json_number(root, "bottom_m", l->bottom_m);
    murk_json_number(root, "optical_depth", l->depth);
    return root;
}

/* Makes the fields of a grid that is written. */
static murk_status describe(murk_fields *fields, const request *asked,
                            const murk_profile_layers *layers, murk_error *err)
{
    char *input = NULL;
    murk_status status =
        asked->save.asked ? MURK_OK : write_input(&input, asked, err);
    if (!status) {
        status =
            murk_save_alone(fields, layers_json(asked, layers), "media",
                            &asked->save, input ? input : "", asked->grid, err);
    }
    free(input);
    return status;
}

/* Reads the profile and writes the grid, unless the file may not be
 * replaced. */
static murk_status write_grid(murk_fields *fields, const request *asked,
                              murk_error *err)
{
    const murk_profile_settings settings = {.csv = asked->csv,
                                            .column = asked->options.column,
                                            .rows = asked->options.rows,
                                            .voxel_m = asked->options.voxel_m,
                                            .width_m = asked->options.width_m};
    murk_profile_layers layers;
    murk_status status = murk_profile_layers_read(&layers, &settings, err);
    if (!status) {
        status = murk_file_check_owner(asked->grid, MURK_GRID_MARK,
                                       sizeof MURK_GRID_MARK - 1,
                                       asked->save.replaces, err);
    }
    if (!status) {
        status = murk_profile_layers_write(&layers, asked->grid, err);
    }
    if (!status) {
        status = describe(fields, asked, &layers, err);
    }
    murk_profile_layers_release(&layers);
    return status;
}

murk_status murk_context_profile_grid(murk_context *context, const char *csv,
                                      const char *grid,
                                      const murk_profile_options *options,
                                      const murk_save_options *save,
                                      const murk_fields **fields,
                                      murk_error *error)
{
    if (!context || !csv || !grid) {
        return murk_save_refuse(fields, error, "context, csv or grid is NULL");
    }
    request asked = {.csv = csv, .grid = grid};
    murk_call call = murk_call_begin(context, NULL, error);
    murk_status status = take_options(&asked, options, save, &call.failure);
    if (!status) {
        status = write_grid(&context->profile, &asked, &call.failure);
    }
    status = murk_call_end(&call, status);
    if (fields) {
        *fields = status ? NULL : &context->profile;
    }
    return status;
}
