/* Regions of interest and targets: fields of JSON and lines of the summary. */
#include "results/goals.h"

#include "results/summary.h"

#include <math.h>

static murk_estimate held_out_of(const murk_sensor_results *s, size_t i)
{
    return s->held_out_region ? s->held_out_region[i].coverage
                              : (murk_estimate){NAN, NAN};
}

static void list_region(murk_results_fields *f, const void *of, size_t i)
{
    const murk_sensor_results *s = of;
    MURK_TEXT(f, "name", "of the region", s->scene->placement.interest[i].name);
    MURK_NUMBER(f, "weight", "1", "of what lies in the region",
                s->scene->placement.interest[i].weight);
    MURK_COUNT(f,
               s && s->scene->placement.targets.given ? "targets"
                                                      : "stored_photons",
               "in the region; named targets if targets are given",
               s->coverage->region[i].photons);
    MURK_NUMBER(f, "coverage", "1", "of the region, in sample",
                s->coverage->region[i].coverage.value);
    MURK_NUMBER(f, "standard_error", "1", "of coverage",
                s->coverage->region[i].coverage.standard_error);
    MURK_ESTIMATE(f, "held_out", "1", "of the region, on a second map",
                  held_out_of(s, i));
}

void murk_results_list_regions(murk_results_fields *f, const void *of)
{
    const murk_sensor_results *s = of;
    MURK_LIST(f, "regions_of_interest", "the scene's regions", list_region, s,
              s->scene->placement.n_interests);
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

void murk_print_regions(const murk_sensor_results *sensors)
{
    const murk_scene_placement *settings = &sensors->scene->placement;
    const murk_region_coverage *in_sample = sensors->coverage->region;
    const murk_region_coverage *held_out = sensors->held_out_region;
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

static void list_targets(murk_results_fields *f, const void *of)
{
    const murk_target_results *t = of;
    MURK_FLAG(f, "listed", "true if a file lists the points",
              t->scene->placement.targets.points != NULL);
    MURK_COUNT(f, "points", "all targets", t->facts->points);
    MURK_COUNT(f, "surface", "on surfaces", t->facts->surface);
    MURK_COUNT(f, "volume", "in the volume", t->facts->volume);
    MURK_ESTIMATE(f, "area_m2", "m2", "surfaces that targets stand for",
                  t->facts->area_m2);
    MURK_ESTIMATE(f, "volume_m3", "m3", "free space that targets stand for",
                  t->facts->volume_m3);
    MURK_NUMBER(f, "band_nm", "nm", "the band they are seen at",
                t->scene->band_nm[murk_targets_band(t->scene)]);
}

void murk_results_list_targets(murk_results_fields *f, const void *of)
{
    const murk_target_results *t = of;
    MURK_OBJECT(f, "targets",
                "null, or the targets that stand in place of photons",
                list_targets, t->scene->placement.targets.given ? t : NULL);
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
    /* Targets in place of photons. */
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
