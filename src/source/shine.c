#include "source/shine.h"

#include <assert.h>

#define TWO_PI (2 * MURK_PI)

/* Watts of a lamp; for distant light its irradiance [W/m2]. */
static double power_of(const murk_source *light, int band)
{
    return light->power_w.band[band];
}

/* 1 - cos(half angle), which keeps its digits in narrow beams. */
static double cone_of(const murk_source *beam)
{
    const double s = sin(beam->divergence_rad / 2);
    return 2 * s * s;
}

/* ---- portals ---- */

/* How far along unit `travel` from the place the line passes a portal inward,
 * and the cosine there; false where it does not. */
static bool passes(const murk_portal *portal, murk_vec3 place, murk_vec3 travel,
                   double *ahead_m, double *cosine)
{
    const murk_vec3 cross = murk_cross(portal->edge1, portal->edge2);
    const double area = murk_length(cross);
    *cosine = murk_dot(travel, cross) / area;
    if (!(*cosine > 0)) {
        return false;
    }
    const murk_vec3 to = murk_sub(portal->corner, place);
    *ahead_m = murk_dot(to, cross) / area / *cosine;
    const murk_vec3 on = murk_sub(murk_scale(*ahead_m, travel), to);
    const double a =
        murk_dot(murk_cross(on, portal->edge2), cross) / (area * area);
    const double b =
        murk_dot(murk_cross(portal->edge1, on), cross) / (area * area);
    return a >= 0 && a < 1 && b >= 0 && b < 1;
}

/* Whether distant light may come along the line. */
static bool enters(const murk_source *light, murk_vec3 place, murk_vec3 travel)
{
    double ahead_m, cosine;
    for (size_t i = 0; i < light->portals; ++i) {
        if (passes(&light->portal[i], place, travel, &ahead_m, &cosine)) {
            return true;
        }
    }
    return light->portals == 0;
}

/* ---- distant light ---- */

static double sky_radiance(const murk_sources *lights, size_t light, int band,
                           murk_vec3 sight)
{
    const murk_source *l = murk_sources_get(lights, light);
    murk_dome dome = l->dome;
    if (dome.c != 0 || dome.e != 0) {
        dome.towards = murk_unit(dome.towards);
    }
    return power_of(l, band) * murk_dome_radiance(&dome, sight) /
           murk_sources_sky_level(lights, light);
}

/* How densely directions towards places on the portals are drawn, each portal
 * as likely. */
static double portals_per_sr(const murk_source *l, murk_vec3 place,
                             murk_vec3 travel)
{
    double per_sr = 0;
    for (size_t i = 0; i < l->portals; ++i) {
        const murk_portal *p = &l->portal[i];
        double ahead_m, cosine;
        if (passes(p, place, travel, &ahead_m, &cosine)) {
            const double area = murk_length(murk_cross(p->edge1, p->edge2));
            per_sr += ahead_m * ahead_m / (area * cosine * (double)l->portals);
        }
    }
    return per_sr;
}

/* False where the place lies in the portal's plane. */
static bool towards_portal(const murk_source *l, murk_vec3 place,
                           const double u[MURK_SHINE_NUMBERS],
                           murk_shine *shine)
{
    const size_t drawn = (size_t)(u[2] * (double)l->portals);
    const murk_portal *k = &l->portal[drawn < l->portals ? drawn : 0];
    murk_vec3 on = murk_along(k->corner, u[0], k->edge1);
    on = murk_along(on, u[1], k->edge2);
    const murk_vec3 way = murk_sub(place, on);
    const double length = murk_length(way);
    const double side = murk_dot(way, murk_cross(k->edge1, k->edge2));
    if (!(length > 0) || side == 0) {
        return false;
    }
    shine->direction = murk_scale((side > 0 ? 1 : -1) / length, way);
    shine->per_sr = portals_per_sr(l, place, shine->direction);
    return shine->per_sr > 0;
}

static double sky_per_sr(const murk_source *l, murk_vec3 place,
                         murk_vec3 travel)
{
    return l->portals > 0 ? portals_per_sr(l, place, travel) : 1 / TWO_PI;
}

