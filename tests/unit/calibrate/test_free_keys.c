/* Free keys: what each turns, where it starts and between what it may move, and
 * scenes at other values. Deterministic. */
#include "free_keys_scene.h"

/* ---- what a key turns ---- */

typedef struct expected {
    const char *key;
    murk_free_kind kind;
    double start;
    bool is_log, turns_phase;
} expected;

static void check_key(const expected *want)
{
    field f;
    make_field(&f, AS_IT_STANDS);
    murk_free_keys *keys = made(&f, &want->key, 1, NULL);
    if (!keys) {
        printf("  %s\n", want->key);
        return;
    }
    const murk_free_key *key = &keys->key[0];
    const bool is_so = key->kind == want->kind && key->start == want->start &&
                       key->is_log == want->is_log &&
                       key->turns_phase == want->turns_phase;
    if (!is_so) {
        printf("%s: kind %d, start %.9g, log %d, phase %d\n", want->key,
               (int)key->kind, key->start, key->is_log, key->turns_phase);
    }
    CHECK(is_so);
    CHECK(key->lower < key->start || !key->is_log);
    CHECK(key->start >= key->lower && key->start <= key->upper);
    CHECK_TEXT(key->name, want->key);
    murk_free_keys_destroy(keys);
}

static void test_keys_are_what_they_turn(void)
{
    /* Keys of the optics of media, for which light is reweighed. */
    static const expected medium[] = {
        {"media.fog.visibility_m", MURK_FREE_MEDIUM, 80, true, false},
        {"media.rain.rain_mm_per_h", MURK_FREE_MEDIUM, 10, true, false},
        {"media.plain.extinction_per_m", MURK_FREE_MEDIUM, .2, true, false},
        {"media.plain.albedo", MURK_FREE_MEDIUM, .9, false, false},
        {"media.plain.phase.hg", MURK_FREE_MEDIUM, .8, false, true},
        {"media.two.extinction_per_m.1", MURK_FREE_MEDIUM, .3, true, false},
        {"media.two.albedo.0", MURK_FREE_MEDIUM, .9, false, false},
        {"media.two.phase.two_hg.2", MURK_FREE_MEDIUM, .95, false, true},
        {"media.sharp.phase.fournier_forand.0", MURK_FREE_MEDIUM, 1.1, false,
         true},
        {"media.each.phase.1.hg", MURK_FREE_MEDIUM, .6, false, true},
        {"media.layer.albedo", MURK_FREE_MEDIUM, .9, false, false},
        {"media.sea.chlorophyll_mg_per_m3", MURK_FREE_MEDIUM, .5, true, true},
    };
    /* Keys of powers, for which light is scaled. */
    static const expected light[] = {
        {"lights.0.power_w", MURK_FREE_LIGHT, 100, true, false},
        {"lights.1.power_w.1", MURK_FREE_LIGHT, 2, true, false},
        {"lights.2.irradiance_w_per_m2", MURK_FREE_LIGHT, 10, true, false},
        {"lights.3.irradiance_w_per_m2.0", MURK_FREE_LIGHT, 5, true, false},
    };
    /* Keys of the world, for which light is traced again. */
    static const expected world[] = {
        {"media.layer.profile.extinction_per_m.0", MURK_FREE_WORLD, .2, true,
         false},
        {"media.layer.profile.extinction_per_m.2", MURK_FREE_WORLD, 0, false,
         false},
        {"media.layer.profile.z_m.1", MURK_FREE_WORLD, 2, false, false},
        {"regions.1.translate_m.2", MURK_FREE_WORLD, 0, false, false},
        {"regions.1.rotate_deg.0", MURK_FREE_WORLD, 0, false, false},
        {"regions.1.scale", MURK_FREE_WORLD, 1, true, false},
        {"regions.1.box.max_m.2", MURK_FREE_WORLD, 2, false, false},
        {"regions.2.sphere.radius_m", MURK_FREE_WORLD, 2, true, false},
        {"regions.3.below_z_m", MURK_FREE_WORLD, 0, false, false},
        {"regions.3.ior", MURK_FREE_WORLD, 1.34, false, false},
        {"regions.3.wind_m_per_s", MURK_FREE_WORLD, 5, false, false},
        {"lights.0.center_m.2", MURK_FREE_WORLD, 9, false, false},
        {"lights.0.radius_m", MURK_FREE_WORLD, .1, true, false},
        {"lights.1.divergence_deg", MURK_FREE_WORLD, 5, false, false},
        {"lights.1.direction.2", MURK_FREE_WORLD, 0, false, false},
        {"lights.2.direction.1", MURK_FREE_WORLD, .1, false, false},
        {"site.latitude_deg", MURK_FREE_WORLD, 52, false, false},
    };
    /* Kind, start and logarithmic scale of each key. */
    for (size_t i = 0; i < sizeof medium / sizeof *medium; ++i) {
        check_key(&medium[i]);
    }
    for (size_t i = 0; i < sizeof light / sizeof *light; ++i) {
        check_key(&light[i]);
    }
    for (size_t i = 0; i < sizeof world / sizeof *world; ++i) {
        check_key(&world[i]);
    }
}

