/* Traces again the photons that a change may touch: those whose path crosses a
 * cell of a changed place, and those that start otherwise. Ledger and tallies
 * are sums of integers, so a photon is taken out by tracing it in the earlier
 * world with negative sign. */
#include "lightmap/light_update.h"

#include "base/interrupt.h"
#include "base/machine.h"
#include "base/progress.h"
#include "base/ranks.h"
#include "base/sort.h"
#include "lightmap/emission.h"
#include "lightmap/rank_exchange.h"
#include "lightmap/watching.h"
#include "world/changed_world.h"
#include "world/scene_tallies.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* If more photons are listed, all are traced anew: a listed one is traced
 * twice. */
#define LISTED_SHARE_MAX 0.5

/* If more photons are listed, and the surroundings of what has changed are so
 * many times smaller than the cells that are noted now, all are traced anew,
 * too, because finer cells make the next updates so much faster. */
#define FEW_SHARE     0.1
#define TIMES_SMALLER 4

/* The cells cover what has changed, enlarged by its own size so many times on
 * each side: what moves is likely to move on by less. */
#define AHEAD 2

/* Listed photons are selected once more if what has changed fills a smaller
 * share of the cells: a path that crosses a cell meets a box in it by about its
 * cross section. */
#define SELECT_BELOW 0.25

/* Rounding of positions and lengths, relative to the coordinates. */
#define SELECT_ROUNDING 1e-9

/* Memory for records that is reserved, as a share of the records before. */
#define RESERVE 1.05

/* ---- the photons that are traced ---- */

typedef struct updating {
    const murk_stage *stage, *before;
    const murk_traced *earlier;
    murk_traced *traced;
    murk_record_buffers *buffers;
    uint32_t *photon; /* [n] those that are traced */
    size_t n;
    uint64_t reused; /* photons of light that is on that are not traced */
    unsigned threads;
} updating;

