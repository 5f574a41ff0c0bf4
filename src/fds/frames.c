/* Reads frames of .s3d and .sf files (fds/frames.h). All sizes in the files are
 * checked against the file before they are used. */
#include "fds/frames.h"

#include "base/field_blocks.h"
#include "base/inputs.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define LABEL_BYTES 30       /* dump.f90 */
#define FRAMES_MAX  10000000 /* a choice: more than runs have */

static murk_status bad(const murk_fds_frames *f, const char *problem,
                       murk_error *err)
{
    return murk_fail(err, MURK_BAD_FILE, f->where, "%s", problem);
}

/* ---- the beginning of a file ---- */

static bool read_header(murk_fds_frames *f)
{
    if (f->is_smoke3d) {
        int32_t words[8];
        const bool is_read = murk_fds_record_words(&f->records, words, 8);
        memcpy(f->nodes, &words[2], sizeof f->nodes);
        return is_read;
    }
    bool is_good = true;
    for (int label = 0; label < 3 && is_good; ++label) {
        uint64_t size = 0;
        is_good =
            murk_fds_record_skip(&f->records, &size) && size == LABEL_BYTES;
    }
    return is_good && murk_fds_record_words(&f->records, f->nodes, 6);
}

/* Computes the number of values of a frame; false if the nodes are out of
 * order or too many. */
static bool count_values(murk_fds_frames *f)
{
    f->values = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const int64_t low = f->nodes[2 * axis], high = f->nodes[2 * axis + 1];
        if (low < 0 || high < low || high > MURK_FIELD_CELLS_MAX) {
            return false;
        }
        f->values *= (uint64_t)(high - low + 1);
        if (f->values > MURK_FIELD_VALUES_MAX) {
            return false;
        }
    }
    return true;
}

/* ---- frames ---- */

/* Skips the records of a frame after the time; false if they are not whole. */
static bool skip_frame(murk_fds_frames *f)
{
    uint64_t size = 0;
    if (f->is_smoke3d) {
        uint32_t bytes[2];
        return murk_fds_record_words(&f->records, bytes, 2) &&
               murk_fds_record_skip(&f->records, &size) && size == bytes[1];
    }
    return murk_fds_record_skip(&f->records, &size) && size == 4 * f->values;
}

static bool add_frame(murk_fds_frames *f, size_t *capacity, float time_s,
                      int64_t offset)
{
    if (f->n == *capacity) {
        const size_t more = *capacity ? 2 * *capacity : 64;
        double *times = realloc(f->time_s, more * sizeof *times);
        if (!times) {
            return false;
        }
        f->time_s = times;
        int64_t *offsets = realloc(f->offset, more * sizeof *offsets);
        if (!offsets) {
            return false;
        }
        f->offset = offsets;
        *capacity = more;
    }
    f->time_s[f->n] = (double)time_s;
    f->offset[f->n++] = offset;
    return true;
}

/* Finds all frames. A run that was restarted may repeat times: a frame that is
 * not later than the one before is refused, because it is not clear which of
 * them is meant. */
static murk_status find_frames(murk_fds_frames *f, murk_error *err)
{
    size_t capacity = 0;
    float time_s;
    while (f->n < FRAMES_MAX &&
           murk_fds_record_words(&f->records, &time_s, 1)) {
        const off_t at = ftello(f->file);
        if (at < 0 || !skip_frame(f)) {
            if (!f->records.is_cut) {
                return bad(f, "has a frame that is malformed", err);
            }
            break;
        }
        if (!isfinite(time_s) ||
            (f->n > 0 && (double)time_s <= f->time_s[f->n - 1])) {
            return bad(f, "has a frame that is not later than the one before",
                       err);
        }
        if (!add_frame(f, &capacity, time_s, at)) {
            return murk_no_memory(err, f->where, "for its frames");
        }
    }
    return f->n > 0 ? MURK_OK : bad(f, "has no whole frame", err);
}

murk_status murk_fds_frames_open(murk_fds_frames *out, const char *path,
                                 bool is_smoke3d, const char *where,
                                 murk_error *err)
{
    murk_fds_frames *f = out;
    *f = (murk_fds_frames){.is_smoke3d = is_smoke3d, .where = where};
    f->file = murk_inputs_open(path);
    struct stat facts;
    if (!f->file || fstat(fileno(f->file), &facts) != 0) {
        return bad(f, strerror(errno), err);
    }
    if (!S_ISREG(facts.st_mode)) {
        return bad(f, "is not a regular file", err);
    }
    /* The first length of both kinds of file is known. */
    f->records =
        (murk_fds_records){.file = f->file, .bytes = (uint64_t)facts.st_size};
    if (!murk_fds_records_begin(&f->records, is_smoke3d ? 32 : LABEL_BYTES) ||
        !read_header(f) || !count_values(f)) {
        return bad(f,
                   is_smoke3d ? "does not begin as a .s3d file of FDS"
                              : "does not begin as a slice file of FDS",
                   err);
    }
    return find_frames(f, err);
}

void murk_fds_frames_close(murk_fds_frames *f)
{
    if (f->file) {
        fclose(f->file);
    }
    free(f->time_s);
    free(f->offset);
    *f = (murk_fds_frames){0};
}

/* Expands run-length coded bytes to exactly `values` numbers. */
static bool expand(const unsigned char *bytes, size_t n, float *out,
                   uint64_t values)
{
    uint64_t at = 0;
    size_t i = 0;
    while (i < n) {
        const bool is_run = bytes[i] == 255;
        if (is_run && n - i < 3) {
            return false;
        }
        const unsigned char value = is_run ? bytes[i + 1] : bytes[i];
        const uint64_t times = is_run ? bytes[i + 2] : 1;
        if (times > values - at) {
            return false;
        }
        for (uint64_t k = 0; k < times; ++k) {
            out[at++] = value;
        }
        i += is_run ? 3 : 1;
    }
    return at == values;
}

static murk_status read_bytes(murk_fds_frames *f, float *out, murk_error *err)
{
    uint32_t sizes[2];
    if (!murk_fds_record_words(&f->records, sizes, 2)) {
        return bad(f, "cannot be read", err);
    }
    unsigned char *bytes = malloc((size_t)sizes[1] + 1);
    if (!bytes) {
        return murk_no_memory(err, f->where, "for a frame");
    }
    const bool is_good = murk_fds_record_bytes(&f->records, bytes, sizes[1]) &&
                         sizes[0] == f->values &&
                         expand(bytes, sizes[1], out, f->values);
    free(bytes);
    return is_good ? MURK_OK
                   : bad(f, "has a frame with too few or too many values", err);
}

murk_status murk_fds_frames_read(murk_fds_frames *frames, size_t frame,
                                 float *out, murk_error *err)
{
    murk_fds_frames *f = frames;
    if (fseeko(f->file, (off_t)f->offset[frame], SEEK_SET) != 0) {
        return bad(f, "cannot be read", err);
    }
    if (f->is_smoke3d) {
        return read_bytes(f, out, err);
    }
    return murk_fds_record_words(&f->records, out, f->values)
               ? MURK_OK
               : bad(f, "cannot be read", err);
}
