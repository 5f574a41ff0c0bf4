/* Listed sites: removes duplicates with a hash grid of cells, then tests each
 * site for zones, clearance and reach. The segment to the reached grid points
 * is sought in rings of growing distance: the first few points one by one,
 * because one of them is open as a rule, then all others at once. */
#include "sensing/listed.h"

#include "base/cells.h"
#include "base/interrupt.h"
#include "base/pool.h"
#include "base/progress.h"
#include "path/segment.h"
#include "sensing/lamp.h"

#include <stdlib.h>

/* Sites of a task (a choice). */
#define BATCH_SITES 256
/* Limits of the search for an open segment: reached points tried, and grid
 * points examined (documented in candidates.h). */
#define NEAREST_MAX  1000
#define EXAMINED_MAX 32768

/* Points tried one by one: a cell of the grid and its neighbours, 3^3. One of
 * them is open as a rule; testing all others at once is faster. */
#define FIRST_TRIES 27

bool murk_site_is_forbidden(const murk_candidate_desc *desc, murk_vec3 point)
{
    return (desc->avoid && murk_zones_contain(desc->avoid, point)) ||
           (desc->within && !murk_zones_contain(desc->within, point));
}

/* ---- listing ---- */

static bool faces_so(const murk_candidate_mount *m, double up)
{
    return up >= m->min_up && up <= m->max_up;
}

static size_t count_all(const murk_candidate_desc *desc)
{
    size_t n = desc->points;
    for (size_t i = 0; i < desc->mounts; ++i) {
        const murk_candidate_mount *m = &desc->mount[i];
        for (size_t k = 0; k < m->sites; ++k) {
            const double up = m->site[k].normal.z;
            n += (size_t)faces_so(m, up) + (size_t)faces_so(m, -up);
        }
    }
    return n;
}

static double wrapped(double x, double min, double max)
{
    return x < min ? x + (max - min) : x > max ? x - (max - min) : x;
}

static murk_vec3 mount_position(const murk_mount_site *foot, murk_vec3 normal,
                                double offset_m, const murk_domain *domain)
{
    const murk_box *box = &domain->box;
    murk_vec3 p = murk_along(foot->position, offset_m, normal);
    if (domain->is_periodic) {
        p.x = wrapped(p.x, box->min.x, box->max.x);
        p.y = wrapped(p.y, box->min.y, box->max.y);
    }
    return p;
}

static size_t list_mount(murk_listed *site, const murk_candidate_mount *m,
                         const murk_domain *domain)
{
    size_t n = 0;
    for (size_t k = 0; k < m->sites; ++k) {
        for (int side = 1; side >= -1; side -= 2) {
            const murk_vec3 normal = murk_scale(side, m->site[k].normal);
            if (faces_so(m, normal.z)) {
                site[n++] = (murk_listed){
                    mount_position(&m->site[k], normal, m->offset_m, domain),
                    normal, m->offset_m};
            }
        }
    }
    return n;
}

murk_status murk_listed_all(murk_listed **out, size_t *n,
                            const murk_candidate_desc *desc,
                            const murk_domain *domain, const char *where,
                            murk_error *err)
{
    const size_t all = count_all(desc);
    murk_listed *site = malloc((all + 1) * sizeof *site);
    if (!site) {
        return murk_fail(err, MURK_NO_MEMORY, where,
                         "no memory for %zu candidates", all);
    }
    for (size_t i = 0; i < desc->points; ++i) {
        site[i] = (murk_listed){.position = desc->point[i]};
    }
    *n = desc->points;
    for (size_t i = 0; i < desc->mounts; ++i) {
        *n += list_mount(site + *n, &desc->mount[i], domain);
    }
    *out = site;
    return MURK_OK;
}

/* ---- duplicates ---- */

typedef struct comparison {
    const murk_listed *site;
    murk_vec3 point;
    double tolerance_m;
} comparison;

static bool is_same(void *context, size_t number)
{
    const comparison *c = context;
    return murk_length(murk_sub(c->site[number].position, c->point)) <=
           c->tolerance_m;
}

/* The index of the nearest grid point along an axis. */
static size_t nearest_index(double min, double max, size_t n, double x)
{
    const double step = n > 1 ? (max - min) / (double)(n - 1) : 1;
    return (size_t)fmin(fmax(round((x - min) / step), 0), (double)(n - 1));
}

static void nearest_of_grid(const murk_candidate_grid *g, murk_vec3 p,
                            size_t at[3])
{
    at[0] = nearest_index(g->min.x, g->max.x, g->size[0], p.x);
    at[1] = nearest_index(g->min.y, g->max.y, g->size[1], p.y);
    at[2] = nearest_index(g->min.z, g->max.z, g->size[2], p.z);
}

