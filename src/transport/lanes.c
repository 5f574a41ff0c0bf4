/* The bookkeeping of photons side by side (transport/lanes.h).
 *
 * Each lane has a walker and, in the arrays of murk_photon_lanes, the part of
 * the walker that a collision changes. A step draws a collision for all lanes
 * and, with surfaces, looks for the surface before it. The lanes whose photon
 * meets something else than a medium or a diffuse surface, and those whose
 * photon is absorbed, are then treated one by one: the walker takes over the
 * event that the lane has found, or finds it anew from the same random numbers,
 * and a photon that has ended is replaced by the next one of the batch. When no
 * photon is left to begin, the lane that was filled last moves into the gap. */
#include "transport/lanes.h"

#include <assert.h>
#include <string.h>

#include "base/interrupt.h"
#include "base/philox.h"
#include "transport/lanes_surfaces.h"
#include "transport/meet.h"
#include "transport/score_lanes.h"

/* With fewer photons than this the walker is faster: a step of 8 lanes takes as
 * long as some 2 or 3 collisions of the walker. */
#define FEW 3

/* Starts of photons that are drawn at once: enough for the processor to work on
 * several. */
#define STARTS 16

static_assert(MURK_LANE_COUNT % MURK_LANE_GROUP == 0, "whole groups");
static_assert(MURK_LANE_COUNT <= MURK_SCORE_PATHS, "a list for each lane");
static_assert(MURK_LANE_COUNT < 64, "a bit for each lane");

typedef struct lane_batch {
    const murk_lane_steps *steps;
    const murk_walk_setup *setup;
    murk_sums *sums;
    uint64_t batch, next, last; /* of the photons in places [next, last) the
                                 * starts are not drawn yet */
    murk_photon_start start[STARTS]; /* of the next photons */
    size_t begun, drawn; /* start[begun] to start[drawn - 1] are still to
                          * begin */
    murk_lane_facts facts;
    bool is_even;    /* a single medium, which is even, fills the domain */
    bool is_heard;   /* collisions are reported */
    bool is_watched; /* segments or events are scored or reported */
    bool watches_media, watches_surfaces; /* those of such events are */
    bool has_other_phases; /* some lane has another phase function than that of
                            * Henyey and Greenstein */
    size_t n;              /* lanes in use: the first n */
    murk_photon_lanes lanes;
    murk_lane_rays before; /* the rays before the step, if is_watched */
    const murk_lane_scoring *scoring; /* for the instruction set */
    murk_lane_segments segments;      /* that this step scores side by side */
    murk_lane_lists lists;            /* open while the lane, not the walker,
                                       * has the photon */
    murk_walker walker[MURK_LANE_COUNT];
    const murk_phase
        *phase[MURK_LANE_COUNT]; /* of the medium of the collision */
    double scattering_per_m[MURK_LANE_COUNT];
    murk_lane_ahead ahead[MURK_LANE_COUNT]; /* with surfaces */
} lane_batch;

/* ---- between walker and lane ---- */

/* Adds the quanta that the medium of the photon has absorbed to the ledger. */
static void settle(lane_batch *b, size_t i)
{
    const murk_walker *w = &b->walker[i];
    const int64_t absorbed = (int64_t)b->lanes.absorbed[i];
    if (absorbed > 0) {
        b->sums->ended[w->channel][MURK_FATE_MEDIA] += absorbed;
        murk_walker_keep(w, w->absorber, absorbed);
        b->lanes.absorbed[i] = 0;
    }
}

/* Brings the walker to the state of the lane. */
static void take_out(lane_batch *b, size_t i)
{
    const murk_photon_lanes *l = &b->lanes;
    murk_walker *w = &b->walker[i];
    w->path.position = murk_vec(l->ray.x[i], l->ray.y[i], l->ray.z[i]);
    w->path.direction = murk_vec(l->ray.dx[i], l->ray.dy[i], l->ray.dz[i]);
    w->quanta = (int64_t)l->ray.quanta[i];
    w->number = (uint32_t)l->number[i];
    if (l->is_new[i] == 0) {
        w->probe = w->path.position;
        w->event_class = MURK_CLASS_LATER;
        w->wraps = 0;
    }
    settle(b, i);
    if (w->score) {
        murk_lane_lists_close(&b->lists, i);
    }
}