static bool shine_sky(const murk_sources *lights, size_t light, int band,
                      murk_vec3 place, const double u[MURK_SHINE_NUMBERS],
                      murk_shine *shine)
{
    const murk_source *l = murk_sources_get(lights, light);
    if (l->portals > 0) {
        if (!towards_portal(l, place, u, shine)) {
            return false;
        }
    } else {
        const double side = sqrt((1 - u[0]) * (1 + u[0])), phi = TWO_PI * u[1];
        shine->direction = murk_vec(-side * cos(phi), -side * sin(phi), -u[0]);
        shine->per_sr = 1 / TWO_PI;
    }
    shine->irradiance_w_per_m2 =
        sky_radiance(lights, light, band, murk_scale(-1, shine->direction)) /
        shine->per_sr;
    return shine->irradiance_w_per_m2 > 0;
}

static double disc_per_sr(const murk_source *l, double cosine)
{
    const double radius = tan(l->angular_radius_rad);
    return 1 / (MURK_PI * radius * radius * cosine * cosine * cosine);
}

static bool shine_directional(const murk_source *l, int band, murk_vec3 place,
                              const double u[MURK_SHINE_NUMBERS],
                              murk_shine *shine)
{
    const double radius = tan(l->angular_radius_rad);
    const double rho = radius * sqrt(u[0]), phi = TWO_PI * u[1];
    murk_vec3 t, b;
    murk_frame(l->direction, &t, &b);
    murk_vec3 d = murk_along(l->direction, rho * cos(phi), t);
    d = murk_along(d, rho * sin(phi), b);
    const double length = murk_length(d);
    shine->direction = murk_scale(1 / length, d);
    shine->irradiance_w_per_m2 = power_of(l, band) * length;
    shine->per_sr = disc_per_sr(l, 1 / length);
    return enters(l, place, shine->direction);
}

/* ---- lamps ---- */

static bool shine_sphere(const murk_source *l, int band, murk_vec3 place,
                         const double u[MURK_SHINE_NUMBERS], murk_shine *shine)
{
    const murk_vec3 to = murk_sub(l->position, place);
    const double d2 = murk_dot(to, to), r2 = l->radius_m * l->radius_m;
    if (!(d2 > r2)) {
        return false; /* inside: it shines outwards */
    }
    const double sine2 = r2 / d2;
    const double cone = sine2 / (1 + sqrt(1 - sine2)); /* 1 - cos */
    const double part = cone * u[0];
    const double distance = sqrt(d2);
    const murk_vec3 sight =
        murk_about(murk_scale(1 / distance, to), 1 - part, TWO_PI * u[1]);
    const double rest = r2 - d2 * part * (2 - part);
    shine->distance_m = distance * (1 - part) - sqrt(fmax(0, rest));
    shine->direction = murk_scale(-1, sight);
    shine->face = murk_unit(
        murk_sub(murk_along(place, shine->distance_m, sight), l->position));
    const double radiance = power_of(l, band) / (4 * MURK_PI * MURK_PI * r2);
    shine->irradiance_w_per_m2 = radiance * TWO_PI * cone;
    shine->per_sr = 1 / (TWO_PI * cone);
    return true;
}

/* From a point of the lamp; *length_m: how far. */
static bool come_from(murk_vec3 from, murk_vec3 place, murk_shine *shine)
{
    const murk_vec3 way = murk_sub(place, from);
    shine->distance_m = murk_length(way);
    shine->direction = murk_scale(1 / shine->distance_m, way);
    return shine->distance_m > 0;
}

/* Of places drawn evenly on a flat lamp. */
static double sheet_per_sr(double area_m2, double distance_m, double cosine)
{
    return distance_m * distance_m / (area_m2 * cosine);
}

/* Radiance. */
static double rect_brightness(const murk_source *l, int band)
{
    const double area = murk_length(murk_cross(l->edge1, l->edge2));
    return power_of(l, band) / (MURK_PI * area);
}

