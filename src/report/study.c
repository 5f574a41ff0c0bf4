/* A study, as a section of the report: of each output a plot against the axis
 * with the most values, a line for each combination of the others. */
#include "report/study.h"
#include "base/calendar.h"
#include "base/number.h"
#include "report/chart.h"
#include "report/html.h"
#include "report/sections.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TITLE_SIZE (2 * NAME_SIZE)

#define PLOTS_MAX 24
#define NAME_SIZE 160

/* From this ratio on, an axis of positive numbers is drawn by logarithms. */
#define LOG_RATIO   20
#define LOG_RATIO_Y 50

typedef struct frame {
    const murk_table *table;
    size_t axes;        /* the table's first columns */
    size_t along;       /* the axis that is drawn against */
    size_t lines;       /* combinations of the others */
    size_t *line_of;    /* [table->rows] */
    size_t *first;      /* [lines] a row of each */
    size_t values;      /* different ones along the axis */
    const char **value; /* [values] in the table's order */
    double *x;          /* [table->rows] */
    murk_axis_scale scale;
    bool is_number;
} frame;

static const char *cell(const frame *f, size_t row, size_t column)
{
    return f->table->cell[row * f->table->columns + column];
}

static double number(const frame *f, size_t row, size_t column)
{
    double value = NAN;
    return murk_number_parse(cell(f, row, column), &value) ? value : NAN;
}

static size_t count_values(const frame *f, size_t axis)
{
    size_t n = 0;
    for (size_t i = 0; i < f->table->rows && n < PLOTS_MAX * PLOTS_MAX; ++i) {
        bool is_new = true;
        for (size_t k = 0; k < i && is_new; ++k) {
            is_new = strcmp(cell(f, i, axis), cell(f, k, axis)) != 0;
        }
        n += is_new;
    }
    return n;
}

static bool same_line(const frame *f, size_t a, size_t b, bool is_paired)
{
    for (size_t k = 0; k < f->axes && !is_paired; ++k) {
        if (k != f->along && strcmp(cell(f, a, k), cell(f, b, k)) != 0) {
            return false;
        }
    }
    return true;
}

static void find_lines(frame *f, bool is_paired)
{
    for (size_t i = 0; i < f->table->rows; ++i) {
        size_t line = 0;
        while (line < f->lines && !same_line(f, i, f->first[line], is_paired)) {
            ++line;
        }
        f->line_of[i] = line;
        if (line == f->lines) {
            f->first[f->lines++] = i;
        }
    }
}

/* "06:30" or "06:30:00" as hours. */
static bool read_clock(const char *text, double *hours)
{
    double seconds;
    const bool is_clock = murk_clock_read(text, &seconds);
    *hours = is_clock ? seconds / 3600 : NAN;
    return is_clock;
}

/* Numbers as they are, hours as hours, else the words one after the other. */
static void find_places(frame *f)
{
    double min = INFINITY, min_above_0 = INFINITY, max = -INFINITY;
    bool is_number = true, is_clock = true;
    for (size_t i = 0; i < f->table->rows; ++i) {
        const char *text = f->axes > 0 ? cell(f, i, f->along) : "1";
        size_t k = 0;
        while (k < f->values && strcmp(text, f->value[k]) != 0) {
            ++k;
        }
        if (k == f->values) {
            f->value[f->values++] = text;
        }
        f->x[i] = (double)k;
        double value = NAN, hours;
        is_number = is_number && murk_number_parse(text, &value);
        is_clock = is_clock && read_clock(text, &hours);
        min = fmin(min, value);
        min_above_0 = value > 0 ? fmin(min_above_0, value) : min_above_0;
        max = fmax(max, value);
    }
    /* 0, 0.1, 1, 10: neither as they are nor by logarithms */
    const double ratio = min == 0 ? max / min_above_0 : 0;
    if (ratio > LOG_RATIO && (double)f->values < ratio / 4) {
        return;
    }
    f->is_number = is_number || is_clock;
    f->scale = is_number && min > 0 && max > LOG_RATIO * min ? MURK_SCALE_LOG
               : is_clock                                    ? MURK_SCALE_CLOCK
                                                             : MURK_SCALE_EVEN;
    for (size_t i = 0; f->is_number && f->axes > 0 && i < f->table->rows; ++i) {
        if (is_clock) {
            (void)read_clock(cell(f, i, f->along), &f->x[i]);
        } else {
            f->x[i] = number(f, i, f->along);
        }
    }
}