static void test_ranges_are_natural(void)
{
    static const char *const asked[] = {
        "media.plain.albedo", "media.plain.phase.hg",
        "media.plain.extinction_per_m", "media.fog.visibility_m",
        "regions.1.translate_m.0"};
    static const double lower[] = {0, -.999, 0, 10, -INFINITY};
    static const double upper[] = {1, .999, INFINITY, 2e5, INFINITY};
    field f;
    make_field(&f, AS_IT_STANDS);
    murk_free_keys *keys = made(&f, asked, 5, NULL);
    for (size_t k = 0; keys && k < 5; ++k) {
        CHECK(keys->key[k].lower == lower[k] && keys->key[k].upper == upper[k]);
    }
    murk_free_keys_destroy(keys);
    keys = made(&f, asked, 5, "media.plain.albedo=.5:");
    CHECK(keys && keys->key[0].lower == .5 && keys->key[0].upper == 1);
    murk_free_keys_destroy(keys);
    keys = made(&f, asked, 5, "media.fog.visibility_m=20:500");
    CHECK(keys && keys->key[3].lower == 20 && keys->key[3].upper == 500);
    murk_free_keys_destroy(keys);
}

/* ---- scenes at values ---- */

static double resolved(const murk_scene_desc *at, const char *const *part,
                       size_t n)
{
    murk_yaml *root = NULL;
    double value = NAN;
    CHECK(murk_yaml_parse(&root, at->resolved, strlen(at->resolved), "r",
                          NULL) == MURK_OK);
    const murk_yaml *node = root;
    for (size_t i = 0; node && i < n; ++i) {
        node = node->kind == MURK_YAML_LIST
                   ? node->child[strtoul(part[i], NULL, 10)]
                   : murk_yaml_get(node, part[i]);
    }
    CHECK(node && murk_yaml_number(node, &value));
    murk_yaml_destroy(root);
    return value;
}

/* Two items of one list that the file leaves to its default, a value with all
 * its digits, and a power. */
static void test_a_scene_has_the_values(void)
{
    static const char *const asked[] = {
        "regions.1.translate_m.0", "regions.1.translate_m.2",
        "media.plain.albedo", "lights.1.power_w.0"};
    static const double value[] = {.25, -1, .1 + .2, 7};
    static const char *const key_path[4][4] = {
        {"regions", "1", "translate_m", "0"},
        {"regions", "1", "translate_m", "2"},
        {"media", "plain", "albedo"},
        {"lights", "1", "power_w", "0"}};
    static const size_t key_depth[] = {4, 4, 3, 4};
    field f;
    make_field(&f, AS_IT_STANDS);
    murk_free_keys *keys = made(&f, asked, 4, NULL);
    murk_scene_desc *at = NULL;
    murk_optics *optics = NULL;
    CHECK(murk_free_scene(&at, keys, 0, value, NULL) == MURK_OK);
    for (size_t k = 0; k < 4; ++k) {
        CHECK(resolved(at, key_path[k], key_depth[k]) == value[k]);
    }
    CHECK(at->regions[1].solid.translate_m.y == 0 && at->n_conditions == 0);
    murk_scene_desc_destroy(at);
    CHECK(murk_free_optics(&optics, keys, 0, value, NULL) == MURK_OK);
    CHECK(optics->media == 11 && optics->bands == 2 && optics->channels == 10);
    CHECK(optics->albedo[2].band[1] == .1 + .2);
    CHECK_NEAR(optics->power_w[2], 7, 1e-14);
    CHECK_NEAR(optics->power_w[3], 2, 1e-14);
    CHECK(optics->extinction_per_m[6].band[0] == 1); /* as a profile says */
    murk_optics_destroy(optics);
    murk_free_keys_destroy(keys);
}

