/* Texts in the header of an image file on the origin of the image. */
#ifndef MURK_RENDER_PROVENANCE_H
#define MURK_RENDER_PROVENANCE_H

typedef struct murk_image_text {
    const char *name; /* 1..79 letters and digits */
    const char *text; /* UTF-8 */
} murk_image_text;

#endif
