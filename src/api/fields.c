/* Fields of results: JSON objects whose values are read by paths. Names that
 * the user gives, such as the name of a material, may contain dots, which in a
 * path look like the dots between names. find() tries the names that fit.
 * murk_fields_make() makes the object by the same table (results/fields.h) as
 * the program makes the JSON file of the result. */
#include "api/handles.h"

#include "results/fields.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

murk_status murk_fields_make(murk_fields *fields, murk_results_list list,
                             const void *of, murk_error *err)
{
    return fields->root
               ? MURK_OK
               : murk_fields_take(fields, murk_results_json(list, of), err);
}

murk_status murk_fields_take(murk_fields *fields, cJSON *root, murk_error *err)
{
    murk_fields_release(fields);
    fields->root = root;
    fields->json = root ? cJSON_Print(root) : NULL;
    if (!fields->json) {
        murk_fields_release(fields);
        return murk_no_memory(err, "", "for the results");
    }
    return MURK_OK;
}

void murk_fields_release(murk_fields *fields)
{
    cJSON_Delete(fields->root);
    cJSON_free(fields->json);
    *fields = (murk_fields){0};
}

/* The largest whole number such that a double holds this number and all smaller
 * positive whole numbers exactly, and no other whole number of a JSON text is
 * rounded to it: 2^53 - 1 (IEEE 754 binary64; RFC 8259, section 6). */
#define EXACT_MAX INT64_C(9007199254740991)

/* An item with an index below this is not remembered as the item that was read
 * last, because it is found by a short walk from the first item. */
#define SHORT_LIST 8

/* Item i of a list; NULL if there is none. If fields->last.item is of this list
 * and not behind item i, the walk begins there, so that the time to read a list
 * in order is in proportion to the length of the list; else the walk begins at
 * the first item. An item with an index below SHORT_LIST is not remembered: it
 * may belong to a short list inside an item of a long list, such as a position
 * of three numbers, and would take the place of the item of the long list. */
static const cJSON *item_of(const murk_fields *fields, const cJSON *list, int i)
{
    murk_fields *memory = (murk_fields *)fields;
    const cJSON *item = list->child;
    int at = 0;
    if (memory->last.list == list && memory->last.index <= i) {
        item = memory->last.item;
        at = memory->last.index;
    }
    while (item && at < i) {
        item = item->next;
        ++at;
    }
    if (item && i >= SHORT_LIST) {
        memory->last.list = list;
        memory->last.item = item;
        memory->last.index = i;
    }
    return item;
}

/* The item of a list that the first part of a path is the index of. NULL if
 * there is no such item. length: of the first part. */
static const cJSON *indexed_item(const murk_fields *fields, const cJSON *list,
                                 const char *path, size_t length)
{
    const size_t digits = strspn(path, "0123456789");
    return digits > 0 && digits < 10 && digits == length
               ? item_of(fields, list, atoi(path))
               : NULL;
}

/* The member of an object whose name is the first `length` bytes of a path;
 * NULL if there is no such member. */
static const cJSON *named_member(const cJSON *object, const char *path,
                                 size_t length)
{
    const cJSON *member = cJSON_IsObject(object) ? object->child : NULL;
    while (member && (strncmp(member->string, path, length) != 0 ||
                      member->string[length] != '\0')) {
        member = member->next;
    }
    return member;
}

/* The item at a path from an item; the item itself if the path is empty. NULL
 * if there is no such item. Of an object, the member with the longest name that
 * the path begins with is tried first, and the member with the next shorter
 * name if the rest of the path leads to no item of the first. */
static const cJSON *find_from(const murk_fields *fields, const cJSON *from,
                              const char *path)
{
    if (!*path) {
        return from;
    }
    /* `length` is that of the name or index, and ends at a dot or at the end of
     * the path. */
    for (size_t length = strlen(path);;) {
        const char *rest = path + length + (path[length] == '.');
        const bool ends_in_dot = path[length] == '.' && !*rest;
        const cJSON *next = cJSON_IsArray(from)
                                ? indexed_item(fields, from, path, length)
                                : named_member(from, path, length);
        const cJSON *found =
            next && !ends_in_dot ? find_from(fields, next, rest) : NULL;
        if (found) {
            return found;
        }
        do {
            if (length == 0) {
                return NULL;
            }
            --length;
        } while (path[length] != '.');
    }
}

/* The item at a path; the whole result if the path is NULL or empty. NULL if
 * there is no such item, or if `fields` is NULL. */
