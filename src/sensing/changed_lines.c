/* Compares sightlines with boxes: straight lines piece by piece, as the walk
 * through a periodic domain has them, and refracted paths by the box around
 * all paths through a plane. */
#include "sensing/changed_lines.h"

/* Rounding to single precision and the step off a surface are far below this
 * share of a range. */
#define RANGE_TIMES 1.001

murk_box_list murk_changes_within_range(const murk_box_list *all,
                                        const murk_domain *domain,
                                        murk_vec3 sensor, double range_m)
{
    murk_box_list near = {.are_all = all->are_all};
    for (size_t i = 0; i < all->n; ++i) {
        double distance_m = INFINITY;
        for (int k = 0; k < murk_domain_images(domain); ++k) {
            const murk_vec3 image = murk_domain_image(domain, sensor, k);
            distance_m =
                fmin(distance_m, murk_box_distance(&all->box[i], image));
        }
        if (distance_m <= RANGE_TIMES * range_m) {
            near.box[near.n++] = all->box[i];
        }
    }
    return near;
}

/* True if the line between two points meets a box. Lines are cut as for the
 * test of surfaces, whose pieces reach over the sides of the domain. */
static bool meets(const murk_box_list *changed, const murk_path_space *space,
                  murk_vec3 from, murk_vec3 to)
{
    murk_path_segment segment[MURK_PATH_SEGMENTS_MAX];
    const int n = murk_path_cut(
        space->domain, from, to,
        murk_path_surface_tolerance_m(space->surfaces, space->domain), segment);
    bool does_meet = false;
    for (int i = 0; i < n && !does_meet; ++i) {
        does_meet = murk_box_list_meet(
            changed, segment[i].from, murk_sub(segment[i].to, segment[i].from));
    }
    return does_meet;
}

bool murk_changes_meet_line(const murk_box_list *changed,
                            const murk_path_viewpoint *v, murk_vec3 point)
{
    const murk_path_space *space = v->space;
    const murk_domain *domain = space->domain;
    if (!domain->is_periodic) {
        return murk_box_list_meet(changed, point, murk_sub(v->position, point));
    }
    /* The line is followed from the point on, and with meshes from the sensor
     * on, too. The two lines are different images of each other, or, half a
     * period apart, lines to different sides. */
    return meets(changed, space, point,
                 murk_path_nearest_image(domain, v->position, point)) ||
           (space->boundary_meshes &&
            meets(changed, space, v->position,
                  murk_path_nearest_image(domain, point, v->position)));
}

static bool overlaps_one(const murk_box_list *changed, const murk_box *box)
{
    bool does_overlap = changed->are_all;
    for (size_t i = 0; i < changed->n && !does_overlap; ++i) {
        does_overlap = murk_box_overlaps(&changed->box[i], box);
    }
    return does_overlap;
}

bool murk_changes_may_meet_refracted(const murk_box_list *changed,
                                     const murk_interfaces *interfaces,
                                     const murk_path_viewpoint *v,
                                     murk_vec3 point)
{
    const murk_path_space *space = v->space;
    if (interfaces->any_mesh || space->domain->is_periodic) {
        return true;
    }
    /* Surfaces are looked for a little beyond the crossing, too. */
    const double more_m =
        murk_path_surface_tolerance_m(space->surfaces, space->domain);
    const murk_vec3 more = {more_m, more_m, more_m};
    bool may_meet = false;
    for (size_t i = 0; i < interfaces->n && !may_meet; ++i) {
        const murk_flat *flat = &interfaces->flat[i];
        const double up = murk_dot(murk_sub(v->position, flat->point),
                                   flat->normal),
                     down =
                         murk_dot(murk_sub(flat->point, point), flat->normal);
        if (!(up * down > 0)) {
            continue; /* both ends lie on one side */
        }
        murk_box around = murk_box_with(murk_box_empty(), v->position);
        around = murk_box_with(around, point);
        around =
            murk_box_with(around, murk_along(v->position, -up, flat->normal));
        around = murk_box_with(around, murk_along(point, down, flat->normal));
        around =
            (murk_box){murk_sub(around.min, more), murk_add(around.max, more)};
        may_meet = overlaps_one(changed, &around);
    }
    return may_meet;
}