static bool is_same(murk_vec3 a, murk_vec3 b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

/* True if photons of the light start alike in both stages: a lamp with the same
 * members but the power. Of other light it is found out photon by photon.
 * Members are compared one by one, since bytes between them may differ. */
static bool is_same_lamp(const murk_source *a, const murk_source *b)
{
    if (a->type != b->type || murk_source_is_distant(a) || a->portals > 0 ||
        b->portals > 0 || !a->intensity != !b->intensity) {
        return false;
    }
    if (a->intensity) { /* the file was read twice */
        uint64_t sum[2][2];
        murk_intensity_checksum(a->intensity, sum[0]);
        murk_intensity_checksum(b->intensity, sum[1]);
        if (memcmp(sum[0], sum[1], sizeof sum[0]) != 0) {
            return false;
        }
    }
    return is_same(a->position, b->position) && is_same(a->edge1, b->edge1) &&
           is_same(a->edge2, b->edge2) && is_same(a->direction, b->direction) &&
           is_same(a->c0, b->c0) && a->radius_m == b->radius_m &&
           a->height_m == b->height_m &&
           a->divergence_rad == b->divergence_rad &&
           a->angular_radius_rad == b->angular_radius_rad &&
           a->is_part == b->is_part;
}

/* How the photons of both stages start. */
typedef struct start_comparison {
    bool deals_alike;                    /* photons belong to the same light */
    bool is_same_lamp[MURK_SOURCES_MAX]; /* same lamp, of any power */
    bool are_all;                        /* all photons start alike */
} start_comparison;

static start_comparison compare_starts(const updating *u)
{
    const murk_sources *a = u->before->lights, *b = u->stage->lights;
    start_comparison out = {.deals_alike = murk_sources_deal_alike(a, b)};
    out.are_all =
        out.deals_alike &&
        memcmp(u->earlier->packet_w, u->traced->packet_w,
               u->traced->channels * sizeof *u->traced->packet_w) == 0;
    for (size_t i = 0; i < murk_sources_count(b); ++i) {
        out.is_same_lamp[i] =
            is_same_lamp(murk_sources_get(a, i), murk_sources_get(b, i));
        out.are_all = out.are_all && out.is_same_lamp[i];
    }
    return out;
}

/* True if the photon starts alike, with the same power. Of light that is off
 * nothing is traced, then or now. */
static bool starts_alike(const updating *u, const start_comparison *c,
                         uint64_t photon)
{
    const murk_sources *a = u->before->lights, *b = u->stage->lights;
    const size_t channel = murk_sources_channel_of(b, photon);
    const double *before_w = &u->earlier->packet_w[channel],
                 *now_w = &u->traced->packet_w[channel];
    if ((!c->deals_alike && channel != murk_sources_channel_of(a, photon)) ||
        memcmp(before_w, now_w, sizeof *now_w) != 0) {
        return false;
    }
    if (c->is_same_lamp[channel / (size_t)u->stage->world.bands] ||
        !(*now_w > 0)) {
        return true;
    }
    const uint32_t seed = u->stage->scene->seed;
    const uint32_t stream = u->traced->stream;
    const murk_ray p = murk_sources_emit_in(a, channel, seed, stream, photon),
                   q = murk_sources_emit_in(b, channel, seed, stream, photon);
    return memcmp(&p.origin, &q.origin, sizeof p.origin) == 0 &&
           memcmp(&p.direction, &q.direction, sizeof p.direction) == 0 &&
           p.is_spent == q.is_spent;
}

/* Lists the photons that start otherwise or cross one of the cells, up to `max`
 * of them and one more. A photon of light that is off crosses none. */
static void list_photons(updating *u, uint64_t cells, size_t max)
{
    const uint64_t *crossed = u->earlier->cells->crossed;
    const start_comparison c = compare_starts(u);
    u->n = 0;
    for (uint64_t i = 0; i < u->earlier->emitted && u->n <= max; ++i) {
        if ((crossed[i] & cells) || (!c.are_all && !starts_alike(u, &c, i))) {
            u->photon[u->n++] = (uint32_t)i;
        }
    }
}

/* ---- tracing ---- */

static murk_trace trace_of(const updating *u, const murk_stage *stage)
{
    murk_trace trace = murk_stage_trace(stage);
    trace.stream = u->traced->stream;
    trace.threads = u->threads;
    trace.tallies = u->traced->tallies;
    trace.photon = u->photon;
    trace.last = u->n;
    return trace;
}

/* Gives the new light the sums of ledger and tallies of the earlier one. */
static murk_status copy_sums(const updating *u, murk_error *err)
{
    murk_light_sums sums;
    const murk_status status = murk_light_sums_read(
        &sums, u->earlier->ledger, u->earlier->tallies, false, MURK_OK, err);
    if (!status) {
        murk_ledger_add(u->traced->ledger, sums.cell);
        if (u->traced->tallies) {
            murk_tallies_add_sums(u->traced->tallies, sums.word);
        }
    }
    murk_light_sums_release(&sums);
    return status;
}

/* Takes the listed photons out of the sums; those that stay are reused. */
static void take_out(updating *u)
{
    murk_trace trace = trace_of(u, u->before);
    trace.takes_back = true;
    murk_trace_run(&trace, u->traced->ledger);
    u->reused = (uint64_t)murk_tally_read(&u->traced->ledger->photons);
}

/* Traces the listed photons in the new world, in waves, and notes their paths.
 */
static murk_status trace_listed(updating *u, murk_error *err)
{
    murk_watching watching = {u->buffers, u->traced->cells,
                              &u->stage->world.domain};
    murk_status status = MURK_OK;
    for (size_t k = 0; k < u->n; ++k) {
        u->traced->cells->crossed[u->photon[k]] = 0;
    }
    const size_t wave = (size_t)MURK_WAVE_BATCHES * MURK_BATCH_PHOTONS;
    for (size_t first = 0; first < u->n && !status; first += wave) {
        murk_trace trace = trace_of(u, u->stage);
        trace.first = first;
        trace.last = u->n - first < wave ? u->n : first + wave;
        murk_watch(&watching, &trace);
        murk_trace_run(&trace, u->traced->ledger);
        status = murk_interrupt_check(err);
        if (!status) {
            status = murk_record_buffers_gather(u->buffers, UINT64_MAX, err);
        }
    }
    return status;
}

/* ---- records ---- */

/* Adds the records of an earlier map, without those of the listed photons. */
static murk_status take_over(murk_record_list *list, const murk_photon_map *map,
                             const uint64_t *is_listed, murk_error *err)
{
    const murk_photon *photon = murk_photon_map_photons(map);
    const size_t n = murk_photon_map_count(map);
    murk_status status = MURK_OK;
    for (size_t i = 0; i < n && !status; ++i) {
        const uint32_t k = murk_photon_emitted(&photon[i]);
        if (!(is_listed[k / 64] >> (k % 64) & 1)) {
            status = murk_record_list_put(list, &photon[i], err);
        }
    }
    return status;
}

/* A bit for each listed photon, for free(). NULL when out of memory. */
static uint64_t *list_bits(const updating *u)
{
    uint64_t *is_listed =
        calloc(u->earlier->emitted / 64 + 1, sizeof *is_listed);
    for (size_t k = 0; is_listed && k < u->n; ++k) {
        is_listed[u->photon[k] / 64] |= UINT64_C(1) << (u->photon[k] % 64);
    }
    return is_listed;
}

/* Adds the records of the photons that are not listed to those that were traced
 * now. */
static murk_status take_over_both(const updating *u, murk_error *err)
{
    uint64_t *is_listed = list_bits(u);
    if (!is_listed) {
        return murk_no_memory(err, "", "for the photons that are traced again");
    }
    murk_status status =
        take_over(&u->buffers->surface, u->earlier->surface, is_listed, err);
    if (!status) {
        status =
            take_over(&u->buffers->volume, u->earlier->volume, is_listed, err);
    }
    free(is_listed);
    return status;
}

static murk_status build_maps(const updating *u, murk_error *err)
{
    murk_traced *traced = u->traced;
    const double begun_s = murk_clock_s();
    murk_status status = murk_record_list_map(
        &traced->surface, &u->buffers->surface, u->threads, err);
    if (!status) {
        status = murk_record_list_map(&traced->volume, &u->buffers->volume,
                                      u->threads, err);
    }
    traced->map_s = murk_clock_s() - begun_s;
    return status;
}

/* ---- the update ---- */

/* True if both stages trace photons by the same rules, so that a photon may be
 * the same in both. */
static bool has_same_rules(const murk_stage *a, const murk_stage *b,
                           const murk_traced *earlier, uint32_t stream)
{
    return murk_can_watch(b) && earlier->cells && earlier->stream == stream &&
           memcmp(&a->scene->origin, &b->scene->origin,
                  sizeof a->scene->origin) == 0 &&
           strcmp(a->scene->rules_key, b->scene->rules_key) == 0 &&
           earlier->emitted == b->scene->photons.emit &&
           murk_sources_channels(a->lights) ==
               murk_sources_channels(b->lights) &&
           murk_surfaces_materials(a->surfaces) ==
               murk_surfaces_materials(b->surfaces) &&
           murk_media_count(a->media) == murk_media_count(b->media) &&
           murk_sources_lit(b->lights) > 0;
}

/* Prepares the new light, and lists the photons that are traced, as far as an
 * update may pay. */
static murk_status prepare(updating *u, uint64_t cells, murk_error *err)
{
    const size_t max = (size_t)(LISTED_SHARE_MAX * (double)u->earlier->emitted);
    u->traced = murk_traced_create(u->stage, u->earlier->stream, err);
    u->photon = malloc((max + 1) * sizeof *u->photon);
    if (!u->traced || !u->photon) {
        return murk_no_memory(err, "", "to update the light");
    }
    u->traced->emitted = u->earlier->emitted;
    const murk_status status = murk_traced_set_powers(u->traced, u->stage, err);
    if (!status) {
        list_photons(u, cells, max);
    }
    return status;
}

/* Gives the new light the cells of the earlier one. */
static murk_status copy_cells(const updating *u, murk_error *err)
{
    const murk_path_cells *before = u->earlier->cells;
    const murk_status status = murk_path_cells_create(
        &u->traced->cells, &before->box, before->photons, err);
    if (!status) {
        memcpy(u->traced->cells->crossed, before->crossed,
               before->photons * sizeof *before->crossed);
    }
    return status;
}

/* Reserves memory for as many records as the earlier map has, and some more.
 * Light that is passed on has no map. */
static void reserve(murk_record_list *list, const murk_photon_map *earlier)
{
    const size_t n = earlier ? murk_photon_map_count(earlier) : 0;
    murk_record_list_reserve(list, RESERVE * (double)n);
}

/* Traces the listed photons in the new world; the buffers then have the new
 * records in watts. In stream 0, whose ledger and tallies are results, these
 * become those of all photons. Of other streams the ledger tells alone whether
 * too many photons are lost, and each lost photon is listed, as it crosses all
 * cells. */
static murk_status trace_again(updating *u, murk_error *err)
{
    murk_traced *traced = u->traced;
    const bool has_sums = traced->stream == 0;
    u->buffers = murk_record_buffers_create(&u->stage->scene->photons);
    murk_status status = u->buffers
                             ? copy_cells(u, err)
                             : murk_no_memory(err, "", "to update the light");
    if (!status) {
        reserve(&u->buffers->surface, u->earlier->surface);
        reserve(&u->buffers->volume, u->earlier->volume);
    }
    if (!status && has_sums) {
        status = murk_tallies_of_stage(&traced->tallies, u->stage, u->threads,
                                       murk_machine_memory_bytes(), err);
    }
    if (!status && has_sums) {
        status = copy_sums(u, err);
    }
    murk_progress_begin("update", (has_sums ? 2 : 1) * u->n, "photons");
    if (!status && has_sums) {
        take_out(u);
    }
    if (!status) {
        status = trace_listed(u, err);
    }
    murk_progress_end();
    if (!status) {
        const murk_emission all = {.stage = u->stage,
                                   .emitted = traced->emitted,
                                   .ledger = traced->ledger};
        status = murk_emission_check_losses(&all, err);
    }
    /* The new records come in shares of a packet, the earlier ones in watts. */
    if (!status) {
        murk_record_buffers_to_watts(u->buffers, traced->packet_w,
                                     u->stage->scene->bands);
    }
    return status;
}

/* Traces the listed photons, and joins the result with what stays. */
static murk_status update(updating *u, murk_error *err)
{
    murk_status status = trace_again(u, err);
    if (!status) {
        status = take_over_both(u, err);
    }
    return status ? status : build_maps(u, err);
}

/* The box whose cells are noted when all photons are traced: the surroundings
 * of what has changed; the domain if all has, or nothing. */
static murk_box surroundings(const murk_box_list *changed,
                             const murk_box *domain)
{
    murk_box box = murk_box_empty();
    for (size_t i = 0; i < changed->n; ++i) {
        box = murk_box_with(murk_box_with(box, changed->box[i].min),
                            changed->box[i].max);
    }
    const murk_vec3 more = murk_scale(AHEAD, murk_sub(box.max, box.min));
    box = murk_box_meet(
        (murk_box){murk_sub(box.min, more), murk_add(box.max, more)}, *domain);
    const bool is_box =
        box.min.x < box.max.x && box.min.y < box.max.y && box.min.z < box.max.z;
    return changed->are_all || !is_box ? *domain : box;
}

static double volume(const murk_box *box)
{
    const murk_vec3 edge = murk_sub(box->max, box->min);
    return edge.x * edge.y * edge.z;
}

/* True if an update takes less time than to trace all photons, and than updates
 * with the cells of the box `watched`. */
static bool pays(const updating *u, const murk_box *watched)
{
    const double share = (double)u->n / (double)u->earlier->emitted;
    const bool is_coarse =
        TIMES_SMALLER * volume(watched) < volume(&u->earlier->cells->box);
    return share <= (is_coarse ? FEW_SHARE : LISTED_SHARE_MAX);
}

/* ---- listed photons that meet no change ---- */

/* Where a selection takes note of the photons that meet a changed box. */
typedef struct selecting {
    murk_box_list changed;
    const murk_domain *domain;
    uint8_t *meets; /* [emitted]; bytes, as threads write neighbours */
} selecting;

/* A murk_event_sink. The path of a lost photon, and of one that may jump, is
 * not known (lightmap/path_cells.h). */
static void select_event(void *context, uint64_t batch, const murk_event *event)
{
    const selecting *s = context;
    uint8_t *meets = &s->meets[event->photon];
    (void)batch;
    if (*meets) {
        return;
    }
    if (event->kind == MURK_EVENT_LOST ||
        (event->kind == MURK_EVENT_WRAPPED &&
         murk_trace_may_jump(s->domain, event->direction_in))) {
        *meets = 1;
        return;
    }
    const murk_vec3 along =
        event->kind == MURK_EVENT_EMITTED
            ? murk_vec(0, 0, 0)
            : murk_scale(event->path_m, event->direction_in);
    *meets = murk_box_list_meet(&s->changed, murk_sub(event->position, along),
                                along);
}

/* True if the changed boxes fill so small a part of the cells that their
 * photons crossed that most listed photons meet no box. */
static bool selects(const updating *u, uint64_t cells,
                    const murk_box_list *changed)
{
    double filled = 0, listed = 0;
    for (size_t i = 0; i < changed->n; ++i) {
        filled += volume(&changed->box[i]);
    }
    for (; cells; cells &= cells - 1) {
        listed += volume(&u->earlier->cells->box) / MURK_PATH_CELLS;
    }
    return u->n > 0 && SELECT_BELOW * listed > filled;
}

/* Takes the photons from the list that start alike and whose path in the
 * earlier world meets no changed box: a cell is coarse, and to trace a photon
 * once more takes half the time of an update of it. */
static murk_status select_photons(updating *u, const murk_box_list *changed,
                                  murk_error *err)
{
    const murk_box *box = &u->stage->world.domain.box;
    const start_comparison c = compare_starts(u);
    const double size_m =
        sqrt(murk_dot(box->min, box->min)) + sqrt(murk_dot(box->max, box->max));
    selecting s = {.changed = *changed, .domain = &u->before->world.domain};
    murk_ledger *unused = NULL;
    murk_box_list_grow(&s.changed, SELECT_ROUNDING * size_m);
    s.meets = calloc(u->earlier->emitted + 1, 1);
    murk_status status =
        s.meets ? murk_ledger_create(&unused, &u->before->world, err)
                : murk_no_memory(err, "", "to update the light");
    if (!status) {
        /* Their paths. */
        murk_trace trace = trace_of(u, u->before);
        trace.tallies = NULL;
        trace.sink = select_event;
        trace.takes_any_order = true;
        trace.context = &s;
        murk_progress_begin("select", u->n, "photons");
        murk_trace_run(&trace, unused);
        murk_progress_end();
        status = murk_interrupt_check(err);
        const size_t n = u->n;
        u->n = 0;
        for (size_t k = 0; k < n; ++k) {
            const uint32_t photon = u->photon[k];
            if (s.meets[photon] ||
                (!c.are_all && !starts_alike(u, &c, photon))) {
                u->photon[u->n++] = photon;
            }
        }
    }
    murk_ledger_destroy(unused);
    free(s.meets);
    return status;
}

/* Finds what has changed and, if an update may pay (*can), prepares it. The
 * cells of *watched are to be noted if it does not. */
static murk_status begin(updating *u, bool *can, murk_box *watched,
                         uint32_t stream, murk_error *err)
{
    const murk_stage *stage = u->stage;
    const murk_box *domain = &stage->world.domain.box;
    murk_box_list changed;
    uint64_t cells = 0;
    murk_status status =
        murk_changed_world(&changed, u->before, stage, MURK_USE_LIGHT, err);
    *can = false;
    if (status) {
        return status;
    }
    *watched = surroundings(&changed, domain);
    /* Light from outside may be attenuated by all media on its way. */
    bool may = has_same_rules(u->before, stage, u->earlier, stream) &&
               !(stage->world.continues && (changed.n > 0 || changed.are_all));
    if (may) {
        may = murk_path_cells_of(&cells, u->earlier->cells, &changed, domain);
    }
    if (may) {
        status = prepare(u, cells, err);
        *can = !status && pays(u, watched);
    }
    /* Without sums a photon is traced once, as often as to select it. */
    return *can && stream == 0 && selects(u, cells, &changed)
               ? select_photons(u, &changed, err)
               : status;
}

static void end(updating *u)
{
    murk_record_buffers_destroy(u->buffers);
    murk_traced_destroy(u->traced);
    free(u->photon);
}

murk_status murk_lightmap_update(murk_traced **out, uint64_t *reused,
                                 const murk_stage *stage,
                                 const murk_traced *earlier,
                                 const murk_stage *earlier_stage,
                                 unsigned threads, murk_error *err)
{
    const double begun_s = murk_clock_s();
    updating u = {.stage = stage,
                  .before = earlier_stage,
                  .earlier = earlier,
                  .threads = threads};
    murk_box watched;
    bool can;
    *reused = 0;
    murk_status status = begin(&u, &can, &watched, 0, err);
    if (can) {
        status = update(&u, err);
    }
    /* Hand over, or trace all. */
    if (can && !status) {
        *reused = u.reused;
        u.traced->trace_s = murk_clock_s() - begun_s - u.traced->map_s;
        *out = u.traced;
        u.traced = NULL;
    }
    end(&u);
    return can || status ? status
                         : murk_lightmap_trace_watched(out, stage, &watched,
                                                       threads, err);
}

/* ---- light that is passed to a sink ---- */

/* Between the photons and the sink of the caller. */
typedef struct passing {
    murk_passed_light *light;
    bool keeps; /* the records are noted */
    murk_record_batch_sink each;
    void *context;
} passing;

/* Appends n records to a list. */
static murk_status put_all(murk_record_list *list, const murk_photon *photon,
                           size_t n, murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < n && !status; ++i) {
        status = murk_record_list_put(list, &photon[i], err);
    }
    return status;
}

