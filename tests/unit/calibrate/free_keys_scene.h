/* For tests of free keys: a scene, and readings of its conditions. */
#ifndef MURK_TESTS_FREE_KEYS_SCENE_H
#define MURK_TESTS_FREE_KEYS_SCENE_H

#include "base/log.h"
#include "base/progress.h"
#include "calibrate/free_keys.h"
#include "check.h"
#include "scene/yaml.h"

#include <stdlib.h>
#include <unistd.h>

static const char *const SCENE =
    "murk: 1\n"
    "bands_nm: [450, 532]\n"
    "north: [0, 1, 0]\n"
    "domain: {min_m: [0, 0, -10], max_m: [30, 20, 10]}\n"
    "site: {latitude_deg: 52, longitude_deg: 5, time: 2026-06-21T12:00:00Z}\n"
    "media:\n"
    "  fog: {preset: fog/kruse, visibility_m: 80}\n"
    "  rain: {preset: rain/marshall-palmer}\n"
    "  plain: {extinction_per_m: .2, albedo: .9, phase: {hg: .8}}\n"
    "  two: {extinction_per_m: [.2, .3], albedo: [.9, .95],"
    " phase: {two_hg: [.9, -.1, .95]}}\n"
    "  sharp: {extinction_per_m: 1, albedo: .8,"
    " phase: {fournier_forand: [1.1, 3.6]}}\n"
    "  each: {extinction_per_m: 1, albedo: .8, phase: [{hg: .5}, {hg: .6}]}\n"
    "  layer: {profile: {z_m: [0, 2, 5], extinction_per_m: [.2, .1, 0]},"
    " albedo: .9}\n"
    "  sea: {preset: water/case-1}\n"
    "  black: {extinction_per_m: .1, albedo: 0}\n"
    "  clear: {extinction_per_m: 0, albedo: .5}\n"
    "  plume: {vdb: p.##.vdb, frame: 3.5, extinction_per_m: 1, albedo: .9}\n"
    "regions:\n"
    "  - {medium: fog}\n"
    "  - {medium: plain, box: {min_m: [1, 1, 1], max_m: [2, 2, 2]}}\n"
    "  - {medium: two, sphere: {center_m: [5, 5, 5], radius_m: 2}}\n"
    "  - {medium: sea, below_z_m: 0, ior: 1.34, wind_m_per_s: 5}\n"
    "lights:\n"
    "  - {type: sphere, center_m: [15, 10, 9], radius_m: .1, power_w: 100}\n"
    "  - {type: beam, origin_m: [0, 0, 1], direction: [1, 0, 0],"
    " divergence_deg: 5, power_w: [1, 2]}\n"
    "  - {type: directional, direction: [0, .1, -1],"
    " irradiance_w_per_m2: 10}\n"
    "  - {type: sun, irradiance_w_per_m2: [5, 6]}\n"
    "  - {type: point, position_m: [1, 2, 3], power_w: 0}\n"
    "conditions:\n"
    "  dawn: {media.fog.visibility_m: 50}\n"
    "  noon: {media.plain: {profile: {z_m: [0, 5],"
    " extinction_per_m: [.2, .1]}, albedo: .5}}\n";

static char path[] = "/tmp/murk-free-XXXXXX";
static char noted[2000];
static murk_scene_desc *scene;

static inline void keep_note(const char *where, const char *text)
{
    const size_t used = strlen(noted);
    snprintf(noted + used, sizeof noted - used, "%s: %s\n", where, text);
}

/* Readings of conditions 0, 1 and of none, as bits 1, 2, 4; eight of each. */
typedef struct field {
    murk_reading reading[32];
    murk_reading_row row[32];
    char gain[2][64];
    murk_readings all;
} field;

static inline void make_field(field *f, unsigned conditions)
{
    *f = (field){.gain = {"probe", "other"}};
    f->all = (murk_readings){.path = "field.csv",
                             .reading = f->reading,
                             .row = f->row,
                             .gain = f->gain,
                             .gains = 2};
    for (unsigned c = 0; c < 3; ++c) {
        for (int i = 0; i < 8 && (conditions >> c & 1); ++i) {
            const size_t n = f->all.readings++;
            f->reading[n] = (murk_reading){.kind = MURK_READ_FLUENCE,
                                           .unit = MURK_UNIT_W_PER_M2,
                                           .line = n + 2,
                                           .gain = n < 2 ? n : SIZE_MAX,
                                           .condition = c < 2 ? c : SIZE_MAX,
                                           .value = 1,
                                           .standard_error = .1};
            f->row[f->all.rows++] = (murk_reading_row){n, 1};
        }
    }
}

#define AS_IT_STANDS 4u

static inline murk_status create(murk_free_keys **out, const field *f,
                                 const char *const *asked, size_t n,
                                 const char *bounds, murk_error *err)
{
    static const char *held[1];
    static const char *asked_for[16];
    held[0] = bounds;
    memcpy(asked_for, asked, n * sizeof *asked);
    *err = (murk_error){0};
    noted[0] = '\0';
    const murk_free_desc desc = {.scene_path = path,
                                 .asked = asked_for,
                                 .n_asked = n,
                                 .bounds = held,
                                 .n_bounds = bounds ? 1 : 0,
                                 .measured = &f->all,
                                 .domain = &scene->domain};
    *out = NULL;
    return murk_free_keys_create(out, &desc, err);
}

static inline murk_free_keys *made(const field *f, const char *const *asked,
                                   size_t n, const char *bounds)
{
    murk_free_keys *keys;
    murk_error err;
    if (create(&keys, f, asked, n, bounds, &err)) {
        printf("%s: %s\n", err.where, err.text);
    }
    CHECK(keys != NULL);
    return keys;
}

#endif
