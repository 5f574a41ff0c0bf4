/* Reads OpenVDB grids and stores them as NanoVDB buffers, and stores
 * rectilinear grids.
 *
 * The files are parsed in the process that the host chooses
 * (base/subprocess.h), mostly a subprocess. It sends a header of fixed size
 * (murk_vdb_facts of medium/vdb_bridge.h), then the bytes of the NanoVDB grid,
 * which the calling process copies to aligned memory and opens as a tree
 * (medium/tree.h). */
#include "medium/grid.h"
#include "medium/grid_internal.h"
#include "medium/grid_jobs.h"

#include "base/file.h"
#include "base/inputs.h"
#include "base/log.h"
#include "base/memory_files.h"
#include "base/subprocess.h"
#include "medium/tree.h"
#include "medium/vdb_bridge.h"

#include <assert.h>
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Memory limit of the subprocess, if less than that of
 * murk_subprocess_limits_for(). A sparse tree is larger in memory than in the
 * file: a node of 4096 voxels along an edge takes some 8 kB in a file and 262
 * kB in memory, twice while the node is converted. 200 bytes for each byte of
 * the file is three times that, and a small hostile file still cannot fill much
 * memory: libraries reserve and copy what its header asks for. MIN_BYTES, which
 * is added, is for the libraries themselves. */
#define MIN_BYTES           UINT64_C(400000000)
#define BYTES_PER_FILE_BYTE 200

#define ALIGNMENT \
    64 /* of buffers, in bytes; NanoVDB requires a multiple of 32 */

struct murk_grid {
    murk_grid_facts facts;
    unsigned char *buffer;   /* the NanoVDB grid, NULL if no voxel is active, or
                              * the packed field of a rectilinear grid */
    murk_tree tree;          /* of voxels */
    murk_rectilinear field;  /* of a rectilinear grid, in `buffer`; n 0: none */
    unsigned further_owners; /* murk_grid_share() */
};

/* The request to the subprocess: a file, or dense samples. */
typedef struct job {
    murk_subprocess *subprocess;
    const char *path, *name; /* path of a file, and name of a grid */
    const char *next;        /* path of the next frame's file; NULL: none */
    double next_weight;      /* of the grid of that file */
    const size_t *size;      /* number of samples along each axis */
    const float *density;
    double index_to_world[12]; /* three rows of four */
    bool as_tiles, is_albedo;
    const char *where, *next_where; /* places of both files */
    const char *read_where; /* place of a failure to read that does not tell
                             * which of the files is to blame */
} job;

/* In the process that parses the file: sends the header, then the grid. */
static murk_status send_grid(void *context, const murk_vdb_facts *facts,
                             const void *bytes, size_t size)
{
    const job *j = context;
    const murk_status status =
        murk_subprocess_send(j->subprocess, facts, sizeof *facts);
    return status || size == 0
               ? status
               : murk_subprocess_send(j->subprocess, bytes, size);
}

static murk_status read_in_subprocess(murk_subprocess *subprocess,
                                      void *context, murk_error *err)
{
    job *j = context;
    j->subprocess = subprocess;
    if (j->next) {
        const char *const path[] = {j->path, j->next};
        const char *const where[] = {j->where, j->next_where};
        return murk_vdb_now()->read_between(path, j->name, j->next_weight,
                                            send_grid, j, where, err);
    }
    return murk_vdb_now()->read(j->path, j->name, j->is_albedo, send_grid, j,
                                j->where, err);
}

static murk_status make_in_subprocess(murk_subprocess *subprocess,
                                      void *context, murk_error *err)
{
    job *j = context;
    j->subprocess = subprocess;
    return murk_vdb_now()->from_samples(j->size, j->density, j->index_to_world,
                                        j->as_tiles, send_grid, j, j->where,
                                        err);
}

/* ---- the jobs ---- */

static void pack_file(murk_parcel *to, const void *context)
{
    const job *j = context;
    murk_parcel_put_text(to, j->path);
    murk_parcel_put_text(to, j->name);
    murk_parcel_put_text(to, j->where);
    murk_parcel_put(to, &j->is_albedo, sizeof j->is_albedo);
    murk_parcel_put_text(to, j->next);
    murk_parcel_put_text(to, j->next_where);
    murk_parcel_put(to, &j->next_weight, sizeof j->next_weight);
}

