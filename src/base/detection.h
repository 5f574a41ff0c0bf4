/* The modes of detection: how clearly a sensor detects a photon, as a number
 * 0..1 called the clarity, and how the clarities of several sensors combine.
 *
 * All of src uses this one list. How the transmittance of a sightline becomes a
 * clarity is one row in sensing/sight_create.c; detection by power is
 * sensing/power.h. */
#ifndef MURK_BASE_DETECTION_H
#define MURK_BASE_DETECTION_H

#include <stdbool.h>
#include <stddef.h>

/* Properties of a mode, as bits. */
enum {
    /* the clarity of a visible photon is the transmittance of the sightline
     * itself, so it changes smoothly with the medium and a matrix file can hold
     * it */
    MURK_DETECTION_SMOOTH = 1,
    /* a clarity is the probability of detection, and detections by several
     * sensors are independent events */
    MURK_DETECTION_BY_CHANCE = 2,
    /* the clarity depends on the power of the traced light around the photon */
    MURK_DETECTION_BY_POWER = 4,
    /* the mode reads the scene key placement.threshold */
    MURK_DETECTION_HAS_THRESHOLD = 8
};

/* X(enumerator, name in scenes and results, properties) */
#define MURK_DETECTIONS(X)                                  \
    X(WEIGHTED, "weighted", MURK_DETECTION_SMOOTH)          \
    X(INDEPENDENT, "independent",                           \
      MURK_DETECTION_SMOOTH | MURK_DETECTION_BY_CHANCE)     \
    X(THRESHOLD, "threshold", MURK_DETECTION_HAS_THRESHOLD) \
    X(POWER, "power", MURK_DETECTION_BY_CHANCE | MURK_DETECTION_BY_POWER)

#define MURK_DETECTION_ENUMERATOR(id, name, is) MURK_DETECTION_##id,
typedef enum murk_detection {
    MURK_DETECTIONS(MURK_DETECTION_ENUMERATOR) MURK_DETECTIONS_COUNT
} murk_detection;
#undef MURK_DETECTION_ENUMERATOR

const char *murk_detection_name(murk_detection detection);

/* True if the mode has all of these properties. */
bool murk_detection_is(murk_detection detection, unsigned properties);

/* The names of the modes that have `property` (has = true) or lack it (has =
 * false), joined by `separator`, such as "weighted or threshold". */
typedef struct murk_detection_text {
    char text[80];
} murk_detection_text;
murk_detection_text murk_detection_list(unsigned property, bool has,
                                        const char *separator);

#endif
