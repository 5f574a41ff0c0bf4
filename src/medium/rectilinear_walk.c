/* Walk of a ray through a field on rectilinear grids, block by block and cell
 * by cell. The cell beyond a face is known by number, not by position, and each
 * block is entered once, so the walk cannot stall. */
#include "medium/rectilinear.h"

#include "base/interval.h"
#include "medium/clip.h"
#include "medium/grid_ray.h"

#include <float.h>
#include <math.h>

typedef murk_rectilinear_walk walk_state;

static murk_vec3 vector_of(const double v[3])
{
    return murk_vec(v[0], v[1], v[2]);
}

/* A search for the block that the ray enters next: the one of the smallest
 * parameter `at`, and of the lowest number where that is the same. */
typedef struct search {
    const walk_state *m;
    murk_vec3 origin, direction;
    size_t number; /* field->n: none so far */
    double at;
} search;

static void test_block(search *s, size_t i)
{
    const walk_state *m = s->m;
    double t0 = -INFINITY, t1 = m->end;
    murk_clip_box(&m->field->block[i].box, s->origin, s->direction, &t0, &t1);
    const bool is_later = m->latest == m->field->n || t0 > m->entered ||
                          (t0 == m->entered && i > m->latest);
    const bool is_first = t0 < s->at || (t0 == s->at && i < s->number);
    if (t0 < t1 && t1 > m->from && is_later && is_first) {
        s->number = i;
        s->at = t0;
    }
}

/* The parameter at which the ray enters a node; infinite if no block of the
 * node can be the next one. */
static double entry_of_node(const search *s, const murk_block_node *node)
{
    double t0 = -INFINITY, t1 = s->m->end;
    murk_clip_box(&node->box, s->origin, s->direction, &t0, &t1);
    return t0 >= t1 || t1 <= s->m->from || t0 > s->at ? INFINITY : t0;
}

/* Finds the block that the ray enters next: *number is field->n if there is
 * none, and *at the ray parameter at which the ray enters it. */
static void find_next_block(const walk_state *m, size_t *number, double *at)
{
    const murk_block_tree *tree = &m->field->tree;
    search s = {.m = m,
                .origin = vector_of(m->origin),
                .direction = vector_of(m->direction),
                .number = m->field->n,
                .at = INFINITY};
    uint32_t waiting[MURK_BLOCK_STACK] = {0};
    double entry[MURK_BLOCK_STACK] = {-INFINITY};
    for (int n = 1; n > 0;) {
        const murk_block_node *node = &tree->node[waiting[--n]];
        /* The best block so far may be nearer by now. */
        if (entry[n] > s.at) {
            continue;
        }
        for (uint32_t i = 0; i < node->n; ++i) {
            test_block(&s, tree->order[node->first + i]);
        }
        if (node->n > 0) {
            continue;
        }
        /* The nearer node comes last, so that it is looked at first. */
        const double low = entry_of_node(&s, &tree->node[node->first]);
        const double high = entry_of_node(&s, &tree->node[node->first + 1]);
        const uint32_t nearer = low <= high ? 0 : 1;
        if (fmax(low, high) < INFINITY) {
            entry[n] = fmax(low, high);
            waiting[n++] = node->first + 1 - nearer;
        }
        if (fmin(low, high) < INFINITY) {
            entry[n] = fmin(low, high);
            waiting[n++] = node->first + nearer;
        }
    }
    *number = s.number;
    *at = s.at;
}

/* Sets `to` to the face ahead by which the ray leaves the cell, at most to the
 * end of the walk. */
static void cross_cell(walk_state *m)
{
    m->to = m->end;
    m->exit_axis = -1;
    for (int axis = 0; axis < 3; ++axis) {
        if (m->inverse[axis] == 0) {
            continue;
        }
        const size_t ahead = m->cell[axis] + (m->inverse[axis] > 0);
        const double face = m->block->edge[axis][ahead];
        const double t = (face - m->origin[axis]) * m->inverse[axis];
        if (t < m->to) {
            m->to = t;
            m->exit_axis = axis;
        }
    }
    m->to = murk_larger(m->to, m->from);
}

/* Enters a block at `from`. */
static void enter_block(walk_state *m, size_t number)
{
    m->block = &m->field->block[number];
    for (int axis = 0; axis < 3; ++axis) {
        m->cell[axis] =
            murk_interval_of(m->block->edge[axis], 1, m->block->cells[axis] + 1,
                             m->origin[axis] + m->from * m->direction[axis]);
    }
}

/* Moves to the cell beyond the face at which the segment ended; out of the
 * block beyond its last cell. */
static void leave_cell(walk_state *m)
{
    const int axis = m->exit_axis;
    const bool is_up = m->inverse[axis] > 0;
    const size_t last = is_up ? m->block->cells[axis] - 1 : 0;
    if (m->cell[axis] == last) {
        m->block = NULL;
    } else {
        m->cell[axis] += is_up ? 1 : (size_t)-1;
    }
}

