/* Keys of the box and of the sphere of a solid (murk_scene_solid), checks of
 * boxes and of edges, the words for the up axis of a mesh, and the names of
 * shapes. The regions of media, the regions of interest, the volume of
 * targets, the zones of candidate sites and the geometry share them. */
#include "scene/keys_rows.h"

#include <float.h>

murk_status murk_check_box(murk_key_reader *walk, const murk_yaml *map,
                           void *box)
{
    const murk_vec3 min = ((murk_box *)box)->min, max = ((murk_box *)box)->max;
    return min.x < max.x && min.y < max.y && min.z < max.z
               ? MURK_OK
               : murk_walk_fail(
                     walk, map,
                     "min_m [%.9g, %.9g, %.9g] and max_m [%.9g, %.9g, %.9g], "
                     "min must be less than max on each axis, m",
                     min.x, min.y, min.z, max.x, max.y, max.z);
}

murk_status murk_check_edges(murk_key_reader *walk, const murk_yaml *map,
                             murk_vec3 edge1, murk_vec3 edge2)
{
    const double area = murk_length(murk_cross(edge1, edge2));
    /* The cross product has three differences of products: parallel edges
     * leave no more than this by rounding. */
    const double slack =
        4 * DBL_EPSILON * murk_length(edge1) * murk_length(edge2);
    return area > slack ? MURK_OK
                        : murk_walk_fail(walk, map,
                                         "edge1_m and edge2_m span no area, "
                                         "must not be zero or parallel");
}

murk_status murk_check_within(murk_key_reader *walk, const murk_yaml *map,
                              const double box[4])
{
    return box[0] < box[2] && box[1] < box[3]
               ? MURK_OK
               : murk_walk_fail(walk, murk_yaml_get(map, "within_m"),
                                "within_m is [%.9g, %.9g, %.9g, %.9g], must be "
                                "[x0, y0, x1, y1] with x0 < x1 and y0 < y1",
                                box[0], box[1], box[2], box[3]);
}

static const murk_key BOX_ROWS[] = {
    ROW("min_m", VECTOR, NEEDED, LONG_M, AT(murk_box, min)),
    ROW("max_m", VECTOR, NEEDED, LONG_M, AT(murk_box, max)),
    END,
};

const murk_keys murk_box_keys = {
    .noun = "box", .check = murk_check_box, .key = BOX_ROWS};

static const murk_key SPHERE_ROWS[] = {
    ROW("center_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_solid, center)),
    ROW("radius_m", NUMBER, NEEDED, SIZE_M, AT(murk_scene_solid, radius_m)),
    END,
};

const murk_keys murk_sphere_keys = {.noun = "sphere", .key = SPHERE_ROWS};

const murk_word murk_up_words[] = {
    {"x", 'x'}, {"y", 'y'}, {"z", 'z'}, WORDS_END};

const char *const murk_zone_variants[] = {"without a shape", "box", "sphere",
                                          "mesh", NULL};
