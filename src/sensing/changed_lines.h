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