static bool shine_rect(const murk_source *l, int band, murk_vec3 place,
                       const double u[MURK_SHINE_NUMBERS], murk_shine *shine)
{
    murk_vec3 from = murk_along(l->position, u[0], l->edge1);
    from = murk_along(from, u[1], l->edge2);
    shine->face = murk_unit(murk_cross(l->edge1, l->edge2));
    if (!come_from(from, place, shine)) {
        return false;
    }
    const double cosine = murk_dot(shine->face, shine->direction);
    if (!(cosine > 0)) {
        return false;
    }
    shine->per_sr = sheet_per_sr(murk_length(murk_cross(l->edge1, l->edge2)),
                                 shine->distance_m, cosine);
    shine->irradiance_w_per_m2 = rect_brightness(l, band) / shine->per_sr;
    return true;
}

static bool shine_beam(const murk_source *l, int band, murk_vec3 place,
                       const double u[MURK_SHINE_NUMBERS], murk_shine *shine)
{
    const double cone = cone_of(l), r = l->radius_m;
    shine->face = l->direction;
    if (!(cone > 0)) {
        const murk_vec3 way = murk_sub(place, l->position);
        const double ahead = murk_dot(way, l->direction);
        const murk_vec3 aside = murk_along(way, -ahead, l->direction);
        shine->direction = l->direction;
        shine->distance_m = ahead;
        shine->irradiance_w_per_m2 = power_of(l, band) / (MURK_PI * r * r);
        return r > 0 && ahead > 0 && murk_dot(aside, aside) < r * r;
    }
    murk_vec3 t, b, from = l->position;
    murk_frame(l->direction, &t, &b);
    const double rho = r * sqrt(u[0]), phi = TWO_PI * u[1];
    from = murk_along(from, rho * cos(phi), t);
    from = murk_along(from, rho * sin(phi), b);
    if (!come_from(from, place, shine)) {
        return false;
    }
    shine->irradiance_w_per_m2 =
        power_of(l, band) /
        (TWO_PI * cone * shine->distance_m * shine->distance_m);
    shine->per_sr =
        r > 0 ? sheet_per_sr(MURK_PI * r * r, shine->distance_m,
                             fabs(murk_dot(shine->direction, l->direction)))
              : INFINITY;
    return 1 - murk_dot(shine->direction, l->direction) < cone;
}

static bool shine_point(const murk_source *l, int band, murk_vec3 place,
                        murk_shine *shine)
{
    if (!come_from(l->position, place, shine)) {
        return false;
    }
    shine->face = shine->direction;
    shine->irradiance_w_per_m2 =
        power_of(l, band) /
        (4 * MURK_PI * shine->distance_m * shine->distance_m);
    return true;
}

bool murk_sources_can_shine(const murk_sources *lights, size_t light)
{
    const murk_source *l = murk_sources_get(lights, light);
    return l->type != MURK_SOURCE_BEAM || l->radius_m > 0 ||
           l->divergence_rad > 0;
}

bool murk_sources_shine(const murk_sources *lights, size_t light, int band,
                        murk_vec3 place, const double u[MURK_SHINE_NUMBERS],
                        murk_shine *shine)
{
    const murk_source *l = murk_sources_get(lights, light);
    *shine = (murk_shine){.distance_m = INFINITY, .per_sr = INFINITY};
    if (!(power_of(l, band) > 0)) {
        return false;
    }
    switch (l->type) {
    case MURK_SOURCE_SPHERE:
        return shine_sphere(l, band, place, u, shine);
    case MURK_SOURCE_RECT:
        return shine_rect(l, band, place, u, shine);
    case MURK_SOURCE_BEAM:
        return shine_beam(l, band, place, u, shine);
    case MURK_SOURCE_DIRECTIONAL:
        return shine_directional(l, band, place, u, shine);
    case MURK_SOURCE_DOME:
        return shine_sky(lights, light, band, place, u, shine);
    case MURK_SOURCE_POINT:
        break;
    }
    return shine_point(l, band, place, shine);
}

/* ---- looking at them ---- */

static murk_glare sphere_glare(const murk_source *l, int band, murk_vec3 place,
                               murk_vec3 sight)
{
    const murk_vec3 to = murk_sub(l->position, place);
    const double ahead = murk_dot(to, sight), d2 = murk_dot(to, to);
    const murk_vec3 aside = murk_along(to, -ahead, sight);
    const double r2 = l->radius_m * l->radius_m;
    const double half = r2 - murk_dot(aside, aside);
    const double distance = ahead - sqrt(fmax(0, half));
    if (!(half > 0 && d2 > r2 && distance > 0)) {
        return (murk_glare){0};
    }
    const double sine2 = r2 / d2;
    const double cone = sine2 / (1 + sqrt(1 - sine2));
    return (murk_glare){.radiance =
                            power_of(l, band) / (4 * MURK_PI * MURK_PI * r2),
                        .distance_m = distance,
                        .per_sr = 1 / (TWO_PI * cone)};
}

