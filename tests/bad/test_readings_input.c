/* Files of readings and names of keys that are cut off, changed, noise, or far
 * too large: whatever they are, they are read or refused in one line, within
 * bounded time and memory. Deterministic. */
#include "base/log.h"
#include "base/progress.h"
#include "base/rng.h"
#include "broken.h"
#include "calibrate/key_place.h"
#include "check.h"
#include "readings/readings.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

static const char SCENE[] =
    "murk: 1\n"
    "bands_nm: [450, 532]\n"
    "domain: {min_m: [0, 0, 0], max_m: [30, 20, 10]}\n"
    "media:\n"
    "  fog: {preset: fog/kruse, visibility_m: 80}\n"
    "  a.b: {extinction_per_m: [1, 2], albedo: .5, phase: [{hg: .5}, {hg: "
    ".6}]}\n"
    "regions:\n"
    "  - {medium: fog}\n"
    "  - {medium: a.b, box: {min_m: [1, 1, 1], max_m: [2, 2, 2]}}\n"
    "lights: [{type: point, position_m: [1, 1, 1], power_w: [1, 2]}]\n"
    "sensors: {types: [{name: cam, range_m: 9, view: {cone_deg: 60}}]}\n"
    "conditions: {dawn: {}, noon: {}}\n";

static const char GOOD[] =
    "kind,condition,x_m,y_m,z_m,x2_m,y2_m,z2_m,direction_x,direction_y,"
    "direction_z,radius_m,acceptance_deg,band_nm,sensor,heading_deg,tilt_deg,"
    "group,gain,unit,value,standard_error,use\n"
    "coverage,dawn,1,2,3,,,,,,,,,,cam,90,-30,A,,,.4,.02,fit\n"
    "coverage,dawn,2,2,3,,,,,,,,,,cam,90,-30,A,,,.4,.02,fit\n"
    "fluence,,4,5,6,,,,,,,.5,,532,,,,,,lux,50,2,hold_out\n"
    "irradiance,noon,4,5,6,,,,0,0,-2,.5,60,,,,,,,W/m2,1.5,.1,\n"
    "transmittance,,1,1,1,1,1,4,,,,,1,,,,,\"B \"\"1\"\"\",,db_per_km,87,3,\n"
    "fluence,,4,5,6,,,,,,,.5,,,,,,,probe,percent,40,5,\n";

static char path[] = "/tmp/murk-readings-XXXXXX";
static murk_scene_desc *scene;
static int read_well;

static void check_refusal(murk_status status, const murk_error *err)
{
    CHECK(status == MURK_BAD_FILE || status == MURK_BAD_VALUE);
    broken_check_refusal(err);
}

static void try_file(const char *bytes, size_t size)
{
    murk_readings *m = NULL;
    murk_error err = {0};
    write_bytes(path, bytes, size);
    const murk_status status =
        murk_readings_read(&m, path, scene, &scene->domain, &err);
    if (status) {
        CHECK(m == NULL);
        check_refusal(status, &err);
        return;
    }
    ++read_well;
    CHECK(m->rows > 0 && m->rows <= m->readings && m->held_out <= m->rows);
    for (size_t i = 0; i < m->readings; ++i) {
        CHECK(isfinite(m->reading[i].value));
        CHECK(m->reading[i].standard_error > 0);
        CHECK(murk_box_contains(&scene->domain.box, m->reading[i].position));
    }
    murk_readings_destroy(m);
}

static void test_cut_off_anywhere(void)
{
    for (size_t size = 0; size < sizeof GOOD - 1; ++size) {
        try_file(GOOD, size);
    }
}

static void test_flipped_bytes(void)
{
    static const char meant[] = ",\n\"#0123456789-+.eE \0naif_";
    for (uint64_t i = 0; i < 4000; ++i) {
        char text[sizeof GOOD];
        memcpy(text, GOOD, sizeof GOOD);
        broken_replace(text, sizeof GOOD - 1, 11, i, i / 4 % 2, meant,
                       sizeof meant - 1);
        try_file(text, sizeof GOOD - 1);
    }
}

