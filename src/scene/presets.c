/* Reads preset files (YAML, built into the program) by their key table, and
 * finds presets by name. */
#include "scene/presets.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/words.h"
#include "preset/files.h"
#include "scene/keys_preset.h"

#define SOURCE_SIZE (MURK_PRESET_NAME_SIZE + sizeof ENDING)

#define ENDING ".yaml"

murk_status murk_preset_parse(murk_preset **out, const char *name,
                              const char *text, size_t size, murk_error *err)
{
    char source[SOURCE_SIZE];
    snprintf(source, sizeof source, "%s" ENDING, name);
    murk_key_reader walk = {.err = err};
    murk_preset *preset = calloc(1, sizeof *preset);
    murk_status status = MURK_OK;
    if (!preset || !(preset->name = strdup(name))) {
        status = murk_no_memory(err, source, "for a preset");
    }
    if (!status) {
        status = murk_yaml_parse(&walk.root, text, size, source, err);
    }
    if (!status) {
        status = murk_walk_root(&walk, &murk_preset_keys, preset);
    }
    /* Hand over a complete preset only. */
    if (!status) {
        *out = preset;
        preset = NULL;
    }
    murk_yaml_destroy(walk.root);
    murk_preset_destroy(preset);
    return status;
}

/* ---- built-in presets ---- */

/* Copies the name of a preset file without the ending: "fog/kruse" for
 * "fog/kruse.yaml". Returns false for files with another ending, such as
 * tables, and for names that are too long. */
static bool name_of(const murk_built_in_file *file,
                    char out[MURK_PRESET_NAME_SIZE])
{
    const size_t length = strlen(file->name), end = strlen(ENDING);
    if (length <= end || strcmp(file->name + length - end, ENDING) != 0 ||
        length - end >= MURK_PRESET_NAME_SIZE) {
        return false;
    }
    memcpy(out, file->name, length - end);
    out[length - end] = '\0';
    return true;
}

size_t murk_presets_count(void)
{
    char name[MURK_PRESET_NAME_SIZE];
    size_t n = 0;
    for (size_t i = 0; i < murk_media_files.n; ++i) {
        n += name_of(&murk_media_files.file[i], name);
    }
    return n;
}

void murk_presets_name(size_t index, char out[MURK_PRESET_NAME_SIZE])
{
    size_t n = 0;
    out[0] = '\0';
    for (size_t i = 0; i < murk_media_files.n; ++i) {
        if (name_of(&murk_media_files.file[i], out) && n++ == index) {
            return;
        }
    }
    out[0] = '\0';
}

static murk_status fail_unknown(const char *name, const char *where,
                                murk_error *err)
{
    const size_t n = murk_presets_count();
    char shown[MURK_PRESET_NAME_SIZE];
    char(*names)[MURK_PRESET_NAME_SIZE] = calloc(n + 1, sizeof *names);
    const char **known = calloc(n + 1, sizeof *known);
    const char *meant = NULL;
    /* Compare with the names of all presets. */
    for (size_t i = 0; names && known && i < n; ++i) {
        murk_presets_name(i, names[i]);
        known[i] = names[i];
    }
    if (names && known) {
        meant = murk_words_meant(name, known, n);
    }
    murk_words_show(shown, sizeof shown, name);
    const murk_status status =
        meant ? murk_fail(err, MURK_BAD_VALUE, where,
                          "no preset %s, did you mean %s?", shown, meant)
              : murk_fail(err, MURK_BAD_VALUE, where,
                          "no preset %s, must be one of those that `murk "
                          "media` lists",
                          shown);
    free(names);
    free(known);
    return status;
}

murk_status murk_presets_read(murk_preset **out, const char *name,
                              const char *where, murk_error *err)
{
    char own[MURK_PRESET_NAME_SIZE];
    for (size_t i = 0; i < murk_media_files.n; ++i) {
        const murk_built_in_file *file = &murk_media_files.file[i];
        if (name_of(file, own) && strcmp(own, name) == 0) {
            return murk_preset_parse(out, name, file->text, file->size, err);
        }
    }
    return fail_unknown(name, where, err);
}
