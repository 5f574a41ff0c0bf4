#include "calibrate/chords.h"

#include <assert.h>
#include <stdlib.h>

struct murk_chords {
    const murk_receiver *receiver;
    size_t n;
};

murk_status murk_chords_create(murk_chords **out, const murk_receiver *receiver,
                               size_t n, murk_error *err)
{
    murk_chords *chords = calloc(1, sizeof *chords);
    if (!chords) {
        return murk_fail(err, MURK_NO_MEMORY, "receivers",
                         "no memory for %zu receivers", n);
    }
    for (size_t i = 0; i < n; ++i) {
        assert(receiver[i].radius_m > 0 && murk_is_finite(receiver[i].center));
    }
    chords->receiver = receiver;
    chords->n = n;
    *out = chords;
    return MURK_OK;
}

void murk_chords_destroy(murk_chords *chords)
{
    free(chords);
}

/* The length of the chord is taken from the line's nearest point to the
 * centre, which keeps its digits for a small sphere far away. */
static inline bool cross(const murk_receiver *receiver, murk_vec3 from,
                         murk_vec3 direction, double length_m,
                         murk_chord *chord)
{
    const murk_vec3 to_center = murk_sub(receiver->center, from);
    const double along = murk_dot(to_center, direction);
    const murk_vec3 off = murk_along(to_center, -along, direction);
    const double left =
        receiver->radius_m * receiver->radius_m - murk_dot(off, off);
    if (!(left > 0)) {
        return false;
    }
    const double half = sqrt(left);
    chord->from_m = along - half > 0 ? along - half : 0;
    chord->to_m = along + half < length_m ? along + half : length_m;
    return chord->to_m > chord->from_m;
}

size_t murk_chords_of(const murk_chords *chords, murk_vec3 from,
                      murk_vec3 direction, double length_m, murk_chord *chord)
{
    size_t n = 0;
    for (size_t i = 0; i < chords->n; ++i) {
        if (cross(&chords->receiver[i], from, direction, length_m, &chord[n])) {
            chord[n++].receiver = (uint32_t)i;
        }
    }
    return n;
}
