/* How the results were made, and how to make them again. */
#include "base/file.h"
#include "base/utf8.h"
#include "report/html.h"
#include "report/sections.h"

#include <dirent.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* ---- commands ---- */

static const char *const names[MURK_RESULT_FILES] = {
    [MURK_RESULT_PLAN] = "plan.json",
    [MURK_RESULT_COVERAGE] = "coverage.json",
    [MURK_RESULT_STUDY] = "study.json",
    [MURK_RESULT_FIT] = "fit.json",
    [MURK_RESULT_LEDGER] = "ledger.json"};

static void write_word(FILE *to, const char *word)
{
    char *quoted = murk_utf8_shell_word(word);
    murk_page_text(to, quoted ? quoted : word);
    free(quoted);
}

static void write_file_of(FILE *to, const murk_results_in *results,
                          const char *name)
{
    char *path = murk_path_join(results->whole, name);
    write_word(to, path ? path : name);
    free(path);
}

/* In a folder that mixes runs, the run of the light is described as well. */
static bool is_told(const murk_results_in *results, int which)
{
    return results->json[which] &&
           (murk_results_is_main(results, (murk_result_file)which) ||
            !murk_results_are_one_run(results));
}

/* What was typed, from the folder where that was. */
static bool write_typed(FILE *to, const murk_results_in *results)
{
    const char *last = "";
    bool has_any = false;
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        const murk_yaml *root = results->json[i];
        const char *command = murk_result_text(root, "run.command");
        const char *folder = murk_result_text(root, "run.folder");
        if (!is_told(results, i) || !command) {
            continue;
        }
        if (!has_any) {
            murk_page_paragraph(to, "As it was typed. Files are named as seen "
                                    "from the folder it was typed in.");
            fputs("<pre tabindex=\"0\">", to);
        }
        if (folder && strcmp(folder, last) != 0) {
            fputs("cd ", to);
            write_word(to, folder);
            fputc('\n', to);
            last = folder;
        }
        murk_page_text(to, command);
        fputs(" -o again\n", to);
        has_any = true;
    }
    fputs(has_any ? "murk report again</pre>\n" : "", to);
    return has_any;
}

/* From the scene that lies beside the results: all keys are in it, what
 * options of the search said is not. */
static void write_resolved(FILE *to, const murk_results_in *results)
{
    const murk_yaml *plan = results->json[MURK_RESULT_PLAN];
    const murk_yaml *seen = results->json[MURK_RESULT_COVERAGE];
    const double repeats = murk_result_number(plan, "repeat.asked");
    murk_page_paragraph(to, "From the resolved scene of this folder, with all "
                            "keys that the command line set, and files by "
                            "their whole paths.");
    fputs("<pre tabindex=\"0\">murk ", to);
    fputs(plan ? "place " : seen ? "sense " : "trace ", to);
    write_file_of(to, results, murk_results_scene(results->folder));
    if (isfinite(repeats)) {
        fprintf(to, " --repeat %.0f", repeats);
    }
    if (seen && !plan) {
        fputs(" --sensors ", to);
        write_file_of(to, results, "coverage.json");
    }
    fputs(" -o again\nmurk report again</pre>\n", to);
}

static void write_commands(FILE *to, const murk_results_in *results)
{
    fputs("<h3>The commands that make it again</h3>\n", to);
    const bool has_typed = write_typed(to, results);
    const bool has_scene =
        !results->json[MURK_RESULT_STUDY] && !results->json[MURK_RESULT_FIT] &&
        murk_results_are_one_run(results) &&
        murk_results_has(results->folder, murk_results_scene(results->folder));
    if (has_scene) {
        write_resolved(to, results);
    }
    murk_page_paragraph(
        to, has_typed || has_scene
                ? "The same program on the same kind of processor gives the "
                  "same bits for any number of threads."
                : "The results do not say which command made them.");
}

/* ---- provenance ---- */

