/* Parts of light: any number of shards, with any number of threads, read in any
 * order, gives the light of an undivided run in every bit: records, ledger,
 * tallies and powers of packets; also if parts are missing. Parts of other
 * scenes, damaged parts and parts that differ are refused. Seeds are fixed. */
#include "base/log.h"
#include "check.h"
#include "lightmap/light_part_trace.h"
#include "lightmap/lightmap.h"
#include "photonmap/map_file.h"
#include "same_light.h"
#include "stage_text.h"

#include <stdlib.h>
#include <unistd.h>

enum { PATH_SIZE = 128, PARTS_MAX = 7 };

static char folder[] = "/tmp/murk-parts-XXXXXX";

/* A room with fog, two bands and two lights, of which one has no power in one
 * band, and a tally of each type. */
static const char text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [3, 2, 1]}\n"
    "bands_nm: [500, 600]\n"
    "geometry: [{rect: {corner_m: [0.1, 0.1, 0.1], edge1_m: [2.8, 0, 0],"
    " edge2_m: [0, 1.8, 0]}, material: wall}]\n"
    "materials: {wall: {diffuse: 0.5}}\n"
    "media: {fog: {extinction_per_m: 1, albedo: 0.9}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: point, position_m: [1, 1, 0.5], power_w: [6, 2]}\n"
    "  - {type: point, position_m: [2, 1, 0.5], power_w: [0, 2]}\n"
    "tallies:\n"
    "  - {name: grid, type: grid, min_m: [0, 0, 0],"
    " max_m: [3, 2, 1], size: [5, 4, 3]}\n"
    "  - {name: plane, type: plane, point_m: [0, 0, 0.5], normal: [0, 0, 1]}\n"
    "photons: {emit: 20000}\n"
    "seed: 3\n";

static const char *const by_emit[] = {"photons={emit: 20000}", NULL};
static const char *const by_few[] = {"photons={emit: 1500}", NULL};
static const char *const by_store[] = {"photons={store: 30000}", NULL};
/* Photons behind the last one fill more than one batch. */
static const char *const by_many[] = {"photons={store: 150000}", NULL};
static const char *const no_maps[] = {"photons={emit: 9000, maps: none}", NULL};
static const char *const other_seed[] = {"photons={emit: 20000}", "seed=4",
                                         NULL};

static const char *path_of(uint32_t number, uint32_t count)
{
    static char path[PARTS_MAX][PATH_SIZE];
    char *out = path[number - 1];
    snprintf(out, PATH_SIZE, "%s/%u-of-%u", folder, number, count);
    return out;
}

static void write_parts(const murk_stage *stage, uint32_t count)
{
    for (uint32_t k = 1; k <= count; ++k) {
        murk_error err = {0};
        CHECK(murk_light_part_trace(stage, (murk_shard){k, count}, 1 + k % 2,
                                    path_of(k, count), &err) == MURK_OK);
        CHECK_TEXT(err.text, "");
    }
}

static murk_status merge(murk_traced **out, const murk_stage *stage,
                         const char *const *path, size_t n, murk_error *err)
{
    murk_light_parts *parts = NULL;
    murk_status status = murk_light_parts_read(&parts, path, n, stage, err);
    if (!status) {
        status = murk_lightmap_merge(out, stage, parts, 2, err);
    }
    murk_light_parts_destroy(parts);
    return status;
}

static void check_same(const murk_traced *whole, const murk_traced *merged)
{
    if (!merged) {
        CHECK(false);
        return;
    }
    CHECK(same_packets(whole, merged));
    CHECK(same_ledger(whole->ledger, merged->ledger));
    CHECK(same_tallies(whole->tallies, merged->tallies));
    CHECK(same_map(whole->surface, merged->surface));
    CHECK(same_map(whole->volume, merged->volume));
}

/* All parts in falling order, the first one twice; and without part 2. */
static void test_parts_are_the_whole(const char *const *overrides,
                                     const uint32_t *counts, size_t n)
{
    murk_stage *stage = stage_text_create(text, overrides);
    murk_traced *whole = NULL;
    murk_error err = {0};
    if (!stage || murk_lightmap_trace(&whole, stage, 0, 2, &err)) {
        CHECK(false);
        return;
    }
    for (size_t c = 0; c < n; ++c) {
        const uint32_t count = counts[c];
        const char *path[PARTS_MAX + 1];
        murk_traced *merged = NULL;
        /* All parts. */
        write_parts(stage, count);
        for (uint32_t k = 0; k < count; ++k) {
            path[k] = path_of(count - k, count);
        }
        path[count] = path_of(1, count);
        CHECK(!merge(&merged, stage, path, count + 1, &err));
        CHECK_TEXT(err.text, "");
        check_same(whole, merged);
        murk_traced_destroy(merged);
        /* Without part 2. */
        if (count > 2) {
            path[count - 2] = path_of(1, count);
            merged = NULL;
            CHECK(!merge(&merged, stage, path, count, &err));
            check_same(whole, merged);
            murk_traced_destroy(merged);
        }
    }
    murk_traced_destroy(whole);
    stage_text_destroy(stage);
}

