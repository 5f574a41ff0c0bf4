/* The forecast of a full run: the numbers of photons and records of the pilot
 * run (lightmap/lightmap.h), the memory of maps and rows, and the disk space of
 * the scratch file; and the same for a run that several ranks share. Ranks
 * divide the photons of a map and the rows of a coverage matrix that is
 * computed as a whole. Each rank receives the records of all others, which the
 * first rank of each machine keeps for the others there, and the rows, which it
 * keeps unless the matrix is large. */
#include "overview/parts.h"

#include "base/machine.h"
#include "base/print.h"
#include "base/scratch_file.h"
#include "placement/problem.h"
#include "world/scene_tallies.h"

#include <math.h>

/* Poses of sensors that a row of the coverage matrix is computed for. */
static double rows_of(const murk_poses *poses)
{
    return poses ? (double)poses->count : 0;
}

/* The largest size [bytes] of the coverage matrix for placement in a known
 * environment: for each photon and pose of a sensor one bit, or two bytes if
 * the scene has media. */
static double matrix_bytes(const murk_session *session, const murk_poses *poses,
                           const murk_forecast *forecast)
{
    const double records = forecast->surface + forecast->volume;
    const bool dims = murk_media_any(session->stage->media);
    return records * rows_of(poses) * (dims ? 2 : 0.125);
}

/* The largest memory [bytes] of the rows that a process holds, of `bytes`
 * altogether: in an unknown environment of those that placement remembers. */
static double memory_of_rows(const murk_session *session, double bytes)
{
    return fmin(session->scene->placement.memory_mb * MURK_BYTES_PER_MB, bytes);
}

static bool is_unknown(const murk_session *session)
{
    return session->scene->placement.knowledge == MURK_SCENE_UNKNOWN;
}

/* The largest size [bytes] of the scratch file that has such rows in a known
 * environment. */
static double scratch_bytes(const murk_session *session, double bytes)
{
    return is_unknown(session) || bytes <= memory_of_rows(session, bytes)
               ? 0
               : bytes;
}

void murk_overview_json_forecast(cJSON *root, const murk_session *session,
                                 const murk_poses *poses,
                                 const murk_forecast *f)
{
    cJSON *object = cJSON_AddObjectToObject(root, "forecast");
    const double matrix = matrix_bytes(session, poses, f);
    murk_json_number(object, "pilot_photons", (double)f->pilot_photons);
    murk_json_number(object, "emitted", f->emitted);
    murk_json_number(object, "surface", f->surface);
    murk_json_number(object, "volume", f->volume);
    murk_json_number(object, "memory_bytes", f->memory_bytes);
    if (f->scratch_bytes > 0) {
        murk_json_number(object, "records_scratch_bytes_at_most",
                         f->scratch_bytes);
    }
    murk_json_number(object, "matrix_bytes_at_most", matrix);
    murk_json_number(object, "remembered_bytes_at_most",
                     is_unknown(session) ? memory_of_rows(session, matrix) : 0);
    murk_json_number(object, "scratch_bytes_at_most",
                     scratch_bytes(session, matrix));
}

void murk_overview_print_forecast(const murk_session *session,
                                  const murk_poses *poses,
                                  const murk_forecast *f)
{
    murk_print("forecast    %.3g photons emitted; stored: %.3g surface, %.3g "
               "volume (from a pilot of %llu photons)\n",
               f->emitted, f->surface, f->volume,
               (unsigned long long)f->pilot_photons);
    /* The memory and the disk space that a run takes. */
    const double matrix = matrix_bytes(session, poses, f);
    const double rows = memory_of_rows(session, matrix);
    const double scratch = scratch_bytes(session, matrix);
    if (f->memory_bytes + rows >= 1e5) {
        murk_print("memory      about %.3g GB a map while tracing; to place at "
                   "most %.3g GB more for rows of the coverage matrix\n",
                   f->memory_bytes / 1e9, rows / 1e9);
    }
    if (f->scratch_bytes > 0) {
        murk_print("            the records do not fit into memory: about %.3g "
                   "GB a map in a scratch file in %s, which has %.3g GB free\n",
                   f->scratch_bytes / 1e9, murk_scratch_folder(),
                   murk_scratch_free_bytes() / 1e9);
    }
    if (scratch > 0) {
        murk_print("            at most %.3g GB in a scratch file in %s, which "
                   "has %.3g GB free (beyond placement.memory_mb)\n",
                   scratch / 1e9, murk_scratch_folder(),
                   murk_scratch_free_bytes() / 1e9);
    }
}

/* ---- ranks ---- */

