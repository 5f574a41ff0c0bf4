/* Where the light went, as a section of the report. */
#include "app/page.h"
#include "app/report.h"

#include <math.h>

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
