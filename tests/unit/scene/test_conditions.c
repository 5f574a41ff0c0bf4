/* Conditions: each is the scene with its overrides in place, checked like any
 * scene, and what is resolved reads back the same. Nothing here is random. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "scene_files.h"

#define SCENE                                                         \
    "murk: 1\n"                                                       \
    "media:\n"                                                        \
    "  fog: {extinction_per_m: 0.02, albedo: 0.9, phase: {hg: .8}}\n" \
    "regions: [{medium: fog}]\n"                                      \
    "lights: [{type: point, position_m: [1, 1, 1], power_w: 9}]\n"    \
    "photons: {emit: 100}\n"

#define VALUE MURK_BAD_VALUE

static murk_scene_desc *must_read(const char *text,
                                  const murk_override *overrides, size_t n)
{
    murk_scene_desc *scene;
    murk_error err;
    if (scene_of(&scene, text, overrides, n, &err)) {
        printf("%s: %s\n", err.where, err.text);
        CHECK(scene != NULL); /* a good scene was refused */
        exit(check_done());
    }
    return scene;
}

static const char THREE[] =
    SCENE "conditions:\n"
          "  clear: {}\n"
          "  fog: {media.fog.extinction_per_m: .1, photons.store: 50,\n"
          "        media.fog.phase: isotropic}\n"
          "  night: {lights.0.power_w: 0.5}\n"
          "placement: {over: worst, condition_weights: {fog: 2.50}}\n";

static void test_each_is_the_scene_with_its_overrides(void)
{
    murk_scene_desc *scene = must_read(THREE, NULL, 0);
    CHECK(scene->n_conditions == 3);
    CHECK(scene->placement.over == MURK_SCENE_OBJECTIVE_WORST);
    const murk_scene_condition *c = scene->conditions;
    CHECK_TEXT(c[0].name, "clear");
    CHECK_TEXT(c[1].name, "fog");
    CHECK_TEXT(c[2].name, "night");
    CHECK_TEXT(c[1].where, "fog.yaml:9:3: conditions.fog");
    CHECK(c[0].weight == 1 && c[1].weight == 2.5 && c[2].weight == 1);

    CHECK(c[0].scene->media[0].extinction_per_m.band[0] == 0.02);
    CHECK(c[1].scene->media[0].extinction_per_m.band[0] == 0.1);
    CHECK(c[2].scene->media[0].extinction_per_m.band[0] == 0.02);
    CHECK(c[0].scene->media[0].phase[0].mean_cosine.band[0] == 0.8);
    CHECK(c[1].scene->media[0].phase[0].mean_cosine.band[0] == 0);
    CHECK(c[1].scene->media[0].albedo.band[0] == 0.9);
    CHECK(c[1].scene->lights[0].power_w.band[0] == 9);
    CHECK(c[2].scene->lights[0].power_w.band[0] == 0.5);
    /* of two keys that exclude each other the condition's holds */
    CHECK(c[1].scene->photons.store == 50 && c[1].scene->photons.emit == 0);
    CHECK(scene->photons.emit == 100 && scene->photons.store == 0);
    CHECK(c[1].scene->n_conditions == 0);
    CHECK(c[1].scene->placement.over == MURK_SCENE_OBJECTIVE_NONE);
    CHECK_TEXT(c[2].scene->media[0].where,
               "fog.yaml:3:3: conditions.night.media.fog");

    /* light depends on what a condition changes, and on nothing else */
    CHECK_TEXT(c[0].scene->light_key, scene->light_key);
    CHECK(strcmp(c[2].scene->light_key, scene->light_key) != 0);
    murk_scene_desc_destroy(scene);
}

static void test_resolved_reads_back(void)
{
    murk_scene_desc *scene = must_read(THREE, NULL, 0);
    CHECK_MENTIONS(scene->resolved, "over: worst");
    CHECK_MENTIONS(scene->resolved, "condition_weights: {fog: 2.5}");
    CHECK_MENTIONS(scene->resolved, "media.fog.extinction_per_m: 0.1");
    murk_scene_desc *again = must_read(scene->resolved, NULL, 0);
    CHECK_TEXT(again->resolved, scene->resolved);
    CHECK_TEXT(again->conditions[1].scene->resolved,
               scene->conditions[1].scene->resolved);
    /* a condition's own scene is a scene */
    murk_scene_desc *fog =
        must_read(scene->conditions[1].scene->resolved, NULL, 0);
    CHECK(fog->media[0].extinction_per_m.band[0] == 0.1);
    murk_scene_desc_destroy(fog);
    murk_scene_desc_destroy(again);
    murk_scene_desc_destroy(scene);
}

static void test_files_lie_beside_the_scene(void)
{
    murk_scene_desc *scene = must_read(
        SCENE "conditions: {thick: {media.fog: {vdb: a/b.vdb,\n"
              "  extinction_per_m: 1, albedo: 1}, regions.0: {medium: fog}}}\n",
        NULL, 0);
    const murk_scene_desc *thick = scene->conditions[0].scene;
    CHECK_TEXT(thick->media[0].vdb, "a/b.vdb");
    char folder[300], full[400];
    CHECK(getcwd(folder, sizeof folder) != NULL);
    snprintf(full, sizeof full, "vdb: \"%s/a/b.vdb\"", folder);
    if (!strstr(scene->resolved, full)) { /* plain where it needs no quotes */
        snprintf(full, sizeof full, "vdb: %s/a/b.vdb", folder);
    }
    CHECK_MENTIONS(scene->resolved, full);
    CHECK_MENTIONS(thick->light_key, "b.vdb");
    CHECK(!strstr(thick->light_key, folder));
    murk_scene_desc_destroy(scene);
}

