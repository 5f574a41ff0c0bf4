#include "results/goals.h"

#include "results/summary.h"

#include <math.h>

void murk_json_regions(cJSON *root, const murk_scene_desc *scene,
                       const murk_region_coverage *in_sample,
                       const murk_region_coverage *held_out)
{
    const murk_scene_placement *settings = &scene->placement;
    cJSON *list = cJSON_AddArrayToObject(root, "regions_of_interest");
    for (size_t i = 0; i < settings->n_interests; ++i) {
        const murk_estimate seen = in_sample[i].coverage;
        const murk_estimate held =
            held_out ? held_out[i].coverage : (murk_estimate){NAN, NAN};
        cJSON *item = cJSON_CreateObject();
        cJSON_AddStringToObject(item, "name", settings->interest[i].name);
        murk_json_number(item, "weight", settings->interest[i].weight);
        cJSON_AddNumberToObject(
            item, settings->targets.given ? "targets" : "stored_photons",
            (double)in_sample[i].photons);
        murk_json_number(item, "coverage", seen.value);
        murk_json_number(item, "standard_error", seen.standard_error);
        murk_json_number(item, "held_out", held.value);
        murk_json_number(item, "held_out_standard_error", held.standard_error);
        cJSON_AddItemToArray(list, item);
    }
}

static void print_in_view(murk_estimate seen)
{
    if (!isfinite(seen.value)) {
        murk_print("  %16s", "none there");
    } else if (!isfinite(seen.standard_error)) {
        murk_print("  %16.4f", seen.value);
    } else {
        murk_print("  %.4f +- %.4f", seen.value, seen.standard_error);
    }
}

void murk_print_regions(const murk_scene_desc *scene,
                        const murk_region_coverage *in_sample,
                        const murk_region_coverage *held_out)
{
    const murk_scene_placement *settings = &scene->placement;
    if (settings->n_interests == 0) {
        return;
    }
    murk_print("regions     %-16s %6s %8s  %16s", "of interest", "weight",
               settings->targets.given ? "targets" : "photons", "in view");
    murk_print(held_out ? "  %16s\n" : "\n", "held out");
    for (size_t i = 0; i < settings->n_interests; ++i) {
        murk_print("            %-16s %6.4g %8zu", settings->interest[i].name,
                   settings->interest[i].weight, in_sample[i].photons);
        print_in_view(in_sample[i].coverage);
        if (held_out) {
            print_in_view(held_out[i].coverage);
        }
        murk_print("\n");
    }
}

void murk_json_targets(cJSON *root, const murk_scene_desc *scene,
                       const murk_target_facts *facts)
{
    const murk_scene_targets *settings = &scene->placement.targets;
    if (!settings->given) {
        cJSON_AddNullToObject(root, "targets");
        return;
    }
    cJSON *object = cJSON_AddObjectToObject(root, "targets");
    cJSON_AddBoolToObject(object, "listed", settings->points != NULL);
    cJSON_AddNumberToObject(object, "points", (double)facts->points);
    cJSON_AddNumberToObject(object, "surface", (double)facts->surface);
    cJSON_AddNumberToObject(object, "volume", (double)facts->volume);
    murk_json_number(object, "area_m2", facts->area_m2.value);
    murk_json_number(object, "area_m2_standard_error",
                     facts->area_m2.standard_error);
    murk_json_number(object, "volume_m3", facts->volume_m3.value);
    murk_json_number(object, "volume_m3_standard_error",
                     facts->volume_m3.standard_error);
    murk_json_number(object, "band_nm",
                     scene->band_nm[murk_targets_band(scene)]);
}

static void print_size(murk_estimate size, const char *unit, const char *what)
{
    if (isfinite(size.value)) {
        murk_print("; %.6g +- %.2g %s of %s in free space", size.value,
                   size.standard_error, unit, what);
    }
}

void murk_print_targets(const murk_target_facts *facts)
{
    if (facts->points == 0) {
        return;
    }
    murk_print("targets     %llu points: %zu of surfaces, %zu in the volume",
               (unsigned long long)facts->points, facts->surface,
               facts->volume);
    print_size(facts->area_m2, "m2", "surfaces");
    print_size(facts->volume_m3, "m3", "volume");
    murk_print("\n");
}

static void print_amount(uint64_t points, double spacing_m)
{
    if (points > 0) {
        murk_print("%llu points", (unsigned long long)points);
    } else {
        murk_print("points %.6g m apart", spacing_m);
    }
}

void murk_print_asked_goals(const murk_scene_desc *scene)
{
    const murk_scene_placement *settings = &scene->placement;
    const murk_scene_targets *t = &settings->targets;
    for (size_t i = 0; i < settings->n_interests; ++i) {
        murk_print("%-12s%s counts %.6g times\n", i ? "" : "interest",
                   settings->interest[i].name, settings->interest[i].weight);
    }
    if (settings->n_interests > 0 && settings->elsewhere != 1) {
        murk_print("%-12swhat lies elsewhere counts %.6g times\n", "",
                   settings->elsewhere);
    }
    if (!t->given) {
        return;
    }
    murk_print("targets     ");
    if (t->points) {
        murk_print("listed in %s", t->points);
    }
    if (t->has_surfaces) {
        print_amount(t->surface_points, t->surface_spacing_m);
        murk_print(" on surfaces%s", t->has_volume ? ", " : "");
    }
    if (t->has_volume) {
        print_amount(t->volume_points, t->volume_spacing_m);
        murk_print(" in the volume");
    }
    murk_print("; seen at %.6g nm\n", scene->band_nm[murk_targets_band(scene)]);
}

const char *murk_error_by(const murk_scene_desc *scene)
{
    return scene->placement.targets.given ? "by target" : "by emitted photon";
}

const char *murk_sample_of(const murk_scene_desc *scene)
{
    const murk_scene_targets *settings = &scene->placement.targets;
    return settings->points  ? "list of targets"
           : settings->given ? "sample of targets"
                             : "sample of photons";
}
