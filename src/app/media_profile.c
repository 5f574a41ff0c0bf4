/* murk media --profile: reads the options, has murk_context_profile_grid()
 * write the grid, and prints what the grid is. */
#include "app/media_profile.h"

#include "app/field.h"
#include "app/identity.h"
#include "app/show.h"
#include "base/number.h"
#include "base/print.h"

#include <stdlib.h>

#define LENGTH_MAX_M 1e9 /* the library refuses more */

/* An option that is a length, 0 where it is not given. */
static murk_status read_length(const char *name, const char *text,
                               double *length_m, murk_error *err)
{
    *length_m = 0;
    if (text && (!murk_number_parse(text, length_m) ||
                 !(*length_m > 0 && *length_m <= LENGTH_MAX_M))) {
        return murk_fail(err, MURK_BAD_VALUE, name,
                         "%.80s, must be more than 0 and at most %g m", text,
                         LENGTH_MAX_M);
    }
    return MURK_OK;
}

static murk_status read_options(murk_profile_options *out,
                                const murk_options *options, murk_error *err)
{
    *out =
        (murk_profile_options){.size = sizeof *out,
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
    const murk_status status =
        read_length("--voxel", options->voxel, &out->voxel_m, err);
    return status ? status
                  : read_length("--width", murk_option_text(options, "--width"),
                                &out->width_m, err);
}

static void print_grid(const murk_fields *f)
{
    murk_print("%s: %s of %.0f rows, %.6g down to %.6g m, optical depth %.7g\n",
               murk_field_text(f, "profile"), murk_field_text(f, "column"),
               murk_field_number(f, "rows"), murk_field_number(f, "top_m"),
               murk_field_number(f, "bottom_m"),
               murk_field_number(f, "optical_depth"));
    murk_print("%s: grid density [1/m], %.0f voxels of %.6g m, %.6g m wide\n",
               murk_field_text(f, "grid"), murk_field_number(f, "voxels"),
               murk_field_number(f, "voxel_m"),
               murk_field_number(f, "width_m"));
}

murk_status murk_command_media_profile(const murk_options *options,
                                       murk_error *err)
{
    murk_profile_options asked;
    char *identity = NULL;
    const murk_fields *fields = NULL;
    murk_status status = read_options(&asked, options, err);
    if (!status) {
        status = murk_identity_alone(&identity, options, err);
    }
    if (!status) {
        const murk_save_options save = {
            .size = sizeof save, .replaces = options->force, .asked = identity};
        status = murk_context_profile_grid(options->context, options->profile,
                                           options->out, &asked, &save, &fields,
                                           err);
    }
    if (!status && options->json) {
        murk_print_json(murk_fields_json(fields));
    } else if (!status && !options->quiet) {
        print_grid(fields);
    }
    free(identity);
    return status;
}
