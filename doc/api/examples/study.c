/* A study: the coverage for three densities of fog. */
#include "example.h"

static const char study_text[] =
    "murk_study: 1\n"
    "base: room.yaml\n"
    "axes: {media.fog.extinction_per_m: [0.05, 0.1, 0.2]}\n"
    "outputs: [coverage_best]\n";

static int write_file(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    return file && fputs(text, file) >= 0 && fclose(file) == 0;
}

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_study *study = NULL;
    const murk_fields *fields = NULL;
    if (!write_file("room.yaml", room) ||
        !write_file("study.yaml", study_text)) {
        return 1;
    }
    must(murk_context_create(&context, NULL, &error), &error);
    /* The folder is checked before the rows are run. */
    must(murk_study_read(&study, context, "study.yaml", NULL, &error), &error);
    must(murk_study_check_save(study, "results", NULL, &error), &error);
    must(murk_study_run(study, &error), &error);
    must(murk_study_fields(study, &fields, &error), &error);
    for (size_t i = 0; i < murk_fields_length(fields, "rows"); ++i) {
        char path[64];
        double share = 0;
        snprintf(path, sizeof path, "rows.%zu.values.coverage_best.value", i);
        must(murk_fields_double(fields, path, &share, &error), &error);
        printf("row %zu: %.1f\n", i, share);
    }
    must(murk_study_save(study, "results", NULL, NULL, &error), &error);
    murk_study_destroy(study);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * row 0: 0.9
 * row 1: 0.8
 * row 2: 0.7
 */
