/* Finds the spherical receivers that a path segment crosses, and the chord in
 * each. Internal to this room. */
#ifndef MURK_CALIBRATE_CHORDS_H
#define MURK_CALIBRATE_CHORDS_H

#include "calibrate/followed.h"

typedef struct murk_chord {
    uint32_t receiver;
    double from_m, to_m; /* distances along the segment, from_m < to_m */
} murk_chord;

typedef struct murk_chords murk_chords;

/* Borrows receiver[n]. The caller owns *out (murk_chords_destroy()). */
murk_status murk_chords_create(murk_chords **out, const murk_receiver *receiver,
                               size_t n, murk_error *err);
void murk_chords_destroy(murk_chords *chords); /* NULL is fine */

/* Fills chord[], which must have room for one chord of each receiver, and
 * returns the number of chords. The order depends on the receivers alone, not
 * on the segment. */
size_t murk_chords_of(const murk_chords *chords, murk_vec3 from,
                      murk_vec3 direction, double length_m, murk_chord *chord);

#endif
