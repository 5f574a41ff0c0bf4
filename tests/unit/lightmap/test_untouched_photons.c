/* Scenes that change with time: a photon that a change does not touch keeps
 * every bit from one time to another. The bounds of shares that may change are
 * far above what is found for the fixed seed; without dealing by shares, or
 * with a rounding that follows the geometry, nearly all photons change. */
#include "base/log.h"
#include "check.h"
#include "lightmap/lightmap.h"
#include "stage_text.h"

#include <stdlib.h>
#include <string.h>

#define PHOTONS 4000

/* A floor and two lamps in fog, and a box that is the only thing up there. */
static const char text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [40, 20, 8]}\n"
    "timeline: {times_s: [0, 10], tracks: []}\n"
    "geometry:\n"
    "  - {rect: {corner_m: [5, 5, 0], edge1_m: [20, 0, 0], edge2_m: [0, 10, "
    "0]}}\n"
    "  - {name: load, box: {min_m: [-0.5, -0.5, -0.5], max_m: [0.5, 0.5, "
    "0.5]}, translate_m: [10, 10, 2]}\n"
    "media: {fog: {extinction_per_m: 0.05, albedo: 0.9}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: point, position_m: [12, 12, 6], power_w: 10}\n"
    "  - {type: point, position_m: [20, 8, 6], power_w: 30}\n"
    "photons: {emit: 4000}\n"
    "seed: 5\n";

/* The light at a time, with a timeline that has this track. */
static murk_traced *light_at(const char *track, const char *at)
{
    char tracks[500], time[64];
    snprintf(tracks, sizeof tracks, "timeline.tracks=[%s]", track);
    snprintf(time, sizeof time, "timeline.at_s=%s", at);
    const char *const set[] = {tracks, time, NULL};
    murk_stage *stage = stage_text_create(text, set);
    murk_traced *traced = NULL;
    murk_error err = {0};
    CHECK(stage != NULL);
    if (stage) {
        CHECK(murk_lightmap_trace(&traced, stage, 0, 1, &err) == MURK_OK);
        CHECK_TEXT(err.text, "");
    }
    stage_text_destroy(stage);
    return traced;
}

/* A sum over the records of each emitted photon that does not depend on their
 * order in the map, and that no two sets of records are likely to share. */
static void add_records(uint64_t *sum, const murk_photon_map *map)
{
    for (size_t i = 0; i < murk_photon_map_count(map); ++i) {
        const murk_photon *p = murk_photon_map_photons(map) + i;
        const murk_vec3 x = murk_photon_place(p);
        const double value[] = {x.x, x.y, x.z, murk_photon_power_w(p)};
        uint64_t bits[4], hash = murk_photon_packed_direction(p);
        memcpy(bits, value, sizeof bits);
        for (int k = 0; k < 4; ++k) {
            hash = (hash ^ bits[k]) * UINT64_C(0x9e3779b97f4a7c15);
            hash ^= hash >> 29;
        }
        sum[murk_photon_emitted(p)] += hash | 1;
    }
}

static uint64_t *sums_of(const murk_traced *traced)
{
    uint64_t *sum = calloc(PHOTONS, sizeof *sum);
    if (sum && traced) {
        add_records(sum, traced->surface);
        add_records(sum, traced->volume);
    }
    return sum;
}

/* Of the photons with records at either time, the number; and of these those
 * whose records changed, and those that have records at the first time alone.
 */
typedef struct difference {
    size_t all, changed, gone;
} difference;

static difference compare(const char *track)
{
    murk_traced *early = light_at(track, "0"), *late = light_at(track, "10");
    uint64_t *a = sums_of(early), *b = sums_of(late);
    difference d = {0, 0, 0};
    for (size_t i = 0; a && b && i < PHOTONS; ++i) {
        d.all += a[i] || b[i];
        d.changed += a[i] != b[i];
        d.gone += a[i] && !b[i];
    }
    free(a);
    free(b);
    murk_traced_destroy(early);
    murk_traced_destroy(late);
    CHECK(d.all > PHOTONS / 10);
    return d;
}

static void test_nothing_changes(void)
{
    const difference d = compare("{key: cameras, keyframes: [{t_s: 0, value: "
                                 "[]}]}");
    CHECK(d.changed == 0);
}

/* The box leaves the bounds of all other geometry, which the rounding of hits
 * must not notice. */
static void test_moved_geometry(void)
{
    const difference d =
        compare("{geometry: load, keyframes: [{t_s: 0, translate_m: [10, 10, "
                "2]}, {t_s: 10, translate_m: [38, 10, 7]}]}");
    CHECK(d.changed > 0 && (double)d.changed < 0.05 * (double)d.all);
}

/* A lamp that goes out: its photons are gone, and no other changes. */
static void test_lamp_that_goes_out(void)
{
    const difference d = compare("{key: lights.0.power_w, between: hold, "
                                 "keyframes: [{t_s: 0, value: 10}, {t_s: 5, "
                                 "value: 0}]}");
    CHECK(d.changed > 0 && d.changed == d.gone);
    CHECK((double)d.changed < 0.4 * (double)d.all);
    /* A lamp that is dimmed changes the power of its own packets alone. */
    const difference dimmed = compare("{key: lights.0.power_w, keyframes: [{t_s"
                                      ": 0, value: 10}, {t_s: 10, value: 5}]}");
    CHECK(dimmed.changed > 0 && dimmed.gone == 0);
    CHECK((double)dimmed.changed < 0.4 * (double)dimmed.all);
}

/* Energy balances, and the power is that of the lamps that are on. */
static void test_ledger_of_lamps_that_are_off(void)
{
    murk_traced *late = light_at("{key: lights.0.power_w, between: hold, "
                                 "keyframes: [{t_s: 0, value: 10}, {t_s: 5, "
                                 "value: 0}]}",
                                 "10");
    if (!late) {
        CHECK(false);
        return;
    }
    CHECK(late->emitted == PHOTONS);
    CHECK(murk_ledger_imbalance(late->ledger) == 0);
    CHECK(late->packet_w[0] == 0);
    const double emitted = (double)murk_tally_read(&late->ledger->photons);
    CHECK_NEAR(emitted * late->packet_w[1], 30, 1e-9);
    CHECK(emitted < PHOTONS);
    murk_traced_destroy(late);
}

int main(void)
{
    murk_warn_quiet(true);
    test_nothing_changes();
    test_moved_geometry();
    test_lamp_that_goes_out();
    test_ledger_of_lamps_that_are_off();
    return check_done();
}
