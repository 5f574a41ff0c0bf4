/* Where the stored rows of a coverage matrix lie: in memory up to a limit, and
 * beyond the limit in a scratch file (base/scratch_file.h), whose pages come
 * into memory when a row is read. Which rows lie in the file depends on the
 * order in which threads store them; their content does not. */
#ifndef MURK_PLACEMENT_ROW_SPACE_H
#define MURK_PLACEMENT_ROW_SPACE_H

#include "base/scratch_file.h"
#include "base/tally.h"
#include "placement/row.h"

typedef struct murk_row_space {
    int64_t memory_max; /* bytes of rows in memory */
    int64_t window_max; /* bytes of the file that are kept in memory */
    murk_tally memory;  /* bytes of rows in memory */
    murk_tally in_file; /* bytes of rows in the file */
    murk_tally window;  /* bytes of pages that were read from the file since all
                           were last evicted, at most */
    _Atomic uintptr_t last;  /* number of the last piece of the file that was
                                read (MURK_ROW_SPACE_PIECE) */
    murk_scratch_file *file; /* NULL: all rows lie in memory */
    murk_error error;        /* the reason why there is no file */
} murk_row_space;

/* Rows of `bytes_max` bytes altogether may be stored, and may take memory_bytes
 * of memory. If `bytes_max` is larger, a quarter of the memory, or 16 MiB if
 * that is more, is for pages of the file. Without a file, for example in a
 * folder that cannot be written to, rows beyond the memory are refused. */
void murk_row_space_init(murk_row_space *out, uint64_t bytes_max,
                         uint64_t memory_bytes);
void murk_row_space_release(murk_row_space *space);

/* Takes over the memory of a stored row; row->is_in_file tells where the row
 * lies then. False if the row can be kept neither in memory nor in the file:
 * murk_row_space_check() then fails. May be called from any thread. */
bool murk_row_space_keep(murk_row_space *space, murk_row *row);

/* Fails with MURK_RUN_FAILED if a row was refused. */
murk_status murk_row_space_check(const murk_row_space *space, murk_error *err);

/* True if all rows can be stored once more before they are freed. */
bool murk_row_space_holds_twice(const murk_row_space *space);

/* Frees a row. May be called from any thread. */
void murk_row_space_drop(murk_row_space *space, murk_row *row);

/* The bytes of all rows that are kept. */
static inline uint64_t murk_row_space_bytes(const murk_row_space *space)
{
    return (uint64_t)(murk_tally_read(&space->memory) +
                      murk_tally_read(&space->in_file));
}

/* Linux brings pages into memory in aligned pieces of up to so many bytes
 * (fault-around). */
#define MURK_ROW_SPACE_PIECE 65536

/* To be called before a row is read: keeps the pages of the file that lie in
 * memory below the limit. Pieces count when they are read, but a piece counts
 * once if one row after the other reads it. May be called from any thread. */
static inline void murk_row_space_read(murk_row_space *space,
                                       const murk_row *row)
{
    if (row->is_in_file) {
        const uintptr_t first = (uintptr_t)row->memory / MURK_ROW_SPACE_PIECE;
        const uintptr_t end =
            ((uintptr_t)row->memory + row->memory_bytes) / MURK_ROW_SPACE_PIECE;
        const uintptr_t last =
            atomic_exchange_explicit(&space->last, end, memory_order_relaxed);
        const int64_t bytes =
            (int64_t)(end - first + (first != last)) * MURK_ROW_SPACE_PIECE;
        const int64_t before = atomic_fetch_add_explicit(&space->window, bytes,
                                                         memory_order_relaxed);
        if (before + bytes > space->window_max) {
            atomic_store_explicit(&space->window, bytes, memory_order_relaxed);
            murk_scratch_file_evict(space->file);
        }
    }
}

#endif