static void test_noise(void)
{
    char noise[2000];
    for (uint64_t i = 0; i < 50; ++i) {
        broken_noise(noise, sizeof noise, 12, i);
        try_file(noise, sizeof noise);
    }
    try_file("{\"murk\": {}, \"parameters\": [1, 2]}\n", 35);
    try_file("murk: 1\nmedia: {}\n", 18);
}

/* Ten million rows, and one row without end. */
static void test_too_large(void)
{
    static const char head[] = "kind,value,standard_error\n";
    const size_t rows = 10000000, size = sizeof head + 3 * rows;
    const double start_s = murk_clock_s();
    char *text = malloc(size);
    CHECK(text != NULL);
    memcpy(text, head, sizeof head - 1);
    for (size_t i = 0; i < rows; ++i) {
        memcpy(text + sizeof head - 1 + 3 * i, ",,\n", 3);
    }
    const int before = read_well;
    try_file(text, size - 1);
    memset(text, ',', size);
    try_file(text, size);
    memset(text, '"', size);
    try_file(text, size);
    CHECK(read_well == before);
    CHECK(murk_clock_s() - start_s < BROKEN_SLOWEST_S);
    free(text);
}

/* Paths of keys with parts dropped, doubled and changed are found or
 * refused. */
static void test_names_of_keys(void)
{
    /* Paths that exist in the resolved scene. */
    static const char *const paths[] = {
        "media.fog.visibility_m", "media.a.b.extinction_per_m.1",
        "media.a.b.phase.0.hg", "regions.1.box.max_m.2", "lights.0.power_w.1"};
    murk_yaml *root = NULL;
    int found = 0;
    CHECK(murk_yaml_parse(&root, scene->resolved, strlen(scene->resolved),
                          "resolved", NULL) == MURK_OK);
    /* Cut a path, change one character, or put another path in place of the
     * rest; a few of the first paths stay whole. */
    for (uint64_t i = 0; i < 20000; ++i) {
        char name[400];
        murk_key_place place;
        murk_error err = {0};
        uint32_t word[4];
        const size_t n =
            (size_t)snprintf(name, sizeof name, "%s", paths[i % 5]);
        murk_random_words(13, MURK_TEST, i, 0, 0, word);
        const uint32_t at = murk_random_below(word[0], (uint32_t)n);
        if (i % 3 == 0) {
            name[at] = '\0';
        } else if (i % 3 == 1) {
            name[at] = ".0123456789@-_ \x7f\xff"[word[1] % 17];
        } else if (i >= 15) {
            snprintf(name + at, sizeof name - at, "%s", paths[word[1] % 5]);
        }
        /* A path that is found has a finite value; any other is refused
         * with a message. */
        const murk_status status =
            murk_key_place_find(&place, root, 1, name, "--free", &err);
        if (status) {
            check_refusal(status, &err);
        } else {
            ++found;
            CHECK(isfinite(place.value) && place.put <= strlen(name));
        }
    }
    CHECK(found >= 5 && found < 10000);
    murk_yaml_destroy(root);
}

int main(void)
{
    murk_error err = {0};
    murk_warn_to(NULL);
    const int handle = mkstemp(path);
    CHECK(handle >= 0);
    close(handle);
    CHECK(murk_scene_desc_parse(&scene, SCENE, "s.yaml", NULL, 0, &err) ==
          MURK_OK);
    if (scene) {
        try_file(GOOD, sizeof GOOD - 1);
        CHECK(read_well == 1);
        test_cut_off_anywhere();
        test_flipped_bytes();
        test_noise();
        CHECK(read_well > 50); /* both ways were taken */
        test_too_large();
        test_names_of_keys();
        CHECK(broken_peak_kb() < BROKEN_MAX_KB);
    }
    unlink(path);
    murk_scene_desc_destroy(scene);
    return check_done();
}
