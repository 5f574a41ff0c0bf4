#include "sensing/ways.h"

#include "path/segment.h"

/* Of its offset: what rises less over a mount's wall is part of it, as
 * skirtings and the steps between panels are. */
#define WALL_SHARE 0.5

murk_ways murk_ways_of(const murk_surfaces *surfaces, const murk_domain *domain)
{
    murk_ways ways = {.surfaces = surfaces,
                      .domain = domain,
                      .tolerance_m =
                          murk_path_surface_tolerance_m(surfaces, domain)};
    /* At right angles, so that no seam runs along both; tilted, so that no way
     * along an axis does. */
    murk_vec3 aside[3] = {{0.537, 0.781, 0.319}};
    aside[0] = murk_unit(aside[0]);
    murk_frame(aside[0], &aside[1], &aside[2]);
    ways.aside[0] = murk_scale(0.5 * ways.tolerance_m, aside[0]);
    ways.aside[1] = murk_scale(0.5 * ways.tolerance_m, aside[1]);
    return ways;
}

bool murk_way_is_open(const murk_ways *w, murk_vec3 from, murk_vec3 to)
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

/* Beyond the side by two hairs: a wall in the side's plane closes it. */
bool murk_way_leads_out(const murk_ways *w, murk_vec3 point)
{
    const murk_domain *domain = w->domain;
    const double beyond = 2 * w->tolerance_m;
    const double x[2] = {domain->box.min.x - beyond,
                         domain->box.max.x + beyond};
    const double y[2] = {domain->box.min.y - beyond,
                         domain->box.max.y + beyond};
    const double z[2] = {domain->box.min.z - beyond,
                         domain->box.max.z + beyond};
    for (int i = 0; i < 2; ++i) {
        if (murk_way_is_open(w, murk_vec(point.x, point.y, z[i]), point)) {
            return true;
        }
        if (domain->is_periodic) {
            continue;
        }
        if (murk_way_is_open(w, murk_vec(x[i], point.y, point.z), point) ||
            murk_way_is_open(w, murk_vec(point.x, y[i], point.z), point)) {
            return true;
        }
    }
    return false;
}

static bool is_near(const murk_ways *w, murk_vec3 point, double radius_m,
                    const murk_mount_site *foot)
{
    if (!foot) {
        return murk_surfaces_near(w->surfaces, point, radius_m);
    }
    const double offset_m =
        murk_dot(murk_sub(point, foot->position), foot->normal);
    return murk_surfaces_near_mount(w->surfaces, point, radius_m, foot,
                                    WALL_SHARE * offset_m);
}

murk_closeness murk_ways_closeness(const murk_ways *w, murk_vec3 point,
                                   double clearance_m,
                                   const murk_mount_site *foot)
{
    const double tolerance = w->tolerance_m;
    if (murk_surfaces_near(w->surfaces, point, tolerance)) {
        return MURK_ON_SURFACE;
    }
    /* A point that stands at the clearance itself is not dropped by rounding.
     */
    if (clearance_m > 2 * tolerance &&
        is_near(w, point, clearance_m - tolerance, foot)) {
        return MURK_TOO_CLOSE;
    }
    return murk_surfaces_near(w->surfaces, point, 2 * tolerance)
               ? MURK_BARELY_CLEAR
               : MURK_CLEAR_OF_SURFACES;
}
