/* The stored history of a path agrees, event by event, with a second trace of
 * the same photons. */
#include "calibrate/histories.h"
#include "check.h"
#include "lightmap/lightmap.h"
#include "stage_text.h"

#include <stdlib.h>

#define PHOTONS 12000
#define MEDIA   3

/* Two media overlap, a third takes the place of both in a ball of glass, a
 * wall stands in the way, and what leaves at one side comes back at the other.
 * The tallies are where the receivers are. */
static const char scene_text[] =
    "murk: 1\n"
    "bands_nm: [450, 550]\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3], sides: periodic}\n"
    "geometry:\n"
    "  - {rect: {corner_m: [0, 0, 0.5], edge1_m: [4, 0, 0],"
    " edge2_m: [0, 4, 0]}, material: floor}\n"
    "  - {sphere: {center_m: [3, 3, 1.5], radius_m: 0.3}, material: glass}\n"
    "materials: {floor: {diffuse: 0.7, specular: 0.1},"
    " glass: {transmit: 1, ior: 1.5}}\n"
    "media:\n"
    "  haze: {extinction_per_m: [0.4, 0.3], albedo: 0.9, phase: {hg: 0.8}}\n"
    "  smoke: {extinction_per_m: 1.5, albedo: 0.6, phase: {hg: 0.3}}\n"
    "  water: {extinction_per_m: 0.8, albedo: 0.8, phase: {hg: 0.9}}\n"
    "regions:\n"
    "  - {medium: haze}\n"
    "  - {medium: smoke, box: {min_m: [1, 1, 0], max_m: [3, 3, 2]}}\n"
    "  - {medium: water, sphere: {center_m: [2, 2, 2], radius_m: 0.6},"
    " ior: 1.33}\n"
    "lights:\n"
    "  - {type: point, position_m: [0.5, 1, 2.5], power_w: [8, 4]}\n"
    "  - {type: point, position_m: [2, 3, 1], power_w: 2}\n"
    "photons: {emit: 12000}\n"
    "tallies:\n"
    "  - {name: near, type: sphere, center_m: [1.4, 1.4, 1.4], radius_m: 0.3}\n"
    "  - {name: edge, type: sphere, center_m: [2.1, 2, 1.5], radius_m: 0.25,"
    " hemispheres: true}\n";

static const size_t reweighed_media[MEDIA] = {2, 0, 1};

static const murk_receiver receivers[] = {
    {{1.4, 1.4, 1.4}, 0.3, {0, 0, 0}, 0, -1},
    {{2.1, 2, 1.5}, 0.25, {0, 0, 0}, 0, -1},
    {{2.1, 2, 1.5}, 0.25, {0, 0, 1}, 0, -1},
    {{2.1, 2, 1.5}, 0.25, {0, 0, -1}, 0, 1},
    {{2.1, 2, 1.5}, 0.25, {0, 0, 1}, 0.8, -1},
    {{3, 3, 1.5}, 0.1, {0, 0, 0}, 0, -1}, /* in the glass */
};
#define RECEIVERS (sizeof receivers / sizeof receivers[0])

static murk_histories_desc desc_of(const murk_stage *stage)
{
    return (murk_histories_desc){.stage = stage,
                                 .threads = 2,
                                 .medium = reweighed_media,
                                 .media = MEDIA,
                                 .keeps_cosines = true,
                                 .receiver = receivers,
                                 .receivers = RECEIVERS,
                                 .keeps_records = true};
}

static murk_histories *follow(const murk_histories_desc *desc)
{
    murk_histories *followed = NULL;
    murk_error err = {0};
    CHECK(!murk_histories_trace(&followed, desc, &err));
    if (!followed) {
        printf("%s: %s\n", err.where, err.text);
    }
    return followed;
}

/* ---- records: what another trace tells of its events ---- */

typedef struct retrace {
    const murk_histories *followed;
    const murk_stage *stage;
    size_t next; /* contribution that the next record should be */
    uint64_t photon;
    double depth; /* of all media, since the lamp */
    uint32_t count[MEDIA], turns;
    size_t wrong_place, wrong_depth, wrong_count, wrong_turn, records;
} retrace;

/* Path times extinction over the re-weighted media: all there are. */
static double stored_depth(const retrace *t, size_t i, int band)
{
    double depth = 0;
    for (size_t m = 0; m < MEDIA; ++m) {
        depth += (double)t->followed->path_m[i * MEDIA + m] *
                 t->stage->scene->media[reweighed_media[m]]
                     .extinction_per_m.band[band];
    }
    return depth;
}

