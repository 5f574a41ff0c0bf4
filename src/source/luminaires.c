/* Luminaires: lamps whose luminous intensity over directions is a table
 * (luminaire/intensity.h).
 *
 * Every point of the luminous area, a point, a rectangle or a disc, emits with
 * the same distribution over directions, that of the table. The intensity of
 * the whole is then that of the table at any distance that is large against the
 * area, as it was measured. A photon starts at a uniform point of the
 * area in a direction drawn from the table. Seen from a point (shine), a
 * point of the luminous area is drawn and the irradiance is intensity /
 * distance^2; along a line of sight (glare) the radiance is intensity / (area
 * times cosine). The area is luminous on both sides, as far as the table has
 * light there.
 *
 * With a height the area is a solid instead, a box or a cylinder, whose sides
 * are luminous, too (source/luminous_solid.h). */
#include "source/luminous_solid.h"
#include "source/source_state.h"

#include <math.h>

#define TWO_PI (2 * MURK_PI) /* a full turn */

/* The part of c0 across the aim that rounding may leave of one along the
 * aim. */
#define ALONG 1e-9

/* The direction of C = 90 degrees. */
static murk_vec3 c90_of(const murk_source *l)
{
    return murk_cross(l->c0, l->direction);
}

/* The share of the power per steradian in a direction of the world. */
static double share_per_sr(const murk_source *l, murk_vec3 travel)
{
    const murk_vec3 local = {murk_dot(travel, l->c0),
                             murk_dot(travel, c90_of(l)),
                             -murk_dot(travel, l->direction)};
    return murk_intensity_candela(l->intensity, local) /
           murk_intensity_lumens(l->intensity);
}

/* ---- shape ---- */

static bool is_solid(const murk_source *l)
{
    return l->height_m > 0;
}

static murk_luminous_solid solid_of(const murk_source *l)
{
    return (murk_luminous_solid){.half = {murk_length(l->edge1) / 2,
                                          murk_length(l->edge2) / 2,
                                          l->height_m / 2},
                                 .radius = l->radius_m};
}

/* Vectors from the world to the solid and back. */
static murk_vec3 into(const murk_source *l, murk_vec3 v)
{
    return murk_vec(murk_dot(v, l->c0), murk_dot(v, c90_of(l)),
                    murk_dot(v, l->direction));
}

static murk_vec3 out_of(const murk_source *l, murk_vec3 local)
{
    murk_vec3 v = murk_scale(local.x, l->c0);
    v = murk_along(v, local.y, c90_of(l));
    return murk_along(v, local.z, l->direction);
}

static double area_of(const murk_source *l)
{
    return l->radius_m > 0 ? MURK_PI * l->radius_m * l->radius_m
                           : murk_length(murk_cross(l->edge1, l->edge2));
}

static murk_vec3 point_of(const murk_source *l, const double u[2])
{
    if (l->radius_m > 0) {
        const double rho = l->radius_m * sqrt(u[0]), phi = TWO_PI * u[1];
        return murk_along(murk_along(l->position, rho * cos(phi), l->c0),
                          rho * sin(phi), c90_of(l));
    }
    return murk_along(murk_along(l->position, u[0] - 0.5, l->edge1), u[1] - 0.5,
                      l->edge2);
}

/* The side on which a luminaire in a surface shines: that of the greater part
 * of the flux. */
static murk_vec3 normal(const murk_source *l)
{
    return murk_intensity_points_to_zero(l->intensity)
               ? l->direction
               : murk_scale(-1, l->direction);
}

/* Half of the size of the luminous area or solid along each axis. */
static murk_vec3 reach_of(const murk_source *l)
{
    const murk_vec3 d = murk_unit(l->direction), e = l->edge1, f = l->edge2;
    const double r = l->radius_m, h = l->height_m;
    return murk_vec(r * sqrt(d.y * d.y + d.z * d.z) +
                        0.5 * (fabs(e.x) + fabs(f.x) + h * fabs(d.x)),
                    r * sqrt(d.x * d.x + d.z * d.z) +
                        0.5 * (fabs(e.y) + fabs(f.y) + h * fabs(d.y)),
                    r * sqrt(d.x * d.x + d.y * d.y) +
                        0.5 * (fabs(e.z) + fabs(f.z) + h * fabs(d.z)));
}

