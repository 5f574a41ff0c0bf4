/* Candidates as placement counts them: every type at every site, for each of
 * its headings and tilts; and the rules that a plan of them keeps. */
#ifndef MURK_PLAN_POSES_H
#define MURK_PLAN_POSES_H

#include "placement/constraints.h"
#include "scene/scene.h"
#include "sensing/sensor.h"

/* Costs are whole numbers of this. */
#define MURK_COST_UNIT 1e-6

typedef struct murk_poses {
    murk_pose *pose; /* [count]: site by site, then type, heading, tilt; the
                        fixed ones last */
    size_t count, fixed;
    murk_constraints
        constraints; /* what is no rule of the scene's is 0 there */
    bool has_constraints;
    /* What the rules point to. */
    uint32_t *class_of, *site;
    size_t *min, *max, *fixed_number;
    int64_t *cost;
    double (*position_m)[3];
    const char **class_name; /* [types], the scene's */
} murk_poses;

/* Sites as they are usable, [n]; *out is the caller's. Fails at the scene's own
 * places: more than 1e7 poses, a fixed sensor outside the domain, a count that
 * the candidates cannot meet, rules that contradict each other. The scene must
 * outlive them. */
murk_status murk_poses_create(murk_poses **out, const murk_scene_desc *scene,
                              const murk_domain *domain, const murk_vec3 *site,
                              size_t n, murk_error *err);
void murk_poses_destroy(murk_poses *poses); /* NULL is fine */

/* NULL where only the count binds. */
const murk_constraints *murk_poses_constraints(const murk_poses *poses);

/* The scene's types as sensing knows them, [scene->sensors.types], for free();
 * NULL when out of memory. */
murk_sensor_type *murk_poses_types(const murk_scene_desc *scene);

#endif