/* Notes the medium of the collision, or of all collisions, of a lane. */
static void set_medium(lane_batch *b, size_t i, const murk_collision *c)
{
    const bool is_hg = c->phase->kind == MURK_PHASE_HG;
    b->lanes.albedo[i] = c->albedo;
    b->lanes.g[i] = is_hg ? c->phase->value[0] : 0;
    b->phase[i] = c->phase;
    b->scattering_per_m[i] = c->scattering_per_m;
    b->has_other_phases |= !is_hg;
    b->walker[i].absorber = b->sums->materials + c->medium;
}

/* Brings the lane to the state of the walker. */
static void put_in(lane_batch *b, size_t i)
{
    murk_walker *w = &b->walker[i];
    murk_photon_lanes *l = &b->lanes;
    l->ray.x[i] = w->path.position.x;
    l->ray.y[i] = w->path.position.y;
    l->ray.z[i] = w->path.position.z;
    l->ray.dx[i] = w->path.direction.x;
    l->ray.dy[i] = w->path.direction.y;
    l->ray.dz[i] = w->path.direction.z;
    l->ray.quanta[i] = (double)w->quanta;
    l->absorbed[i] = 0;
    l->photon_low[i] = (uint32_t)w->photon;
    l->photon_high[i] = (uint32_t)(w->photon >> 32);
    l->number[i] = w->number;
    l->is_new[i] = 1;
    if (w->score) {
        murk_lane_lists_open(&b->lists, i, w->score);
    }
    b->phase[i] = NULL; /* until the next collision */
    murk_collision all;
    const murk_media *media = b->setup->world->media;
    if (b->is_even &&
        murk_media_even(media, w->band, &l->extinction_per_m[i], &all)) {
        set_medium(b, i, &all);
    }
    for (size_t k = 0; k < b->facts.regions.n; ++k) {
        const murk_lane_region *region = &b->facts.regions.region[k];
        const murk_collision c = murk_media_even_collision(
            media, region->medium, w->band,
            region->is_grid ? &l->grid.scale[i] : &l->region_extinction[k][i]);
        l->region_albedo[k][i] = c.albedo;
        l->region_g[k][i] =
            c.phase->kind == MURK_PHASE_HG ? c.phase->value[0] : 0;
    }
}

/* ---- photons ---- */

/* The start of the next photon; NULL if there is none, or after an
 * interrupt. */
static const murk_photon_start *next_start(lane_batch *b)
{
    if (b->begun == b->drawn) {
        const uint64_t left = b->last - b->next;
        b->begun = 0;
        b->drawn = left < STARTS ? (size_t)left : STARTS;
        murk_walk_starts_draw(b->setup, b->next, b->drawn, b->start);
        b->next += b->drawn;
    }
    return b->begun < b->drawn && !murk_interrupted() ? &b->start[b->begun++]
                                                      : NULL;
}

/* Begins photons until one of them does not end at the start. False if there is
 * no further photon. */
static bool begin(lane_batch *b, size_t i, murk_score_path *score)
{
    murk_walker *w = &b->walker[i];
    const murk_photon_start *start;
    while ((start = next_start(b)) != NULL) {
        const murk_fate fate = murk_walk_photon_begin(w, b->setup, b->sums,
                                                      score, b->batch, start);
        if (fate == MURK_FATE_NONE) {
            put_in(b, i);
            return true;
        }
        murk_walk_photon_end(w, fate);
    }
    return false;
}

/* Ends the photon of a lane, whose walker is up to date, and fills the lane
 * with the next photon or with that of the last lane. */
