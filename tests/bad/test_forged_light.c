/* A light.murk whose checksums are right and whose contents are not what a run
 * can have written is refused in one line, whatever is forged. */
#include "base/rng.h"
#include "base/tally.h"
#include "check.h"
#include "lightmap/lightmap.h"
#include "photonmap/map_file.h"
#include "photonmap/photon.h"
#include "stage_text.h"

#include <stdint.h>
#include <stdlib.h>
#include <unistd.h>

static const char scene_text[] =
    "murk: 1\n"
    "bands_nm: [450, 600]\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "geometry: [{box: {min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}}]\n"
    "media: {fog: {extinction_per_m: 0.3, albedo: 0.9}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: point, position_m: [1, 1, 2.5], power_w: [8, 2]}\n"
    "  - {type: point, position_m: [3, 3, 2.5], power_w: 1}\n"
    "photons: {emit: 500}\n";

/* Where the numbers lie in the section "facts" (lightmap/store.c). */
enum { EMITTED, CHANNELS, PHOTONS, COLLISIONS, LOST };

typedef struct forgery {
    const char *section;
    size_t at;    /* byte within the section */
    size_t width; /* bytes of the new value */
    union {
        float f;
        double d;
        int64_t i;
        uint64_t u;
        uint8_t b;
        uint32_t w;
    } value;
    const char *says;
} forgery;

static char path[64];

/* Writes the sections with one change and loads the file again: the refusal, or
 * "" where the file was taken. */
static const char *refusal(const murk_section *sections, size_t n,
                           const forgery *change, const murk_stage *stage)
{
    static murk_error err;
    const murk_section *found =
        murk_map_file_find(sections, n, change->section);
    char before[8];
    murk_traced *traced = NULL;
    err = (murk_error){0};
    CHECK(found && change->at + change->width <= found->size);
    if (!found || change->at + change->width > found->size) {
        return "";
    }
    char *at = (char *)found->bytes + change->at;
    memcpy(before, at, change->width);
    memcpy(at, &change->value, change->width);
    CHECK(murk_map_file_write(path, sections, n, NULL) == MURK_OK);
    memcpy(at, before, change->width);
    const murk_status status =
        murk_lightmap_load(&traced, stage, path, 1, &err);
    if (!status) {
        murk_traced_destroy(traced);
        return "";
    }
    CHECK(status == MURK_BAD_FILE || status == MURK_BAD_VALUE); /* its seed */
    CHECK(traced == NULL);
    CHECK_TEXT(err.where, path);
    CHECK(strchr(err.text, '\n') == NULL);
    return err.text;
}

static void test_forgeries(const murk_section *sections, size_t n,
                           const murk_stage *stage)
{
    const size_t record = offsetof(murk_photon, power_w);
    const size_t place = offsetof(murk_photon, position_m);
    const size_t second = sizeof(murk_photon);
    const forgery forgeries[] = {
        {"surface", record, 4, {.f = NAN}, "a power that"},
        {"surface", record, 4, {.f = INFINITY}, "a power that"},
        {"surface", record, 4, {.f = -1e-9f}, "a power that"},
        {"volume", second + record, 4, {.f = 11}, "a power that"},
        {"surface", place, 4, {.f = NAN}, "outside the domain"},
        {"surface", place + 4, 4, {.f = -0.01f}, "outside the domain"},
        {"volume", place + 8, 4, {.f = 3.001f}, "outside the domain"},
        {"volume", place, 4, {.f = 1e30f}, "outside the domain"},
        {"surface", offsetof(murk_photon, direction), 4, {.w = 0}, "missing"},
        {"surface", offsetof(murk_photon, normal), 4, {.w = 0}, "missing"},
        {"volume", offsetof(murk_photon, normal), 4, {.w = 7}, "missing"},
        {"surface", offsetof(murk_photon, emitted), 4, {.w = 500}, "an index"},
        {"surface", offsetof(murk_photon, band), 1, {.b = 2}, "an index"},
        {"surface", offsetof(murk_photon, light), 1, {.b = 2}, "an index"},
        {"volume", offsetof(murk_photon, material), 1, {.b = 1}, "an index"},
        {"surface", offsetof(murk_photon, kind), 1, {.b = 4}, "a kind"},
        {"surface", offsetof(murk_photon, kind), 1, {.b = 3}, "a kind"},
        {"volume", offsetof(murk_photon, kind), 1, {.b = 8}, "a kind"},
        {"packet_w", 0, 8, {.d = NAN}, "of another power"},
        {"packet_w", 8, 8, {.d = 0}, "of another power"},
        {"packet_w", 16, 8, {.d = -1}, "of another power"},
        {"ledger", 0, 8, {.i = INT64_MAX}, "other emitted energy"},
        {"ledger", 0, 8, {.i = INT64_MIN}, "other emitted energy"},
        {"ledger", 4 * 8, 8, {.i = INT64_MAX}, "does not add up"},
        {"ledger", 8 * 8, 8, {.i = -1}, "does not add up"},
        {"ledger", 12 * 8, 8, {.i = INT64_MIN}, "does not add up"},
        {"ledger", 16 * 8, 8, {.i = 1}, "does not add up"},
        {"absorbed", 0, 8, {.i = INT64_MAX}, "add up to the ledger's"},
        {"absorbed", 8, 8, {.i = -1}, "add up to the ledger's"},
        {"facts", 8 * EMITTED, 8, {.u = 499}, "counts that are out"},
        {"facts", 8 * EMITTED, 8, {.u = 1ull << 32}, "section facts"},
        {"facts", 8 * PHOTONS, 8, {.u = UINT64_MAX}, "counts that are out"},
        {"facts", 8 * COLLISIONS, 8, {.u = 1ull << 63}, "counts that are out"},
        {"facts", 8 * LOST, 8, {.u = 501}, "counts that are out"},
        {"facts", 8 * LOST + 8, 8, {.u = UINT64_MAX}, "counts that are out"},
        {"facts", 8 * CHANNELS, 8, {.u = 3}, "section facts"}};
    for (size_t i = 0; i < sizeof forgeries / sizeof *forgeries; ++i) {
        const char *text = refusal(sections, n, &forgeries[i], stage);
        if (!strstr(text, forgeries[i].says)) {
            printf("forgery %zu of %s: \"%s\"\n", i, forgeries[i].section,
                   text);
        }
        CHECK_MENTIONS(text, forgeries[i].says);
    }
    /* a photon of a light that its number is not dealt to */
    const murk_photon *first =
        murk_map_file_find(sections, n, "surface")->bytes;
    const forgery dealt = {"surface",
                           offsetof(murk_photon, light),
                           1,
                           {.b = (uint8_t)!first->light},
                           "another light or band"};
    CHECK_MENTIONS(refusal(sections, n, &dealt, stage), dealt.says);
    /* what is as it was is taken */
    const forgery none = {"surface", record, 4, {.f = first->power_w}, ""};
    CHECK_TEXT(refusal(sections, n, &none, stage), "");
}

