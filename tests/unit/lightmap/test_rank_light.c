/* Ranks that divide the batches of waves give the light of one rank in every
 * bit: records, ledger, tallies and powers of packets, on all ranks, with any
 * number of threads. An exchange that loses a rank's sums or changes a bit of
 * its records does not. Seeds are fixed. */
#include "base/log.h"
#include "check.h"
#include "lightmap/lightmap.h"
#include "same_light.h"
#include "stage_text.h"
#include "thread_ranks.h"

#include <stdlib.h>
#include <unistd.h>

/* A room with fog, two bands and two lights, of which one has no power in one
 * band. */
#define SCENE                                                             \
    "murk: 1\n"                                                           \
    "domain: {min_m: [0, 0, 0], max_m: [3, 2, 1]}\n"                      \
    "bands_nm: [500, 600]\n"                                              \
    "geometry: [{rect: {corner_m: [0.1, 0.1, 0.1], edge1_m: [2.8, 0, 0]," \
    " edge2_m: [0, 1.8, 0]}, material: wall}]\n"                          \
    "materials: {wall: {diffuse: 0.5}}\n"                                 \
    "media: {fog: {extinction_per_m: 1, albedo: 0.9}}\n"                  \
    "regions: [{medium: fog}]\n"                                          \
    "lights:\n"                                                           \
    "  - {type: point, position_m: [1, 1, 0.5], power_w: [6, 2]}\n"       \
    "  - {type: point, position_m: [2, 1, 0.5], power_w: [0, 2]}\n"       \
    "seed: 3\n"                                                           \
    "photons: {emit: 20000}\n"

static const char without_tallies[] = SCENE;
static const char with_tallies[] =
    SCENE "tallies:\n"
          "  - {name: grid, type: grid, min_m: [0, 0, 0],"
          " max_m: [3, 2, 1], size: [5, 4, 3]}\n"
          "  - {name: ball, type: sphere, center_m: [1.5, 1, 0.5],"
          " radius_m: 0.4}\n"
          "  - {name: plane, type: plane, point_m: [0, 0, 0.5],"
          " normal: [0, 0, 1], angle_bins: 2}\n";

static const char *const by_emit[] = {"photons={emit: 20000}", NULL};
/* Fewer batches than ranks. */
static const char *const by_few[] = {"photons={emit: 1500}", NULL};
static const char *const by_store[] = {"photons={store: 30000}", NULL};
/* Photons behind the last one fill more than one batch. */
static const char *const by_many[] = {"photons={store: 150000}", NULL};
static const char *const no_maps[] = {"photons={emit: 9000, maps: none}", NULL};

/* Every wave but the last ends with a checkpoint. */
#define EVERY_S 1e-9

typedef struct job {
    const murk_stage *stage;
    uint32_t stream;
    unsigned threads;
    const char *checkpoint; /* NULL: none */
    bool in_first;          /* rank 0 alone keeps the records */
    murk_traced *light[THREAD_RANKS_MAX];
} job;

static murk_status trace(void *context, unsigned number, murk_error *err)
{
    job *j = context;
    murk_warn_to(NULL); /* of light that escapes */
    murk_ranks_keep_in_first(j->in_first);
    return j->checkpoint
               ? murk_lightmap_resume(&j->light[number], j->stage, j->threads,
                                      j->checkpoint, EVERY_S, err)
               : murk_lightmap_trace(&j->light[number], j->stage, j->stream,
                                     j->threads, err);
}

/* Traces without ranks. */
static murk_status trace_alone(murk_traced **out, const job *j, murk_error *err)
{
    return murk_lightmap_trace(out, j->stage, j->stream, j->threads, err);
}

static bool is_empty(const murk_photon_map *map)
{
    return !map || murk_photon_map_count(map) == 0;
}

/* Whether a rank is on the machine of rank 0, with which it then shares the
 * maps, even if rank 0 alone keeps the records. */
static bool is_beside_first(unsigned rank, unsigned count)
{
    return thread_ranks_here(count, rank).first == 0;
}

/* The maps have the same records, and range queries, which read bounding boxes,
 * find as many of them. */
static bool same_queries(const murk_photon_map *a, const murk_photon_map *b)
{
    bool is_same = same_map(a, b);
    for (size_t i = 0; i < murk_photon_map_count(a) && is_same; i += 97) {
        const murk_vec3 at = murk_photon_place(&murk_photon_map_photons(a)[i]);
        is_same = murk_photon_map_count_within(a, at, 0.3) ==
                  murk_photon_map_count_within(b, at, 0.3);
    }
    return is_same;
}

/* Traces in ranks. *same_sums: all ranks have the ledger and the tallies of
 * `whole`; *same_records: its packets and its maps, which other machines than
 * that of rank 0 may lack. */
static void compare(const murk_traced *whole, const job *settings,
                    unsigned count, thread_ranks_defect defect, bool *same_sums,
                    bool *same_records)
{
    job j = *settings;
    const thread_ranks_end end = thread_ranks_run(count, defect, trace, &j);
    *same_sums = *same_records = thread_ranks_succeeded(&end, count);
    for (unsigned r = 0; r < count; ++r) {
        const murk_traced *light = j.light[r];
        if (!light) {
            *same_sums = *same_records = false;
            continue;
        }
        *same_sums = *same_sums && same_ledger(whole->ledger, light->ledger) &&
                     same_tallies(whole->tallies, light->tallies);
        *same_records =
            *same_records && same_packets(whole, light) &&
            (j.in_first && !is_beside_first(r, count)
                 ? is_empty(light->surface) && is_empty(light->volume)
                 : same_queries(whole->surface, light->surface) &&
                       same_queries(whole->volume, light->volume));
        murk_traced_destroy(j.light[r]);
    }
}

