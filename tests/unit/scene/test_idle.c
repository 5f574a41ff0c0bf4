/* Keys that are given in vain: each rule names its key where it does nothing,
 * and is silent where it acts, where the key is at its default, and where a
 * condition makes it act. The reference lists them all. Nothing here is
 * random. */
#include "check.h"
#include "reference.h"
#include "scene/idle.h"

#include <stdlib.h>

static const char *const SCENE =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "media: {fog: {extinction_per_m: 0.1, albedo: 0.9}}\n"
    "regions: [{medium: fog}]\n"
    "lights: [{type: point, position_m: [1, 1, 1], power_w: 1}]\n"
    "photons: {emit: 100}\n"
    "sensors: {types: [{name: node, range_m: 4}], count: 1}\n";

typedef struct idle_case {
    const char *rule;           /* its key */
    const char *idle, *acts;    /* what is set besides, for one and the other */
    const char *given, *preset; /* the key as it is given, and at its default
                                   (NULL: it has none) */
} idle_case;

static const idle_case CASES[] = {
    {"domain.outside", "domain.sides=periodic", "domain.sides=open",
     "domain.outside=continued", "domain.outside=empty"},
    {"placement.threshold", "placement.detection=weighted",
     "placement.detection=threshold", "placement.threshold=0.2",
     "placement.threshold=5e-2"},
    {"placement.power_radius_m", "placement.detection=weighted",
     "placement.detection=power", "placement.power_radius_m=1", NULL},
    {"placement.power_neighbours", "placement.detection=weighted",
     "placement.detection=power", "placement.power_neighbours=20",
     "placement.power_neighbours=64"},
    {"placement.through", "placement.visibility=normal",
     "placement.visibility=ray", "placement.through=refract", NULL},
    {"placement.start_m", "placement.knowledge=known",
     "placement.knowledge=explore", "placement.start_m=[1, 1, 1]", NULL},
    {"placement.start_plan", "placement.method=greedy", "placement.method=best",
     "placement.start_plan=plan.json", NULL},
    {"placement.restarts", "placement.method=greedy", "placement.method=best",
     "placement.restarts=7", "placement.restarts=200"},
    {"placement.nodes", "placement.knowledge=unknown",
     "placement.knowledge=known", "placement.nodes=7",
     "placement.nodes=1000000"},
    {"placement.moves_at_most", "placement.method=best",
     "placement.start_plan=plan.json", "placement.moves_at_most=1", NULL},
    {"placement.move_cost", "placement.method=best",
     "placement.start_plan=plan.json", "placement.move_cost=0.1",
     "placement.move_cost=0"},
    {"placement.look_ahead", "placement.method=best",
     "timeline={times_s: [0, 1]}", "placement.look_ahead=2",
     "placement.look_ahead=1"},
    {"placement.restarts", "placement.start_plan=plan.json",
     "placement.method=best", "placement.restarts=7", "placement.restarts=200"},
    {"placement.nodes", "placement.start_plan=plan.json",
     "placement.method=best", "placement.nodes=7", "placement.nodes=1000000"},
    {"placement.at_least", "sensors.count=1", "sensors.target=0.5",
     "placement.at_least=2", NULL},
    {"placement.elsewhere", "placement.interest=[]",
     "placement.interest=[{name: a, medium: fog}]", "placement.elsewhere=0.5",
     "placement.elsewhere=1"},
    {"placement.jitter_draws", "placement.jitter_m=0", "placement.jitter_m=0.1",
     "placement.jitter_draws=7", "placement.jitter_draws=100"},
    {"placement.condition_weights", "conditions={a: {}, b: {}}",
     "placement.over=mean", "placement.condition_weights={a: 2}", NULL},
    {"placement.regret", "conditions={a: {}, b: {}}", "placement.over=regret",
     "placement.regret=relative", "placement.regret=absolute"},
    {"sensors.types.*.aperture_m2", "placement.detection=weighted",
     "placement.detection=power", "sensors.types.0.aperture_m2=1",
     "sensors.types.0.aperture_m2=1e-4"},
    {"sensors.types.*.quantum_efficiency", "placement.detection=weighted",
     "placement.detection=power", "sensors.types.0.quantum_efficiency=1",
     "sensors.types.0.quantum_efficiency=0.5"},
    {"sensors.types.*.exposure_s", "placement.detection=weighted",
     "placement.detection=power", "sensors.types.0.exposure_s=1",
     "sensors.types.0.exposure_s=0.01"},
    {"sensors.types.*.target_m2", "placement.detection=weighted",
     "placement.detection=power", "sensors.types.0.target_m2=1",
     "sensors.types.0.target_m2=1e-4"},
    {"sensors.types.*.target_m3", "placement.detection=weighted",
     "placement.detection=power", "sensors.types.0.target_m3=1",
     "sensors.types.0.target_m3=1e-6"},
    {"sensors.types.*.cost", "sensors.count=2", "sensors.budget=4",
     "sensors.types.0.cost=2", "sensors.types.0.cost=1"},
    {"photons.store_when", "photons.maps=none", "photons.maps=volume",
     "photons.store_when=hit", "photons.store_when=reflected"},
    {"photons.max_stored", "photons.maps=none", "photons.maps=volume",
     "photons.max_stored=1000", "photons.max_stored=1e8"},
    {"site", "lights.0.schedule=always", "lights.0.schedule=[[06:00, 22:00]]",
     "site={time: 2026-06-21T12:00:00Z, time_zone: Z}", NULL},
    {"weather", "media.fog={extinction_per_m: 0.1, albedo: 1}",
     "media.fog={preset: weather}",
     "weather={metar: 'EGHI 150650Z 0500 11/10'}", NULL},
};
#define N_CASES (sizeof CASES / sizeof *CASES)