/* A murk_record_batch_sink. */
static murk_status pass_on(void *context, const murk_record_batch *batch,
                           murk_error *err)
{
    const passing *p = context;
    murk_status status = MURK_OK;
    if (p->keeps) {
        status =
            put_all(&p->light->surface, batch->surface, batch->n_surface, err);
    }
    if (p->keeps && !status) {
        status =
            put_all(&p->light->volume, batch->volume, batch->n_volume, err);
    }
    return status ? status : p->each(p->context, batch, err);
}

/* The numbers of the records of a list by emitted photon, those of one photon
 * in the order in which they came; for free(). NULL when out of memory. */
static uint64_t *order_of(const murk_record_list *list)
{
    uint64_t *order = malloc(list->n * sizeof *order + 1);
    for (size_t i = 0; order && i < list->n; ++i) {
        order[i] = (uint64_t)murk_photon_emitted(&list->photon[i]) << 32 | i;
    }
    if (order) {
        murk_sort_uint64(order, list->n);
    }
    return order;
}

/* The records of one map while they are joined. */
typedef struct joining {
    const murk_record_list *before, *traced;
    const uint64_t *order;    /* of `traced` */
    size_t at_before, at_new; /* the next ones */
    murk_record_list *out;
} joining;

/* Appends the records of the photons below `end`: those that were traced now,
 * and of the other photons the earlier ones. */
