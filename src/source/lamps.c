/* Lamps: light sources within the domain. One row of functions for each type,
 * at the end of the file.
 *
 * For each type: the check against the domain, the start of a photon from
 * uniform numbers, a sampled direction from which the light reaches a point
 * (shine), and, except for a point, the light along a line of sight (glare).
 * Spheres and rectangles emit by Lambert's cosine law; a point is isotropic; a
 * beam is a disc of parallel rays, or of rays spread evenly over the solid
 * angle of a cone. For shine, rectangles and the discs of divergent beams are
 * sampled by area, and spheres by the solid angle of the visible cone; points
 * and parallel beams have one direction only. */
#include "source/source_state.h"

#include <math.h>

#define TWO_PI (2 * MURK_PI) /* a full turn */

/* The power of a lamp [W]. */
static double power_of(const murk_source *light, int band)
{
    return light->power_w.band[band];
}

/* Sets direction and distance from a point of a lamp. Returns false if the
 * distance is 0. */
static bool come_from(murk_vec3 from, murk_vec3 place, murk_shine *shine)
{
    const murk_vec3 to_place = murk_sub(place, from);
    shine->distance_m = murk_length(to_place);
    shine->direction = murk_scale(1 / shine->distance_m, to_place);
    return shine->distance_m > 0;
}

/* The probability density [1/sr] of the direction from a uniform point of a
 * flat lamp. cosine: of the angle between the direction and the normal. */
static double sheet_per_sr(double area_m2, double distance_m, double cosine)
{
    return distance_m * distance_m / (area_m2 * cosine);
}

static inline murk_vec3 isotropic(double u_mu, double u_phi)
{
    const double mu = 2 * u_mu - 1, phi = TWO_PI * u_phi;
    const double s = sqrt(1 - mu * mu); /* |mu| < 1 */
    return murk_unit(murk_vec(s * cos(phi), s * sin(phi), mu));
}

static murk_vec3 cosine_law(murk_vec3 normal, double u_mu, double u_phi)
{
    return murk_about(normal, sqrt(u_mu), TWO_PI * u_phi);
}

static double radius_of(const murk_source *l)
{
    return l->radius_m;
}

static murk_box ball_box(const murk_source *l)
{
    const murk_vec3 r = {l->radius_m, l->radius_m, l->radius_m};
    return (murk_box){murk_sub(l->position, r), murk_add(l->position, r)};
}

/* ---- sphere ---- */

/* 1 - cos of half the angle under which a sphere appears, for the square of the
 * ratio of radius and distance. */
static double sphere_cone(double sine2)
{
    return sine2 / (1 + sqrt(1 - sine2));
}

static double sphere_radiance(const murk_source *l, int band)
{
    const double r2 = l->radius_m * l->radius_m;
    return power_of(l, band) / (4 * MURK_PI * MURK_PI * r2);
}

static murk_status prepare_sphere(murk_source_state *s, murk_error *err)
{
    const murk_source *l = &s->light;
    const double r = l->radius_m;
    if (!(r > 0 && isfinite(r))) {
        return murk_fail(err, MURK_BAD_VALUE, l->where,
                         "radius_m is %g m, must be above 0 m", r);
    }
    return murk_source_check_inside(s->domain, l->position, murk_vec(r, r, r),
                                    "the lamp", l->where, err);
}

static murk_ray emit_sphere(const murk_source_state *s,
                            const double u[MURK_ENTRY_FACES_NUMBERS])
{
    const murk_source *l = &s->light;
    const murk_vec3 normal = isotropic(u[0], u[1]);
    return (murk_ray){.origin = murk_along(l->position, l->radius_m, normal),
                      .direction = cosine_law(normal, u[2], u[3])};
}

