/* A bounding volume hierarchy over the receivers: nodes are stored in
 * depth-first order with a skip index, so that a traversal is one loop with a
 * fixed order (B. Smits, Journal of Graphics Tools 3 (1998) 1,
 * doi:10.1080/10867651.1998.10487488). Nodes split at the median of the longest
 * axis. */
#include "calibrate/receiver_tree.h"

#include "base/sort.h"

#include <assert.h>
#include <stdlib.h>

#define LEAF 4 /* receivers in a leaf, few enough to test one by one */

/* Boxes exceed the spheres by these shares of the radius and of the distance
 * from the origin, far more than the rounding of a segment. */
#define GROWN_RADIUS 1e-6
#define GROWN_PLACE  1e-12

/* A direction component with an absolute value below this counts as this, so
 * that the inverse is finite. */
#define LEVEL 1e-300

typedef struct node {
    murk_box box;
    uint32_t skip;     /* the node that follows all descendants */
    uint32_t first, n; /* n > 0: a leaf with order[first .. first + n); 0: an
                        * inner node */
} node;

struct murk_receiver_tree {
    const murk_receiver *receiver;
    uint32_t *order; /* [receivers] */
    node *nodes;
    size_t n_nodes;
};

/* ---- building ---- */

/* Sort key of a receiver: position on the axis, then number. */
typedef struct sorted {
    double at;
    uint32_t receiver;
} sorted;

static int compare(const void *a, const void *b)
{
    const sorted *x = a, *y = b;
    const int order = MURK_ORDER(x->at, y->at);
    return order ? order : MURK_ORDER(x->receiver, y->receiver);
}

static murk_box box_of(const murk_receiver_tree *c, uint32_t first, uint32_t n)
{
    murk_box box = murk_box_empty();
    for (uint32_t i = first; i < first + n; ++i) {
        const murk_receiver *r = &c->receiver[c->order[i]];
        const double out = r->radius_m * (1 + GROWN_RADIUS) +
                           murk_length(r->center) * GROWN_PLACE;
        const murk_vec3 reach = murk_vec(out, out, out);
        box = murk_box_with(box, murk_sub(r->center, reach));
        box = murk_box_with(box, murk_add(r->center, reach));
    }
    return box;
}

/* Builds the node of n receivers and recursively the nodes of both halves. The
 * depth is the logarithm of n. */
static void split(murk_receiver_tree *c, sorted *scratch, uint32_t first,
                  uint32_t n)
{
    node *made = &c->nodes[c->n_nodes++];
    made->box = box_of(c, first, n);
    made->first = first;
    made->n = n <= LEAF ? n : 0;
    /* Sort by position on the longest axis. */
    if (n > LEAF) {
        const murk_vec3 size = murk_sub(made->box.max, made->box.min);
        const int axis = size.x >= size.y && size.x >= size.z ? 0
                         : size.y >= size.z                   ? 1
                                                              : 2;
        for (uint32_t i = 0; i < n; ++i) {
            const uint32_t r = c->order[first + i];
            scratch[i] =
                (sorted){murk_component(c->receiver[r].center, axis), r};
        }
        qsort(scratch, n, sizeof *scratch, compare);
        for (uint32_t i = 0; i < n; ++i) {
            c->order[first + i] = scratch[i].receiver;
        }
        split(c, scratch, first, n / 2);
        split(c, scratch, first + n / 2, n - n / 2);
    }
    made->skip = (uint32_t)c->n_nodes;
}

murk_status murk_receiver_tree_create(murk_receiver_tree **out,
                                      const murk_receiver *receiver, size_t n,
                                      murk_error *err)
{
    assert(n < UINT32_MAX / 4);
    /* Allocate; a binary tree has fewer than 2 n nodes. */
    murk_receiver_tree *c = calloc(1, sizeof *c);
    sorted *scratch = malloc((n + 1) * sizeof *scratch);
    if (c) {
        c->receiver = receiver;
        c->order = malloc((n + 1) * sizeof *c->order);
        c->nodes = malloc((2 * n + 1) * sizeof *c->nodes);
    }
    if (!c || !scratch || !c->order || !c->nodes) {
        murk_receiver_tree_destroy(c);
        free(scratch);
        return murk_no_memory(err, "receivers", "for %zu receivers", n);
    }
    /* Build. */
    for (size_t i = 0; i < n; ++i) {
        assert(receiver[i].radius_m > 0 && murk_is_finite(receiver[i].center));
        c->order[i] = (uint32_t)i;
    }
    if (n > 0) {
        split(c, scratch, 0, (uint32_t)n);
    }
    free(scratch);
    *out = c;
    return MURK_OK;
}

void murk_receiver_tree_destroy(murk_receiver_tree *tree)
{
    if (tree) {
        free(tree->order);
        free(tree->nodes);
        free(tree);
    }
}

/* ---- traversal ---- */

/* A segment with the inverse of the direction. */
typedef struct segment {
    murk_vec3 from, direction, inverse;
    double length_m;
} segment;

static double inverse_of(double d)
{
    return 1 / (fabs(d) < LEVEL ? LEVEL : d);
}

/* Intersects the interval [t0, t1] with one slab. */
static inline void clip(double low, double high, double from, double inverse,
                        double *t0, double *t1)
{
    const double a = (low - from) * inverse, b = (high - from) * inverse;
    const double enter = a < b ? a : b, leave = a < b ? b : a;
    *t0 = enter > *t0 ? enter : *t0;
    *t1 = leave < *t1 ? leave : *t1;
}

static inline bool meets(const segment *l, const murk_box *box)
{
    double t0 = 0, t1 = l->length_m;
    clip(box->min.x, box->max.x, l->from.x, l->inverse.x, &t0, &t1);
    clip(box->min.y, box->max.y, l->from.y, l->inverse.y, &t0, &t1);
    clip(box->min.z, box->max.z, l->from.z, l->inverse.z, &t0, &t1);
    return t0 <= t1;
}

/* The chord of a segment in a sphere. The half length follows from the point of
 * the line closest to the centre, which keeps precision for a small sphere far
 * away. */
static inline bool cross(const segment *l, const murk_receiver *receiver,
                         murk_chord *chord)
{
    const murk_vec3 to_center = murk_sub(receiver->center, l->from);
    const double along = murk_dot(to_center, l->direction);
    const murk_vec3 off = murk_along(to_center, -along, l->direction);
    const double left =
        receiver->radius_m * receiver->radius_m - murk_dot(off, off);
    if (!(left > 0)) {
        return false;
    }
    const double half = sqrt(left);
    chord->from_m = along - half > 0 ? along - half : 0;
    chord->to_m = along + half < l->length_m ? along + half : l->length_m;
    return chord->to_m > chord->from_m;
}

size_t murk_receiver_tree_chords(const murk_receiver_tree *tree, murk_vec3 from,
                                 murk_vec3 direction, double length_m,
                                 murk_chord *chord)
{
    const segment l = {from, direction,
                       murk_vec(inverse_of(direction.x),
                                inverse_of(direction.y),
                                inverse_of(direction.z)),
                       length_m};
    size_t found = 0;
    /* Skip the descendants of a node whose box the segment does not meet. */
    for (size_t i = 0; i < tree->n_nodes;) {
        const node *at = &tree->nodes[i];
        if (!meets(&l, &at->box)) {
            i = at->skip;
            continue;
        }
        for (uint32_t k = 0; k < at->n; ++k) {
            const uint32_t receiver = tree->order[at->first + k];
            if (cross(&l, &tree->receiver[receiver], &chord[found])) {
                chord[found++].receiver = receiver;
            }
        }
        ++i;
    }
    return found;
}
