/* Positions in messages. A scene far from 0 is computed about a local origin
 * (scene/origin.h), of which the rooms below `study` know nothing; what they
 * say of a position is printed in the coordinates of the user's scene all the
 * same, because every message prints positions through this header. */
#ifndef MURK_BASE_POSITION_H
#define MURK_BASE_POSITION_H

#include "base/vector.h"

typedef struct murk_position_text {
    char text[96]; /* "[500001.5, 5500002, 3]" */
} murk_position_text;

/* The place in the user's coordinates that positions count from; 0 at first.
 * Set it while no other thread prints messages. */
void murk_position_origin(murk_vec3 origin);

/* A position that counts from there, as the user knows it: to 9 digits, and
 * with a local origin to 12, which are millimetres below 1e9 m. */
murk_position_text murk_position_show(murk_vec3 local);

#endif
