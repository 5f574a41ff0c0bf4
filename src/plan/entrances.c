/* Lists the positions of lamps and the centres of portals. Distant light adds
 * the open sides of the domain. */
#include "plan/entrances.h"

#include <stdlib.h>

static bool is_same(murk_vec3 a, murk_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Appends the centre of a portal unless it is in the list already: sun and sky
 * usually share their portals. */
static size_t add_portal(murk_vec3 *place, size_t first, size_t n,
                         const murk_portal *portal)
{
    murk_vec3 middle = murk_along(portal->corner, 0.5, portal->edge1);
    middle = murk_along(middle, 0.5, portal->edge2);
    for (size_t i = first; i < n; ++i) {
        if (is_same(place[i], middle)) {
            return n;
        }
    }
    place[n] = middle;
    return n + 1;
}

murk_status murk_entrances(murk_reach *out, murk_vec3 **places,
                           const murk_stage *stage, const char *where,
                           murk_error *err)
{
    const murk_sources *lights = stage->lights;
    const size_t n = murk_sources_count(lights);
    /* Allocate for one position of each lamp and one of each portal. */
    size_t capacity = n + 1;
    for (size_t i = 0; i < n; ++i) {
        capacity += murk_sources_get(lights, i)->portals;
    }
    murk_vec3 *place = calloc(capacity, sizeof *place);
    if (!place) {
        return murk_fail(err, MURK_NO_MEMORY, where,
                         "no memory for the lamps' places");
    }
    /* Lamps, and whether any light is distant. */
    murk_reach reach = {.lamps = place, .domain = stage->world.domain};
    for (size_t i = 0; i < n; ++i) {
        if (murk_sources_place(lights, i, &place[reach.n_lamps])) {
            ++reach.n_lamps;
        } else {
            reach.from_sides = true;
        }
    }
    /* Portals. */
    const size_t lamps = reach.n_lamps;
    for (size_t i = 0; i < n; ++i) {
        const murk_source *light = murk_sources_get(lights, i);
        for (size_t k = 0; k < light->portals; ++k) {
            reach.n_lamps =
                add_portal(place, lamps, reach.n_lamps, &light->portal[k]);
        }
    }
    *out = reach;
    *places = place;
    return MURK_OK;
}
