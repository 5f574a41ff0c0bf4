/* murk help: the reference entry of a scene key, as murk_context_reference()
 * gives it. The entry of a map is followed by the keys of the map. */
#include "app/field.h"
#include "app/options.h"
#include "base/print.h"

#include <stdlib.h>
#include <string.h>

/* ---- fields ---- */

/* Prints a label, and the texts of a list with commas between; nothing if the
 * list is empty. */
static void print_list(const murk_fields *f, const char *label,
                       const char *path)
{
    const size_t n = murk_field_length(f, "%s", path);
    for (size_t i = 0; i < n; ++i) {
        murk_print("%s%s", i ? ", " : label,
                   murk_field_text(f, "%s.%zu", path, i));
    }
    if (n > 0) {
        murk_print("\n");
    }
}

static bool is_true(const murk_fields *f, const char *path, const char *name)
{
    char whole[MURK_FIELD_PATH_SIZE];
    bool value = false;
    snprintf(whole, sizeof whole, "%s.%s", path, name);
    (void)murk_fields_bool(f, whole, &value, NULL);
    return value;
}

/* ---- entries ---- */

/* Prints what is known of a row: `path` is that of its fields. said: the
 * meaning of the row before, which is not told twice. */
static void print_row(const murk_fields *f, const char *path, const char *said)
{
    char list[MURK_FIELD_PATH_SIZE], label[128];
    /* The variants that have the key. */
    snprintf(list, sizeof list, "%s.variants", path);
    snprintf(label, sizeof label,
             "of          a %s: ", murk_field_text(f, "of"));
    print_list(f, label, list);
    /* Values, unit and default, with the other keys of the group. */
    murk_print("value       %s\n", murk_field_text(f, "%s.value", path));
    const char *unit = murk_field_text(f, "%s.unit", path);
    const char *preset = murk_field_text(f, "%s.default", path);
    const char *stated = murk_field_text(f, "%s.default_in_words", path);
    if (unit) {
        murk_print("unit        %s\n", unit);
    }
    const bool is_needed = is_true(f, path, "required");
    snprintf(list, sizeof list, "%s.in_place_of", path);
    if (is_needed && !preset && murk_field_length(f, "%s", list) > 0) {
        print_list(f, "default     none; required is this or one of ", list);
    } else {
        murk_print("default     %s\n", preset      ? preset
                                       : is_needed ? "none; required"
                                       : stated    ? stated
                                                   : "none; may be left out");
        print_list(f, "in place of ", list);
    }
    const char *meaning = murk_field_text(f, "%s.meaning", path);
    if (meaning && (!said || strcmp(meaning, said) != 0)) {
        murk_print("meaning     %s\n", meaning);
    }
}

/* Prints all rows of a name: a key may take other values in other variants. */
static void print_entry(const murk_fields *f)
{
    const char *said = NULL;
    murk_print("key         %s\n", murk_field_text(f, "path"));
    for (size_t i = 0; i < murk_field_length(f, "rows"); ++i) {
        char path[32];
        snprintf(path, sizeof path, "rows.%zu", i);
        print_row(f, path, said);
        said = murk_field_text(f, "%s.meaning", path);
    }
}

/* True if a key above has the same name and meaning, in another variant. */
static bool is_repeated(const murk_fields *f, size_t i)
{
    const char *name = murk_field_text(f, "keys.%zu.name", i);
    const char *meaning = murk_field_text(f, "keys.%zu.meaning", i);
    bool is_same = false;
    for (size_t k = 0; k < i; ++k) {
        const char *other = murk_field_text(f, "keys.%zu.meaning", k);
        is_same |= strcmp(murk_field_text(f, "keys.%zu.name", k), name) == 0 &&
                   other && meaning && strcmp(other, meaning) == 0;
    }
    return is_same;
}

/* Ends the line of a key: if the key or another must be given, names the
 * others. */
static void print_others(const murk_fields *f, const char *path)
{
    char list[MURK_FIELD_PATH_SIZE];
    snprintf(list, sizeof list, "%s.in_place_of", path);
    if (is_true(f, path, "required") && murk_field_length(f, "%s", list) > 0) {
        print_list(f, " is this or one of ", list);
    } else {
        murk_print("\n");
    }
}

/* Prints the keys of a map, with values, defaults and meanings. */
static void print_map(const murk_fields *f)
{
    const char *introduction = murk_field_text(f, "introduction");
    murk_print("\nkeys of %s\n", murk_field_text(f, "path"));
    if (introduction) {
        murk_print("  %s\n", introduction);
    }
    /* Each key: name and values, then the meaning. */
    for (size_t i = 0; i < murk_field_length(f, "keys"); ++i) {
        char path[32];
        if (is_repeated(f, i)) {
            continue;
        }
        snprintf(path, sizeof path, "keys.%zu", i);
        const char *preset = murk_field_text(f, "%s.default", path);
        const char *meaning = murk_field_text(f, "%s.meaning", path);
        murk_print("  %s: %s%s%s", murk_field_text(f, "%s.name", path),
                   murk_field_text(f, "%s.value", path),
                   preset                         ? "; default "
                   : is_true(f, path, "required") ? "; required"
                                                  : "",
                   preset ? preset : "");
        print_others(f, path);
        murk_print("      %s\n", meaning ? meaning : "");
    }
}

/* ---- the command ---- */

/* The keys of the top level, with the first sentence of each meaning. */
static void print_top_level(const murk_fields *f)
{
    murk_print("usage: murk help KEY, as in murk help sensors.count; murk "
               "COMMAND --help\n\n");
    for (size_t i = 0; i < murk_field_length(f, "keys"); ++i) {
        const char *meaning = murk_field_text(f, "keys.%zu.meaning", i);
        const char *stop = meaning ? strstr(meaning, ". ") : NULL;
        murk_print("%-14s%.*s\n", murk_field_text(f, "keys.%zu.name", i),
                   stop      ? (int)(stop + 1 - meaning)
                   : meaning ? (int)strlen(meaning)
                             : 0,
                   meaning ? meaning : "");
    }
}

/* Looks a key up. A key that the library does not know, nor one like it, is
 * refused with the command that lists the keys. */
static murk_status find(const murk_fields **out, const murk_options *options,
                        murk_error *err)
{
    murk_error why = MURK_ERROR_NONE;
    const size_t size = sizeof "scene." + strlen(options->input);
    char *name = malloc(size);
    if (!name) {
        return murk_no_memory(err, "", "for the key");
    }
    snprintf(name, size, "scene.%s", options->input);
    const murk_status status =
        murk_context_reference(options->context, name, out, &why);
    free(name);
    return status ? murk_fail(err, status, why.where, "%s%s", why.text,
                              strcmp(why.text, "no such key") == 0
                                  ? "; murk help lists the keys of a scene"
                                  : "")
                  : MURK_OK;
}

murk_status murk_command_help(const murk_options *options, murk_error *err)
{
    const murk_fields *f = NULL;
    const murk_status status =
        options->input
            ? find(&f, options, err)
            : murk_context_reference(options->context, "scene", &f, err);
    if (status) {
        return status;
    }
    if (!options->input) {
        print_top_level(f);
        return MURK_OK;
    }
    print_entry(f);
    if (murk_field_length(f, "keys") > 0) {
        print_map(f);
    }
    if (murk_command_find(options->input)) {
        murk_print("\nThe command of this name: murk %s --help\n",
                   options->input);
    }
    return MURK_OK;
}
