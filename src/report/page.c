/* The page of a result folder: reads everything that the page shows, then
 * writes it. The page has the summaries of the runs and the commands that make
 * them again as text, and pictures; the rest is data, which the script of the
 * page draws (tools/report). Without scripts, the CSV files are shown as
 * tables. The page loads nothing: its content security policy allows only its
 * own style and script, by their hashes, and images that are part of it. */
#include "report/report.h"

#include "base/file.h"
#include "base/interrupt.h"
#include "base/version.h"
#include "report/data.h"
#include "report/fields.h"
#include "report/html.h"
#include "report/pictures.h"
#include "report/scene.h"
#include "report/sections.h"
#include "report/view_data.h"
#include "report/web_files.h"

#include <stdlib.h>
#include <string.h>

#define NAME_SIZE 256 /* of a title; longer names are cut at 200 bytes */
#define FILE_SIZE 176 /* of "ledger-NAME.json", NAME that of a condition */

/* Largest number of bytes of a JSON file in the page. In each file, lists and
 * maps are cut to the first of these numbers of items with which the file fits,
 * or to the last of these numbers. */
#define JSON_BYTES_MAX 300000
static const size_t list_max[] = {2000, 200, 60, 10, 1};

struct murk_report {
    murk_results_in results;
    murk_report_fields fields;
    murk_report_scene scene;
    murk_report_pictures pictures;
    const char *page; /* path of the page, borrowed */
};

/* ---- head ---- */

/* The name of the folder, also if it was given as ".". */
static const char *folder_name(const murk_results_in *results)
{
    const char *slash = strrchr(results->whole, '/');
    return slash && slash[1] ? slash + 1 : results->whole;
}

/* The name of the study file, else of the scene file, else of the folder,
 * without the folders before the name and without the ending. */
static void name_of(char out[NAME_SIZE], const murk_results_in *results)
{
    const char *path =
        murk_result_text(results->json[MURK_RESULT_STUDY], "study");
    for (int i = 0; !path && i < MURK_RESULT_FILES; ++i) {
        path = murk_result_text(results->json[i], "scene");
    }
    path = path ? path : folder_name(results);
    const char *slash = strrchr(path, '/');
    path = slash && slash[1] ? slash + 1 : path;
    const char *dot = strrchr(path, '.');
    const size_t length =
        dot && dot > path ? (size_t)(dot - path) : strlen(path);
    snprintf(out, NAME_SIZE, "%.*s", (int)(length < 200 ? length : 200), path);
}

static void write_head(FILE *to, const char *name, bool has_pictures)
{
    const murk_built_in_file *css =
        murk_built_in_find(&murk_web_files, "page.css");
    const murk_built_in_file *js =
        murk_built_in_find(&murk_web_files, "page.js");
    char style[MURK_HTML_HASH_SIZE], script[MURK_HTML_HASH_SIZE];
    murk_html_hash(style, css->text, css->size);
    murk_html_hash(script, js->text, js->size);
    fprintf(to,
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n"
            "<meta charset=\"utf-8\">\n"
            "<meta http-equiv=\"Content-Security-Policy\" content=\""
            "default-src &#39;none&#39;; style-src &#39;%s&#39;; "
            "script-src &#39;%s&#39;; %s"
            "base-uri &#39;none&#39;; form-action &#39;none&#39;\">\n"
            "<meta name=\"viewport\" content=\"width=device-width\">\n"
            "<meta name=\"generator\" content=\"murk %s\">\n"
            "<title>",
            style, script, has_pictures ? "img-src data:; " : "", MURK_VERSION);
    murk_html_text(to, name);
    fputs(" \xe2\x80\x93 murk</title>\n<style>", to);
    (void)fwrite(css->text, 1, css->size, to);
    fputs("</style>\n</head>\n", to);
}

/* ---- data ---- */

/* True for parts of a main JSON about its run and its files, which are no data
 * of the page. */
static bool is_of_one_run(const char *key)
{
    return strcmp(key, "run") == 0 || strcmp(key, "murk") == 0 ||
           strcmp(key, "files") == 0 || strcmp(key, "identity") == 0;
}

static void write_json(murk_data *data, const char *key, const murk_yaml *root,
                       size_t items_max)
{
    murk_data_begin(data, key, '{');
    for (size_t i = 0; i < murk_result_entries(root); ++i) {
        if (!is_of_one_run(root->key[i])) {
            murk_data_yaml(data, root->key[i], root->child[i], items_max);
        }
    }
    murk_data_end(data, '}');
}

/* True if the JSON is at most JSON_BYTES_MAX long with lists and maps cut to
 * this number of items. */
static bool fits(const murk_yaml *root, size_t items_max)
{
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    if (to) {
        murk_data data = {.to = to};
        write_json(&data, NULL, root, items_max);
        (void)fclose(to);
    }
    free(text);
    return size <= JSON_BYTES_MAX;
}

static void add_json(murk_data *data, const char *key, const murk_yaml *root)
{
    size_t k = 0;
    while (k + 1 < sizeof list_max / sizeof *list_max &&
           !fits(root, list_max[k])) {
        ++k;
    }
    write_json(data, key, root, list_max[k]);
}

/* Adds the ledger of each condition, from the file ledger-NAME.json. Ledgers
 * that cannot be read are left out. */
