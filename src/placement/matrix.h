/* What the rest of the room knows of a matrix. */
#ifndef MURK_PLACEMENT_MATRIX_H
#define MURK_PLACEMENT_MATRIX_H

#include "placement/row.h"

struct murk_matrix {
    murk_layout layout;
    size_t candidates;
    murk_row *row; /* [candidates] */
    bool borrows_rows;
    bool all_clear; /* every row is BITS or CLEAR_LIST */
    uint64_t pairs;
    size_t memory_bytes;
};

#endif
