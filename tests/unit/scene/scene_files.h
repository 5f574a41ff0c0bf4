/* For tests of scenes: a folder of their own as the working folder, so that
 * messages name plain files, and texts read as scenes. */
#ifndef MURK_TESTS_SCENE_FILES_H
#define MURK_TESTS_SCENE_FILES_H

#include <stdlib.h>
#include <unistd.h>

#include "check.h"
#include "scene/scene.h"
#include "written.h"

static char folder_path[256];

/* Makes it and goes there; false when it cannot. */
static inline bool folder_enter(void)
{
    const char *parent = getenv("TMPDIR");
    snprintf(folder_path, sizeof folder_path, "%s/murk-test-XXXXXX",
             parent ? parent : P_tmpdir);
    return mkdtemp(folder_path) && chdir(folder_path) == 0;
}

/* Removes what was written under these names, and the folder. */
static inline void folder_leave(const char *const *files)
{
    for (; *files; ++files) {
        unlink(*files);
    }
    CHECK(chdir("..") == 0 && rmdir(folder_path) == 0);
}

/* Reads the text as fog.yaml. */
static inline murk_status scene_of(murk_scene_desc **out, const char *text,
                                   const murk_override *overrides, size_t n,
                                   murk_error *err)
{
    *out = NULL;
    *err = (murk_error){0};
    write_text("fog.yaml", text);
    return murk_scene_desc_read(out, "fog.yaml", overrides, n, err);
}

/* The text is refused in exactly these words. */
#define CHECK_REFUSED(input, want_status, want_where, want_text)            \
    do {                                                                    \
        murk_scene_desc *scene_;                                            \
        murk_error err_;                                                    \
        CHECK(scene_of(&scene_, (input), NULL, 0, &err_) == (want_status)); \
        CHECK(scene_ == NULL);                                              \
        CHECK_TEXT(err_.where, want_where);                                 \
        CHECK_TEXT(err_.text, want_text);                                   \
        murk_scene_desc_destroy(scene_);                                    \
    } while (0)

#endif