static const cJSON *find(const murk_fields *fields, const char *path)
{
    const cJSON *root = fields ? fields->root : NULL;
    return root && path ? find_from(fields, root, path) : root;
}

murk_field_kind murk_fields_kind(const murk_fields *fields, const char *path)
{
    const cJSON *item = find(fields, path);
    return !item                  ? MURK_FIELD_UNKNOWN
           : cJSON_IsNull(item)   ? MURK_FIELD_ABSENT
           : cJSON_IsNumber(item) ? MURK_FIELD_NUMBER
           : cJSON_IsBool(item)   ? MURK_FIELD_BOOL
           : cJSON_IsString(item) ? MURK_FIELD_STRING
           : cJSON_IsArray(item)  ? MURK_FIELD_LIST
                                  : MURK_FIELD_OBJECT;
}

/* Fails with MURK_BAD_VALUE: because the caller's `value`, the address to write
 * to, is NULL, or else because the field at the path is not of the wanted kind.
 */
static murk_status refuse(const murk_fields *fields, const char *path,
                          const void *value, const char *wanted,
                          murk_error *error)
{
    if (!value) {
        return murk_call_refuse(error, "value is NULL");
    }
    static const char *const kinds[] = {"no field",      "absent",   "a number",
                                        "true or false", "a string", "a list",
                                        "an object"};
    murk_error failure = {0};
    (void)murk_fail(&failure, MURK_BAD_VALUE, path ? path : "",
                    "is %s, must be %s", kinds[murk_fields_kind(fields, path)],
                    wanted);
    murk_call_pass(error, &failure); /* the place is the path of a field */
    return MURK_BAD_VALUE;
}

murk_status murk_fields_double(const murk_fields *fields, const char *path,
                               double *value, murk_error *error)
{
    const murk_field_kind kind = murk_fields_kind(fields, path);
    if (!value || (kind != MURK_FIELD_NUMBER && kind != MURK_FIELD_ABSENT)) {
        return refuse(fields, path, value, "a number", error);
    }
    *value = kind == MURK_FIELD_ABSENT ? NAN : find(fields, path)->valuedouble;
    return MURK_OK;
}

murk_status murk_fields_int64(const murk_fields *fields, const char *path,
                              int64_t *value, murk_error *error)
{
    const cJSON *item = find(fields, path);
    if (!value || !cJSON_IsNumber(item)) {
        return refuse(fields, path, value, "a whole number", error);
    }
    const double number = item->valuedouble;
    if (number != nearbyint(number) || !(fabs(number) <= (double)EXACT_MAX)) {
        murk_error failure = {0};
        (void)murk_fail(&failure, MURK_BAD_VALUE, path ? path : "",
                        "is %.17g, must be a whole number of %lld..%lld, "
                        "which a double holds exactly",
                        number, (long long)-EXACT_MAX, (long long)EXACT_MAX);
        murk_call_pass(error, &failure);
        return MURK_BAD_VALUE;
    }
    *value = (int64_t)number;
    return MURK_OK;
}

murk_status murk_fields_bool(const murk_fields *fields, const char *path,
                             bool *value, murk_error *error)
{
    const cJSON *item = find(fields, path);
    if (!value || !cJSON_IsBool(item)) {
        return refuse(fields, path, value, "true or false", error);
    }
    *value = cJSON_IsTrue(item);
    return MURK_OK;
}

murk_status murk_fields_string(const murk_fields *fields, const char *path,
                               const char **value, murk_error *error)
{
    const murk_field_kind kind = murk_fields_kind(fields, path);
    if (!value || (kind != MURK_FIELD_STRING && kind != MURK_FIELD_ABSENT)) {
        return refuse(fields, path, value, "a string", error);
    }
    *value = find(fields, path)->valuestring; /* NULL of null */
    return MURK_OK;
}

size_t murk_fields_length(const murk_fields *fields, const char *path)
{
    const cJSON *item = find(fields, path);
    return cJSON_IsArray(item) || cJSON_IsObject(item)
               ? (size_t)cJSON_GetArraySize(item)
               : 0;
}

const char *murk_fields_name(const murk_fields *fields, const char *path,
                             size_t i)
{
    const cJSON *item = find(fields, path);
    const cJSON *child =
        cJSON_IsObject(item) && i < murk_fields_length(fields, path)
            ? cJSON_GetArrayItem(item, (int)i)
            : NULL;
    return child ? child->string : NULL;
}

const char *murk_fields_json(const murk_fields *fields)
{
    return fields ? fields->json : NULL;
}
