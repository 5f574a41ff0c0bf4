/* Reads a NanoVDB float tree: a sorted table of root cells for binary
 * search, and descent to leaves by PNanoVDB.h. */
#include "medium/tree.h"

#include "medium/nodes.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

/* First voxel of a root cell along an axis. A root key packs the three cell
 * numbers, x highest, 21 bits each. */
static int32_t key_first(uint64_t key, int axis)
{
    const uint32_t number = (uint32_t)(key >> (21 * (2 - axis)));
    return (int32_t)(number << 12);
}

static int compare_cells(const void *a, const void *b)
{
    const murk_root_cell *p = a, *q = b;
    for (int axis = 0; axis < 3; ++axis) {
        if (p->first[axis] != q->first[axis]) {
            return p->first[axis] < q->first[axis] ? -1 : 1;
        }
    }
    return 0;
}

static murk_root_cell read_cell(const unsigned char *buffer,
                                pnanovdb_buf_t words,
                                pnanovdb_root_handle_t root,
                                pnanovdb_root_tile_handle_t tile)
{
    murk_root_cell cell = {{0}, 0, NULL};
    const uint64_t key = pnanovdb_root_tile_get_key(words, tile);
    for (int axis = 0; axis < 3; ++axis) {
        cell.first[axis] = key_first(key, axis);
    }
    const int64_t child = pnanovdb_root_tile_get_child(words, tile);
    if (child != 0) {
        cell.node = buffer + root.address.byte_offset + child;
    } else {
        cell.value = pnanovdb_read_float(
            words, pnanovdb_root_tile_get_value_address(
                       PNANOVDB_GRID_TYPE_FLOAT, words, tile));
    }
    return cell;
}

murk_status murk_tree_open(murk_tree *tree, const unsigned char *buffer,
                           const int64_t first[3], const int64_t last[3],
                           float elsewhere, const char *where, murk_error *err)
{
    murk_tree opened = {.elsewhere = elsewhere};
    if (buffer) {
        /* The table of root cells; cells that are constant, with the value
         * elsewhere, are left out. */
        const pnanovdb_buf_t words = murk_node_buffer(buffer);
        const pnanovdb_grid_handle_t grid = {{0}};
        const pnanovdb_root_handle_t root =
            pnanovdb_tree_get_root(words, pnanovdb_grid_get_tree(words, grid));
        const uint32_t n = pnanovdb_root_get_tile_count(words, root);
        opened.cells = calloc(n + (size_t)1, sizeof *opened.cells);
        if (!opened.cells) {
            return murk_no_memory(err, where, "for a grid's root");
        }
        for (uint32_t i = 0; i < n; ++i) {
            const murk_root_cell cell = read_cell(
                buffer, words, root,
                pnanovdb_root_get_tile(PNANOVDB_GRID_TYPE_FLOAT, root, i));
            if (cell.node || cell.value != elsewhere) {
                opened.cells[opened.n_cells++] = cell;
            }
        }
        qsort(opened.cells, opened.n_cells, sizeof *opened.cells,
              compare_cells);
    }
    /* The box of active voxels. */
    for (int axis = 0; axis < 3; ++axis) {
        assert(first[axis] >= -MURK_INDEX_MAX && last[axis] <= MURK_INDEX_MAX);
        opened.first[axis] = (int32_t)first[axis];
        opened.last[axis] = (int32_t)last[axis];
    }
    *tree = opened;
    return MURK_OK;
}

void murk_tree_close(murk_tree *tree)
{
    free(tree->cells);
    *tree = (murk_tree){0};
}

const murk_root_cell *murk_tree_root_cell(const murk_tree *tree,
                                          const int32_t voxel[3])
{
    murk_root_cell sought = {{0}, 0, NULL};
    for (int axis = 0; axis < 3; ++axis) {
        sought.first[axis] = voxel[axis] & ~(MURK_ROOT_CELL - 1);
    }
    return tree->n_cells > 0 ? bsearch(&sought, tree->cells, tree->n_cells,
                                       sizeof sought, compare_cells)
                             : NULL;
}

murk_tree_node murk_tree_node_at(murk_tree_cursor *cursor,
                                 const int32_t voxel[3])
{
    murk_tree_cursor *c = cursor;
    if (!(c->lower && murk_cell_contains(c->lower_first, voxel, 128))) {
        const murk_root_cell *root = murk_tree_root_cell(c->tree, voxel);
        if (!root || !root->node) {
            return (murk_tree_node){
                NULL, root ? root->value : c->tree->elsewhere, MURK_ROOT_CELL};
        }
        const murk_cell cell = murk_upper_cell(root->node, voxel);
        if (!cell.child) {
            return (murk_tree_node){NULL, cell.value, 128};
        }
        c->lower = cell.child;
        murk_cell_first(c->lower_first, voxel, 128);
    }
    const murk_cell cell = murk_lower_cell(c->lower, voxel);
    return cell.child ? (murk_tree_node){murk_leaf_values(cell.child), 0, 8}
                      : (murk_tree_node){NULL, cell.value, 8};
}

float murk_tree_value(const murk_tree *tree, const int32_t voxel[3])
{
    murk_tree_cursor cursor = {.tree = tree};
    const murk_tree_node node = murk_tree_node_at(&cursor, voxel);
    return node.leaf ? node.leaf[murk_offset_in_leaf(voxel)] : node.value;
}

void murk_tree_corners(const murk_tree *tree, const int32_t voxel[3],
                       double corner[8])
{
    murk_tree_cursor cursor = {.tree = tree};
    const murk_tree_node node = murk_tree_node_at(&cursor, voxel);
    const int offset = murk_offset_in_leaf(voxel);
    const bool is_inside =
        (voxel[0] & 7) != 7 && (voxel[1] & 7) != 7 &&
        (voxel[2] & 7) != 7; /* the cell is inside one leaf or tile */
    for (int which = 0; which < 8; ++which) {
        const int32_t at[3] = {voxel[0] + (which >> 2),
                               voxel[1] + (which >> 1 & 1),
                               voxel[2] + (which & 1)};
        float value = node.value;
        if (!is_inside) {
            value = murk_tree_value(tree, at);
        } else if (node.leaf) {
            value = node.leaf[offset + ((which & 4) << 4) + ((which & 2) << 2) +
                              (which & 1)];
        }
        corner[which] = (double)value;
    }
}

bool murk_tree_voxel_at(const murk_tree *tree, int32_t below, murk_vec3 p,
                        int32_t voxel[3], double in[3])
{
    const double place[3] = {p.x, p.y, p.z};
    for (int axis = 0; axis < 3; ++axis) {
        const double low = floor(place[axis]);
        if (!(low >= (double)tree->first[axis] - below &&
              low <= tree->last[axis])) {
            return false;
        }
        voxel[axis] = (int32_t)low;
        in[axis] = place[axis] - low;
    }
    return true;
}

bool murk_tree_density(const murk_tree *tree, murk_vec3 p, double *density)
{
    int32_t voxel[3];
    double in[3];
    if (!murk_tree_voxel_at(tree, 0, p, voxel, in)) {
        return false;
    }
    *density = (double)murk_tree_value(tree, voxel);
    return tree->n_cells > 0;
}