static murk_status prepare(murk_source_state *s, murk_error *err)
{
    murk_source *l = &s->light;
    if (!l->intensity) {
        return murk_fail(err, MURK_BAD_VALUE, l->where,
                         "no intensities, must be those of a file");
    }
    if (!(l->radius_m >= 0 && isfinite(l->radius_m))) {
        return murk_fail(err, MURK_BAD_VALUE, l->where,
                         "radius_m is %g m, must be 0 m or more", l->radius_m);
    }
    if (!(l->height_m >= 0 && isfinite(l->height_m))) {
        return murk_fail(err, MURK_BAD_VALUE, l->where,
                         "height_m is %g m, must be 0 m or more", l->height_m);
    }
    const murk_status status = murk_source_prepare_direction(s, err);
    if (status) {
        return status;
    }
    /* Make C = 0 perpendicular to the photometric zero. */
    const murk_vec3 aside =
        murk_along(l->c0, -murk_dot(l->c0, l->direction), l->direction);
    if (!(murk_is_finite(aside) &&
          murk_length(aside) > ALONG * murk_length(l->c0))) {
        return murk_fail(err, MURK_BAD_VALUE, l->where,
                         "c0 is [%g, %g, %g], must not be along the aim",
                         l->c0.x, l->c0.y, l->c0.z);
    }
    l->c0 = murk_unit(aside);
    return murk_source_check_inside(s->domain, l->position, reach_of(l),
                                    "the luminaire", l->where, err);
}

static murk_ray emit(const murk_source_state *s,
                     const double u[MURK_ENTRY_FACES_NUMBERS])
{
    const murk_source *l = &s->light;
    murk_vec3 local = murk_intensity_draw(l->intensity, u[2], u[3]);
    local.z = -local.z; /* the table has photometric zero at -z */
    murk_vec3 origin;
    if (is_solid(l)) {
        const murk_luminous_solid solid = solid_of(l);
        origin = murk_add(l->position,
                          out_of(l, murk_luminous_leave(&solid, local, u)));
    } else {
        origin = point_of(l, u);
    }
    return (murk_ray){.origin = origin,
                      .direction = murk_unit(out_of(l, local))};
}

/* The shine() of a solid: the radiance of a point that the place sees, times
 * its projected area, over the squared distance. */
static bool shine_solid(const murk_source *l, int band, murk_vec3 place,
                        const double u[MURK_SHINE_NUMBERS], murk_shine *shine)
{
    const murk_luminous_solid solid = solid_of(l);
    murk_luminous_point from;
    if (!murk_luminous_draw(&solid, into(l, murk_sub(place, l->position)), u,
                            &from)) {
        return false;
    }
    const murk_vec3 start = murk_add(l->position, out_of(l, from.point));
    const murk_vec3 to_place = murk_sub(place, start);
    shine->distance_m = murk_length(to_place);
    if (!(shine->distance_m > 0)) {
        return false;
    }
    shine->direction = murk_scale(1 / shine->distance_m, to_place);
    shine->face = out_of(l, from.normal);
    /* The area from which the light comes, as the place sees it. */
    const double shown = from.area * murk_dot(shine->face, shine->direction);
    const double square = shine->distance_m * shine->distance_m;
    const double silhouette =
        murk_luminous_silhouette(&solid, into(l, shine->direction));
    if (!(shown > 0 && silhouette > 0)) {
        return false;
    }
    shine->irradiance_w_per_m2 = l->power_w.band[band] *
                                 share_per_sr(l, shine->direction) / square *
                                 shown / silhouette;
    shine->per_sr = square / shown;
    return shine->irradiance_w_per_m2 > 0;
}

