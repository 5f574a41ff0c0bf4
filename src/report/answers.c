/* What was asked of a study, a fit or light alone, and the answer; and how
 * sentences with values are written. */
#include "report/answers.h"

#include "report/html.h"

#include <math.h>
#include <string.h>

#define PATH_MAX_BYTES 80 /* of a value's path in a sentence */
#define SHOWN_MAX      8  /* keys of one sentence, so that it can be read */
#define OUTPUTS_MAX    12 /* lines of the answer; tables have all outputs */

/* ---- sentences ---- */

/* "sensor|sensors}": the first word for one, else the second. */
static void say_count(FILE *to, double n, const char *words, const char *end)
{
    const char *bar = memchr(words, '|', (size_t)(end - words));
    const char *from = n == 1 || !bar ? words : bar + 1;
    const char *stop = n == 1 && bar ? bar : end;
    murk_html_number(to, n);
    fprintf(to, " %.*s", (int)(stop - from), from);
}

/* Writes the value that stands behind '{'; returns what follows its '}'. */
static const char *say_value(FILE *to, const murk_yaml *root, const char *from)
{
    char path[PATH_MAX_BYTES], error[PATH_MAX_BYTES + 16];
    const int length = (int)strcspn(from, "$*%~#[}");
    const char *end = strchr(from, '}');
    snprintf(path, sizeof path, "%.*s", length, from);
    snprintf(error, sizeof error, "%s_standard_error", path);
    const double value = murk_result_number(root, path);
    /* the character behind the path tells the form */
    switch (from[length]) {
    case '$': {
        const char *text = murk_result_text(root, path);
        murk_html_text(to, text && *text ? text : MURK_HTML_NONE);
        break;
    }
    case '*':
        murk_html_number(to, round(value / 1e6));
        break;
    case '%':
        murk_html_share(to, value, NAN);
        break;
    case '~':
        murk_html_share(to, value, murk_result_number(root, error));
        break;
    case '#':
        say_count(to, value, from + length + 1, end);
        break;
    case '[':
        say_count(to, (double)murk_result_count(root, path), from + length + 1,
                  end);
        break;
    default:
        murk_html_number(to, value);
    }
    return end + 1;
}

void murk_report_say(FILE *to, const murk_yaml *root, const char *words)
{
    while (*words) {
        const size_t n = strcspn(words, "{");
        (void)fwrite(words, 1, n, to);
        words += n;
        if (*words) {
            words = say_value(to, root, words + 1);
        }
    }
}

/* ---- a study ---- */

/* "density_475nm": of one band only. */
static bool is_of_band(const char *output)
{
    const char *last = strrchr(output, '_');
    const size_t digits = last ? strspn(last + 1, "0123456789.") : 0;
    return digits > 0 && strcmp(last + 1 + digits, "nm") == 0;
}

static void ask_study(FILE *to, const murk_yaml *study)
{
    const size_t axes = murk_result_count(study, "axes");
    const murk_yaml *list = murk_result_at(study, "axes");
    fputs("<div><dt>Asked</dt><dd>How do the results change with ", to);
    for (size_t i = 0; i < axes && i < SHOWN_MAX; ++i) {
        fputs(i == 0 ? "" : i + 1 < axes ? ", " : " and ", to);
        murk_report_say(to, list->child[i], "{key$} ({values[value|values})");
    }
    fputs(axes == 0 ? "nothing: one run?" : "?", to);
    fputs("</dd></div>\n", to);
}

typedef struct extreme {
    double value, error;
    size_t row; /* from 1 */
} extreme;

/* Smallest and largest value of an output over all rows; false if no row has
 * one. */
static bool find_extremes(extreme out[2], const murk_yaml *rows, size_t n,
                          const char *output)
{
    out[0] = (extreme){.value = INFINITY};
    out[1] = (extreme){.value = -INFINITY};
    for (size_t i = 0; i < n; ++i) {
        const murk_yaml *one =
            murk_result_get(murk_result_at(rows->child[i], "values"), output);
        const extreme e = {murk_result_number(one, "value"),
                           murk_result_number(one, "standard_error"), i + 1};
        out[0] = e.value < out[0].value ? e : out[0];
        out[1] = e.value > out[1].value ? e : out[1];
    }
    return out[0].row > 0;
}

/* Coverages are shares, which are shown in per cent. */
static void write_value(FILE *to, const extreme *e, const char *output)
{
    const bool is_share = strncmp(output, "coverage", 8) == 0;
    fputs("<strong>", to);
    (is_share ? murk_html_share : murk_html_estimate)(to, e->value, e->error);
    fputs("</strong>", to);
}

/* The value, and the values of the axes there. */
static void write_extreme(FILE *to, const extreme *e, const murk_yaml *rows,
                          const char *output)
{
    const murk_yaml *axes = murk_result_at(rows->child[e->row - 1], "axes");
    const size_t n = murk_result_entries(axes);
    write_value(to, e, output);
    for (size_t i = 0; i < n && i < SHOWN_MAX; ++i) {
        const char *dot = strrchr(axes->key[i], '.');
        fputs(i == 0 ? " (" : ", ", to);
        murk_html_text(to, dot && dot[1] ? dot + 1 : axes->key[i]);
        fputc(' ', to);
        murk_html_text(to, murk_result_text(axes->child[i], ""));
    }
    fputs(n > 0 ? ")" : "", to);
}

