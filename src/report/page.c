/* The page of a result folder: reads all that it shows, then writes it.
 *
 * The page asks nobody for anything: its content security policy allows its
 * own style and script alone, by their hashes. */
#include "report/report.h"

#include "base/file.h"
#include "base/interrupt.h"
#include "base/version.h"
#include "report/html.h"
#include "report/pictures.h"
#include "report/scene.h"
#include "report/sections.h"
#include "report/web_files.h"

#include <stdlib.h>
#include <string.h>

#define NAME_SIZE 256

struct murk_report {
    murk_results_in results;
    murk_report_fields fields;
    murk_report_scene scene;
    murk_report_pictures pictures;
    const char *page; /* its own path, borrowed */
};

static const murk_web_file *find_file(const char *name)
{
    for (size_t i = 0; i < murk_web_files_count; ++i) {
        if (strcmp(murk_web_files[i].name, name) == 0) {
            return &murk_web_files[i];
        }
    }
    return NULL;
}

/* ---- head ---- */

/* The folder's own name, also where it was given as ".". */
static const char *folder_name(const murk_results_in *results)
{
    const char *slash = strrchr(results->whole, '/');
    return slash && slash[1] ? slash + 1 : results->whole;
}

/* The scene's or study's name without folder and ending; else the folder's. */
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
    const murk_web_file *css = find_file("page.css");
    const murk_web_file *view = find_file("view.js");
    char style[MURK_PAGE_HASH_SIZE], script[MURK_PAGE_HASH_SIZE];
    murk_page_hash(style, css->text, css->size);
    murk_page_hash(script, view->text, view->size);
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
    murk_page_text(to, name);
    fputs(" \xe2\x80\x93 murk</title>\n<style>", to);
    (void)fwrite(css->text, 1, css->size, to);
    fputs("</style>\n</head>\n", to);
}

static void write_contents(FILE *to, const murk_report *c)
{
    const murk_results_in *results = &c->results;
    const bool has_plan =
        results->json[MURK_RESULT_PLAN] || results->json[MURK_RESULT_COVERAGE];
    const struct {
        const char *id, *title;
        bool is_there;
    } parts[] = {
        {"summary", "In short", true},
        {"placement", "Placement", has_plan},
        {"where", "Where they are",
         murk_report_has_view(&c->scene) || c->scene.note[0]},
        {"pictures", "Pictures", c->pictures.n + c->pictures.n_exr > 0},
        {"study", "Study", results->json[MURK_RESULT_STUDY] != NULL},
        {"calibration", "Calibration", results->json[MURK_RESULT_FIT] != NULL},
        {"light", "Light",
         results->json[MURK_RESULT_LEDGER] ||
             murk_result_count(results->json[MURK_RESULT_PLAN], "conditions") >
                 0},
        {"tallies", "Tallies",
         murk_results_has(results->folder, "tallies.csv")},
        {"made", "How it was made", true}};
    fputs("<nav aria-label=\"Contents\"><ul>\n", to);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; ++i) {
        if (parts[i].is_there) {
            fprintf(to, "<li><a href=\"#%s\">%s</a></li>\n", parts[i].id,
                    parts[i].title);
        }
    }
    fputs("</ul></nav>\n", to);
}

/* ---- the page ---- */

static murk_status write_parts(FILE *to, const murk_report *c, murk_error *err)
{
    const murk_results_in *results = &c->results;
    murk_report_summary(to, results);
    murk_status status = murk_report_plan(to, results, err);
    if (!status) {
        status = murk_report_plans(to, &c->scene, err);
    }
    murk_report_pictures_write(to, &c->pictures);
    if (!status) {
        status = murk_report_study(to, results, err);
    }
    if (!status) {
        status = murk_report_fit(to, results, err);
    }
    if (!status) {
        status = murk_report_light(to, results, c->fields.scene, err);
    }
    if (!status) {
        status = murk_report_tallies(to, results, &c->fields, err);
    }
    murk_report_made(to, results, c->page);
    return status;
}

static murk_status write_page(FILE *to, const murk_report *c, murk_error *err)
{
    char name[NAME_SIZE];
    name_of(name, &c->results);
    write_head(to, name, c->pictures.carried > 0);
    fputs("<body>\n<a class=\"skip\" href=\"#main\">To the results</a>\n"
          "<header>\n<h1>",
          to);
    murk_page_text(to, name);
    fputs("</h1>\n<p class=\"note\">Light and sensors, simulated by "
          "murk " MURK_VERSION ". Results of the folder ",
          to);
    murk_page_text(to, folder_name(&c->results));
    fputs(".</p>\n", to);
    write_contents(to, c);
    fputs("</header>\n<main id=\"main\" tabindex=\"-1\">\n", to);
    const murk_status status = write_parts(to, c, err);
    fputs("</main>\n<footer>Made by murk report, version " MURK_VERSION
          ". This page is one file and loads nothing from elsewhere."
          "</footer>\n",
          to);
    if (murk_report_has_view(&c->scene)) {
        const murk_web_file *view = find_file("view.js");
        fputs("<script>", to);
        (void)fwrite(view->text, 1, view->size, to);
        fputs("</script>\n", to);
    }
    fputs("</body>\n</html>\n", to);
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
        /* what was not read because of it is missing in the page */
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
                             murk_error *err)
{
    murk_report *c = calloc(1, sizeof *c);
    *out = c;
    if (!c) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the page");
    }
    murk_status status = murk_results_read(&c->results, folder, err);
    if (!status) {
        c->results.strangers = murk_results_strangers(&c->results);
        /* by children: before there is any ray device */
        status = murk_report_fields_read(&c->fields, &c->results, err);
    }
    if (!status) {
        status = murk_report_pictures_read(&c->pictures, folder, err);
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
                               .sensors = report->scene.sensors};
    for (size_t i = 0; i < report->scene.states; ++i) {
        facts.photons += report->scene.state[i].points.photons;
        facts.photons_shown += report->scene.state[i].points.n;
    }
    return facts;
}