static void replace(lane_batch *b, size_t i, murk_fate fate)
{
    murk_walk_photon_end(&b->walker[i], fate);
    if (!begin(b, i, b->walker[i].score) && i != --b->n) {
        take_out(b, b->n);
        b->walker[i] = b->walker[b->n];
        put_in(b, i);
    }
}

/* ---- a step ---- */

/* The free flights that are not loops over lanes. */
static void fly_each(lane_batch *b)
{
    murk_photon_lanes *l = &b->lanes;
    const murk_lane_rays *ray = &l->ray;
    for (size_t i = 0; i < b->n; ++i) {
        const murk_walker *w = &b->walker[i];
        murk_collision c;
        const bool meets = murk_media_fly(
            b->setup->world->media, w->band, w->path.inside,
            murk_vec(ray->x[i], ray->y[i], ray->z[i]),
            murk_vec(ray->dx[i], ray->dy[i], ray->dz[i]), INFINITY, l->tau[i],
            murk_uniform((uint32_t)l->word_medium[i]), &c);
        l->meets[i] = meets;
        if (meets) {
            if (b->sums->materials + c.medium != w->absorber) {
                settle(b, i);
            }
            l->distance_m[i] = c.distance_m;
            set_medium(b, i, &c);
        }
    }
}

/* The media of collisions in several regions. */
static void find_media(lane_batch *b)
{
    murk_photon_lanes *l = &b->lanes;
    const murk_media *media = b->setup->world->media;
    for (size_t i = 0; i < b->n; ++i) {
        const murk_walker *w = &b->walker[i];
        const size_t medium =
            b->facts.regions.region[(size_t)l->region[i]].medium;
        if (l->meets[i] == 0) {
            continue;
        }
        if (b->sums->materials + medium != w->absorber || !b->phase[i]) {
            double extinction_per_m;
            const murk_collision c = murk_media_even_collision(
                media, medium, w->band, &extinction_per_m);
            settle(b, i);
            set_medium(b, i, &c);
        }
        b->scattering_per_m[i] = l->scattering_per_m[i];
    }
}

/* The cosines of phase functions of other kinds. */
static void sample_other_phases(lane_batch *b)
{
    for (size_t i = 0; i < b->n; ++i) {
        if (b->lanes.scatters[i] != 0 && b->phase[i]->kind != MURK_PHASE_HG) {
            b->lanes.cosine[i] = murk_phase_sample(
                b->phase[i], murk_uniform((uint32_t)b->lanes.word_cosine[i]));
        }
    }
}

/* Scores planes and spheres for the segment of a lane. */
static void score_crossings(lane_batch *b, size_t i)
{
    const murk_photon_lanes *l = &b->lanes;
    const murk_lane_rays *from = &b->before;
    murk_score_path *const path = b->walker[i].score;
    murk_lane_lists_close(&b->lists, i);
    murk_score_crossings(
        path, murk_vec(from->x[i], from->y[i], from->z[i]),
        murk_vec(from->dx[i], from->dy[i], from->dz[i]), l->distance_m[i],
        from->quanta[i],
        (murk_station){murk_vec(l->ray.x[i], l->ray.y[i], l->ray.z[i]), 0});
    murk_lane_lists_open(&b->lists, i, path);
}

/* Scores the segments to the collisions of a step side by side, except those of
 * photons whose list might become full: these are left to watch(). */
static void score(lane_batch *b)
{
    const murk_tallies *t = b->sums->scorer->tallies;
    const murk_photon_lanes *l = &b->lanes;
    murk_lane_segments *segments = &b->segments;
    segments->n = b->n;
    b->scoring->select(segments, &b->lists, l->meets, l->distance_m);
    for (size_t i = 0; t->planes + t->probes > 0 && i < b->n; ++i) {
        if (segments->is_scored[i]) {
            score_crossings(b, i);
        }
    }
    for (size_t k = 0; k < t->lattices; ++k) {
        b->scoring->score(&t->lattice[k], segments, &b->lists);
    }
}

/* Scores and reports the collision of a lane, as scatter() of walk.c does; what
 * score() has scored is only reported. */
