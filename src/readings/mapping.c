/* Reads mapping files. All that does not depend on the file of measurements is
 * checked here, so that a mistake in the mapping is told at its place there. */
#include "readings/mapping.h"

#include "base/path.h"
#include "base/words.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Errors of AERONET's optical depths under cloudless skies, of a field
 * instrument that was calibrated recently: .01 from 440 nm on, .02 below.
 * Source: Holben et al., Remote Sens. Environ. 66 (1998) 1,
 * doi:10.1016/S0034-4257(98)00031-5. */
#define AOD_SPLIT_NM    440
#define AOD_ERROR       "0.01"
#define AOD_SHORT_ERROR "0.02"

typedef struct reader {
    murk_mapping *mapping;
    const char *path;
    murk_error *err;
} reader;

/* ---- messages ---- */

static murk_status fail_at(const reader *r, const murk_yaml *node,
                           const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static murk_status fail_at(const reader *r, const murk_yaml *node,
                           const char *format, ...)
{
    char where[320], text[256];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    murk_yaml_place(node, where, sizeof where);
    return murk_fail(r->err, MURK_BAD_VALUE, where, "%s", text);
}

static murk_status no_memory(const reader *r)
{
    return murk_no_memory(r->err, r->path, "for the mapping");
}

/* Fails at the key of `child`, which is none of known[n]. */
static murk_status unknown_key(const reader *r, const murk_yaml *child,
                               const char *key, const char *const *known,
                               size_t n)
{
    char where[320], shown[64];
    murk_words_show(shown, sizeof shown, key);
    murk_yaml_key_place(child, where, sizeof where);
    return murk_fail(r->err, MURK_BAD_VALUE, where,
                     "%s is no key of a mapping here%s", shown,
                     murk_words_suggest(key, known, n).text);
}

/* Checks that a node is a map with keys of known[n] alone. */
static murk_status check_map(const reader *r, const murk_yaml *map,
                             const char *const *known, size_t n)
{
    if (map->kind != MURK_YAML_MAP) {
        return fail_at(r, map, "must be a map");
    }
    for (size_t i = 0; i < map->n; ++i) {
        size_t k = 0;
        while (k < n && strcmp(map->key[i], known[k]) != 0) {
            ++k;
        }
        if (k == n) {
            return unknown_key(r, map->child[i], map->key[i], known, n);
        }
    }
    return MURK_OK;
}

static murk_status read_number(const reader *r, const murk_yaml *node,
                               double *out)
{
    return murk_yaml_number(node, out) ? MURK_OK
                                       : fail_at(r, node, "must be a number");
}

static murk_status read_text(const reader *r, const murk_yaml *node,
                             const char **out)
{
    if (node->kind != MURK_YAML_SCALAR || node->text[0] == '\0') {
        return fail_at(r, node, "must be a text");
    }
    *out = node->text;
    return MURK_OK;
}

/* Reads a word; *out is the index in known[n]. */
static murk_status read_word(const reader *r, const murk_yaml *node,
                             const char *const *known, int n, int *out)
{
    char list[256], shown[48];
    size_t used = 0;
    if (node->kind != MURK_YAML_SCALAR) {
        return fail_at(r, node, "must be a word");
    }
    for (int i = 0; i < n; ++i) {
        if (strcmp(node->text, known[i]) == 0) {
            *out = i;
            return MURK_OK;
        }
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%s",
                                 i ? ", " : "", known[i]);
    }
    murk_words_show(shown, sizeof shown, node->text);
    return fail_at(r, node, "%s, must be one of %s", shown, list);
}

/* ---- cells ---- */

/* Checks a constant of a column. */
static murk_status check_constant(const reader *r, const murk_yaml *node,
                                  murk_reading_column column)
{
    double number;
    int word;
    if (column == MURK_COLUMN_KIND) {
        return read_word(r, node, murk_reading_kinds, MURK_READING_KINDS,
                         &word);
    }
    return murk_reading_column_is_text(column) ||
                   murk_yaml_number(node, &number)
               ? MURK_OK
               : fail_at(r, node,
                         "must be a number, or a map with the column of the "
                         "file");
}