static murk_status read_packed(murk_subprocess *subprocess, murk_parcel *from,
                               murk_error *err)
{
    job j = {0};
    j.path = murk_parcel_take_text(from);
    j.name = murk_parcel_take_text(from);
    j.where = murk_parcel_take_text(from);
    const bool *is_albedo = murk_parcel_take(from, sizeof *is_albedo);
    j.next = murk_parcel_take_text(from);
    j.next_where = murk_parcel_take_text(from);
    const double *weight = murk_parcel_take(from, sizeof *weight);
    if (!is_albedo || !weight || !j.path || !j.where ||
        (j.next && !j.next_where)) {
        return murk_fail(err, MURK_RUN_FAILED, "", "malformed request");
    }
    j.is_albedo = *is_albedo;
    j.next_weight = *weight;
    return read_in_subprocess(subprocess, &j, err);
}

const murk_subprocess_job murk_grid_read_job = {.name = "grid",
                                                .prepare = murk_vdb_prepare,
                                                .work = read_in_subprocess,
                                                .pack = pack_file,
                                                .work_packed = read_packed};

static void pack_samples(murk_parcel *to, const void *context)
{
    const job *j = context;
    murk_parcel_put(to, j->size, 3 * sizeof *j->size);
    murk_parcel_put(to, j->density,
                    j->size[0] * j->size[1] * j->size[2] * sizeof *j->density);
    murk_parcel_put(to, j->index_to_world, sizeof j->index_to_world);
    murk_parcel_put(to, &j->as_tiles, sizeof j->as_tiles);
    murk_parcel_put_text(to, j->where);
}

static murk_status make_packed(murk_subprocess *subprocess, murk_parcel *from,
                               murk_error *err)
{
    job j = {0};
    j.size = murk_parcel_take(from, 3 * sizeof *j.size);
    j.density = murk_parcel_take(from, 0);
    const double *rows = murk_parcel_take(from, sizeof j.index_to_world);
    const bool *as_tiles = murk_parcel_take(from, sizeof *as_tiles);
    j.where = murk_parcel_take_text(from);
    if (from->is_short || !j.where) {
        return murk_fail(err, MURK_RUN_FAILED, "", "malformed request");
    }
    memcpy(j.index_to_world, rows, sizeof j.index_to_world);
    j.as_tiles = *as_tiles;
    return make_in_subprocess(subprocess, &j, err);
}

const murk_subprocess_job murk_grid_make_job = {.name = "samples",
                                                .prepare = murk_vdb_prepare,
                                                .work = make_in_subprocess,
                                                .pack = pack_samples,
                                                .work_packed = make_packed};

/* ---- the answer ---- */

static murk_grid_facts facts_from_vdb(const murk_vdb_facts *vdb)
{
    murk_grid_facts facts = {.active = vdb->active,
                             .minimum = vdb->minimum,
                             .maximum = vdb->maximum,
                             .sum = vdb->sum,
                             .background = vdb->background};
    memcpy(facts.name, vdb->name, sizeof facts.name);
    /* Transformation; the length of a column of the matrix is the edge of a
     * voxel along that axis. */
    double edge_squared[3] = {0};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            const double m = vdb->index_to_world[4 * row + column];
            facts.index_to_world.matrix[row][column] = m;
            edge_squared[column] += m * m;
        }
    }
    facts.index_to_world.shift =
        murk_vec(vdb->index_to_world[3], vdb->index_to_world[7],
                 vdb->index_to_world[11]);
    for (int axis = 0; axis < 3; ++axis) {
        facts.voxel_m[axis] = sqrt(edge_squared[axis]);
        facts.index_min[axis] = vdb->index_min[axis];
        facts.index_max[axis] = vdb->index_max[axis];
    }
    return facts;
}

