/* murk help: the reference entry of a scene key. The key table says which
 * values a key takes, its default and the keys that it excludes; the meaning is
 * that of doc/reference. The entry of a map is followed by the keys of the
 * map. */
#include "app/options.h"
#include "app/reference.h"
#include "results/summary.h"
#include "scene/value.h"
#include "scene/words.h"

#include <stdlib.h>
#include <string.h>

#define NAMES_MAX 64   /* more names than a table of keys has */
#define LIST_SIZE 1000 /* bytes, more than a list of names of keys has */

/* ---- names that are listed ---- */

static void add(char list[LIST_SIZE], const char *name)
{
    const size_t length = strlen(list);
    snprintf(list + length, LIST_SIZE - length, "%s%s", length ? ", " : "",
             name);
}

/* Lists the other keys of the group of a key. A map may have one key of a group
 * at most. */
static void list_group(char list[LIST_SIZE], const murk_keys *table,
                       const murk_key *row)
{
    list[0] = '\0';
    for (const murk_key *other = table->key; other->name; ++other) {
        if (row->group && other->group == row->group &&
            strcmp(other->name, row->name) != 0) {
            add(list, other->name);
        }
    }
}

/* Lists the variants of the map that may have the key. An empty list means all
 * variants. */
static void list_variants(char list[LIST_SIZE], const murk_keys *table,
                          const murk_key *row)
{
    list[0] = '\0';
    for (int i = 0; row->variants && i < murk_keys_variants(table); ++i) {
        if (row->variants & (1u << i)) {
            add(list, murk_keys_variant_name(table, i));
        }
    }
}

/* ---- entries ---- */

/* Prints the default of a key. The reference describes in words a default that
 * depends on other keys. */
static void print_default(const murk_keys *table, const murk_key *row)
{
    char *stated = murk_reference_default(table, row);
    const bool is_stated = stated && strcmp(stated, "-") != 0 &&
                           strcmp(stated, "required") != 0 &&
                           strcmp(stated, "one of these") != 0;
    murk_print("default     %s\n", row->preset     ? row->preset
                                   : row->required ? "none; required"
                                   : is_stated     ? stated
                                                   : "none; may be left out");
    free(stated);
}

/* Prints all rows of a name: a key may take other values in other variants. */
static void print_entry(const murk_reference_key *key)
{
    char list[LIST_SIZE], *said = NULL;
    murk_print("key         %s\n", key->path);
    for (const murk_key *row = key->row; row->name; ++row) {
        if (strcmp(row->name, key->row->name) != 0) {
            continue;
        }
        /* What the key table says. */
        char allowed[MURK_ALLOWED_SIZE];
        murk_value_allowed(row, allowed);
        list_variants(list, key->table, row);
        if (list[0]) {
            murk_print("of          a %s: %s\n", key->table->noun, list);
        }
        murk_print("value       %s\n", allowed);
        if (row->unit) {
            murk_print("unit        %s\n", row->unit);
        }
        print_default(key->table, row);
        list_group(list, key->table, row);
        if (list[0]) {
            murk_print("in place of %s\n", list);
        }
        /* What the reference says, once. */
        char *meaning = murk_reference_meaning(key->table, row);
        if (meaning && (!said || strcmp(meaning, said) != 0)) {
            murk_print("meaning     %s\n", meaning);
        }
        free(said);
        said = meaning;
    }
    free(said);
}

/* True if a row above has the same name and meaning, in another variant. */
static bool is_repeated(const murk_keys *table, const murk_key *row,
                        const char *meaning)
{
    bool is_same = false;
    for (const murk_key *above = table->key; above < row; ++above) {
        if (strcmp(above->name, row->name) == 0) {
            char *other = murk_reference_meaning(table, above);
            is_same |= other && meaning && strcmp(other, meaning) == 0;
            free(other);
        }
    }
    return is_same;
}

