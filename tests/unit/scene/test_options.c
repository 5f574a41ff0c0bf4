/* Scene keys as options: what is refused, to the letter, and what applies.
 * Nothing here is random. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "full_scene.h"
#include "scene_files.h"

typedef struct option_refusal {
    const char *option, *where, *text;
} option_refusal;

static const option_refusal OPTIONS[] = {
    {"lights.9.power_w=1", "--set lights.9.power_w=1",
     "item 9 of a list of 5, must be 0..4"},
    {"lights.x.power_w=1", "--set lights.x.power_w=1",
     "item x of a list of 5, must be 0..4"},
    {"lights.0.power_w=1W", "--set lights.0.power_w=1W",
     "1W, must be a number (the total), 0..1e15 W, or a list, one a band"},
    {"lights.0.powr_w=1", "--set lights.0.powr_w=1",
     "no powr_w in lights, did you mean power_w?"},
    {"media.hase.albedo=1", "--set media.hase.albedo=1",
     "no hase in media, did you mean haze?"},
    {"media.fog={albedo: 1}", "--set media.fog={albedo: 1}",
     "misses extinction_per_m, must be a number, 0..1e9 1/m, or a list of "
     "them, one a band"},
    {"media.haze={extinction_per_m: 1, albedo: 3}",
     "--set media.haze={extinction_per_m: 1, albedo: 3}: media.haze.albedo",
     "3, must be 0..1"},
    {"media.haze.preset=x", "--set media.haze.preset=x",
     "no preset x, must be one of those that `murk media` lists"},
    {"photons", "--set photons", "must be KEY=VALUE, such as photons.emit=1e5"},
    {"=3", "--set =3",
     "an empty key, must be KEY=VALUE, such as photons.emit=1e5"},
    {"photons..emit=3", "--set photons..emit=3",
     "an empty key, must be KEY=VALUE, such as photons.emit=1e5"},
    {"seed=", "--set seed=", "empty, must be YAML"},
    {"seed=[1", "--set seed=[1", "not YAML: did not find expected ',' or ']'"},
    {"seed.x=1", "--set seed.x=1", "x is below a single value"},
    {"sed=1", "--set sed=1", "no sed in the scene, did you mean seed?"},
    {"placement.method.x=1", "--set placement.method.x=1",
     "x is below a single value"},
    {"domain.min_m.3=1", "--set domain.min_m.3=1",
     "item 3 of a list of 3, must be 0..2"},
};

static void test_option_refusals(void)
{
    for (size_t i = 0; i < sizeof OPTIONS / sizeof *OPTIONS; ++i) {
        const murk_override option = {.text = OPTIONS[i].option};
        murk_scene_desc *scene;
        murk_error err;
        CHECK(scene_of(&scene, FULL_SCENE, &option, 1, &err) != MURK_OK);
        CHECK_TEXT(err.where, OPTIONS[i].where);
        CHECK_TEXT(err.text, OPTIONS[i].text);
        murk_scene_desc_destroy(scene);
    }
}

static void test_options_of_other_names(void)
{
    const murk_override option = {.text = "seed=-3", .option = "--seed -3"};
    murk_scene_desc *scene;
    murk_error err;
    CHECK(scene_of(&scene, FULL_SCENE, &option, 1, &err) == MURK_BAD_VALUE);
    CHECK_TEXT(err.where, "--seed -3");
    CHECK_TEXT(err.text, "-3, must be 0..4294967295");
}

static void test_options_apply(void)
{
    static const murk_override options[] = {
        {.text = "media.haze.phase=isotropic"},
        {.text = "media.thin.phase.hg=0.5"}, /* was a word: now a map */
        {.text = "media.smoke.phase=[rayleigh, {hg: .1}]"},
        {.text = "media.smoke.phase.0.two_hg=[.9, -.1, .7]"},
        {.text = "media.smoke.phase.1.hg=.2"},
        {.text = "lights.1.power_w.0=11"},
        {.text = "photons.emit=1e6"}, /* in place of store */
        {.text = "photons.emit=2e6"}, /* the last of equals wins */
        {.text = "placement.weights=balanced"},
        {.text = "media.new={extinction_per_m: 1, albedo: 0}"},
        {.text = "regions.0.medium=new"},
        {.text = "materials.default.diffuse=0.25"},
        {.text = "sensors.candidates.grid.spacing_m=2"},
    };
    murk_scene_desc *scene;
    murk_error err;
    const murk_status status = scene_of(&scene, FULL_SCENE, options,
                                        sizeof options / sizeof *options, &err);
    CHECK(status == MURK_OK);
    CHECK_TEXT(err.text, "");
    if (status) {
        return;
    }
    CHECK(scene->media[0].phase[0].mean_cosine.band[0] == 0);
    CHECK(scene->media[2].phase[0].mean_cosine.band[1] == 0.5);
    const murk_scene_medium *smoke = &scene->media[1];
    CHECK(smoke->n_phases == 2);
    CHECK(smoke->phase[0].kind == MURK_PHASE_TWO_HG);
    CHECK(smoke->phase[0].value[2] == .7);
    CHECK(smoke->phase[1].mean_cosine.band[1] == .2);
    CHECK(scene->lights[1].power_w.band[0] == 11);
    CHECK(scene->lights[1].power_w.band[1] == 30);
    CHECK(scene->photons.emit == 2000000 && scene->photons.store == 0);
    CHECK(scene->photons.store_hits);
    CHECK(scene->placement.balanced);
    CHECK(scene->n_media == 6 && scene->regions[0].medium == 5);
    CHECK(scene->materials[0].diffuse.band[0] == 0.25);
    CHECK(scene->sensors.candidates.grid_size[0] == 15);
    murk_scene_desc_destroy(scene);
}

static void test_emit_and_store_exclude_each_other(void)
{
    const murk_override both[] = {{.text = "photons.store=5"},
                                  {.text = "photons.emit=5"}};
    murk_scene_desc *scene;
    murk_error err;
    CHECK(scene_of(&scene, FULL_SCENE, both, 2, &err) == MURK_BAD_VALUE);
    CHECK_TEXT(err.where, "--set photons.emit=5");
    CHECK_TEXT(err.text, "store and emit are both on the command line, must be "
                         "one of them");
}
int main(void)
{
    if (!folder_enter()) {
        check_skip("no folder for temporary files");
    }
    test_option_refusals();
    test_options_of_other_names();
    test_options_apply();
    test_emit_and_store_exclude_each_other();
    folder_leave((const char *const[]){"fog.yaml", NULL});
    return check_done();
}
