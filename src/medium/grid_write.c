/* Writes .vdb files: checks the fields, lets a job of murk_subprocess_do()
 * (base/subprocess.h) build the bytes of the file, and replaces the random file
 * identifier by one derived from the contents. */
#include "medium/grid_write.h"
#include "medium/grid_internal.h"
#include "medium/grid_jobs.h"

#include "base/file.h"
#include "base/subprocess.h"
#include "medium/tree.h"
#include "medium/vdb_bridge.h"

#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Names of grids are read back into 128 bytes (murk_grid_facts). */
#define NAME_BYTES_MAX 127

/* Upper limits of the memory of one node: a leaf has 512 values, the others
 * have tables of 4096 and 32768 entries. */
#define LEAF_BYTES  UINT64_C(2304)
#define LOWER_BYTES UINT64_C(40000)
#define UPPER_BYTES UINT64_C(300000)
#define MIN_BYTES   UINT64_C(400000000) /* for OpenVDB itself */

/* A generous time limit: some 2e7 voxels per second are usual. */
#define VOXELS_PER_SECOND UINT64_C(1000000)
#define MIN_SECONDS       60

typedef struct job {
    murk_subprocess *subprocess;
    const char *where;
    murk_vdb_field field[MURK_GRID_FIELDS_MAX];
    size_t n;
    const size_t *size;
    double index_to_world[12]; /* three rows of four */
} job;

static murk_status check_field(const murk_grid_field *fields, size_t i,
                               size_t voxels, const char *path, murk_error *err)
{
    const char *name = fields[i].name;
    const size_t length = name ? strlen(name) : 0;
    if (!(length > 0 && length <= NAME_BYTES_MAX)) {
        return murk_fail(err, MURK_BAD_VALUE, path,
                         "field %zu has a name of %zu bytes, must be 1..%d", i,
                         length, NAME_BYTES_MAX);
    }
    for (size_t k = 0; k < i; ++k) {
        if (strcmp(name, fields[k].name) == 0) {
            return murk_fail(err, MURK_BAD_VALUE, path,
                             "two fields named %s, must differ", name);
        }
    }
    for (size_t k = 0; k < voxels; ++k) {
        if (!isfinite(fields[i].value[k])) {
            return murk_fail(err, MURK_BAD_VALUE, path,
                             "field %s: value %zu is %g, must be finite", name,
                             k, (double)fields[i].value[k]);
        }
    }
    return MURK_OK;
}

static murk_status check(const char *path, const murk_grid_field *fields,
                         size_t n, const size_t size[3],
                         const murk_affine *index_to_world, murk_error *err)
{
    murk_affine inverse;
    if (!(n > 0 && n <= MURK_GRID_FIELDS_MAX)) {
        return murk_fail(err, MURK_BAD_VALUE, path, "%zu fields, must be 1..%d",
                         n, MURK_GRID_FIELDS_MAX);
    }
    size_t voxels = 1;
    murk_status status = murk_grid_check_size(size, &voxels, path, err);
    if (!status && !murk_affine_invert(index_to_world, &inverse)) {
        status = murk_fail(err, MURK_BAD_VALUE, path,
                           "index_to_world is singular or not finite");
    }
    for (size_t i = 0; i < n && !status; ++i) {
        status = check_field(fields, i, voxels, path, err);
    }
    return status;
}

/* Number of nodes with the given edge that cover a box of size[] voxels. */
static uint64_t nodes(const size_t size[3], size_t edge)
{
    uint64_t n = 1;
    for (int axis = 0; axis < 3; ++axis) {
        n *= (size[axis] + edge - 1) / edge;
    }
    return n;
}

static murk_status send_bytes(void *context, const void *bytes, size_t size)
{
    return murk_subprocess_send(((job *)context)->subprocess, bytes, size);
}

static murk_status write_in_subprocess(murk_subprocess *subprocess,
                                       void *context, murk_error *err)
{
    job *j = context;
    j->subprocess = subprocess;
    return murk_vdb_now()->write(j->field, j->n, j->size, j->index_to_world,
                                 send_bytes, j, j->where, err);
}

/* The notes of a field end with NULL. */
static size_t count_notes(const murk_vdb_field *field)
{
    size_t n = 0;
    while (field->notes && field->notes[n]) {
        ++n;
    }
    return n;
}

static void pack(murk_parcel *to, const void *context)
{
    const job *j = context;
    const size_t voxels = j->size[0] * j->size[1] * j->size[2];
    murk_parcel_put_text(to, j->where);
    murk_parcel_put(to, j->size, 3 * sizeof *j->size);
    murk_parcel_put(to, j->index_to_world, sizeof j->index_to_world);
    murk_parcel_put(to, &j->n, sizeof j->n);
    for (size_t i = 0; i < j->n; ++i) {
        const murk_vdb_field *field = &j->field[i];
        const size_t notes = count_notes(field);
        murk_parcel_put_text(to, field->name);
        murk_parcel_put(to, field->value, voxels * sizeof *field->value);
        murk_parcel_put(to, &notes, sizeof notes);
        for (size_t k = 0; k < notes; ++k) {
            murk_parcel_put_text(to, field->notes[k]);
        }
    }
}

/* Takes the field that pack() put; *notes is released by the caller. */
static void take_field(murk_vdb_field *field, const char ***notes,
                       murk_parcel *from)
{
    field->name = murk_parcel_take_text(from);
    field->value = murk_parcel_take(from, 0);
    const size_t *n = murk_parcel_take(from, sizeof *n);
    *notes = n ? calloc(*n + 1, sizeof **notes) : NULL;
    from->is_short |= !*notes;
    for (size_t k = 0; *notes && k < *n; ++k) {
        (*notes)[k] = murk_parcel_take_text(from);
    }
    field->notes = *notes;
}

