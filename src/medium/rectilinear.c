/* Fields on rectilinear grids: packed form, value at a point, differences. */
#include "medium/rectilinear.h"

#include "base/interval.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Cells along an edge of the boxes in which differences are listed. */
#define CHANGED_EDGE 8

/* ---- opening ---- */

static murk_status malformed(const char *where, murk_error *err)
{
    return murk_fail(err, MURK_BAD_FILE, where,
                     "malformed: its reader handed over no field");
}

/* True if the size of a block is in range. */
static bool is_size(const murk_field_size *size)
{
    bool is_good = size->has_nodes <= 1;
    for (int axis = 0; axis < 3; ++axis) {
        is_good = is_good && size->cells[axis] >= 1 &&
                  size->cells[axis] <= MURK_FIELD_CELLS_MAX;
    }
    return is_good;
}

/* Sets the pointers of all blocks; false if the bytes are too few or too
 * many. */
static bool find_parts(murk_rectilinear *field, const murk_field_size *size,
                       const unsigned char *parts, uint64_t left)
{
    for (size_t i = 0; i < field->n; ++i) {
        murk_rectilinear_block *block = &field->block[i];
        if (!is_size(&size[i])) {
            return false;
        }
        block->has_nodes = size[i].has_nodes != 0;
        for (int axis = 0; axis < 3; ++axis) {
            block->cells[axis] = size[i].cells[axis];
            const uint64_t bytes = (size[i].cells[axis] + 1) * sizeof(double);
            if (bytes > left) {
                return false;
            }
            block->edge[axis] = (const double *)(const void *)parts;
            parts += bytes;
            left -= bytes;
        }
    }
    /* The values of all blocks. */
    for (size_t i = 0; i < field->n; ++i) {
        const uint64_t values = murk_field_values(&size[i]);
        if (values > left / sizeof(float)) {
            return false;
        }
        field->block[i].value = (const float *)(const void *)parts;
        field->n_values += values;
        parts += values * sizeof(float);
        left -= values * sizeof(float);
    }
    return left == 0;
}

/* Checks the edges of a block, and computes its box and smallest cells. */
static bool measure_edges(murk_rectilinear *field,
                          murk_rectilinear_block *block)
{
    double low[3], high[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double *edge = block->edge[axis];
        const size_t n = block->cells[axis];
        low[axis] = edge[0];
        high[axis] = edge[n];
        bool rises = isfinite(edge[0]) && isfinite(edge[n]);
        for (size_t i = 0; i < n && rises; ++i) {
            const double length = edge[i + 1] - edge[i];
            rises = length > 0;
            field->smallest[axis] = fmin(field->smallest[axis], length);
        }
        if (!rises) {
            return false;
        }
    }
    block->box = (murk_box){murk_vec(low[0], low[1], low[2]),
                            murk_vec(high[0], high[1], high[2])};
    field->box = murk_box_with(field->box, block->box.min);
    field->box = murk_box_with(field->box, block->box.max);
    return true;
}

/* Checks all values and computes their minimum, maximum and sum. */
static bool measure_values(murk_rectilinear *field)
{
    const float *value = field->block[0].value;
    bool are_good = true;
    field->minimum = INFINITY;
    for (uint64_t i = 0; i < field->n_values; ++i) {
        const double v = (double)value[i];
        are_good = are_good && v >= 0 && v <= DBL_MAX;
        field->minimum = fmin(field->minimum, v);
        field->maximum = fmax(field->maximum, v);
        field->sum += v;
    }
    return are_good;
}

static bool do_overlap(const murk_rectilinear_block *a,
                       const murk_rectilinear_block *b)
{
    bool overlap = true;
    for (int axis = 0; axis < 3 && overlap; ++axis) {
        overlap = murk_field_overlap(a->edge[axis], a->cells[axis],
                                     b->edge[axis], b->cells[axis]);
    }
    return overlap;
}

