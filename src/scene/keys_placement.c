/* Keys of placement: the method of the search, and the value of a plan. */
#include "scene/keys_rows.h"

static murk_status check_weights(murk_key_reader *walk, const murk_yaml *map,
                                 void *item)
{
    const murk_scene_placement *placement =
        &((murk_scene_desc *)item)->placement;
    if (!(placement->weight_surface + placement->weight_volume > 0)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "surface and volume are both 0, one must be "
                              "more than 0");
    }
    return MURK_OK;
}

static const murk_key WEIGHTS_ROWS[] = {
    ROW("surface", NUMBER, NEEDED, .max = 1e6,
        AT(murk_scene_desc, placement.weight_surface)),
    ROW("volume", NUMBER, NEEDED, .max = 1e6,
        AT(murk_scene_desc, placement.weight_volume)),
    END,
};

static const murk_keys WEIGHTS = {
    .noun = "weights",
    .check = check_weights,
    .key = WEIGHTS_ROWS,
};

#define METHOD_WORD(id, name) {name, MURK_PLACE_##id},
static const murk_word METHOD_WORDS[] = {MURK_PLACE_METHODS(METHOD_WORD)
                                             WORDS_END};

#define DETECTION_WORD(id, name, is) {name, MURK_DETECTION_##id},
static const murk_word DETECTION_WORDS[] = {MURK_DETECTIONS(DETECTION_WORD)
                                                WORDS_END};

static const murk_word VISIBILITY_WORDS[] = {
    {"ray", 0},
    {"normal", 1},
    WORDS_END,
};

static const murk_word THROUGH_WORDS[] = {
    {"thin", MURK_SCENE_THIN},
    {"block", MURK_SCENE_BLOCK},
    {"refract", MURK_SCENE_REFRACT},
    WORDS_END,
};

static const murk_word KNOWLEDGE_WORDS[] = {
    {"known", MURK_SCENE_KNOWN},
    {"unknown", MURK_SCENE_UNKNOWN},
    {"explore", MURK_SCENE_EXPLORE},
    WORDS_END,
};

static const murk_word WEIGHTS_WORDS[] = {
    {"balanced", 1},
    WORDS_END,
};

static const murk_word OBJECTIVE_WORDS[] = {
    {"null", MURK_SCENE_OBJECTIVE_NONE},
    {"mean", MURK_SCENE_OBJECTIVE_MEAN},
    {"worst", MURK_SCENE_OBJECTIVE_WORST},
    {"regret", MURK_SCENE_OBJECTIVE_REGRET},
    WORDS_END,
};

static const murk_word REGRET_WORDS[] = {
    {"absolute", 0},
    {"relative", 1},
    WORDS_END,
};

static const murk_word TARGETS_WORDS[] = {
    {"photons", 0},
    WORDS_END,
};

static const murk_key PLACEMENT_ROWS[] = {
    ROW("method", WORD, .preset = "best", .words = METHOD_WORDS,
        AT(murk_scene_desc, placement.method)),
    ROW("detection", WORD, .preset = "weighted", .words = DETECTION_WORDS,
        AT(murk_scene_desc, placement.detection)),
    ROW("threshold", NUMBER, .above = true, .max = 1, .preset = "0.05",
        AT(murk_scene_desc, placement.threshold)),
    ROW("power_radius_m", NUMBER, SIZE_M,
        AT(murk_scene_desc, placement.power_radius_m)),
    ROW("power_neighbours", COUNT, .min = 12, .max = 128, .preset = "64",
        AT(murk_scene_desc, placement.power_neighbours)),
    ROW("visibility", WORD, .preset = "ray", .words = VISIBILITY_WORDS,
        AT(murk_scene_desc, placement.by_normal)),
    ROW("through", WORD, .preset = "thin", .words = THROUGH_WORDS,
        AT(murk_scene_desc, placement.through)),
    ROW("knowledge", WORD, .preset = "known", .words = KNOWLEDGE_WORDS,
        AT(murk_scene_desc, placement.knowledge)),
    ROW("start_m", VECTOR, LONG_M, AT(murk_scene_desc, placement.start),
        FLAG(murk_scene_desc, placement.has_start)),
    ROW("restarts", COUNT, .min = 1, .max = 1e6, .preset = "200",
        AT(murk_scene_desc, placement.restarts)),
    ROW("redundancy", COUNT, .min = 1, .max = 16, .preset = "1",
        AT(murk_scene_desc, placement.redundancy)),
    ROW("at_least", COUNT, .min = 1, .max = 16,
        AT(murk_scene_desc, placement.at_least)),
    ROW("weights", MAP, .keys = &WEIGHTS, .preset = "balanced",
        .words = WEIGHTS_WORDS, AT(murk_scene_desc, placement.balanced)),
    ROW("interest", LIST, .keys = &murk_interest_keys, .preset = "[]"),
    ROW("elsewhere", NUMBER, .max = 1e6, .preset = "1",
        AT(murk_scene_desc, placement.elsewhere)),
    ROW("targets", MAP, .keys = &murk_target_keys, .preset = "photons",
        .words = TARGETS_WORDS),
    ROW("hold_out", BOOL, .preset = "true",
        AT(murk_scene_desc, placement.hold_out)),
    ROW("jitter_m", NUMBER, .max = 1e9, .unit = "m", .preset = "0",
        AT(murk_scene_desc, placement.jitter_m)),
    ROW("jitter_deg", NUMBER, .max = 180, .unit = "degrees", .preset = "0",
        .factor = MURK_PI / 180, AT(murk_scene_desc, placement.jitter_rad)),
    ROW("jitter_draws", COUNT, .min = 2, .max = 1e6, .preset = "100",
        AT(murk_scene_desc, placement.jitter_draws)),
    ROW("nodes", COUNT, .max = 1e15, .preset = "1000000",
        AT(murk_scene_desc, placement.nodes)),
    ROW("over", WORD, .preset = "null", .words = OBJECTIVE_WORDS,
        AT(murk_scene_desc, placement.over)),
    ROW("regret", WORD, .preset = "absolute", .words = REGRET_WORDS,
        AT(murk_scene_desc, placement.relative_regret)),
    ROW("condition_weights", MAP, .keys = &murk_condition_weight_keys,
        .preset = "{}"),
    END,
};

/* at_least counts sensors per photon: it needs certain detection, a search
 * that knows all photons, and a single condition. */
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
               ? murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                                "at_least is given, which needs %s", cause)
               : MURK_OK;
}

/* Checks that involve the regions of interest. */
static murk_status check_placement(murk_key_reader *walk, const murk_yaml *map,
                                   void *item)
{
    const murk_scene_placement *placement =
        &((murk_scene_desc *)item)->placement;
    double max = placement->elsewhere;
    for (size_t i = 0; i < placement->n_interests; ++i) {
        max = fmax(max, placement->interest[i].weight);
    }
    if (!(max > 0)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "elsewhere and the weights of interest are all "
                              "0, one must be more than 0");
    }
    if (murk_detection_is(placement->detection, MURK_DETECTION_BY_CHANCE) &&
        placement->redundancy > 1) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "redundancy is %llu with detection: %s, must be "
                              "1: all views count there",
                              (unsigned long long)placement->redundancy,
                              murk_detection_name(placement->detection));
    }
    return check_at_least(walk, map, placement);
}

const murk_keys murk_placement_keys = {
    .noun = "placement",
    .check = check_placement,
    WHERE(murk_scene_desc, placement.where),
    .key = PLACEMENT_ROWS,
};