/* Prints the keys of a map, with values, defaults and meanings. */
static void print_table(const murk_keys *table, const char *path)
{
    char *introduction = murk_reference_introduction(table);
    murk_print("\nkeys of %s\n", path);
    if (introduction) {
        murk_print("  %s\n", introduction);
    }
    free(introduction);
    /* Each key: name and values, then the meaning. */
    for (const murk_key *row = table->key; row->name; ++row) {
        char allowed[MURK_ALLOWED_SIZE];
        char *meaning = murk_reference_meaning(table, row);
        if (is_repeated(table, row, meaning)) {
            free(meaning);
            continue;
        }
        murk_value_allowed(row, allowed);
        murk_print("  %s: %s%s%s\n", row->name, allowed,
                   row->preset      ? "; default "
                   : !row->required ? ""
                   : row->group     ? "; one of a group is required"
                                    : "; required",
                   row->preset ? row->preset : "");
        murk_print("      %s\n", meaning ? meaning : "");
        free(meaning);
    }
}

/* ---- unknown keys ---- */

typedef struct search {
    const char *last; /* part of the unknown path */
    char list[LIST_SIZE];
} search;

static void take_same_name(void *context, const char *path)
{
    search *s = context;
    const char *dot = strrchr(path, '.');
    if (strcmp(dot ? dot + 1 : path, s->last) == 0) {
        add(s->list, path);
    }
}

/* Suggests a key of the same map that is spelled alike, or keys of that name in
 * other maps. */
static murk_status unknown_key(const char *path, const murk_reference_key *key,
                               murk_error *err)
{
    const char *names[NAMES_MAX], *dot = strrchr(path, '.');
    char part[MURK_SCENE_NAME_SIZE], shown[MURK_REFERENCE_PATH_SIZE];
    size_t n = 0;
    const murk_key *row = key->looked_up ? key->looked_up->key : NULL;
    for (; row && row->name && n < NAMES_MAX; ++row) {
        names[n++] = row->name;
    }
    snprintf(part, sizeof part, "%.*s", (int)strcspn(key->unknown, "."),
             key->unknown);
    murk_words_show(shown, sizeof shown, path);
    /* A key that is spelled alike, in the table in which the unknown part of
     * the path was looked up. */
    const char *meant = murk_words_meant(part, names, n);
    if (meant) {
        return murk_fail(err, MURK_BAD_VALUE, shown,
                         "no such key, did you mean %.*s%s?",
                         (int)(key->unknown - path), path, meant);
    }
    search s = {.last = dot ? dot + 1 : path};
    murk_reference_visit_all(take_same_name, &s);
    return s.list[0] ? murk_fail(err, MURK_BAD_VALUE, shown,
                                 "no such key, did you mean %s?", s.list)
                     : murk_fail(err, MURK_BAD_VALUE, shown,
                                 "no such key; murk help lists the keys of a "
                                 "scene");
}

/* ---- the command ---- */

/* The keys of the top level, with the first sentence of each meaning. */
static void print_top_level(void)
{
    murk_print("usage: murk help KEY, as in murk help sensors.count; murk "
               "COMMAND --help\n\n");
    for (const murk_key *row = murk_scene_keys.key; row->name; ++row) {
        char *meaning = murk_reference_meaning(&murk_scene_keys, row);
        const char *stop = meaning ? strstr(meaning, ". ") : NULL;
        murk_print("%-14s%.*s\n", row->name,
                   stop      ? (int)(stop + 1 - meaning)
                   : meaning ? (int)strlen(meaning)
                             : 0,
                   meaning ? meaning : "");
        free(meaning);
    }
}

murk_status murk_command_help(const murk_options *options, murk_error *err)
{
    if (!options->input) {
        print_top_level();
        return MURK_OK;
    }
    const murk_reference_key key = murk_reference_find(options->input);
    if (!key.row) {
        return unknown_key(options->input, &key, err);
    }
    print_entry(&key);
    if (key.row->keys && !key.row->keys->is_open) {
        print_table(key.row->keys, key.path);
    }
    if (murk_command_find(options->input)) {
        murk_print("\nThe command of this name: murk %s --help\n",
                   options->input);
    }
    return MURK_OK;
}