static bool is_of_grid(const murk_candidate_grid *g, murk_vec3 p,
                       double tolerance_m)
{
    size_t at[3];
    nearest_of_grid(g, p, at);
    const size_t index = at[0] + g->size[0] * (at[1] + g->size[1] * at[2]);
    return murk_length(murk_sub(murk_candidate_grid_point(g, index), p)) <=
           tolerance_m;
}

/* Marks a site as duplicate if an earlier site lies within the tolerance; the
 * earlier site may be a duplicate itself. */
static murk_status find_duplicates(uint8_t *verdict, const murk_listed *site,
                                   size_t n, const murk_candidate_desc *desc,
                                   double tolerance_m, murk_error *err)
{
    murk_cells *cells = NULL;
    murk_status status = murk_cells_create(&cells, 2 * tolerance_m, err);
    for (size_t i = 0; i < n && !status; ++i) {
        comparison c = {site, site[i].position, tolerance_m};
        const bool is_one =
            (!desc->is_reach_grid &&
             is_of_grid(&desc->grid, c.point, tolerance_m)) ||
            murk_cells_search(cells, c.point, tolerance_m, is_same, &c);
        verdict[i] = is_one ? MURK_SITE_DUPLICATE : MURK_SITE_USABLE;
        status = murk_cells_add(cells, c.point, err);
    }
    murk_cells_destroy(cells);
    return status;
}

/* ---- segments ---- */

typedef struct classification {
    const murk_candidate_desc *desc;
    const murk_free_space *space;
    const murk_reach *reach;
    murk_free_segments segments;
    const murk_listed *site;
    size_t n;
    uint8_t *verdict;
    murk_vec3 *lamp; /* [lamps] places from which light starts */
    size_t lamps;
} classification;

/* Reached grid points around a site, collected for testing. */
typedef struct neighbours {
    size_t examined, tried, n;
    murk_vec3 point[NEAREST_MAX];
} neighbours;

static void examine(const classification *j, neighbours *near, size_t index)
{
    ++near->examined;
    if (j->space->is_reached[index] && near->tried + near->n < NEAREST_MAX) {
        near->point[near->n++] =
            murk_candidate_grid_point(&j->desc->grid, index);
    }
}

static size_t min_of(size_t at, size_t r)
{
    return at > r ? at - r : 0;
}

static size_t max_of(size_t at, size_t r, size_t n)
{
    return n - 1 - at > r ? at + r : n - 1;
}

/* Examines the grid points at distance r in steps, along the axis of the
 * largest distance. */
static void examine_ring(const classification *j, neighbours *near,
                         const size_t at[3], size_t r)
{
    const size_t *n = j->desc->grid.size;
    for (size_t z = min_of(at[2], r); z <= max_of(at[2], r, n[2]); ++z) {
        for (size_t y = min_of(at[1], r); y <= max_of(at[1], r, n[1]); ++y) {
            const size_t row = n[0] * (y + n[1] * z);
            if (z + r == at[2] || z == at[2] + r || y + r == at[1] ||
                y == at[1] + r) {
                for (size_t x = min_of(at[0], r); x <= max_of(at[0], r, n[0]);
                     ++x) {
                    examine(j, near, row + x);
                }
                continue;
            }
            if (at[0] >= r) {
                examine(j, near, row + at[0] - r);
            }
            if (r > 0 && at[0] + r < n[0]) {
                examine(j, near, row + at[0] + r);
            }
        }
    }
}

/* True if a segment from the point to one of the collected points is open.
 * Empties the collection. */
static bool is_any_open(const classification *j, neighbours *near,
                        murk_vec3 point)
{
    bool blocked[NEAREST_MAX] = {false};
    const bool is_periodic = j->reach->domain.is_periodic;
    if (!is_periodic) {
        murk_surfaces_blocked_many(j->segments.surfaces, near->point, near->n,
                                   point, true, blocked);
    }
    bool is_open = false;
    for (size_t i = 0; i < near->n && !is_open; ++i) {
        const murk_vec3 to =
            murk_path_nearest_image(&j->reach->domain, point, near->point[i]);
        is_open = !blocked[i] &&
                  murk_free_segment_is_open(&j->segments, near->point[i], to);
    }
    near->tried += near->n;
    near->n = 0;
    return is_open;
}

static bool joins_grid(const classification *j, murk_vec3 point)
{
    const size_t *n = j->desc->grid.size;
    size_t at[3];
    nearest_of_grid(&j->desc->grid, point, at);
    const size_t last = (n[0] > n[1] ? n[0] : n[1]) + n[2];
    neighbours near;
    near.examined = near.tried = near.n = 0;
    for (size_t r = 0; r < last && near.tried + near.n < NEAREST_MAX &&
                       near.examined < EXAMINED_MAX;
         ++r) {
        examine_ring(j, &near, at, r);
        if (near.tried < FIRST_TRIES && near.n > 0 &&
            is_any_open(j, &near, point)) {
            return true;
        }
    }
    return near.n > 0 && is_any_open(j, &near, point);
}

