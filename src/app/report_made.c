/* Where the light went, how the results were made, and how to make them
 * again. */
#include "app/page.h"
#include "app/report.h"

#include <dirent.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* ---- energy ---- */

static void write_watts(FILE *to, const char *name, double watts,
                        double emitted)
{
    murk_page_row_begin(to, name);
    murk_page_cell_number(to, watts);
    murk_page_cell_share(to, emitted > 0 ? watts / emitted : NAN, NAN);
    murk_page_row_end(to);
}

static void write_absorbers(FILE *to, const murk_yaml *ledger, const char *path,
                            const char *what, double emitted)
{
    const murk_yaml *by = murk_result_at(ledger, path);
    const size_t n = by && by->kind == MURK_YAML_MAP ? by->n : 0;
    for (size_t i = 0; i < n && i < MURK_PAGE_ROWS_MAX; ++i) {
        char name[160];
        snprintf(name, sizeof name, "%s %s", what, by->key[i]);
        write_watts(to, name, murk_result_number(by->child[i], "total"),
                    emitted);
    }
}

void murk_report_light(FILE *to, const murk_results_in *results)
{
    static const char *const heads[] = {"where", "W", "of what was emitted"};
    const murk_yaml *ledger = results->json[MURK_RESULT_LEDGER];
    if (!ledger) {
        return;
    }
    const double emitted = murk_result_number(ledger, "emitted_w.total");
    murk_page_section_begin(to, "light", "Where the light went");
    murk_page_table_begin(to, "Energy balance", heads, 3);
    write_watts(to, "emitted", emitted, emitted);
    write_watts(to, "absorbed by surfaces",
                murk_result_number(ledger, "absorbed_surfaces_w.total"),
                emitted);
    write_absorbers(to, ledger, "absorbed_by_material_w", "of that by",
                    emitted);
    write_watts(to, "absorbed by media",
                murk_result_number(ledger, "absorbed_media_w.total"), emitted);
    write_absorbers(to, ledger, "absorbed_by_medium_w", "of that by", emitted);
    write_watts(to, "escaped", murk_result_number(ledger, "escaped_w.total"),
                emitted);
    write_watts(to, "lost to rounding and limits",
                murk_result_number(ledger, "lost_w.total"), emitted);
    murk_page_table_end(to);
    murk_page_section_end(to);
}

/* ---- commands ---- */

/* A word for a POSIX shell: in quotes, where it needs them. */
static void write_word(FILE *to, const char *word)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRST"
                                "UVWXYZ0123456789_-+./:=@,%";
    char *quoted = malloc(4 * strlen(word) + 3);
    if (!quoted || (*word && word[strspn(word, plain)] == '\0')) {
        murk_page_text(to, word);
        free(quoted);
        return;
    }
    char *at = quoted;
    *at++ = '\'';
    for (; *word; ++word) {
        if (*word == '\'') { /* out of the quotes and in again */
            memcpy(at, "'\\'", 3);
            at += 3;
        }
        *at++ = *word;
    }
    memcpy(at, "'", 2);
    murk_page_text(to, quoted);
    free(quoted);
}

static void write_file_of(FILE *to, const murk_results_in *results,
                          const char *name)
{
    char *path = murk_results_path(results->folder, name);
    write_word(to, path ? path : name);
    free(path);
}

static void write_seed(FILE *to, const murk_yaml *root)
{
    const double seed = murk_result_number(root, "seed");
    if (isfinite(seed)) {
        fprintf(to, " --seed %.0f", seed);
    }
}

static void write_place(FILE *to, const murk_results_in *results)
{
    const murk_yaml *plan = results->json[MURK_RESULT_PLAN];
    const char *matrix = murk_result_text(plan, "matrix.file");
    const double repeats = murk_result_number(plan, "repeat.asked");
    if (matrix) {
        fputs("murk place --matrix ", to);
        write_word(to, matrix);
        fprintf(to, " --count %zu", murk_result_count(plan, "sensors"));
        write_seed(to, plan);
    } else {
        fputs("murk place ", to);
        write_file_of(to, results, "scene.yaml");
        if (isfinite(repeats)) {
            fprintf(to, " --repeat %.0f", repeats);
        }
    }
    fputs(" -o again\n", to);
}

