/* The current key of a traversal (scene/walk.h), and messages that name that
 * key and the place of a node. */
#include "scene/walk.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/words.h"

#define PLACE_SIZE (MURK_SCENE_WHERE_SIZE - MURK_WALK_KEY_SIZE)

size_t murk_walk_enter(murk_key_reader *walk, const char *part)
{
    const size_t length = strlen(walk->key);
    char shown[MURK_SCENE_NAME_SIZE];
    murk_words_show(shown, sizeof shown, part);
    snprintf(walk->key + length, sizeof walk->key - length, "%s%s",
             length ? "." : "", shown);
    return length;
}

size_t murk_walk_enter_item(murk_key_reader *walk, size_t index)
{
    char number[24];
    snprintf(number, sizeof number, "%zu", index);
    return murk_walk_enter(walk, number);
}

void murk_walk_leave(murk_key_reader *walk, size_t length)
{
    walk->key[length] = '\0';
}

/* True if `source` is an option that names the key itself: --set KEY=VALUE, set
 * KEY=VALUE of the library, or any other option, such as --seed 3. */
static bool names_key(const char *source, const char *key)
{
    const size_t length = strlen(key), mark = strlen(MURK_SET_MARK);
    const char *set = strncmp(source, "--", 2) == 0 ? source + 2 : source;
    if (strncmp(set, MURK_SET_MARK, mark) != 0) {
        return murk_yaml_is_option(source);
    }
    return strncmp(set + mark, key, length) == 0 && set[mark + length] == '=';
}

void murk_walk_where(const murk_yaml *node, const char *key, bool at_key,
                     murk_scene_where out)
{
    char place[PLACE_SIZE];
    if (at_key || node->kind != MURK_YAML_SCALAR) {
        murk_yaml_key_place(node, place, sizeof place);
    } else {
        murk_yaml_place(node, place, sizeof place);
    }
    const bool is_said = key[0] == '\0' || names_key(node->source, key);
    snprintf(out, MURK_SCENE_WHERE_SIZE, "%s%s%.*s", place, is_said ? "" : ": ",
             is_said ? 0 : MURK_WALK_KEY_SIZE, key);
}

static murk_status fail(murk_key_reader *walk, const murk_yaml *node,
                        bool at_key, const char *format, va_list args)
{
    murk_scene_where where;
    char text[512];
    vsnprintf(text, sizeof text, format, args);
    murk_walk_where(node, walk->key, at_key, where);
    return murk_fail(walk->err, MURK_BAD_VALUE, where, "%s", text);
}

murk_status murk_walk_fail(murk_key_reader *walk, const murk_yaml *node,
                           const char *format, ...)
{
    va_list args;
    va_start(args, format);
    const murk_status status = fail(walk, node, false, format, args);
    va_end(args);
    return status;
}

murk_status murk_walk_fail_key(murk_key_reader *walk, const murk_yaml *node,
                               const char *format, ...)
{
    va_list args;
    va_start(args, format);
    const murk_status status = fail(walk, node, true, format, args);
    va_end(args);
    return status;
}

murk_status murk_walk_no_memory(murk_key_reader *walk)
{
    return murk_no_memory(walk->err, walk->root->source, "to read it");
}
