/* The reference of keys (reference/reference.h). A path is followed through the
 * key table, part by part; where a part may be the name of a key or the name of
 * an item, both are tried. The table of the reference (doc/reference) that
 * belongs to a part of the key table is found by the comments above the tables,
 * and a row of it by the name of the key and the values that the key table
 * allows. */
#include "reference/reference.h"

#include "reference/pages.h"
#include "scene/value.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- paths ---- */

/* True if items of the key are maps of their own, with a number or a name. */
static bool has_items(const murk_key *row)
{
    return row->kind == MURK_KEY_LIST || row->kind == MURK_KEY_MAPS ||
           row->kind == MURK_KEY_NAMED;
}

/* True if a part of a path, of that length, may name an item of the key. */
static bool is_item(const murk_key *row, const char *part, size_t length)
{
    if (row->kind == MURK_KEY_MAP || row->kind == MURK_KEY_NUMBER) {
        return false;
    }
    const bool is_number = strspn(part, "0123456789") == length;
    const bool is_any = length == 1 && part[0] == '*';
    return length > 0 && (is_number || is_any || row->kind == MURK_KEY_NAMED);
}

static void append(char path[MURK_REFERENCE_PATH_SIZE], const char *part)
{
    const size_t length = strlen(path);
    snprintf(path + length, MURK_REFERENCE_PATH_SIZE - length, "%s%s",
             length ? "." : "", part);
}

/* Follows the rest of a path from a key on, `row` of `table`; row NULL: from
 * the top level, `table`. found->path is the path so far. */
static bool follow(murk_reference_key *found, const murk_keys *table,
                   const murk_key *row, bool in_item, const char *rest)
{
    const murk_keys *below = row ? row->keys : table;
    const size_t length = strcspn(rest, "."), so_far = strlen(found->path);
    const char *next = rest + length + (rest[length] == '.');
    /* The end of the path, or keys that the user chooses. */
    if (!*rest || (below && below->is_open)) {
        found->table = table;
        found->row = row;
        return row != NULL;
    }
    /* The part as the name of a key. */
    char name[MURK_SCENE_NAME_SIZE];
    snprintf(name, sizeof name, "%.*s", (int)length, rest);
    const murk_key *key = below ? murk_keys_find(below, name) : NULL;
    if (key) {
        if (row && has_items(row)) {
            append(found->path, "*");
        }
        append(found->path, name);
        if (follow(found, below, key, false, next)) {
            return true;
        }
        found->path[so_far] = '\0';
    } else if (rest >= found->unknown) {
        found->unknown = rest;
        found->looked_up = below;
    }
    /* The part as an item: a list of lists has two of them. */
    return row && (!in_item || !below) && is_item(row, rest, length) &&
           follow(found, table, row, true, next);
}

murk_reference_key murk_reference_find(const murk_keys *root, const char *path)
{
    murk_reference_key found = {.unknown = path, .looked_up = root};
    (void)follow(&found, root, NULL, false, path);
    return found;
}

/* Visits the keys of a table at the path `above`. are_settable: all keys above
 * are maps of one kind. */
static void visit_below(const murk_keys *keys, const char *above,
                        bool are_settable, murk_reference_visit *visit,
                        void *context)
{
    for (const murk_key *row = keys->key; row->name; ++row) {
        murk_reference_key key = {.table = keys, .row = row};
        if (murk_keys_find(keys, row->name) != row) {
            continue;
        }
        snprintf(key.path, sizeof key.path, "%s", above);
        append(key.path, row->name);
        key.is_settable = are_settable && !row->keys;
        visit(context, &key);
        if (row->keys) {
            if (has_items(row)) {
                append(key.path, "*");
            }
            visit_below(row->keys, key.path,
                        are_settable && row->kind == MURK_KEY_MAP, visit,
                        context);
        }
    }
}

void murk_reference_visit_all(const murk_keys *root,
                              murk_reference_visit *visit, void *context)
{
    visit_below(root, "", true, visit, context);
}

/* ---- tables of the reference ---- */

static const char BEGIN[] = "<!-- keys of ";
static const char HEAD[] = "| key | value | default | meaning |";

/* The part of the key table that a path in a comment of the reference names. */
static const murk_keys *table_named(const char *path)
{
    if (strcmp(path, "scene") == 0) {
        return &murk_scene_keys;
    }
    if (strcmp(path, "study") == 0) {
        return &murk_study_keys;
    }
    const murk_reference_key found =
        murk_reference_find(&murk_scene_keys, path);
    return found.row ? found.row->keys : NULL;
}

/* True if a comment, whose paths begin at `text`, names the table. */
static bool names_table(const char *text, const murk_keys *table)
{
    while (*text != ' ' && *text != '\n') {
        char path[MURK_REFERENCE_PATH_SIZE];
        const size_t length = strcspn(text, ", \n");
        snprintf(path, sizeof path, "%.*s", (int)length, text);
        if (table_named(path) == table) {
            return true;
        }
        text += length + strspn(text + length, ",");
        text += *text == ' ' && text[1] != '-'; /* " -->" ends the comment */
    }
    return false;
}

/* The text behind the comment of a table; NULL: there is none. */
static const char *find_text(const murk_keys *table)
{
    for (size_t i = 0; i < murk_reference_files.n; ++i) {
        const char *at = murk_reference_files.file[i].text;
        while ((at = strstr(at, BEGIN))) {
            at += sizeof BEGIN - 1;
            if (names_table(at, table)) {
                return at + strcspn(at, "\n") + 1;
            }
        }
    }
    return NULL;
}

