/* Writes the text of a scene to a temporary file, reads it with overrides as a
 * command would, and builds the stage from it. */
#include "stage_text.h"

#include "base/file.h"
#include "world/stage_build.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define OVERRIDES_MAX 64

murk_scene_desc *scene_text_create(const char *yaml,
                                   const char *const *overrides)
{
    char path[] = "/tmp/murk_test_scene_XXXXXX";
    murk_error err = {0};
    murk_scene_desc *scene = NULL;
    murk_override list[OVERRIDES_MAX];
    size_t n = 0;
    /* The overrides, then the text by a file. */
    while (overrides && overrides[n] && n < OVERRIDES_MAX) {
        list[n] = (murk_override){.text = overrides[n]};
        ++n;
    }
    if (overrides && overrides[n]) {
        printf("more than %d overrides\n", OVERRIDES_MAX);
        return NULL;
    }
    const int fd = mkstemp(path);
    if (fd < 0 || write(fd, yaml, strlen(yaml)) < 0) {
        printf("cannot write %s\n", path);
    } else if (murk_scene_desc_read(&scene, path, list, n, &err)) {
        printf("%s: %s\n", err.where, err.text);
    }
    if (fd >= 0) {
        close(fd);
        unlink(path);
    }
    return scene;
}

murk_stage *stage_text_create(const char *yaml, const char *const *overrides)
{
    murk_error err = {0};
    murk_stage *stage = NULL;
    murk_scene_desc *scene = scene_text_create(yaml, overrides);
    if (scene && murk_stage_create(&stage, scene, &err)) {
        printf("%s: %s\n", err.where, err.text);
        murk_scene_desc_destroy(scene);
    }
    return stage;
}

void stage_text_destroy(murk_stage *stage)
{
    if (stage) {
        /* the test made the scene, so it may also end it */
        murk_scene_desc *scene = (murk_scene_desc *)(uintptr_t)stage->scene;
        murk_stage_destroy(stage);
        murk_scene_desc_destroy(scene);
    }
}
