#include "results/plan.h"

#include "results/results.h"
#include "results/summary.h"

#include <math.h>

const char *const murk_method_names[] = {[MURK_PLACE_BEST] = "best",
                                         [MURK_PLACE_SPOQ] = "spoq",
                                         [MURK_PLACE_GREEDY] = "greedy",
                                         [MURK_PLACE_EXACT] = "exact"};
const size_t murk_method_names_count =
    sizeof murk_method_names / sizeof *murk_method_names;

double murk_share(uint64_t part, uint64_t whole)
{
    return whole ? (double)part / (double)whole : NAN;
}

void murk_json_bound(cJSON *root, const murk_place_result *place)
{
    cJSON *object = cJSON_AddObjectToObject(root, "bound");
    murk_json_number(object, "upper", murk_share(place->upper, place->whole));
    murk_json_number(object, "gap",
                     place->upper || !place->whole
                         ? murk_share(place->upper - place->value, place->upper)
                         : 0);
    cJSON_AddBoolToObject(object, "proven_optimal", place->proven_optimal);
    cJSON_AddStringToObject(object, "guarantee", place->guarantee);

    cJSON *curve = cJSON_AddArrayToObject(root, "curve");
    for (size_t i = 0; i < place->curve_points; ++i) {
        const murk_curve_point *point = &place->curve[i];
        cJSON *item = cJSON_CreateObject();
        cJSON_AddNumberToObject(item, "count", (double)point->count);
        murk_json_number(item, "coverage",
                         murk_share(point->value, place->whole));
        murk_json_number(item, "upper", murk_share(point->upper, place->whole));
        cJSON_AddItemToArray(curve, item);
    }
}

void murk_json_cut(cJSON *object, const murk_place_result *place)
{
    if (place->is_cut) {
        cJSON_AddStringToObject(object, "cut_by", "nodes");
    } else if (place->is_work_cut) {
        cJSON_AddStringToObject(object, "cut_by", "work");
    } else {
        cJSON_AddNullToObject(object, "cut_by");
    }
}

void murk_print_bound(const murk_place_result *place, bool has_budget,
                      const char *sample)
{
    if (place->proven_optimal) {
        murk_print("bound       proven optimal for this %s\n", sample);
    } else {
        char what[40] = "no plan within the budget covers";
        if (!has_budget) {
            snprintf(what, sizeof what, "no %zu candidates cover",
                     place->count);
        }
        murk_print("bound       %s more than %.4f of this %s; guarantee: %s\n",
                   what, murk_share(place->upper, place->whole), sample,
                   place->guarantee);
    }
    if (place->is_cut) {
        murk_print("            branch and bound ended by placement.nodes "
                   "after %llu: the bound is the one reached so far\n",
                   (unsigned long long)place->nodes);
    }
    if (place->is_work_cut) {
        murk_print(
            "            the search ended by its limit of work: the plan "
            "and the bound are those reached so far\n");
    }
}
