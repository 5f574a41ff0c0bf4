/* The types of light sources that a scene names.
 *
 * All of src uses this one list: the scene reads the keys of each type
 * (scene/keys_lights.c), and src/source emits the photons (source/lamps.c and
 * source/distant.c, one row for each type). The scene replaces daylight by its
 * parts, suns and skies (base/daylight_parts.h). */
#ifndef MURK_BASE_SOURCE_TYPE_H
#define MURK_BASE_SOURCE_TYPE_H

typedef enum murk_source_group {
    MURK_SOURCE_LAMP,    /* emits within the domain */
    MURK_SOURCE_DISTANT, /* parallel light, its direction is given */
    MURK_SOURCE_BODY,    /* sun or moon: direction by place and time */
    MURK_SOURCE_DOME     /* the sky: light from the whole upper hemisphere */
} murk_source_group;

/* X(enumerator, name in scenes and results, group) */
#define MURK_SOURCE_TYPES(X)               \
    X(SPHERE, "sphere", LAMP)              \
    X(RECT, "rect", LAMP)                  \
    X(POINT, "point", LAMP)                \
    X(BEAM, "beam", LAMP)                  \
    X(DIRECTIONAL, "directional", DISTANT) \
    X(SUN, "sun", BODY)                    \
    X(MOON, "moon", BODY)                  \
    X(SKY, "sky", DOME)                    \
    X(NIGHT_SKY, "night_sky", DOME)        \
    X(LUMINAIRE, "luminaire", LAMP)        \
    X(DAYLIGHT, "daylight", DOME)

#define MURK_SOURCE_ENUMERATOR(id, name, group) MURK_SOURCE_##id,
typedef enum murk_source_type {
    MURK_SOURCE_TYPES(MURK_SOURCE_ENUMERATOR)
} murk_source_type;
#undef MURK_SOURCE_ENUMERATOR

const char *murk_source_type_name(murk_source_type type);
murk_source_group murk_source_type_group(murk_source_type type);

#endif
