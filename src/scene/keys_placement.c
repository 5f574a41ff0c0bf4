/* Keys of placement: the method of the search, and the value of a plan. */
#include "scene/keys_rows.h"

#include <stdio.h>

static murk_status check_weights(murk_key_reader *walk, const murk_yaml *map,
                                 void *item)
{
    const murk_scene_placement *placement = item;
    return placement->weight_surface + placement->weight_volume > 0
               ? MURK_OK
               : murk_walk_fail(
                     walk, map,
                     "surface and volume are both 0, one must be more than 0");
}

#define PLAN(member) AT(murk_scene_placement, member)

static const murk_key WEIGHTS_ROWS[] = {
    ROW("surface", NUMBER, NEEDED, .max = 1e6, PLAN(weight_surface)),
    ROW("volume", NUMBER, NEEDED, .max = 1e6, PLAN(weight_volume)),
    END,
};

static const murk_keys WEIGHTS = {
    .noun = "weights", .check = check_weights, .key = WEIGHTS_ROWS};

#define METHOD_WORD(id, name) {name, MURK_PLACE_##id},
static const murk_word METHOD_WORDS[] = {MURK_PLACE_METHODS(METHOD_WORD)
                                             WORDS_END};

#define DETECTION_WORD(id, name, is) {name, MURK_DETECTION_##id},
static const murk_word DETECTION_WORDS[] = {MURK_DETECTIONS(DETECTION_WORD)
                                                WORDS_END};

static const murk_key PLACEMENT_ROWS[] = {
    ROW("method", WORD, .preset = "best", .words = METHOD_WORDS, PLAN(method)),
    ROW("detection", WORD, .preset = "weighted", .words = DETECTION_WORDS,
        PLAN(detection)),
    ROW("threshold", NUMBER, .above = true, .max = 1, .preset = "0.05",
        PLAN(threshold)),
    ROW("power_radius_m", NUMBER, SIZE_M, PLAN(power_radius_m)),
    ROW("power_neighbours", COUNT, .min = 12, .max = 128, .preset = "64",
        PLAN(power_neighbours)),
    ROW("visibility", WORD, .preset = "ray", WORDS({"ray", 0}, {"normal", 1}),
        PLAN(by_normal)),
    ROW("through", WORD, .preset = "thin", PLAN(through),
        WORDS({"thin", MURK_SCENE_THIN}, {"block", MURK_SCENE_BLOCK},
              {"refract", MURK_SCENE_REFRACT})),
    ROW("knowledge", WORD, .preset = "known", PLAN(knowledge),
        WORDS({"known", MURK_SCENE_KNOWN}, {"unknown", MURK_SCENE_UNKNOWN},
              {"explore", MURK_SCENE_EXPLORE})),
    ROW("memory_mb", NUMBER, .max = 1e9, .unit = "MiB", .preset = "1024",
        PLAN(memory_mb)),
    ROW("start_m", VECTOR, PLACE_M, PLAN(start),
        FLAG(murk_scene_placement, has_start)),
    ROW("start_plan", PATH, PLAN(start_plan)),
    ROW("moves_at_most", COUNT, .max = 1e6, PLAN(moves_max),
        FLAG(murk_scene_placement, limits_moves)),
    ROW("move_cost", NUMBER, .max = 1, .preset = "0", PLAN(move_cost)),
    ROW("look_ahead", COUNT, .min = 1, .max = MURK_SCENE_CONDITIONS_MAX,
        .preset = "1", PLAN(steps_ahead)),
    ROW("restarts", COUNT, .min = 1, .max = 1e6, .preset = "200",
        PLAN(restarts)),
    ROW("redundancy", COUNT, .min = 1, .max = 16, .preset = "1",
        PLAN(redundancy)),
    ROW("at_least", COUNT, .min = 1, .max = 16, PLAN(at_least)),
    ROW("weights", MAP, .keys = &WEIGHTS, .preset = "balanced",
        WORDS({"balanced", 1}), PLAN(balanced)),
    ROW("interest", LIST, .keys = &murk_interest_keys, .preset = "[]"),
    ROW("elsewhere", NUMBER, .max = 1e6, .preset = "1", PLAN(elsewhere)),
    ROW("targets", MAP, .keys = &murk_target_keys, .preset = "photons",
        WORDS({"photons", 0}), INSIDE(murk_scene_placement, targets)),
    ROW("hold_out", BOOL, .preset = "true", PLAN(hold_out)),
    ROW("jitter_m", NUMBER, .max = 1e9, .unit = "m", .preset = "0",
        PLAN(jitter_m)),
    ROW("jitter_deg", NUMBER, .max = 180, RADIANS, .preset = "0",
        PLAN(jitter_rad)),
    ROW("jitter_draws", COUNT, .min = 2, .max = 1e6, .preset = "100",
        PLAN(jitter_draws)),
    ROW("nodes", COUNT, .max = 1e15, .preset = "1000000", PLAN(nodes)),
    ROW("time_limit_s", NUMBER, .above = true, .max = 1e9, .unit = "s",
        PLAN(time_limit_s)),
    ROW("over", WORD, .preset = "null", PLAN(over),
        WORDS({"null", MURK_SCENE_OBJECTIVE_NONE},
              {"mean", MURK_SCENE_OBJECTIVE_MEAN},
              {"worst", MURK_SCENE_OBJECTIVE_WORST},
              {"regret", MURK_SCENE_OBJECTIVE_REGRET})),
    ROW("regret", WORD, .preset = "absolute",
        WORDS({"absolute", 0}, {"relative", 1}), PLAN(relative_regret)),
    ROW("condition_weights", MAP, .keys = &murk_condition_weight_keys,
        .preset = "{}"),
    END,
};

