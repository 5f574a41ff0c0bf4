/* Prints positions in messages. A scene far from 0 is computed about a local
 * origin (scene/origin.h), so that most of src knows positions relative to that
 * origin only. A message prints such a position through this header, so that
 * users read the position in the coordinates of their scene. */
#ifndef MURK_BASE_POSITION_H
#define MURK_BASE_POSITION_H

#include "base/vector.h"

typedef struct murk_position_text {
    char text[96]; /* e.g. "[500001.5, 5500002, 3]" */
} murk_position_text;

/* Sets the local origin of the host of the calling thread (base/host.h), in the
 * coordinates of the user [m]; at first it is 0. Call it while no other thread
 * of the host prints messages. */
void murk_position_origin(murk_vec3 origin);

/* Prints, in the coordinates of the user, a position that is given relative to
 * the local origin: with 9 digits, or with 12 if the local origin is not 0. 12
 * digits resolve millimetres below 1e9 m. */
murk_position_text murk_position_show(murk_vec3 local);

#endif
