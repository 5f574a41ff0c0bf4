/* Reads FDS runs as rectilinear grids. The files are parsed in the process that
 * the host chooses (base/subprocess.h), which sends a header of fixed size and
 * the packed field (medium/rectilinear.h). */
#include "medium/grid.h"

#include "base/log.h"
#include "medium/grid_internal.h"
#include "medium/grid_jobs.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* The request. */
typedef struct job {
    const char *path, *where;
    murk_fds_asked asked;
} job;

/* What comes before the packed field. A multiple of eight bytes. */
typedef struct header {
    double frame_s[2], weight, step_per_m, capped_per_m, mass_extinction;
    uint64_t capped;
    uint32_t quantity, is_rounded;
} header;

/* ---- in the process that parses ---- */

static murk_status send_field(murk_subprocess *to, const murk_fds_field *f)
{
    const header first = {.frame_s = {f->frame_s[0], f->frame_s[1]},
                          .weight = f->weight,
                          .step_per_m = f->step_per_m,
                          .capped_per_m = f->capped_per_m,
                          .mass_extinction = f->mass_extinction,
                          .capped = f->capped,
                          .quantity = (uint32_t)f->quantity,
                          .is_rounded = f->is_rounded};
    const uint64_t blocks = f->n;
    murk_status status = murk_subprocess_send(to, &first, sizeof first);
    if (!status) {
        status = murk_subprocess_send(to, &blocks, sizeof blocks);
    }
    /* Sizes, edges and values, each of all blocks. */
    for (size_t i = 0; i < f->n && !status; ++i) {
        const murk_fds_block *b = &f->block[i];
        const murk_rectilinear_size size = {
            .cells = {b->cells[0], b->cells[1], b->cells[2]},
            .has_nodes = b->has_nodes};
        status = murk_subprocess_send(to, &size, sizeof size);
    }
    for (size_t i = 0; i < 3 * f->n && !status; ++i) {
        const murk_fds_block *b = &f->block[i / 3];
        status = murk_subprocess_send(to, b->edge[i % 3],
                                      (b->cells[i % 3] + 1) * sizeof(double));
    }
    for (size_t i = 0; i < f->n && !status; ++i) {
        const murk_fds_block *b = &f->block[i];
        const murk_rectilinear_size size = {
            .cells = {b->cells[0], b->cells[1], b->cells[2]},
            .has_nodes = b->has_nodes};
        status = murk_subprocess_send(
            to, b->value, murk_rectilinear_values(&size) * sizeof(float));
    }
    return status;
}

static murk_status read_in_subprocess(murk_subprocess *subprocess,
                                      void *context, murk_error *err)
{
    const job *j = context;
    murk_fds_field *field = NULL;
    murk_status status =
        murk_fds_field_read(&field, j->path, &j->asked, j->where, err);
    if (!status) {
        status = send_field(subprocess, field);
    }
    murk_fds_field_destroy(field);
    return status;
}

static void pack(murk_parcel *to, const void *context)
{
    const job *j = context;
    murk_parcel_put_text(to, j->path);
    murk_parcel_put_text(to, j->where);
    murk_parcel_put(to, &j->asked.quantity, sizeof j->asked.quantity);
    murk_parcel_put(to, &j->asked.time_s, sizeof j->asked.time_s);
    murk_parcel_put(to, &j->asked.n_meshes, sizeof j->asked.n_meshes);
    murk_parcel_put(to, j->asked.mesh,
                    j->asked.n_meshes * sizeof *j->asked.mesh);
}

static murk_status read_packed(murk_subprocess *subprocess, murk_parcel *from,
                               murk_error *err)
{
    job j = {.path = murk_parcel_take_text(from),
             .where = murk_parcel_take_text(from)};
    const murk_fds_quantity *quantity =
        murk_parcel_take(from, sizeof *quantity);
    const double *time_s = murk_parcel_take(from, sizeof *time_s);
    const size_t *n = murk_parcel_take(from, sizeof *n);
    const double *mesh = murk_parcel_take(from, 0);
    if (from->is_short || !j.path || !j.where || !quantity || !time_s || !n) {
        return murk_fail(err, MURK_RUN_FAILED, "", "malformed request");
    }
    j.asked = (murk_fds_asked){
        .quantity = *quantity, .mesh = mesh, .n_meshes = *n, .time_s = *time_s};
    return read_in_subprocess(subprocess, &j, err);
}

