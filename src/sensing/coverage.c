/* Coverage of a set of sensors on the maps of a sight: computes the rows of the
 * sensors, combines them photon by photon, and sums up
 * (sensing/covered_photons.h). */
#include "base/interrupt.h"
#include "base/pool.h"
#include "base/position.h"
#include "base/progress.h"
#include "sensing/covered_photons.h"
#include "sensing/sight_parts.h"

#include <stdlib.h>

/* ---- rows ---- */

typedef struct rows_task {
    murk_sight *sight;
    const murk_pose *pose;
    murk_sparse_row *row; /* [threads], in the scratch buffers of the sight */
} rows_task;

/* The scratch buffers belong to the row and not to the thread, so that the rows
 * of all threads stay valid until they are added. */
static void find_row(void *context, unsigned worker, uint64_t batch)
{
    const rows_task *t = context;
    (void)worker;
    if (t->pose[batch].type == MURK_POSE_OF_NONE) {
        t->row[batch] = (murk_sparse_row){0};
    } else {
        murk_sight_row(t->sight, (unsigned)batch, &t->pose[batch],
                       &t->row[batch]);
    }
}

murk_status murk_coverage_rows(murk_sight *sight, const murk_pose *pose,
                               size_t n, murk_row_sink sink, void *context,
                               murk_error *err)
{
    const size_t threads = sight->desc.threads;
    murk_sparse_row *row = calloc(threads, sizeof *row);
    if (!row) {
        return murk_no_memory(err, "", "to look from %zu sensors", n);
    }
    murk_status status = MURK_OK;
    for (size_t first = 0; !status && first < n; first += threads) {
        const size_t left = n - first, some = left < threads ? left : threads;
        rows_task task = {sight, pose + first, row};
        murk_pool_run_workers(sight->desc.threads, some, find_row, &task);
        status = murk_interrupt_check(err);
        for (size_t i = 0; !status && i < some; ++i) {
            sink(context, (uint32_t)(first + i), &row[i]);
        }
    }
    free(row);
    return status;
}

/* A murk_row_sink: adds the row to the combined rows and to the value of the
 * sensor alone. */
static void add_row(void *context, uint32_t sensor, const murk_sparse_row *row)
{
    murk_covered_photons *m = context;
    for (size_t k = 0; k < row->seen; ++k) {
        m->single_value[sensor] +=
            (uint64_t)m->weight[row->photon[k]] *
            (row->clarity ? row->clarity[k] : MURK_CLEAR);
    }
    murk_combined_rows_add(&m->combined, sensor, row);
    murk_progress_add(1);
}

/* A murk_row_sink of the second pass: the value that is lost without the
 * sensor. */
static void add_only(void *context, uint32_t sensor, const murk_sparse_row *row)
{
    murk_covered_photons *m = context;
    m->only[sensor] = murk_combined_rows_only_of(&m->combined, m->weight, row);
    murk_progress_add(1);
}

/* The rows of all sensors: once, and with detection probabilities a second time
 * for the values that are lost without each sensor. */
static murk_status find_rows(murk_covered_photons *m, murk_sight *sight,
                             const murk_pose *pose, murk_error *err)
{
    const bool is_twice = m->combined.dose;
    murk_progress_begin("sense", (is_twice ? 2 : 1) * (uint64_t)m->sensors,
                        "sensors");
    murk_status status =
        murk_coverage_rows(sight, pose, m->sensors, add_row, m, err);
    if (!status && is_twice) {
        status = murk_coverage_rows(sight, pose, m->sensors, add_only, m, err);
    } else if (!status) {
        murk_combined_rows_only(&m->combined, m->weight, m->only);
    }
    murk_progress_end();
    murk_sight_rest(sight);
    return status;
}

/* ---- the whole ---- */

murk_status murk_coverage_check(const murk_sight_desc *desc,
                                const murk_pose *pose, size_t n,
                                murk_error *err)
{
    for (size_t j = 0; j < n; ++j) {
        const murk_box *box = &desc->domain.box;
        if (pose[j].type != MURK_POSE_OF_NONE &&
            !murk_box_contains(box, pose[j].position)) {
            return murk_fail(err, MURK_BAD_VALUE, "sensors",
                             "sensor %zu at %s m is outside the domain, %s to "
                             "%s m",
                             j + 1, murk_position_show(pose[j].position).text,
                             murk_position_show(box->min).text,
                             murk_position_show(box->max).text);
        }
    }
    return MURK_OK;
}

bool murk_coverage_result_create(murk_coverage_result *out, size_t n,
                                 size_t regions)
{
    *out = (murk_coverage_result){
        .covers = calloc(n + 1, sizeof *out->covers),
        .only_it_covers = calloc(n + 1, sizeof *out->only_it_covers),
        .seen_by_at_least = calloc(n + 1, sizeof *out->seen_by_at_least),
        .region = regions ? calloc(regions, sizeof *out->region) : NULL};
    return out->covers && out->only_it_covers && out->seen_by_at_least &&
           (out->region || !regions);
}

murk_status murk_coverage_result_measure(murk_coverage_result *out,
                                         murk_sight *sight,
                                         const murk_pose *pose, size_t n,
                                         murk_error *err)
{
    const murk_sight_desc *desc = &sight->desc;
    murk_covered_photons m = {.desc = desc,
                              .sight = sight,
                              .sensors = n,
                              .photons = sight->photons,
                              .surface_photons =
                                  murk_photon_map_count(desc->surface_map),
                              .weight = sight->weight};
    murk_coverage_result coverage = {0};
    murk_status status = murk_coverage_check(desc, pose, n, err);
    if (!status) {
        /* The combined rows, sums by sensor, and the arrays of the result. */
        m.single_value = calloc(n + 1, sizeof *m.single_value);
        if (!murk_coverage_result_create(
                &coverage, n, desc->interest ? desc->interest->n : 0) ||
            !murk_covered_photons_init(&m, sight->photons) || !m.single_value) {
            status = murk_no_memory(err, "",
                                    "to measure %zu sensors over %zu photons",
                                    n, sight->photons);
        }
    }
    if (!status) {
        status = find_rows(&m, sight, pose, err);
    }
    if (!status) {
        status = murk_covered_photons_sum_up(&coverage, &m, err);
    }
    if (status) {
        murk_coverage_result_release(&coverage);
    } else {
        *out = coverage;
    }
    murk_covered_photons_release(&m);
    return status;
}

murk_status murk_coverage_total_measure(murk_estimate *out, murk_sight *sight,
                                        const murk_pose *pose, size_t n,
                                        murk_error *err)
{
    murk_coverage_result coverage = {0};
    const murk_status status =
        murk_coverage_result_measure(&coverage, sight, pose, n, err);
    *out = coverage.total;
    murk_coverage_result_release(&coverage);
    return status;
}

void murk_coverage_result_release(murk_coverage_result *coverage)
{
    free(coverage->covers);
    free(coverage->only_it_covers);
    free(coverage->seen_by_at_least);
    free(coverage->region);
    *coverage = (murk_coverage_result){0};
}