static size_t index_of(uint8_t medium)
{
    return medium == 2 ? 0 : medium == 0 ? 1 : 2;
}

static void receive_segment(void *context, uint64_t batch,
                            const murk_trace_segment *segment)
{
    retrace *t = context;
    (void)batch;
    t->depth += segment->is_in_solid
                    ? 0
                    : murk_media_optical_depth(
                          t->stage->media, segment->band, segment->inside,
                          segment->from, segment->direction, segment->length_m);
}

static void hear_record(retrace *t, const murk_event *event)
{
    const murk_histories *f = t->followed;
    /* Find the next contribution that is a record. */
    while (t->next < f->n &&
           !murk_contribution_is_record(&f->contribution[t->next])) {
        ++t->next;
    }
    if (t->next == f->n) {
        ++t->wrong_place;
        return;
    }
    /* The contribution belongs to the photon, band, light and map of the event,
     * and has the same value. */
    const size_t i = t->next++;
    const murk_contribution *c = &f->contribution[i];
    const bool is_volume = event->kind == MURK_EVENT_MEDIUM;
    ++t->records;
    t->wrong_place += c->photon != event->photon || c->band != event->band ||
                      c->light != event->light ||
                      c->receiver != (is_volume ? MURK_RECORD_OF_VOLUME
                                                : MURK_RECORD_OF_SURFACE) ||
                      (is_volume && c->medium != event->material_or_medium) ||
                      c->value != (float)event->leaving;
    /* Optical depth, collisions in each medium and turns are those of the
     * path. */
    t->wrong_depth +=
        !(fabs(stored_depth(t, i, c->band) - t->depth) <= 1e-6 * t->depth);
    for (size_t m = 0; m < MEDIA; ++m) {
        const bool is_own =
            is_volume && index_of(event->material_or_medium) == m;
        t->wrong_count += f->count[i * MEDIA + m] != t->count[m] + is_own;
    }
    t->wrong_turn += c->turns != t->turns;
}

static void receive_event(void *context, uint64_t batch,
                          const murk_event *event)
{
    retrace *t = context;
    (void)batch;
    if (event->kind == MURK_EVENT_EMITTED) {
        t->depth = 0;
        t->turns = 0;
        for (size_t m = 0; m < MEDIA; ++m) {
            t->count[m] = 0;
        }
        return;
    }
    const bool scatters = event->outcome == MURK_SCATTERED;
    if (scatters ||
        (event->kind == MURK_EVENT_SURFACE && event->outcome == MURK_DIFFUSE)) {
        hear_record(t, event);
    }
    if (scatters) {
        ++t->count[index_of(event->material_or_medium)];
        ++t->turns;
    }
}

static void test_records_know_their_paths(const murk_stage *stage,
                                          const murk_histories *followed)
{
    retrace t = {.followed = followed, .stage = stage};
    murk_ledger *ledger = NULL;
    murk_error err = {0};
    CHECK(!murk_ledger_create(&ledger, &stage->world, &err));
    murk_trace trace = murk_stage_trace(stage);
    trace.last = PHOTONS;
    trace.sink = receive_event;
    trace.segment_sink = receive_segment;
    trace.context = &t;
    murk_trace_run(&trace, ledger);
    CHECK(t.records > 20000);
    CHECK(t.wrong_place == 0);
    CHECK(t.wrong_depth == 0);
    CHECK(t.wrong_count == 0);
    CHECK(t.wrong_turn == 0);
    murk_ledger_destroy(ledger);
}

/* ---- maps ---- */

static void check_map(const murk_histories *followed,
                      const murk_photon_map *got, const murk_photon_map *want,
                      uint32_t kind)
{
    const size_t n = murk_photon_map_count(want);
    CHECK(murk_photon_map_count(got) == n && n > 100);
    size_t wrong = 0;
    for (size_t i = 0; i < n && murk_photon_map_count(got) == n; ++i) {
        murk_photon a = murk_photon_map_photons(got)[i];
        const murk_photon b = murk_photon_map_photons(want)[i];
        if (a.emitted >= followed->n ||
            followed->contribution[a.emitted].receiver != kind) {
            ++wrong;
            continue;
        }
        a.emitted = followed->contribution[a.emitted].photon;
        wrong += memcmp(&a, &b, sizeof a) != 0;
    }
    CHECK(wrong == 0);
}

static void test_maps_are_the_scenes(const murk_histories *followed,
                                     const murk_traced *traced)
{
    CHECK(followed->emitted == traced->emitted);
    check_map(followed, followed->surface, traced->surface,
              MURK_RECORD_OF_SURFACE);
    check_map(followed, followed->volume, traced->volume,
              MURK_RECORD_OF_VOLUME);
}

