/* Follows a ray by the walk of the photon tracer (transport/walk.h), with sums
 * that nobody reads: a ray carries radiance, not power. */
#include "transport/follow.h"

#include <stdlib.h>

#include "transport/jump.h"
#include "transport/walk.h"

struct murk_follower {
    murk_trace trace;
    murk_walk_setup setup;
    murk_sums sums; /* read by nobody: a ray's quanta are no light */
    murk_tally *absorber;
    double (*busy)[2]; /* heights that are not free */
    uint32_t events_max;
};

murk_status murk_follower_create(murk_follower **out, const murk_trace *trace,
                                 murk_error *err)
{
    const murk_transport_world *world = trace->world;
    const size_t materials = murk_surfaces_materials(world->surfaces);
    const size_t absorbers = materials + murk_media_count(world->media);
    murk_follower *f = calloc(1, sizeof *f);
    murk_tally *absorber = calloc(absorbers + 1, sizeof *absorber);
    if (!f || !absorber) {
        free(f);
        free(absorber);
        return murk_no_memory(err, "render", "for a ray's way");
    }
    /* The walk, without tallies. */
    f->trace = *trace;
    f->trace.tallies = NULL;
    f->events_max = trace->events_max;
    f->setup = murk_walk_setup_of(&f->trace);
    f->absorber = absorber;
    /* The heights of a periodic domain that a ray must not jump over. */
    const murk_status status =
        murk_jump_heights(&f->busy, &f->setup.n_busy, world, err);
    if (status) {
        murk_follower_destroy(f);
        return status;
    }
    f->setup.busy = (const double(*)[2])f->busy;
    f->setup.jumps = world->domain.is_periodic;
    /* Sums for the walk to add to. */
    f->sums.absorber = absorber;
    f->sums.materials = materials;
    f->sums.absorbers = absorbers;
    *out = f;
    return MURK_OK;
}

void murk_follower_destroy(murk_follower *follower)
{
    if (follower) {
        free(follower->absorber);
        free(follower->busy);
        free(follower);
    }
}

void murk_follow_photon(murk_follower *follower, uint64_t number, int band,
                        murk_vec3 origin, murk_vec3 direction)
{
    follower->trace.events_max = follower->events_max;
    const murk_ray ray = {.origin = origin, .direction = direction};
    murk_walk_from(&follower->setup, &follower->sums, number, band, ray);
}

/* With events_max at 0, the next event is one too many. */
void murk_follower_stop(murk_follower *follower)
{
    follower->trace.events_max = 0;
}