static bool have_overlap(const murk_rectilinear *field)
{
    bool found = false;
    for (size_t i = 0; i < field->n && !found; ++i) {
        for (size_t k = 0; k < i && !found; ++k) {
            found = do_overlap(&field->block[i], &field->block[k]);
        }
    }
    return found;
}

static const murk_box *box_of_block(const void *context, size_t i)
{
    const murk_rectilinear *field = context;
    return &field->block[i].box;
}

murk_status murk_rectilinear_open(murk_rectilinear *out,
                                  const unsigned char *bytes, size_t size,
                                  const char *where, murk_error *err)
{
    uint64_t n = 0;
    if (size >= sizeof n) {
        memcpy(&n, bytes, sizeof n);
    }
    if (n == 0 || n > MURK_RECTILINEAR_BLOCKS_MAX ||
        size - sizeof n < n * sizeof(murk_field_size)) {
        return malformed(where, err);
    }
    murk_rectilinear field = {
        .n = n,
        .block = calloc(n, sizeof *field.block),
        .box = murk_box_empty(),
        .smallest = {INFINITY, INFINITY, INFINITY},
    };
    if (!field.block) {
        return murk_no_memory(err, where, "for %zu blocks of a grid", field.n);
    }
    /* The parts of the blocks, then their edges and values. */
    const size_t sizes = n * sizeof(murk_field_size);
    const unsigned char *first = bytes + sizeof n;
    bool is_good = find_parts(&field, (const void *)first, first + sizes,
                              size - sizeof n - sizes);
    for (size_t i = 0; i < field.n && is_good; ++i) {
        is_good = measure_edges(&field, &field.block[i]);
    }
    if (!is_good || !measure_values(&field) || have_overlap(&field)) {
        murk_rectilinear_close(&field);
        return malformed(where, err);
    }
    if (!murk_block_tree_build(&field.tree, field.n, box_of_block, &field)) {
        murk_rectilinear_close(&field);
        return murk_no_memory(err, where, "for a tree of blocks");
    }
    *out = field;
    return MURK_OK;
}

void murk_rectilinear_close(murk_rectilinear *field)
{
    murk_block_tree_release(&field->tree);
    free(field->block);
    *field = (murk_rectilinear){0};
}

/* ---- points ---- */

/* The value of a block at a point inside of it. */
static double value_at(const murk_rectilinear_block *b, const double p[3])
{
    size_t cell[3];
    double share[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double *edge = b->edge[axis];
        const size_t i = murk_interval_of(edge, 1, b->cells[axis] + 1, p[axis]);
        const double s = (p[axis] - edge[i]) / (edge[i + 1] - edge[i]);
        cell[axis] = i;
        share[axis] = s > 0 ? (s < 1 ? s : 1) : 0;
    }
    if (!b->has_nodes) {
        return (double)
            b->value[(cell[2] * b->cells[1] + cell[1]) * b->cells[0] + cell[0]];
    }
    /* Trilinear: along x on four edges, along y on two faces, along z. */
    const size_t row = b->cells[0] + 1, sheet = row * (b->cells[1] + 1);
    const float *v = &b->value[cell[2] * sheet + cell[1] * row + cell[0]];
    double on_face[2];
    for (size_t k = 0; k < 2; ++k) {
        double on_edge[2];
        for (size_t j = 0; j < 2; ++j) {
            const float *low = &v[k * sheet + j * row];
            on_edge[j] =
                (double)low[0] + share[0] * ((double)low[1] - (double)low[0]);
        }
        on_face[k] = on_edge[0] + share[1] * (on_edge[1] - on_edge[0]);
    }
    return on_face[0] + share[2] * (on_face[1] - on_face[0]);
}

