/* Walk of a ray through the bricks of a grid, one segment of constant bound
 * after the other (medium/bricks.h).
 *
 * Like march.c a hierarchical digital differential analyser (Museth,
 * SIGGRAPH Talks 2014, doi:10.1145/2614106.2614136). */
#include "medium/bricks.h"

#include "medium/brick_cells.h"
void murk_brick_walk_begin(murk_brick_walk *walk, const murk_bricks *bricks,
                           murk_vec3 origin, murk_vec3 direction, double t0,
                           double t1)
{
    /* Beyond all indices of a grid. */
    static const int32_t first[3] = {-MURK_INDEX_MAX - 2, -MURK_INDEX_MAX - 2,
                                     -MURK_INDEX_MAX - 2};
    static const int32_t last[3] = {MURK_INDEX_MAX + 2, MURK_INDEX_MAX + 2,
                                    MURK_INDEX_MAX + 2};
    walk->bricks = bricks;
    walk->block = NULL;
    murk_grid_ray_begin(&walk->ray, origin, direction, t0, t1, first, last);
}

bool murk_brick_walk_next(murk_brick_walk *walk)
{
    murk_brick_walk *w = walk;
    const murk_bricks *b = w->bricks;
    murk_grid_ray *r = &walk->ray;
    r->from = r->to;
    if (!(r->from < r->end)) {
        return false;
    }
    if (!w->block || !murk_cell_contains(w->block_first, r->at, MURK_BLOCK)) {
        const murk_brick_bound s = murk_bricks_lookup(b, r->at);
        w->block = s.table;
        w->block_min = s.bound;
        murk_cell_first(w->block_first, r->at, MURK_BLOCK);
        if (!s.table) {
            w->bound = (double)s.bound;
            murk_grid_ray_cross_cell(r, 1 << s.shift);
            return true;
        }
    }
    const float bound = w->block[murk_brick_in_block(b->edge_shift, r->at)];
    w->bound = (double)(bound < w->block_min ? w->block_min : bound);
    murk_grid_ray_cross_cell(r, 1 << b->edge_shift);
    return true;
}
