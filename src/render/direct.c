/* Direct light at a place by shadow rays: picks a number of shadow rays for
 * each light (render/choice.h), draws a point of the light, and weighs the
 * contribution against the ray that goes on by the balance heuristic of Veach
 * and Guibas (1995, doi:10.1145/218380.218498). */
#include "render/direct.h"

#include "source/shine.h"

/* Slots of the random numbers for images, different from those for lights. */
#define IMAGE_SLOT 32

/* The radiance towards the viewer [W/m2/sr] for light that arrives along
 * `arriving` with 1 W/m2 on a plane at right angles to it. */
static double answer(const murk_shading_point *place, murk_vec3 arriving)
{
    if (place->phase) {
        const double mu = -murk_dot(arriving, place->sight);
        return place->albedo *
               murk_phase_density(place->phase, fmax(-1, fmin(1, mu)));
    }
    return place->diffuse / MURK_PI *
           fmax(0, -murk_dot(arriving, place->normal));
}

/* The weight of shadow rays for light that arrives in this direction, sampled
 * with density per_sr. `answers`: the response of the point (answer()), which
 * is also the density [1/sr] with which the ray continues. */
static double share_of_rays(double answers, double per_sr)
{
    return per_sr < INFINITY ? per_sr / (per_sr + answers) : 1;
}

double murk_direct_rest(const murk_scenery *scenery,
                        const murk_shading_point *place, size_t light,
                        murk_vec3 arriving, double per_sr, murk_vec3 wrapped)
{
    /* The number of shadow rays to this light. */
    const size_t *lit = scenery->lit[place->band];
    double all[MURK_SOURCES_MAX];
    murk_choice_rays(scenery, place, all);
    double rays = 0;
    for (size_t i = 0; i < scenery->n_lit[place->band]; ++i) {
        rays = lit[i] == light ? all[i] : rays;
    }
    /* In a periodic domain: times the probability of the image that the ray has
     * hit. */
    const murk_transport_world *world = scenery->world;
    if (world->domain.is_periodic &&
        !murk_source_is_distant(murk_sources_get(world->lights, light))) {
        const murk_source_images images =
            murk_images_of(scenery, light, place->position);
        rays *= murk_images_chance(
            &images, (const double[2]){round(wrapped.x / images.period_m[0]),
                                       round(wrapped.y / images.period_m[1])});
    }
    return 1 - share_of_rays(answer(place, arriving), rays * per_sr);
}

static double light_from(const murk_scenery *scenery,
                         const murk_shading_point *place, size_t light,
                         const murk_address *address, uint32_t slot,
                         double rays, murk_balance balance)
{
    /* In a periodic domain one image of the lamp is drawn. */
    const murk_transport_world *world = scenery->world;
    const murk_source *l = murk_sources_get(world->lights, light);
    const bool is_distant = murk_source_is_distant(l);
    const murk_random4 random = murk_random_at(address, slot);
    murk_vec3 seen_from = place->position;
    if (world->domain.is_periodic && !is_distant) {
        const murk_random4 drawn = murk_random_at(address, slot + IMAGE_SLOT);
        const murk_source_images images =
            murk_images_of(scenery, light, place->position);
        double periods[2];
        rays *= murk_images_draw(&images, drawn.u, periods);
        seen_from.x -= periods[0] * images.period_m[0];
        seen_from.y -= periods[1] * images.period_m[1];
    }
    /* Draw a point or a direction of the light. */
    murk_shine shine;
    if (!murk_sources_shine(world->lights, light, place->band, seen_from,
                            random.u, &shine)) {
        return 0;
    }
    /* The share of this contribution by the balance heuristic. */
    const double answers = answer(place, shine.direction);
    const bool is_met =
        balance.goes_on &&
        (!place->phase ||
         -murk_dot(shine.direction, place->sight) > place->cone);
    const double counts =
        is_met ? share_of_rays(answers, rays * shine.per_sr) : 1;
    const double radiance = counts * answers * shine.irradiance_w_per_m2 / rays;
    if (!(rays > 0 && radiance > 0)) {
        return 0;
    }
    /* The shadow ray starts and ends clear of the surfaces. */
    const murk_vec3 start =
        place->phase ? place->position
                     : murk_surfaces_leave(world->surfaces, place->position,
                                           place->normal);
    murk_vec3 back = murk_scale(-1, shine.direction);
    double length = shine.distance_m;
    if (!is_distant) {
        /* A lamp may lie in a surface; the shadow ray ends in front of it. */
        const murk_vec3 lamp = murk_along(place->position, length, back);
        const murk_vec3 offset = murk_sub(
            murk_surfaces_leave(world->surfaces, lamp, shine.face), start);
        length = murk_length(offset);
        if (!(length > 0)) {
            return radiance;
        }
        back = murk_scale(1 / length, offset);
    }
    return radiance * murk_scenery_through(scenery, place->band, start, back,
                                           length, balance.sheets);
}

double murk_direct_light(const murk_scenery *scenery,
                         const murk_shading_point *place,
                         const murk_address *address, murk_balance balance)
{
    const int band = place->band;
    const size_t n = scenery->n_lit[band];
    double rays[MURK_SOURCES_MAX];
    murk_choice_rays(scenery, place, rays);
    double sum = 0;
    if (n <= MURK_LIGHTS_AT_ONCE) {
        for (uint32_t k = 0; k < n; ++k) {
            sum += light_from(scenery, place, scenery->lit[band][k], address, k,
                              rays[k], balance);
        }
    } else {
        /* Systematic sampling: one random number places all rays at equal
         * steps, so that the number of rays of a light differs from the mean by
         * less than one. */
        double next = murk_random_at(address, 0).u[3], passed = 0;
        uint32_t sent = 0;
        for (size_t i = 0; i < n; ++i) {
            passed += rays[i];
            for (; next < passed && sent < MURK_LIGHTS_AT_ONCE;
                 next += 1, ++sent) {
                sum += light_from(scenery, place, scenery->lit[band][i],
                                  address, sent, rays[i], balance);
            }
        }
    }
    return sum / (place->index * place->index);
}
