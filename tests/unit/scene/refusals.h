/* For tests of refusals: what is refused, where and in which words. */
#ifndef MURK_TESTS_REFUSALS_H
#define MURK_TESTS_REFUSALS_H

#include "scene_files.h"

#define HEAD    "murk: 1\n"
#define LAMP    "lights: [{type: point, position_m: [0, 0, 0], power_w: 1}]\n"
#define SENSORS "sensors: {types: [{name: a, range_m: 1}], "
#define VALUE   MURK_BAD_VALUE

typedef struct refusal {
    const char *scene; /* from line 2 on, without lights */
    murk_status status;
    const char *where, *text;
} refusal;

/* The scene of each, with a lamp, is refused in exactly its words. */
static inline void check_refusals(const refusal *refusals, size_t n)
{
    char text[1000];
    for (size_t i = 0; i < n; ++i) {
        const refusal *r = &refusals[i];
        snprintf(text, sizeof text, HEAD "%s" LAMP, r->scene);
        CHECK_REFUSED(text, r->status, r->where, r->text);
    }
}

#endif
