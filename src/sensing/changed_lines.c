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

/* A corner of a box, enlarged by margin_m. */
static murk_vec3 corner_of(const murk_box *box, int corner, double margin_m)
{
    return murk_vec(corner & 1 ? box->max.x + margin_m : box->min.x - margin_m,
                    corner & 2 ? box->max.y + margin_m : box->min.y - margin_m,
                    corner & 4 ? box->max.z + margin_m : box->min.z - margin_m);
}

murk_change_cone murk_changes_cone(const murk_box_list *near, murk_vec3 sensor,
                                   double range_m, double margin_m)
{
    /* Rounding, of squares and of ranges, is far below this share. */
    static const double slack = 0.001;
    murk_change_cone cone = {.nearest_m = INFINITY};
    murk_box all = murk_box_empty();
    for (size_t i = 0; i < near->n; ++i) {
        all = murk_box_with(murk_box_with(all, near->box[i].min),
                            near->box[i].max);
    }
    const murk_vec3 to =
        murk_sub(murk_scale(0.5, murk_add(all.min, all.max)), sensor);
    if (near->are_all || near->n == 0 || !(murk_length(to) > 0)) {
        return cone;
    }
    /* A cone is convex, so one that has all corners has the boxes. */
    double cosine = 1;
    cone.axis = murk_unit(to);
    for (size_t i = 0; i < 8 * near->n; ++i) {
        const murk_vec3 offset = murk_sub(
            corner_of(&near->box[i / 8], (int)(i % 8), margin_m), sensor);
        const double along_m = murk_dot(offset, cone.axis);
        cone.nearest_m = fmin(cone.nearest_m, along_m);
        cosine = fmin(cosine, along_m / murk_length(offset));
    }
    cosine -= slack;
    cone.is_there = cone.nearest_m > 0 && cosine * cosine > 0.5 && cosine > 0;
    cone.cosine2 = cosine * cosine;
    cone.nearest_m *= 1 - slack;
    /* The ball through the sensor and the rim of the cone's part in range. */
    cone.radius_m = (1 + slack) * range_m / (2 * cosine);
    cone.middle = murk_along(sensor, cone.radius_m, cone.axis);
    return cone;
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