static murk_glare rect_glare(const murk_source *l, int band, murk_vec3 place,
                             murk_vec3 sight)
{
    const murk_portal sheet = {l->position, l->edge1, l->edge2};
    double ahead_m, cosine;
    /* Its light has passed it, on the way to the place, where it shines to. */
    if (!passes(&sheet, place, murk_scale(-1, sight), &ahead_m, &cosine) ||
        !(ahead_m < 0)) {
        return (murk_glare){0};
    }
    const double area = murk_length(murk_cross(l->edge1, l->edge2));
    return (murk_glare){.radiance = rect_brightness(l, band),
                        .distance_m = -ahead_m,
                        .per_sr = sheet_per_sr(area, ahead_m, cosine)};
}

/* Even over the cone's solid angle, so brighter aside. */
static murk_glare beam_glare(const murk_source *l, int band, murk_vec3 place,
                             murk_vec3 sight)
{
    const double cone = cone_of(l), r = l->radius_m;
    const double cosine = -murk_dot(sight, l->direction);
    if (!(cone > 0 && r > 0 && 1 - cosine < cone) || cosine == 0) {
        return (murk_glare){0};
    }
    const murk_vec3 to = murk_sub(l->position, place);
    const double distance = -murk_dot(to, l->direction) / cosine;
    const murk_vec3 aside = murk_sub(murk_scale(distance, sight), to);
    if (!(distance > 0 && murk_dot(aside, aside) < r * r)) {
        return (murk_glare){0};
    }
    const double area = MURK_PI * r * r;
    return (murk_glare){.radiance = power_of(l, band) /
                                    (area * TWO_PI * cone * fabs(cosine)),
                        .distance_m = distance,
                        .per_sr = sheet_per_sr(area, distance, fabs(cosine))};
}

static murk_glare disc_glare(const murk_source *l, int band, murk_vec3 place,
                             murk_vec3 sight)
{
    const double radius = tan(l->angular_radius_rad);
    const double cosine = -murk_dot(sight, l->direction);
    const double side = murk_length(murk_cross(sight, l->direction));
    if (!(cosine > 0 && side < radius * cosine) ||
        !enters(l, place, murk_scale(-1, sight))) {
        return (murk_glare){0};
    }
    const double per_sr = disc_per_sr(l, cosine);
    return (murk_glare){.radiance = power_of(l, band) * per_sr / cosine,
                        .distance_m = INFINITY,
                        .per_sr = per_sr};
}

static murk_glare sky_glare(const murk_sources *lights, size_t light, int band,
                            murk_vec3 place, murk_vec3 sight)
{
    const murk_source *l = murk_sources_get(lights, light);
    const murk_vec3 travel = murk_scale(-1, sight);
    if (!(sight.z >= 0) || !enters(l, place, travel)) {
        return (murk_glare){0};
    }
    return (murk_glare){.radiance = sky_radiance(lights, light, band, sight),
                        .distance_m = INFINITY,
                        .per_sr = sky_per_sr(l, place, travel)};
}

murk_glare murk_sources_glare(const murk_sources *lights, size_t light,
                              int band, murk_vec3 place, murk_vec3 sight)
{
    const murk_source *l = murk_sources_get(lights, light);
    switch (l->type) {
    case MURK_SOURCE_SPHERE:
        return sphere_glare(l, band, place, sight);
    case MURK_SOURCE_RECT:
        return rect_glare(l, band, place, sight);
    case MURK_SOURCE_BEAM:
        return beam_glare(l, band, place, sight);
    case MURK_SOURCE_DIRECTIONAL:
        return disc_glare(l, band, place, sight);
    case MURK_SOURCE_DOME:
        return sky_glare(lights, light, band, place, sight);
    case MURK_SOURCE_POINT:
        break;
    }
    return (murk_glare){0};
}