static bool shine_sphere(const murk_source_state *s, int band, murk_vec3 place,
                         const double u[MURK_SHINE_NUMBERS], murk_shine *shine)
{
    const murk_source *l = &s->light;
    const murk_vec3 to = murk_sub(l->position, place);
    const double d2 = murk_dot(to, to), r2 = l->radius_m * l->radius_m;
    if (!(d2 > r2)) {
        return false; /* inside: a sphere emits outwards only */
    }
    const double cone = sphere_cone(r2 / d2);
    const double part = cone * u[0];
    const double distance = sqrt(d2);
    const murk_vec3 sight =
        murk_about(murk_scale(1 / distance, to), 1 - part, TWO_PI * u[1]);
    const double rest = r2 - d2 * part * (2 - part);
    shine->distance_m = distance * (1 - part) - sqrt(fmax(0, rest));
    shine->direction = murk_scale(-1, sight);
    shine->face = murk_unit(
        murk_sub(murk_along(place, shine->distance_m, sight), l->position));
    shine->irradiance_w_per_m2 = sphere_radiance(l, band) * TWO_PI * cone;
    shine->per_sr = 1 / (TWO_PI * cone);
    return true;
}

static murk_glare sphere_glare(const murk_source_state *s, int band,
                               murk_vec3 place, murk_vec3 sight)
{
    const murk_source *l = &s->light;
    const murk_vec3 to = murk_sub(l->position, place);
    const double ahead = murk_dot(to, sight), d2 = murk_dot(to, to);
    const murk_vec3 aside = murk_along(to, -ahead, sight);
    const double r2 = l->radius_m * l->radius_m;
    const double half = r2 - murk_dot(aside, aside);
    const double distance = ahead - sqrt(fmax(0, half));
    if (!(half > 0 && d2 > r2 && distance > 0)) {
        return (murk_glare){0};
    }
    return (murk_glare){.radiance = sphere_radiance(l, band),
                        .distance_m = distance,
                        .per_sr = 1 / (TWO_PI * sphere_cone(r2 / d2))};
}

/* ---- rectangle ---- */

static murk_status prepare_rect(murk_source_state *s, murk_error *err)
{
    const murk_source *l = &s->light;
    const murk_portal sheet = {l->position, l->edge1, l->edge2};
    s->normal = murk_unit(murk_cross(l->edge1, l->edge2));
    return murk_source_check_sheet(&sheet, s->domain, "the lamp's", l->where,
                                   err);
}

static murk_ray emit_rect(const murk_source_state *s,
                          const double u[MURK_ENTRY_FACES_NUMBERS])
{
    const murk_source *l = &s->light;
    const murk_vec3 p = murk_along(l->position, u[0], l->edge1);
    return (murk_ray){.origin = murk_along(p, u[1], l->edge2),
                      .direction = cosine_law(s->normal, u[2], u[3])};
}

static double rect_area(const murk_source *l)
{
    return murk_length(murk_cross(l->edge1, l->edge2));
}

static double rect_radiance(const murk_source *l, int band)
{
    return power_of(l, band) / (MURK_PI * rect_area(l));
}

static bool shine_rect(const murk_source_state *s, int band, murk_vec3 place,
                       const double u[MURK_SHINE_NUMBERS], murk_shine *shine)
{
    const murk_source *l = &s->light;
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
    shine->per_sr = sheet_per_sr(rect_area(l), shine->distance_m, cosine);
    shine->irradiance_w_per_m2 = rect_radiance(l, band) / shine->per_sr;
    return true;
}

static murk_glare rect_glare(const murk_source_state *s, int band,
                             murk_vec3 place, murk_vec3 sight)
{
    const murk_source *l = &s->light;
    const murk_portal sheet = {l->position, l->edge1, l->edge2};
    double ahead_m, cosine;
    /* The light that reaches the point must have started on the rectangle and
     * on the emitting side: the line of travel passes the rectangle towards the
     * emitting side, before the point. */
    if (!murk_source_passes(&sheet, place, murk_scale(-1, sight), &ahead_m,
                            &cosine) ||
        !(ahead_m < 0)) {
        return (murk_glare){0};
    }
    return (murk_glare){.radiance = rect_radiance(l, band),
                        .distance_m = -ahead_m,
                        .per_sr = sheet_per_sr(rect_area(l), ahead_m, cosine)};
}

static murk_box rect_box(const murk_source *l)
{
    return murk_box_of_parallelogram(l->position, l->edge1, l->edge2);
}

static double rect_extent(const murk_source *l)
{
    return 0.5 * (murk_length(l->edge1) + murk_length(l->edge2));
}

