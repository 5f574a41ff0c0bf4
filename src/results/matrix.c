/* A plan over a coverage matrix: fields of plan.json, and the summary. */
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

/* Converts a value, the sum of weight * clarity over the columns that count for
 * each row, to the unit of the weights in the file. A row that as many columns
 * cover as the redundancy says counts with the weight of the row. */
static double as_given(const murk_matrix_plan *p, uint64_t value)
{
    return (double)value / MURK_CLEAR / p->matrix->unit / p->redundancy;
}

static void list_matrix(murk_results_fields *f, const void *of)
{
    const murk_matrix_plan *p = of;
    MURK_TEXT(f, "file", "as named", p->file);
    MURK_TEXT(f, "sha256", "of the file", p->matrix->sha256);
    MURK_TEXT(f, "format", "dense CSV, sparse CSV or OR-Library text",
              format_name(p->matrix->format));
    MURK_COUNT(f, "rows", "of the matrix", p->matrix->rows);
    MURK_COUNT(f, "columns", "of the matrix", p->matrix->columns);
    MURK_COUNT(f, "entries", "other than 0",
               murk_sparse_matrix_entries(p->matrix));
    MURK_NUMBER(f, "weight", "", "of all rows", as_given(p, p->place.whole));
    MURK_NUMBER(f, "covered", "", "weight that the columns cover",
                as_given(p, p->place.value));
    MURK_NUMBER(f, "covered_at_most", "", "no as many columns cover more",
                as_given(p, p->place.upper));
}

/* Lists fields that are null here, but have a value in a plan for a scene. */
static void list_nulls(murk_results_fields *f, const char *const *name,
                       size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        MURK_NULL(f, name[i], "", "null");
    }
}

static void list_photons(murk_results_fields *f, const void *of)
{
    static const char *const none[] = {"emitted", "surface", "volume"};
    (void)of;
    list_nulls(f, none, 3);
}

static void list_candidates(murk_results_fields *f, const void *of)
{
    const murk_matrix_plan *p = of;
    MURK_COUNT(f, "asked", "columns", p->matrix->columns);
    MURK_COUNT(f, "usable", "columns", p->matrix->columns);
    MURK_NULL(f, "doubtful", "", "null");
    MURK_COUNT(f, "after_presolve", "columns that no other dominates",
               p->place.after_presolve);
}

static void list_column(murk_results_fields *f, const void *of, size_t k)
{
    static const char *const none[] = {"type", "position_m", "axis",
                                       "heading_deg", "tilt_deg"};
    const murk_matrix_plan *p = of;
    const size_t column = p ? p->place.sensor[k] : 0;
    list_nulls(f, none, sizeof none / sizeof *none);
    MURK_COUNT(f, "column", "of the matrix, from 1", column + 1);
    MURK_TEXT(f, "name", "of the column",
              p->matrix->name ? p->matrix->name[column] : NULL);
    MURK_NUMBER(f, "cost", "", "of the column",
                p->matrix->cost ? p->matrix->cost[column] : NAN);
    MURK_NUMBER(f, "covers", "1", "share that the column covers alone",
                murk_share(p->covers.alone[k], p->place.whole));
    MURK_NUMBER(f, "only_it_covers", "1",
                "share that is lost without the column",
                murk_share(p->covers.only[k], p->place.whole));
}

static void list_coverage(murk_results_fields *f, const void *of)
{
    static const char *const none[] = {"held_out", "held_out_standard_error",
                                       "surface", "volume"};
    const murk_matrix_plan *p = of;
    MURK_NUMBER(f, "in_sample", "1", "share of the weight",
                murk_share(p->place.value, p->place.whole));
    list_nulls(f, none, sizeof none / sizeof *none);
    MURK_NUMBER(f, "ceiling", "1", "coverage of all columns",
                murk_share(p->place.ceiling, p->place.whole));
    MURK_NUMBER(f, "sum_of_views", "1", "sum of the columns' own coverages",
                murk_share(p->covers.sum, p->place.whole / p->redundancy));
}

