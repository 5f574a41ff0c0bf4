#include "results/robust.h"

#include "results/results.h"
#include "results/summary.h"

#include <math.h>

#define DEG_PER_RAD (180 / MURK_PI)

/* Sensors are numbered from 1, as in coverage.csv. */
static void add_number(cJSON *object, const char *key, size_t sensor)
{
    cJSON_AddNumberToObject(object, key, (double)sensor + 1);
}

static void add_drop_one(cJSON *object, const murk_robust *r)
{
    const murk_drop_one drop = murk_robust_drop_one(r);
    cJSON *item = cJSON_AddObjectToObject(object, "drop_one");
    if (isfinite(drop.worst_loss)) {
        add_number(item, "worst_sensor", drop.worst);
    } else {
        cJSON_AddNullToObject(item, "worst_sensor");
    }
    murk_json_number(item, "worst_loss", drop.worst_loss);
    murk_json_number(item, "mean_loss", drop.mean_loss);
    cJSON *list = cJSON_AddArrayToObject(item, "without");
    for (size_t i = 0; i < r->sensors; ++i) {
        cJSON *one = cJSON_CreateObject();
        add_number(one, "sensor", i);
        murk_json_number(one, "in_sample", r->without[i]);
        murk_json_number(one, "held_out",
                         r->without_held_out ? r->without_held_out[i] : NAN);
        cJSON_AddItemToArray(list, one);
    }
}

static double asked_deg(const murk_scene_desc *scene)
{
    return round(scene->placement.jitter_rad * DEG_PER_RAD * 1e9) / 1e9;
}

static void add_jitter(cJSON *object, const murk_scene_desc *scene,
                       const murk_jittered *j)
{
    if (j->draws == 0) {
        cJSON_AddNullToObject(object, "jitter");
        return;
    }
    cJSON *item = cJSON_AddObjectToObject(object, "jitter");
    murk_json_number(item, "jitter_m", scene->placement.jitter_m);
    murk_json_number(item, "jitter_deg", asked_deg(scene));
    cJSON_AddNumberToObject(item, "draws", (double)j->draws);
    cJSON_AddStringToObject(item, "measured",
                            j->on_held_out ? "held_out" : "in_sample");
    murk_json_number(item, "as_planned", j->as_planned);
    murk_json_number(item, "mean", j->mean.value);
    murk_json_number(item, "mean_standard_error", j->mean.standard_error);
    murk_json_number(item, "quantile_5", j->quantile);
    murk_json_number(item, "quantile_5_lower", j->quantile_lower);
    murk_json_number(item, "quantile_5_upper", j->quantile_upper);
    cJSON_AddNumberToObject(item, "unmoved", (double)j->unmoved);
}

static void add_links(cJSON *object, const murk_links *links)
{
    murk_json_number(object, "link_range_m", links->range_m);
    murk_json_number(object, "plain_link_range_m", links->plain_range_m);
    if (links->groups > 0) {
        cJSON_AddNumberToObject(object, "link_groups", (double)links->groups);
    } else {
        cJSON_AddNullToObject(object, "link_groups");
    }
    cJSON *list = cJSON_AddArrayToObject(object, "links");
    for (size_t i = 0; i < links->n; ++i) {
        cJSON *one = cJSON_CreateObject();
        add_number(one, "from", links->link[i].from);
        add_number(one, "to", links->link[i].to);
        murk_json_number(one, "length_m", links->link[i].length_m);
        cJSON_AddItemToArray(list, one);
    }
}

void murk_json_robust(cJSON *root, const murk_scene_desc *scene,
                      const murk_robust *robust)
{
    cJSON *object = cJSON_AddObjectToObject(root, "robustness");
    add_drop_one(object, robust);
    add_jitter(object, scene, &robust->jittered);
    add_links(object, &robust->links);
}

static void print_jitter(const murk_scene_desc *scene, const murk_jittered *j,
                         size_t sensors)
{
    if (j->draws == 0) {
        return;
    }
    murk_print(
        "jitter      within %.4g m and %.4g degrees: mean %.4f +- %.4f, 5 %% "
        "quantile %.4f",
        scene->placement.jitter_m, asked_deg(scene), j->mean.value,
        j->mean.standard_error, j->quantile);
    if (isfinite(j->quantile_lower) && isfinite(j->quantile_upper)) {
        murk_print(" (95 %%: %.4f..%.4f)", j->quantile_lower,
                   j->quantile_upper);
    }
    murk_print(", %s; %.4f as planned\n",
               j->on_held_out ? "held out" : "in sample", j->as_planned);
    if (j->unmoved > 0) {
        murk_print(
            "            %zu of %zu places stayed: no free place within reach "
            "was found\n",
            j->unmoved, j->draws * sensors);
    }
}

static void print_links(const murk_links *links)
{
    if (links->groups == 0) {
        return;
    }
    if (links->groups == 1) {
        murk_print("links       of %.4g m join all sensors by open ways",
                   links->range_m);
    } else {
        murk_print("links       of no range join all sensors by open ways: %zu "
                   "groups",
                   links->groups);
    }
    murk_print("; of %.4g m, were all ways open\n", links->plain_range_m);
}

void murk_print_robust(const murk_scene_desc *scene, const murk_robust *robust)
{
    const murk_drop_one drop = murk_robust_drop_one(robust);
    if (isfinite(drop.worst_loss)) {
        murk_print("drop one    coverage falls by %.4f at most (without sensor "
                   "%zu), by %.4f in the mean%s\n",
                   drop.worst_loss, drop.worst + 1, drop.mean_loss,
                   robust->without_held_out ? ", held out" : "");
    }
    print_jitter(scene, &robust->jittered, robust->sensors);
    if (robust->sensors > 1) {
        print_links(&robust->links);
    }
}
