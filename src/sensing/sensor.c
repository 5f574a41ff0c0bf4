/* Frames and fields of view of poses. The frame consists of horizontal and
 * tilted unit vectors (heading clockwise from north); the field of view is
 * tested by dot products only, without angles. */
#include "sensing/sensor.h"

#include <math.h>

murk_sensor_frame murk_pose_frame(const murk_pose *pose, murk_vec3 north)
{
    const murk_vec3 up = {0, 0, 1}, east = murk_cross(north, up);
    const double sin_h = sin(pose->heading_rad), cos_h = cos(pose->heading_rad);
    const murk_vec3 level =
        murk_add(murk_scale(sin_h, east), murk_scale(cos_h, north));
    murk_sensor_frame frame = {
        .axis = murk_add(murk_scale(cos(pose->tilt_rad), level),
                         murk_scale(sin(pose->tilt_rad), up)),
        .right = murk_sub(murk_scale(cos_h, east), murk_scale(sin_h, north))};
    frame.up = murk_cross(frame.right, frame.axis);
    return frame;
}

murk_field murk_field_of(const murk_sensor_type *type, const murk_pose *pose,
                         murk_vec3 north)
{
    return (murk_field){.view = type->view,
                        .frame = murk_pose_frame(pose, north),
                        .cosine = cos(type->cone_rad / 2),
                        .h_slope = tan(type->hfov_rad / 2),
                        .v_slope = tan(type->vfov_rad / 2),
                        .least2_m2 = type->least_range_m * type->least_range_m,
                        .toward = type->toward};
}

bool murk_field_contains(const murk_field *field, murk_vec3 offset)
{
    const double distance2 = murk_dot(offset, offset);
    if (!(distance2 >= field->least2_m2)) {
        return false;
    }
    const double ahead = murk_dot(offset, field->frame.axis);
    switch (field->view) {
    case MURK_VIEW_CONE:
        return ahead >= field->cosine * sqrt(distance2);
    case MURK_VIEW_FRUSTUM:
        return ahead > 0 &&
               fabs(murk_dot(offset, field->frame.right)) <=
                   field->h_slope * ahead &&
               fabs(murk_dot(offset, field->frame.up)) <=
                   field->v_slope * ahead;
    case MURK_VIEW_SPHERE:
        break;
    }
    return true;
}

bool murk_field_takes(const murk_field *field, murk_vec3 offset,
                      murk_vec3 travel)
{
    const murk_vec3 against =
        field->view == MURK_VIEW_SPHERE ? offset : field->frame.axis;
    return !field->toward || murk_dot(travel, against) < 0;
}
