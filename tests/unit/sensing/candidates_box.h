/* For tests of candidates: a room with a lamp, and where sensors may stand in
 * it. */
#ifndef MURK_TESTS_CANDIDATES_BOX_H
#define MURK_TESTS_CANDIDATES_BOX_H

#include "base/rng.h"
#include "sensing/candidates.h"
#include "world.h"

#define N_MAX 16

static const murk_domain interior = {.box = {{0, 0, 0}, {10, 10, 4}}};
static const murk_vec3 lamp = {2.3, 3.1, 3.7};

/* The room's six sides, wound either way. */
static inline size_t add_sides(murk_surface_desc *out, size_t n)
{
    out[n] = a_box(interior.box.min, interior.box.max);
    return n + 1;
}

static inline murk_reach by_lamp(void)
{
    return (murk_reach){.lamps = &lamp, .n_lamps = 1, .domain = interior};
}

static inline murk_candidate_grid half_metres(void)
{
    return (murk_candidate_grid){
        .min = {0.5, 0.5, 0.5}, .max = {9.5, 9.5, 3.5}, .size = {19, 19, 7}};
}

static inline murk_candidates *candidates_of(const murk_surface_desc *desc,
                                             size_t n,
                                             const murk_candidate_grid *grid,
                                             const murk_reach *reach,
                                             unsigned threads)
{
    murk_surfaces *surfaces = surfaces_of(desc, n);
    murk_candidates *out = NULL;
    murk_error err = {0};
    const murk_candidate_desc all = {.grid = *grid};
    CHECK(murk_candidates_create(&out, &all, surfaces, reach, threads, "here",
                                 &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    if (out) {
        CHECK(out->usable + out->too_close + out->unreached == out->asked);
    }
    murk_surfaces_destroy(surfaces);
    return out;
}

static inline bool has(const murk_candidates *c, murk_vec3 p)
{
    for (size_t i = 0; c && i < c->usable; ++i) {
        if (murk_length(murk_sub(c->position[i], p)) < 1e-9) {
            return true;
        }
    }
    return false;
}

/* How many candidates lie strictly inside a box. */
static inline size_t inside(const murk_candidates *c, murk_vec3 min,
                            murk_vec3 max)
{
    size_t n = 0;
    for (size_t i = 0; c && i < c->usable; ++i) {
        const murk_vec3 p = c->position[i];
        n += p.x > min.x && p.x < max.x && p.y > min.y && p.y < max.y &&
             p.z > min.z && p.z < max.z;
    }
    return n;
}

#endif
