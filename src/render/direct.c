#include "render/direct.h"

#include "light/shine.h"

/* Of more lights than this, so many are drawn. */
#define LIGHTS_AT_ONCE 4

/* Slots of random numbers, apart from those of the lights. */
#define IMAGE_SLOT 32

/* Which image of a lamp: k periods away with a chance of 1/2 at 0, else
 * 2^-(|k| + 2). All images shine. */
static double image_of(double u, double *periods)
{
    *periods = 0;
    if (u < 0.5) {
        return 0.5;
    }
    const double side = u < 0.75 ? -1 : 1;
    double rest = (u < 0.75 ? u - 0.5 : u - 0.75) * 4; /* 0..1 */
    double chance = 0.125;
    for (*periods = side; rest < 0.5 && fabs(*periods) < 30; *periods += side) {
        rest *= 2;
        chance /= 2;
    }
    return chance;
}

/* Radiance for light that arrives with one W/m2 across its direction. */
static double answer(const murk_place *place, murk_vec3 arriving)
{
    if (place->phase) {
        const double mu = -murk_dot(arriving, place->sight);
        return place->albedo *
               murk_phase_density(place->phase, fmax(-1, fmin(1, mu)));
    }
    return place->diffuse / MURK_PI *
           fmax(0, -murk_dot(arriving, place->normal));
}

/* Light that is counted whichever way it was found cannot be looked for at the
 * places of a lamp's images as well. */
static bool may_be_met(const murk_scenery *scenery, const murk_light *light)
{
    return !scenery->world->domain.is_periodic || murk_light_is_distant(light);
}

/* How many shadow rays are sent towards the light, in the mean. */
static double rays_to(const murk_scenery *scenery, int band, size_t light)
{
    const size_t n = scenery->n_lit[band];
    const double *chance = scenery->chance[band];
    for (size_t i = 0; n > LIGHTS_AT_ONCE && i < n; ++i) {
        if (scenery->lit[band][i] == light) {
            return LIGHTS_AT_ONCE * (chance[i] - (i > 0 ? chance[i - 1] : 0));
        }
    }
    return 1;
}

/* Share of shadow rays in what finds light that arrives so; answers: how much
 * of it is answered, which is also how densely the ray goes on. */
static double share_of_rays(double answers, double per_sr)
{
    return per_sr < INFINITY ? per_sr / (per_sr + answers) : 1;
}

double murk_direct_rest(const murk_scenery *scenery, const murk_place *place,
                        size_t light, murk_vec3 arriving, double per_sr)
{
    const murk_light *l = murk_lights_get(scenery->world->lights, light);
    if (!may_be_met(scenery, l)) {
        return 0;
    }
    const double rays = rays_to(scenery, place->band, light);
    return 1 - share_of_rays(answer(place, arriving), rays * per_sr);
}

static double light_from(const murk_scenery *scenery, const murk_place *place,
                         size_t light, const murk_address *address,
                         uint32_t slot, double rays, murk_balance balance)
{
    const murk_world *world = scenery->world;
    const murk_light *l = murk_lights_get(world->lights, light);
    const bool is_distant = murk_light_is_distant(l);
    const murk_random4 random = murk_random_at(address, slot);
    murk_vec3 seen_from = place->position;
    double chance = 1;
    if (world->domain.is_periodic && !is_distant) {
        const murk_random4 image = murk_random_at(address, slot + IMAGE_SLOT);
        const murk_box *box = &world->domain.box;
        double x, y;
        chance = image_of(image.u[0], &x) * image_of(image.u[1], &y);
        seen_from.x -= x * (box->max.x - box->min.x);
        seen_from.y -= y * (box->max.y - box->min.y);
    }
    murk_shine shine;
    if (!murk_lights_shine(world->lights, light, place->band, seen_from,
                           random.u, &shine)) {
        return 0;
    }
    const double answers = answer(place, shine.direction);
    const bool is_met =
        balance.goes_on && may_be_met(scenery, l) &&
        (!place->phase ||
         -murk_dot(shine.direction, place->sight) > place->cone);
    const double counts =
        is_met ? share_of_rays(answers, rays * shine.per_sr) : 1;
    const double radiance =
        counts * answers * shine.irradiance_w_per_m2 / (chance * rays);
    if (!(radiance > 0)) {
        return 0;
    }
    const murk_vec3 start =
        place->phase ? place->position
                     : murk_surfaces_leave(world->surfaces, place->position,
                                           place->normal);
    murk_vec3 back = murk_scale(-1, shine.direction);
    double length = shine.distance_m;
    if (!is_distant) {
        /* A lamp may lie in a surface, which it is before. */
        const murk_vec3 lamp = murk_along(place->position, length, back);
        const murk_vec3 way = murk_sub(
            murk_surfaces_leave(world->surfaces, lamp, shine.face), start);
        length = murk_length(way);
        if (!(length > 0)) {
            return radiance;
        }
        back = murk_scale(1 / length, way);
    }
    return radiance * murk_scenery_through(scenery, place->band, start, back,
                                           length, balance.sheets);
}

double murk_direct_light(const murk_scenery *scenery, const murk_place *place,
                         const murk_address *address, murk_balance balance)
{
    const int band = place->band;
    const size_t n = scenery->n_lit[band];
    const bool draws = n > LIGHTS_AT_ONCE;
    double sum = 0;
    for (uint32_t k = 0; k < (draws ? LIGHTS_AT_ONCE : n); ++k) {
        size_t which = k;
        double rays = 1; /* to this light, in the mean */
        if (draws) {
            const double u = murk_random_at(address, k).u[3];
            const double *chance = scenery->chance[band];
            for (which = 0; which + 1 < n && u >= chance[which]; ++which) {
            }
            rays = (chance[which] - (which > 0 ? chance[which - 1] : 0)) *
                   LIGHTS_AT_ONCE;
        }
        sum += light_from(scenery, place, scenery->lit[band][which], address, k,
                          rays, balance);
    }
    return sum / (place->index * place->index);
}
