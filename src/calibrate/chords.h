/* Which receivers a leg crosses, and where. Private to this room. */
#ifndef MURK_CALIBRATE_CHORDS_H
#define MURK_CALIBRATE_CHORDS_H

#include "calibrate/followed.h"

typedef struct murk_chord {
    uint32_t receiver;
    double from_m, to_m; /* along the leg, from < to */
} murk_chord;

typedef struct murk_chords murk_chords;

/* Borrows receiver[n]. *out is the caller's: murk_chords_destroy(). */
murk_status murk_chords_create(murk_chords **out, const murk_receiver *receiver,
                               size_t n, murk_error *err);
void murk_chords_destroy(murk_chords *chords); /* NULL is fine */

/* Fills chord[receivers], in an order that is the receivers' own; returns how
 * many. */
size_t murk_chords_of(const murk_chords *chords, murk_vec3 from,
                      murk_vec3 direction, double length_m, murk_chord *chord);

#endif
