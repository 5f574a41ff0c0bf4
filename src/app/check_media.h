/* What check says of media, their phase functions, and the regions that they
 * fill. */
#ifndef MURK_APP_CHECK_MEDIA_H
#define MURK_APP_CHECK_MEDIA_H

#include "results/json.h"

#include "world/stage.h"

void murk_print_media(const murk_stage *stage);

/* Adds "media" and "regions", lists. */
void murk_json_media(cJSON *root, const murk_stage *stage);

#endif