static bool make_frame(frame *f, bool is_paired)
{
    const size_t rows = f->table->rows;
    f->line_of = calloc(rows + 1, sizeof *f->line_of);
    f->first = calloc(rows + 1, sizeof *f->first);
    f->value = calloc(rows + 1, sizeof *f->value);
    f->x = calloc(rows + 1, sizeof *f->x);
    if (!f->line_of || !f->first || !f->value || !f->x) {
        return false;
    }
    size_t max = 0;
    for (size_t k = 0; k < f->axes && !is_paired; ++k) {
        const size_t n = count_values(f, k);
        if (n > max) {
            max = n;
            f->along = k;
        }
    }
    find_lines(f, is_paired);
    find_places(f);
    return true;
}

static void release_frame(frame *f)
{
    free(f->line_of);
    free(f->first);
    free(f->value);
    free(f->x);
}

/* ---- a plot ---- */

static void name_line(char out[NAME_SIZE], const frame *f, size_t line,
                      const char *output, bool is_paired)
{
    size_t at = 0;
    out[0] = '\0';
    for (size_t k = 0; k < f->axes && !is_paired && at < NAME_SIZE; ++k) {
        if (k == f->along) {
            continue;
        }
        const int n =
            snprintf(out + at, NAME_SIZE - at, "%s%s %s", at > 0 ? ", " : "",
                     f->table->name[k], cell(f, f->first[line], k));
        at += n > 0 ? (size_t)n : 0;
    }
    if (at == 0) {
        snprintf(out, NAME_SIZE, "%s", output);
    }
}

static const char *unit_of(const murk_yaml *study, const char *output)
{
    const size_t rows = murk_result_count(study, "rows");
    const murk_yaml *list = murk_result_at(study, "rows");
    for (size_t i = 0; i < rows; ++i) {
        const murk_yaml *values = murk_result_at(list->child[i], "values");
        const murk_yaml *value = values && values->kind == MURK_YAML_MAP
                                     ? murk_yaml_get(values, output)
                                     : NULL;
        const char *unit = murk_result_text(value, "unit");
        if (unit) {
            return unit;
        }
    }
    return "";
}

static bool spans_decades(const frame *f, size_t column)
{
    double min = INFINITY, max = -INFINITY;
    for (size_t i = 0; i < f->table->rows; ++i) {
        min = fmin(min, number(f, i, column));
        max = fmax(max, number(f, i, column));
    }
    return min > 0 && max > LOG_RATIO_Y * min;
}

static bool draw_output(FILE *to, const frame *f, const murk_yaml *study,
                        size_t column, bool is_paired)
{
    const size_t rows = f->table->rows;
    const size_t lines =
        f->lines < MURK_CHART_SERIES_MAX ? f->lines : MURK_CHART_SERIES_MAX;
    const char *output = f->table->name[column];
    const char *unit = unit_of(study, output);
    murk_chart_series series[MURK_CHART_SERIES_MAX] = {0};
    char names[MURK_CHART_SERIES_MAX][NAME_SIZE];
    double *room = malloc((4 * rows * lines + 1) * sizeof *room);
    if (!room) {
        return false;
    }
    for (size_t k = 0; k < lines; ++k) {
        const size_t line = k * f->lines / lines; /* evenly chosen */
        double *x = room + 4 * rows * k, *y = x + rows;
        double *low = y + rows, *high = low + rows;
        size_t n = 0;
        for (size_t i = 0; i < rows; ++i) {
            if (f->line_of[i] != line) {
                continue;
            }
            const double error = number(f, i, column + 1);
            x[n] = f->x[i];
            y[n] = number(f, i, column);
            low[n] = y[n] - (isfinite(error) ? 1.96 * error : 0);
            high[n] = y[n] + (isfinite(error) ? 1.96 * error : 0);
            ++n;
        }
        name_line(names[k], f, line, output, is_paired);
        series[k] = (murk_chart_series){.name = names[k],
                                        .n = n,
                                        .x = x,
                                        .y = y,
                                        .low = low,
                                        .high = high,
                                        .is_line = true};
    }
    const bool has_unit = *unit && strcmp(unit, "1") != 0;
    char title[TITLE_SIZE], y_title[NAME_SIZE];
    if (lines < f->lines) {
        snprintf(title, sizeof title,
                 "%.160s, with 95 %% intervals (%zu of %zu lines; all are in "
                 "table.csv)",
                 output, lines, f->lines);
    } else {
        snprintf(title, sizeof title, "%.200s, with 95 %% intervals", output);
    }
    snprintf(y_title, sizeof y_title, "%.100s%s%.40s", output,
             has_unit ? ", " : "", has_unit ? unit : "");
    const murk_chart chart = {
        .title = title,
        .x_title = f->axes > 0 ? f->table->name[f->along] : "",
        .y_title = y_title,
        .x_name = f->is_number ? NULL : f->value,
        .x_names = f->is_number ? 0 : f->values,
        .x = f->scale,
        .y = murk_study_is_share(output) ? MURK_SCALE_SHARE
             : spans_decades(f, column)  ? MURK_SCALE_LOG
                                         : MURK_SCALE_EVEN};
    murk_chart_draw(to, &chart, series, lines);
    free(room);
    return true;
}