static void watch(lane_batch *b, size_t i)
{
    const murk_photon_lanes *l = &b->lanes;
    const murk_lane_rays *from = &b->before;
    murk_walker *w = &b->walker[i];
    const murk_vec3 start = {from->x[i], from->y[i], from->z[i]};
    const murk_vec3 arriving = {from->dx[i], from->dy[i], from->dz[i]};
    const double before = from->quanta[i];
    /* The segment to the collision. */
    w->path.position = murk_vec(l->ray.x[i], l->ray.y[i], l->ray.z[i]);
    if (w->score && b->segments.is_scored[i] == 0) {
        murk_lane_lists_close(&b->lists, i);
        murk_score_segment(w->score, start, arriving, l->distance_m[i], before,
                           (murk_station){w->path.position, 0});
        murk_lane_lists_open(&b->lists, i, w->score);
    }
    const bool scatters = l->scatters[i] != 0;
    if (murk_walker_is_heard(w) && (scatters || !w->setup->trace->skips_ends)) {
        w->number = (uint32_t)l->number[i];
        murk_event event;
        murk_walker_event(&event, w, MURK_EVENT_MEDIUM);
        event.outcome = scatters ? MURK_SCATTERED : MURK_ABSORBED;
        event.material_or_medium = (uint8_t)(w->absorber - b->sums->materials);
        event.direction_in = arriving;
        event.direction_out =
            scatters ? murk_vec(l->ray.dx[i], l->ray.dy[i], l->ray.dz[i])
                     : murk_vec(0, 0, 0);
        event.weight = before / (double)MURK_PACKET;
        event.leaving = scatters ? l->ray.quanta[i] / (double)MURK_PACKET : 0;
        event.reflectance = l->albedo[i];
        event.path_m = l->distance_m[i];
        event.scattering_per_m = b->scattering_per_m[i];
        murk_walker_tell(w, &event);
        w->event_class = MURK_CLASS_LATER;
    }
}

/* The next events of all lanes, if there are surfaces. */
static void find_next(lane_batch *b)
{
    const double *extinction_per_m =
        b->is_even ? b->lanes.extinction_per_m : b->lanes.piece_extinction;
    for (size_t i = 0; i < b->n; ++i) {
        murk_lane_find(&b->ahead[i], &b->walker[i], &b->lanes, i,
                       extinction_per_m[i]);
    }
}

/* The lanes whose next event is a surface that reflects diffusely or absorbs.
 */
static void reflect(lane_batch *b)
{
    for (size_t i = 0; i < b->n; ++i) {
        if (b->ahead[i].next == MURK_LANE_REFLECTS) {
            murk_lane_reflect(&b->ahead[i], &b->walker[i], &b->lanes, i);
        }
    }
}

/* Lets the walker, which is up to date, treat the event of a lane. */
static murk_fate walk(const lane_batch *b, size_t i, murk_walker *w)
{
    if (b->facts.any_surfaces && b->ahead[i].next == MURK_LANE_MEETS) {
        return murk_lane_meet(&b->ahead[i], w);
    }
    if (!b->facts.any_surfaces && w->number <= b->facts.events_max) {
        /* No medium and no surface: the side of the domain. */
        murk_path_event side;
        return murk_path_first_event(&w->path, w->probe, NULL, INFINITY, &side)
                   ? murk_meet_side(w, side.distance_m)
                   : murk_walker_lose(w, MURK_LOSS_NUMERICAL);
    }
    /* The walker looks for the event anew. */
    --w->number;
    return murk_walk_photon_event(w);
}

