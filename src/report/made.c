/* The section of the page about how the results were made, and the commands
 * that make them again. Words of commands are quoted for a shell
 * (base/utf8.h). */
#include "base/file.h"
#include "base/memory_files.h"
#include "base/utf8.h"
#include "report/html.h"
#include "report/sections.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* ---- commands ---- */

static void write_word(FILE *to, const char *word)
{
    char *quoted = murk_utf8_shell_word(word);
    murk_html_text(to, quoted ? quoted : word);
    free(quoted);
}

static void write_file_of(FILE *to, const murk_results_in *results,
                          const char *name)
{
    char *path = murk_path_join(results->whole, name);
    write_word(to, path ? path : name);
    free(path);
}

/* True if the run of a JSON is described: that of each main JSON and, in a
 * folder with files of several runs, also that of ledger.json. */
static bool is_described(const murk_results_in *results, int which)
{
    return results->json[which] &&
           (murk_results_is_main(results, (murk_result_file)which) ||
            !murk_results_are_one_run(results));
}

/* Writes the commands as they were typed, with the folders they were typed in.
 * False if no command is known. */
static bool write_typed(FILE *to, const murk_results_in *results)
{
    const char *last = "";
    bool has_any = false;
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        const murk_yaml *root = results->json[i];
        const char *command = murk_result_text(root, "run.command");
        const char *folder = murk_result_text(root, "run.folder");
        if (!is_described(results, i) || !command) {
            continue;
        }
        /* a block that a shell can run; it changes to the folder of each
         * command, if the JSON states the folder */
        if (!has_any) {
            fputs("<p>As it was typed. Files are named as seen from the folder "
                  "it was typed in.</p>\n<pre tabindex=\"0\">",
                  to);
        }
        if (folder && strcmp(folder, last) != 0) {
            fputs("cd ", to);
            write_word(to, folder);
            fputc('\n', to);
            last = folder;
        }
        murk_html_text(to, command);
        fputs(" -o again\n", to);
        has_any = true;
    }
    fputs(has_any ? "murk report again</pre>\n" : "", to);
    return has_any;
}

/* Writes a command that uses the resolved scene in the folder. The resolved
 * scene has all keys, also those that options of the command line set. Of the
 * other options only --repeat and --sensors are written. */
static void write_resolved(FILE *to, const murk_results_in *results)
{
    const murk_yaml *plan = results->json[MURK_RESULT_PLAN];
    const murk_yaml *seen = results->json[MURK_RESULT_COVERAGE];
    const double repeats = murk_result_number(plan, "repeat.asked");
    fputs("<p>From the resolved scene of this folder, with all keys that the "
          "command line set, and files by their whole paths.</p>\n"
          "<pre tabindex=\"0\">murk ",
          to);
    fputs(plan                                ? "place "
          : seen                              ? "sense "
          : results->json[MURK_RESULT_FOLLOW] ? "follow "
                                              : "trace ",
          to);
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
    /* Arrays of a program are in no file. */
    const murk_scene_desc *scene = results->scene;
    bool has_arrays = false;
    for (size_t i = 0; scene && i < scene->files; ++i) {
        has_arrays |= murk_memory_is(scene->file[i]);
    }
    const bool has_scene =
        !results->json[MURK_RESULT_STUDY] &&
        !murk_results_has_readings(results) && !has_arrays &&
        murk_results_are_one_run(results) &&
        murk_results_has(results->folder, murk_results_scene(results->folder));
    if (has_arrays) {
        fputs("<p>The scene has arrays of the program that made it, so that "
              "program alone makes the results again.</p>\n",
              to);
    }
    if (has_scene) {
        write_resolved(to, results);
    }
    fputs(has_typed || has_scene
              ? "<p>The same program on the same kind of processor gives the "
                "same bits for any number of threads.</p>\n"
          : has_arrays
              ? ""
              : "<p>The results do not say which command made them.</p>\n",
          to);
}

/* ---- provenance ---- */

static void begin_table(FILE *to, const char *caption, const char *heads)
{
    fprintf(to,
            "<div class=\"table\" tabindex=\"0\" role=\"region\" "
            "aria-label=\"%s\">\n<table>\n<caption>%s</caption>\n%s<tbody>\n",
            caption, caption, heads);
}

static void end_table(FILE *to)
{
    fputs("</tbody>\n</table>\n</div>\n", to);
}

/* A fact of a run: the value at a path of the JSON, as a text, or as a number
 * divided by per_unit. */
typedef struct fact {
    const char *name, *path, *unit; /* unit NULL: a text */
    double per_unit;
    int decimals;
} fact;