static bool begins_with(const char *text, const char *end, const char *word)
{
    const size_t length = strlen(word);
    return (size_t)(end - text) >= length && strncmp(text, word, length) == 0;
}

/* Prints a link, [TEXT](PAGE#PART), as plain text: "below" becomes the part of
 * the reference, others their text. Returns the end of the link, or NULL if
 * there is none at `at`. */
static const char *print_link(FILE *out, const char *at, const char *end)
{
    const char *middle = *at == '[' ? strstr(at, "](") : NULL;
    const char *close = middle ? strchr(middle, ')') : NULL;
    if (!close || close >= end || memchr(at + 1, '[', (size_t)(middle - at))) {
        return NULL;
    }
    const char *part = memchr(middle, '#', (size_t)(close - middle));
    if (!begins_with(at, end, "[below]") || !part) {
        for (++at; at < middle; ++at) {
            if (*at != '`') {
                fputc(*at, out);
            }
        }
        return close + 1;
    }
    fputs("the reference", out);
    /* The part is the heading in small letters, - for blanks; that of keys is
     * printed by the help itself. */
    if (!begins_with(++part, close, "keys-of-")) {
        fputs(", \"", out);
        for (; part < close; ++part) {
            fputc(*part == '-' ? ' ' : *part, out);
        }
        fputc('"', out);
    }
    return close + 1;
}

/* Copies text without marks of Markdown, and with single blanks. */
static char *plain(const char *text, size_t length)
{
    const char *end = text + length;
    char *copy = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&copy, &size);
    if (!out) {
        return NULL;
    }
    /* A blank is printed before the next word, so there is none at the end. */
    bool has_text = false, is_behind_blank = false;
    while (text < end) {
        if (isspace((unsigned char)*text)) {
            is_behind_blank = has_text;
            ++text;
            continue;
        }
        if (*text == '`' ||
            (*text == '\\' && text + 1 < end && text[1] == '|')) {
            ++text;
            continue;
        }
        if (is_behind_blank) {
            fputc(' ', out);
        }
        const char *behind = print_link(out, text, end);
        if (!behind) {
            fputc(*text, out);
        }
        text = behind ? behind : text + 1;
        has_text = true;
        is_behind_blank = false;
    }
    if (fclose(out)) {
        free(copy);
        copy = NULL;
    }
    return copy;
}

char *murk_reference_introduction(const murk_keys *table)
{
    const char *text = find_text(table);
    const char *end = text ? strstr(text, HEAD) : NULL;
    return end && end > text ? plain(text, (size_t)(end - text)) : NULL;
}

enum { NAME, ALLOWED, DEFAULT, MEANING, CELLS };

/* Finds the cells of a row of a table. A cell ends before " | ", the last one
 * before " |" at the end of the line. */
static bool split(const char *line, const char *cell[CELLS],
                  size_t length[CELLS])
{
    const size_t whole = strcspn(line, "\n");
    const char *at = line + 2, *last = line + whole - 2;
    for (int i = 0; i < CELLS; ++i) {
        const char *bar = i + 1 < CELLS ? strstr(at, " | ") : last;
        if (!bar || bar > last || bar < at) {
            return false;
        }
        cell[i] = at;
        length[i] = (size_t)(bar - at);
        at = bar + 3;
    }
    return true;
}

static bool is_text(const char *text, const char *cell, size_t length)
{
    return strlen(text) == length && strncmp(text, cell, length) == 0;
}

/* A cell of the row of a key. Of several rows with the name of the key, the row
 * with the same allowed values is chosen, and of such rows the row with the
 * same default. */
static char *cell_of(const murk_keys *table, const murk_key *row, int which)
{
    char name[MURK_SCENE_NAME_SIZE + 2], allowed[MURK_ALLOWED_SIZE];
    char preset[MURK_SCENE_NAME_SIZE];
    const char *line = find_text(table), *found = NULL, *cell[CELLS];
    size_t length[CELLS], found_length = 0;
    int score = -1;
    /* The cells as the key table has them. */
    snprintf(name, sizeof name, "`%s`", row->name);
    murk_value_allowed(row, allowed);
    snprintf(preset, sizeof preset, row->preset ? "`%s`" : "%s",
             row->preset      ? row->preset
             : !row->required ? "-"
             : row->group     ? "one of these"
                              : "required");
    /* The row of the table that agrees best. */
    line = line ? strstr(line, HEAD) : NULL;
    for (; line && *line == '|'; line += strcspn(line, "\n") + 1) {
        if (!split(line, cell, length) ||
            !is_text(name, cell[NAME], length[NAME])) {
            continue;
        }
        const int agreement =
            2 * is_text(allowed, cell[ALLOWED], length[ALLOWED]) +
            is_text(preset, cell[DEFAULT], length[DEFAULT]);
        if (agreement > score) {
            score = agreement;
            found = cell[which];
            found_length = length[which];
        }
    }
    return found ? plain(found, found_length) : NULL;
}

char *murk_reference_meaning(const murk_keys *table, const murk_key *row)
{
    return cell_of(table, row, MEANING);
}

char *murk_reference_default(const murk_keys *table, const murk_key *row)
{
    return cell_of(table, row, DEFAULT);
}