static void answer_output(FILE *to, const murk_yaml *rows,
                          const extreme found[2], const char *output,
                          const char *unit)
{
    const bool has_unit = unit && *unit && strcmp(unit, "1") != 0;
    fputs("<li>", to);
    murk_html_text(to, output);
    fputs(has_unit ? ", " : "", to);
    murk_html_text(to, has_unit ? unit : "");
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

void murk_answer_study(FILE *to, const murk_yaml *study)
{
    const size_t n = murk_result_count(study, "rows");
    const murk_yaml *rows = murk_result_at(study, "rows");
    const murk_yaml *values =
        n > 0 ? murk_result_at(rows->child[0], "values") : NULL;
    const size_t outputs = murk_result_entries(values);
    ask_study(to, study);
    /* an output's range over all rows; bands have a table of their own */
    fputs("<div><dt>Answer</dt><dd><ul>", to);
    size_t shown = 0;
    for (size_t k = 0; k < outputs && shown < OUTPUTS_MAX; ++k) {
        extreme found[2];
        if (!is_of_band(values->key[k]) &&
            find_extremes(found, rows, n, values->key[k])) {
            ++shown;
            answer_output(to, rows, found, values->key[k],
                          murk_result_text(values->child[k], "unit"));
        }
    }
    murk_report_say(to, study,
                    "</ul></dd></div>\n<div><dt>Runs</dt><dd>{rows_done} of "
                    "{rows_asked} done, {rows_failed} failed");
    fputs(murk_result_is(study, "interrupted", "true")
              ? "; interrupted before the end."
              : ".",
          to);
    fputs("</dd></div>\n", to);
}

/* ---- a fit ---- */

/* With its standard error if the data determine the value, else to two digits
 * with its status in words. */
static void write_parameter(FILE *to, const murk_yaml *p)
{
    const double value = murk_result_number(p, "value");
    murk_report_say(to, p, "<li>{key$} = <strong>");
    if (murk_result_is(p, "status", "determined") || !isfinite(value)) {
        murk_html_estimate(to, value, murk_result_number(p, "standard_error"));
    } else {
        murk_html_power(to, value, 2);
        murk_report_say(to, p, " ({status$})");
    }
    murk_report_say(to, p,
                    isfinite(murk_result_number(p, "lower"))
                        ? "</strong>, with 95 % within {lower} to {upper}</li>"
                        : "</strong></li>");
}

static void answer_fit(FILE *to, const murk_yaml *fit, bool is_refused)
{
    const size_t n = murk_result_count(fit, "parameters");
    const murk_yaml *list = murk_result_at(fit, "parameters");
    fprintf(to, "<div><dt>%s</dt><dd><ul>",
            is_refused ? "Best values, which do not fit" : "Answer");
    for (size_t i = 0; i < n && i < SHOWN_MAX; ++i) {
        write_parameter(to, list->child[i]);
    }
    fputs("</ul>", to);
    if (n > SHOWN_MAX) {
        fprintf(to, "and %zu more, below.", n - SHOWN_MAX);
    }
    fputs("</dd></div>\n", to);
}

/* The verdict in fit.json's own words. */
static void judge_fit(FILE *to, const murk_yaml *fit)
{
    const char *rms = "hold_out.rms_in_standard_errors";
    murk_report_say(to, fit, "<div><dt>Does it fit?</dt><dd>{verdict$}");
    if (murk_result_number(fit, "hold_out.rows") > 0 &&
        isfinite(murk_result_number(fit, rms))) {
        murk_report_say(to, fit,
                        " Readings that had no say (held out, "
                        "{hold_out.rows}) lie within "
                        "{hold_out.rms_in_standard_errors} of their standard "
                        "errors (root mean square).");
    }
    fputs("</dd></div>\n", to);
}

void murk_answer_fit(FILE *to, const murk_yaml *fit)
{
    const bool is_refused = murk_result_is(fit, "accepted", "false");
    murk_report_say(to, fit,
                    "<div><dt>Asked</dt><dd>Which {parameters[value of the "
                    "scene explains|values of the scene explain} the "
                    "{data.rows#reading|readings} of {data.file$} "
                    "best?</dd></div>\n");
    if (is_refused) { /* before any value */
        judge_fit(to, fit);
    }
    answer_fit(to, fit, is_refused);
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
    murk_report_say(to, ledger,
                    "<div><dt>Asked</dt><dd>Where does the light of this scene "
                    "go?</dd></div>\n<div><dt>Answer</dt><dd>Of "
                    "{emitted_w.total} W");
    for (size_t k = 0; k < 4; ++k) {
        char path[40];
        snprintf(path, sizeof path, "%s.total", names[k][0]);
        fputs(k == 3 ? " and <strong>" : ", <strong>", to);
        murk_html_share(
            to, emitted > 0 ? murk_result_number(ledger, path) / emitted : NAN,
            NAN);
        fprintf(to, "</strong> %s", names[k][1]);
    }
    fputs(".</dd></div>\n", to);
}