/* A scene as resolved has one value where a list had it twice. */
static void test_a_band_of_one_value_is_its_own(void)
{
    static const char *const asked[] = {"media.plain.albedo.1",
                                        "media.plain.extinction_per_m.0"};
    static const double value[] = {.25, .3};
    field f;
    make_field(&f, AS_IT_STANDS);
    murk_free_keys *keys = made(&f, asked, 2, NULL);
    murk_optics *optics = NULL;
    CHECK(keys->key[0].start == .9 && keys->key[1].start == .2);
    CHECK(murk_free_optics(&optics, keys, 0, value, NULL) == MURK_OK);
    CHECK(optics->albedo[2].band[0] == .9 && optics->albedo[2].band[1] == .25);
    CHECK(optics->extinction_per_m[2].band[0] == .3);
    CHECK(optics->extinction_per_m[2].band[1] == .2);
    murk_optics_destroy(optics);
    murk_free_keys_destroy(keys);
}

static void test_values_out_of_range_are_named(void)
{
    static const char *const asked[] = {"media.plain.albedo"};
    const double value = 1.5;
    field f;
    make_field(&f, AS_IT_STANDS);
    murk_free_keys *keys = made(&f, asked, 1, NULL);
    murk_scene_desc *at = NULL;
    murk_error err = {0};
    CHECK(murk_free_scene(&at, keys, 0, &value, &err) == MURK_BAD_VALUE);
    CHECK(at == NULL);
    CHECK_MENTIONS(err.where, "keys media.plain.albedo");
    CHECK_MENTIONS(err.text, "0..1");
    murk_free_keys_destroy(keys);
}

/* ---- conditions ---- */

static void test_each_condition_has_its_own(void)
{
    /* One key for each condition, and one for all. */
    static const char *const asked[] = {"media.fog.visibility_m@each",
                                        "media.two.albedo.0"};
    field f;
    make_field(&f, AS_IT_STANDS | 1);
    murk_free_keys *keys = made(&f, asked, 2, NULL);
    /* The first stands for two parameters, with names and starts of the
     * conditions. */
    CHECK(keys->conditions == 2 && keys->n == 3);
    CHECK(keys->condition[0] == SIZE_MAX && keys->condition[1] == 0);
    CHECK_TEXT(keys->condition_name[1], "dawn");
    CHECK_TEXT(keys->key[0].name, "media.fog.visibility_m@scene");
    CHECK_TEXT(keys->key[1].name, "media.fog.visibility_m@dawn");
    CHECK(keys->key[0].start == 80 && keys->key[1].start == 50);
    /* Each parameter is in its own condition, and the common one in both. */
    CHECK(keys->key[0].is_in[0] && !keys->key[0].is_in[1]);
    CHECK(!keys->key[1].is_in[0] && keys->key[1].is_in[1]);
    CHECK(keys->key[2].is_in[0] && keys->key[2].is_in[1]);
    /* The scene of a condition has the values of these parameters. */
    const double value[] = {60, 40, .7};
    for (size_t c = 0; c < 2; ++c) {
        murk_scene_desc *at = NULL;
        static const char *const key_path[] = {"media", "fog", "visibility_m"};
        CHECK(murk_free_scene(&at, keys, c, value, NULL) == MURK_OK);
        CHECK(resolved(at, key_path, 3) == value[c]);
        CHECK(at->media[3].albedo.band[0] == .7);
        CHECK(at->media[3].albedo.band[1] == .95);
        murk_scene_desc_destroy(at);
    }
    murk_free_keys_destroy(keys);
}

/* One value for all wins over what a condition sets; where a condition puts
 * another medium, the key has no say. */
static void test_one_value_wins_over_a_condition(void)
{
    static const char *const asked[] = {"media.fog.visibility_m",
                                        "media.plain.extinction_per_m"};
    field f;
    make_field(&f, 3);
    murk_free_keys *keys = made(&f, asked, 2, NULL);
    CHECK(keys->conditions == 2 && keys->n == 2);
    CHECK(keys->key[0].start == 50); /* of dawn, the first in use */
    CHECK(keys->key[1].is_in[0] && !keys->key[1].is_in[1]);
    CHECK_MENTIONS(noted, "noon has no such key");
    const double value[] = {33, .4};
    for (size_t c = 0; c < 2; ++c) {
        murk_scene_desc *at = NULL;
        static const char *const key_path[] = {"media", "fog", "visibility_m"};
        CHECK(murk_free_scene(&at, keys, c, value, NULL) == MURK_OK);
        CHECK(resolved(at, key_path, 3) == 33);
        CHECK(at->media[2].profile_z_m.n == (c == 0 ? 0 : 2));
        murk_scene_desc_destroy(at);
    }
    murk_free_keys_destroy(keys);
}