/* The scene of ROOM with these set, NULL ends them; NULL after printing. */
static murk_scene_desc *scene_with(const char *const *set)
{
    murk_override override[4];
    size_t n = 0;
    for (; set[n]; ++n) {
        override[n] = (murk_override){.text = set[n]};
    }
    murk_scene_desc *scene = NULL;
    murk_error err = {0};
    if (murk_scene_desc_parse(&scene, SCENE, "room.yaml", override, n, &err)) {
        printf("%s: %s\n", err.where, err.text);
    }
    CHECK(scene != NULL);
    return scene;
}

/* How many warnings there are with these set. */
static size_t idle_with(const char *a, const char *b, const char *c)
{
    murk_scene_desc *scene = scene_with((const char *const[]){a, b, c, NULL});
    const size_t n = scene ? scene->idles : SIZE_MAX;
    murk_scene_desc_destroy(scene);
    return n;
}

/* True if a rule of this key has this text. */
static bool is_of_rule(const char *rule, const char *text)
{
    bool is_it = false;
    for (const murk_idle_key *r = murk_idle_keys; r->key; ++r) {
        is_it |= strcmp(r->key, rule) == 0 && strcmp(r->text, text) == 0;
    }
    return is_it;
}

static void check_idle(const idle_case *c)
{
    murk_scene_desc *scene =
        scene_with((const char *const[]){c->idle, c->given, NULL});
    CHECK(scene && scene->idles == 1);
    if (scene && scene->idles == 1) {
        CHECK(is_of_rule(c->rule, scene->idle[0].text));
        CHECK(strncmp(scene->idle[0].where, "--set ", 6) == 0);
        CHECK(strstr(scene->idle[0].where, c->given));
    } else {
        printf("%s\n", c->rule);
    }
    murk_scene_desc_destroy(scene);
}

static void test_each_rule(void)
{
    size_t constraints = 0;
    for (const murk_idle_key *r = murk_idle_keys; r->key; ++r) {
        ++constraints;
    }
    CHECK(constraints == N_CASES);
    for (size_t i = 0; i < N_CASES; ++i) {
        const idle_case *c = &CASES[i];
        check_idle(c);
        const bool is_over =
            strcmp(c->rule, "placement.condition_weights") == 0 ||
            strcmp(c->rule, "placement.regret") == 0;
        const bool is_acting =
            idle_with(c->given, c->acts, is_over ? c->idle : NULL) == 0;
        CHECK(is_acting);
        CHECK(!c->preset || idle_with(c->idle, c->preset, NULL) == 0);
        if (!is_acting) {
            printf("%s\n", c->rule);
        }
    }
}

