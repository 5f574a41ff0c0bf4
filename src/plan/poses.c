/* Expands sites, sensor types, headings and tilts into numbered candidates,
 * appends the fixed sensors, and converts the rules of the scene (counts of
 * types, budget, one sensor per site, spacing) into constraints of placement.
 */
#include "plan/poses.h"

#include "base/position.h"
#include "base/sort.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Limit on the number of candidates: their arrays take some 0.9 GB. */
#define POSES_MAX 1e7

#define RAD_PER_DEG (MURK_PI / 180) /* radians in a degree */

/* max_count of a type without a limit, as src/scene sets it. */
#define ANY_COUNT 1000000

/* ---- types ---- */

murk_sensor_type *murk_poses_types(const murk_scene_desc *scene)
{
    const murk_scene_sensors *settings = &scene->sensors;
    murk_sensor_type *out = calloc(settings->types + 1, sizeof *out);
    for (size_t k = 0; out && k < settings->types; ++k) {
        const murk_scene_sensor_type *type = &settings->type[k];
        out[k] =
            (murk_sensor_type){.least_range_m = type->least_range_m,
                               .range_m = type->range_m,
                               .view = type->view,
                               .cone_rad = type->cone_rad,
                               .hfov_rad = type->hfov_rad,
                               .vfov_rad = type->vfov_rad,
                               .acceptance_rad = type->acceptance_rad,
                               .aperture_m2 = type->aperture_m2,
                               .quantum_efficiency = type->quantum_efficiency,
                               .exposure_s = type->exposure_s,
                               .target_m2 = type->target_m2,
                               .target_m3 = type->target_m3,
                               .toward = type->toward,
                               .bands = type->bands};
    }
    return out;
}

/* ---- poses ---- */

/* Number of headings of a type: listed, or evenly spaced; 1 for a type that
 * looks everywhere. */
static size_t headings_of(const murk_scene_sensor_type *type)
{
    return type->view == MURK_VIEW_SPHERE ? 1
           : type->headings_deg.n         ? type->headings_deg.n
                                          : (size_t)type->headings;
}

static size_t tilts_of(const murk_scene_sensor_type *type)
{
    return type->view == MURK_VIEW_SPHERE ? 1 : type->tilts_deg.n;
}

static murk_pose pose_of(const murk_scene_sensor_type *type, size_t number,
                         murk_vec3 site, size_t heading, size_t tilt)
{
    murk_pose pose = {.type = (uint32_t)number, .position = site};
    if (type->view != MURK_VIEW_SPHERE) {
        const double heading_deg =
            type->headings_deg.n
                ? type->headings_deg.value[heading]
                : 360.0 * (double)heading / (double)type->headings;
        pose.heading_rad = heading_deg * RAD_PER_DEG;
        pose.tilt_rad = type->tilts_deg.value[tilt] * RAD_PER_DEG;
    }
    return pose;
}

/* Writes the poses of all types at one site, from index `at` on; returns their
 * number. */
static size_t fill_site(murk_poses *p, const murk_scene_sensors *settings,
                        murk_vec3 site, uint32_t number, size_t at)
{
    const size_t first = at;
    for (size_t k = 0; k < settings->types; ++k) {
        const murk_scene_sensor_type *type = &settings->type[k];
        for (size_t h = 0; h < headings_of(type); ++h) {
            for (size_t t = 0; t < tilts_of(type); ++t) {
                p->site[at] = number;
                p->pose[at++] = pose_of(type, k, site, h, t);
            }
        }
    }
    return at - first;
}

typedef struct place {
    murk_vec3 at;
    size_t pose;
} place;

int murk_by_position(const void *a, const void *b)
{
    const murk_vec3 *p = a, *q = b;
    const int x = MURK_ORDER(p->x, q->x), y = MURK_ORDER(p->y, q->y);
    return x ? x : y ? y : MURK_ORDER(p->z, q->z);
}

/* Order by position, then by number. */
static int by_place(const void *a, const void *b)
{
    const place *x = a, *y = b;
    const int order = murk_by_position(&x->at, &y->at);
    return order ? order : MURK_ORDER(x->pose, y->pose);
}

/* A fixed sensor (pose `first` or later) at the position of a site, or of an
 * earlier fixed sensor, gets the number of that site or sensor, so that
 * one_per_site applies to both. */
static murk_status join_sites(murk_poses *p, size_t first, murk_error *err)
{
    place *order = malloc((p->count + 1) * sizeof *order);
    if (!order) {
        return murk_no_memory(err, "", "for the candidates");
    }
    for (size_t j = 0; j < p->count; ++j) {
        order[j] = (place){p->pose[j].position, j};
    }
    /* Equal positions are neighbours after sorting. */
    qsort(order, p->count, sizeof *order, by_place);
    for (size_t k = 1; k < p->count; ++k) {
        const murk_vec3 a = order[k - 1].at, b = order[k].at;
        if (order[k].pose >= first && a.x == b.x && a.y == b.y && a.z == b.z) {
            p->site[order[k].pose] = p->site[order[k - 1].pose];
        }
    }
    free(order);
    return MURK_OK;
}