static murk_status copy_buffer(murk_grid *grid, const unsigned char *bytes,
                               size_t size, const char *where, murk_error *err)
{
    if (size == 0) {
        return MURK_OK;
    }
    const size_t rounded = (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    grid->buffer = aligned_alloc(ALIGNMENT, rounded);
    if (!grid->buffer) {
        return murk_no_memory(err, where, "for a grid of %zu bytes", size);
    }
    memcpy(grid->buffer, bytes, size);
    grid->facts.memory_bytes = rounded;
    return MURK_OK;
}

/* Warns of inactive voxels with a value, which often mean a mistake in the
 * file. */
static void warn_of_cleared(const char *where, const char *grid,
                            uint64_t voxels)
{
    if (voxels > 0) {
        murk_warn(where,
                  "grid %s: %llu voxels hold a value but are not active; "
                  "they count as 0",
                  grid, (unsigned long long)voxels);
    }
}

static murk_status malformed(const char *where, murk_error *err)
{
    return murk_fail(err, MURK_BAD_FILE, where,
                     "malformed: its reader handed over nothing");
}

/* Builds the grid from the bytes that send_grid() sent. */
static murk_status build_received(murk_grid **out, const unsigned char *sent,
                                  size_t size, const job *j, murk_error *err)
{
    const char *where = j->where;
    /* The header first. */
    murk_vdb_facts facts;
    if (size < sizeof facts) {
        return malformed(where, err);
    }
    memcpy(&facts, sent, sizeof facts);
    murk_grid *grid = calloc(1, sizeof *grid);
    if (!grid) {
        return murk_no_memory(err, where, "for a grid");
    }
    /* Copy the grid and open the tree. */
    grid->facts = facts_from_vdb(&facts);
    murk_status status =
        copy_buffer(grid, sent + sizeof facts, size - sizeof facts, where, err);
    if (!status) {
        status = murk_tree_open(
            &grid->tree, grid->buffer, facts.index_min, facts.index_max,
            j->is_albedo ? MURK_VDB_NO_ALBEDO : 0, where, err);
    }
    if (status) {
        goto done;
    }
    warn_of_cleared(where, facts.name, facts.cleared);
    warn_of_cleared(j->next_where, facts.name, facts.cleared_next);
    *out = grid;
    grid = NULL;
done:
    murk_grid_destroy(grid);
    return status;
}

void murk_grid_limit_memory(murk_subprocess_limits *limits, uint64_t file_bytes)
{
    if (file_bytes < (limits->memory_bytes - MIN_BYTES) / BYTES_PER_FILE_BYTE) {
        limits->memory_bytes = MIN_BYTES + BYTES_PER_FILE_BYTE * file_bytes;
    }
}

static murk_status run(murk_grid **out, const murk_subprocess_job *kind, job *j,
                       uint64_t input_bytes, murk_error *err)
{
    murk_subprocess_limits limits = murk_subprocess_limits_for(input_bytes);
    murk_grid_limit_memory(&limits, input_bytes);
    unsigned char *sent = NULL;
    size_t size = 0;
    murk_status status =
        murk_subprocess_do(&sent, &size, kind, j, &limits, j->read_where, err);
    if (!status) {
        status = build_received(out, sent, size, j, err);
    }
    free(sent);
    return status;
}

/* Checks that need no parser: a regular, readable file with the magic bytes
 * of OpenVDB (openvdb/io/Archive.cc). */
static murk_status check_file(const char *path, uint64_t *size,
                              const char *where, murk_error *err)
{
    static const unsigned char vdb[8] = {0x20, 'B', 'D', 'V', 0, 0, 0, 0};
    struct stat facts;
    if (stat(path, &facts) != 0) {
        return murk_fail(err, MURK_BAD_FILE, where, "cannot be read: %s",
                         strerror(errno));
    }
    if (!S_ISREG(facts.st_mode)) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         S_ISDIR(facts.st_mode)
                             ? "is a folder, must be an OpenVDB file"
                             : "is not a regular file");
    }
    /* Read the first eight bytes. */
    FILE *file = murk_inputs_open(path);
    if (!file) {
        return murk_fail(err, MURK_BAD_FILE, where, "cannot be read: %s",
                         strerror(errno));
    }
    unsigned char magic[8] = {0};
    const size_t n = fread(magic, 1, sizeof magic, file);
    fclose(file);
    if (n == 0) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "is empty, must be an OpenVDB file");
    }
    /* A NanoVDB file is a common mistake and gets a message of its own. */
    if (n >= 7 && memcmp(magic, "NanoVDB", 7) == 0) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "is a NanoVDB file, must be OpenVDB: "
                         "nanovdb_convert makes a .vdb of it");
    }
    if (n < sizeof magic || memcmp(magic, vdb, sizeof vdb) != 0) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "is not an OpenVDB file (its first bytes differ)");
    }
    *size = (uint64_t)facts.st_size;
    return MURK_OK;
}

/* Makes a grid of the samples in memory that a path "memory:NAME" names
 * (base/memory_files.h). Albedos are refused. */
