/* The frame of public calls: the calling thread enters the host of the context
 * (base/host.h), the work fills an error of murk's own, and at the end the
 * message goes to the error of the caller, with the place split into file,
 * line, column and key. Also the checks of arguments and structs of the caller.
 */
#include "api/handles.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "base/ranks.h"
#include "base/version.h"
#include "scene/keys.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The beginning of the places that murk_call_bad_argument() makes. */
#define MURK_ARGUMENT "argument "

/* Bytes for one part of the path of a key; names of keys are shorter. */
#define KEY_PART_SIZE 256

/* No struct of murk.h will have more bytes: a larger size is a mistake, such as
 * memory that was not set. */
#define STRUCT_MAX 4096

const char *murk_version(void)
{
    return MURK_VERSION;
}

murk_call murk_call_begin(murk_context *context, const murk_memory_files *files,
                          murk_error *error)
{
    murk_call call = {
        .context = context, .host = context->host, .error = error};
    call.before = murk_host_enter(context->host);
    context->host->files = files;
    return call;
}

/* Removes ":NUMBER", a number of 1 to 9 digits, from the end of a text and
 * returns the number. Returns 0 and changes nothing if the text does not end
 * so. */
static int take_number(char *text)
{
    char *colon = strrchr(text, ':');
    const size_t digits = colon ? strspn(colon + 1, "0123456789") : 0;
    if (digits == 0 || digits > 9 || colon[1 + digits] != '\0') {
        return 0;
    }
    *colon = '\0';
    return (int)strtol(colon + 1, NULL, 10);
}

/* True if the text has only characters that paths of keys have, or none. */
static bool is_key(const char *text)
{
    return strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                        "0123456789._@-") == strlen(text);
}

/* Arguments of public calls, and members of options, whose name is the place of
 * a failure. The place of an element of a list of texts is "NAME TEXT", where
 * TEXT begins with a key: "keys KEY" or "bounds KEY=LOW:HIGH". */
static const struct {
    const char *name;
    bool is_list;
} settings[] = {
    {"keys", true},          {"bounds", true},   {"exports", false},
    {"voxel_m", false},      {"runs", false},    {"loss", false},
    {"predict", false},      {"command", false}, {"photon", false},
    {"picture", false},      {"pixels", false},  {"cut_m", false},
    {"ranks", false},        {"camera", false},  {"from_sensor", false},
    {"false_colour", false}, {"width_m", false}, {"next", false}};

/* Returns the part of a place behind MURK_SET_MARK ("set "), or behind the name
 * of a setting and a blank if the setting is a list: a text that begins with a
 * key. Returns "" if the place is the name of a setting, and NULL for any other
 * place. */
static const char *rest_of_setting(const char *place)
{
    if (strncmp(place, MURK_SET_MARK, strlen(MURK_SET_MARK)) == 0) {
        return place + strlen(MURK_SET_MARK);
    }
    for (size_t i = 0; i < sizeof settings / sizeof *settings; ++i) {
        const size_t length = strlen(settings[i].name);
        if (strncmp(place, settings[i].name, length) != 0) {
            continue;
        }
        if (place[length] == '\0') {
            return place + length;
        }
        if (settings[i].is_list && place[length] == ' ') {
            return place + length + 1;
        }
    }
    return NULL;
}

/* True if the key table has this path, such as "placement.threshold" or
 * "lights.0", or if the path is empty. A number behind a key counts as an
 * index. False for a path with the name of a medium or of another item that the
 * user names, because the key table does not have these names. */
static bool is_scene_key(const char *path)
{
    const murk_keys *keys = &murk_scene_keys;
    while (*path) {
        char part[KEY_PART_SIZE];
        const size_t length = strcspn(path, ".");
        snprintf(part, sizeof part, "%.*s", (int)length, path);
        const bool is_index =
            keys != &murk_scene_keys && strspn(part, "0123456789") == length;
        const murk_key *row =
            keys && !is_index ? murk_keys_find(keys, part) : NULL;
        if (!row && !is_index) {
            return false;
        }
        keys = is_index ? keys : row->keys;
        path += length + (path[length] == '.');
    }
    return true;
}

/* True if a place that may be a key, a setting or a file of the same name is
 * taken for the key or the setting. The code of the error decides: a file that
 * is malformed or cannot be written fails with other codes. */
static bool may_be_name(const murk_error *error)
{
    return error->code == MURK_BAD_VALUE || error->code == MURK_NO_MEMORY;
}

/* Splits the place of an error into the members file, line, column and key.
 * "FILE:LINE:COLUMN: KEY" sets all of them; every part but FILE may be absent.
 * "set KEY=VALUE", and "NAME KEY" with the name of a setting, set `key` alone.
 * If may_be_name() is true, the path of a key in the key table sets `key` alone
 * as well, and the name of a setting sets none; else both count as files. An
 * argument sets none. A key behind ": " takes precedence over another key. An
 * error that names a file already, the array that a call adds, is left as it
 * is. */