static murk_vec3 rect_middle(const murk_source *l)
{
    return murk_along(murk_along(l->position, 0.5, l->edge1), 0.5, l->edge2);
}

static murk_vec3 rect_normal(const murk_source *l)
{
    return murk_unit(murk_cross(l->edge1, l->edge2));
}

static double rect_near(const murk_source *l, int band, murk_vec3 to_lamp,
                        bool has_images)
{
    const double extent = rect_extent(l);
    const double square = fmax(murk_dot(to_lamp, to_lamp), extent * extent);
    const murk_vec3 face = rect_normal(l);
    const double before = -murk_dot(face, to_lamp);
    /* A point in or behind the plane of the lamp gets no light. In a periodic
     * domain an image of the lamp may light the point, unless the lamp is
     * level, so that all images lie in the same plane. */
    if (!(before > 0) && (!has_images || fabs(face.z) == 1)) {
        return 0;
    }
    const double cosine =
        fmin(1, fmax(0, before + 0.5 * extent) / sqrt(square));
    return power_of(l, band) * cosine / (MURK_PI * square);
}

/* ---- beam ---- */

/* A point of the disc of a beam, with the frame t, b of the beam. */
static murk_vec3 disc_point(const murk_source *beam, murk_vec3 t, murk_vec3 b,
                            const double u[2])
{
    const double rho = beam->radius_m * sqrt(u[0]), phi = TWO_PI * u[1];
    return murk_along(murk_along(beam->position, rho * cos(phi), t),
                      rho * sin(phi), b);
}

/* 1 - cos(half angle), with full precision for narrow beams. */
static double cone_of(const murk_source *beam)
{
    const double s = sin(beam->divergence_rad / 2);
    return 2 * s * s;
}

static murk_status prepare_beam(murk_source_state *s, murk_error *err)
{
    const murk_source *l = &s->light;
    const double r = l->radius_m, half = l->divergence_rad;
    if (!(r >= 0 && isfinite(r))) {
        return murk_fail(err, MURK_BAD_VALUE, l->where,
                         "radius_m is %g m, must be 0 m or more", r);
    }
    if (!(half >= 0 && half <= MURK_PI)) {
        return murk_fail(err, MURK_BAD_VALUE, l->where,
                         "divergence is %g rad, must be 0..pi rad", half);
    }
    const murk_status status = murk_source_prepare_direction(s, err);
    if (status) {
        return status;
    }
    /* The disc must lie in the domain; `reach` is half of the size of the disc
     * along each axis. */
    s->cone = cone_of(l);
    const murk_vec3 d = l->direction;
    const murk_vec3 reach = {r * sqrt(d.y * d.y + d.z * d.z),
                             r * sqrt(d.x * d.x + d.z * d.z),
                             r * sqrt(d.x * d.x + d.y * d.y)};
    return murk_source_check_inside(s->domain, l->position, reach,
                                    "the beam's disc", l->where, err);
}

static murk_ray emit_beam(const murk_source_state *s,
                          const double u[MURK_ENTRY_FACES_NUMBERS])
{
    const murk_source *l = &s->light;
    murk_ray ray = {.origin = l->position, .direction = l->direction};
    murk_vec3 t, b;
    murk_frame(l->direction, &t, &b);
    if (l->radius_m > 0) {
        ray.origin = disc_point(l, t, b, u);
    }
    if (s->cone > 0) {
        /* Draw w = 1 - cos(angle to the axis), which keeps full precision in
         * narrow beams. */
        const double w = s->cone * u[2], phi = TWO_PI * u[3];
        const double side = sqrt(fmax(0, w * (2 - w)));
        murk_vec3 d = murk_scale(1 - w, l->direction);
        d = murk_along(d, side * cos(phi), t);
        ray.direction = murk_unit(murk_along(d, side * sin(phi), b));
    }
    return ray;
}

