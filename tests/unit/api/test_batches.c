/* Batches that are handed over while light is traced: in the order of photons,
 * without gaps, and together the records of the light to the bit, for any
 * number of threads; a batch that cancels ends the trace. */
#include "check.h"
#include "murk.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* 20 batches, the last of them short; the second half of the room is fog. */
static const char scene_text[] =
    "murk: 1\n"
    "bands_nm: [450, 650]\n"
    "domain: {min_m: [0, 0, 0], max_m: [8, 6, 3]}\n"
    "geometry: [{box: {min_m: [0, 0, 0], max_m: [8, 6, 3]}}]\n"
    "materials: {default: {diffuse: [0.6, 0.4]}}\n"
    "media: {fog: {extinction_per_m: 0.2, albedo: 0.9, phase: {hg: 0.7}}}\n"
    "regions: [{medium: fog, box: {min_m: [4, 0, 0], max_m: [8, 6, 3]}}]\n"
    "lights:\n"
    "  - {type: point, position_m: [2, 3, 2], power_w: [2, 1]}\n"
    "  - {type: point, position_m: [6, 3, 2], power_w: 7}\n";

#define EMIT        "20000"
#define STORE       "30000"
#define MAX_RECORDS 200000

/* All values of a record, without padding. */
typedef struct record {
    float position_m[3], direction[3], normal[3], power_w;
    uint32_t emitted, numbers; /* band, light, material, event class */
} record;

typedef struct records {
    record *of; /* [MAX_RECORDS] */
    size_t n;
} records;

typedef struct stream {
    records map[2];
    uint64_t batches, photons; /* next number of each */
    uint64_t last_size;        /* photons of the last batch */
    uint64_t cancel_at;        /* number of the batch that cancels */
    bool is_ordered, is_short;
} stream;

static const char *const fields[] = {"position_m", "direction", "normal",
                                     "power_w",    "emitted",   "band",
                                     "light",      "material",  "event_class"};
#define FIELDS (sizeof fields / sizeof *fields)

static const void *element(const murk_array *view, size_t i)
{
    return (const char *)view->data + (ptrdiff_t)i * view->stride[0];
}

/* Record i of the views of all fields. */
static record record_of(const murk_array view[FIELDS], size_t i)
{
    record r;
    memcpy(r.position_m, element(&view[0], i), sizeof r.position_m);
    memcpy(r.direction, element(&view[1], i), sizeof r.direction);
    memcpy(r.normal, element(&view[2], i), sizeof r.normal);
    memcpy(&r.power_w, element(&view[3], i), sizeof r.power_w);
    memcpy(&r.emitted, element(&view[4], i), sizeof r.emitted);
    unsigned char numbers[4];
    for (size_t k = 0; k < 4; ++k) {
        memcpy(&numbers[k], element(&view[5 + k], i), 1);
    }
    memcpy(&r.numbers, numbers, sizeof r.numbers);
    return r;
}

static int receive(void *user, murk_batch *batch)
{
    stream *s = user;
    uint64_t photons[2];
    murk_batch_photons(batch, photons);
    s->is_ordered &= murk_batch_number(batch) == s->batches++ &&
                     photons[0] == s->photons && photons[1] >= photons[0];
    s->photons = photons[1] + 1;
    s->last_size = photons[1] + 1 - photons[0];
    /* Copy the records of both maps; photons do not fall back. */
    for (int map = 0; map < 2; ++map) {
        murk_array view[FIELDS];
        const size_t n = murk_batch_count(batch, (murk_map)map);
        records *all = &s->map[map];
        for (size_t k = 0; k < FIELDS; ++k) {
            view[k] = (murk_array){.size = sizeof view[k]};
            CHECK(!murk_batch_array(batch, (murk_map)map, fields[k], &view[k],
                                    NULL) &&
                  view[k].shape[0] == n);
        }
        uint64_t emitted = photons[0];
        for (size_t i = 0; i < n && all->n < MAX_RECORDS; ++i) {
            const record r = record_of(view, i);
            s->is_ordered &= r.emitted >= emitted && r.emitted <= photons[1];
            emitted = r.emitted;
            all->of[all->n++] = r;
        }
        CHECK(murk_batch_array(batch, (murk_map)map, "no_such_field", &view[0],
                               NULL) == MURK_BAD_VALUE);
    }
    return s->batches > s->cancel_at;
}

static int compare(const void *a, const void *b)
{
    return memcmp(a, b, sizeof(record));
}

