/* The simple twin of the tallies: fluence rate in balls and boxes by track
 * length, from the tracer's events alone. A photon's chords are kept together,
 * so the errors are those of independent photons. One thread, open sides. */
#ifndef MURK_TESTS_CHORDS_H
#define MURK_TESTS_CHORDS_H

#include "base/stats.h"
#include "transport/trace.h"

#define CHORD_PLACES_MAX 32

typedef struct chord_place {
    bool is_box;
    murk_vec3 center;
    double radius_m;
    murk_box box;
} chord_place;

typedef struct chords {
    size_t n;
    chord_place place[CHORD_PLACES_MAX];
    uint64_t photons;              /* so far */
    double now[CHORD_PLACES_MAX];  /* of the current photon [m] */
    double sum[CHORD_PLACES_MAX];  /* of those before */
    double sum2[CHORD_PLACES_MAX]; /* squares */
    murk_vec3 from, direction;     /* of the current segment */
    double weight;
} chords;

chord_place chord_ball(murk_vec3 center, double radius_m);
chord_place chord_box(murk_vec3 min, murk_vec3 max);

/* The event sink; context is the chords. */
void chords_note(void *context, uint64_t batch, const murk_event *event);

/* Mean fluence rate in the place per watt emitted [1/m2]. */
murk_estimate chords_fluence(const chords *c, size_t place);

#endif