static cJSON *seen_by(const murk_matrix_plan *p)
{
    cJSON *list = cJSON_CreateArray();
    for (size_t k = 0; k < p->place.count; ++k) {
        const double seen =
            murk_share(p->covers.seen_by[k], p->covers.whole_rows);
        cJSON_AddItemToArray(list, cJSON_CreateNumber(seen));
    }
    return list;
}

static void list_target(murk_results_fields *f, const void *of)
{
    const murk_matrix_plan *p = of;
    MURK_NUMBER(f, "asked", "1", "the target", p->target);
    MURK_COUNT(f, "fewest_possible", "no fewer columns reach the target",
               p->place.fewest);
    MURK_NULL(f, "confirmed", "", "null");
    MURK_NULL(f, "confirmed_standard_error", "", "null");
}

static void list_placement(murk_results_fields *f, const void *of)
{
    static const char *const before[] = {"visibility", "through"};
    static const char *const behind[] = {"queries", "looks", "shadow_rays",
                                         "sightlines_blocked_by_interfaces",
                                         "sightlines_totally_reflected"};
    const murk_matrix_plan *p = of;
    MURK_TEXT(f, "method", "a word of placement.method",
              murk_place_method_name(p->desc.method));
    MURK_TEXT(f, "detection", "a word of placement.detection",
              murk_detection_name(p->detection));
    MURK_NULL(f, "threshold", "", "null");
    MURK_COUNT(f, "redundancy", "columns that count for a row", p->redundancy);
    list_nulls(f, before, 2);
    MURK_TEXT(f, "knowledge", "known", "known");
    MURK_COUNT(f, "restarts", "starts asked for", p->desc.restarts);
    MURK_COUNT(f, "starts", "starts made", p->place.restarts);
    MURK_COUNT(f, "evaluations", "of plans", p->place.evaluations);
    list_nulls(f, behind, sizeof behind / sizeof *behind);
    murk_results_list_cut(f, p ? &p->place : NULL);
}

void murk_results_list_matrix_plan(murk_results_fields *f, const void *of)
{
    static const char *const scene[] = {"scene", "scene_sha256"};
    const murk_matrix_plan *p = of;
    const murk_budget_results budget = {p ? p->budget : 0,
                                        p ? &p->place : NULL};
    if (!murk_results_describes(f)) {
        murk_results_list_murk(f, NULL);
    }
    list_nulls(f, scene, 2);
    MURK_COUNT(f, "seed", "of all random numbers", p->desc.seed);
    /* The fields about the matrix, then the fields that a plan for a scene has,
     * too. */
    MURK_OBJECT(f, "matrix", "with --matrix", list_matrix, p);
    MURK_OBJECT(f, "photons", "nulls", list_photons, p);
    MURK_OBJECT(f, "candidates", "the columns", list_candidates, p);
    MURK_LIST(f, "sensors", "the chosen columns", list_column, p,
              p->place.count);
    MURK_OBJECT(f, "coverage", "coverage of the plan", list_coverage, p);
    MURK_JSON(f, "seen_by_at_least", "1",
              "share that at least 1, 2, ... columns cover", seen_by(p));
    MURK_NULL(f, "robustness", "", "null: no places, and one sample");
    murk_results_list_bound(f, p ? &p->place : NULL);
    if (MURK_LISTED_IF(f, p->target > 0)) {
        MURK_OBJECT(f, "target", "with a target", list_target, p);
    }
    if (MURK_LISTED_IF(f, p->budget > 0)) {
        MURK_OBJECT(f, "budget", "with a budget", murk_results_list_budget,
                    &budget);
    }
    MURK_OBJECT(f, "placement", "how the plan was found", list_placement, p);
}

void murk_matrix_plan_print(const void *of)
{
    const murk_matrix_plan *p = of;
    const murk_sparse_matrix *m = p->matrix;
    const murk_place_result *place = &p->place;
    const size_t entries = murk_sparse_matrix_entries(m);
    murk_print("matrix      %s (%s): %zu rows, %zu columns, %zu entries (%.3g "
               "%%)\n",
               p->file, format_name(m->format), m->rows, m->columns, entries,
               100.0 * (double)entries / (double)m->rows / (double)m->columns);
    /* The table of the first chosen columns. */
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
    /* Coverage in weights as the file gives them. */
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
}