/* Writes a row with a name and a value; an en dash if there is no value. */
static void write_fact(FILE *to, const murk_yaml *root, const fact *f)
{
    const char *text = murk_result_text(root, f->path);
    fprintf(to, "<tr><th scope=\"row\">%s</th><td class=\"text\">", f->name);
    const double n = f->unit ? murk_result_number(root, f->path) : NAN;
    if (isfinite(n)) {
        fprintf(to, "%.*f %s", f->decimals, n / f->per_unit, f->unit);
    } else {
        murk_html_text(to, text && *text ? text : MURK_HTML_NONE);
    }
    fputs("</td></tr>\n", to);
}

static void write_packages(FILE *to, const murk_yaml *root)
{
    const murk_yaml *packages = murk_result_at(root, "murk.packages");
    const size_t n = murk_result_entries(packages);
    fputs("<tr><th scope=\"row\">packages</th><td class=\"text\">", to);
    for (size_t i = 0; i < n && i < MURK_REPORT_ROWS_MAX; ++i) {
        fputs(i > 0 ? ", " : "", to);
        const char *version = murk_result_text(packages->child[i], "");
        murk_html_text(to, packages->key[i]);
        fputc(' ', to);
        murk_html_text(to, version && *version ? version : MURK_HTML_NONE);
    }
    fputs("</td></tr>\n", to);
}

static void write_run(FILE *to, const char *file, const murk_yaml *root)
{
    static const fact of_study[] = {
        {.name = "study", .path = "study"},
        {.name = "its SHA-256", .path = "study_sha256"}};
    static const fact of_all[] = {
        {.name = "scene", .path = "scene"},
        {.name = "its SHA-256", .path = "scene_sha256"},
        {.name = "seed", .path = "seed"},
        {.name = "made on", .path = "run.date"},
        {"time", "run.seconds.total", "s", 1, 2},
        {.name = "threads", .path = "run.threads"},
        {"most memory at once", "run.peak_memory_bytes", "MB", 1e6, 0},
        {.name = "murk", .path = "murk.version"},
        {.name = "its commit", .path = "murk.commit"},
        {.name = "compiler", .path = "murk.compiler"}};
    char caption[64];
    snprintf(caption, sizeof caption, "How %s was made", file);
    begin_table(to, caption, "");
    for (size_t i = 0; i < 2 && murk_result_text(root, "study"); ++i) {
        write_fact(to, root, &of_study[i]);
    }
    /* Facts of every result, then the packages. */
    for (size_t i = 0; i < sizeof of_all / sizeof *of_all; ++i) {
        write_fact(to, root, &of_all[i]);
    }
    write_packages(to, root);
    end_table(to);
}

/* ---- files ---- */

/* The file name of the page if it is written into the folder; else NULL. */
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

/* Lists the files of the folder, but not the page itself or report.html, so
 * that a page that is made again is the same. */
static void write_files(FILE *to, const murk_results_in *results,
                        const char *page)
{
    const char *own = name_in(results->folder, page);
    size_t rows = 0;
    if (results->entries <= 0) {
        return;
    }
    begin_table(to, "Files of the folder",
                "<thead><tr><th scope=\"col\">file</th><th scope=\"col\">bytes"
                "</th></tr></thead>\n");
    /* regular files by name, without the page itself */
    for (int i = 0; i < results->entries; ++i) {
        struct stat known;
        const char *name = results->entry[i]->d_name;
        char *path =
            (own && strcmp(name, own) == 0) || strcmp(name, "report.html") == 0
                ? NULL
                : murk_path_join(results->folder, name);
        if (path && stat(path, &known) == 0 && S_ISREG(known.st_mode) &&
            ++rows <= MURK_REPORT_ROWS_MAX) {
            fputs("<tr><th scope=\"row\">", to);
            murk_html_text(to, name);
            fprintf(to, "</th><td>%lld</td></tr>\n", (long long)known.st_size);
        }
        free(path);
    }
    end_table(to);
    if (rows > MURK_REPORT_ROWS_MAX) {
        fprintf(to,
                "<p class=\"note\">The first %d of %zu rows; all are in the "
                "folder.</p>\n",
                MURK_REPORT_ROWS_MAX, rows);
    }
}

void murk_report_made(FILE *to, const murk_results_in *results,
                      const char *page)
{
    fputs("<section id=\"made\" data-title=\"How it was made\">\n"
          "<h2>How it was made</h2>\n",
          to);
    if (results->made_by) {
        fputs("<p>No folder of these results was kept: ", to);
        murk_html_text(to, results->made_by);
        fputs(" makes them again.</p>\n", to);
    } else {
        write_commands(to, results);
    }
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        if (is_described(results, i)) {
            write_run(to, murk_result_kinds[i].file, results->json[i]);
        }
    }
    if (!results->made_by) {
        write_files(to, results, page);
    }
    fputs("</section>\n", to);
}