static void write_packages(FILE *to, const murk_yaml *root)
{
    const murk_yaml *packages = murk_result_at(root, "murk.packages");
    const size_t n =
        packages && packages->kind == MURK_YAML_MAP ? packages->n : 0;
    murk_page_row_begin(to, "packages");
    fputs("<td class=\"text\">", to);
    for (size_t i = 0; i < n && i < MURK_PAGE_ROWS_MAX; ++i) {
        fputs(i > 0 ? ", " : "", to);
        murk_page_text(to, packages->key[i]);
        fputc(' ', to);
        murk_page_text(to, murk_result_text(packages->child[i], ""));
    }
    fputs("</td>", to);
    murk_page_row_end(to);
}

static void write_run(FILE *to, const char *file, const murk_yaml *root)
{
    char caption[64];
    snprintf(caption, sizeof caption, "How %s was made", file);
    murk_page_table_begin(to, caption, NULL, 0);
    if (murk_result_text(root, "study")) {
        murk_page_fact(to, "study", murk_result_text(root, "study"));
        murk_page_fact(to, "its SHA-256",
                       murk_result_text(root, "study_sha256"));
    }
    murk_page_fact(to, "scene", murk_result_text(root, "scene"));
    murk_page_fact(to, "its SHA-256", murk_result_text(root, "scene_sha256"));
    murk_page_fact(to, "seed", murk_result_text(root, "seed"));
    murk_page_fact(to, "made on", murk_result_text(root, "run.date"));
    murk_page_fact_number(to, "time",
                          murk_result_number(root, "run.seconds.total"), "s");
    murk_page_fact_number(to, "threads",
                          murk_result_number(root, "run.threads"), "");
    murk_page_fact_number(
        to, "most memory at once",
        round(murk_result_number(root, "run.peak_memory_bytes") / 1e6), "MB");
    murk_page_fact(to, "murk", murk_result_text(root, "murk.version"));
    murk_page_fact(to, "its commit", murk_result_text(root, "murk.commit"));
    murk_page_fact(to, "compiler", murk_result_text(root, "murk.compiler"));
    write_packages(to, root);
    murk_page_table_end(to);
}

/* ---- files ---- */

static int is_shown(const struct dirent *entry)
{
    return entry->d_name[0] != '.';
}

static int by_name(const struct dirent **a, const struct dirent **b)
{
    return strcmp((*a)->d_name, (*b)->d_name);
}

/* The page's own name in the folder; NULL where it is written elsewhere. */
static const char *name_in(const char *folder, const char *page)
{
    struct stat here, there;
    const char *name = murk_path_name(page);
    char *parent =
        name > page ? strndup(page, (size_t)(name - page)) : strdup(".");
    const bool is_in =
        parent && stat(folder, &here) == 0 && stat(parent, &there) == 0 &&
        here.st_dev == there.st_dev && here.st_ino == there.st_ino;
    free(parent);
    return is_in ? name : NULL;
}

/* But the page, which would tell of itself: two of one folder are the same. */
static void write_files(FILE *to, const char *folder, const char *page)
{
    static const char *const heads[] = {"file", "bytes"};
    const char *own = name_in(folder, page);
    struct dirent **entry = NULL;
    size_t rows = 0;
    const int n = scandir(folder, &entry, is_shown, by_name);
    if (n <= 0) {
        free(entry);
        return;
    }
    murk_page_table_begin(to, "Files of the folder", heads, 2);
    for (int i = 0; i < n; ++i) {
        struct stat known;
        const char *name = entry[i]->d_name;
        char *path =
            (own && strcmp(name, own) == 0) || strcmp(name, "report.html") == 0
                ? NULL
                : murk_path_join(folder, name);
        if (path && stat(path, &known) == 0 && S_ISREG(known.st_mode) &&
            ++rows <= MURK_PAGE_ROWS_MAX) {
            murk_page_row_begin(to, name);
            murk_page_cell_number(to, (double)known.st_size);
            murk_page_row_end(to);
        }
        free(path);
        free(entry[i]);
    }
    free(entry);
    murk_page_table_end(to);
    murk_page_more(to, rows, "the folder");
}

void murk_report_made(FILE *to, const murk_results_in *results,
                      const char *page)
{
    murk_page_section_begin(to, "made", "How it was made");
    write_commands(to, results);
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        if (is_told(results, i)) {
            write_run(to, names[i], results->json[i]);
        }
    }
    write_files(to, results->folder, page);
    murk_page_section_end(to);
}