/* The share of one rank of a run, and what it receives from the others. */
typedef struct rank_share {
    unsigned threads;
    double photons, rows; /* that the rank traces for a map, and computes */
    double trace_s;       /* of the photons of a map, with all threads */
    double tallies_bytes; /* that the rank holds, as every rank does */
    double matrix_bytes;  /* of the rows that the rank holds, at most */
    double records_bytes, rows_bytes, sums_bytes; /* that the rank receives */
} rank_share;

static rank_share share_of(const murk_session *session, const murk_poses *poses,
                           const murk_forecast *f, unsigned ranks)
{
    const double n = ranks, records = f->surface + f->volume;
    const double others = (n - 1) / n;
    const unsigned threads = session->settings.threads;
    /* The pilot run is one batch, which one thread traces. */
    const double photon_s =
        f->pilot_photons > 0 ? f->pilot_s / (double)f->pilot_photons : 0;
    rank_share share = {
        .threads = threads,
        .photons = f->emitted / n,
        .trace_s = photon_s * f->emitted / (n * threads),
        .tallies_bytes = murk_tallies_bytes(session->stage, threads),
        .matrix_bytes = matrix_bytes(session, poses, f),
        .records_bytes = others * records * sizeof(murk_photon),
        /* The sums are part of the memory for one thread. */
        .sums_bytes = ranks > 1 ? murk_tallies_bytes(session->stage, 1) : 0};
    /* In an unknown environment ranks divide the first look at each candidate,
     * and receive the rows that are remembered. */
    share.rows = rows_of(poses) / n;
    share.rows_bytes =
        others * (is_unknown(session)
                      ? memory_of_rows(session, share.matrix_bytes)
                      : share.matrix_bytes);
    if (!is_unknown(session) &&
        murk_matrix_spreads(rows_of(poses), records, ranks)) {
        share.matrix_bytes /= n;
        /* Fewer candidates are compared in pairs, for which all ranks receive
         * one row after the other. */
        if (rows_of(poses) > MURK_PRESOLVE_CANDIDATES_MAX) {
            share.rows_bytes = 0;
        }
    }
    return share;
}

void murk_overview_json_ranks(cJSON *root, const murk_session *session,
                              const murk_poses *poses, const murk_forecast *f,
                              unsigned ranks)
{
    const rank_share share = share_of(session, poses, f, ranks);
    cJSON *object = cJSON_AddObjectToObject(root, "ranks");
    murk_json_number(object, "count", ranks);
    murk_json_number(object, "threads", share.threads);
    /* Divided. */
    murk_json_number(object, "photons", share.photons);
    murk_json_number(object, "trace_s", share.trace_s);
    murk_json_number(object, "rows", share.rows);
    /* Held by each machine, and by each rank. */
    murk_json_number(object, "memory_bytes", f->memory_bytes);
    murk_json_number(object, "rows_bytes_at_most",
                     memory_of_rows(session, share.matrix_bytes));
    murk_json_number(object, "scratch_bytes_at_most",
                     scratch_bytes(session, share.matrix_bytes));
    murk_json_number(object, "tallies_bytes", share.tallies_bytes);
    /* Received by each rank. */
    murk_json_number(object, "received_records_bytes", share.records_bytes);
    murk_json_number(object, "received_rows_bytes_at_most", share.rows_bytes);
    murk_json_number(object, "received_sums_bytes_at_most", share.sums_bytes);
}

void murk_overview_print_ranks(const murk_session *session,
                               const murk_poses *poses, const murk_forecast *f,
                               unsigned ranks)
{
    const rank_share share = share_of(session, poses, f, ranks);
    const double gb = 1e-9;
    /* The work that is divided. */
    murk_print("ranks       %u with %u thread%s each; a rank traces %.3g "
               "photons a map and computes %.3g rows of the coverage matrix\n",
               ranks, share.threads, share.threads > 1 ? "s" : "",
               share.photons, share.rows);
    /* Memory and disk space; those of small matrices are not divided. */
    murk_print(
        "            memory about %.3g GB a map while tracing, which the "
        "ranks of a machine share; of each rank at most %.3g GB for "
        "rows, %.3g GB for tallies\n",
        gb * f->memory_bytes, gb * memory_of_rows(session, share.matrix_bytes),
        gb * share.tallies_bytes);
    const double scratch = scratch_bytes(session, share.matrix_bytes);
    if (scratch > 0) {
        murk_print("            scratch file of each rank at most %.3g GB\n",
                   gb * scratch);
    }
    /* The exchange, and the time. */
    murk_print("            received by each rank: %.3g GB of records a map, "
               "at most %.3g GB of rows and %.3g GB of sums of tallies\n",
               gb * share.records_bytes, gb * share.rows_bytes,
               gb * share.sums_bytes);
    murk_print(
        "time        about %.2g s to trace a map, as the pilot took; "
        "ordering the map, held-out photons, rows and choosing sensors are "
        "not counted\n",
        share.trace_s);
}