const murk_subprocess_job murk_grid_fds_job = {"fds", read_in_subprocess, pack,
                                               read_packed};

/* ---- the answer ---- */

/* Describes how the values were obtained. */
static void describe(const header *h, char *out, size_t size)
{
    char from[128];
    const murk_fds_quantity quantity = (murk_fds_quantity)h->quantity;
    if (h->is_rounded) {
        snprintf(from, sizeof from,
                 "bytes of .s3d, rounded to +-%.3g /m and more where the smoke "
                 "is denser",
                 h->step_per_m);
    } else if (quantity == MURK_FDS_SOOT_DENSITY) {
        snprintf(from, sizeof from, "slices, mass extinction %.6g m2/kg",
                 h->mass_extinction);
    } else {
        snprintf(from, sizeof from, "slices%s",
                 quantity == MURK_FDS_VISIBILITY ? ", extinction 3/S" : "");
    }
    if (h->weight > 0) {
        snprintf(out, size, "%s; between the frames at %.7g and %.7g s", from,
                 h->frame_s[0], h->frame_s[1]);
    } else {
        snprintf(out, size, "%s; frame at %.7g s", from, h->frame_s[0]);
    }
}

/* Warns of values that are limits and not measures. */
static void warn(const header *h, const murk_grid_facts *facts,
                 const char *where)
{
    if (h->is_rounded && h->capped > 0) {
        murk_warn(where,
                  "%llu of %llu values are opaque in the .s3d files: the "
                  "extinction there is at least %.4g /m, which is taken",
                  (unsigned long long)h->capped,
                  (unsigned long long)facts->active, h->capped_per_m);
    } else if (!h->is_rounded && h->quantity == MURK_FDS_VISIBILITY) {
        murk_warn(where,
                  "%llu of %llu values have the largest visibility, at which "
                  "FDS cuts: the extinction there is at most %.4g /m, which is "
                  "taken",
                  (unsigned long long)h->capped,
                  (unsigned long long)facts->active, h->capped_per_m);
    }
    if (facts->maximum == 0) {
        murk_warn(where, "the smoke is 0 everywhere: there is nothing in the "
                         "way of light");
    }
}

static murk_status build_received(murk_grid **out, const unsigned char *sent,
                                  size_t size, const char *where,
                                  murk_error *err)
{
    header h;
    if (size < sizeof h) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "malformed: its reader handed over nothing");
    }
    memcpy(&h, sent, sizeof h);
    if (h.quantity > MURK_FDS_VISIBILITY) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "malformed: its reader handed over no quantity");
    }
    char note[sizeof((murk_grid_facts *)0)->note];
    describe(&h, note, sizeof note);
    murk_status status = murk_grid_from_field(
        out, sent + sizeof h, size - sizeof h,
        murk_fds_quantity_names[h.quantity], note, where, err);
    if (!status) {
        warn(&h, murk_grid_describe(*out), where);
    }
    return status;
}

murk_status murk_grid_read_fds(murk_grid **out, const char *path,
                               const murk_fds_asked *asked, const char *where,
                               murk_error *err)
{
    char place[sizeof err->where];
    snprintf(place, sizeof place, "%s: %s", where, path);
    struct stat facts;
    const uint64_t size = stat(path, &facts) == 0 ? (uint64_t)facts.st_size : 0;
    job j = {.path = path, .where = place, .asked = *asked};
    const murk_subprocess_limits limits = murk_subprocess_limits_for(size);
    unsigned char *sent = NULL;
    size_t n = 0;
    murk_status status = murk_subprocess_do(&sent, &n, &murk_grid_fds_job, &j,
                                            &limits, place, err);
    if (!status) {
        status = build_received(out, sent, n, place, err);
    }
    free(sent);
    return status;
}
