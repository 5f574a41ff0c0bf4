/* The places from which the light of a lamp starts: the lamp, or both sides of
 * the surface that it lies on; and for a lamp inside of solids, places just
 * outside, found by following six directions out of these solids. */
#include "sensing/lamp.h"

#include "path/segment.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

/* Both directions along three axes. */
#define DIRECTIONS 6

/* The largest number of surfaces that are followed in one direction, and of
 * solids that are remembered: far more than nested solids have. */
#define CROSSINGS_MAX 64

typedef struct lamp_search {
    const murk_surfaces *surfaces;
    const murk_domain *domain;
    double tolerance_m;
    murk_vec3 direction[DIRECTIONS];
    uint16_t around[CROSSINGS_MAX]; /* solids that contain the lamp */
    size_t n_around;
    murk_vec3 *place;
    size_t n_places;
} lamp_search;

static void add_place(lamp_search *w, murk_vec3 place)
{
    if (w->n_places < MURK_LAMP_PLACES_MAX) {
        w->place[w->n_places++] = place;
    }
}

/* Both directions along three orthogonal axes, tilted so that no direction
 * follows a seam of rectangular buildings. */
static void choose_directions(murk_vec3 direction[DIRECTIONS])
{
    direction[0] = murk_unit(murk_vec(0.937, 0.281, 0.207));
    murk_frame(direction[0], &direction[1], &direction[2]);
    for (int i = 0; i < 3; ++i) {
        direction[3 + i] = murk_scale(-1, direction[i]);
    }
}

/* ---- a lamp on a surface ---- */

/* Adds the places just off both sides of the surface that the lamp lies on.
 * Adds the lamp itself if it is off every surface, or if no ray along an axis
 * finds the surface. */
static void add_sides(lamp_search *w, murk_vec3 lamp)
{
    static const murk_vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const double tolerance = w->tolerance_m;
    if (!murk_surfaces_near(w->surfaces, lamp, tolerance)) {
        add_place(w, lamp);
        return;
    }
    for (int i = 0; i < 3; ++i) {
        for (int sign = -1; sign <= 1; sign += 2) {
            murk_hit hit;
            const murk_vec3 direction = murk_scale(sign, axes[i]);
            const murk_vec3 start = murk_along(lamp, -4 * tolerance, direction);
            if (murk_surfaces_hit(w->surfaces, start, direction, 8 * tolerance,
                                  &hit)) {
                /* Two tolerances off, because segments are tested half a
                 * tolerance aside as well. */
                const murk_vec3 on =
                    murk_along(start, hit.distance_m, direction);
                add_place(w, murk_along(on, 2 * tolerance, hit.normal));
                add_place(w, murk_along(on, -2 * tolerance, hit.normal));
                return;
            }
        }
    }
    add_place(w, lamp);
}

/* ---- a lamp in glass ---- */

static bool lets_light_through(const murk_surfaces *surfaces,
                               const murk_hit *hit)
{
    const murk_material *m = murk_surfaces_material(surfaces, hit->material);
    for (int i = 0; i < MURK_BANDS_MAX; ++i) {
        /* Of a solid, specular + transmit is the share of light that is not
         * absorbed; Fresnel's equations split this share. */
        const double specular = hit->solid ? m->specular.band[i] : 0;
        if (m->transmit.band[i] + specular > 0) {
            return true;
        }
    }
    return false;
}

/* Finds the next surface in a direction and moves *at to just behind this
 * surface. False if there is none. */
static bool step(const lamp_search *w, murk_vec3 *at, murk_vec3 direction,
                 murk_hit *hit)
{
    if (!murk_surfaces_hit(w->surfaces, *at, direction, INFINITY, hit)) {
        return false;
    }
    *at = murk_surfaces_leave(w->surfaces,
                              murk_along(*at, hit->distance_m, direction),
                              murk_scale(-1, hit->normal));
    return true;
}

static bool contains(const uint16_t *solids, size_t n, uint16_t solid)
{
    for (size_t i = 0; i < n; ++i) {
        if (solids[i] == solid) {
            return true;
        }
    }
    return false;
}

/* Lists the solids crossed in a direction through all surfaces, each solid
 * once, and returns their number. */
static size_t crossed(const lamp_search *w, murk_vec3 from, murk_vec3 direction,
                      uint16_t solid[CROSSINGS_MAX])
{
    size_t n = 0;
    murk_hit hit;
    for (int k = 0; k < CROSSINGS_MAX && step(w, &from, direction, &hit); ++k) {
        if (hit.solid && !contains(solid, n, hit.solid)) {
            solid[n++] = hit.solid;
        }
    }
    return n;
}

/* Finds the solids that all six directions cross: those contain the lamp. */
static void find_around(lamp_search *w, murk_vec3 from)
{
    w->n_around = crossed(w, from, w->direction[0], w->around);
    for (int i = 1; i < DIRECTIONS && w->n_around > 0; ++i) {
        uint16_t solid[CROSSINGS_MAX];
        const size_t n = crossed(w, from, w->direction[i], solid);
        size_t remaining = 0;
        for (size_t k = 0; k < w->n_around; ++k) {
            if (contains(solid, n, w->around[k])) {
                w->around[remaining++] = w->around[k];
            }
        }
        w->n_around = remaining;
    }
}

/* Adds the place two tolerances behind a surface, unless another surface lies
 * within four tolerances or the place is outside of the domain or in a
 * solid. */
static void add_outside(lamp_search *w, murk_vec3 behind, murk_vec3 onward)
{
    const double off = 2 * w->tolerance_m;
    const murk_vec3 place = murk_along(behind, off, onward);
    murk_hit hit;
    if (murk_box_contains(&w->domain->box, place) &&
        !murk_surfaces_hit(w->surfaces, behind, onward, 2 * off, &hit) &&
        murk_surfaces_solid_at(w->surfaces, place) == 0) {
        add_place(w, place);
    }
}

/* Follows a direction out of the solids around the lamp and adds a place just
 * behind each surface of these solids that add_outside() accepts. Ends at
 * another solid and at a surface that transmits no light. */
static void walk_out(lamp_search *w, murk_vec3 from, murk_vec3 direction)
{
    murk_hit hit;
    for (int k = 0; k < CROSSINGS_MAX && step(w, &from, direction, &hit); ++k) {
        if (!lets_light_through(w->surfaces, &hit) ||
            (hit.solid && !contains(w->around, w->n_around, hit.solid))) {
            return;
        }
        if (hit.solid) {
            add_outside(w, from, murk_scale(-1, hit.normal));
        }
    }
}

size_t murk_lamp_places(const murk_surfaces *surfaces,
                        const murk_domain *domain, murk_vec3 lamp,
                        murk_vec3 place[MURK_LAMP_PLACES_MAX])
{
    lamp_search w = {.surfaces = surfaces,
                     .domain = domain,
                     .tolerance_m =
                         murk_path_surface_tolerance_m(surfaces, domain),
                     .place = place};
    /* Add the places of the lamp itself. Then, for each of these places, add
     * places outside of the solids that contain the place. */
    choose_directions(w.direction);
    add_sides(&w, lamp);
    if (murk_surfaces_describe(surfaces).solids == 0) {
        return w.n_places;
    }
    for (size_t i = 0, n = w.n_places; i < n; ++i) {
        const murk_vec3 from = w.place[i];
        find_around(&w, from);
        for (int k = 0; k < DIRECTIONS && w.n_around > 0; ++k) {
            walk_out(&w, from, w.direction[k]);
        }
    }
    return w.n_places;
}