static void test_a_condition_may_make_it_act(void)
{
    CHECK(idle_with("lights.0.schedule=always",
                    "site={latitude_deg: 52, longitude_deg: 5, time: "
                    "2026-06-21T12:00:00Z, time_zone: Z}",
                    "conditions={night: {lights.0.schedule: night}}") == 0);
    CHECK(idle_with("media.mist={extinction_per_m: 1, albedo: 1}", NULL,
                    NULL) == 1);
    CHECK(idle_with("media.mist={extinction_per_m: 1, albedo: 1}",
                    "conditions={misty: {regions.0.medium: mist}}", NULL) == 0);
}

#define TIMELINE(track) "timeline={times_s: [0, 1], tracks: [" track "]}"

/* At other times keys act that do not now, by a track or, as those of the first
 * step do, without a start plan; with one each step begins at a plan. */
static void test_another_time_may_make_it_act(void)
{
    CHECK(idle_with(TIMELINE(""), "placement.moves_at_most=1",
                    "placement.move_cost=0.1") == 0);
    CHECK(idle_with(TIMELINE(""), "placement.nodes=7",
                    "placement.restarts=7") == 0);
    CHECK(idle_with(TIMELINE(""), "placement.nodes=7",
                    "placement.start_plan=plan.json") == 1);
    CHECK(idle_with("media.mist={extinction_per_m: 1, albedo: 1}", TIMELINE(""),
                    NULL) == 1);
    CHECK(idle_with("media.mist={extinction_per_m: 1, albedo: 1}",
                    TIMELINE("{key: regions.0.medium, keyframes: [{t_s: 0, "
                             "value: fog}, {t_s: 1, value: mist}]}"),
                    NULL) == 0);
    CHECK(idle_with("site={time: 2026-06-21T12:00:00Z, time_zone: Z}",
                    TIMELINE("{key: lights.0.schedule, keyframes: [{t_s: 0, "
                             "value: always}, {t_s: 1, value: night}]}"),
                    NULL) == 0);
}

/* All defaults are written out there, which are nobody's wishes. */
static void test_the_scene_as_resolved_says_the_same(void)
{
    const char *const overrides[] = {"placement.threshold=0.2",
                                     "placement.start_m=[1, 1, 1]", NULL};
    for (size_t first = 0; first < 3; ++first) {
        murk_scene_desc *scene = scene_with(overrides + first), *again = NULL;
        murk_error err = {0};
        CHECK(scene && !murk_scene_desc_parse(&again, scene->resolved,
                                              "scene.yaml", NULL, 0, &err));
        CHECK(scene && again && scene->idles == 2 - first &&
              again->idles == scene->idles);
        murk_scene_desc_destroy(scene);
        murk_scene_desc_destroy(again);
    }
}

static void test_the_place_is_that_of_the_key(void)
{
    char text[1000];
    snprintf(text, sizeof text, "%splacement:\n  threshold: 0.3\n", SCENE);
    murk_scene_desc *scene = NULL;
    murk_error err = {0};
    CHECK(!murk_scene_desc_parse(&scene, text, "room.yaml", NULL, 0, &err));
    CHECK(scene && scene->idles == 1);
    if (scene && scene->idles == 1) {
        CHECK_TEXT(scene->idle[0].where, "room.yaml:9:3: placement.threshold");
    }
    murk_scene_desc_destroy(scene);
}

static void test_the_reference_lists_them(void)
{
    char *reference = reference_read();
    for (const murk_idle_key *r = murk_idle_keys; reference && r->key; ++r) {
        char row[300];
        snprintf(row, sizeof row, "| `%s` | %s |\n", r->key, r->text);
        CHECK(strstr(reference, row));
    }
    free(reference);
}

int main(void)
{
    test_each_rule();
    test_a_condition_may_make_it_act();
    test_another_time_may_make_it_act();
    test_the_scene_as_resolved_says_the_same();
    test_the_place_is_that_of_the_key();
    test_the_reference_lists_them();
    return check_done();
}