/* ---- chords ---- */

/* W/m2 of a receiver in a band. */
static double reading(const murk_histories *f, size_t receiver, int band)
{
    double sum = 0;
    for (size_t i = 0; i < f->n; ++i) {
        const murk_contribution *c = &f->contribution[i];
        if (c->receiver == receiver && c->band == band) {
            sum += (double)c->value * f->packet_w[c->light * 2u + c->band];
        }
    }
    const double r = receivers[receiver].radius_m;
    return sum / (4. / 3 * MURK_PI * r * r * r);
}

static double tallied(const murk_traced *traced, size_t tally, int band,
                      size_t cell)
{
    return murk_tallies_read(traced->tallies, tally, band, cell,
                             traced->ledger->emitted, traced->packet_w)
        .value;
}

static void test_receivers_agree_with_tallies(const murk_histories *f,
                                              const murk_traced *traced)
{
    for (int band = 0; band < 2; ++band) {
        const double near = tallied(traced, 0, band, 0);
        const double edge =
            tallied(traced, 1, band, 0) + tallied(traced, 1, band, 1);
        CHECK(near > 0 && edge > 0);
        CHECK_NEAR(reading(f, 0, band), near, 1e-6 * near);
        CHECK_NEAR(reading(f, 1, band), edge, 1e-6 * edge);
    }
    CHECK(reading(f, 5, 0) > 0);
    /* a side takes a part; a cone a part of that; a band is a band */
    CHECK(reading(f, 2, 1) + reading(f, 3, 1) < reading(f, 1, 1));
    CHECK(reading(f, 4, 1) < reading(f, 2, 1) && reading(f, 4, 1) > 0);
    CHECK(reading(f, 3, 0) == 0 && reading(f, 3, 1) > 0);
}

/* In glass there are no media; in the ball only the one that has replaced the
 * others; each photon's chords and records follow one another. */
static void test_chords_know_their_media(const murk_histories *f)
{
    size_t wrong = 0, seen = 0, unordered = 0;
    for (size_t i = 0; i < f->n; ++i) {
        const murk_contribution *c = &f->contribution[i];
        const float *chord = f->chord_m + i * MEDIA;
        if (i > 0 && f->contribution[i - 1].photon == c->photon) {
            const murk_contribution *before = c - 1;
            unordered += before->first != c->first || before->turns > c->turns;
            for (size_t m = 0; m < MEDIA; ++m) {
                unordered += f->path_m[(i - 1) * MEDIA + m] >
                             f->path_m[i * MEDIA + m] + 1e-5F;
            }
        } else if (i > 0) {
            unordered += f->contribution[i - 1].photon > c->photon;
        }
        if (c->receiver == 5) {
            ++seen;
            wrong += chord[0] != 0 || chord[1] != 0 || chord[2] != 0;
        } else if (c->receiver == 0) { /* the haze and the smoke, alike */
            ++seen;
            wrong += !(chord[0] == 0 && fabsf(chord[1] - chord[2]) < 1e-6F &&
                       fabsf(chord[1] - c->value) < 1e-6F);
        }
    }
    CHECK(seen > 100);
    CHECK(wrong == 0);
    CHECK(unordered == 0);
}

/* ---- how much is kept ---- */

static bool are_same(const murk_histories *a, const murk_histories *b)
{
    const size_t media = a->media;
    return a->n == b->n && a->turns == b->turns && a->emitted == b->emitted &&
           !memcmp(a->contribution, b->contribution,
                   a->n * sizeof *a->contribution) &&
           !memcmp(a->path_m, b->path_m, a->n * media * sizeof *a->path_m) &&
           !memcmp(a->chord_m, b->chord_m, a->n * media * sizeof *a->path_m) &&
           !memcmp(a->count, b->count, a->n * media * sizeof *a->count) &&
           !memcmp(a->turn, b->turn, a->turns * sizeof *a->turn) &&
           !memcmp(a->turn_medium, b->turn_medium, a->turns);
}

static void test_threads_do_not_matter(const murk_stage *stage,
                                       const murk_histories *two)
{
    murk_histories_desc desc = desc_of(stage);
    for (unsigned threads = 1; threads < 6; threads += 4) {
        desc.threads = threads;
        murk_histories *other = follow(&desc);
        CHECK(other && are_same(other, two));
        murk_histories_destroy(other);
    }
}

