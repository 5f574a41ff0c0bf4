/* murk init: prints one of the scenes to start from, which lie under
 * scenes/start and are built into the program. */
#include "app/built_in_files.h"
#include "app/options.h"
#include "base/words.h"

#include <stdlib.h>
#include <string.h>

static const char DEFAULT[] = "room";

#define NAMES_MAX 16 /* more than there are scenes */
#define NAME_SIZE 64 /* bytes, more than the name of a file of them has */

/* Fails with a message that lists the names of the scenes. */
static murk_status no_such_scene(const char *name, murk_error *err)
{
    char text[NAMES_MAX][NAME_SIZE], list[200] = "", shown[64];
    const char *names[NAMES_MAX];
    size_t n = 0;
    for (size_t i = 0; i < murk_start_files.n && i < NAMES_MAX; ++i) {
        const char *file = murk_start_files.file[i].name;
        snprintf(text[i], sizeof text[i], "%.*s", (int)strcspn(file, "."),
                 file);
        names[n++] = text[i];
        const size_t length = strlen(list);
        snprintf(list + length, sizeof list - length, "%s%s", i ? ", " : "",
                 text[i]);
    }
    murk_words_show(shown, sizeof shown, name);
    return murk_fail(err, MURK_BAD_VALUE, "init",
                     "%s: no such scene%s; there are %s", shown,
                     murk_words_suggest(name, names, n).text, list);
}

murk_status murk_command_init(const murk_options *options, murk_error *err)
{
    const char *name = options->input ? options->input : DEFAULT;
    char path[NAME_SIZE];
    snprintf(path, sizeof path, "%s.yaml", name);
    const murk_built_in_file *file =
        murk_built_in_find(&murk_start_files, path);
    if (!file) {
        return no_such_scene(name, err);
    }
    fputs(file->text, stdout);
    return MURK_OK;
}