static void test_ranks_give_the_light_of_one(const char *text,
                                             const char *const *overrides,
                                             uint32_t stream)
{
    static const unsigned counts[] = {1, 2, 3, 5};
    /* The light without ranks. */
    murk_stage *stage = stage_text_create(text, overrides);
    job j = {.stage = stage, .stream = stream, .threads = 1};
    murk_traced *whole = NULL;
    murk_error err = {0};
    if (!stage || trace_alone(&whole, &j, &err)) {
        CHECK(false);
        stage_text_destroy(stage);
        return;
    }
    CHECK((whole->tallies != NULL) == (text == with_tallies && stream == 0));
    /* That of ranks. */
    for (size_t c = 0; c < sizeof counts / sizeof *counts; ++c) {
        for (j.threads = 1; j.threads <= 2; ++j.threads) {
            bool same_sums, same_records;
            j.in_first = j.threads == 2; /* each way once */
            compare(whole, &j, counts[c], THREAD_RANKS_SOUND, &same_sums,
                    &same_records);
            CHECK(same_sums);
            CHECK(same_records);
        }
    }
    murk_traced_destroy(whole);
    stage_text_destroy(stage);
}

static void test_a_wrong_exchange_is_noticed(void)
{
    murk_stage *stage = stage_text_create(with_tallies, by_emit);
    const job j = {.stage = stage, .threads = 1};
    murk_traced *whole = NULL;
    murk_error err = {0};
    bool same_sums = true, same_records = false;
    if (!stage || trace_alone(&whole, &j, &err)) {
        CHECK(false);
        stage_text_destroy(stage);
        return;
    }
    /* The records are exchanged apart from the sums. */
    compare(whole, &j, 3, THREAD_RANKS_LOSE_WORDS, &same_sums, &same_records);
    CHECK(!same_sums && same_records);
    compare(whole, &j, 3, THREAD_RANKS_LOSE_CARRY, &same_sums, &same_records);
    CHECK(!same_sums && same_records);
    compare(whole, &j, 3, THREAD_RANKS_FLIP_BIT, &same_sums, &same_records);
    CHECK(same_sums && !same_records);
    murk_traced_destroy(whole);
    stage_text_destroy(stage);
}

/* Ranks leave a checkpoint, from which other numbers of ranks go on. */
static void test_ranks_go_on_from_a_checkpoint(const char *const *overrides)
{
    static const unsigned counts[] = {3, 1, 2, 5};
    char path[] = "/tmp/murk-checkpoint-XXXXXX";
    const int file = mkstemp(path);
    murk_stage *stage = stage_text_create(with_tallies, overrides);
    job j = {.stage = stage, .threads = 1};
    murk_traced *whole = NULL;
    murk_error err = {0};
    if (file < 0 || !stage || trace_alone(&whole, &j, &err)) {
        CHECK(false);
        stage_text_destroy(stage);
        return;
    }
    /* The first ranks find no checkpoint. */
    close(file);
    unlink(path);
    j.checkpoint = path;
    for (size_t c = 0; c < sizeof counts / sizeof *counts; ++c) {
        bool same_sums, same_records;
        compare(whole, &j, counts[c], THREAD_RANKS_SOUND, &same_sums,
                &same_records);
        CHECK(same_sums);
        CHECK(same_records);
        CHECK(access(path, R_OK) == 0);
    }
    unlink(path);
    murk_traced_destroy(whole);
    stage_text_destroy(stage);
}

/* A failure before the trace ends all ranks with the same message. */
static murk_status trace_or_fail(void *context, unsigned number,
                                 murk_error *err)
{
    return number == 1 ? murk_fail(err, MURK_RUN_FAILED, "rank 1", "has failed")
                       : trace(context, number, err);
}

static void test_a_rank_that_fails_ends_all(void)
{
    murk_stage *stage = stage_text_create(with_tallies, by_emit);
    job j = {.stage = stage, .threads = 2};
    const thread_ranks_end end =
        thread_ranks_run(3, THREAD_RANKS_SOUND, trace_or_fail, &j);
    for (unsigned r = 0; r < 3; ++r) {
        CHECK(end.status[r] == MURK_RUN_FAILED && !j.light[r]);
        CHECK_TEXT(end.error[r].where, "rank 1");
        CHECK_TEXT(end.error[r].text, "has failed");
    }
    stage_text_destroy(stage);
}

int main(void)
{
    murk_warn_to(NULL);
    test_ranks_give_the_light_of_one(with_tallies, by_emit, 0);
    test_ranks_give_the_light_of_one(without_tallies, by_emit, 0);
    test_ranks_give_the_light_of_one(with_tallies, by_emit, 2);
    test_ranks_give_the_light_of_one(with_tallies, by_few, 0);
    test_ranks_give_the_light_of_one(with_tallies, by_store, 0);
    test_ranks_give_the_light_of_one(without_tallies, by_many, 0);
    test_ranks_give_the_light_of_one(with_tallies, no_maps, 0);
    /* Records in scratch files, which the ranks of a machine share. */
    CHECK(setenv("MURK_MEMORY_MB", "0", 1) == 0);
    test_ranks_give_the_light_of_one(with_tallies, by_store, 0);
    CHECK(unsetenv("MURK_MEMORY_MB") == 0);
    test_ranks_go_on_from_a_checkpoint(by_store);
    test_ranks_go_on_from_a_checkpoint(by_many);
    test_a_wrong_exchange_is_noticed();
    test_a_rank_that_fails_ends_all();
    return check_done();
}