/* KEY@each for all values of a key by condition, which follow each other. */
static void write_free_keys(FILE *to, const murk_yaml *fit)
{
    const size_t n = murk_result_count(fit, "parameters");
    const murk_yaml *list = murk_result_at(fit, "parameters");
    const char *last = "";
    size_t last_length = 0;
    for (size_t i = 0; i < n; ++i) {
        char word[256];
        const char *key = murk_result_text(list->child[i], "key");
        if (!key) {
            continue;
        }
        const size_t length = strcspn(key, "@");
        if (key[length] && length == last_length &&
            strncmp(key, last, length) == 0) {
            continue;
        }
        last = key;
        last_length = key[length] ? length : 0;
        snprintf(word, sizeof word, "%.*s%s",
                 (int)(length < 200 ? length : 200), key,
                 key[length] ? "@each" : "");
        fputs(" --free ", to);
        write_word(to, word);
    }
}

static void write_fit(FILE *to, const murk_yaml *fit)
{
    const char *scene = murk_result_text(fit, "scene");
    const char *data = murk_result_text(fit, "data.file");
    fputs("murk fit ", to);
    write_word(to, scene ? scene : "SCENE");
    fputs(" --data ", to);
    write_word(to, data ? data : "DATA");
    write_free_keys(to, fit);
    write_seed(to, fit);
    fputs(" -o again\n", to);
}

static void write_commands(FILE *to, const murk_results_in *results)
{
    const murk_yaml *study = results->json[MURK_RESULT_STUDY];
    const murk_yaml *fit = results->json[MURK_RESULT_FIT];
    fputs("<h3>The commands that make it again</h3>\n<pre tabindex=\"0\">", to);
    if (results->json[MURK_RESULT_PLAN]) {
        write_place(to, results);
    }
    if (results->json[MURK_RESULT_COVERAGE]) {
        fputs("murk sense ", to);
        write_file_of(to, results, "scene.yaml");
        fputs(" --sensors ", to);
        write_file_of(to, results, "coverage.json");
        fputs(" -o again\n", to);
    }
    if (study) {
        const char *path = murk_result_text(study, "study");
        fputs("murk study ", to);
        write_word(to, path ? path : "STUDY");
        write_seed(to, study);
        fputs(" -o again\n", to);
    }
    if (fit) {
        write_fit(to, fit);
    }
    if (!results->json[MURK_RESULT_PLAN] &&
        !results->json[MURK_RESULT_COVERAGE] && !study && !fit) {
        fputs("murk trace ", to);
        write_file_of(to, results, "scene.yaml");
        fputs(" -o again\n", to);
    }
    fputs("murk report again</pre>\n", to);
    murk_page_paragraph(
        to, study || fit
                ? "The same program on the same kind of processor gives the "
                  "same bits for any number of threads. What was said by --set "
                  "or by options of the search when it was run has to be said "
                  "again."
                : "scene.yaml is the scene as resolved, with all that the "
                  "command line said. The same program on the same kind of "
                  "processor gives the same bits for any number of threads.");
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

/* No pages, also while they are written: this one would tell of itself. */
static int is_result(const struct dirent *entry)
{
    return entry->d_name[0] != '.' && !strstr(entry->d_name, ".html");
}

static int by_name(const struct dirent **a, const struct dirent **b)
{
    return strcmp((*a)->d_name, (*b)->d_name);
}

static void write_files(FILE *to, const char *folder)
{
    static const char *const heads[] = {"file", "bytes"};
    struct dirent **entry = NULL;
    const int n = scandir(folder, &entry, is_result, by_name);
    if (n <= 0) {
        free(entry);
        return;
    }
    murk_page_table_begin(to, "Files of the folder", heads, 2);
    for (int i = 0; i < n; ++i) {
        struct stat known;
        char *path = murk_results_path(folder, entry[i]->d_name);
        if (path && i < MURK_PAGE_ROWS_MAX && stat(path, &known) == 0 &&
            S_ISREG(known.st_mode)) {
            murk_page_row_begin(to, entry[i]->d_name);
            murk_page_cell_number(to, (double)known.st_size);
            murk_page_row_end(to);
        }
        free(path);
        free(entry[i]);
    }
    free(entry);
    murk_page_table_end(to);
}

void murk_report_made(FILE *to, const murk_results_in *results)
{
    static const char *const names[MURK_RESULT_FILES] = {
        "plan.json", "coverage.json", "study.json", "fit.json", "ledger.json"};
    bool has_main = false;
    murk_page_section_begin(to, "made", "How it was made");
    write_commands(to, results);
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        /* ledger.json is made by the same run */
        if (results->json[i] && !(i == MURK_RESULT_LEDGER && has_main)) {
            write_run(to, names[i], results->json[i]);
            has_main = true;
        }
    }
    write_files(to, results->folder);
    murk_page_section_end(to);
}
