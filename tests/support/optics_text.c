/* Builds the optics that re-weighting needs from a scene that is given as
 * text. Failures end the program. */
#include "optics_text.h"

#include "stage_text.h"

#include <stdio.h>
#include <stdlib.h>

murk_optics *optics_text_create(const char *yaml, const char *const *overrides)
{
    murk_scene_desc *scene = scene_text_create(yaml, overrides);
    murk_error err = {0};
    murk_optics *optics = NULL;
    if (!scene ||
        murk_optics_create(&optics, scene, &scene->domain, NULL, NULL, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    return optics;
}
