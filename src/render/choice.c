/* Distributes shadow rays over lights and over the images of a lamp.
 *
 * Lights: each light is drawn in proportion to an estimate of the irradiance
 * that it would give in clear air without occluders, if all light came from the
 * center of the light. A share of the rays is distributed without regard to the
 * point, half in proportion to power and half evenly, so that a light is found,
 * too, when brighter lights are occluded (Shirley, Wang and Zimmerman, ACM
 * Trans. Graph. 15 (1996) 1, doi:10.1145/226150.226151, section 5).
 *
 * Images: half of the draws go to the nearest image and the eight images around
 * it, by the inverse square of the distance. The other half draw an isotropic
 * direction from the point to a plane at the height of the lamp (at least half
 * the shorter period away from the point), and take the image whose cell of the
 * plane the direction hits: the probability is the solid angle of the cell
 * divided by 2 pi. Images at any distance are therefore drawn in proportion to
 * their visible size, and a lamp that fills the period is sampled as the
 * infinite lamp that it forms with its images. */
#include "render/choice.h"

/* The share of the rays that is distributed half by power and half evenly. */
#define BLIND_SHARE 0.25

/* An image that is farther away than this [periods] is left to rays that hit it
 * by themselves; fewer than one draw in a million concerns such an image. */
#define PERIODS_MAX 1e6

/* From this distance on [periods] the solid angle of a cell is computed from
 * the center of the cell, exact to 1e-4; for nearer cells it is computed from
 * the corners, without loss of digits. */
#define FAR_PERIODS 100

/* ---- lights ---- */

static murk_vec3 to_nearest_image(const murk_domain *domain, murk_vec3 offset)
{
    if (domain->is_periodic) {
        const double x = domain->box.max.x - domain->box.min.x;
        const double y = domain->box.max.y - domain->box.min.y;
        offset.x -= x * round(offset.x / x);
        offset.y -= y * round(offset.y / y);
    }
    return offset;
}

static double weight_of(const murk_scenery *scenery,
                        const murk_shading_point *place, size_t light)
{
    const murk_transport_world *world = scenery->world;
    const murk_source *l = murk_sources_get(world->lights, light);
    murk_vec3 middle;
    if (!murk_sources_place(world->lights, light, &middle)) {
        return l->power_w.band[place->band]; /* irradiance */
    }
    const bool has_images = world->domain.is_periodic;
    const murk_vec3 offset =
        to_nearest_image(&world->domain, murk_sub(middle, place->position));
    double weight =
        murk_source_irradiance_near(l, place->band, offset, has_images);
    if (!place->phase && !has_images) {
        const double above = murk_dot(place->normal, offset) +
                             murk_source_extent_m(l) + scenery->margin_m;
        const double distance = murk_length(offset);
        weight *= above < distance ? fmax(0, above) / distance : 1;
    }
    return weight;
}

void murk_choice_rays(const murk_scenery *scenery,
                      const murk_shading_point *place,
                      double rays[MURK_SOURCES_MAX])
{
    const size_t n = scenery->n_lit[place->band];
    const size_t *lit = scenery->lit[place->band];
    const double *chance = scenery->chance[place->band];
    double sum = 0;
    for (size_t i = 0; i < n; ++i) {
        rays[i] =
            n > MURK_LIGHTS_AT_ONCE ? weight_of(scenery, place, lit[i]) : 1;
        sum += rays[i];
    }
    for (size_t i = 0; n > MURK_LIGHTS_AT_ONCE && i < n; ++i) {
        const double blind = chance[i] - (i > 0 ? chance[i - 1] : 0);
        const double share =
            sum > 0 ? (1 - BLIND_SHARE) * rays[i] / sum + BLIND_SHARE * blind
                    : blind;
        rays[i] = MURK_LIGHTS_AT_ONCE * share;
    }
}

/* ---- images ---- */

