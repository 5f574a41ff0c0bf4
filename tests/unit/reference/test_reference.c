/* The reference of scene keys: each row of the key table, of scenes and of
 * studies, has a meaning in the tables of the reference as the program has them
 * built in, and paths are followed with and without items. Nothing here is
 * random. */
#include "check.h"
#include "reference/reference.h"

#include <stdlib.h>
#include <string.h>

static void check_table(const murk_keys *table)
{
    char *introduction = murk_reference_introduction(table);
    CHECK(!introduction || !strstr(introduction, "]("));
    free(introduction);
    for (const murk_key *row = table->key; row->name; ++row) {
        char *meaning = murk_reference_meaning(table, row);
        char *preset = murk_reference_default(table, row);
        const bool is_said = meaning && meaning[0] && !strchr(meaning, '`') &&
                             !strstr(meaning, "](");
        if (!is_said) {
            printf("%s of a %s has no meaning\n", row->name, table->noun);
        }
        CHECK(is_said);
        CHECK(!row->preset || (preset && strcmp(preset, row->preset) == 0));
        free(meaning);
        free(preset);
        if (row->keys) {
            check_table(row->keys);
        }
    }
}

/* The key that a path leads to. */
static void check_path(const char *path, const char *found)
{
    const murk_reference_key key = murk_reference_find(&murk_scene_keys, path);
    CHECK(key.row != NULL);
    CHECK_TEXT(key.path, found);
}

static void test_paths(void)
{
    check_path("sensors", "sensors");
    check_path("sensors.count", "sensors.count");
    check_path("bands_nm.0", "bands_nm");
    /* Items: by number, by name, by *, or not at all. */
    check_path("lights.0.power_w", "lights.*.power_w");
    check_path("lights.power_w", "lights.*.power_w");
    check_path("lights.12", "lights");
    check_path("media.fog.extinction_per_m", "media.*.extinction_per_m");
    check_path("media.*.extinction_per_m", "media.*.extinction_per_m");
    check_path("media.albedo.albedo", "media.*.albedo");
    check_path("media.fog.phase.1.hg", "media.*.phase.hg");
    check_path("media.fog.profile.extinction_per_m.0.1",
               "media.*.profile.extinction_per_m");
    check_path("sensors.candidates.mount.0.z_m",
               "sensors.candidates.mount.*.z_m");
    check_path("conditions.fog.media.fog.albedo", "conditions");
}

/* The part of a path that is unknown, and the map in which it was looked up. */
static void check_unknown(const char *path, const char *part, const char *noun)
{
    const murk_reference_key key = murk_reference_find(&murk_scene_keys, path);
    CHECK(key.row == NULL);
    CHECK_TEXT(key.unknown, part);
    CHECK_TEXT(key.looked_up ? key.looked_up->noun : "none", noun);
}

static void test_unknown_paths(void)
{
    check_unknown("", "", "scene");
    check_unknown("cameroon", "cameroon", "scene");
    check_unknown("sensors.cuont", "cuont", "sensors");
    check_unknown("media.fog.albdeo", "albdeo", "medium");
    check_unknown("sensors.count.of", "of", "none");
    check_unknown("lights.lamp.power_w", "lamp.power_w", "light");
}

int main(void)
{
    check_table(&murk_scene_keys);
    check_table(&murk_study_keys);
    test_paths();
    test_unknown_paths();
    return check_done();
}