/* The sign and size that errors and their shares must have. */
static murk_status read_size(const reader *r, const murk_yaml *node,
                             double *out)
{
    const murk_status status = read_number(r, node, out);
    return status || *out >= 0 ? status : fail_at(r, node, "must be 0 or more");
}

/* Reads a rule that is a map. */
static murk_status read_map(const reader *r, murk_mapping_rule *rule,
                            const murk_yaml *node, murk_reading_column column)
{
    static const char *const known[] = {"column", "factor",   "offset",
                                        "units",  "relative", "at_least"};
    const bool is_error = column == MURK_COLUMN_ERROR;
    murk_status status = check_map(r, node, known, is_error ? 6 : 4);
    for (size_t i = 0; i < node->n && !status; ++i) {
        const char *key = node->key[i];
        const murk_yaml *child = node->child[i];
        if (strcmp(key, "column") == 0) {
            status = read_text(r, child, &rule->column);
        } else if (strcmp(key, "units") == 0) {
            status = read_text(r, child, &rule->unit);
        } else if (strcmp(key, "factor") == 0) {
            status = read_number(r, child, &rule->factor);
        } else if (strcmp(key, "offset") == 0) {
            status = read_number(r, child, &rule->offset);
        } else {
            status = read_size(r, child,
                               strcmp(key, "relative") == 0 ? &rule->relative
                                                            : &rule->at_least);
        }
    }
    /* A column is needed, but for errors by a rule. */
    const bool has_size = rule->relative > 0 || rule->at_least > 0;
    if (!status && !rule->column && !has_size) {
        return fail_at(r, node,
                       is_error ? "must have a column, relative or at_least"
                                : "must have a column");
    }
    const bool converts = rule->factor != 1 || rule->offset != 0;
    return status || !converts || !murk_reading_column_is_text(column)
               ? status
               : fail_at(r, node, "is a text, which has no factor or offset");
}

static murk_status read_rule(const reader *r, murk_mapping_rule *rule,
                             const murk_yaml *node, murk_reading_column column)
{
    *rule = (murk_mapping_rule){.node = node, .factor = 1};
    if (node->kind == MURK_YAML_MAP) {
        return read_map(r, rule, node, column);
    }
    if (node->kind == MURK_YAML_LIST) {
        return fail_at(r, node, "a list, must be a constant or a map");
    }
    if (node->text[0] == '\0' || murk_yaml_is_null(node)) {
        rule->node = NULL;
        return MURK_OK;
    }
    rule->constant = node->text;
    return check_constant(r, node, column);
}

/* ---- selections ---- */

static murk_status read_select(const reader *r, murk_mapping_selection *out,
                               const murk_yaml *map)
{
    if (map->kind != MURK_YAML_MAP || map->n > MURK_MAPPING_SELECT_MAX) {
        return fail_at(r, map, "must be a map of at most %d columns",
                       MURK_MAPPING_SELECT_MAX);
    }
    murk_status status = MURK_OK;
    for (size_t i = 0; i < map->n && !status; ++i) {
        const murk_yaml *node = map->child[i];
        murk_mapping_select *item = &out->item[out->n++];
        *item = (murk_mapping_select){.node = node, .column = map->key[i]};
        if (node->kind == MURK_YAML_SCALAR) {
            item->text = node->text;
        } else if (node->kind != MURK_YAML_LIST || node->n != 2 ||
                   !murk_yaml_number(node->child[0], &item->low) ||
                   !murk_yaml_number(node->child[1], &item->high) ||
                   item->low > item->high) {
            status = fail_at(r, node,
                             "must be the cell itself, or a list of the least "
                             "and the largest number");
        }
    }
    return status;
}

/* ---- entries ---- */

