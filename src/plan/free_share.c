/* Stratified estimate of the free share of a box or a ball: 24^3 equal cells of
 * the bounding box with one random point each; points outside a ball are
 * ignored. Source of the method: any text on Monte Carlo integration, for
 * example A. B. Owen, Monte Carlo theory, methods and examples, chapter 8. */
#include "plan/free_share.h"

#include "base/pool.h"
#include "base/rng.h"
#include "base/tally.h"

#include <math.h>

/* Cells on each axis. With 24^3 points the standard error is at most .5 /
 * 24^1.5 = 0.004. */
#define CELLS_EACH 24

typedef struct job {
    const murk_part *part;
    const murk_open_space *space;
    uint32_t seed;
    murk_tally inside, free;
} job;

/* Tests the points of one layer of cells. */
static void ask(void *context, uint64_t layer)
{
    job *j = context;
    const murk_part *part = j->part;
    const murk_vec3 size = murk_sub(part->box.max, part->box.min);
    int64_t inside = 0, is_free = 0;
    for (uint64_t i = 0; i < CELLS_EACH * CELLS_EACH; ++i) {
        const uint64_t place = layer * CELLS_EACH * CELLS_EACH + i;
        /* A random point in the cell. */
        const murk_random4 r =
            murk_random(j->seed, MURK_FREE_SPACE, place, part->number, 0);
        const murk_vec3 at = murk_vec(
            part->box.min.x +
                size.x * ((double)(i % CELLS_EACH) + r.u[0]) / CELLS_EACH,
            part->box.min.y +
                size.y * ((double)(i / CELLS_EACH) + r.u[1]) / CELLS_EACH,
            part->box.min.z + size.z * ((double)layer + r.u[2]) / CELLS_EACH);
        /* Count the points in the part, and those in free space. */
        if (part->is_ball &&
            murk_length(murk_sub(at, part->center)) > part->radius_m) {
            continue;
        }
        ++inside;
        is_free += murk_open_space_holds(j->space, at, murk_vec(0, 0, 0));
    }
    murk_tally_add(&j->inside, inside);
    murk_tally_add(&j->free, is_free);
}

murk_estimate murk_free_share(const murk_part *part,
                              const murk_open_space *space, uint32_t seed,
                              unsigned threads)
{
    job j = {.part = part, .space = space, .seed = seed};
    if (!space) {
        return (murk_estimate){1, 0};
    }
    murk_pool_run(threads, CELLS_EACH, ask, &j);
    const double n = (double)murk_tally_read(&j.inside),
                 share = n > 0 ? (double)murk_tally_read(&j.free) / n : 0;
    return (murk_estimate){share, n > 0 ? sqrt(share * (1 - share) / n) : 0};
}
