/* Coverage of given sensors: fields of coverage.json, and lines of the summary.
 */
#include "results/sense.h"

#include "results/robust.h"
#include "results/summary.h"
#include "results/tallies.h"

#include <math.h>

static void list_coverage(murk_results_fields *f, const void *of)
{
    const murk_coverage_result *coverage = of;
    MURK_NUMBER(f, "in_sample", "1", "on the light that was traced",
                coverage->total.value);
    MURK_NUMBER(f, "standard_error", "1", "of in_sample",
                coverage->total.standard_error);
    MURK_NULL(f, "held_out", "1", "null: nothing was chosen");
    MURK_NULL(f, "held_out_standard_error", "1", "null");
    MURK_NULL(f, "ceiling", "1", "null: no candidates were asked");
    MURK_ESTIMATE(f, "surface", "1", "of the surface map alone",
                  coverage->surface);
    MURK_ESTIMATE(f, "volume", "1", "of the volume map alone",
                  coverage->volume);
    MURK_NUMBER(f, "sum_of_views", "1", "sum of the sensors' own coverages",
                coverage->sum_of_views);
}

void murk_results_list_sense(murk_results_fields *f, const void *of)
{
    const murk_sense_results *r = of;
    const murk_scene_desc *scene = r ? r->session->scene : NULL;
    const murk_sensor_results *sensors = r ? &r->sensors : NULL;
    const murk_target_results targets = {scene, r ? r->targets : NULL};
    const murk_robust_results robust = {scene, r ? r->robust : NULL};
    murk_results_list_head(f, scene);
    MURK_OBJECT(f, "photons", "photons of the light", murk_results_list_photons,
                r->session->traced);
    murk_results_list_targets(f, &targets);
    murk_results_list_sensors(f, sensors);
    MURK_OBJECT(f, "coverage", "coverage of the sensors", list_coverage,
                sensors->coverage);
    murk_results_list_shares(f, sensors);
    murk_results_list_regions(f, sensors);
    murk_results_list_robust(f, &robust);
}

void murk_print_sense(const void *of)
{
    const murk_sense_results *results = of;
    const murk_session *session = results->session;
    const murk_coverage_result *coverage = results->sensors.coverage;
    murk_print_light(session);
    murk_print_tallies(session);
    murk_print_targets(results->targets);
    murk_print_sensors(&results->sensors, session->results.folder);
    if (!isfinite(coverage->total.value)) {
        murk_print("coverage    none: it is dark (");
    } else if (isfinite(coverage->total.standard_error)) {
        murk_print("coverage    %.4f +- %.4f (one standard error, %s; ",
                   coverage->total.value, coverage->total.standard_error,
                   murk_error_by(session->scene));
    } else {
        murk_print("coverage    %.4f (", coverage->total.value);
    }
    murk_print_maps(coverage);
    murk_print(")\n");
    murk_print_weights(session->scene, coverage);
    murk_print_regions(&results->sensors);
    murk_print_robust(session->scene, results->robust);
}