static bool shine(const murk_source_state *s, int band, murk_vec3 place,
                  const double u[MURK_SHINE_NUMBERS], murk_shine *shine)
{
    const murk_source *l = &s->light;
    if (is_solid(l)) {
        return shine_solid(l, band, place, u, shine);
    }
    const double area = area_of(l);
    const murk_vec3 to_place = murk_sub(place, point_of(l, u));
    shine->distance_m = murk_length(to_place);
    if (!(shine->distance_m > 0)) {
        return false;
    }
    shine->direction = murk_scale(1 / shine->distance_m, to_place);
    const double cosine = murk_dot(shine->direction, l->direction);
    shine->face = normal(l);
    const double square = shine->distance_m * shine->distance_m;
    shine->irradiance_w_per_m2 =
        l->power_w.band[band] * share_per_sr(l, shine->direction) / square;
    shine->per_sr = area > 0 ? square / (area * fabs(cosine)) : INFINITY;
    return shine->irradiance_w_per_m2 > 0;
}

/* True if a point in the plane of the luminous area, relative to the center,
 * lies in the area. */
static bool is_in_area(const murk_source *l, murk_vec3 aside)
{
    if (l->radius_m > 0) {
        return murk_dot(aside, aside) < l->radius_m * l->radius_m;
    }
    return fabs(murk_dot(aside, l->edge1)) <
               0.5 * murk_dot(l->edge1, l->edge1) &&
           fabs(murk_dot(aside, l->edge2)) < 0.5 * murk_dot(l->edge2, l->edge2);
}

static murk_glare glare_solid(const murk_source *l, int band, murk_vec3 place,
                              murk_vec3 sight)
{
    const murk_luminous_solid solid = solid_of(l);
    const murk_vec3 along = into(l, sight);
    const double silhouette = murk_luminous_silhouette(&solid, along);
    murk_luminous_point at;
    double distance;
    if (!(silhouette > 0) ||
        !murk_luminous_meet(&solid, into(l, murk_sub(place, l->position)),
                            along, &at, &distance)) {
        return (murk_glare){0};
    }
    const double shown = at.area * fabs(murk_dot(at.normal, along));
    return (murk_glare){.radiance = l->power_w.band[band] *
                                    share_per_sr(l, murk_scale(-1, sight)) /
                                    silhouette,
                        .distance_m = distance,
                        .per_sr = distance * distance / shown};
}

static murk_glare glare(const murk_source_state *s, int band, murk_vec3 place,
                        murk_vec3 sight)
{
    const murk_source *l = &s->light;
    if (is_solid(l)) {
        return glare_solid(l, band, place, sight);
    }
    const double area = area_of(l), cosine = murk_dot(sight, l->direction);
    if (!(area > 0) || cosine == 0) {
        return (murk_glare){0};
    }
    const murk_vec3 to = murk_sub(l->position, place);
    const double distance = murk_dot(to, l->direction) / cosine;
    if (!(distance > 0 &&
          is_in_area(l, murk_sub(murk_scale(distance, sight), to)))) {
        return (murk_glare){0};
    }
    const double share = share_per_sr(l, murk_scale(-1, sight));
    return (murk_glare){.radiance = l->power_w.band[band] * share /
                                    (area * fabs(cosine)),
                        .distance_m = distance,
                        .per_sr = distance * distance / (area * fabs(cosine))};
}

static murk_box box(const murk_source *l)
{
    const murk_vec3 reach = reach_of(l);
    return (murk_box){murk_sub(l->position, reach),
                      murk_add(l->position, reach)};
}

static double extent(const murk_source *l)
{
    return l->radius_m +
           0.5 * (murk_length(l->edge1) + murk_length(l->edge2) + l->height_m);
}

static double irradiance_near(const murk_source *l, int band, murk_vec3 to_lamp,
                              bool has_images)
{
    const double d = murk_length(to_lamp), reach = extent(l);
    const double square = fmax(d * d, reach * reach);
    /* An image of the lamp may have any direction. */
    const double share = has_images || !(d > 0)
                             ? 1 / (4 * MURK_PI)
                             : share_per_sr(l, murk_scale(-1 / d, to_lamp));
    return l->power_w.band[band] * share / square;
}

const murk_source_row murk_source_luminaire_row = {
    .prepare = prepare,
    .emit = emit,
    .shine = shine,
    .glare = glare,
    .box = box,
    .extent_m = extent,
    .normal = normal,
    .irradiance_near = irradiance_near,
};