/* A number of its own, and the first of more are the same. */
static void test_photons_may_be_asked_for(const murk_stage *stage,
                                          const murk_histories *all)
{
    murk_histories_desc desc = desc_of(stage);
    desc.photons = 1500;
    murk_histories *f = follow(&desc);
    if (f) {
        CHECK(f->emitted == 1500 && f->n < all->n && f->turns < all->turns);
        CHECK(!memcmp(f->contribution, all->contribution,
                      f->n * sizeof *f->contribution));
        CHECK(all->contribution[f->n].photon >= 1500);
        CHECK(f->emitted_in[0] + f->emitted_in[1] + f->emitted_in[2] +
                  f->emitted_in[3] ==
              1500);
    }
    murk_histories_destroy(f);
}

static void test_fewer_histories_may_be_stored(const murk_stage *stage,
                                               const murk_histories *all)
{
    murk_histories_desc desc = desc_of(stage);
    desc.keeps_cosines = false;
    desc.keeps_records = false;
    desc.media = 1;
    murk_histories *f = follow(&desc);
    if (f) {
        CHECK(f->turns == 0 && !f->surface && !f->volume);
        size_t j = 0, wrong = 0;
        for (size_t i = 0; i < all->n; ++i) {
            if (!murk_contribution_is_record(&all->contribution[i])) {
                wrong +=
                    j >= f->n ||
                    f->contribution[j].value != all->contribution[i].value ||
                    f->path_m[j] != all->path_m[i * MEDIA];
                ++j;
            }
        }
        CHECK(j == f->n && wrong == 0);
    }
    murk_histories_destroy(f);
}

/* Also where no record is kept, as many photons go out as the scene's `store`
 * takes. */
static void test_store_says_how_many(void)
{
    const char *const overrides[] = {"photons.store=4000", NULL};
    murk_stage *stage = stage_text_create(scene_text, overrides);
    if (!stage) {
        CHECK(false);
        return;
    }
    murk_histories_desc desc = desc_of(stage);
    murk_histories *f = follow(&desc);
    desc.keeps_records = false;
    murk_histories *bare = follow(&desc);
    murk_traced *traced = NULL;
    murk_error err = {0};
    CHECK(!murk_lightmap_trace(&traced, stage, 0, 2, &err));
    if (f && bare && traced) {
        test_maps_are_the_scenes(f, traced);
        CHECK(bare->emitted == f->emitted && bare->n < f->n);
    }
    murk_histories_destroy(f);
    murk_histories_destroy(bare);
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
}

/* ---- refusals ---- */

static void test_refusals(const murk_stage *stage)
{
    murk_histories_desc desc = desc_of(stage);
    murk_histories *f = NULL;
    /* Less memory than the light needs. */
    murk_error err = {0};
    desc.memory_max_bytes = 1e5;
    CHECK(murk_histories_trace(&f, &desc, &err) == MURK_BAD_VALUE && !f);
    CHECK_MENTIONS(err.text, "must be at most 0.0001 GB");

    /* Fewer photons than the smallest number. */
    desc = desc_of(stage);
    desc.photons = 3;
    err = (murk_error){0};
    CHECK(murk_histories_trace(&f, &desc, &err) == MURK_BAD_VALUE && !f);
    CHECK_MENTIONS(err.text, "must be at least 4");

    /* A scene in which all lights are dark. */
    const char *const dark[] = {"lights.0.power_w=0", "lights.1.power_w=0",
                                NULL};
    murk_stage *night = stage_text_create(scene_text, dark);
    if (night) {
        desc = desc_of(night);
        err = (murk_error){0};
        CHECK(murk_histories_trace(&f, &desc, &err) == MURK_BAD_VALUE && !f);
        CHECK_MENTIONS(err.text, "all lights are dark");
    }
    stage_text_destroy(night);
}

int main(void)
{
    murk_stage *stage = stage_text_create(scene_text, NULL);
    const murk_histories_desc desc = desc_of(stage);
    murk_histories *followed = stage ? follow(&desc) : NULL;
    murk_traced *traced = NULL;
    murk_error err = {0};
    CHECK(stage && !murk_lightmap_trace(&traced, stage, 0, 2, &err));
    if (followed && traced) {
        test_records_know_their_paths(stage, followed);
        test_maps_are_the_scenes(followed, traced);
        test_receivers_agree_with_tallies(followed, traced);
        test_chords_know_their_media(followed);
        test_threads_do_not_matter(stage, followed);
        test_photons_may_be_asked_for(stage, followed);
        test_fewer_histories_may_be_stored(stage, followed);
        test_store_says_how_many();
        test_refusals(stage);
    }
    murk_histories_destroy(followed);
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
    return check_done();
}
