/* Listed sites: marks duplicates by a hash grid of cells, then tests each site
 * for zones, clearance and reach. An open segment to a reached grid point is
 * sought in rings of growing distance: the first few points ring by ring,
 * because one of these segments is open as a rule, then all others at once. */
#include "sensing/listed.h"

#include "base/cells.h"
#include "base/interrupt.h"
#include "base/pool.h"
#include "base/progress.h"
#include "path/segment.h"

#include <stdlib.h>

/* Sites that a thread takes at a time (a choice). */
#define BATCH_SITES 256
/* Limits of the search for an open segment: reached points tried, and grid
 * points examined, after which no further ring begins (documented in
 * sensing/candidates.h). */
#define NEAREST_MAX  1000
#define EXAMINED_MAX 32768

/* The number of reached points that are tried ring by ring: as many as the
 * nearest grid point with the neighbours, 3^3. The segment to one of these
 * points is open as a rule; testing all other segments at once is faster. */
#define FIRST_TRIES 27

/* ---- listing ---- */

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
            if (normal.z >= m->min_up && normal.z <= m->max_up) {
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
    /* Each mounting point has two sides, of which the limits on the normal may
     * exclude one or both. */
    size_t all = desc->points;
    for (size_t i = 0; i < desc->mounts; ++i) {
        all += 2 * desc->mount[i].sites;
    }
    murk_listed *site = malloc((all + 1) * sizeof *site);
    if (!site) {
        return murk_no_memory(err, where, "for %zu candidates", all);
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

/* Marks a site as duplicate if a grid point that is a candidate, or an earlier
 * site, lies within the tolerance; the earlier site may be a duplicate itself.
 */
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
    const murk_free_segments *segments; /* those of space */
    const murk_domain *domain;
    const murk_listed *site;
    uint8_t *verdict;
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

/* Examines the grid points at distance r from point `at`: the largest of the
 * three distances along the axes, in steps of the grid. Indices below 0 wrap to
 * large numbers, which are skipped like all indices beyond the grid. */
static void examine_ring(const classification *j, neighbours *near,
                         const size_t at[3], size_t r)
{
    const size_t *n = j->desc->grid.size;
    for (size_t k = 0; k <= 2 * r; ++k) {
        const size_t z = at[2] + k - r;
        for (size_t i = 0; z < n[2] && i <= 2 * r; ++i) {
            const size_t y = at[1] + i - r, row = n[0] * (y + n[1] * z);
            const bool is_edge = k == 0 || k == 2 * r || i == 0 || i == 2 * r;
            for (size_t h = 0; y < n[1] && h <= 2 * r;
                 h += is_edge ? 1 : 2 * r) {
                const size_t x = at[0] + h - r;
                if (x < n[0]) {
                    examine(j, near, row + x);
                }
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
    const bool is_periodic = j->domain->is_periodic;
    if (!is_periodic) {
        murk_surfaces_blocked_many(j->segments->surfaces, near->point, near->n,
                                   point, true, blocked);
    }
    bool is_open = false;
    for (size_t i = 0; i < near->n && !is_open; ++i) {
        const murk_vec3 to =
            murk_path_nearest_image(j->domain, point, near->point[i]);
        is_open = !blocked[i] &&
                  murk_free_segment_is_open(j->segments, near->point[i], to);
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

/* True if an open segment joins the point to a reached grid point (of those
 * that joins_grid() tries), to a lamp, or, for distant light, to an open side.
 */
static bool is_joined(const classification *j, murk_vec3 point)
{
    if (joins_grid(j, point)) {
        return true;
    }
    for (size_t i = 0; i < j->space->places; ++i) {
        const murk_vec3 light = j->space->place[i];
        const murk_vec3 to = murk_path_nearest_image(j->domain, point, light);
        if (murk_free_segment_is_open(j->segments, light, to)) {
            return true;
        }
    }
    return j->space->reach->from_sides &&
           murk_free_segment_leads_out(j->segments, point);
}

/* ---- classification ---- */

/* True if a surface lies between a mount and the mounting point, from which the
 * segment starts just off the carrying surface. Transmitting sheets do not
 * count. */
static bool is_cut_off(const classification *j, const murk_listed *site,
                       const murk_mount_site *foot)
{
    const murk_surfaces *s = j->segments->surfaces;
    return murk_surfaces_blocked(
        s, murk_surfaces_leave(s, foot->position, foot->normal), site->position,
        true);
}

static murk_verdict verdict_on(const classification *j, const murk_listed *site)
{
    /* The surface that carries a mount does not count for the clearance. */
    const murk_mount_site foot = {
        murk_along(site->position, -site->offset_m, site->normal),
        site->normal};
    const murk_mount_site *mounted_on = site->offset_m > 0 ? &foot : NULL;
    if (!murk_box_contains(&j->domain->box, site->position)) {
        return MURK_SITE_UNREACHED;
    }
    if (murk_candidate_is_forbidden(j->desc, site->position)) {
        return MURK_SITE_FORBIDDEN;
    }
    /* Clearance and reach. */
    const murk_closeness closeness = murk_free_segments_closeness(
        j->segments, site->position, j->desc->grid.clearance_m, mounted_on);
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

static void classify(void *context, uint64_t i)
{
    classification *j = context;
    if (j->verdict[i] != MURK_SITE_DUPLICATE) {
        j->verdict[i] = (uint8_t)verdict_on(j, &j->site[i]);
    }
    murk_progress_add(1);
}

murk_status murk_listed_judge(uint8_t *verdict, const murk_listed *sites,
                              size_t n, const murk_candidate_desc *desc,
                              const murk_free_space *space, unsigned threads,
                              murk_error *err)
{
    classification j = {.desc = desc,
                        .space = space,
                        .segments = &space->segments,
                        .domain = &space->reach->domain,
                        .site = sites,
                        .verdict = verdict};
    const murk_status status = find_duplicates(
        verdict, sites, n, desc, space->segments.tolerance_m, err);
    if (!status && n > 0) {
        murk_progress_begin("sites", n, "sites");
        murk_pool_run_items(threads, n, BATCH_SITES, classify, &j);
        murk_progress_end();
    }
    return status ? status : murk_interrupt_check(err);
}
