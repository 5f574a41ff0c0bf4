#include "results/matrix.h"
#include "results/plan.h"
#include "results/summary.h"

#include "plan/poses.h"

#include <math.h>

static const char *format_name(murk_matrix_format format)
{
    static const char *const name[] = {[MURK_MATRIX_DENSE_CSV] = "dense CSV",
                                       [MURK_MATRIX_SPARSE_CSV] = "sparse CSV",
                                       [MURK_MATRIX_OR_LIBRARY] =
                                           "OR-Library text"};
    return name[format];
}

/* A value in weights as the file gives them. */
static double as_given(const murk_matrix_plan *p, uint64_t value)
{
    return (double)value / MURK_CLEAR / p->matrix->unit / p->redundancy;
}

static void add_nulls(cJSON *object, const char *const *key, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        cJSON_AddNullToObject(object, key[i]);
    }
}

static void add_matrix(cJSON *root, const murk_matrix_plan *p)
{
    const murk_sparse_matrix *m = p->matrix;
    cJSON *object = cJSON_AddObjectToObject(root, "matrix");
    cJSON_AddStringToObject(object, "file", p->file);
    cJSON_AddStringToObject(object, "sha256", p->matrix->sha256);
    cJSON_AddStringToObject(object, "format", format_name(m->format));
    cJSON_AddNumberToObject(object, "rows", (double)m->rows);
    cJSON_AddNumberToObject(object, "columns", (double)m->columns);
    cJSON_AddNumberToObject(object, "entries",
                            (double)murk_sparse_matrix_entries(m));
    murk_json_number(object, "weight", as_given(p, p->place.whole));
    murk_json_number(object, "covered", as_given(p, p->place.value));
    murk_json_number(object, "covered_at_most", as_given(p, p->place.upper));
}

static void add_sensors(cJSON *root, const murk_matrix_plan *p)
{
    static const char *const empty[] = {"type", "position_m", "axis",
                                        "heading_deg", "tilt_deg"};
    const murk_sparse_matrix *m = p->matrix;
    cJSON *list = cJSON_AddArrayToObject(root, "sensors");
    for (size_t k = 0; k < p->place.count; ++k) {
        const size_t column = p->place.sensor[k];
        cJSON *item = cJSON_CreateObject();
        add_nulls(item, empty, sizeof empty / sizeof *empty);
        cJSON_AddNumberToObject(item, "column", (double)column + 1);
        if (m->name) {
            cJSON_AddStringToObject(item, "name", m->name[column]);
        } else {
            cJSON_AddNullToObject(item, "name");
        }
        murk_json_number(item, "cost", m->cost ? m->cost[column] : NAN);
        murk_json_number(item, "covers",
                         murk_share(p->covers.alone[k], p->place.whole));
        murk_json_number(item, "only_it_covers",
                         murk_share(p->covers.only[k], p->place.whole));
        cJSON_AddItemToArray(list, item);
    }
}

static void add_coverage(cJSON *root, const murk_matrix_plan *p)
{
    static const char *const empty[] = {"held_out", "held_out_standard_error",
                                        "surface", "volume"};
    const murk_place_result *place = &p->place;
    cJSON *object = cJSON_AddObjectToObject(root, "coverage");
    murk_json_number(object, "in_sample",
                     murk_share(place->value, place->whole));
    add_nulls(object, empty, sizeof empty / sizeof *empty);
    murk_json_number(object, "ceiling",
                     murk_share(place->ceiling, place->whole));
    murk_json_number(object, "sum_of_views",
                     murk_share(p->covers.sum, place->whole / p->redundancy));
    cJSON *list = cJSON_AddArrayToObject(root, "seen_by_at_least");
    for (size_t k = 0; k < place->count; ++k) {
        cJSON_AddItemToArray(
            list, cJSON_CreateNumber(
                      murk_share(p->covers.seen_by[k], p->covers.whole_rows)));
    }
}

