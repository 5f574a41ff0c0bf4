/* Reads FDS runs as rectilinear grids. The files are parsed in the process that
 * the host chooses (base/subprocess.h), which sends the packed field
 * (base/field_blocks.h). */
#include "medium/grid.h"

#include "fds/data_files.h"
#include "medium/grid_internal.h"
#include "medium/grid_jobs.h"

#include <stdio.h>
#include <sys/stat.h>

/* The request. */
typedef struct job {
    const char *path, *where;
    murk_fds_asked asked;
} job;

/* ---- in the process that parses ---- */

/* Describes how the values were obtained. */
static void describe(const murk_fds_field *f, char *out, size_t size)
{
    char from[128];
    if (f->is_rounded) {
        snprintf(from, sizeof from,
                 "bytes of .s3d, rounded to +-%.3g /m and more where the smoke "
                 "is denser",
                 f->step_per_m);
    } else if (f->quantity == MURK_FDS_SOOT_DENSITY) {
        snprintf(from, sizeof from, "slices, mass extinction %.6g m2/kg",
                 f->mass_extinction);
    } else {
        snprintf(from, sizeof from, "slices%s",
                 f->quantity == MURK_FDS_VISIBILITY ? ", extinction 3/S" : "");
    }
    if (f->weight > 0) {
        snprintf(out, size, "%s; between the frames at %.7g and %.7g s", from,
                 f->frame_s[0], f->frame_s[1]);
    } else {
        snprintf(out, size, "%s; frame at %.7g s", from, f->frame_s[0]);
    }
}

/* The warning of values that are limits and not measures. */
static void warn(const murk_fds_field *f, char *out, size_t size)
{
    if (f->is_rounded && f->capped > 0) {
        snprintf(out, size,
                 "%llu values are opaque in the .s3d files: the extinction "
                 "there is at least %.4g /m, which is taken",
                 (unsigned long long)f->capped, f->capped_per_m);
    } else if (f->capped > 1 && f->quantity == MURK_FDS_VISIBILITY) {
        /* Only a limit gives several values the same largest visibility. */
        snprintf(out, size,
                 "%llu values have the largest visibility, at which FDS cuts: "
                 "the extinction there is at most %.4g /m, which is taken",
                 (unsigned long long)f->capped, f->capped_per_m);
    }
}

static murk_status read_in_subprocess(murk_subprocess *subprocess,
                                      void *context, murk_error *err)
{
    const job *j = context;
    murk_fds_field *field = NULL;
    murk_status status =
        murk_fds_field_read(&field, j->path, &j->asked, j->where, err);
    if (!status) {
        murk_field_head head = {0};
        snprintf(head.name, sizeof head.name, "%s",
                 murk_fds_quantity_names[field->quantity]);
        describe(field, head.note, sizeof head.note);
        warn(field, head.warning, sizeof head.warning);
        status = murk_field_send(subprocess, &head, field->block, field->n);
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

const murk_subprocess_job murk_grid_fds_job = {.name = "fds",
                                               .work = read_in_subprocess,
                                               .pack = pack,
                                               .work_packed = read_packed};

/* ---- in the host ---- */

/* Adds the size of a file to the sum in `context`. */
static bool add_size(void *context, const char *file)
{
    uint64_t *sum = context;
    struct stat facts;
    if (stat(file, &facts) == 0) {
        *sum += (uint64_t)facts.st_size;
    }
    return true;
}

/* The limits for a run. Its values are in the data files beside the .smv file,
 * which are read up to the time that is asked for. */
static murk_subprocess_limits limits_for(const char *path)
{
    uint64_t bytes = 0;
    (void)add_size(&bytes, path);
    (void)murk_fds_data_files(path, false, add_size, &bytes);
    return murk_subprocess_limits_for(bytes);
}

murk_status murk_grid_read_fds(murk_grid **out, const char *path,
                               const murk_fds_asked *asked, const char *where,
                               murk_error *err)
{
    char place[sizeof err->where];
    snprintf(place, sizeof place, "%s: %s", where, path);
    job j = {.path = path, .where = place, .asked = *asked};
    const murk_subprocess_limits limits = limits_for(path);
    return murk_grid_read_field(out, &murk_grid_fds_job, &j, &limits, place,
                                err);
}