/* True if an open segment joins the point to the reached grid, to a lamp, or to
 * an open side. */
static bool is_joined(const classification *j, murk_vec3 point)
{
    if (joins_grid(j, point)) {
        return true;
    }
    for (size_t i = 0; i < j->lamps; ++i) {
        const murk_vec3 to =
            murk_path_nearest_image(&j->reach->domain, point, j->lamp[i]);
        if (murk_free_segment_is_open(&j->segments, j->lamp[i], to)) {
            return true;
        }
    }
    return j->reach->from_sides &&
           murk_free_segment_leads_out(&j->segments, point);
}

/* ---- classification ---- */

static bool is_mounted(const murk_listed *site)
{
    return site->offset_m > 0;
}

/* True if another surface lies between a mount and its mounting point. */
static bool is_cut_off(const classification *j, const murk_listed *site,
                       const murk_mount_site *foot)
{
    const murk_surfaces *s = j->segments.surfaces;
    return murk_surfaces_blocked(
        s, murk_surfaces_leave(s, foot->position, foot->normal), site->position,
        true);
}

static murk_verdict classify(const classification *j, const murk_listed *site)
{
    /* The surface that carries a mount does not count. */
    const murk_mount_site foot = {
        murk_along(site->position, -site->offset_m, site->normal),
        site->normal};
    const murk_mount_site *mounted_on = is_mounted(site) ? &foot : NULL;
    if (!murk_box_contains(&j->reach->domain.box, site->position)) {
        return MURK_SITE_UNREACHED;
    }
    if (murk_site_is_forbidden(j->desc, site->position)) {
        return MURK_SITE_FORBIDDEN;
    }
    /* Clearance and reach. */
    const murk_closeness closeness = murk_free_segments_closeness(
        &j->segments, site->position, j->desc->grid.clearance_m, mounted_on);
    if (closeness == MURK_ON_SURFACE) {
        return MURK_SITE_TOO_CLOSE;
    }
    if ((mounted_on && is_cut_off(j, site, mounted_on)) ||
        !is_joined(j, site->position)) {
        return MURK_SITE_UNREACHED;
    }
    return closeness == MURK_TOO_CLOSE      ? MURK_SITE_TOO_CLOSE
           : closeness == MURK_BARELY_CLEAR ? MURK_SITE_DOUBTFUL
                                            : MURK_SITE_USABLE;
}

static void classify_batch(void *context, uint64_t batch)
{
    classification *j = context;
    const size_t begin = (size_t)batch * BATCH_SITES;
    const size_t end = begin + BATCH_SITES < j->n ? begin + BATCH_SITES : j->n;
    for (size_t i = begin; i < end; ++i) {
        if (j->verdict[i] != MURK_SITE_DUPLICATE) {
            j->verdict[i] = (uint8_t)classify(j, &j->site[i]);
        }
    }
    murk_progress_add(end - begin);
}

static murk_status place_lamps(classification *j, const char *where,
                               murk_error *err)
{
    const murk_reach *reach = j->reach;
    j->lamp =
        malloc((reach->n_lamps * MURK_LAMP_PLACES_MAX + 1) * sizeof *j->lamp);
    if (!j->lamp) {
        return murk_fail(err, MURK_NO_MEMORY, where, "no memory for %zu lamps",
                         reach->n_lamps);
    }
    for (size_t i = 0; i < reach->n_lamps; ++i) {
        j->lamps += murk_lamp_places(j->segments.surfaces, &reach->domain,
                                     reach->lamps[i], j->lamp + j->lamps);
    }
    return MURK_OK;
}

murk_status murk_listed_judge(uint8_t *verdict, const murk_listed *sites,
                              size_t n, const murk_candidate_desc *desc,
                              const murk_free_space *space,
                              const murk_surfaces *surfaces,
                              const murk_reach *reach, unsigned threads,
                              const char *where, murk_error *err)
{
    /* Duplicates, lamps, then all sites over threads. */
    classification j = {.desc = desc,
                        .space = space,
                        .reach = reach,
                        .segments =
                            murk_free_segments_of(surfaces, &reach->domain),
                        .site = sites,
                        .n = n,
                        .verdict = verdict};
    murk_status status =
        find_duplicates(verdict, sites, n, desc, j.segments.tolerance_m, err);
    if (!status) {
        status = place_lamps(&j, where, err);
    }
    if (!status) {
        murk_progress_begin("sites", n, "sites");
        murk_pool_run(threads, (n + BATCH_SITES - 1) / BATCH_SITES,
                      classify_batch, &j);
        murk_progress_end();
        if (murk_interrupted()) {
            status = murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
        }
    }
    free(j.lamp);
    return status;
}