static void test_gains_are_of_readings(void)
{
    static const char *const asked[] = {"gain.other", "media.plain.albedo"};
    field f;
    make_field(&f, AS_IT_STANDS | 1);
    murk_free_keys *keys = made(&f, asked, 2, NULL);
    CHECK(keys->key[0].kind == MURK_FREE_GAIN && keys->key[0].gain == 1);
    CHECK(keys->key[0].start == 1 && keys->key[0].lower == 0);
    CHECK(keys->key[1].gain == SIZE_MAX);
    CHECK(!keys->key[0].is_in[0] && keys->key[0].is_in[1]);
    murk_free_keys_destroy(keys);
}

/* ---- differences ---- */

static void test_differences_keep_the_bounds(void)
{
    static const char *const asked[] = {"media.plain.albedo",
                                        "media.plain.extinction_per_m",
                                        "media.sharp.phase.fournier_forand.1"};
    field f;
    make_field(&f, AS_IT_STANDS);
    murk_free_keys *keys = made(&f, asked, 3, NULL);
    double low, high;
    murk_free_key_around(keys, 0, .9, &low, &high);
    CHECK_NEAR(high - .9, .9 - low, 1e-15);
    CHECK(high - low > 1e-6 && high - low < 1e-4);
    murk_free_key_around(keys, 0, 1, &low, &high);
    CHECK(high == 1 && low < 1 && low > .9999);
    murk_free_key_around(keys, 0, 0, &low, &high);
    CHECK(low == 0 && high > 0 && high < 1e-4);
    murk_free_key_around(keys, 1, 1e-6, &low, &high);
    CHECK_NEAR((high - low) / 1e-6, 2e-5, 1e-9);
    /* tables: their nodes are right to 1e-5 alone */
    murk_free_key_around(keys, 2, 3.6, &low, &high);
    CHECK(high - low > .1 && high < 4.9999);
    murk_free_keys_destroy(keys);
}

/* The slope of extinction by visibility is -extinction / visibility at 550 nm,
 * and Kruse's exponent turns with visibility, too. */
static void test_differences_are_the_laws_slopes(void)
{
    static const char *const asked[] = {"media.fog.visibility_m"};
    field f;
    make_field(&f, AS_IT_STANDS);
    murk_free_keys *keys = made(&f, asked, 1, NULL);
    double low, high;
    murk_optics *at_low = NULL, *at_high = NULL;
    murk_free_key_around(keys, 0, 80, &low, &high);
    CHECK(murk_free_optics(&at_low, keys, 0, &low, NULL) == MURK_OK);
    CHECK(murk_free_optics(&at_high, keys, 0, &high, NULL) == MURK_OK);
    const double q = .585 * cbrt(.08), l = log(532. / 550);
    const double sigma = -log(.02) / 80 * exp(-q * l);
    const double want = -sigma / 80 * (1 + q / 3 * l);
    const double got = (at_high->extinction_per_m[0].band[1] -
                        at_low->extinction_per_m[0].band[1]) /
                       (high - low);
    CHECK_NEAR(got / want, 1, 1e-8);
    murk_optics_destroy(at_low);
    murk_optics_destroy(at_high);
    murk_free_keys_destroy(keys);
}

int main(void)
{
    /* Write the scene to a file, and read it once for all tests. */
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
    /* Keys and values. */
    test_keys_are_what_they_turn();
    test_ranges_are_natural();
    test_a_scene_has_the_values();
    test_a_band_of_one_value_is_its_own();
    test_values_out_of_range_are_named();
    /* Conditions, gains and differences. */
    test_each_condition_has_its_own();
    test_one_value_wins_over_a_condition();
    test_gains_are_of_readings();
    test_differences_keep_the_bounds();
    test_differences_are_the_laws_slopes();
    unlink(path);
    murk_scene_desc_destroy(scene);
    return check_done();
}