/* Plots and rows of all light's outputs, or of the bands'. */
static bool write_outputs(FILE *to, const frame *f, const murk_yaml *study,
                          bool is_paired, bool of_bands)
{
    const murk_table *t = f->table;
    bool is_whole = true;
    size_t plots = 0;
    fputs("<div class=\"plans\">\n", to);
    for (size_t c = f->axes; is_whole && c < t->columns; ++c) {
        if (murk_study_is_output(t, c)) {
            if (murk_study_is_of_band(t->name[c]) == of_bands &&
                plots++ < PLOTS_MAX) {
                is_whole = draw_output(to, f, study, c, is_paired);
            }
            ++c;
        }
    }
    fputs("</div>\n", to);
    if (plots > PLOTS_MAX) {
        fprintf(to, "<p class=\"note\">%d of %zu outputs are drawn.</p>\n",
                PLOTS_MAX, plots);
    }
    return is_whole && murk_report_study_rows(to, t, f->axes, of_bands);
}

static bool has_bands(const frame *f)
{
    for (size_t c = f->axes; c < f->table->columns; ++c) {
        if (murk_study_is_output(f->table, c) &&
            murk_study_is_of_band(f->table->name[c])) {
            return true;
        }
    }
    return false;
}

static bool write_table(FILE *to, const murk_table *table,
                        const murk_yaml *study)
{
    const char *mode = murk_result_text(study, "mode");
    const bool is_paired = mode && strcmp(mode, "paired") == 0;
    const size_t axes = murk_result_count(study, "axes");
    frame f = {.table = table,
               .axes = axes < table->columns ? axes : table->columns};
    bool is_whole = make_frame(&f, is_paired) &&
                    write_outputs(to, &f, study, is_paired, false);
    if (is_whole && has_bands(&f)) {
        fputs("<details><summary>The same band by band</summary>\n", to);
        is_whole = write_outputs(to, &f, study, is_paired, true);
        fputs("</details>\n", to);
    }
    release_frame(&f);
    return is_whole;
}

murk_status murk_report_study(FILE *to, const murk_results_in *results,
                              murk_error *err)
{
    const murk_yaml *study = results->json[MURK_RESULT_STUDY];
    murk_table *table = NULL;
    if (!study) {
        return MURK_OK;
    }
    murk_status status =
        murk_results_table(&table, results->folder, "table.csv", err);
    if (status) {
        return status;
    }
    murk_page_section_begin(to, "study", "The study");
    if (table && !write_table(to, table, study)) {
        status = murk_fail(err, MURK_NO_MEMORY, "", "no memory for the plots");
    } else if (!table) {
        murk_page_paragraph(to, "There is no table.csv beside study.json.");
    }
    murk_report_study_failed(to, study);
    murk_report_study_plans(to, study);
    murk_page_section_end(to);
    murk_table_destroy(table);
    return status;
}