static void add_placement(cJSON *root, const murk_matrix_plan *p)
{
    const murk_place_result *place = &p->place;
    if (p->target > 0) {
        cJSON *object = cJSON_AddObjectToObject(root, "target");
        murk_json_number(object, "asked", p->target);
        cJSON_AddNumberToObject(object, "fewest_possible",
                                (double)place->fewest);
        cJSON_AddNullToObject(object, "confirmed");
        cJSON_AddNullToObject(object, "confirmed_standard_error");
    }
    if (p->budget > 0) {
        cJSON *object = cJSON_AddObjectToObject(root, "budget");
        murk_json_number(object, "asked", p->budget);
        murk_json_number(object, "spent", (double)place->cost * MURK_COST_UNIT);
    }
    cJSON *object = cJSON_AddObjectToObject(root, "placement");
    cJSON_AddStringToObject(object, "method",
                            murk_method_names[p->desc.method]);
    cJSON_AddStringToObject(object, "detection",
                            murk_detection_name(p->detection));
    cJSON_AddNullToObject(object, "threshold");
    cJSON_AddNumberToObject(object, "redundancy", p->redundancy);
    cJSON_AddNullToObject(object, "visibility");
    cJSON_AddNullToObject(object, "through");
    cJSON_AddStringToObject(object, "knowledge", "known");
    cJSON_AddNumberToObject(object, "restarts", (double)p->desc.restarts);
    cJSON_AddNumberToObject(object, "starts", (double)place->restarts);
    cJSON_AddNumberToObject(object, "evaluations", (double)place->evaluations);
    cJSON_AddNullToObject(object, "queries");
    cJSON_AddNullToObject(object, "shadow_rays");
    cJSON_AddNullToObject(object, "sightlines_blocked_by_interfaces");
    cJSON_AddNullToObject(object, "sightlines_totally_reflected");
    cJSON_AddNumberToObject(object, "nodes", (double)place->nodes);
    murk_json_cut(object, place);
}

cJSON *murk_matrix_plan_json(const murk_matrix_plan *p)
{
    static const char *const photons[] = {"emitted", "surface", "volume"};
    const double columns = (double)p->matrix->columns;
    cJSON *root = murk_json_begin_murk();
    cJSON_AddNullToObject(root, "scene");
    cJSON_AddNullToObject(root, "scene_sha256");
    cJSON_AddNumberToObject(root, "seed", p->desc.seed);
    add_matrix(root, p);
    add_nulls(cJSON_AddObjectToObject(root, "photons"), photons, 3);
    cJSON *object = cJSON_AddObjectToObject(root, "candidates");
    cJSON_AddNumberToObject(object, "asked", columns);
    cJSON_AddNumberToObject(object, "usable", columns);
    cJSON_AddNullToObject(object, "doubtful");
    cJSON_AddNumberToObject(object, "after_presolve",
                            (double)p->place.after_presolve);
    add_sensors(root, p);
    add_coverage(root, p);
    cJSON_AddNullToObject(root, "robustness"); /* no places; and one sample */
    murk_json_bound(root, &p->place);
    add_placement(root, p);
    return root;
}

void murk_matrix_plan_print(const murk_matrix_plan *p)
{
    const murk_sparse_matrix *m = p->matrix;
    const murk_place_result *place = &p->place;
    const size_t entries = murk_sparse_matrix_entries(m);
    murk_print("matrix      %s (%s): %zu rows, %zu columns, %zu entries (%.3g "
               "%%)\n",
               p->file, format_name(m->format), m->rows, m->columns, entries,
               100.0 * (double)entries / (double)m->rows / (double)m->columns);
    murk_print("columns     %8s  %8s %10s%s\n", "", "covers", "only it",
               m->name ? "  name" : "");
    for (size_t k = 0; k < place->count && k < MURK_PRINTED_ROWS; ++k) {
        murk_print("            %8zu  %8.4f %10.4f%s%s\n", place->sensor[k] + 1,
                   murk_share(p->covers.alone[k], place->whole),
                   murk_share(p->covers.only[k], place->whole),
                   m->name ? "  " : "",
                   m->name ? m->name[place->sensor[k]] : "");
    }
    murk_print_more(place->count, p->session.results.folder, "plan.json");
    murk_print("coverage    %.4f: %.10g of %.10g; all columns: %.10g\n",
               murk_share(place->value, place->whole),
               as_given(p, place->value), as_given(p, place->whole),
               as_given(p, place->ceiling));
    if (p->target > 0) {
        murk_print(
            "target      %.4f takes %zu columns, and no fewer than %zu\n",
            p->target, place->count, place->fewest);
    }
    if (p->budget > 0) {
        murk_print("budget      %.10g of %.10g spent\n",
                   (double)place->cost * MURK_COST_UNIT, p->budget);
    }
    murk_print_bound(place, p->budget > 0, "matrix");
    murk_run_facts run = p->session.run;
    run.sense_s = 0;
    murk_print_time(&run, "matrix", p->session.run.sense_s);
    murk_print_files(&p->session);
}
