/* What was asked of a study, a fit or light alone, and the answer. */
#include "report/answers.h"
#include "report/fit.h"
#include "report/html.h"
#include "report/study.h"

#include <math.h>
#include <string.h>

#define SHOWN_MAX   8 /* keys */
#define OUTPUTS_MAX 12

static void strong_share(FILE *to, double share, double standard_error)
{
    fputs("<strong>", to);
    murk_page_share(to, share, standard_error);
    fputs("</strong>", to);
}

/* ---- a study ---- */

static void ask_study(FILE *to, const murk_yaml *study)
{
    const size_t axes = murk_result_count(study, "axes");
    const murk_yaml *list = murk_result_at(study, "axes");
    murk_page_line_begin(to, "Asked");
    fputs("How do the results change with ", to);
    for (size_t i = 0; i < axes && i < SHOWN_MAX; ++i) {
        fputs(i == 0 ? "" : i + 1 < axes ? ", " : " and ", to);
        murk_page_text(to, murk_result_text(list->child[i], "key"));
        fputs(" (", to);
        murk_page_count(to, (double)murk_result_count(list->child[i], "values"),
                        "value", "values");
        fputc(')', to);
    }
    fputs(axes == 0 ? "nothing: one run?" : "?", to);
    murk_page_line_end(to);
}

typedef struct extreme {
    double value, error;
    size_t row; /* from 1 */
} extreme;

/* Least and most of an output over all rows; false where no row has it. */
static bool find_extremes(extreme out[2], const murk_yaml *rows, size_t n,
                          const char *output)
{
    out[0] = (extreme){.value = INFINITY};
    out[1] = (extreme){.value = -INFINITY};
    for (size_t i = 0; i < n; ++i) {
        const murk_yaml *values = murk_result_at(rows->child[i], "values");
        const murk_yaml *one = values && values->kind == MURK_YAML_MAP
                                   ? murk_yaml_get(values, output)
                                   : NULL;
        const extreme e = {murk_result_number(one, "value"),
                           murk_result_number(one, "standard_error"), i + 1};
        out[0] = e.value < out[0].value ? e : out[0];
        out[1] = e.value > out[1].value ? e : out[1];
    }
    return out[0].row > 0;
}

static void write_value(FILE *to, const extreme *e, const char *output)
{
    if (murk_study_is_share(output)) {
        strong_share(to, e->value, e->error);
    } else {
        fputs("<strong>", to);
        murk_page_estimate(to, e->value, e->error);
        fputs("</strong>", to);
    }
}

/* The value, and in which row that is: by what the axes are there. */
static void write_extreme(FILE *to, const extreme *e, const murk_yaml *rows,
                          const char *output)
{
    const murk_yaml *axes = murk_result_at(rows->child[e->row - 1], "axes");
    write_value(to, e, output);
    const size_t n = axes && axes->kind == MURK_YAML_MAP ? axes->n : 0;
    for (size_t i = 0; i < n && i < SHOWN_MAX; ++i) {
        const char *dot = strrchr(axes->key[i], '.');
        fputs(i == 0 ? " (" : ", ", to);
        murk_page_text(to, dot && dot[1] ? dot + 1 : axes->key[i]);
        fputc(' ', to);
        murk_page_text(to, murk_result_text(axes->child[i], ""));
    }
    fputs(n > 0 ? ")" : "", to);
}

static void answer_study(FILE *to, const murk_yaml *study)
{
    const size_t n = murk_result_count(study, "rows");
    const murk_yaml *rows = murk_result_at(study, "rows");
    const murk_yaml *values =
        n > 0 ? murk_result_at(rows->child[0], "values") : NULL;
    const size_t outputs =
        values && values->kind == MURK_YAML_MAP ? values->n : 0;
    murk_page_line_begin(to, "Answer");
    fputs("<ul>", to);
    size_t shown = 0;
    for (size_t k = 0; k < outputs && shown < OUTPUTS_MAX; ++k) {
        extreme found[2];
        const char *output = values->key[k];
        const char *unit = murk_result_text(values->child[k], "unit");
        if (murk_study_is_of_band(output) ||
            !find_extremes(found, rows, n, output)) {
            continue;
        }
        ++shown;
        fputs("<li>", to);
        murk_page_text(to, output);
        fputs(unit && *unit && strcmp(unit, "1") != 0 ? ", " : "", to);
        murk_page_text(to, unit && *unit && strcmp(unit, "1") != 0 ? unit : "");
        if (found[0].value < found[1].value) {
            fputs(": from ", to);
            write_extreme(to, &found[0], rows, output);
            fputs(" to ", to);
            write_extreme(to, &found[1], rows, output);
        } else {
            fputs(": everywhere ", to);
            write_value(to, &found[0], output);
        }
        fputs("</li>", to);
    }
    fputs("</ul>", to);
    murk_page_line_end(to);
    murk_page_line_begin(to, "Runs");
    murk_page_number(to, murk_result_number(study, "rows_done"));
    fputs(" of ", to);
    murk_page_number(to, murk_result_number(study, "rows_asked"));
    fputs(" done, ", to);
    murk_page_number(to, murk_result_number(study, "rows_failed"));
    fputs(" failed", to);
    fputs(murk_result_is(study, "interrupted", "true")
              ? "; interrupted before the end."
              : ".",
          to);
    murk_page_line_end(to);
}