static murk_status read_entry(const reader *r, murk_mapping_entry *out,
                              const murk_yaml *map)
{
    const char *known[MURK_READING_COLUMNS + 3] = {"select", "average",
                                                   "aod_nm"};
    const size_t n = MURK_READING_COLUMNS +
                     (r->mapping->format == MURK_FIELD_AERONET ? 3 : 2);
    /* The keys that there may be: those of an entry, and all columns. */
    for (int i = 0; i < MURK_READING_COLUMNS; ++i) {
        known[n - MURK_READING_COLUMNS + (size_t)i] =
            murk_reading_column_name((murk_reading_column)i);
    }
    murk_status status = check_map(r, map, known, n);
    /* Read each key; add_entries() reads aod_nm. */
    *out = (murk_mapping_entry){.node = map};
    for (size_t i = 0; i < map->n && !status; ++i) {
        const murk_reading_column column =
            murk_reading_column_find(map->key[i]);
        if (column < MURK_READING_COLUMNS) {
            status = read_rule(r, &out->rule[column], map->child[i], column);
        } else if (strcmp(map->key[i], "select") == 0) {
            status = read_select(r, &out->select, map->child[i]);
        } else if (strcmp(map->key[i], "average") == 0 &&
                   !murk_yaml_bool(map->child[i], &out->is_averaged)) {
            status = fail_at(r, map->child[i], "must be true or false");
        }
    }
    return status;
}

/* Fails if an entry misses what every reading needs. */
static murk_status check_entry(const reader *r, const murk_mapping_entry *entry)
{
    static const murk_reading_column needed[] = {
        MURK_COLUMN_KIND, MURK_COLUMN_VALUE, MURK_COLUMN_ERROR};
    for (size_t i = 0; i < sizeof needed / sizeof *needed; ++i) {
        if (!entry->rule[needed[i]].node) {
            return fail_at(r, entry->node, "misses %s",
                           murk_reading_column_name(needed[i]));
        }
    }
    return MURK_OK;
}

/* A copy of a printed number that lives as long as the mapping. */
static const char *print(const reader *r, const char *format, double number)
{
    char *text = murk_arena_array(&r->mapping->arena, 64, 1);
    if (text) {
        snprintf(text, 64, format, number);
    }
    return text;
}

/* Fills a cell that the entry does not state. */
static void complete(murk_mapping_entry *entry, murk_reading_column column,
                     const char *constant)
{
    murk_mapping_rule *rule = &entry->rule[column];
    if (!rule->node) {
        *rule = (murk_mapping_rule){
            .node = entry->node, .constant = constant, .factor = 1};
    }
}

/* Makes an entry that of the aerosol optical depth at one wavelength: a
 * vertical segment, whose optical depth is the reading. */
static murk_status add_depth(const reader *r, murk_mapping_entry *entry,
                             const murk_yaml *node)
{
    double nm;
    if (!murk_yaml_number(node, &nm) || !(nm > 0 && nm < 1e5)) {
        return fail_at(r, node, "must be wavelengths in nm");
    }
    const char *band_nm = print(r, "%.9g", nm);
    const char *column = print(r, "AOD_%.9gnm", nm);
    if (!band_nm || !column) {
        return no_memory(r);
    }
    if (entry->rule[MURK_COLUMN_KIND].node ||
        entry->rule[MURK_COLUMN_UNIT].node ||
        entry->rule[MURK_COLUMN_VALUE].node) {
        return fail_at(r, entry->node,
                       "aod_nm states kind, unit and value of a reading, which "
                       "must not be given");
    }
    complete(entry, MURK_COLUMN_KIND,
             murk_reading_kinds[MURK_READ_TRANSMITTANCE]);
    complete(entry, MURK_COLUMN_UNIT,
             murk_reading_unit_name(MURK_UNIT_OPTICAL_DEPTH));
    complete(entry, MURK_COLUMN_BAND, band_nm);
    complete(entry, MURK_COLUMN_ERROR,
             nm < AOD_SPLIT_NM ? AOD_SHORT_ERROR : AOD_ERROR);
    entry->rule[MURK_COLUMN_VALUE] =
        (murk_mapping_rule){.node = node, .column = column, .factor = 1};
    /* The other end lies above the place. */
    for (int i = 0; i < 2; ++i) {
        murk_mapping_rule *end = &entry->rule[MURK_COLUMN_X2 + i];
        if (!end->node) {
            *end = entry->rule[MURK_COLUMN_X + i];
        }
    }
    return MURK_OK;
}

/* Adds the entries of one item of the list: one, or one for each wavelength of
 * aod_nm. */
