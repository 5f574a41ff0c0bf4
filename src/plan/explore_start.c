/* The place where exploration begins: usable sites are tested in the order of
 * their distance from the point start_m of the scene until an open straight
 * segment joins one of them to start_m; without start_m exploration begins at
 * the first fixed sensor. */
#include "base/interrupt.h"
#include "base/position.h"
#include "base/sort.h"
#include "plan/explore.h"
#include "sensing/outlook.h"

#include <stdlib.h>

typedef struct far_place {
    double distance_m;
    uint32_t place;
} far_place;

/* Rising distance; ties go to the lower number. */
static int by_distance(const void *a, const void *b)
{
    const far_place *x = a, *y = b;
    const int order = MURK_ORDER(x->distance_m, y->distance_m);
    return order ? order : MURK_ORDER(x->place, y->place);
}

/* Finds the nearest usable site that an open straight segment joins to `from`;
 * false if there is none, or if the run is interrupted. order[sites->usable] is
 * a workspace. */
static bool find_nearest(uint32_t *start, murk_outlook *outlook,
                         const murk_candidates *sites, far_place *order,
                         murk_vec3 from)
{
    for (size_t k = 0; k < sites->usable; ++k) {
        order[k] = (far_place){murk_length(murk_sub(sites->position[k], from)),
                               (uint32_t)k};
    }
    qsort(order, sites->usable, sizeof *order, by_distance);
    for (size_t k = 0; k < sites->usable && !murk_interrupted(); ++k) {
        if (murk_outlook_is_open(outlook, from,
                                 sites->position[order[k].place])) {
            *start = order[k].place;
            return true;
        }
    }
    return false;
}

murk_status murk_explore_start(uint32_t *start, const murk_stage *stage,
                               const murk_candidates *sites,
                               const murk_poses *poses, murk_error *err)
{
    const murk_scene_placement *settings = &stage->scene->placement;
    const murk_domain *domain = &stage->world.domain;
    const murk_vec3 x = settings->start;
    /* Without start_m, begin at the first fixed sensor, which must exist. */
    if (!settings->has_start && poses->fixed == 0) {
        return murk_fail(err, MURK_BAD_VALUE, settings->where,
                         "start_m: not given, but knowledge is explore, which "
                         "begins at start_m, [x, y, z] in m, or at a fixed "
                         "sensor");
    }
    if (!settings->has_start) {
        *start = poses->site[poses->count - poses->fixed];
        return MURK_OK;
    }
    /* start_m must lie in the domain. */
    if (!murk_box_contains(&domain->box, x)) {
        return murk_fail(err, MURK_BAD_VALUE, settings->where,
                         "start_m: %s m lies outside the domain, %s to %s m",
                         murk_position_show(x).text,
                         murk_position_show(domain->box.min).text,
                         murk_position_show(domain->box.max).text);
    }
    /* Search. */
    far_place *order = calloc(sites->usable + 1, sizeof *order);
    if (!order) {
        return murk_no_memory(err, settings->where, "for %zu candidates",
                              sites->usable);
    }
    const murk_sight_desc seen = {.surfaces = stage->surfaces,
                                  .domain = *domain};
    murk_outlook outlook;
    murk_outlook_init(&outlook, &seen, stage->scene->bands);
    const bool is_found = find_nearest(start, &outlook, sites, order, x);
    free(order);
    const murk_status status = murk_interrupt_check(err);
    return status || is_found
               ? status
               : murk_fail(err, MURK_BAD_VALUE, settings->where,
                           "start_m: no straight open way leads from %s m "
                           "to any of the %zu usable candidates: inside "
                           "of something, or out of their sight",
                           murk_position_show(x).text, sites->usable);
}