static murk_status join_until(joining *j, const uint64_t *is_listed,
                              uint64_t end, murk_error *err)
{
    murk_status status = MURK_OK;
    while (!status) {
        const murk_photon *a = j->at_before < j->before->n
                                   ? &j->before->photon[j->at_before]
                                   : NULL;
        const murk_photon *b =
            j->at_new < j->traced->n
                ? &j->traced->photon[(uint32_t)j->order[j->at_new]]
                : NULL;
        const uint64_t of_a = a ? murk_photon_emitted(a) : UINT64_MAX,
                       of_b = b ? murk_photon_emitted(b) : UINT64_MAX;
        if ((of_a < of_b ? of_a : of_b) >= end) {
            break;
        }
        if (of_a <= of_b) { /* a photon with both is listed */
            ++j->at_before;
            if (!(is_listed[of_a / 64] >> (of_a % 64) & 1)) {
                status = murk_record_list_put(j->out, a, err);
            }
        } else {
            ++j->at_new;
            status = murk_record_list_put(j->out, b, err);
        }
    }
    return status;
}

/* Joins both maps batch by batch, and passes each batch to the sink. */
static murk_status join_batches(const updating *u, joining map[2],
                                const uint64_t *is_listed, const passing *p,
                                murk_error *err)
{
    const uint64_t emitted = u->traced->emitted;
    murk_status status = MURK_OK;
    for (uint64_t first = 0, k = 0; first < emitted && !status; ++k) {
        const uint64_t end = first + MURK_BATCH_PHOTONS < emitted
                                 ? first + MURK_BATCH_PHOTONS
                                 : emitted;
        const size_t n[2] = {map[0].out->n, map[1].out->n};
        /* The records of the batch follow those of the batches before. */
        status = join_until(&map[0], is_listed, end, err);
        if (!status) {
            status = join_until(&map[1], is_listed, end, err);
        }
        if (!status) {
            const murk_record_batch batch = {
                .number = k,
                .first = first,
                .last = end - 1,
                .surface = map[0].out->n ? map[0].out->photon + n[0] : NULL,
                .volume = map[1].out->n ? map[1].out->photon + n[1] : NULL,
                .n_surface = map[0].out->n - n[0],
                .n_volume = map[1].out->n - n[1]};
            status = p->each(p->context, &batch, err);
        }
        first = end;
    }
    return status;
}

