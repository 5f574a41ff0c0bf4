/* A measured profile of an extinction coefficient as a grid. */
#include "example.h"

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    const murk_fields *fields = NULL;
    double voxels = 0, optical_depth = 0;
    FILE *csv = fopen("cast.csv", "w");
    if (!csv) {
        return 1;
    }
    fputs("depth_m,c_per_m\n0,0.1\n10,0.3\n", csv);
    fclose(csv);
    const murk_profile_options options = {.size = sizeof options,
                                          .voxel_m = 0.5};
    must(murk_context_create(&context, NULL, &error), &error);
    must(murk_context_profile_grid(context, "cast.csv", "cast.vdb", &options,
                                   NULL, &fields, &error),
         &error);
    must(murk_fields_double(fields, "voxels", &voxels, &error), &error);
    must(murk_fields_double(fields, "optical_depth", &optical_depth, &error),
         &error);
    printf("%g voxels, optical depth %g\n", voxels, optical_depth);
    murk_context_destroy(context);
    remove("cast.csv");
    remove("cast.vdb");
    return 0;
}

/* Prints:
 *
 * 20 voxels, optical depth 2
 */
