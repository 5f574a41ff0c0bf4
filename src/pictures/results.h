/* The results of a picture: the JSON and the lines of the summary. */
#ifndef MURK_PICTURES_RESULTS_H
#define MURK_PICTURES_RESULTS_H

#include "pictures/rendering.h"
#include "results/session.h"

typedef struct murk_picture_results {
    const murk_session *session; /* traced NULL: the picture is without light */
    const murk_rendering *rendering;
    const murk_image_files *images; /* as written */
} murk_picture_results;

/* The JSON, without `identity` and `run`, for murk_session_finish(). */
cJSON *murk_picture_json(const murk_picture_results *results);

/* Prints the summary with the lines of the time and the files. `of` points to a
 * murk_picture_results whose session is finished. */
void murk_picture_print(const void *of);

#endif
