/* Finds the regions of interest that contain each photon, as a bit mask, and
 * the factor of their weights. */
#include "sensing/interest.h"

#include "base/pool.h"

/* Photons that a thread takes at a time (a choice). */
#define BATCH_PHOTONS 4096

static bool is_of_kind(const murk_interest_region *region,
                       const murk_photon *photon)
{
    const bool is_volume = murk_photon_is_volume(photon);
    return (region->material < 0 ||
            (!is_volume && murk_photon_material(photon) == region->material)) &&
           (region->medium < 0 ||
            (is_volume && murk_photon_material(photon) == region->medium));
}

static bool box_holds(const murk_box *box, murk_vec3 p, double slack_m)
{
    const murk_vec3 slack = {slack_m, slack_m, slack_m};
    const murk_box wide = {murk_sub(box->min, slack),
                           murk_add(box->max, slack)};
    return murk_box_contains(&wide, p);
}

/* The boundary meshes that contain the photon. A surface photon is tested on
 * both sides of the surface, because the boundary mesh may be that surface. */
static uint64_t boundary_meshes_around(const murk_interest *interest,
                                       const murk_photon *photon,
                                       double slack_m)
{
    const murk_vec3 p = murk_photon_place(photon);
    if (!interest->boundary_meshes) {
        return 0;
    }
    if (murk_photon_is_volume(photon)) {
        return murk_boundary_meshes_at(interest->boundary_meshes, p);
    }
    const murk_vec3 normal = murk_photon_normal(photon);
    const double off =
        slack_m + murk_boundary_meshes_tolerance_m(interest->boundary_meshes);
    return murk_boundary_meshes_at(interest->boundary_meshes,
                                   murk_along(p, off, normal)) |
           murk_boundary_meshes_at(interest->boundary_meshes,
                                   murk_along(p, -off, normal));
}

uint64_t murk_interest_at(const murk_interest *interest,
                          const murk_photon *photon, double slack_m)
{
    /* The slack is for surface photons only: they lie on boundaries, from which
     * storage may have moved them. */
    const murk_vec3 p = murk_photon_place(photon);
    const double slack = murk_photon_is_volume(photon) ? 0 : slack_m;
    const uint64_t boundary_meshes =
        boundary_meshes_around(interest, photon, slack_m);
    uint64_t regions = 0;
    for (size_t i = 0; i < interest->n; ++i) {
        const murk_interest_region *r = &interest->region[i];
        bool is_in = is_of_kind(r, photon);
        switch (r->shape) {
        case MURK_REGION_BOX:
            is_in = is_in && box_holds(&r->box, p, slack);
            break;
        case MURK_REGION_SPHERE:
            is_in = is_in &&
                    murk_length(murk_sub(p, r->center)) <= r->radius_m + slack;
            break;
        case MURK_REGION_MESH:
            is_in = is_in && (boundary_meshes >> i & 1);
            break;
        default: /* everywhere */
            break;
        }
        regions |= (uint64_t)is_in << i;
    }
    return regions;
}

typedef struct work {
    uint64_t *member;
    const murk_interest *interest;
    const murk_photon *photon;
    double slack_m;
} work;

static void find_members(void *context, uint64_t i)
{
    const work *w = context;
    w->member[i] = murk_interest_at(w->interest, &w->photon[i], w->slack_m);
}

void murk_interest_members(uint64_t *member, const murk_interest *interest,
                           const murk_photon_map *map, double slack_m,
                           unsigned threads)
{
    work w = {member, interest, murk_photon_map_photons(map), slack_m};
    murk_pool_run_items(threads, murk_photon_map_count(map), BATCH_PHOTONS,
                        find_members, &w);
}

double murk_interest_factor(const murk_interest *interest, uint64_t regions)
{
    double factor = regions ? 1 : interest->elsewhere;
    for (size_t i = 0; i < interest->n; ++i) {
        if (regions >> i & 1) {
            factor *= interest->region[i].weight;
        }
    }
    return factor;
}
