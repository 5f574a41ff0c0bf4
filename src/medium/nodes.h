/* Access to the nodes below the root of a NanoVDB float tree from C: short
 * names for functions of PNanoVDB.h. For use inside src/medium only. */
#ifndef MURK_MEDIUM_NODES_H
#define MURK_MEDIUM_NODES_H

#define PNANOVDB_C
#include <nanovdb/PNanoVDB.h>

#include <stddef.h>
#include <stdint.h>

/* Either a child node, or (child NULL) one value for the whole cell. */
typedef struct murk_cell {
    const unsigned char *child;
    float value;
} murk_cell;

/* PNanoVDB.h addresses bytes from the start of a buffer. With a node as the
 * start, the address of that node is 0. */
static inline pnanovdb_buf_t murk_node_buffer(const unsigned char *node)
{
    return pnanovdb_make_buf((uint32_t *)(uintptr_t)node, 0);
}

/* The cell at an entry of the table of a node. The entry holds the offset of
 * the child from the node, or the value. */
static inline murk_cell murk_table_cell(const unsigned char *node,
                                        pnanovdb_address_t entry, bool is_child)
{
    const pnanovdb_buf_t buffer = murk_node_buffer(node);
    return is_child ? (murk_cell){node + pnanovdb_read_int64(buffer, entry), 0}
                    : (murk_cell){NULL, pnanovdb_read_float(buffer, entry)};
}

/* The cell of an upper node that contains the voxel: 128 voxels along an
 * edge. */
static inline murk_cell murk_upper_cell(const unsigned char *node,
                                        const int32_t voxel[3])
{
    const pnanovdb_buf_t buffer = murk_node_buffer(node);
    const pnanovdb_upper_handle_t upper = {{0}};
    const pnanovdb_coord_t at = {voxel[0], voxel[1], voxel[2]};
    const uint32_t n = pnanovdb_upper_coord_to_offset(&at);
    return murk_table_cell(node,
                           pnanovdb_upper_get_table_address(
                               PNANOVDB_GRID_TYPE_FLOAT, buffer, upper, n),
                           pnanovdb_upper_get_child_mask(buffer, upper, n));
}

/* The cell of a lower node that contains the voxel: 8 voxels along an edge. */
static inline murk_cell murk_lower_cell(const unsigned char *node,
                                        const int32_t voxel[3])
{
    const pnanovdb_buf_t buffer = murk_node_buffer(node);
    const pnanovdb_lower_handle_t lower = {{0}};
    const pnanovdb_coord_t at = {voxel[0], voxel[1], voxel[2]};
    const uint32_t n = pnanovdb_lower_coord_to_offset(&at);
    return murk_table_cell(node,
                           pnanovdb_lower_get_table_address(
                               PNANOVDB_GRID_TYPE_FLOAT, buffer, lower, n),
                           pnanovdb_lower_get_child_mask(buffer, lower, n));
}

/* The 512 values of a leaf; voxel (i, j, k) is at (i & 7) * 64 + (j & 7) * 8
 * + (k & 7). */
static inline const float *murk_leaf_values(const unsigned char *node)
{
    const pnanovdb_leaf_handle_t leaf = {{0}};
    const pnanovdb_address_t first = pnanovdb_leaf_get_table_address(
        PNANOVDB_GRID_TYPE_FLOAT, murk_node_buffer(node), leaf, 0);
    return (const float *)(const void *)(node + first.byte_offset);
}

#endif