static void check_map(const murk_light *light, records *streamed,
                      const records *stored, bool has_shares)
{
    CHECK(streamed->n == stored->n && stored->n > 1000);
    for (size_t i = 0; has_shares && i < streamed->n; ++i) {
        record *r = &streamed->of[i];
        unsigned char numbers[4];
        memcpy(numbers, &r->numbers, sizeof numbers);
        r->power_w =
            (float)((double)r->power_w *
                    murk_light_packet_w(light, numbers[1], numbers[0]));
    }
    qsort(streamed->of, streamed->n, sizeof(record), compare);
    qsort(stored->of, stored->n, sizeof(record), compare);
    CHECK(memcmp(streamed->of, stored->of, stored->n * sizeof(record)) == 0);
}

static records read_map(murk_light *light, murk_map map)
{
    records out = {calloc(MAX_RECORDS, sizeof(record)), 0};
    murk_array view[FIELDS];
    for (size_t k = 0; k < FIELDS; ++k) {
        view[k] = (murk_array){.size = sizeof view[k]};
        CHECK(!murk_light_array(light, map, fields[k], &view[k], NULL));
    }
    const size_t n = murk_light_count(light, map);
    CHECK(out.of && n <= MAX_RECORDS);
    while (out.of && out.n < n && out.n < MAX_RECORDS) {
        out.of[out.n] = record_of(view, out.n);
        ++out.n;
    }
    return out;
}

static stream make_stream(uint64_t cancel_at)
{
    stream s = {.is_ordered = true, .cancel_at = cancel_at};
    for (int map = 0; map < 2; ++map) {
        s.map[map].of = calloc(MAX_RECORDS, sizeof(record));
        CHECK(s.map[map].of != NULL);
    }
    return s;
}

static void free_stream(stream *s)
{
    free(s->map[0].of);
    free(s->map[1].of);
}

/* A world with photons.emit or photons.store. */
static murk_world *make_world(murk_context *context, const char *key,
                              const char *value)
{
    murk_error error = MURK_ERROR_NONE;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    CHECK(!murk_scene_parse(&scene, context, scene_text, "room", &error));
    CHECK(!murk_scene_set(scene, key, value, &error));
    CHECK(!murk_world_create(&world, scene, &error));
    if (error.code) {
        printf("%s: %s\n", error.where, error.text);
    }
    murk_scene_destroy(scene);
    return world;
}

static void test_batches_are_the_records_of_the_light(unsigned threads,
                                                      bool is_store)
{
    const murk_context_options options = {.size = sizeof options,
                                          .threads = threads};
    murk_context *context = NULL;
    murk_light *light = NULL;
    stream s = make_stream(UINT64_MAX);
    CHECK(!murk_context_create(&context, &options, NULL));
    murk_world *world = is_store ? make_world(context, "photons.store", STORE)
                                 : make_world(context, "photons.emit", EMIT);
    CHECK(!murk_light_stream(&light, world, receive, &s, NULL));
    CHECK(s.is_ordered);
    /* All photons of the light and no other are in a batch. */
    const murk_fields *ledger = NULL;
    int64_t emitted = 0;
    CHECK(!murk_light_fields(light, &ledger, NULL) &&
          !murk_fields_int64(ledger, "photons_emitted", &emitted, NULL));
    CHECK(s.photons == (uint64_t)emitted && s.last_size < 1024);
    for (int map = 0; map < 2; ++map) {
        records stored = read_map(light, (murk_map)map);
        check_map(light, &s.map[map], &stored, is_store);
        free(stored.of);
    }
    murk_light_destroy(light);
    murk_world_destroy(world);
    murk_context_destroy(context);
    free_stream(&s);
}

/* Of the 20 batches four are received, *out is NULL, and the world traces once
 * more. The address sanitizer finds what a cancelled trace leaks. */
static void test_a_batch_cancels(void)
{
    murk_context *context = NULL;
    murk_light *light = (void *)&context;
    murk_error error = MURK_ERROR_NONE;
    stream s = make_stream(3);
    CHECK(!murk_context_create(&context, NULL, NULL));
    murk_world *world = make_world(context, "photons.emit", EMIT);
    CHECK(murk_light_stream(&light, world, receive, &s, &error) ==
          MURK_INTERRUPTED);
    CHECK(!light && s.batches == 4 && error.code == MURK_INTERRUPTED);
    CHECK(!murk_light_trace(&light, world, NULL) && light);
    CHECK(isnan(murk_light_packet_w(light, 2, 0)) &&
          isnan(murk_light_packet_w(light, 0, 2)) &&
          isnan(murk_light_packet_w(light, -1, 0)));
    murk_light_destroy(light);
    murk_world_destroy(world);
    murk_context_destroy(context);
    free_stream(&s);
}

int main(void)
{
    static const unsigned threads[] = {1, 2, 5};
    for (size_t i = 0; i < 3; ++i) {
        test_batches_are_the_records_of_the_light(threads[i], false);
        test_batches_are_the_records_of_the_light(threads[i], true);
    }
    test_a_batch_cancels();
    return check_done();
}