/* The block that holds a point, of several the first; field->n: none. */
static size_t block_at(const murk_rectilinear *field, murk_vec3 p)
{
    const murk_block_tree *tree = &field->tree;
    uint32_t waiting[MURK_BLOCK_STACK] = {0};
    size_t found = field->n;
    for (int n = 1; n > 0;) {
        const murk_block_node *node = &tree->node[waiting[--n]];
        if (!murk_box_holds(&node->box, p)) {
            continue;
        }
        for (uint32_t i = 0; i < node->n; ++i) {
            const size_t number = tree->order[node->first + i];
            if (number < found &&
                murk_box_holds(&field->block[number].box, p)) {
                found = number;
            }
        }
        if (node->n == 0) {
            waiting[n++] = node->first + 1;
            waiting[n++] = node->first;
        }
    }
    return found;
}

bool murk_rectilinear_density(const murk_rectilinear *field, murk_vec3 p,
                              double *density)
{
    if (!murk_box_holds(&field->box, p)) {
        return false;
    }
    const double at[3] = {p.x, p.y, p.z};
    const size_t number = block_at(field, p);
    *density = number < field->n ? value_at(&field->block[number], at) : 0;
    return true;
}

/* ---- differences ---- */

static bool have_same_edges(const murk_rectilinear *a,
                            const murk_rectilinear *b)
{
    bool are_same = a->n == b->n;
    for (size_t i = 0; i < a->n && are_same; ++i) {
        const murk_rectilinear_block *p = &a->block[i], *q = &b->block[i];
        are_same = p->has_nodes == q->has_nodes &&
                   memcmp(p->cells, q->cells, sizeof p->cells) == 0;
        for (int axis = 0; axis < 3 && are_same; ++axis) {
            are_same = memcmp(p->edge[axis], q->edge[axis],
                              (p->cells[axis] + 1) * sizeof(double)) == 0;
        }
    }
    return are_same;
}

/* True if the values of the cells first[] to last[], both included, differ. */
static bool differ_in(const murk_rectilinear_block *a,
                      const murk_rectilinear_block *b, const size_t first[3],
                      const size_t last[3])
{
    const size_t more = a->has_nodes ? 1 : 0;
    const size_t row = a->cells[0] + more, sheet = row * (a->cells[1] + more);
    bool differ = false;
    for (size_t k = first[2]; k <= last[2] + more && !differ; ++k) {
        for (size_t j = first[1]; j <= last[1] + more && !differ; ++j) {
            const size_t at = k * sheet + j * row + first[0];
            differ =
                memcmp(&a->value[at], &b->value[at],
                       (last[0] + more - first[0] + 1) * sizeof *a->value) != 0;
        }
    }
    return differ;
}

static void add_changes(murk_box_list *changed, const murk_rectilinear_block *a,
                        const murk_rectilinear_block *b)
{
    const size_t *n = a->cells;
    size_t first[3], last[3];
    for (first[2] = 0; first[2] < n[2]; first[2] += CHANGED_EDGE) {
        for (first[1] = 0; first[1] < n[1]; first[1] += CHANGED_EDGE) {
            for (first[0] = 0; first[0] < n[0]; first[0] += CHANGED_EDGE) {
                double low[3], high[3];
                for (int axis = 0; axis < 3; ++axis) {
                    const size_t end = first[axis] + CHANGED_EDGE;
                    last[axis] = (end < n[axis] ? end : n[axis]) - 1;
                    low[axis] = a->edge[axis][first[axis]];
                    high[axis] = a->edge[axis][last[axis] + 1];
                }
                if (differ_in(a, b, first, last)) {
                    murk_box_list_add(
                        changed,
                        (murk_box){murk_vec(low[0], low[1], low[2]),
                                   murk_vec(high[0], high[1], high[2])});
                }
            }
        }
    }
}

void murk_rectilinear_changes(murk_box_list *changed, const murk_rectilinear *a,
                              const murk_rectilinear *b)
{
    if (!have_same_edges(a, b)) {
        changed->are_all = true;
        return;
    }
    for (size_t i = 0; i < a->n; ++i) {
        add_changes(changed, &a->block[i], &b->block[i]);
    }
}
