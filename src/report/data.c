/* Writes JSON (RFC 8259) into the page. Text is escaped, and '<' is written
 * \u003c, so that "</script>" and "<!--" cannot occur. */
#include "report/data.h"

#include "base/utf8.h"
#include "report/html.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Largest number of bytes of a text in the page. */
#define TEXT_MAX 1000

/* Writes a text in quotes, cut at the end of the character that reaches
 * bytes_max. */
static void write_text(FILE *to, const char *text, size_t bytes_max)
{
    const char *end = text + bytes_max;
    fputc('"', to);
    while (*text && text < end) {
        const size_t n = murk_utf8_length(text);
        if (n == 0 || murk_utf8_control(text)) {
            fputs("\\ufffd", to);
        } else if (*text == '"' || *text == '\\') {
            fprintf(to, "\\%c", *text);
        } else if (*text == '<') {
            fputs("\\u003c", to);
        } else {
            (void)fwrite(text, 1, n, to);
        }
        text += n > 0 ? n : 1;
    }
    fputc('"', to);
}

/* Writes a number with 15 digits, or with 17 if 15 change it by more than the
 * last bit. These are the digits that cJSON writes into the result files. null
 * if it is not finite. */
static void write_number(FILE *to, double value)
{
    char text[32];
    if (!isfinite(value)) {
        fputs("null", to);
        return;
    }
    snprintf(text, sizeof text, "%.15g", value);
    const double read = strtod(text, NULL);
    if (fabs(read - value) > DBL_EPSILON * fmax(fabs(read), fabs(value))) {
        snprintf(text, sizeof text, "%.17g", value);
    }
    fputs(text, to);
}

/* Writes what comes before an item: a comma unless it is the first, and the
 * key. */
static void next(murk_data *data, const char *key)
{
    fputs(data->has_item ? "," : "", data->to);
    data->has_item = true;
    if (key) {
        write_text(data->to, key, TEXT_MAX);
        fputc(':', data->to);
    }
}

murk_data murk_data_open(FILE *to, const char *id)
{
    fprintf(to, "<script type=\"application/json\" id=\"%s\">{", id);
    return (murk_data){.to = to};
}

void murk_data_close(murk_data *data)
{
    fputs("}</script>\n", data->to);
}

void murk_data_begin(murk_data *data, const char *key, char bracket)
{
    next(data, key);
    fputc(bracket, data->to);
    data->has_item = false;
}

void murk_data_end(murk_data *data, char bracket)
{
    fputc(bracket, data->to);
    data->has_item = true;
}

void murk_data_number(murk_data *data, const char *key, double value)
{
    next(data, key);
    write_number(data->to, value);
}

void murk_data_numbers(murk_data *data, const char *key, const double *value,
                       size_t n)
{
    murk_data_begin(data, key, '[');
    for (size_t i = 0; i < n; ++i) {
        murk_data_number(data, NULL, value[i]);
    }
    murk_data_end(data, ']');
}

void murk_data_vector(murk_data *data, const char *key, murk_vec3 value)
{
    murk_data_numbers(data, key, (const double[]){value.x, value.y, value.z},
                      3);
}

void murk_data_bool(murk_data *data, const char *key, bool value)
{
    next(data, key);
    fputs(value ? "true" : "false", data->to);
}

void murk_data_text(murk_data *data, const char *key, const char *text)
{
    next(data, key);
    write_text(data->to, text ? text : "", TEXT_MAX);
}

void murk_data_floats(murk_data *data, const char *key, const double *value,
                      size_t n)
{
    float *small = malloc((n + 1) * sizeof *small);
    next(data, key);
    fputc('"', data->to);
    for (size_t i = 0; small && i < n; ++i) {
        small[i] = (float)value[i];
    }
    if (small) {
        murk_html_base64(data->to, small, n * sizeof *small);
    }
    fputc('"', data->to);
    free(small);
}

/* ---- results ---- */

static void write_scalar(FILE *to, const murk_yaml *node)
{
    double number;
    bool is_true;
    if (murk_yaml_is_null(node)) {
        fputs("null", to);
    } else if (murk_yaml_number(node, &number)) {
        write_number(to, number);
    } else if (murk_yaml_bool(node, &is_true)) {
        fputs(is_true ? "true" : "false", to);
    } else {
        write_text(to, node->text, TEXT_MAX);
    }
}

void murk_data_yaml(murk_data *data, const char *key, const murk_yaml *node,
                    size_t items_max)
{
    const size_t n = node->n < items_max ? node->n : items_max;
    const bool is_cut = node->kind == MURK_YAML_LIST && n < node->n;
    if (node->kind == MURK_YAML_SCALAR) {
        next(data, key);
        write_scalar(data->to, node);
        return;
    }
    /* the number of items of the list in the file */
    if (is_cut) {
        murk_data_begin(data, key, '{');
        murk_data_number(data, "of", (double)node->n);
        key = "first";
    }
    const bool is_map = node->kind == MURK_YAML_MAP;
    murk_data_begin(data, key, is_map ? '{' : '[');
    for (size_t i = 0; i < n; ++i) {
        murk_data_yaml(data, is_map ? node->key[i] : NULL, node->child[i],
                       items_max);
    }
    murk_data_end(data, is_map ? '}' : ']');
    if (is_cut) {
        murk_data_end(data, '}');
    }
}