murk_status murk_poses_check_fixed(const murk_scene_sensors *sensors,
                                   const murk_domain *domain, murk_error *err)
{
    for (size_t k = 0; k < sensors->n_fixed; ++k) {
        const murk_scene_fixed_sensor *fixed = &sensors->fixed[k];
        if (!murk_box_contains(&domain->box, fixed->position)) {
            return murk_fail(err, MURK_BAD_VALUE, fixed->where,
                             "position_m: %s m lies outside the domain, %s to "
                             "%s m",
                             murk_position_show(fixed->position).text,
                             murk_position_show(domain->box.min).text,
                             murk_position_show(domain->box.max).text);
        }
    }
    return MURK_OK;
}

/* Appends the fixed sensors, each with a site of its own. */
static murk_status place_fixed(murk_poses *p,
                               const murk_scene_sensors *settings,
                               const murk_domain *domain, uint32_t sites,
                               murk_error *err)
{
    const size_t first = p->count - p->fixed;
    const murk_status status = murk_poses_check_fixed(settings, domain, err);
    if (status) {
        return status;
    }
    for (size_t k = 0; k < p->fixed; ++k) {
        const murk_scene_fixed_sensor *fixed = &settings->fixed[k];
        p->fixed_number[k] = first + k;
        p->pose[first + k] = (murk_pose){.type = (uint32_t)fixed->type,
                                         .position = fixed->position,
                                         .heading_rad = fixed->heading_rad,
                                         .tilt_rad = fixed->tilt_rad};
        p->site[first + k] = sites + (uint32_t)k;
    }
    return settings->one_per_site ? join_sites(p, first, err) : MURK_OK;
}

/* ---- constraints ---- */

/* Fails if the constraints contradict each other, so that the user learns it
 * before light is traced. */
static murk_status check_constraints(const murk_poses *p,
                                     const murk_scene_sensors *settings,
                                     murk_error *err)
{
    murk_constraint_set constraint_set;
    if (!p->has_constraints) {
        return MURK_OK;
    }
    murk_error cause = {0};
    const murk_status status = murk_constraint_set_init(
        &constraint_set, &p->constraints, p->count,
        settings->count > 0 ? (size_t)settings->count : p->count,
        settings->count == 0, &cause);
    if (status) {
        return murk_fail(err, status, settings->where, "%s", cause.text);
    }
    murk_constraint_set_release(&constraint_set);
    return MURK_OK;
}

/* Fills the constraints from the settings of the scene. */
static void fill_constraints(murk_poses *p, const murk_scene_sensors *settings)
{
    /* Minimum and maximum counts of types. */
    bool has_classes = false, has_costs = settings->budget > 0;
    for (size_t k = 0; k < settings->types; ++k) {
        const murk_scene_sensor_type *type = &settings->type[k];
        p->class_name[k] = type->name;
        p->min[k] = (size_t)type->min_count;
        p->max[k] =
            type->max_count < ANY_COUNT ? (size_t)type->max_count : p->count;
        has_classes =
            has_classes || type->min_count > 0 || type->max_count < ANY_COUNT;
    }
    /* Type, cost and position of each candidate. Fixed sensors are paid for
     * already. */
    for (size_t j = 0; j < p->count; ++j) {
        const murk_vec3 x = p->pose[j].position;
        p->class_of[j] = p->pose[j].type;
        const bool is_paid = j >= p->count - p->fixed;
        p->cost[j] = is_paid ? 0
                             : llround(settings->type[p->pose[j].type].cost /
                                       MURK_COST_UNIT);
        p->position_m[j][0] = x.x;
        p->position_m[j][1] = x.y;
        p->position_m[j][2] = x.z;
    }
    /* Leave out the arrays of constraints that the scene does not have. A
     * budget of less than half a unit stays a budget: 0 would stand for none.
     */
    p->constraints = (murk_constraints){
        .classes = has_classes ? settings->types : 0,
        .class_of = has_classes ? p->class_of : NULL,
        .min = has_classes ? p->min : NULL,
        .max = has_classes ? p->max : NULL,
        .cost = has_costs ? p->cost : NULL,
        .budget = has_costs ? (int64_t)fmax(
                                  1, round(settings->budget / MURK_COST_UNIT))
                            : 0,
        .fixed = p->fixed ? p->fixed_number : NULL,
        .fixed_count = p->fixed,
        .site = settings->one_per_site ? p->site : NULL,
        .position_m = (const double(*)[3])p->position_m,
        .spacing_m = settings->spacing_m,
        .class_name = p->class_name,
        .cost_unit = MURK_COST_UNIT};
    p->has_constraints = has_classes || has_costs || p->fixed > 0 ||
                         settings->one_per_site || settings->spacing_m > 0;
}

