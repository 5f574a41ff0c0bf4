/* Where the light went, as a section of the report. */
#include "base/file.h"
#include "report/chart_bars.h"
#include "report/html.h"
#include "report/sections.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define FILE_SIZE (CELL + 16) /* a name and the ending of a file */

#define LONG_CELL (CELL + 8)

#define HEADS_MAX (BANDS_MAX + 3) /* and the columns that all have */

#define CELL 160

typedef struct way {
    const char *key, *name;
} way;

static const way ways[] = {{"absorbed_surfaces_w", "absorbed by surfaces"},
                           {"absorbed_media_w", "absorbed by media"},
                           {"escaped_w", "escaped"},
                           {"lost_w", "lost to rounding and limits"}};
#define WAYS (sizeof ways / sizeof *ways)

/* Of {"total": .., "bands": [..]}: the band, or the total for -1. */
static double watts_of(const murk_yaml *ledger, const char *key, long band)
{
    const murk_yaml *at = murk_result_at(ledger, key);
    if (band < 0) {
        return murk_result_number(at, "total");
    }
    return (size_t)band < murk_result_count(at, "bands")
               ? murk_result_number(murk_result_at(at, "bands")->child[band],
                                    "")
               : NAN;
}

/* By its wavelength, where the scene is known; else by its number. */
static void name_band(char out[CELL], size_t band, const murk_scene_desc *scene)
{
    if (scene && band < (size_t)scene->bands) {
        snprintf(out, CELL, "%.6g nm", scene->band_nm[band]);
    } else {
        snprintf(out, CELL, "band %zu", band + 1);
    }
}

/* ---- bars ---- */

/* One of all light, then one of each band where there are several. */
static bool draw_bars(FILE *to, const murk_yaml *ledger, size_t bands,
                      const murk_scene_desc *scene)
{
    const size_t rows = bands > 1 ? bands + 1 : 1;
    const char *part[WAYS];
    double *share = malloc(rows * WAYS * sizeof *share);
    char(*text)[CELL] = malloc(rows * sizeof *text);
    const char **name = malloc(rows * sizeof *name);
    const bool is_whole = share && text && name;
    for (size_t i = 0; is_whole && i < rows; ++i) {
        const long band = (long)i - 1;
        const double emitted = watts_of(ledger, "emitted_w", band);
        if (band < 0) {
            snprintf(text[i], CELL, "all light");
        } else {
            name_band(text[i], (size_t)band, scene);
        }
        name[i] = text[i];
        for (size_t k = 0; k < WAYS; ++k) {
            const double watts = watts_of(ledger, ways[k].key, band);
            share[i * WAYS + k] = emitted > 0 ? watts / emitted : NAN;
        }
    }
    for (size_t k = 0; k < WAYS; ++k) {
        part[k] = ways[k].name;
    }
    const murk_bars bars = {.title = bands > 1 ? "Where the light went, by band"
                                               : "Where the light went",
                            .axis_title = "share of what was emitted",
                            .rows = rows,
                            .parts = WAYS,
                            .name = name,
                            .part = part,
                            .value = share,
                            .scale = MURK_SCALE_SHARE};
    if (is_whole) {
        murk_bars_draw(to, &bars);
    }
    free(share);
    free(text);
    free(name);
    return is_whole;
}

/* ---- the table ---- */

static void write_watts(FILE *to, const char *name, const murk_yaml *of,
                        const murk_yaml *emitted, size_t bands)
{
    const double total = murk_result_number(of, "total");
    const double all = murk_result_number(emitted, "total");
    murk_page_row_begin(to, name);
    murk_page_cell_number(to, total);
    murk_page_cell_share(to, all > 0 ? total / all : NAN, NAN);
    for (size_t b = 0; bands > 1 && b < bands; ++b) {
        const murk_yaml *list = murk_result_at(of, "bands");
        const bool has = b < murk_result_count(of, "bands");
        murk_page_cell_number(to, has ? murk_result_number(list->child[b], "")
                                      : NAN);
    }
    murk_page_row_end(to);
}

static void write_absorbers(FILE *to, const murk_yaml *ledger, const char *path,
                            size_t bands)
{
    const murk_yaml *emitted = murk_result_at(ledger, "emitted_w");
    const murk_yaml *by = murk_result_at(ledger, path);
    const size_t n = by && by->kind == MURK_YAML_MAP ? by->n : 0;
    for (size_t i = 0; i < n && i < MURK_PAGE_ROWS_MAX; ++i) {
        char name[CELL];
        if (murk_result_number(by->child[i], "total") == 0) {
            continue; /* named in the scene, and met by no photon */
        }
        snprintf(name, sizeof name, "of that by %.120s", by->key[i]);
        write_watts(to, name, by->child[i], emitted, bands);
    }
}

#define BANDS_MAX 16