/* Joins the records of the photons that were traced with the earlier ones. */
static murk_status join(const updating *u, const murk_passed_light *earlier,
                        const passing *p, murk_error *err)
{
    uint64_t *is_listed = list_bits(u),
             *surface = order_of(&u->buffers->surface),
             *volume = order_of(&u->buffers->volume);
    joining map[2] = {{.before = &earlier->surface,
                       .traced = &u->buffers->surface,
                       .order = surface,
                       .out = &p->light->surface},
                      {.before = &earlier->volume,
                       .traced = &u->buffers->volume,
                       .order = volume,
                       .out = &p->light->volume}};
    const murk_status status =
        is_listed && surface && volume
            ? join_batches(u, map, is_listed, p, err)
            : murk_no_memory(err, "", "for the photons that are traced again");
    free(is_listed);
    free(surface);
    free(volume);
    return status;
}

void murk_passed_light_release(murk_passed_light *light)
{
    murk_traced_destroy(light->traced);
    murk_record_list_release(&light->surface);
    murk_record_list_release(&light->volume);
    *light = (murk_passed_light){0};
}

/* True if a run of all photons might be refused for the number of records. */
static bool may_exceed(const updating *u, const murk_passed_light *earlier)
{
    return earlier->surface.n + earlier->volume.n + u->buffers->stored >
           u->stage->scene->photons.max_stored;
}

