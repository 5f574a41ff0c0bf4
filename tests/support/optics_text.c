#include "optics_text.h"

#include "stage_text.h"

#include <stdio.h>
#include <stdlib.h>

murk_optics optics_text_read(const char *yaml, const char *const *overrides)
{
    murk_scene *scene = scene_text_create(yaml, overrides);
    murk_error err = {0};
    murk_optics o = {.scene = scene};
    if (!scene || murk_phases_create(&o.phases, scene, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    o.bands = scene->bands;
    o.media = scene->n_media;
    o.channels = scene->n_lights * (size_t)scene->bands;
    o.extinction_per_m = calloc(o.media + 1, sizeof *o.extinction_per_m);
    o.albedo = calloc(o.media + 1, sizeof *o.albedo);
    o.power_w = calloc(o.channels + 1, sizeof *o.power_w);
    if (!o.extinction_per_m || !o.albedo || !o.power_w) {
        printf("out of memory\n");
        exit(1);
    }
    for (size_t m = 0; m < o.media; ++m) {
        o.extinction_per_m[m] = scene->media[m].extinction_per_m;
        o.albedo[m] = scene->media[m].albedo;
    }
    for (size_t c = 0; c < o.channels; ++c) {
        const size_t bands = (size_t)scene->bands;
        o.power_w[c] = scene->lights[c / bands].power_w.band[c % bands];
    }
    return o;
}

void optics_text_release(murk_optics *optics)
{
    murk_phases_destroy(optics->phases);
    murk_scene_destroy(optics->scene);
    free(optics->extinction_per_m);
    free(optics->albedo);
    free(optics->power_w);
    *optics = (murk_optics){0};
}
