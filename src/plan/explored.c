/* Seen places and their connections, kept as disjoint sets with path
 * compression (R. E. Tarjan, Journal of the ACM 22 (1975) 215,
 * doi:10.1145/321879.321884), and paths between places. */
#include "plan/explored.h"

#include <assert.h>
#include <stdlib.h>

/* The largest number of seen places that a path is searched over, besides those
 * that are always used. There are some 2e6 pairs of 2000 places. */
#define PATH_PLACES_MAX 2000

murk_status murk_explored_init(murk_explored *out, const murk_sight_desc *sight,
                               int bands, size_t sites, const murk_poses *poses,
                               murk_error *err)
{
    /* The number of places: sites, and places of fixed sensors. */
    size_t places = sites;
    for (size_t j = 0; j < poses->count; ++j) {
        const size_t above = (size_t)poses->site[j] + 1;
        places = above > places ? above : places;
    }
    /* Allocate. */
    *out = (murk_explored){.places = places, .sites = sites};
    murk_outlook_init(&out->outlook, sight, bands);
    out->place = calloc(places + 1, sizeof *out->place);
    out->is_seen = calloc(places + 1, sizeof *out->is_seen);
    out->is_always_used = calloc(places + 1, sizeof *out->is_always_used);
    out->joined = calloc(places + 1, sizeof *out->joined);
    if (!out->place || !out->is_seen || !out->is_always_used || !out->joined) {
        murk_explored_release(out);
        return murk_no_memory(err, "", "for %zu places", places);
    }
    /* Positions; at first every place is a set of its own. */
    for (size_t j = 0; j < poses->count; ++j) {
        out->place[poses->site[j]] = poses->pose[j].position;
    }
    for (size_t k = 0; k < places; ++k) {
        out->joined[k] = (uint32_t)k;
    }
    return MURK_OK;
}

void murk_explored_release(murk_explored *explored)
{
    free(explored->place);
    free(explored->is_seen);
    free(explored->is_always_used);
    free(explored->joined);
    *explored = (murk_explored){0};
}

/* The representative of the set that a place belongs to: the lowest number. */
static uint32_t root_of(const murk_explored *e, uint32_t place)
{
    while (e->joined[place] != place) {
        place = e->joined[place];
    }
    return place;
}

/* Returns root_of(), and shortens the chain of parents for later calls. */
static uint32_t find_root(murk_explored *e, uint32_t place)
{
    const uint32_t root = root_of(e, place);
    while (e->joined[place] != root) {
        const uint32_t next = e->joined[place];
        e->joined[place] = root;
        place = next;
    }
    return root;
}

static void join(murk_explored *e, uint32_t a, uint32_t b)
{
    const uint32_t x = find_root(e, a), y = find_root(e, b);
    e->joined[x > y ? x : y] = x > y ? y : x;
}

static void mark_seen(murk_explored *e, uint32_t place)
{
    e->sites_seen += !e->is_seen[place] && place < e->sites;
    e->is_seen[place] = 1;
}

size_t murk_explored_see(murk_explored *e, const murk_pose *pose,
                         uint32_t place)
{
    const murk_outlook_view view = murk_outlook_from(&e->outlook, pose);
    mark_seen(e, place);
    e->is_always_used[place] = 1;
    for (uint32_t k = 0; k < e->places; ++k) {
        if (!murk_outlook_sees(&view, e->place[k])) {
            continue;
        }
        /* A place that was seen earlier and belongs to another set connects
         * both sets, so paths need it. */
        if (e->is_seen[k] && find_root(e, k) != find_root(e, place)) {
            e->is_always_used[k] = 1;
        }
        mark_seen(e, k);
        join(e, k, place);
    }
    return e->sites_seen;
}

bool murk_explored_joins(const murk_explored *e, uint32_t place, uint32_t other)
{
    return e->is_seen[place] && root_of(e, place) == root_of(e, other);
}

size_t murk_explored_opens(murk_explored *e, const murk_pose *pose,
                           uint32_t place)
{
    const murk_outlook_view view = murk_outlook_from(&e->outlook, pose);
    size_t n = 0;
    for (uint32_t k = 0; k < e->sites; ++k) {
        n += !murk_explored_joins(e, k, place) &&
             murk_outlook_sees(&view, e->place[k]);
    }
    return n;
}

/* Lists, in rising order, the places that a path may lead over: both ends, and
 * of the seen places in the set of `from` those that are always used and every
 * `each`-th of the others. Returns the number of places in the list. */
static size_t list_places(const murk_explored *e, uint32_t from, uint32_t to,
                          uint32_t *list)
{
    const uint32_t root = root_of(e, from);
    size_t free_ones = 0;
    for (uint32_t k = 0; k < e->places; ++k) {
        free_ones +=
            e->is_seen[k] && !e->is_always_used[k] && root_of(e, k) == root;
    }
    /* Of the places that are not always used, list PATH_PLACES_MAX at most. */
    const size_t each =
        free_ones > PATH_PLACES_MAX
            ? (free_ones + PATH_PLACES_MAX - 1) / PATH_PLACES_MAX
            : 1;
    /* List the places. */
    size_t n = 0, met = 0;
    for (uint32_t k = 0; k < e->places; ++k) {
        const bool is_end = k == from || k == to;
        if (!is_end && (!e->is_seen[k] || root_of(e, k) != root)) {
            continue;
        }
        const bool is_free = !e->is_always_used[k];
        met += is_free;
        if (is_end || !is_free || met % each == 0) {
            list[n++] = k;
        }
    }
    return n;
}

murk_status murk_explored_path(murk_explored *e, murk_vec3 **path,
                               size_t *stops, double *length_m, uint32_t from,
                               uint32_t to, murk_error *err)
{
    /* List the places and find the ends in the list. */
    uint32_t *list = malloc((e->places + 1) * sizeof *list);
    size_t n = list ? list_places(e, from, to, list) : 0;
    murk_vec3 *place = malloc((n + 1) * sizeof *place);
    size_t *stop = malloc((n + 1) * sizeof *stop);
    murk_vec3 *out = malloc((n + 1) * sizeof *out);
    murk_status status = MURK_OK;
    if (!list || !place || !stop || !out) {
        status =
            murk_no_memory(err, "", "for a way over %zu places", e->places);
        goto done;
    }
    size_t first = 0, last = 0;
    for (size_t k = 0; k < n; ++k) {
        place[k] = e->place[list[k]];
        first = list[k] == from ? k : first;
        last = list[k] == to ? k : last;
    }
    /* Search. */
    status = murk_route_find(stop, stops, length_m, &e->outlook, place, n,
                             first, last, err);
    if (status) {
        goto done;
    }
    assert(*stops > 0);
    /* Translate the stops into positions. */
    for (size_t k = 0; k < *stops; ++k) {
        out[k] = place[stop[k]];
    }
    *path = out;
    out = NULL;
done:
    free(list);
    free(place);
    free(stop);
    free(out);
    return status;
}
