/* The candidates of placement, which are poses: every sensor type at every
 * site, for each heading and tilt of the type, and the fixed sensors. Also the
 * constraints that a plan satisfies. */
#ifndef MURK_PLAN_POSES_H
#define MURK_PLAN_POSES_H

#include "placement/constraints.h"
#include "scene/scene.h"
#include "sensing/sensor.h"

/* Costs are integer multiples of this unit, so that sums of costs are exact. */
#define MURK_COST_UNIT 1e-6

typedef struct murk_poses {
    murk_pose *pose; /* [count]; ordered by site, then type, heading, tilt;
                      * then sensors that have drifted; fixed sensors last */
    size_t count, fixed;
    murk_constraints constraints; /* 0 for constraints that the scene does not
                                   * have */
    bool has_constraints;
    /* Arrays that the constraints point to: class_of, site, cost and position_m
     * [count], min and max [types], fixed_number [fixed]. site is the number of
     * the site of each pose. The numbers of fixed sensors follow those of the
     * usable sites, except that with one_per_site a fixed sensor at the
     * position of a site, or of an earlier fixed sensor, has the number of that
     * site or sensor. */
    uint32_t *class_of, *site;
    size_t *min, *max, *fixed_number;
    int64_t *cost;
    double (*position_m)[3];
    const char **class_name; /* [types]; names of the scene */
    bool limits_moves; /* the constraints have a rule on moves from `start` */
    uint32_t *start;   /* [starts] candidates at which the search begins; NULL
                        * until murk_start_plan_match() (plan/start_plan.h), and
                        * if the scene has no start_plan */
    size_t starts;
} murk_poses;

/* Creates the poses at the usable sites, site[n]. The caller owns *out; the
 * scene must outlive *out. Fails with MURK_BAD_VALUE if there are more than 1e7
 * poses, if a fixed sensor lies outside the domain, if the count exceeds the
 * number of poses, or if constraints contradict each other; or with
 * MURK_NO_MEMORY. The message for a fixed sensor outside the domain names the
 * place of that sensor in the scene, other messages of MURK_BAD_VALUE that of
 * the key sensors. */
murk_status murk_poses_create(murk_poses **out, const murk_scene_desc *scene,
                              const murk_domain *domain, const murk_vec3 *site,
                              size_t n, murk_error *err);
/* The same with further poses drifted[n_drifted], each with a site of its own:
 * sensors that stand where no candidate is, and may stay there. */
murk_status murk_poses_create_with(murk_poses **out,
                                   const murk_scene_desc *scene,
                                   const murk_domain *domain,
                                   const murk_vec3 *site, size_t n,
                                   const murk_pose *drifted, size_t n_drifted,
                                   murk_error *err);
void murk_poses_destroy(murk_poses *poses); /* NULL is fine */

/* Fails with MURK_BAD_VALUE if a fixed sensor lies outside the domain. */
murk_status murk_poses_check_fixed(const murk_scene_sensors *sensors,
                                   const murk_domain *domain, murk_error *err);

/* Compares two murk_vec3 by x, then y, then z, for qsort() and bsearch(). */
int murk_by_position(const void *a, const void *b);

/* Adds the scene's rule on moves from the start plan, if it has both. */
void murk_poses_limit_moves(murk_poses *poses,
                            const murk_scene_placement *placement);

/* The constraints of the poses without the rule on moves, for which `copy` is
 * used; NULL as the next function. */
const murk_constraints *murk_poses_constraints_of_any(const murk_poses *poses,
                                                      murk_constraints *copy);

/* The constraints of the poses; NULL if the scene has none besides the count
 * and the target. */
const murk_constraints *murk_poses_constraints(const murk_poses *poses);

/* Converts the sensor types of the scene to the struct of sensing/sensor.h. The
 * array has scene->sensors.types elements; the caller frees it with free().
 * NULL when out of memory. */
murk_sensor_type *murk_poses_types(const murk_scene_desc *scene);

#endif
