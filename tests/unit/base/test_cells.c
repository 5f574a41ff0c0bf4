/* A search finds every point within the radius, whatever was added before and
 * across the sides of cells, also below zero. Compared with looking at all
 * points in turn; no false alarms. */
#include "base/cells.h"
#include "base/rng.h"
#include "check.h"

#include <stdlib.h>

#define SEED   3
#define POINTS 3000

typedef struct incumbent {
    const murk_vec3 *point;
    murk_vec3 at;
    double radius_m;
    bool found[POINTS];
    size_t calls, stop_at;
} incumbent;

static bool meet(void *context, size_t i)
{
    incumbent *f = context;
    f->found[i] |= murk_length(murk_sub(f->point[i], f->at)) <= f->radius_m;
    return ++f->calls == f->stop_at;
}

static murk_vec3 random_point(uint64_t i, uint32_t event)
{
    const murk_random4 r = murk_random(SEED, MURK_TEST, i, event, 0);
    return murk_vec(10 * (r.u[0] - .5), 10 * (r.u[1] - .5), 4 * (r.u[2] - .5));
}

int main(void)
{
    static murk_vec3 point[POINTS];
    static incumbent f;
    murk_cells *cells = NULL;
    murk_error err = {0};
    CHECK(murk_cells_create(&cells, .5, &err) == MURK_OK);
    size_t near = 0, missed = 0, calls = 0;
    for (size_t i = 0; i < POINTS; ++i) {
        point[i] = random_point(i, 0);
        f = (incumbent){
            .point = point, .at = random_point(i, 1), .radius_m = .4};
        CHECK(!murk_cells_search(cells, f.at, f.radius_m, meet, &f));
        for (size_t k = 0; k < i; ++k) {
            const bool is_near =
                murk_length(murk_sub(point[k], f.at)) <= f.radius_m;
            near += is_near;
            missed += is_near && !f.found[k];
        }
        calls += f.calls;
        CHECK(murk_cells_add(cells, point[i], &err) == MURK_OK);
    }
    CHECK(near > 1000 && missed == 0);
    /* 27 cells of 1/8 m^3 among 400 m^3, some of them of other cells */
    CHECK(calls < POINTS * (size_t)POINTS / 2 / 50);
    f = (incumbent){
        .point = point, .at = point[7], .radius_m = .4, .stop_at = 1};
    CHECK(murk_cells_search(cells, f.at, f.radius_m, meet, &f));
    CHECK(f.calls == 1);
    murk_cells_destroy(cells);
    murk_cells_destroy(NULL);
    return check_done();
}