/* The message of a merge that is refused. */
static murk_error refusal(const murk_stage *stage, const char *const *path,
                          size_t n)
{
    murk_traced *merged = NULL;
    murk_error err = {0};
    CHECK(merge(&merged, stage, path, n, &err) != MURK_OK && !merged);
    return err;
}

static void test_other_parts_are_refused(void)
{
    murk_stage *stage = stage_text_create(text, by_emit);
    murk_stage *other = stage_text_create(text, other_seed);
    const char *path[2] = {path_of(1, 2), path_of(2, 2)};
    write_parts(stage, 2);
    /* Another seed, and another number of shards. */
    murk_error err = refusal(other, path, 2);
    CHECK_TEXT(err.where, path[0]);
    CHECK_MENTIONS(err.text, "made for another scene: it has \"seed: 3\"");
    CHECK_MENTIONS(err.text, "the scene has \"seed: 4\"");
    write_parts(stage, 3);
    const char *mixed[2] = {path_of(1, 2), path_of(2, 3)};
    char first[PATH_SIZE];
    snprintf(first, sizeof first, "%s/1-of-2", folder);
    mixed[0] = first;
    err = refusal(stage, mixed, 2);
    CHECK_MENTIONS(err.text, "part 2 of 3, other parts are of 2");
    /* A damaged file. */
    write_parts(stage, 2);
    FILE *file = fopen(path[1], "r+b");
    CHECK(file && fseek(file, -5, SEEK_END) == 0 && fputc(77, file) == 77);
    if (file) {
        fclose(file);
    }
    err = refusal(stage, path, 2);
    CHECK_TEXT(err.where, path[1]);
    stage_text_destroy(stage);
    stage_text_destroy(other);
}

/* Writes a good part with 8 bytes of one section replaced, and checks that it
 * is refused with the text. */
static void check_forged(const murk_stage *stage, const char *name, size_t at,
                         int64_t value, const char *mention)
{
    murk_section *sections = NULL;
    size_t n = 0;
    murk_error err = {0};
    const char *good = path_of(1, 1), *forged = path_of(2, 2);
    CHECK(!murk_map_file_read(&sections, &n, good, &err));
    for (size_t i = 0; i < n; ++i) {
        if (strcmp(sections[i].name, name) == 0) {
            CHECK(at + sizeof value <= sections[i].size);
            memcpy((char *)sections[i].bytes + at, &value, sizeof value);
        }
    }
    CHECK(!murk_map_file_write(forged, sections, n, &err));
    murk_map_file_release(sections, n);
    err = refusal(stage, &forged, 1);
    CHECK_MENTIONS(err.text, mention);
}

/* Contents that no run can have written, in files that are whole. */
static void test_forged_parts_are_refused(void)
{
    murk_stage *stage = stage_text_create(text, by_few);
    write_parts(stage, 1);
    check_forged(stage, "part", 0, 3, "other batches than those of the shard");
    check_forged(stage, "part", 0, INT64_MAX, "other batches than those");
    check_forged(stage, "part", 8, 1499, "other batches than those");
    check_forged(stage, "part", 16, 2, "\"part\" is missing");
    check_forged(stage, "part", 24, 'x', "made by murk x");
    check_forged(stage, "counts", 0, -1, "records are missing");
    check_forged(stage, "records", 24, 7, "records of other photons");
    check_forged(stage, "records", 0, -1, "a position outside the domain");
    check_forged(stage, "ledger", 0, -1, "sums that no photons have");
    check_forged(stage, "ledger", 8, INT64_MAX, "sums that no photons have");
    check_forged(stage, "ledger", 0, 0, "what no run can have written");
    stage_text_destroy(stage);
}

int main(void)
{
    static const uint32_t counts[] = {1, 2, 3, 7};
    CHECK(mkdtemp(folder) != NULL);
    murk_warn_to(NULL); /* of missing parts */
    test_parts_are_the_whole(by_emit, counts, 4);
    test_parts_are_the_whole(by_few, counts, 4);
    test_parts_are_the_whole(by_store, counts, 4);
    test_parts_are_the_whole(by_many, counts + 3, 1);
    test_parts_are_the_whole(no_maps, counts, 4);
    test_other_parts_are_refused();
    test_forged_parts_are_refused();
    return check_done();
}
