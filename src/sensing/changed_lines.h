/* Sightlines that meet a changed place, in domains with images and across
 * interfaces. For use inside src/sensing only. */
#ifndef MURK_SENSING_CHANGED_LINES_H
#define MURK_SENSING_CHANGED_LINES_H

#include "base/box_list.h"
#include "sensing/refract.h"

/* The boxes that a sightline of the sensor within range can meet. The range is
 * enlarged, because a photon is found up to the range in single precision, and
 * its sightline begins off the surface. */
murk_box_list murk_changes_within_range(const murk_box_list *all,
                                        const murk_domain *domain,
                                        murk_vec3 sensor, double range_m);

/* A cone around a sensor, outside of which no straight sightline meets a
 * changed place, and a ball that has all of the cone within range. */
typedef struct murk_change_cone {
    bool is_there; /* false: a sightline in any direction may meet a place */
    murk_vec3 axis;
    double cosine2;   /* of the angle between the axis and the side, squared */
    double nearest_m; /* along the axis, to the first place */
    murk_vec3 middle;
    double radius_m; /* of the ball */
} murk_change_cone;

/* The cone around the boxes, which are enlarged by margin_m: the distance by
 * which a sightline may begin off its photon, and rounding. None is there if
 * the angle exceeds 45 degrees, where the ball is no smaller than the range,
 * and if any place may have changed. For sightlines without images. */
murk_change_cone murk_changes_cone(const murk_box_list *near, murk_vec3 sensor,
                                   double range_m, double margin_m);

/* True if a photon at this offset from the sensor lies in the cone. */
static inline bool murk_change_cone_has(const murk_change_cone *cone,
                                        murk_vec3 offset)
{
    const double along_m = murk_dot(offset, cone->axis);
    /* Without a branch: the outcome is hard to predict. */
    return (along_m >= cone->nearest_m) &
           (along_m * along_m >= cone->cosine2 * murk_dot(offset, offset));
}

/* True if the straight line between the sensor and the nearest image of a point
 * meets a box, in a periodic domain after the line is moved into the domain. */
bool murk_changes_meet_line(const murk_box_list *changed,
                            const murk_path_viewpoint *sensor, murk_vec3 point);

/* True if a refracted path between the sensor and a point may meet a box. By
 * Snell's law a path lies in the triangle between either end, its foot on the
 * plane of the face, and the foot of the other end; the box around the four
 * points is compared. Always true if a mesh has an index, whose faces may have
 * any plane, and in a periodic domain. */
bool murk_changes_may_meet_refracted(const murk_box_list *changed,
                                     const murk_interfaces *interfaces,
                                     const murk_path_viewpoint *sensor,
                                     murk_vec3 point);

#endif