/* ---- all ---- */

/* Allocates all arrays. */
static bool allocate(murk_poses *p, size_t types)
{
    const size_t n = p->count + 1;
    p->pose = calloc(n, sizeof *p->pose);
    p->class_of = calloc(n, sizeof *p->class_of);
    p->site = calloc(n, sizeof *p->site);
    p->cost = calloc(n, sizeof *p->cost);
    p->position_m = calloc(n, sizeof *p->position_m);
    p->fixed_number = calloc(p->fixed + 1, sizeof *p->fixed_number);
    p->min = calloc(types + 1, sizeof *p->min);
    p->max = calloc(types + 1, sizeof *p->max);
    p->class_name = calloc(types + 1, sizeof *p->class_name);
    return p->pose && p->class_of && p->site && p->cost && p->position_m &&
           p->fixed_number && p->min && p->max && p->class_name;
}

murk_status murk_poses_create(murk_poses **out, const murk_scene_desc *scene,
                              const murk_domain *domain, const murk_vec3 *site,
                              size_t n, murk_error *err)
{
    return murk_poses_create_with(out, scene, domain, site, n, NULL, 0, err);
}

murk_status murk_poses_create_with(murk_poses **out,
                                   const murk_scene_desc *scene,
                                   const murk_domain *domain,
                                   const murk_vec3 *site, size_t n,
                                   const murk_pose *drifted, size_t n_drifted,
                                   murk_error *err)
{
    const murk_scene_sensors *settings = &scene->sensors;
    murk_poses *p = calloc(1, sizeof *p);
    murk_status status = MURK_OK;
    /* Count the poses of one site, then of all. */
    double each = 0;
    for (size_t k = 0; k < settings->types; ++k) {
        each += (double)headings_of(&settings->type[k]) *
                (double)tilts_of(&settings->type[k]);
    }
    if (p && each * (double)n + (double)settings->n_fixed > POSES_MAX) {
        status = murk_fail(err, MURK_BAD_VALUE, settings->where,
                           "%zu usable sites with %g types, headings and tilts "
                           "each are %.4g candidates, must be at most 1e7",
                           n, each, each * (double)n);
        goto done;
    }
    if (p) {
        p->fixed = settings->n_fixed;
        p->count = (size_t)each * n + n_drifted + p->fixed;
    }
    /* Allocate, and write the poses of each site. */
    if (!p || !allocate(p, settings->types)) {
        status = murk_no_memory(err, settings->where, "for the candidates");
        goto done;
    }
    size_t at = 0;
    for (size_t i = 0; i < n; ++i) {
        at += fill_site(p, settings, site[i], (uint32_t)i, at);
    }
    for (size_t i = 0; i < n_drifted; ++i) {
        p->site[at] = (uint32_t)(n + i);
        p->pose[at++] = drifted[i];
    }
    assert(at + p->fixed == p->count);
    /* Append the fixed sensors; check the constraints. */
    status = place_fixed(p, settings, domain, (uint32_t)(n + n_drifted), err);
    if (!status && settings->count > p->count) {
        status = murk_fail(err, MURK_BAD_VALUE, settings->where,
                           "count: %llu sensors, but only %zu candidates",
                           (unsigned long long)settings->count, p->count);
    }
    if (!status) {
        fill_constraints(p, settings);
        status = check_constraints(p, settings, err);
    }
    if (status) {
        goto done;
    }
    *out = p;
    p = NULL;
done:
    murk_poses_destroy(p);
    return status;
}

void murk_poses_destroy(murk_poses *p)
{
    if (p) {
        free(p->pose);
        free(p->class_of);
        free(p->site);
        free(p->min);
        free(p->max);
        free(p->class_name);
        free(p->fixed_number);
        free(p->cost);
        free(p->position_m);
        free(p->start);
        free(p);
    }
}

void murk_poses_limit_moves(murk_poses *poses,
                            const murk_scene_placement *placement)
{
    murk_constraints *rules = &poses->constraints;
    if (!poses->start ||
        !(placement->limits_moves || placement->move_cost > 0)) {
        return;
    }
    poses->limits_moves = true;
    rules->start = poses->start;
    rules->start_count = poses->starts;
    rules->moves_max =
        placement->limits_moves ? (size_t)placement->moves_max : SIZE_MAX;
    rules->move_cost = placement->move_cost;
}

const murk_constraints *murk_poses_constraints_of_any(const murk_poses *poses,
                                                      murk_constraints *copy)
{
    *copy = poses->constraints;
    copy->start = NULL;
    return poses->has_constraints ? copy : NULL;
}

const murk_constraints *murk_poses_constraints(const murk_poses *poses)
{
    return poses->has_constraints || poses->limits_moves ? &poses->constraints
                                                         : NULL;
}
