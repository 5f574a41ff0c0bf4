/* The CSV files of a result folder as tables of the page.
 *
 * They are in a <noscript> element: a browser without scripts shows them, and
 * with scripts the script of the page reads them there
 * (tools/report/results.js), so that no file is in the page twice. Each table
 * is cut at about TABLE_BYTES. Tables that the script does not need are left
 * out if the file is larger than FILE_BYTES_MAX or cannot be read, or once the
 * tables take ALL_BYTES. */
#include "report/sections.h"

#include "base/file.h"
#include "report/html.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* About the largest number of bytes of one table, and of all tables together:
 * the page should stay below 3 MB with its script, photons and pictures. Tables
 * that the script needs count towards ALL_BYTES, but are written, up to
 * TABLE_BYTES each, also beyond it. */
#define TABLE_BYTES 250000
#define ALL_BYTES   700000

/* Larger files are left out, unless the script of the page needs them. */
#define FILE_BYTES_MAX 16000000

/* True if the script of the page draws from this file, so that a failure to
 * read it is an error. */
static bool is_drawn(const murk_results_in *results, const char *name)
{
    const murk_yaml *plan = results->json[MURK_RESULT_PLAN];
    return strcmp(name, "tallies.csv") == 0 ||
           (strcmp(name, "table.csv") == 0 &&
            results->json[MURK_RESULT_STUDY]) ||
           (strcmp(name, "fit.csv") == 0 &&
            murk_results_has_readings(results)) ||
           (strcmp(name, "moves.csv") == 0 &&
            results->json[MURK_RESULT_FOLLOW]) ||
           (strcmp(name, "repeat.csv") == 0 &&
            isfinite(murk_result_number(plan, "repeat.runs")));
}

static size_t write_row(FILE *to, char *const *cell, size_t n, const char *tag)
{
    size_t bytes = sizeof "<tr></tr>\n";
    fputs("<tr>", to);
    for (size_t i = 0; i < n; ++i) {
        fprintf(to, "<%s>", tag);
        murk_html_text(to, cell[i]);
        fprintf(to, "</%s>", tag);
        bytes += strlen(cell[i]) + sizeof "<td></td>";
    }
    fputs("</tr>\n", to);
    return bytes;
}

/* Writes a table, and a note if it is cut. Returns about how many bytes were
 * written. */
static size_t write_table(FILE *to, const char *name, const murk_table *table,
                          size_t bytes_max)
{
    fputs("<div class=\"table\">\n<table data-file=\"", to);
    murk_html_text(to, name);
    fprintf(to, "\" data-rows=\"%zu\">\n<caption>", table->rows);
    murk_html_text(to, name);
    fputs("</caption>\n<thead>", to);
    size_t bytes = write_row(to, table->name, table->columns, "th");
    fputs("</thead>\n<tbody>\n", to);
    size_t row = 0;
    for (; row < table->rows && bytes < bytes_max; ++row) {
        bytes += write_row(to, table->cell + row * table->columns,
                           table->columns, "td");
    }
    fputs("</tbody>\n</table>\n</div>\n", to);
    if (row < table->rows) {
        fprintf(to, "<p class=\"note\">The first %zu of %zu rows.</p>\n", row,
                table->rows);
    }
    return bytes;
}

/* Reads one CSV file and writes it as a table of at most about TABLE_BYTES.
 * Lowers *left, the number of bytes left for all tables, by about the bytes
 * written. A file that the script does not need is left out if it is larger
 * than FILE_BYTES_MAX, if it cannot be read, or if *left is 0; its table is cut
 * at *left bytes at most. Fails if a file that the script needs cannot be read,
 * or if there is no memory for a table. */
static murk_status add_file(FILE *to, const murk_results_in *results,
                            const char *name, size_t *left, murk_error *err)
{
    const bool is_needed = is_drawn(results, name);
    murk_table *table = NULL;
    murk_error why = {0};
    struct stat known = {0};
    char *path = murk_path_join(results->folder, name);
    const bool is_small =
        path && stat(path, &known) == 0 && known.st_size <= FILE_BYTES_MAX;
    free(path);
    if (!is_needed && !(is_small && *left > 0)) {
        return MURK_OK;
    }
    const murk_status status = murk_results_table(&table, results->folder, name,
                                                  is_needed ? err : &why);
    if (table) {
        const size_t bytes_max =
            *left < TABLE_BYTES && !is_needed ? *left : TABLE_BYTES;
        const size_t bytes = write_table(to, name, table, bytes_max);
        *left -= bytes < *left ? bytes : *left;
    }
    murk_table_destroy(table);
    return is_needed || status == MURK_NO_MEMORY ? status : MURK_OK;
}

murk_status murk_report_csv(FILE *to, const murk_results_in *results,
                            murk_error *err)
{
    size_t left = ALL_BYTES, n = 0;
    murk_status status = MURK_OK;
    for (int i = 0; i < results->entries && !status; ++i) {
        const char *name = results->entry[i]->d_name;
        if (murk_name_ends(name, ".csv")) {
            if (n++ == 0) {
                fprintf(to, "<noscript>\n<section>\n<h2>Tables%s</h2>\n",
                        results->made_by ? "" : " of the folder");
            }
            status = add_file(to, results, name, &left, err);
        }
    }
    fputs(n > 0 ? "</section>\n</noscript>\n" : "", to);
    return status;
}