void murk_rectilinear_begin(murk_rectilinear_walk *walk,
                            const murk_rectilinear *field, murk_vec3 origin,
                            murk_vec3 direction, double t0, double t1)
{
    *walk = (murk_rectilinear_walk){.field = field,
                                    .end = fmin(t1, DBL_MAX),
                                    .from = t0,
                                    .to = t0,
                                    .exit_axis = -1,
                                    .latest = field->n,
                                    .next = field->n};
    for (int axis = 0; axis < 3; ++axis) {
        walk->origin[axis] = murk_component(origin, axis);
        walk->inverse[axis] = murk_invert(murk_component(direction, axis));
        walk->direction[axis] =
            walk->inverse[axis] == 0 ? 0 : murk_component(direction, axis);
    }
}

bool murk_rectilinear_next(murk_rectilinear_walk *walk)
{
    walk_state *m = walk;
    m->from = m->to;
    if (!(m->from < m->end)) {
        return false;
    }
    if (m->block) {
        leave_cell(m);
    }
    if (!m->block && m->next < m->field->n) {
        /* The segment between blocks has ended. */
        enter_block(m, m->next);
        m->next = m->field->n;
    } else if (!m->block) {
        size_t number;
        double at;
        find_next_block(m, &number, &at);
        m->latest = number;
        m->entered = at;
        if (number == m->field->n || at > m->from) {
            m->next = number;
            m->exit_axis = -1;
            m->to = murk_smaller(at, m->end);
            return true;
        }
        enter_block(m, number);
    }
    cross_cell(m);
    return true;
}

/* The values at the corners of the current cell: corner[4 x + 2 y + z]. */
static void corners_of(const walk_state *m, double corner[8])
{
    const murk_rectilinear_block *b = m->block;
    const size_t row = b->cells[0] + 1, sheet = row * (b->cells[1] + 1);
    const float *v =
        &b->value[m->cell[2] * sheet + m->cell[1] * row + m->cell[0]];
    for (size_t i = 0; i < 8; ++i) {
        corner[i] = (double)v[(i & 1) * sheet + (i >> 1 & 1) * row + (i >> 2)];
    }
}

/* The place at ray parameter t in the current cell, as shares of its edges. */
static void place_in_cell(const walk_state *m, double t, double place[3])
{
    for (int axis = 0; axis < 3; ++axis) {
        const double *edge = &m->block->edge[axis][m->cell[axis]];
        const double at = m->origin[axis] + t * m->direction[axis];
        const double share = (at - edge[0]) / (edge[1] - edge[0]);
        place[axis] = murk_smaller(murk_larger(share, 0), 1);
    }
}

static double value_of_cell(const walk_state *m)
{
    const murk_rectilinear_block *b = m->block;
    return (double)
        b->value[(m->cell[2] * b->cells[1] + m->cell[1]) * b->cells[0] +
                 m->cell[0]];
}

/* True if the field is 0 in the whole segment. */
static bool is_empty(const walk_state *m)
{
    if (!m->block || !m->block->has_nodes) {
        return !m->block || value_of_cell(m) == 0;
    }
    const murk_rectilinear_block *b = m->block;
    const size_t row = b->cells[0] + 1, sheet = row * (b->cells[1] + 1);
    const float *v =
        &b->value[m->cell[2] * sheet + m->cell[1] * row + m->cell[0]];
    /* Values are 0 or more. */
    return v[0] + v[1] + v[row] + v[row + 1] + v[sheet] + v[sheet + 1] +
               v[sheet + row] + v[sheet + row + 1] ==
           0;
}

murk_cubic murk_rectilinear_cubic(const murk_rectilinear_walk *walk, double t0,
                                  double t1)
{
    if (!walk->block) {
        return (murk_cubic){{0}};
    }
    if (!walk->block->has_nodes) {
        return (murk_cubic){{value_of_cell(walk), 0, 0, 0}};
    }
    double corner[8], a[3], b[3];
    corners_of(walk, corner);
    place_in_cell(walk, t0, a);
    place_in_cell(walk, t1, b);
    return murk_cubic_in_cell(corner, a, b);
}

bool murk_rectilinear_integrate(murk_rectilinear_walk *walk, double scale,
                                double offset, double limit, double *sum)
{
    walk_state *m = walk;
    while (murk_rectilinear_next(m)) {
        /* Where there is no smoke, the next segment. */
        if (offset == 0 && is_empty(m)) {
            continue;
        }
        const double length = m->to - m->from;
        const murk_cubic own = murk_rectilinear_cubic(m, m->from, m->to);
        murk_cubic whole = {{offset, 0, 0, 0}};
        murk_cubic_add(&whole, scale, &own);
        const double mean = murk_cubic_integral(&whole, 1);
        const double more = *sum + mean * length;
        if (more >= limit && mean > 0 && length > 0) {
            /* The limit is reached in this segment. */
            const double s =
                murk_cubic_reach(&whole, (limit - *sum) / (mean * length));
            m->to = murk_smaller(m->to, m->from + s * length);
            m->value = murk_cubic_value(&own, s);
            m->value = m->value > 0 ? m->value : murk_cubic_integral(&own, 1);
            *sum = limit;
            return true;
        }
        *sum = more;
    }
    return false;
}