static murk_status read_memory(murk_grid **out, const char *path,
                               bool is_albedo, const char *where,
                               murk_error *err)
{
    const murk_memory_file *file = NULL;
    const murk_status status =
        murk_memory_find(&file, path, MURK_MEMORY_GRID, where, err);
    if (status) {
        return status;
    }
    if (is_albedo) {
        return murk_fail(err, MURK_UNSUPPORTED, where,
                         "a grid of albedos must be an OpenVDB file");
    }
    const murk_grid_samples *given = file->data;
    return murk_grid_from_samples(out, given->size, given->value,
                                  &given->index_to_world, where, err);
}

/* Checks the files of a request and lets a subprocess read them. Limits are
 * those of one file of the size of all. */
static murk_status read_files(murk_grid **out, job *j, murk_error *err)
{
    uint64_t size = 0, next_size = 0;
    murk_status status = check_file(j->path, &size, j->where, err);
    if (!status && j->next) {
        status = check_file(j->next, &next_size, j->next_where, err);
    }
    return status ? status
                  : run(out, &murk_grid_read_job, j, size + next_size, err);
}

/* Reads the grid of a request, whose places are set here; warns if no voxel is
 * active or if all densities are 0. */
static murk_status read_grid(murk_grid **out, job *j, const char *where,
                             murk_error *err)
{
    char place[sizeof err->where], next_place[sizeof err->where],
        both[sizeof err->where];
    snprintf(place, sizeof place, "%s: %s", where, j->path);
    snprintf(next_place, sizeof next_place, "%s: %s", where,
             j->next ? j->next : "");
    snprintf(both, sizeof both, "%s: %s or %s", where, j->path,
             j->next ? j->next : "");
    j->where = place;
    j->next_where = next_place;
    j->read_where = j->next ? both : place;
    const murk_status status =
        murk_memory_is(j->path)
            ? read_memory(out, j->path, j->is_albedo, place, err)
            : read_files(out, j, err);
    if (status) {
        return status;
    }
    /* A grid without effect often means a mistake. */
    const murk_grid_facts *facts = &(*out)->facts;
    if (j->is_albedo && facts->active == 0) {
        murk_warn(place, "grid %s is empty: the albedo is %g everywhere",
                  facts->name, facts->background);
    } else if (!j->is_albedo && facts->maximum == 0) {
        murk_warn(place, "grid %s %s: there is nothing in the way of light",
                  facts->name, facts->active ? "is 0 everywhere" : "is empty");
    }
    return MURK_OK;
}

murk_status murk_grid_read(murk_grid **out, const char *path, const char *name,
                           const char *where, murk_error *err)
{
    job j = {.path = path, .name = name};
    return read_grid(out, &j, where, err);
}

murk_status murk_grid_read_between(murk_grid **out, const char *const path[2],
                                   double weight, const char *name,
                                   const char *where, murk_error *err)
{
    assert(weight > 0 && weight < 1);
    if (murk_memory_is(path[0]) || murk_memory_is(path[1])) {
        return murk_fail(err, MURK_UNSUPPORTED, where,
                         "frames to interpolate must be OpenVDB files");
    }
    job j = {
        .path = path[0], .name = name, .next = path[1], .next_weight = weight};
    return read_grid(out, &j, where, err);
}

murk_status murk_grid_read_albedo(murk_grid **out, const char *path,
                                  const char *name, const char *where,
                                  murk_error *err)
{
    job j = {.path = path, .name = name, .is_albedo = true};
    return read_grid(out, &j, where, err);
}

murk_status murk_grid_check_size(const size_t size[3], size_t *voxels,
                                 const char *where, murk_error *err)
{
    size_t n = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(size[axis] > 0 && size[axis] <= MURK_VOXELS_MAX / n)) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "%zu x %zu x %zu samples, must be 1 or more along "
                             "each axis and at most %zu in all",
                             size[0], size[1], size[2],
                             (size_t)MURK_VOXELS_MAX);
        }
        n *= size[axis];
    }
    *voxels = n;
    return MURK_OK;
}

murk_status murk_grid_make(murk_grid **out, const size_t size[3],
                           const float *density,
                           const murk_affine *index_to_world, bool as_tiles,
                           const char *where, murk_error *err)
{
    size_t voxels = 0;
    const murk_status status = murk_grid_check_size(size, &voxels, where, err);
    if (status) {
        return status;
    }
    job j = {
        .size = size, .density = density, .as_tiles = as_tiles, .where = where};
    murk_affine_rows(index_to_world, j.index_to_world);
    return run(out, &murk_grid_make_job, &j, voxels * sizeof *density, err);
}