static murk_status write_packed(murk_subprocess *subprocess, murk_parcel *from,
                                murk_error *err)
{
    job j = {0};
    const char **notes[MURK_GRID_FIELDS_MAX] = {0};
    j.where = murk_parcel_take_text(from);
    j.size = murk_parcel_take(from, 3 * sizeof *j.size);
    const double *rows = murk_parcel_take(from, sizeof j.index_to_world);
    const size_t *n = murk_parcel_take(from, sizeof *n);
    for (; n && j.n < *n && j.n < MURK_GRID_FIELDS_MAX; ++j.n) {
        take_field(&j.field[j.n], &notes[j.n], from);
    }
    murk_status status = MURK_OK;
    if (from->is_short || !rows || !j.where) {
        status = murk_fail(err, MURK_RUN_FAILED, "", "malformed request");
    } else {
        memcpy(j.index_to_world, rows, sizeof j.index_to_world);
        status = write_in_subprocess(subprocess, &j, err);
    }
    for (size_t i = 0; i < j.n; ++i) {
        free(notes[i]);
    }
    return status;
}

const murk_subprocess_job murk_grid_write_job = {.name = "write",
                                                 .prepare = murk_vdb_prepare,
                                                 .work = write_in_subprocess,
                                                 .pack = pack,
                                                 .work_packed = write_packed};

/* Position of the identifier in an OpenVDB file: behind 8 bytes of magic,
 * three 32-bit versions (file, library major and minor) and one byte that
 * says whether grids can be found by offset (openvdb/io/Archive.cc). */
#define ID_AT    21
#define ID_BYTES 36 /* a UUID in text: 8-4-4-4-12 digits */

static bool is_id(const unsigned char *text)
{
    for (int i = 0; i < ID_BYTES; ++i) {
        const bool is_dash = i == 8 || i == 13 || i == 18 || i == 23;
        if (is_dash ? text[i] != '-' : !isxdigit(text[i])) {
            return false;
        }
    }
    return true;
}

/* OpenVDB draws the identifier at random. The function replaces the identifier
 * by a UUID of version 8 (RFC 9562), whose digits are, but for version and
 * variant, those of the SHA-256 of the file with zeros for the identifier, so
 * that the same fields give the same file. False if there is no identifier at
 * ID_AT. */
static bool derive_id(unsigned char *bytes, size_t n)
{
    if (n < ID_AT + ID_BYTES || !is_id(bytes + ID_AT)) {
        return false;
    }
    char *id = (char *)bytes + ID_AT;
    memset(id, '0',
           ID_BYTES); /* the random identifier must not enter the hash */
    char hash[65], text[ID_BYTES + 1];
    murk_sha256_hex(bytes, n, hash);
    hash[12] = '8'; /* version 8; the next line sets the variant, binary 10xx */
    hash[16] = "89ab"[strtoul((char[]){hash[16], '\0'}, NULL, 16) % 4];
    snprintf(text, sizeof text, "%.8s-%.4s-%.4s-%.4s-%.12s", hash, hash + 8,
             hash + 12, hash + 16, hash + 20);
    memcpy(id, text, ID_BYTES);
    return true;
}

murk_status murk_grid_write(const char *path, const murk_grid_field *fields,
                            size_t n, const size_t size[3],
                            const murk_affine *index_to_world, murk_error *err)
{
    murk_status status = check(path, fields, n, size, index_to_world, err);
    if (status) {
        return status;
    }
    job j = {.where = path, .n = n, .size = size};
    murk_affine_rows(index_to_world, j.index_to_world);
    for (size_t i = 0; i < n; ++i) {
        j.field[i] =
            (murk_vdb_field){fields[i].name, fields[i].value, fields[i].notes};
    }
    /* The limit of four times the memory of the trees is for the trees and
     * twice the bytes of the file, which are at most as large as the trees,
     * with a margin. */
    const uint64_t tree_bytes =
        n * (nodes(size, 8) * LEAF_BYTES + nodes(size, 128) * LOWER_BYTES +
             nodes(size, 4096) * UPPER_BYTES);
    const uint64_t values = (uint64_t)n * size[0] * size[1] * size[2];
    const murk_subprocess_limits limits = {
        .memory_bytes = MIN_BYTES + 4 * tree_bytes,
        .handed_bytes = MIN_BYTES + tree_bytes,
        .seconds = MIN_SECONDS + (unsigned)(values / VOXELS_PER_SECOND)};
    /* Build the bytes in a subprocess. */
    unsigned char *bytes = NULL;
    size_t n_bytes = 0;
    murk_error failure = {0};
    status = murk_subprocess_do(&bytes, &n_bytes, &murk_grid_write_job, &j,
                                &limits, path, &failure);
    if (status) { /* no file of the user was read, so the failure is one of the
                     run */
        status = status == MURK_BAD_FILE ? MURK_RUN_FAILED : status;
        return murk_fail(err, status, path, "cannot write: %s", failure.text);
    }
    status = derive_id(bytes, n_bytes)
                 ? murk_file_write(path, bytes, n_bytes, err)
                 : murk_fail(err, MURK_RUN_FAILED, path,
                             "cannot write: OpenVDB's header has no identifier "
                             "where this program expects it");
    free(bytes);
    return status;
}