murk_source_images murk_images_of(const murk_scenery *scenery, size_t light,
                                  murk_vec3 place)
{
    const murk_transport_world *world = scenery->world;
    const murk_box *box = &world->domain.box;
    const murk_source *l = murk_sources_get(world->lights, light);
    murk_vec3 middle = place;
    murk_sources_place(world->lights, light, &middle);
    const murk_vec3 away = murk_sub(middle, place);
    murk_source_images m = {
        .period_m = {box->max.x - box->min.x, box->max.y - box->min.y},
        .away_m = {away.x, away.y},
        .size_m = fmax(murk_source_extent_m(l), scenery->margin_m)};
    /* The plane stays at least half a period away: at a small height, hardly
     * any image but the nearest one would be drawn. */
    m.height_m = fmax(fabs(away.z), 0.5 * fmin(m.period_m[0], m.period_m[1]));
    m.nearest[0] = -round(away.x / m.period_m[0]);
    m.nearest[1] = -round(away.y / m.period_m[1]);
    for (int k = 0; k < 9; ++k) {
        const double x = away.x + (m.nearest[0] + k % 3 - 1) * m.period_m[0];
        const double y = away.y + (m.nearest[1] + k / 3 - 1) * m.period_m[1];
        m.weight[k] =
            1 / fmax(x * x + y * y + away.z * away.z, m.size_m * m.size_m);
        m.sum += m.weight[k];
    }
    return m;
}

/* The signed solid angle of the rectangle from the axis to (x, y) in a plane at
 * height h. */
static double corner_angle(double x, double y, double h)
{
    return atan2(x * y, h * sqrt(h * h + x * x + y * y));
}

/* The solid angle of the cell around an image. */
static double cell_angle(const murk_source_images *m, const double periods[2])
{
    const double half_x = 0.5 * m->period_m[0], half_y = 0.5 * m->period_m[1];
    const double x = m->away_m[0] + periods[0] * m->period_m[0];
    const double y = m->away_m[1] + periods[1] * m->period_m[1];
    const double h = m->height_m;
    const double distance = sqrt(x * x + y * y + h * h);
    if (distance > FAR_PERIODS * 2 * fmax(half_x, half_y)) {
        return 4 * half_x * half_y * h / (distance * distance * distance);
    }
    return corner_angle(x + half_x, y + half_y, h) -
           corner_angle(x - half_x, y + half_y, h) -
           corner_angle(x + half_x, y - half_y, h) +
           corner_angle(x - half_x, y - half_y, h);
}

double murk_images_chance(const murk_source_images *m, const double periods[2])
{
    const double i = periods[0] - m->nearest[0], j = periods[1] - m->nearest[1];
    if (fmax(fabs(periods[0]), fabs(periods[1])) > PERIODS_MAX) {
        return 0;
    }
    const bool is_near = fabs(i) <= 1 && fabs(j) <= 1;
    const double near =
        is_near ? m->weight[(int)(3 * (j + 1) + i + 1)] / m->sum : 0;
    return 0.5 * near + 0.5 * cell_angle(m, periods) / (2 * MURK_PI);
}

double murk_images_draw(const murk_source_images *m, const double u[4],
                        double periods[2])
{
    if (u[0] < 0.5) {
        double left = u[1] * m->sum;
        int k = 0;
        while (k < 8 && left >= m->weight[k]) {
            left -= m->weight[k++];
        }
        periods[0] = m->nearest[0] + k % 3 - 1;
        periods[1] = m->nearest[1] + k / 3 - 1;
    } else {
        const double mu = u[2], phi = 2 * MURK_PI * u[3];
        const double aside = m->height_m * sqrt((1 - mu) * (1 + mu)) / mu;
        periods[0] = round((aside * cos(phi) - m->away_m[0]) / m->period_m[0]);
        periods[1] = round((aside * sin(phi) - m->away_m[1]) / m->period_m[1]);
    }
    return murk_images_chance(m, periods);
}