static void split_place(murk_error *error)
{
    if (error->file[0]) {
        return;
    }
    char place[sizeof error->where];
    snprintf(place, sizeof place, "%s", error->where);
    char *key = NULL;
    for (char *at = strstr(place, ": "); at; at = strstr(at + 1, ": ")) {
        key = at;
    }
    if (key && is_key(key + 2)) {
        *key = '\0';
        snprintf(error->key, sizeof error->key, "%s", key + 2);
    }
    /* The rest of the place is an argument, a setting, a key or a file. */
    if (strncmp(place, MURK_ARGUMENT, strlen(MURK_ARGUMENT)) == 0) {
        return;
    }
    const char *rest = rest_of_setting(place);
    if (rest && (rest[0] || may_be_name(error))) {
        if (error->key[0] == '\0') {
            snprintf(error->key, sizeof error->key, "%.*s",
                     (int)strcspn(rest, "="), rest);
        }
        return;
    }
    if (!key && may_be_name(error) && is_scene_key(place)) {
        snprintf(error->key, sizeof error->key, "%s", place);
        return;
    }
    const int last = take_number(place), line = last ? take_number(place) : 0;
    error->line = line ? line : last;
    error->column = line ? last : 0;
    snprintf(error->file, sizeof error->file, "%s", place);
}

void murk_call_report(murk_error *to, murk_error *failure)
{
    split_place(failure);
    murk_call_pass(to, failure);
}

void murk_call_pass(murk_error *to, murk_error *failure)
{
    if (!to || to->code != MURK_OK) {
        return;
    }
    const size_t size =
        to->size > 0 && to->size < sizeof *failure ? to->size : sizeof *failure;
    failure->size = to->size;
    memcpy(to, failure, size);
}

murk_status murk_call_end(murk_call *call, murk_status status)
{
    call->host->files = NULL;
    (void)murk_host_enter(call->before);
    /* The request to stop is met, so the next call works as usual. */
    if (status == MURK_INTERRUPTED) {
        atomic_store(&call->host->stop, 0);
    }
    if (status) {
        (void)murk_fail(&call->failure, status, "", "%s",
                        murk_status_text(status));
        call->failure.code = status;
        murk_call_report(call->error, &call->failure);
    }
    return status;
}

murk_status murk_call_end_long(murk_call *call, murk_status status)
{
    /* The request may have caused any other failure, so report it instead. */
    if (atomic_exchange(&call->host->stop, 0)) {
        call->failure = (murk_error){0};
        status = murk_fail(&call->failure, MURK_INTERRUPTED, "", "interrupted");
    }
    return murk_call_end(call, status);
}

murk_status murk_call_limit_search(double limit_s, double begun_s,
                                   murk_error *failure)
{
    if (!(limit_s > 0)) {
        return MURK_OK;
    }
    if (murk_ranks_count() > 1) {
        return murk_fail(failure, MURK_BAD_VALUE, "placement.time_limit_s",
                         "%g s with %u ranks, each of which would end its "
                         "search at another point; must be absent",
                         limit_s, murk_ranks_count());
    }
    murk_finish_set_deadline(begun_s + limit_s);
    return MURK_OK;
}

murk_status murk_call_refuse(murk_error *error, const char *text)
{
    murk_error failure = {0};
    (void)murk_fail(&failure, MURK_BAD_VALUE, "", "%s", text);
    murk_call_report(error, &failure);
    return MURK_BAD_VALUE;
}

murk_status murk_call_bad_argument(murk_error *err, const char *name,
                                   const char *format, ...)
{
    char where[sizeof err->where], text[sizeof err->text];
    snprintf(where, sizeof where, MURK_ARGUMENT "%s", name);
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return murk_fail(err, MURK_BAD_VALUE, where, "%s", text);
}

murk_status murk_call_check_texts(murk_error *err, const char *name,
                                  const char *const *text, size_t n)
{
    if (!text && n > 0) {
        return murk_call_bad_argument(err, name, "is NULL, must be %zu texts",
                                      n);
    }
    for (size_t i = 0; i < n; ++i) {
        if (!text[i]) {
            return murk_call_bad_argument(
                err, name, "element %zu of %zu is NULL, must be a text", i, n);
        }
    }
    return MURK_OK;
}

murk_status murk_struct_check(const void *given, size_t min_size, size_t known,
                              const char *argument, const char *type,
                              murk_error *err)
{
    size_t size;
    memcpy(&size, given, sizeof size);
    /* All structs of murk.h have the alignment of their first member, a
     * size_t, so their size is a multiple of that alignment. */
    if (size == 0 || size < min_size || size > STRUCT_MAX ||
        size % _Alignof(size_t) != 0) {
        return murk_call_bad_argument(
            err, argument, "size is %zu, must be sizeof(%s)", size, type);
    }
    const unsigned char *byte = given;
    for (size_t i = known; i < size; ++i) {
        if (byte[i]) {
            char where[sizeof err->where];
            snprintf(where, sizeof where, MURK_ARGUMENT "%s", argument);
            return murk_fail(err, MURK_UNSUPPORTED, where,
                             "%s has a member of a newer murk.h that is not 0, "
                             "which murk " MURK_VERSION " does not know",
                             type);
        }
    }
    return MURK_OK;
}

murk_status murk_options_copy(void *known, size_t size, const void *given,
                              const char *argument, const char *type,
                              murk_error *err)
{
    const murk_status status =
        given ? murk_struct_check(given, sizeof(size_t), size, argument, type,
                                  err)
              : MURK_OK;
    if (given && !status) {
        size_t bytes;
        memcpy(&bytes, given, sizeof bytes);
        memcpy(known, given, bytes < size ? bytes : size);
    }
    return status;
}