murk_status murk_grid_from_samples(murk_grid **out, const size_t size[3],
                                   const float *density,
                                   const murk_affine *index_to_world,
                                   const char *where, murk_error *err)
{
    return murk_grid_make(out, size, density, index_to_world, true, where, err);
}

murk_grid *murk_grid_share(murk_grid *grid)
{
    if (grid) {
        ++grid->further_owners;
    }
    return grid;
}

void murk_grid_destroy(murk_grid *grid)
{
    if (grid && grid->further_owners > 0) {
        --grid->further_owners;
    } else if (grid) {
        murk_tree_close(&grid->tree);
        murk_rectilinear_close(&grid->field);
        free(grid->buffer);
        free(grid);
    }
}

const murk_grid_facts *murk_grid_describe(const murk_grid *grid)
{
    return &grid->facts;
}

const void *murk_grid_nanovdb(const murk_grid *grid)
{
    return grid->field.n ? NULL : grid->buffer;
}

const murk_tree *murk_grid_tree(const murk_grid *grid)
{
    return &grid->tree;
}

const murk_rectilinear *murk_grid_rectilinear(const murk_grid *grid)
{
    return grid->field.n ? &grid->field : NULL;
}

static void describe_field(murk_grid *grid, const murk_field_head *head,
                           size_t size)
{
    const murk_rectilinear *field = &grid->field;
    murk_grid_facts *facts = &grid->facts;
    snprintf(facts->name, sizeof facts->name, "%.*s",
             (int)sizeof head->name - 1, head->name);
    snprintf(facts->note, sizeof facts->note, "%.*s",
             (int)sizeof head->note - 1, head->note);
    facts->effective_radius_um = head->effective_radius_um;
    facts->active = field->n_values;
    facts->minimum = field->minimum;
    facts->maximum = field->maximum;
    facts->sum = field->sum;
    facts->index_to_world = murk_affine_identity();
    memcpy(facts->voxel_m, field->smallest, sizeof facts->voxel_m);
    facts->blocks = field->n;
    for (size_t i = 0; i < field->n; ++i) {
        facts->has_nodes = facts->has_nodes || field->block[i].has_nodes;
    }
    facts->box = field->box;
    murk_checksum(grid->buffer, size, facts->checksum);
}

murk_status murk_grid_from_field(murk_grid **out, const unsigned char *packed,
                                 size_t size, const char *where,
                                 murk_error *err)
{
    murk_field_head head;
    if (size < sizeof head) {
        return malformed(where, err);
    }
    memcpy(&head, packed, sizeof head);
    murk_grid *grid = calloc(1, sizeof *grid);
    if (!grid) {
        return murk_no_memory(err, where, "for a grid");
    }
    size -= sizeof head;
    murk_status status =
        copy_buffer(grid, packed + sizeof head, size, where, err);
    if (!status) {
        status =
            murk_rectilinear_open(&grid->field, grid->buffer, size, where, err);
    }
    if (status) {
        murk_grid_destroy(grid);
        return status;
    }
    /* Facts and warnings. */
    describe_field(grid, &head, size);
    if (head.warning[0]) {
        murk_warn(where, "%.*s", (int)sizeof head.warning - 1, head.warning);
    }
    if (grid->facts.maximum == 0) {
        murk_warn(where,
                  "%s is 0 everywhere: there is nothing in the way of "
                  "light",
                  grid->facts.name);
    }
    *out = grid;
    return MURK_OK;
}

murk_status murk_grid_read_field(murk_grid **out,
                                 const murk_subprocess_job *kind, void *context,
                                 const murk_subprocess_limits *limits,
                                 const char *where, murk_error *err)
{
    unsigned char *sent = NULL;
    size_t size = 0;
    murk_status status =
        murk_subprocess_do(&sent, &size, kind, context, limits, where, err);
    if (!status) {
        status = murk_grid_from_field(out, sent, size, where, err);
    }
    free(sent);
    return status;
}

double murk_grid_value(const murk_grid *grid, int64_t i, int64_t j, int64_t k)
{
    const int64_t at[3] = {i, j, k};
    int32_t voxel[3];
    for (int axis = 0; axis < 3; ++axis) {
        if (at[axis] < grid->tree.first[axis] ||
            at[axis] > grid->tree.last[axis]) {
            return 0;
        }
        voxel[axis] = (int32_t)at[axis];
    }
    return (double)murk_tree_value(&grid->tree, voxel);
}
