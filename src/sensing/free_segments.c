/* Tests of straight segments and of points against surfaces. Each segment is
 * tested by three rays, because a ray along the seam of a mesh may slip
 * through. */
#include "sensing/free_segments.h"

#include "path/segment.h"

/* Share of the offset of a mount: surfaces that rise less than this share of
 * the offset over the wall are part of the wall, such as skirtings and steps
 * between panels (a choice). */
#define WALL_SHARE 0.5

murk_free_segments murk_free_segments_of(const murk_surfaces *surfaces,
                                         const murk_domain *domain)
{
    murk_free_segments segments = {
        .surfaces = surfaces,
        .domain = domain,
        .tolerance_m = murk_path_surface_tolerance_m(surfaces, domain)};
    /* The offsets are at right angles to each other, so that no seam is
     * parallel to both, and tilted, so that no axis is parallel to either. */
    murk_vec3 aside[3] = {{0.537, 0.781, 0.319}};
    aside[0] = murk_unit(aside[0]);
    murk_frame(aside[0], &aside[1], &aside[2]);
    segments.aside[0] = murk_scale(0.5 * segments.tolerance_m, aside[0]);
    segments.aside[1] = murk_scale(0.5 * segments.tolerance_m, aside[1]);
    return segments;
}

bool murk_free_segment_is_open(const murk_free_segments *w, murk_vec3 from,
                               murk_vec3 to)
{
    if (murk_path_blocked(w->surfaces, w->domain, from, to, !w->by_sheets)) {
        return false;
    }
    for (int i = 0; i < 2; ++i) {
        if (murk_path_blocked(w->surfaces, w->domain, from,
                              murk_add(to, w->aside[i]), !w->by_sheets)) {
            return false;
        }
    }
    return true;
}

/* The segments end two tolerances beyond the side, so that a wall in the plane
 * of the side closes it. */
bool murk_free_segment_leads_out(const murk_free_segments *w, murk_vec3 point)
{
    const murk_box *box = &w->domain->box;
    const double beyond = 2 * w->tolerance_m;
    for (int side = w->domain->is_periodic ? 4 : 0; side < 6; ++side) {
        const int axis = side / 2;
        murk_vec3 outside = point;
        murk_component_set(&outside, axis,
                           side % 2 ? murk_component(box->max, axis) + beyond
                                    : murk_component(box->min, axis) - beyond);
        if (murk_free_segment_is_open(w, outside, point)) {
            return true;
        }
    }
    return false;
}

/* True if a surface lies within the radius; the surface that carries the mount
 * `foot` does not count. foot NULL: every surface counts. */
static bool is_near(const murk_free_segments *w, murk_vec3 point,
                    double radius_m, const murk_mount_site *foot)
{
    if (!foot) {
        return murk_surfaces_near(w->surfaces, point, radius_m);
    }
    const double offset_m =
        murk_dot(murk_sub(point, foot->position), foot->normal);
    return murk_surfaces_near_mount(w->surfaces, point, radius_m, foot,
                                    WALL_SHARE * offset_m);
}

murk_closeness murk_free_segments_closeness(const murk_free_segments *w,
                                            murk_vec3 point, double clearance_m,
                                            const murk_mount_site *foot)
{
    const double tolerance = w->tolerance_m;
    if (murk_surfaces_near(w->surfaces, point, tolerance)) {
        return MURK_ON_SURFACE;
    }
    /* The radius is one tolerance less than the clearance, so that rounding
     * does not drop a point exactly at the clearance. */
    if (clearance_m > 2 * tolerance &&
        is_near(w, point, clearance_m - tolerance, foot)) {
        return MURK_TOO_CLOSE;
    }
    return murk_surfaces_near(w->surfaces, point, 2 * tolerance)
               ? MURK_BARELY_CLEAR
               : MURK_CLEAR_OF_SURFACES;
}
