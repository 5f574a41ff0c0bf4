/* The shapes of regions (of media, of interest, of targets, of sensor sites),
 * and the shapes of surfaces. All of src uses these two lists. */
#ifndef MURK_BASE_SHAPE_H
#define MURK_BASE_SHAPE_H

/* X(enumerator, name for messages, key of a scene that states the shape; NULL:
 * the shape is what a region has without such a key) */
#define MURK_REGION_SHAPES(X)                                                 \
    X(EVERYWHERE, "everywhere", NULL)                                         \
    X(BOX, "box", "box")                                                      \
    X(SPHERE, "sphere", "sphere")                                             \
    X(MESH, "mesh", "mesh")             /* a closed mesh */                   \
    X(GRID, "grid", NULL)               /* the extent of the medium's grid */ \
    X(BELOW, "half space", "below_z_m") /* z less than below_z_m */

#define MURK_REGION_ENUMERATOR(id, name, key) MURK_REGION_##id,
typedef enum murk_region_shape {
    MURK_REGION_SHAPES(MURK_REGION_ENUMERATOR)
} murk_region_shape;
#undef MURK_REGION_ENUMERATOR

/* X(enumerator, key of a scene that states the shape) */
#define MURK_SURFACE_SHAPES(X) \
    X(MESH, "file")            \
    X(BOX, "box")              \
    X(RECT, "rect")            \
    X(SPHERE, "sphere")

#define MURK_SHAPE_ENUMERATOR(id, key) MURK_SHAPE_##id,
typedef enum murk_shape {
    MURK_SURFACE_SHAPES(MURK_SHAPE_ENUMERATOR)
} murk_shape;
#undef MURK_SHAPE_ENUMERATOR

#endif