static void add_ledgers(murk_data *data, const murk_results_in *results)
{
    const murk_yaml *plan = results->json[MURK_RESULT_PLAN];
    const size_t n = murk_result_count(plan, "conditions");
    const murk_yaml *list = murk_result_at(plan, "conditions");
    murk_data_begin(data, "ledgers", '{');
    for (size_t i = 0; i < n && i < MURK_REPORT_ROWS_MAX; ++i) {
        char file[FILE_SIZE];
        murk_yaml *ledger = NULL;
        murk_error why = {0};
        const char *name = murk_result_text(list->child[i], "name");
        snprintf(file, sizeof file, "ledger-%.*s.json", FILE_SIZE - 16,
                 name ? name : "");
        char *path = name && !strchr(name, '/')
                         ? murk_results_path(results->folder, file)
                         : NULL;
        if (path && !murk_yaml_read(&ledger, path, &why)) {
            add_json(data, name, ledger);
        }
        murk_yaml_destroy(ledger);
        free(path);
    }
    murk_data_end(data, '}');
}

static murk_status write_data(FILE *to, const murk_report *c, murk_error *err)
{
    const murk_scene_desc *scene = c->results.scene;
    /* the main JSON files, ledgers of conditions, and what the plots need */
    murk_data data = murk_data_open(to, "results");
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        if (c->results.json[i]) {
            add_json(&data, murk_result_kinds[i].key, c->results.json[i]);
        }
    }
    add_ledgers(&data, &c->results);
    murk_data_numbers(&data, "bands_nm", scene ? scene->band_nm : NULL,
                      scene ? (size_t)scene->bands : 0);
    murk_data_text(&data, "note", c->scene.note);
    murk_status status = murk_report_tallies(&data, &c->results, err);
    murk_report_fields_add(&data, &c->fields);
    murk_data_close(&data);
    return status || !murk_report_has_view(&c->scene)
               ? status
               : murk_view_data_write(to, &c->scene, err);
}

/* ---- the page ---- */

static murk_status write_page(FILE *to, const murk_report *c, murk_error *err)
{
    char name[NAME_SIZE];
    const char *made_by = c->results.made_by;
    name_of(name, &c->results);
    write_head(to, name, c->pictures.carried > 0);
    fputs("<body>\n<a class=\"skip\" href=\"#main\">To the results</a>\n"
          "<header>\n<h1>",
          to);
    murk_html_text(to, name);
    fputs("</h1>\n<p class=\"note\">Light and sensors, simulated by "
          "murk " MURK_VERSION ". Results of ",
          to);
    fputs(made_by ? "" : "the folder ", to);
    murk_html_text(to, made_by ? made_by : folder_name(&c->results));
    /* Contents in this order: the readable part (summary, tables, pictures,
     * commands), the data, and the script, which draws from tables and data. */
    fputs(".</p>\n</header>\n<main id=\"main\" tabindex=\"-1\">\n", to);
    murk_report_summary(to, &c->results);
    murk_status status = murk_report_csv(to, &c->results, err);
    murk_report_pictures_write(to, &c->pictures);
    murk_report_made(to, &c->results, c->page);
    fputs("</main>\n<footer>Made by murk report, version " MURK_VERSION
          ". This page is one file and loads nothing from elsewhere."
          "</footer>\n",
          to);
    if (!status) {
        status = write_data(to, c, err);
    }
    const murk_built_in_file *js =
        murk_built_in_find(&murk_web_files, "page.js");
    fputs("<script>", to);
    (void)fwrite(js->text, 1, js->size, to);
    fputs("</script>\n</body>\n</html>\n", to);
    return status;
}

murk_status murk_report_write(murk_report *c, const char *path, murk_error *err)
{
    murk_file *file = NULL;
    c->page = path;
    murk_status status = murk_file_create(&file, path, err);
    if (!status) {
        status = write_page(murk_file_stream(file), c, err);
    }
    if (!status && murk_interrupted()) {
        /* The page is given up, because it would lack what was not read because
         * of the interrupt. */
        status = murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    if (!status) {
        status = murk_file_commit(&file, err);
    }
    murk_file_discard(file);
    return status;
}

/* ---- reading ---- */

murk_status murk_report_read(murk_report **out, const char *folder,
                             const char *made_by, murk_error *err)
{
    murk_report *c = calloc(1, sizeof *c);
    *out = c;
    if (!c) {
        return murk_no_memory(err, "", "for the page");
    }
    murk_status status = murk_results_read(&c->results, folder, err);
    c->results.made_by = made_by;
    if (!status) {
        c->results.strangers = murk_results_strangers(&c->results);
        /* The grids are read before there is a ray device, because subprocesses
         * read them. */
        status = murk_report_fields_read(&c->fields, &c->results, err);
    }
    if (!status) {
        status = murk_report_pictures_read(&c->pictures, &c->results, err);
    }
    return status ? status
                  : murk_report_scene_read(&c->scene, &c->results, err);
}

void murk_report_destroy(murk_report *report)
{
    if (report) {
        murk_report_scene_release(&report->scene);
        murk_report_pictures_release(&report->pictures);
        murk_report_fields_release(&report->fields);
        murk_results_release(&report->results);
        free(report);
    }
}

murk_report_facts murk_report_describe(const murk_report *report)
{
    murk_report_facts facts = {.results = &report->results,
                               .sensors = report->scene.state[0].sensors};
    for (size_t i = 0; i < report->scene.states; ++i) {
        facts.photons += report->scene.state[i].points.photons;
        facts.photons_shown += report->scene.state[i].points.n;
    }
    return facts;
}
