/* The files of murk render: the OpenEXR image, and PNG files beside it. */
#ifndef MURK_APP_IMAGES_H
#define MURK_APP_IMAGES_H

#include "app/viewpoint.h"
#include "render/false_colour.h"

typedef struct murk_image_files {
    char *exr, *png, *false_colour;       /* paths, owned; NULL: not wanted */
    char channel[MURK_CHANNEL_NAME_SIZE]; /* in false colour */
    /* Once written: */
    double stops;              /* exposure of the PNG */
    murk_false_colour colours; /* of the image in false colour */
} murk_image_files;

/* What a picture is of and how it was made, as far as the images say it. */
typedef struct murk_image_facts {
    const murk_scene_desc *scene;
    const murk_viewpoint *viewpoint;
    const murk_options *options;
    const char *method; /* "path: path tracing with shadow rays" */
    uint64_t photons;
} murk_image_facts;

/* Sets the names of the files: that of -o, or else the name of the scene with
 * the mark, beside the scene; and finds the channel to show in false colour.
 * Fails with MURK_BAD_VALUE if two bands would have channels of one name, if
 * there is no such channel, or if murk did not write a file that has the name;
 * and with MURK_RUN_FAILED if a file cannot be made. Release *out also after a
 * failure. */
murk_status murk_images_name(murk_image_files *out, const murk_options *options,
                             const murk_scene_desc *scene, const char *mark,
                             murk_error *err);

/* Writes the OpenEXR image, then the PNG files. Each file is written whole or
 * not at all. */
murk_status murk_images_write(murk_image_files *images,
                              const murk_image *picture,
                              const murk_image_facts *facts, murk_error *err);
void murk_images_release(murk_image_files *images);

#endif