void murk_answer_study(FILE *to, const murk_yaml *study)
{
    ask_study(to, study);
    answer_study(to, study);
}

/* ---- a fit ---- */

static void ask_fit(FILE *to, const murk_yaml *fit)
{
    const double n = (double)murk_result_count(fit, "parameters");
    murk_page_line_begin(to, "Asked");
    fputs("Which ", to);
    murk_page_count(to, n, "value", "values");
    fputs(" of the scene explain", to);
    fputs(n == 1 ? "s" : "", to);
    fputs(" the ", to);
    murk_page_count(to, murk_result_number(fit, "data.rows"), "reading",
                    "readings");
    fputs(" of ", to);
    murk_page_text(to, murk_result_text(fit, "data.file"));
    fputs(" best?", to);
    murk_page_line_end(to);
}

static void answer_fit(FILE *to, const murk_yaml *fit)
{
    const size_t n = murk_result_count(fit, "parameters");
    const murk_yaml *list = murk_result_at(fit, "parameters");
    const bool is_refused = murk_result_is(fit, "accepted", "false");
    murk_page_line_begin(to, is_refused ? "Best values, which do not fit"
                                        : "Answer");
    fputs("<ul>", to);
    for (size_t i = 0; i < n && i < SHOWN_MAX; ++i) {
        const murk_yaml *p = list->child[i];
        const double lower = murk_result_number(p, "lower");
        fputs("<li>", to);
        murk_page_text(to, murk_result_text(p, "key"));
        fputs(" = <strong>", to);
        murk_report_fit_value(to, p);
        fputs("</strong>", to);
        if (isfinite(lower)) {
            fputs(", with 95 % within ", to);
            murk_page_number(to, lower);
            fputs(" to ", to);
            murk_page_number(to, murk_result_number(p, "upper"));
        }
        fputs("</li>", to);
    }
    fputs("</ul>", to);
    if (n > SHOWN_MAX) {
        fprintf(to, "and %zu more, below.", n - SHOWN_MAX);
    }
    murk_page_line_end(to);
}

/* The verdict in fit.json's own words. */
static void judge_fit(FILE *to, const murk_yaml *fit)
{
    murk_page_line_begin(to, "Does it fit?");
    murk_page_text(to, murk_result_text(fit, "verdict"));
    const double rows = murk_result_number(fit, "hold_out.rows");
    const double rms =
        murk_result_number(fit, "hold_out.rms_in_standard_errors");
    if (rows > 0 && isfinite(rms)) {
        fputs(" Readings that had no say (held out, ", to);
        murk_page_number(to, rows);
        fputs(") lie within ", to);
        murk_page_number(to, rms);
        fputs(" of their standard errors (root mean square).", to);
    }
    murk_page_line_end(to);
}

void murk_answer_fit(FILE *to, const murk_yaml *fit)
{
    const bool is_refused = murk_result_is(fit, "accepted", "false");
    ask_fit(to, fit);
    if (is_refused) { /* before any value */
        judge_fit(to, fit);
    }
    answer_fit(to, fit);
    if (!is_refused) {
        judge_fit(to, fit);
    }
}

/* ---- light alone ---- */

void murk_answer_light(FILE *to, const murk_yaml *ledger)
{
    static const char *const names[][2] = {
        {"absorbed_surfaces_w", "is absorbed by surfaces"},
        {"absorbed_media_w", "by media"},
        {"escaped_w", "escapes"},
        {"lost_w", "is lost to rounding and limits"}};
    const double emitted = murk_result_number(ledger, "emitted_w.total");
    murk_page_line_begin(to, "Asked");
    fputs("Where does the light of this scene go?", to);
    murk_page_line_end(to);
    murk_page_line_begin(to, "Answer");
    fputs("Of ", to);
    murk_page_number(to, emitted);
    fputs(" W", to);
    for (size_t k = 0; k < 4; ++k) {
        char path[40];
        snprintf(path, sizeof path, "%s.total", names[k][0]);
        fputs(k == 3 ? " and " : ", ", to);
        strong_share(
            to, emitted > 0 ? murk_result_number(ledger, path) / emitted : NAN,
            NAN);
        fprintf(to, " %s", names[k][1]);
    }
    fputc('.', to);
    murk_page_line_end(to);
}
