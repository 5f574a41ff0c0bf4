/* Prints what a save of the library returns: the text of the main JSON, or the
 * summary that `run` holds, then times, memory and the names of the files. */
#include "app/show.h"

#include "app/field.h"
#include "base/print.h"

#include <string.h>

#define SHOWN_S 0.005 /* shorter times would be shown as 0.00 */

bool murk_shows_summary(const murk_options *options)
{
    return !options->json && !options->quiet;
}

void murk_show_lines(const murk_fields *saved, const char *list)
{
    const size_t n = murk_fields_length(saved, list);
    for (size_t i = 0; i < n; ++i) {
        murk_print("%s", murk_field_text(saved, "%s.%zu", list, i));
        murk_print("\n");
    }
}

void murk_show_results(const murk_options *options, const murk_fields *saved)
{
    if (options->json) {
        murk_print_json(murk_fields_json(saved));
    } else if (!options->quiet) {
        murk_show_lines(saved, "run.summary");
    }
}

void murk_show_times(const murk_fields *saved)
{
    /* In a plan for a matrix the time to sense is that to take the matrix. */
    const bool has_matrix =
        murk_fields_kind(saved, "matrix") == MURK_FIELD_OBJECT;
    const struct {
        const char *name, *path;
    } part[] = {{"load", "run.seconds.load"},
                {"trace", "run.seconds.trace"},
                {"maps", "run.seconds.map"},
                {"sense", has_matrix ? "" : "run.seconds.sense"},
                {"place", "run.seconds.place"},
                {"matrix", has_matrix ? "run.seconds.sense" : ""}};
    murk_print("time        %.2f s",
               murk_field_number(saved, "run.seconds.total"));
    const char *between = ": ";
    for (size_t i = 0; i < sizeof part / sizeof *part; ++i) {
        const double seconds = murk_field_number(saved, "%s", part[i].path);
        if (seconds >= SHOWN_S) {
            murk_print("%s%s %.2f", between, part[i].name, seconds);
            between = ", ";
        }
    }
    murk_print("; memory %.2g GB\n",
               murk_field_number(saved, "run.peak_memory_bytes") / 1e9);
}

static void show_files(const murk_fields *saved)
{
    const char *folder = murk_field_text(saved, "saved.folder");
    if (!folder) {
        murk_print("files       none: -o DIR writes them\n");
        return;
    }
    murk_print("files       %s:", folder);
    for (size_t i = murk_fields_length(saved, "saved.files"); i > 0; --i) {
        murk_print(" %s", murk_field_text(saved, "saved.files.%zu", i - 1));
    }
    murk_print("\n");
}

void murk_show_run(const murk_options *options, const murk_fields *saved)
{
    if (murk_shows_summary(options)) {
        murk_show_times(saved);
        show_files(saved);
    }
}

void murk_show(const murk_options *options, const murk_fields *saved)
{
    if (saved) {
        murk_show_results(options, saved);
        murk_show_run(options, saved);
    }
}

murk_status murk_show_check_search(const murk_fields *plan, murk_error *err)
{
    const char *cut_by = murk_field_text(plan, "placement.cut_by");
    return cut_by && strcmp(cut_by, "interrupt") == 0
               ? murk_fail(err, MURK_INTERRUPTED, "",
                           "interrupted: plan and bound are those that the "
                           "search had reached")
               : MURK_OK;
}