/* Treats what a step has left to the walker of a lane. */
static void finish(lane_batch *b, size_t i)
{
    murk_walker *w = &b->walker[i];
    const bool meets = b->lanes.meets[i] != 0;
    const bool scatters = b->lanes.scatters[i] != 0;
    const bool reflects =
        b->facts.any_surfaces && b->ahead[i].next == MURK_LANE_REFLECTS;
    b->sums->collisions += meets;
    const bool is_scored = b->segments.is_scored[i] != 0;
    if (meets && b->watches_media && (b->is_heard || !is_scored)) {
        watch(b, i);
    }
    if (reflects && b->watches_surfaces) {
        if (w->score) {
            murk_lane_lists_close(&b->lists, i);
        }
        murk_lane_reflected(
            &b->ahead[i], w, &b->lanes, i,
            murk_vec(b->before.x[i], b->before.y[i], b->before.z[i]));
        if (w->score) {
            murk_lane_lists_open(&b->lists, i, w->score);
        }
    }
    /* A photon whose list overflowed owns the scorer's sums and is followed to
     * its end now. */
    const bool is_alone = !is_scored && w->score && w->score->has_sums;
    if (scatters && !is_alone) {
        return;
    }
    take_out(b, i);
    murk_fate fate = scatters ? MURK_FATE_NONE
                     : meets  ? MURK_FATE_MEDIA
                              : MURK_FATE_SURFACES;
    if (reflects) {
        w->absorber = b->ahead[i].ahead.hit.material;
    } else if (!meets) {
        fate = walk(b, i, w);
    }
    /* A photon that owns the sums of the scorer must end before any other. */
    if (fate == MURK_FATE_NONE && w->score && w->score->has_sums) {
        fate = murk_walk_photon_on(w);
    }
    if (fate == MURK_FATE_NONE) {
        put_in(b, i);
    } else {
        replace(b, i, fate);
    }
}

/* Treats what a step has left of all lanes. Most photons are scattered in a
 * medium, and nothing is left but to count the collision. */
static void finish_all(lane_batch *b, size_t n)
{
    const uint64_t unfinished =
        b->is_heard ? UINT64_MAX
                    : b->steps->unfinished(&b->lanes, b->segments.is_scored, n);
    uint64_t left = unfinished & ((UINT64_C(1) << b->n) - 1);
    size_t finished = b->n;
    /* From the last lane to the first, because a gap is filled with the last
     * lane. */
    while (left != 0) {
        const size_t i = 63 - (size_t)__builtin_clzll(left);
        left ^= UINT64_C(1) << i;
        --finished;
        finish(b, i);
    }
    b->sums->collisions += finished;
}

/* The free flights, and what ends them. */
static void fly(lane_batch *b, size_t n)
{
    murk_photon_lanes *l = &b->lanes;
    if (b->is_even) {
        b->steps->fly(l, n);
    } else if (b->facts.has_regions) {
        b->steps->fly_regions(l, &b->facts, n);
    } else if (b->facts.any_media) {
        fly_each(b);
    }
    if (b->facts.any_surfaces) {
        find_next(b);
    }
    if (b->facts.has_regions) {
        find_media(b);
    }
}

/* Copies n rays: a copy of the whole structure would be made by an instruction
 * that takes several times as long. */
static void keep_rays(murk_lane_rays *to, const murk_lane_rays *from, size_t n)
{
    const size_t size = n * sizeof from->x[0];
    memcpy(to->x, from->x, size);
    memcpy(to->y, from->y, size);
    memcpy(to->z, from->z, size);
    memcpy(to->dx, from->dx, size);
    memcpy(to->dy, from->dy, size);
    memcpy(to->dz, from->dz, size);
    memcpy(to->quanta, from->quanta, size);
}

/* One event of each photon. */
static void step(lane_batch *b)
{
    murk_photon_lanes *l = &b->lanes;
    /* Lanes beyond the last one compute numbers that nobody reads. */
    const size_t n =
        (b->n + MURK_LANE_GROUP - 1) / MURK_LANE_GROUP * MURK_LANE_GROUP;
    if (b->is_watched) {
        keep_rays(&b->before, &l->ray, n);
    }
    b->steps->draw(l, &b->facts, n);
    fly(b, n);
    if (b->facts.any_media) {
        b->steps->collide(l, &b->facts, n);
        if (b->sums->scorer) {
            score(b);
        }
    } else {
        memset(l->scatters, 0, sizeof l->scatters);
    }
    if (b->has_other_phases) {
        sample_other_phases(b);
    }
    if (b->facts.any_surfaces) {
        reflect(b);
    }
    b->steps->turn(l, n);
    finish_all(b, n);
}