/* at_least counts sensors per photon: it needs detection without chance, a
 * method other than spoq, a search that knows all photons, and no objective
 * over conditions. */
static murk_status check_at_least(murk_key_reader *walk, const murk_yaml *map,
                                  const murk_scene_placement *placement)
{
    const murk_detection_text certain =
        murk_detection_list(MURK_DETECTION_BY_CHANCE, false, " or ");
    char detection[sizeof certain.text + 16];
    snprintf(detection, sizeof detection, "detection: %s", certain.text);
    const char *cause =
        murk_detection_is(placement->detection, MURK_DETECTION_BY_CHANCE)
            ? detection
        : placement->method == MURK_PLACE_SPOQ ? "method: best, greedy or exact"
        : placement->knowledge != MURK_SCENE_KNOWN     ? "knowledge: known"
        : placement->over != MURK_SCENE_OBJECTIVE_NONE ? "over: null"
                                                       : NULL;
    return placement->at_least > 0 && cause
               ? murk_walk_fail(walk, map, "at_least is given, which needs %s",
                                cause)
               : MURK_OK;
}

/* A start plan is for searches; an exploration begins at start_m. */
static murk_status check_start_plan(murk_key_reader *walk, const murk_yaml *map,
                                    const murk_scene_placement *placement)
{
    return placement->start_plan && placement->knowledge == MURK_SCENE_EXPLORE
               ? murk_walk_fail(walk, map,
                                "start_plan is given with knowledge: explore, "
                                "which walks from start_m; knowledge must be "
                                "known or unknown")
               : MURK_OK;
}

/* Plans that move few sensors, and plans for several steps, are searched from
 * what every candidate sees, for one scene. */
static murk_status check_moves(murk_key_reader *walk, const murk_yaml *map,
                               const murk_scene_placement *placement)
{
    const bool has_moves = placement->limits_moves || placement->move_cost > 0;
    const char *cause =
        placement->knowledge != MURK_SCENE_KNOWN       ? "knowledge: known"
        : placement->over != MURK_SCENE_OBJECTIVE_NONE ? "over: null"
        : placement->at_least > 0                      ? "no at_least"
        : has_moves && placement->method == MURK_PLACE_GREEDY
            ? "method: best, spoq or exact"
            : NULL;
    const char *key = placement->limits_moves      ? "moves_at_most"
                      : has_moves                  ? "move_cost"
                      : placement->steps_ahead > 1 ? "look_ahead"
                                                   : NULL;
    return key && cause
               ? murk_walk_fail(walk, map, "%s is given, which needs %s", key,
                                cause)
               : MURK_OK;
}

/* Checks that some photon has a weight, that redundancy fits the mode of
 * detection, and the needs of start_plan, at_least, moves and look_ahead. */
static murk_status check_placement(murk_key_reader *walk, const murk_yaml *map,
                                   void *item)
{
    const murk_scene_placement *placement = item;
    /* The weights of photons. */
    double max = placement->elsewhere;
    for (size_t i = 0; i < placement->n_interests; ++i) {
        max = fmax(max, placement->interest[i].weight);
    }
    if (!(max > 0)) {
        return murk_walk_fail(walk, map,
                              "elsewhere and the weights of interest are all "
                              "0, one must be more than 0");
    }
    if (murk_detection_is(placement->detection, MURK_DETECTION_BY_CHANCE) &&
        placement->redundancy > 1) {
        return murk_walk_fail(walk, map,
                              "redundancy is %llu with detection: %s, must be "
                              "1: all views count there",
                              (unsigned long long)placement->redundancy,
                              murk_detection_name(placement->detection));
    }
    /* Keys that need others. */
    murk_status status = check_start_plan(walk, map, placement);
    if (!status) {
        status = check_moves(walk, map, placement);
    }
    return status ? status : check_at_least(walk, map, placement);
}

const murk_keys murk_placement_keys = {
    .noun = "placement",
    .check = check_placement,
    WHERE(murk_scene_placement, where),
    .key = PLACEMENT_ROWS,
};
