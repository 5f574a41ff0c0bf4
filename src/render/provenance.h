/* What an image says of itself: name and text of each line of its header. */
#ifndef MURK_RENDER_PROVENANCE_H
#define MURK_RENDER_PROVENANCE_H

typedef struct murk_image_text {
    const char *name; /* 1..79 letters and digits */
    const char *text; /* UTF-8 */
} murk_image_text;

#endif