/* True if the free flights of all photons are loops over lanes. */
static bool fly_in_lanes(const murk_media *media)
{
    double extinction_per_m;
    murk_collision all;
    murk_lane_regions regions;
    return murk_media_even(media, 0, &extinction_per_m, &all) ||
           murk_media_lane_regions(media, &regions);
}

const murk_lane_steps *murk_photon_lanes_for(const murk_walk_setup *setup)
{
    const murk_trace *trace = setup->trace;
    const murk_path_space *space = &setup->space;
    const bool suits =
        (space->any_surfaces
             ? !setup->any_media || fly_in_lanes(setup->world->media)
             : setup->any_media) &&
        !space->any_boundaries && !trace->by_delta && !trace->segment_sink &&
        (!trace->sink || trace->takes_any_order);
    return suits ? murk_lane_steps_chosen() : NULL;
}

void murk_photon_lanes_trace(const murk_lane_steps *steps,
                             const murk_walk_setup *setup, murk_sums *sums,
                             uint64_t batch, uint64_t first, uint64_t last)
{
    const murk_trace *trace = setup->trace;
    lane_batch b;
    memset(&b.lanes, 0, sizeof b.lanes);
    b.steps = steps;
    b.setup = setup;
    b.sums = sums;
    b.batch = batch;
    b.next = first;
    b.last = last;
    b.begun = b.drawn = 0;
    b.facts = (murk_lane_facts){
        .seed = trace->seed,
        .purpose = (uint32_t)MURK_FLIGHT + setup->purpose_shift,
        .surface_purpose = (uint32_t)MURK_SURFACE + setup->purpose_shift,
        .any_media = setup->any_media,
        .any_surfaces = setup->space.any_surfaces,
        .events_max = trace->events_max,
        .min_quanta = (double)setup->min_quanta,
        .sides = setup->space.sides};
    double extinction_per_m;
    murk_collision all;
    b.is_even = setup->any_media && murk_media_even(setup->world->media, 0,
                                                    &extinction_per_m, &all);
    if (setup->any_media && !b.is_even) {
        murk_lane_regions *regions = &b.facts.regions;
        b.facts.has_regions =
            murk_media_lane_regions(setup->world->media, regions);
        if (b.facts.has_regions && regions->has_grid) {
            b.facts.grid = murk_grid_lane_steps_for(steps->set);
        }
    }
    b.is_heard = trace->sink && !trace->skips_media;
    b.watches_media = sums->scorer || b.is_heard;
    b.watches_surfaces =
        setup->space.any_surfaces &&
        (sums->scorer || (trace->sink && !trace->skips_surfaces));
    b.is_watched = b.watches_media || b.watches_surfaces;
    b.has_other_phases = false;
    b.scoring = murk_lane_scoring_for(steps->set);
    memset(&b.segments, 0, sizeof b.segments);
    b.segments.from = &b.before;
    if (sums->scorer) {
        murk_lane_lists_create(&b.lists, sums->scorer);
        sums->scorer->add = b.scoring->add;
    } else {
        memset(b.segments.is_scored, -1, sizeof b.segments.is_scored);
    }
    memset(&b.before, 0, sizeof b.before);
    /* Begin a photon in each lane. */
    b.n = 0;
    while (b.n < MURK_LANE_COUNT &&
           begin(&b, b.n, sums->scorer ? &sums->scorer->path[b.n] : NULL)) {
        ++b.n;
    }
    while (b.n >= FEW && !murk_interrupted()) {
        step(&b);
    }
    /* The walker alone follows the last photons. */
    for (size_t i = 0; i < b.n; ++i) {
        take_out(&b, i);
        murk_walk_photon_end(&b.walker[i], murk_walk_photon_on(&b.walker[i]));
    }
}
