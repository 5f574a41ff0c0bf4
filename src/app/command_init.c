/* murk init: prints one of the scenes to start from, which lie under
 * scenes/start and are built into the program. */
#include "app/options.h"
#include "app/scene_files.h"
#include "scene/words.h"

#include <stdlib.h>
#include <string.h>

static const char FOLDER[] = "start/";
static const char DEFAULT[] = "room";

#define NAMES_MAX 16 /* more than there are scenes */

/* Fails with the names that there are. */
static murk_status no_such_scene(const char *name, murk_error *err)
{
    char text[NAMES_MAX][MURK_SCENE_NAME_SIZE], list[200] = "", shown[64];
    const char *names[NAMES_MAX];
    size_t n = 0;
    for (size_t i = 0; i < murk_scene_files_count && n < NAMES_MAX; ++i) {
        const char *file = murk_scene_files[i].name;
        if (strncmp(file, FOLDER, strlen(FOLDER)) == 0) {
            file += strlen(FOLDER);
            snprintf(text[n], sizeof text[n], "%.*s", (int)strcspn(file, "."),
                     file);
            names[n] = text[n];
            const size_t length = strlen(list);
            snprintf(list + length, sizeof list - length, "%s%s", n ? ", " : "",
                     text[n]);
            ++n;
        }
    }
    murk_words_show(shown, sizeof shown, name);
    return murk_fail(err, MURK_BAD_VALUE, "init",
                     "%s: no such scene%s; there are %s", shown,
                     murk_words_suggest(name, names, n).text, list);
}

murk_status murk_command_init(const murk_options *options, murk_error *err)
{
    const char *name = options->input ? options->input : DEFAULT;
    char path[MURK_SCENE_NAME_SIZE];
    snprintf(path, sizeof path, "%s%s.yaml", FOLDER, name);
    const murk_scene_file *file = murk_scene_file_find(path);
    if (!file) {
        return no_such_scene(name, err);
    }
    fputs(file->text, stdout);
    return MURK_OK;
}