static murk_status add_entries(const reader *r, const murk_yaml *map)
{
    murk_mapping *m = r->mapping;
    murk_mapping_entry entry;
    murk_status status = read_entry(r, &entry, map);
    if (status) {
        return status;
    }
    const murk_yaml *depths = murk_yaml_get(map, "aod_nm");
    const bool is_list = depths && depths->kind == MURK_YAML_LIST;
    const size_t n = is_list ? depths->n : 1;
    if (n < 1 || m->n + n > MURK_MAPPING_ENTRIES_MAX) {
        return fail_at(r, map, "entries must be 1..%d",
                       MURK_MAPPING_ENTRIES_MAX);
    }
    for (size_t i = 0; i < n && !status; ++i) {
        murk_mapping_entry *made = &m->entry[m->n++];
        *made = entry;
        if (depths) {
            status = add_depth(r, made, is_list ? depths->child[i] : depths);
        }
        status = status ? status : check_entry(r, made);
    }
    return status;
}

/* ---- the file ---- */

static murk_status read_root(const reader *r)
{
    static const char *const known[] = {"murk_readings", "file",   "format",
                                        "missing",       "select", "readings"};
    murk_mapping *m = r->mapping;
    const murk_yaml *root = m->root;
    const murk_yaml *version = murk_yaml_get(root, "murk_readings");
    const murk_yaml *file = murk_yaml_get(root, "file");
    const murk_yaml *format = murk_yaml_get(root, "format");
    const murk_yaml *select = murk_yaml_get(root, "select");
    const char *name = NULL;
    double number = 0;
    int word = MURK_FIELD_CSV;
    /* What it is, and of which file. */
    if (!version || !murk_yaml_number(version, &number) || number != 1) {
        return murk_fail(r->err, MURK_BAD_FILE, r->path,
                         "no mapping of readings: must have murk_readings: 1");
    }
    murk_status status =
        check_map(r, root, known, sizeof known / sizeof *known);
    if (!status && !file) {
        status = fail_at(r, root, "misses file, the file of measurements");
    }
    status = status ? status : read_text(r, file, &name);
    if (!status && format) {
        status =
            read_word(r, format, murk_field_formats, MURK_FIELD_FORMATS, &word);
    }
    m->format = (murk_field_format)word;
    if (!status && select) {
        status = read_select(r, &m->select, select);
    }
    if (!status && !(m->file = murk_path_beside(r->path, name))) {
        status = no_memory(r);
    }
    return status;
}

static murk_status read_missing(const reader *r)
{
    const murk_yaml *list = murk_yaml_get(r->mapping->root, "missing");
    r->mapping->missing = list;
    if (list && list->kind != MURK_YAML_LIST) {
        return fail_at(r, list, "must be a list of numbers or texts");
    }
    for (size_t i = 0; list && i < list->n; ++i) {
        if (list->child[i]->kind != MURK_YAML_SCALAR) {
            return fail_at(r, list->child[i], "must be a number or a text");
        }
    }
    return MURK_OK;
}

static murk_status read_entries(const reader *r)
{
    murk_mapping *m = r->mapping;
    const murk_yaml *list = murk_yaml_get(m->root, "readings");
    if (!list || list->kind != MURK_YAML_LIST || list->n < 1) {
        return fail_at(r, list ? list : m->root,
                       "must have readings, a list of one entry or more");
    }
    m->entry =
        murk_arena_array(&m->arena, MURK_MAPPING_ENTRIES_MAX, sizeof *m->entry);
    murk_status status = m->entry ? MURK_OK : no_memory(r);
    for (size_t i = 0; i < list->n && !status; ++i) {
        status = add_entries(r, list->child[i]);
    }
    return status;
}

bool murk_mapping_is(const char *path)
{
    const char *end = strrchr(path, '.');
    return end && (strcmp(end, ".yaml") == 0 || strcmp(end, ".yml") == 0);
}

murk_status murk_mapping_parse(murk_mapping *out, const char *path,
                               const char *text, size_t size, murk_error *err)
{
    const reader r = {out, path, err};
    *out = (murk_mapping){0};
    murk_status status = murk_yaml_parse(&out->root, text, size, path, err);
    status = status ? status : read_root(&r);
    status = status ? status : read_missing(&r);
    return status ? status : read_entries(&r);
}

void murk_mapping_release(murk_mapping *mapping)
{
    murk_yaml_destroy(mapping->root);
    free(mapping->file);
    murk_arena_release(&mapping->arena);
    *mapping = (murk_mapping){0};
}
