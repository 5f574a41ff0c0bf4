/* Reads the triangles of `GEOM` (fds/geom.h). Sizes are checked against the
 * file before memory is taken. */
#include "fds/geom.h"

#include "base/inputs.h"
#include "base/path.h"
#include "fds/records.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define VERSION 2 /* of the format, as FDS 6 writes it */

typedef struct reader {
    murk_fds_records records;
    const char *where;
    murk_error *err;
} reader;

static murk_status bad(const reader *r, const char *problem)
{
    return murk_fail(r->err, MURK_BAD_FILE, r->where, "%s", problem);
}

static bool skip_if(reader *r, int32_t n)
{
    uint64_t size;
    return n == 0 || murk_fds_record_skip(&r->records, &size);
}

/* Reads the records before the frames. */
static murk_status read_head(reader *r)
{
    int32_t one, version, head[3];
    if (!murk_fds_records_begin(&r->records, sizeof one) ||
        !murk_fds_record_words(&r->records, &one, 1) || one != 1 ||
        !murk_fds_record_words(&r->records, &version, 1)) {
        return bad(r, "does not begin as a geometry file of FDS");
    }
    if (version != VERSION) {
        return murk_fail(r->err, MURK_BAD_FILE, r->where,
                         "is a geometry file of version %d, must be of %d",
                         version, VERSION);
    }
    if (!murk_fds_record_words(&r->records, head, 3) || !skip_if(r, head[0]) ||
        !skip_if(r, head[1])) {
        return bad(r, "has a malformed head");
    }
    return MURK_OK;
}

/* Reads time and sizes of a frame; false at the end of the file. */
static bool read_sizes(reader *r, int32_t size[3])
{
    float time_s;
    return murk_fds_record_words(&r->records, &time_s, 1) &&
           murk_fds_record_words(&r->records, size, 3);
}

/* Checks that all numbers are coordinates, corners and surfaces, and lets
 * corners count from 0 on. */
static murk_status check_geom(const reader *r, const murk_fds_run *run,
                              murk_fds_geom *g)
{
    bool is_good = true;
    for (size_t i = 0; i < 3 * g->vertices; ++i) {
        is_good = is_good && isfinite(g->vertex[i]);
    }
    if (!is_good) {
        return bad(r, "has coordinates that are not finite");
    }
    for (size_t i = 0; i < 3 * g->triangles; ++i) {
        is_good = is_good && g->corner[i] >= 1 && g->corner[i] <= g->vertices;
        g->corner[i] -= 1;
    }
    for (size_t i = 0; i < g->triangles; ++i) {
        is_good = is_good && g->surface[i] < run->surfaces;
    }
    return is_good ? MURK_OK
                   : bad(r, "has a triangle with a corner or surface that is "
                            "not there");
}

/* Reads the arrays of a frame. */
static murk_status read_frame(reader *r, const int32_t size[3],
                              murk_fds_geom *g)
{
    /* Each vertex takes 12 bytes of the file, each triangle 12 and more. */
    if (size[0] < 0 || size[1] < 0 || size[2] < 0 ||
        (uint64_t)size[0] + (uint64_t)size[1] > r->records.bytes / 12) {
        return bad(r, "has sizes beyond the end of the file");
    }
    g->vertices = (size_t)size[0];
    g->triangles = (size_t)size[1];
    g->vertex = malloc((3 * g->vertices + 1) * sizeof *g->vertex);
    g->corner = malloc((3 * g->triangles + 1) * sizeof *g->corner);
    g->surface = malloc((g->triangles + 1) * sizeof *g->surface);
    if (!g->vertex || !g->corner || !g->surface) {
        return murk_no_memory(r->err, r->where, "for its triangles");
    }
    murk_fds_records *from = &r->records;
    uint64_t skipped;
    const bool has_vertices =
        g->vertices == 0 ||
        murk_fds_record_words(from, g->vertex, 3 * g->vertices);
    const bool has_triangles =
        has_vertices &&
        (g->triangles == 0 ||
         (murk_fds_record_words(from, g->corner, 3 * g->triangles) &&
          murk_fds_record_words(from, g->surface, g->triangles) &&
          murk_fds_record_skip(from, &skipped)));
    /* Volumes have corners and materials. */
    return has_triangles && skip_if(r, size[2]) && skip_if(r, size[2])
               ? MURK_OK
               : bad(r, "ends within its triangles");
}

static murk_status read_file(reader *r, const murk_fds_run *run,
                             const char *path, murk_fds_geom *out)
{
    struct stat facts;
    FILE *file = r->records.file = murk_inputs_open(path);
    if (!file || fstat(fileno(file), &facts) != 0 || !S_ISREG(facts.st_mode)) {
        return bad(r, file ? "is not a regular file" : strerror(errno));
    }
    r->records.bytes = (uint64_t)facts.st_size;
    int32_t size[3], more[3];
    murk_status status = read_head(r);
    if (!status && !read_sizes(r, size)) {
        status = bad(r, "has no frame");
    }
    if (!status) {
        status = read_frame(r, size, out);
    }
    if (!status) {
        status = check_geom(r, run, out);
    }
    return !status && read_sizes(r, more)
               ? bad(r, "has more than one frame: geometry that moves is not "
                        "read")
               : status;
}

murk_status murk_fds_geom_read(murk_fds_geom *out, const murk_fds_run *run,
                               const char *path, const char *where,
                               murk_error *err)
{
    *out = (murk_fds_geom){0};
    if (!run->geom[0]) {
        return MURK_OK;
    }
    murk_error own = {0};
    char place[sizeof own.where];
    snprintf(place, sizeof place, "%.400s: %s", where, run->geom);
    reader r = {.where = place, .err = err ? err : &own};
    char *file = murk_path_beside(path, run->geom);
    const murk_status status =
        file ? read_file(&r, run, file, out)
             : murk_no_memory(err, where, "for its triangles");
    if (r.records.file) {
        fclose(r.records.file);
    }
    free(file);
    return status;
}

void murk_fds_geom_release(murk_fds_geom *geom)
{
    free(geom->vertex);
    free(geom->corner);
    free(geom->surface);
    *geom = (murk_fds_geom){0};
}