static void test_the_command_line(void)
{
    /* it changes the scene, and conditions come on top */
    const murk_override base[] = {{"media.fog.extinction_per_m=.5", NULL},
                                  {"photons.emit=7", "--emit 7"}};
    murk_scene_desc *scene = must_read(THREE, base, 2);
    const murk_scene_condition *c = scene->conditions;
    CHECK(c[0].scene->media[0].extinction_per_m.band[0] == 0.5);
    CHECK(c[1].scene->media[0].extinction_per_m.band[0] == 0.1);
    CHECK(c[0].scene->photons.emit == 7 && c[1].scene->photons.store == 50);
    murk_scene_desc_destroy(scene);

    /* it may change what a condition sets, add to it, or add conditions */
    const murk_override more[] = {
        {"conditions.fog.media.fog.extinction_per_m=.7", NULL},
        {"conditions.fog.media.fog.albedo=0.25", NULL},
        {"conditions.dim={lights.0.power_w: 2}", NULL},
        {"placement.condition_weights.dim=4", NULL}};
    scene = must_read(THREE, more, 4);
    c = scene->conditions;
    CHECK(scene->n_conditions == 4 && c[3].weight == 4 && c[1].weight == 2.5);
    CHECK(c[1].scene->media[0].extinction_per_m.band[0] == 0.7);
    CHECK(c[1].scene->media[0].albedo.band[0] == 0.25);
    CHECK(c[3].scene->lights[0].power_w.band[0] == 2);
    murk_scene_desc_destroy(scene);
}

#define HEAD SCENE "conditions: {clear: {}, "

static void test_refusals(void)
{
    CHECK_REFUSED(HEAD "fog: {media.fgo.albedo: 1}}\n", VALUE,
                  "fog.yaml:7:31: conditions.fog.media.fgo.albedo",
                  "no fgo in media, did you mean fog?");
    CHECK_REFUSED(HEAD "fog: {medai.fog.albedo: 1}}\n", VALUE,
                  "fog.yaml:7:31: conditions.fog.medai.fog.albedo",
                  "no medai in the scene, did you mean media?");
    CHECK_REFUSED(HEAD "fog: {lights.1.power_w: 1}}\n", VALUE,
                  "fog.yaml:7:31: conditions.fog.lights.1.power_w",
                  "item 1 of a list of 1, must be 0..0");
    /* values are checked where they stand */
    CHECK_REFUSED(HEAD "fog: {media.fog.albedo: 1.5}}\n", VALUE,
                  "fog.yaml:7:49: conditions.fog.media.fog.albedo",
                  "1.5, must be 0..1");
    CHECK_REFUSED(HEAD "fog: {photons.emit: 5, photons.store: 6}}\n", VALUE,
                  "fog.yaml:7:48: conditions.fog.photons.store",
                  "emit and store are both in the condition, must be one of "
                  "them");
    CHECK_REFUSED(HEAD "fog: {media.fog.phase: isotropic, "
                       "media.fog.phase.hg: .5}}\n",
                  VALUE, "fog.yaml:7:59: conditions.fog.media.fog.phase.hg",
                  "one of it and media.fog.phase lies within the other, must "
                  "be apart");
    CHECK_REFUSED(HEAD "fog: {sensors.count: 3}}\n", VALUE,
                  "fog.yaml:7:31: conditions.fog.sensors.count",
                  "must be the same in all conditions; what may differ lies "
                  "in seed, weather, timeline, materials, geometry, media, "
                  "regions, lights, photons, flight, tallies");
    CHECK_REFUSED(HEAD "'a b': {}}\n", VALUE, "fog.yaml:7:25: conditions.a b",
                  "a name of other characters than letters, digits, - and _");
    CHECK_REFUSED(HEAD "worst: {}}\n", VALUE, "fog.yaml:7:25: conditions.worst",
                  "worst is a word of placement.over, must be another name");
    /* murk fit writes KEY@scene for readings without a condition */
    CHECK_REFUSED(HEAD "scene: {}}\n", VALUE, "fog.yaml:7:25: conditions.scene",
                  "scene is the word for the scene without a condition, must "
                  "be another name");
    CHECK_REFUSED(HEAD "fog: {}}\n"
                       "placement: {condition_weights: {fgo: 1}}\n",
                  VALUE, "fog.yaml:8:33: placement.condition_weights.fgo",
                  "no such condition, did you mean fog?");
    CHECK_REFUSED(HEAD "fog: {}}\n"
                       "placement: {condition_weights: {fog: -1}}\n",
                  VALUE, "fog.yaml:8:38: placement.condition_weights.fog",
                  "-1, must be 0..1e6");
    CHECK_REFUSED(SCENE "conditions: {fog: {}}\n"
                        "placement: {condition_weights: {fog: 0}}\n",
                  VALUE, "fog.yaml:8:13: placement.condition_weights",
                  "all weights are 0, one must be more than 0");
    char many[2000] = SCENE "conditions: {";
    for (int i = 0; i < 65; ++i) {
        snprintf(many + strlen(many), sizeof many - strlen(many), "c%d: {}, ",
                 i);
    }
    strcat(many, "last: {}}\n");
    CHECK_REFUSED(many, VALUE, "fog.yaml:7:1: conditions",
                  "66 items (condition), must be at most 64");
}

int main(void)
{
    CHECK(folder_enter());
    test_each_is_the_scene_with_its_overrides();
    test_resolved_reads_back();
    test_files_lie_beside_the_scene();
    test_the_command_line();
    test_refusals();
    folder_leave((const char *const[]){"fog.yaml", NULL});
    return check_done();
}
