/* Robustness of a plan: fields of JSON and lines of the summary. */
#include "results/robust.h"

#include "results/coverage.h"
#include "results/summary.h"

#include <math.h>

/* Sensors are numbered from 1, as in coverage.csv. */
static void list_without(murk_results_fields *f, const void *of, size_t i)
{
    const murk_robust *r = of;
    MURK_COUNT(f, "sensor", "number, from 1", i + 1);
    MURK_NUMBER(f, "in_sample", "1", "coverage without the sensor",
                r->without[i]);
    MURK_NUMBER(f, "held_out", "1", "the same on a second map",
                r->without_held_out ? r->without_held_out[i] : NAN);
}

static void list_drop_one(murk_results_fields *f, const void *of)
{
    const murk_robust *r = of;
    const murk_drop_one drop = r ? murk_robust_drop_one(r) : (murk_drop_one){0};
    MURK_NUMBER(f, "worst_sensor", "",
                "the sensor whose loss lowers coverage most",
                isfinite(drop.worst_loss) ? (double)drop.worst + 1 : NAN);
    MURK_NUMBER(f, "worst_loss", "1", "coverage lost with that sensor",
                drop.worst_loss);
    MURK_NUMBER(f, "mean_loss", "1", "mean over the sensors", drop.mean_loss);
    MURK_LIST(f, "without", "coverage without each sensor", list_without, r,
              r->sensors);
}

static void list_jitter(murk_results_fields *f, const void *of)
{
    const murk_robust_results *r = of;
    const murk_jittered *j = r ? &r->robust->jittered : NULL;
    MURK_NUMBER(f, "jitter_m", "m", "radius of displacements",
                r->scene->placement.jitter_m);
    MURK_NUMBER(f, "jitter_deg", "degrees", "largest turn",
                murk_degrees(r->scene->placement.jitter_rad));
    MURK_COUNT(f, "draws", "displaced plans", j->draws);
    MURK_TEXT(f, "measured", "held_out or in_sample",
              j->on_held_out ? "held_out" : "in_sample");
    MURK_NUMBER(f, "as_planned", "1", "coverage without displacement",
                j->as_planned);
    MURK_ESTIMATE(f, "mean", "1", "mean coverage of displaced plans", j->mean);
    MURK_NUMBER(f, "quantile_5", "1",
                "coverage that 95 % of displaced plans exceed", j->quantile);
    MURK_NUMBER(f, "quantile_5_lower", "1",
                "lower 95 % confidence limit of quantile_5", j->quantile_lower);
    MURK_NUMBER(f, "quantile_5_upper", "1",
                "upper 95 % confidence limit of quantile_5", j->quantile_upper);
    MURK_COUNT(f, "unmoved", "displacements that found no free place",
               j->unmoved);
}

static void list_link(murk_results_fields *f, const void *of, size_t i)
{
    const murk_links *links = of;
    MURK_COUNT(f, "from", "sensor, from 1", links->link[i].from + 1);
    MURK_COUNT(f, "to", "sensor, from 1", links->link[i].to + 1);
    MURK_NUMBER(f, "length_m", "m", "distance", links->link[i].length_m);
}

static void list_robust(murk_results_fields *f, const void *of)
{
    const murk_robust_results *r = of;
    const murk_links *links = r ? &r->robust->links : NULL;
    MURK_OBJECT(f, "drop_one", "coverage if one sensor fails", list_drop_one,
                r->robust);
    MURK_OBJECT(f, "jitter", "null, or coverage if sensors are displaced",
                list_jitter, r->robust->jittered.draws ? r : NULL);
    MURK_NUMBER(f, "link_range_m", "m",
                "least range of links that joins all sensors by open ways",
                links->range_m);
    MURK_NUMBER(f, "plain_link_range_m", "m", "the same if all ways were open",
                links->plain_range_m);
    MURK_NUMBER(f, "link_groups", "", "groups that open ways join",
                links->groups > 0 ? (double)links->groups : NAN);
    MURK_LIST(f, "links", "pairs of the shortest tree that joins them",
              list_link, links, links->n);
}

void murk_results_list_robust(murk_results_fields *f, const void *of)
{
    MURK_OBJECT(f, "robustness", "coverage if the plan is not followed",
                list_robust, of);
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
        scene->placement.jitter_m, murk_degrees(scene->placement.jitter_rad),
        j->mean.value, j->mean.standard_error, j->quantile);
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