static void write_table(FILE *to, const murk_yaml *ledger, size_t bands,
                        const murk_scene_desc *scene)
{
    char text[BANDS_MAX][LONG_CELL], name[CELL];
    const char *heads[HEADS_MAX] = {"where", "W", "of what was emitted"};
    const murk_yaml *emitted = murk_result_at(ledger, "emitted_w");
    bands = bands < BANDS_MAX ? bands : BANDS_MAX;
    for (size_t b = 0; b < bands; ++b) {
        name_band(name, b, scene);
        snprintf(text[b], sizeof text[b], "%s, W", name);
        heads[3 + b] = text[b];
    }
    murk_page_table_begin(to, "Energy balance", heads,
                          bands > 1 ? bands + 3 : 3);
    write_watts(to, "emitted", emitted, emitted, bands);
    for (size_t k = 0; k < WAYS; ++k) {
        write_watts(to, ways[k].name, murk_result_at(ledger, ways[k].key),
                    emitted, bands);
        if (k == 0) {
            write_absorbers(to, ledger, "absorbed_by_material_w", bands);
        } else if (k == 1) {
            write_absorbers(to, ledger, "absorbed_by_medium_w", bands);
        }
    }
    murk_page_table_end(to);
}

static void write_counts(FILE *to, const murk_yaml *ledger)
{
    murk_page_table_begin(to, "Photons", NULL, 0);
    murk_page_fact_number(to, "left the lights",
                          murk_result_number(ledger, "photons_emitted"), "");
    murk_page_fact_number(to, "collisions in media",
                          murk_result_number(ledger, "collisions"), "");
    murk_page_fact_number(to, "given up after too many events",
                          murk_result_number(ledger, "lost.events"), "");
    murk_page_fact_number(to, "given up after too many wraps",
                          murk_result_number(ledger, "lost.wraps"), "");
    murk_page_fact_number(to, "lost to rounding",
                          murk_result_number(ledger, "lost.numerical"), "");
    murk_page_table_end(to);
}

/* ---- over conditions ---- */

/* ledger-NAME.json, NULL where there is none that can be read. */
static murk_yaml *read_ledger(const char *folder, const char *name)
{
    char file[FILE_SIZE];
    murk_yaml *ledger = NULL;
    murk_error why = {0}; /* a page without this bar is a page */
    snprintf(file, sizeof file, "ledger-%.*s.json", CELL, name);
    if (strchr(name, '/') || !murk_results_has(folder, file)) {
        return NULL;
    }
    char *path = murk_path_join(folder, file);
    if (path) {
        (void)murk_yaml_read(&ledger, path, &why);
    }
    free(path);
    return ledger;
}

/* A bar for each condition; the ledger of each is a file of its own. */
static bool draw_conditions(FILE *to, const murk_results_in *results,
                            const murk_yaml *list, size_t n)
{
    const char *part[WAYS];
    double *share = malloc((n * WAYS + 1) * sizeof *share);
    const char **name = malloc((n + 1) * sizeof *name);
    const bool is_whole = share && name;
    for (size_t i = 0; is_whole && i < n; ++i) {
        const char *text = murk_result_text(list->child[i], "name");
        name[i] = text ? text : "";
        murk_yaml *ledger = read_ledger(results->folder, name[i]);
        const double emitted = watts_of(ledger, "emitted_w", -1);
        for (size_t k = 0; k < WAYS; ++k) {
            const double watts = watts_of(ledger, ways[k].key, -1);
            share[i * WAYS + k] = emitted > 0 ? watts / emitted : NAN;
        }
        murk_yaml_destroy(ledger);
    }
    for (size_t k = 0; k < WAYS; ++k) {
        part[k] = ways[k].name;
    }
    const murk_bars bars = {.title = "Where the light went, by condition",
                            .axis_title = "share of what was emitted",
                            .rows = n,
                            .parts = WAYS,
                            .name = name,
                            .part = part,
                            .value = share,
                            .scale = MURK_SCALE_SHARE};
    if (is_whole) {
        murk_bars_draw(to, &bars);
    }
    free(share);
    free(name);
    return is_whole;
}

static murk_status report_conditions(FILE *to, const murk_results_in *results,
                                     murk_error *err)
{
    const murk_yaml *plan = results->json[MURK_RESULT_PLAN];
    const size_t n = murk_result_count(plan, "conditions");
    if (n == 0) {
        return MURK_OK;
    }
    murk_page_section_begin(to, "light", "Where the light went");
    const bool is_whole =
        draw_conditions(to, results, murk_result_at(plan, "conditions"),
                        n < MURK_BARS_MAX ? n : MURK_BARS_MAX);
    murk_page_paragraph(to, "In watts, and by what absorbed it, it is in the "
                            "file ledger-NAME.json of each condition.");
    murk_page_section_end(to);
    return is_whole
               ? MURK_OK
               : murk_fail(err, MURK_NO_MEMORY, "", "no memory for the plots");
}

murk_status murk_report_light(FILE *to, const murk_results_in *results,
                              const murk_scene_desc *scene, murk_error *err)
{
    const murk_yaml *ledger = results->json[MURK_RESULT_LEDGER];
    if (!ledger) {
        return report_conditions(to, results, err);
    }
    const size_t bands = murk_result_count(ledger, "emitted_w.bands");
    murk_page_section_begin(to, "light", "Where the light went");
    const bool is_whole = draw_bars(to, ledger, bands, scene);
    write_table(to, ledger, bands, scene);
    write_counts(to, ledger);
    murk_page_section_end(to);
    return is_whole
               ? MURK_OK
               : murk_fail(err, MURK_NO_MEMORY, "", "no memory for the plots");
}
