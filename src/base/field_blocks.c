/* Packs fields on rectilinear grids (base/field_blocks.h): sizes, edges and
 * values of all blocks follow each other, so that the receiver can check them
 * before use. */
#include "base/field_blocks.h"

#include <math.h>
#include <stdlib.h>

/* Edges in files are rounded to five or six digits: a share of a cell. */
#define OVERLAP_MAX 1e-3

uint64_t murk_field_values(const murk_field_size *size)
{
    const uint64_t more = size->has_nodes ? 1 : 0;
    return (size->cells[0] + more) * (size->cells[1] + more) *
           (size->cells[2] + more);
}

bool murk_field_overlap(const double *a, size_t a_cells, const double *b,
                        size_t b_cells)
{
    const double low = fmax(a[0], b[0]), high = fmin(a[a_cells], b[b_cells]);
    return high - low > OVERLAP_MAX * fmin(a[1] - a[0], b[1] - b[0]);
}

static murk_field_size size_of(const murk_field_block *b)
{
    return (murk_field_size){.cells = {b->cells[0], b->cells[1], b->cells[2]},
                             .has_nodes = b->has_nodes};
}

murk_status murk_field_send(murk_subprocess *to, const murk_field_head *head,
                            const murk_field_block *block, size_t n)
{
    const uint64_t blocks = n;
    murk_status status = murk_subprocess_send(to, head, sizeof *head);
    if (!status) {
        status = murk_subprocess_send(to, &blocks, sizeof blocks);
    }
    /* Sizes, edges and values, each of all blocks. */
    for (size_t i = 0; i < n && !status; ++i) {
        const murk_field_size size = size_of(&block[i]);
        status = murk_subprocess_send(to, &size, sizeof size);
    }
    for (size_t i = 0; i < 3 * n && !status; ++i) {
        const murk_field_block *b = &block[i / 3];
        status = murk_subprocess_send(to, b->edge[i % 3],
                                      (b->cells[i % 3] + 1) * sizeof(double));
    }
    for (size_t i = 0; i < n && !status; ++i) {
        const murk_field_size size = size_of(&block[i]);
        status = murk_subprocess_send(to, block[i].value,
                                      murk_field_values(&size) *
                                          sizeof *block[i].value);
    }
    return status;
}

void murk_field_blocks_destroy(murk_field_block *block, size_t n)
{
    for (size_t i = 0; block && i < n; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            free(block[i].edge[axis]);
        }
        free(block[i].value);
    }
    free(block);
}