murk_status murk_lightmap_update_passed(
    murk_passed_light *out, const murk_stage *stage, uint32_t stream,
    const murk_passed_light *earlier, unsigned threads, double bytes_each,
    murk_record_batch_sink each, void *context, murk_error *err)
{
    const double begun_s = murk_clock_s();
    const passing p = {out, murk_can_watch(stage), each, context};
    updating u = {.stage = stage, .threads = threads};
    murk_box watched = stage->world.domain.box;
    murk_status status = MURK_OK;
    bool can = false;
    *out = (murk_passed_light){0};
    if (earlier && earlier->traced) {
        u.earlier = earlier->traced;
        u.before = earlier->stage;
        status = begin(&u, &can, &watched, stream, err);
    }
    if (can) {
        status = trace_again(&u, err);
        can = status || !may_exceed(&u, earlier);
    }
    if (can && !status) {
        status = join(&u, earlier, &p, err);
    }
    /* Hand over, or trace all. */
    if (can && !status) {
        u.traced->trace_s = murk_clock_s() - begun_s;
        out->traced = u.traced;
        u.traced = NULL;
    }
    end(&u);
    return can || status ? status
                         : murk_lightmap_pass(&out->traced, stage, stream,
                                              threads, bytes_each, pass_on,
                                              (void *)&p, &watched, err);
}