static bool shine_beam(const murk_source_state *s, int band, murk_vec3 place,
                       const double u[MURK_SHINE_NUMBERS], murk_shine *shine)
{
    const murk_source *l = &s->light;
    const double cone = cone_of(l), r = l->radius_m;
    shine->face = l->direction;
    /* A parallel beam: one direction, if the point is in the beam. */
    if (!(cone > 0)) {
        const murk_vec3 to_place = murk_sub(place, l->position);
        const double ahead = murk_dot(to_place, l->direction);
        const murk_vec3 aside = murk_along(to_place, -ahead, l->direction);
        shine->direction = l->direction;
        shine->distance_m = ahead;
        shine->irradiance_w_per_m2 = power_of(l, band) / (MURK_PI * r * r);
        return r > 0 && ahead > 0 && murk_dot(aside, aside) < r * r;
    }
    /* A divergent beam: sample the disc, uniformly. */
    murk_vec3 t, b;
    murk_frame(l->direction, &t, &b);
    if (!come_from(disc_point(l, t, b, u), place, shine)) {
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

/* The light of a divergent beam along a line of sight. Power is uniform over
 * the solid angle of the cone, so the radiance grows with 1 / cosine. Radiance
 * 0: the beam is parallel or has no width, or the line of sight does not meet
 * the disc within the cone. */
static murk_glare beam_glare(const murk_source_state *s, int band,
                             murk_vec3 place, murk_vec3 sight)
{
    const murk_source *l = &s->light;
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

static bool beam_can_shine(const murk_source *l)
{
    return l->radius_m > 0 || l->divergence_rad > 0;
}

static double beam_near(const murk_source *l, int band, murk_vec3 to_lamp,
                        bool has_images)
{
    (void)has_images;
    const double ahead = -murk_dot(l->direction, to_lamp);
    const double aside2 = fmax(0, murk_dot(to_lamp, to_lamp) - ahead * ahead);
    const double radius =
        l->radius_m + fmax(0, ahead) * tan(fmin(1.5, l->divergence_rad));
    return ahead > 0 && aside2 < radius * radius && radius > 0
               ? power_of(l, band) / (MURK_PI * radius * radius)
               : 0;
}

/* ---- point ---- */

static murk_status prepare_point(murk_source_state *s, murk_error *err)
{
    const murk_vec3 none = {0, 0, 0};
    s->light.radius_m = 0; /* a sphere without an extent */
    return murk_source_check_inside(s->domain, s->light.position, none,
                                    "the lamp", s->light.where, err);
}

static murk_ray emit_point(const murk_source_state *s,
                           const double u[MURK_ENTRY_FACES_NUMBERS])
{
    return (murk_ray){.origin = s->light.position,
                      .direction = isotropic(u[0], u[1])};
}

static bool shine_point(const murk_source_state *s, int band, murk_vec3 place,
                        const double u[MURK_SHINE_NUMBERS], murk_shine *shine)
{
    (void)u;
    const murk_source *l = &s->light;
    if (!come_from(l->position, place, shine)) {
        return false;
    }
    shine->face = shine->direction;
    shine->irradiance_w_per_m2 =
        power_of(l, band) /
        (4 * MURK_PI * shine->distance_m * shine->distance_m);
    return true;
}

/* ---- the rows ---- */

const murk_source_row murk_source_lamp_rows[] = {
    [MURK_SOURCE_SPHERE] = {.prepare = prepare_sphere,
                            .emit = emit_sphere,
                            .shine = shine_sphere,
                            .glare = sphere_glare,
                            .box = ball_box,
                            .extent_m = radius_of},
    [MURK_SOURCE_RECT] = {.prepare = prepare_rect,
                          .emit = emit_rect,
                          .shine = shine_rect,
                          .glare = rect_glare,
                          .box = rect_box,
                          .extent_m = rect_extent,
                          .middle = rect_middle,
                          .normal = rect_normal,
                          .irradiance_near = rect_near},
    [MURK_SOURCE_POINT] = {.prepare = prepare_point,
                           .emit = emit_point,
                           .shine = shine_point,
                           .box = ball_box,
                           .extent_m = radius_of},
    [MURK_SOURCE_BEAM] = {.prepare = prepare_beam,
                          .emit = emit_beam,
                          .shine = shine_beam,
                          .glare = beam_glare,
                          .can_shine = beam_can_shine,
                          .box = ball_box,
                          .extent_m = radius_of,
                          .irradiance_near = beam_near},
};
