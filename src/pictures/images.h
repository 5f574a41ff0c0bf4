/* The files of a picture: the OpenEXR image, and PNG files beside it. */
#ifndef MURK_PICTURES_IMAGES_H
#define MURK_PICTURES_IMAGES_H

#include "pictures/viewpoint.h"
#include "render/false_colour.h"

typedef struct murk_image_files {
    murk_image_options options;           /* of murk.h; borrows its text */
    char *exr, *png, *false_colour;       /* paths, owned; NULL: not wanted */
    char channel[MURK_CHANNEL_NAME_SIZE]; /* in false colour */
    /* Once written: */
    double stops;              /* exposure of the PNG */
    murk_false_colour colours; /* of the image in false colour */
} murk_image_files;

/* What the headers of the images say of the picture. */
typedef struct murk_image_facts {
    const murk_scene_desc *scene;
    const murk_viewpoint *viewpoint;
    const char *command; /* the command line; NULL: not said */
    const char *method;  /* "path: path tracing with shadow rays" */
    uint64_t photons;
} murk_image_facts;

/* Sets the names of the files: `path` is that of the OpenEXR image, and the
 * names of PNG files follow from it; path NULL: no file is wanted. Finds the
 * channel to show in false colour. has_coverage: the picture has the channels
 * of coverage. replaces: files that murk did not write may be replaced. Fails
 * with MURK_BAD_VALUE if two bands would have channels of one name, if there is
 * no such channel, if the path ends in ".png", or if a file may not be
 * replaced; and with MURK_RUN_FAILED if a file cannot be made. Release *out
 * also after a failure. */
murk_status murk_images_name(murk_image_files *out, const char *path,
                             const murk_image_options *options,
                             const murk_scene_desc *scene, bool has_coverage,
                             bool replaces, murk_error *err);

/* The memory that writing the files takes in addition to the picture
 * [bytes]. */
double murk_images_bytes(const murk_image_options *options, size_t width,
                         size_t height);

/* Writes the OpenEXR image, then the PNG files. Each file is written whole or
 * not at all. */
murk_status murk_images_write(murk_image_files *images,
                              const murk_image *picture,
                              const murk_image_facts *facts, murk_error *err);
void murk_images_release(murk_image_files *images);

#endif
