/* Free keys that are refused: where and in which words. Nothing here is random.
 */
#include "free_keys_scene.h"

/* ---- what is refused ---- */

static void refused_with(const field *f, const char *asked, const char *bounds,
                         const char *where, const char *why)
{
    murk_free_keys *keys;
    murk_error err;
    const char *all[] = {asked};
    const murk_status status = create(&keys, f, all, 1, bounds, &err);
    CHECK(status == MURK_BAD_VALUE);
    CHECK(keys == NULL);
    CHECK_MENTIONS(err.where, where);
    CHECK_MENTIONS(err.text, why);
    CHECK(!strchr(err.text, '\n'));
    murk_free_keys_destroy(keys);
}

static void refused(const char *asked, const char *why)
{
    field f;
    char where[200];
    make_field(&f, AS_IT_STANDS);
    snprintf(where, sizeof where, "keys %s", asked);
    refused_with(&f, asked, NULL, where, why);
}

static void test_keys_are_refused(void)
{
    /* Keys of other parts of the scene, and misspelt keys. */
    refused("", "nothing, must be of media, regions, lights or site");
    refused("medi.fog.visibility_m",
            "no medi in the scene, did you mean media");
    refused("photons.emit", "a key of photons, must be of media");
    refused("sensors.count", "must be of media, regions, lights or site");
    refused("media.fgo.visibility_m", "no fgo in media, did you mean fog?");
    refused("media.fog.visiblity_m",
            "no visiblity_m in media.fog, did you mean visibility_m?");
    /* Keys without a value to start from, and words that the preset does
     * not know. */
    refused("media.fog.mor_m", "media.fog has no mor_m to start from");
    refused("media.fog.albedo", "media.fog has no albedo to start from");
    refused("media.fog.chlorophyll_mg_per_m3",
            "changes nothing, so it cannot be free: fog/kruse does not know "
            "it, must be one of visibility_m");
    refused("media.sea.visibility_m",
            "changes nothing, so it cannot be free: water/case-1 does not");
    refused("media.plain.chlorophyll_mg_per_m3",
            "a word of presets, and the medium has none");
    /* Keys that are not one number. */
    refused("media.fog", "a map, must be one number");
    refused("media", "a map, must be one number");
    refused("media.fog.", "an empty part of a key");
    refused("media.two.albedo",
            "a list of 2, must be one number: media.two.albedo.0 is its first");
    refused("media.two.albedo.2", "item 2 of media.two.albedo, a list of 2");
    refused("media.plain.albedo.2",
            "media.plain.albedo is 0.9, one value for all bands");
    refused("lights.0.power_w.1", "lights.0.power_w is 100, one value");
    refused("media.plain.phase", "a map, must be one number");
    refused("media.fog.preset", "fog/kruse, must be a number");
    refused("regions.9.scale", "item 9 of regions, a list of 4, must be 0..3");
    refused("regions.0.scale", "to start from");
    refused("regions.1.replace", "false, must be a number");
    refused("lights.0.schedule", "must be a number");
    refused("media.plume.frame", "a choice or a count, must be a number");
    /* Bad names of conditions and gains, and keys that change nothing. */
    refused("media.plain.albedo@dawn", "must be @each");
    refused("gain.prob", "did you mean probe?");
    refused("media.black.albedo",
            "media.black has no extinction, scattering or power at the start");
    refused(
        "media.clear.extinction_per_m",
        "must start above 0, by another value of media.clear.extinction_per_m");
    refused("lights.4.power_w", "lights.4 has no extinction");
    refused("lights.3.linke_turbidity", "changes nothing in the light");
}

static void test_counts_and_bounds_are_refused(void)
{
    static const char *const twice[] = {"media.plain.albedo",
                                        "media.plain.albedo@each"};
    field f;
    murk_free_keys *keys;
    murk_error err;
    make_field(&f, AS_IT_STANDS);
    CHECK(create(&keys, &f, twice, 2, NULL, &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, "asked for twice");
    CHECK(create(&keys, &f, twice, 0, NULL, &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, "no keys");
    f.all.held_out = 8;
    refused_with(&f, "media.plain.albedo", NULL, "field.csv",
                 "0 rows to be fitted (8 held out) for 1 parameters");
    f.all.held_out = 7; /* one row for one parameter is enough */
    CHECK(create(&keys, &f, twice, 1, NULL, &err) == MURK_OK);
    murk_free_keys_destroy(keys);
    f.all.held_out = 0;
    refused_with(&f, "media.plain.albedo", "media.plain.albedo=.9:.9", "bounds",
                 "less than the second");
    refused_with(&f, "media.plain.albedo", "media.plain.albdo=0:1", "bounds",
                 "no free key, did you mean media.plain.albedo?");
    refused_with(&f, "media.plain.albedo", "media.plain.albedo=.5", "bounds",
                 "must be KEY=LOW:HIGH");
    refused_with(&f, "media.plain.albedo", "media.plain.albedo=.5:x", "bounds",
                 "must be KEY=LOW:HIGH");
    refused_with(&f, "media.plain.albedo", "media.plain.albedo=.5:.4", "bounds",
                 "less than the second");
    refused_with(&f, "media.plain.albedo", "media.plain.albedo=0:2", "bounds",
                 "must be within 0 to 1");
    refused_with(&f, "media.plain.albedo", "media.plain.albedo=.1:.4",
                 "keys media.plain.albedo",
                 "starts at 0.9, must be within its bounds, 0.1 to 0.4");
    f.reading[0].unit = MURK_UNIT_RELATIVE;
    refused_with(&f, "media.plain.albedo", NULL, "field.csv:2: gain",
                 "gain.probe must be a free key");
    f.reading[1].is_held_out = true;
    refused_with(&f, "gain.other", NULL, "keys gain.other", "held out");
}

int main(void)
{
    murk_error err = {0};
    const int handle = mkstemp(path);
    CHECK(handle >= 0);
    FILE *to = fdopen(handle, "w");
    CHECK(to && fputs(SCENE, to) >= 0 && fclose(to) == 0);
    murk_warn_to(keep_note);
    if (murk_scene_desc_read(&scene, path, NULL, 0, &err)) {
        printf("%s: %s\n", err.where, err.text);
        return 1;
    }
    test_keys_are_refused();
    test_counts_and_bounds_are_refused();
    unlink(path);
    murk_scene_desc_destroy(scene);
    return check_done();
}
