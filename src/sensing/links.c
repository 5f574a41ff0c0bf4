/* The range of links: a minimum spanning tree by Prim's algorithm in O(n^2)
 * tests, once with surfaces and once without. A segment is tested only if it is
 * shorter than the best known link of the sensor. */
#include "sensing/links.h"

#include "base/interrupt.h"
#include "path/segment.h"
#include "sensing/free_segments.h"

#include <stdlib.h>

typedef struct nearest_link {
    double
        length_m; /* distance from the tree; INFINITY: no open segment found */
    size_t from;
} nearest_link;

typedef struct search {
    const murk_pose *pose;
    size_t n;
    const murk_free_segments *segments; /* NULL: all segments are open */
    const murk_domain *domain;
    nearest_link *nearest; /* [n] */
    bool *is_in;           /* [n] */
} search;

/* Updates the distances from the tree after a sensor was added. */
static void spread(search *s, size_t from)
{
    const murk_vec3 at = s->pose[from].position;
    for (size_t j = 0; j < s->n; ++j) {
        if (s->is_in[j]) {
            continue;
        }
        const murk_vec3 to =
            murk_path_nearest_image(s->domain, s->pose[j].position, at);
        const double length_m = murk_length(murk_sub(to, at));
        if (length_m < s->nearest[j].length_m &&
            (!s->segments || murk_free_segment_is_open(s->segments, at, to))) {
            s->nearest[j] = (nearest_link){length_m, from};
        }
    }
}

/* The next sensor: of the sensors outside of the tree the nearest to the tree,
 * the first of equals. If no open segment leads from the tree to a sensor, the
 * first sensor outside of the tree, which begins a new group. */
static size_t next_of(const search *s)
{
    size_t best = s->n;
    for (size_t j = 0; j < s->n; ++j) {
        if (!s->is_in[j] && (best == s->n || s->nearest[j].length_m <
                                                 s->nearest[best].length_m)) {
            best = j;
        }
    }
    return best;
}

/* Fills *out except for the plain range. False if interrupted. */
static bool grow(search *s, murk_links *out)
{
    for (size_t j = 0; j < s->n; ++j) {
        s->nearest[j].length_m = INFINITY;
        s->is_in[j] = false;
    }
    double longest_m = 0;
    for (size_t k = 0; k < s->n && !murk_interrupted(); ++k) {
        const size_t j = next_of(s);
        const nearest_link r = s->nearest[j];
        if (isfinite(r.length_m)) {
            longest_m = fmax(longest_m, r.length_m);
            out->link[out->n++] = (murk_link){r.from, j, r.length_m};
        } else {
            ++out->groups;
        }
        s->is_in[j] = true;
        spread(s, j);
    }
    out->range_m = out->groups == 1 ? longest_m : NAN;
    return !murk_interrupted();
}

murk_status murk_links_find(murk_links *out, const murk_pose *pose, size_t n,
                            const murk_surfaces *surfaces,
                            const murk_domain *domain, bool through_sheets,
                            murk_error *err)
{
    murk_links links = {.range_m = NAN, .plain_range_m = NAN};
    if (n == 0 || n > MURK_LINKED_SENSORS_MAX) {
        *out = links;
        return MURK_OK;
    }
    /* Allocate for both trees. */
    murk_free_segments segments = murk_free_segments_of(surfaces, domain);
    segments.by_sheets = !through_sheets;
    search s = {.pose = pose,
                .n = n,
                .domain = domain,
                .nearest = malloc(n * sizeof *s.nearest),
                .is_in = malloc(n * sizeof *s.is_in)};
    murk_links plain = {.link = malloc(n * sizeof *plain.link)};
    links.link = malloc(n * sizeof *links.link);
    murk_status status = MURK_OK;
    if (!s.nearest || !s.is_in || !plain.link || !links.link) {
        status = murk_no_memory(err, "", "for the links of %zu sensors", n);
        goto done;
    }
    /* First with all segments open, then with surfaces. */
    bool is_done = grow(&s, &plain);
    s.segments = &segments;
    is_done = is_done && grow(&s, &links);
    if (!is_done) {
        status = murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
        goto done;
    }
    links.plain_range_m = plain.range_m;
    *out = links;
    links.link = NULL;
done:
    free(s.nearest);
    free(s.is_in);
    murk_links_release(&plain);
    murk_links_release(&links);
    return status;
}

void murk_links_release(murk_links *links)
{
    free(links->link);
    *links = (murk_links){0};
}
