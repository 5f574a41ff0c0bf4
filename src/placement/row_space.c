/* Stored rows in memory and in a scratch file (placement/row_space.h). A row
 * has all arrays in one block of memory, so a row that moves to the file keeps
 * its arrays at the same distances from the begin of the block. */
#include "placement/row_space.h"

#include <stdlib.h>

/* The share of the memory that is for pages of the file. With less than
 * WINDOW_MIN bytes of pages, evicting them takes longer than reading rows, so
 * this memory is used even if none is given (a choice). */
#define WINDOW_SHARE 4
#define WINDOW_MIN   (INT64_C(1) << 24)

void murk_row_space_init(murk_row_space *out, uint64_t bytes_max,
                         uint64_t memory_bytes)
{
    *out = (murk_row_space){0};
    if (memory_bytes > INT64_MAX) {
        memory_bytes = INT64_MAX;
    }
    out->memory_max = (int64_t)memory_bytes;
    if (bytes_max > memory_bytes) {
        const int64_t window = out->memory_max / WINDOW_SHARE;
        out->memory_max -= window;
        out->window_max = window > WINDOW_MIN ? window : WINDOW_MIN;
        /* Twice, because merging photons stores all rows once more. */
        const uint64_t twice =
            bytes_max < UINT64_MAX / 2 ? 2 * bytes_max : UINT64_MAX;
        if (murk_scratch_file_create(&out->file, twice, &out->error)) {
            out->file = NULL;
        }
    }
}

void murk_row_space_release(murk_row_space *space)
{
    murk_scratch_file_destroy(space->file);
    *space = (murk_row_space){0};
}

/* The place in the block `to` of an array that lies in the block `from`. */
static const void *moved(const void *array, const char *from, const char *to)
{
    return array ? to + ((const char *)array - from) : NULL;
}

/* Moves a row to a copy of its block. */
static void move(murk_row *row, void *to)
{
    const char *from = row->memory;
    row->bits = moved(row->bits, from, to);
    row->at = moved(row->at, from, to);
    row->segment_start = moved(row->segment_start, from, to);
    row->clarity = moved(row->clarity, from, to);
    row->slot = moved(row->slot, from, to);
    free(row->memory);
    row->memory = to;
}

bool murk_row_space_keep(murk_row_space *space, murk_row *row)
{
    const int64_t bytes = (int64_t)row->memory_bytes;
    /* In memory, if the row fits. */
    const int64_t before = atomic_fetch_add(&space->memory, bytes);
    if (before + bytes <= space->memory_max) {
        return true;
    }
    murk_tally_add(&space->memory, -bytes);
    murk_tally_add(&space->in_file, bytes);
    /* Else in the file. */
    void *mapped = space->file
                       ? murk_scratch_file_append(space->file, row->memory,
                                                  row->memory_bytes)
                       : NULL;
    if (!mapped) {
        free(row->memory);
        *row = (murk_row){0};
        return false;
    }
    move(row, mapped);
    row->is_in_file = true;
    return true;
}

murk_status murk_row_space_check(const murk_row_space *space, murk_error *err)
{
    const bool has_refused =
        !space->file && murk_tally_read(&space->in_file) > 0;
    return has_refused   ? murk_fail(err, MURK_RUN_FAILED, space->error.where,
                                     "%s", space->error.text)
           : space->file ? murk_scratch_file_check(space->file, err)
                         : MURK_OK;
}

bool murk_row_space_holds_twice(const murk_row_space *space)
{
    const double in_file = (double)murk_tally_read(&space->in_file);
    return in_file <= 0 || in_file <= murk_scratch_file_left(space->file);
}

void murk_row_space_drop(murk_row_space *space, murk_row *row)
{
    const int64_t bytes = (int64_t)row->memory_bytes;
    if (row->is_in_file) {
        murk_scratch_file_discard(space->file, row->memory, row->memory_bytes);
        murk_tally_add(&space->in_file, -bytes);
    } else if (row->memory) {
        free(row->memory);
        murk_tally_add(&space->memory, -bytes);
    }
    *row = (murk_row){0};
}
