/* Kinds that a scene names: methods of placement (placement/place.h), views of
 * sensors (sensing/sensor.h), types of tallies (transport/tallies.h). For each
 * of the three all of src uses one list. */
#ifndef MURK_BASE_KINDS_H
#define MURK_BASE_KINDS_H

/* X(enumerator, name in scenes and results) */
#define MURK_PLACE_METHODS(X) \
    X(BEST, "best")           \
    X(SPOQ, "spoq")           \
    X(GREEDY, "greedy")       \
    X(EXACT, "exact")

#define MURK_VIEW_SHAPES(X)                                            \
    X(SPHERE, "sphere") /* all round: heading and tilt mean nothing */ \
    X(CONE, "cone")                                                    \
    X(FRUSTUM, "frustum") /* a rectangle in the pinhole's projection */

#define MURK_TALLY_TYPES(X) \
    X(PLANE, "plane")       \
    X(GRID, "grid")         \
    X(SPHERE, "sphere")

#define MURK_PLACE_ENUMERATOR(id, name) MURK_PLACE_##id,
#define MURK_VIEW_ENUMERATOR(id, name)  MURK_VIEW_##id,
#define MURK_TALLY_ENUMERATOR(id, name) MURK_TALLY_##id,
typedef enum murk_place_method {
    MURK_PLACE_METHODS(MURK_PLACE_ENUMERATOR)
} murk_place_method;
typedef enum murk_view { MURK_VIEW_SHAPES(MURK_VIEW_ENUMERATOR) } murk_view;
typedef enum murk_tally_type {
    MURK_TALLY_TYPES(MURK_TALLY_ENUMERATOR)
} murk_tally_type;
#undef MURK_PLACE_ENUMERATOR
#undef MURK_VIEW_ENUMERATOR
#undef MURK_TALLY_ENUMERATOR

const char *murk_place_method_name(murk_place_method method);
const char *murk_view_name(murk_view view);
const char *murk_tally_type_name(murk_tally_type type);

#endif