/* Whatever bytes stand in a section: refused, or taken without harm. */
static void test_noise(const murk_section *sections, size_t n,
                       const murk_stage *stage)
{
    static const char *const name[] = {"surface",  "volume", "packet_w",
                                       "absorbed", "facts",  "ledger"};
    size_t taken = 0;
    for (uint64_t i = 0; i < 300; ++i) {
        uint32_t word[4];
        murk_random_words(5, MURK_TEST, i, 0, 0, word);
        const murk_section *section =
            murk_map_file_find(sections, n, name[i % 6]);
        const forgery change = {section->name,
                                word[0] % (section->size - 4),
                                4,
                                {.w = word[1]},
                                ""};
        taken += *refusal(sections, n, &change, stage) == '\0';
    }
    /* a record's position within the domain, a direction, a smaller power, a
     * material, a class: some thirds of the records' bytes may be anything */
    CHECK(taken < 100);
}

/* A wall beyond the side of the domain by less than the margin within which
 * surfaces count as lying in the side is met, so the light of its photons is
 * light that a run has written. A wall beyond the margin is not met. */
static void test_walls_beyond_the_domain(void)
{
    static const struct {
        double x_m;
        bool is_met;
    } walls[] = {{10, true}, {10.00002, true}, {10.000038, true}, {12, false}};
    /* Trace light in a box whose wall lies there, and read the light again. */
    for (size_t i = 0; i < sizeof walls / sizeof *walls; ++i) {
        char text[500], wall[32];
        snprintf(wall, sizeof wall, "%.9g", walls[i].x_m);
        snprintf(text, sizeof text,
                 "murk: 1\n"
                 "domain: {min_m: [0, 0, 0], max_m: [10, 10, 5]}\n"
                 "geometry: [{box: {min_m: [-2, -2, -2], max_m: [%s, 12, 7]}}]"
                 "\nlights: [{type: point, position_m: [5, 5, 4], power_w: 1}]"
                 "\nphotons: {emit: 500}\n",
                 wall);
        murk_stage *stage = stage_text_create(text, NULL);
        murk_traced *traced = NULL, *again = NULL;
        murk_error err = {0};
        CHECK(stage && !murk_lightmap_trace(&traced, stage, 0, 1, NULL));
        if (traced && !murk_lightmap_save(traced, stage, path, NULL)) {
            CHECK((murk_photon_map_count(traced->surface) > 0) ==
                  walls[i].is_met);
            CHECK(murk_lightmap_load(&again, stage, path, 1, &err) == MURK_OK);
            CHECK_TEXT(err.text, "");
        }
        murk_traced_destroy(again);
        murk_traced_destroy(traced);
        stage_text_destroy(stage);
    }
}

int main(void)
{
    snprintf(path, sizeof path, "test_forged.tmp.%ld", (long)getpid());
    murk_stage *stage = stage_text_create(scene_text, NULL);
    murk_traced *traced = NULL;
    murk_section *sections = NULL;
    size_t n = 0;
    CHECK(stage && !murk_lightmap_trace(&traced, stage, 0, 1, NULL));
    if (traced && !murk_lightmap_save(traced, stage, path, NULL) &&
        !murk_map_file_read(&sections, &n, path, NULL)) {
        test_forgeries(sections, n, stage);
        test_noise(sections, n, stage);
    }
    CHECK(sections);
    murk_map_file_release(sections, n);
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
    test_walls_beyond_the_domain();
    remove(path);
    return check_done();
}
