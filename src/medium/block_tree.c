/* Builds the tree over the blocks of a rectilinear grid
 * (medium/block_tree.h): the blocks of a node are sorted by their middles along
 * the longest side of the node, and each half becomes a node. */
#include "medium/block_tree.h"

#include <stdlib.h>

/* A block while the tree is built. */
typedef struct entry {
    double key; /* twice the middle along the axis of the sort */
    uint32_t number;
    const murk_box *box;
} entry;

static int by_key(const void *a, const void *b)
{
    const entry *x = a, *y = b;
    if (x->key < y->key || x->key > y->key) {
        return x->key < y->key ? -1 : 1;
    }
    return (x->number > y->number) - (x->number < y->number);
}

static murk_box box_of(const entry *all, size_t n)
{
    murk_box box = murk_box_empty();
    for (size_t i = 0; i < n; ++i) {
        box = murk_box_with(box, all[i].box->min);
        box = murk_box_with(box, all[i].box->max);
    }
    return box;
}

static int longest_axis(const murk_box *box)
{
    const murk_vec3 size = murk_sub(box->max, box->min);
    const int axis = size.y > size.x ? 1 : 0;
    return size.z > murk_component(size, axis) ? 2 : axis;
}

/* Fills node `at` with the entries [first, first + n). *used nodes are taken.
 */
static void build(murk_block_node *node, size_t at, size_t *used, entry *all,
                  size_t first, size_t n)
{
    entry *own = all + first;
    node[at].box = box_of(own, n);
    if (n <= MURK_BLOCK_LEAF_MAX) {
        node[at].first = (uint32_t)first;
        node[at].n = (uint32_t)n;
        return;
    }
    const int axis = longest_axis(&node[at].box);
    for (size_t i = 0; i < n; ++i) {
        own[i].key = murk_component(own[i].box->min, axis) +
                     murk_component(own[i].box->max, axis);
    }
    qsort(own, n, sizeof *own, by_key);
    /* Two nodes, each with one half. */
    const size_t children = *used, half = n / 2;
    *used += 2;
    node[at].first = (uint32_t)children;
    node[at].n = 0;
    build(node, children, used, all, first, half);
    build(node, children + 1, used, all, first + half, n - half);
}

bool murk_block_tree_build(murk_block_tree *out, size_t n,
                           const murk_box *(*box)(const void *context,
                                                  size_t i),
                           const void *context)
{
    /* A tree with at most n leaves has fewer than 2 n nodes. */
    murk_block_tree tree = {.node = calloc(2 * n, sizeof *tree.node),
                            .order = calloc(n, sizeof *tree.order)};
    entry *all = calloc(n, sizeof *all);
    const bool has_memory = tree.node && tree.order && all;
    if (has_memory) {
        size_t used = 1;
        for (size_t i = 0; i < n; ++i) {
            all[i] = (entry){.number = (uint32_t)i, .box = box(context, i)};
        }
        build(tree.node, 0, &used, all, 0, n);
        for (size_t i = 0; i < n; ++i) {
            tree.order[i] = all[i].number;
        }
        *out = tree;
    } else {
        murk_block_tree_release(&tree);
    }
    free(all);
    return has_memory;
}

void murk_block_tree_release(murk_block_tree *tree)
{
    free(tree->node);
    free(tree->order);
    *tree = (murk_block_tree){0};
}
