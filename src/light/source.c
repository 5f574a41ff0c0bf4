#include "light/source.h"

#include <float.h>

#define TWO_PI (2 * MURK_PI)

/* A lamp may touch the domain's faces: sums of coordinates there may be off by
 * a few roundings of the largest. */
#define TOUCH_ROUNDINGS 4

/* A cross product is off by some roundings of |a||b|: a shorter one says
 * nothing of where the rectangle faces. */
#define CROSS_ROUNDINGS 8

/* The negated comparisons also refuse NaN. */
static murk_status check_power(const murk_light *l, size_t bands,
                               murk_error *err)
{
    const bool distant = l->type == MURK_LIGHT_DIRECTIONAL;
    const char *name = distant ? "irradiance_w_per_m2" : "power_w";
    const char *unit = distant ? "W/m2" : "W";
    bool shines = false;
    for (size_t b = 0; b < bands; ++b) {
        const double power = l->power_w.band[b];
        if (!(power >= 0 && isfinite(power))) {
            return murk_fail(err, MURK_BAD_VALUE, l->where,
                             "%s is %g %s in band %zu, must be 0 %s or more",
                             name, power, unit, b, unit);
        }
        shines = shines || power > 0;
    }
    if (!shines) {
        return murk_fail(err, MURK_BAD_VALUE, l->where,
                         "%s is 0 %s in every band, must be above 0 %s in one",
                         name, unit, unit);
    }
    return MURK_OK;
}

static double largest_of(murk_vec3 v)
{
    return fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
}

/* Refuses a point, grown by `reach` along each axis, that is not inside. */
static murk_status check_inside(const murk_domain *domain, murk_vec3 p,
                                murk_vec3 reach, const char *what,
                                const char *where, murk_error *err)
{
    const murk_box *box = &domain->box;
    const double touch = TOUCH_ROUNDINGS * DBL_EPSILON *
                         fmax(largest_of(box->min), largest_of(box->max));
    if (p.x - reach.x >= box->min.x - touch &&
        p.y - reach.y >= box->min.y - touch &&
        p.z - reach.z >= box->min.z - touch &&
        p.x + reach.x <= box->max.x + touch &&
        p.y + reach.y <= box->max.y + touch &&
        p.z + reach.z <= box->max.z + touch) {
        return MURK_OK;
    }
    return murk_fail(
        err, MURK_BAD_VALUE, where,
        "%s at [%g, %g, %g] m %s the domain [%g, %g, %g] .. "
        "[%g, %g, %g] m, must be inside",
        what, p.x, p.y, p.z,
        murk_box_contains(box, p) ? "reaches out of" : "is outside", box->min.x,
        box->min.y, box->min.z, box->max.x, box->max.y, box->max.z);
}

static murk_status prepare_direction(murk_source *s, murk_error *err)
{
    const murk_vec3 d = s->light.direction;
    const double size = largest_of(d);
    if (!(murk_is_finite(d) && size > 0)) {
        return murk_fail(err, MURK_BAD_VALUE, s->light.where,
                         "direction is [%g, %g, %g], must be finite and not "
                         "zero",
                         d.x, d.y, d.z);
    }
    s->light.direction =
        murk_unit(murk_vec(d.x / size, d.y / size, d.z / size));
    return MURK_OK;
}

static murk_status prepare_sphere(murk_source *s, const murk_domain *domain,
                                  murk_error *err)
{
    const murk_light *l = &s->light;
    const double r = l->radius_m;
    if (!(r > 0 && isfinite(r))) {
        return murk_fail(err, MURK_BAD_VALUE, l->where,
                         "radius_m is %g m, must be above 0 m", r);
    }
    return check_inside(domain, l->position, murk_vec(r, r, r), "the lamp",
                        l->where, err);
}

static murk_status prepare_rect(murk_source *s, const murk_domain *domain,
                                murk_error *err)
{
    const murk_light *l = &s->light;
    const murk_vec3 normal = murk_cross(l->edge1, l->edge2);
    const double least = CROSS_ROUNDINGS * DBL_EPSILON * murk_length(l->edge1) *
                         murk_length(l->edge2);
    if (!(murk_length(normal) > least)) {
        return murk_fail(err, MURK_BAD_VALUE, l->where,
                         "edge1_m [%g, %g, %g] and edge2_m [%g, %g, %g] span "
                         "no area, must not be zero or parallel",
                         l->edge1.x, l->edge1.y, l->edge1.z, l->edge2.x,
                         l->edge2.y, l->edge2.z);
    }
    s->normal = murk_unit(normal);
    const murk_vec3 none = {0, 0, 0};
    for (int corner = 0; corner < 4; ++corner) {
        murk_vec3 p = murk_along(l->position, corner % 2, l->edge1);
        p = murk_along(p, corner / 2, l->edge2);
        const murk_status status =
            check_inside(domain, p, none, "the lamp's corner", l->where, err);
        if (status) {
            return status;
        }
    }
    return MURK_OK;
}

static murk_status prepare_beam(murk_source *s, const murk_domain *domain,
                                murk_error *err)
{
    const murk_light *l = &s->light;
    const double r = l->radius_m, half = l->divergence_rad;
    if (!(r >= 0 && isfinite(r))) {
        return murk_fail(err, MURK_BAD_VALUE, l->where,
                         "radius_m is %g m, must be 0 m or more", r);
    }
    if (!(half >= 0 && half <= MURK_PI)) {
        return murk_fail(err, MURK_BAD_VALUE, l->where,
                         "divergence is %g rad, must be 0..pi rad", half);
    }
    const murk_status status = prepare_direction(s, err);
    if (status) {
        return status;
    }
    s->cone = 2 * sin(half / 2) * sin(half / 2);
    const murk_vec3 d = l->direction;
    const murk_vec3 reach = {r * sqrt(d.y * d.y + d.z * d.z),
                             r * sqrt(d.x * d.x + d.z * d.z),
                             r * sqrt(d.x * d.x + d.y * d.y)};
    return check_inside(domain, l->position, reach, "the beam's disc", l->where,
                        err);
}

/* Shares of the faces across x, y and z in the light that enters, and its
 * power for 1 W/m2. */
static murk_status prepare_directional(murk_source *s,
                                       const murk_domain *domain,
                                       double *area_m2, murk_error *err)
{
    const murk_status status = prepare_direction(s, err);
    if (status) {
        return status;
    }
    const murk_vec3 d = s->light.direction;
    const murk_vec3 size = murk_sub(domain->box.max, domain->box.min);
    double face[3] = {fabs(d.x) * size.y * size.z, fabs(d.y) * size.z * size.x,
                      fabs(d.z) * size.x * size.y};
    if (domain->is_periodic) {
        if (!(d.z < 0)) {
            return murk_fail(err, MURK_BAD_VALUE, s->light.where,
                             "direction is [%g, %g, %g], must go down: light "
                             "enters a periodic domain through its top only",
                             d.x, d.y, d.z);
        }
        face[0] = face[1] = 0;
    }
    *area_m2 = face[0] + face[1] + face[2];
    s->face_end[0] = face[0] / *area_m2;
    s->face_end[1] = (face[0] + face[1]) / *area_m2;
    s->face_end[2] = 1;
    return MURK_OK;
}

static murk_status prepare(murk_source *s, const murk_domain *domain,
                           double *power_scale, murk_error *err)
{
    const murk_vec3 none = {0, 0, 0};
    *power_scale = 1;
    switch (s->light.type) {
    case MURK_LIGHT_SPHERE:
        return prepare_sphere(s, domain, err);
    case MURK_LIGHT_RECT:
        return prepare_rect(s, domain, err);
    case MURK_LIGHT_BEAM:
        return prepare_beam(s, domain, err);
    case MURK_LIGHT_DIRECTIONAL:
        return prepare_directional(s, domain, power_scale, err);
    case MURK_LIGHT_POINT:
        break;
    }
    return check_inside(domain, s->light.position, none, "the lamp",
                        s->light.where, err);
}

murk_status murk_source_prepare(murk_source *s, size_t bands,
                                const murk_domain *domain, double *power_scale,
                                murk_error *err)
{
    const murk_status status = check_power(&s->light, bands, err);
    return status ? status : prepare(s, domain, power_scale, err);
}

static double held(double x, double least, double most)
{
    return x < least ? least : x > most ? most : x;
}

/* A lamp that touches the domain's face must not, by rounding, start its
 * photons behind it. */
static murk_vec3 inside(const murk_box *box, murk_vec3 p)
{
    return murk_vec(held(p.x, box->min.x, box->max.x),
                    held(p.y, box->min.y, box->max.y),
                    held(p.z, box->min.z, box->max.z));
}

static murk_vec3 isotropic(double u_mu, double u_phi)
{
    const double mu = 2 * u_mu - 1, phi = TWO_PI * u_phi;
    const double s = sqrt(fmax(0, 1 - mu * mu));
    return murk_unit(murk_vec(s * cos(phi), s * sin(phi), mu));
}

static murk_vec3 cosine_law(murk_vec3 normal, double u_mu, double u_phi)
{
    return murk_about(normal, sqrt(u_mu), TWO_PI * u_phi);
}

static murk_ray emit_beam(const murk_source *s, const double u[4])
{
    const murk_light *l = &s->light;
    murk_ray ray = {l->position, l->direction};
    murk_vec3 t, b;
    murk_frame(l->direction, &t, &b);
    if (l->radius_m > 0) {
        const double rho = l->radius_m * sqrt(u[0]), phi = TWO_PI * u[1];
        ray.origin = murk_along(ray.origin, rho * cos(phi), t);
        ray.origin = murk_along(ray.origin, rho * sin(phi), b);
    }
    if (s->cone > 0) {
        /* By 1 - cos(angle), which keeps its digits in narrow beams. */
        const double w = s->cone * u[2], phi = TWO_PI * u[3];
        const double side = sqrt(fmax(0, w * (2 - w)));
        murk_vec3 d = murk_scale(1 - w, l->direction);
        d = murk_along(d, side * cos(phi), t);
        ray.direction = murk_unit(murk_along(d, side * sin(phi), b));
    }
    return ray;
}

static murk_ray emit_directional(const murk_source *s, const murk_box *box,
                                 const double u[4])
{
    const murk_vec3 d = s->light.direction;
    murk_vec3 p = {box->min.x + u[1] * (box->max.x - box->min.x),
                   box->min.y + u[2] * (box->max.y - box->min.y),
                   box->min.z + u[3] * (box->max.z - box->min.z)};
    if (u[0] < s->face_end[0]) {
        p.x = d.x > 0 ? box->min.x : box->max.x;
    } else if (u[0] < s->face_end[1]) {
        p.y = d.y > 0 ? box->min.y : box->max.y;
    } else {
        p.z = d.z > 0 ? box->min.z : box->max.z;
    }
    return (murk_ray){p, d};
}

static murk_ray start_of(const murk_source *s, const murk_box *box,
                         const double u[4])
{
    const murk_light *l = &s->light;
    switch (l->type) {
    case MURK_LIGHT_SPHERE: {
        const murk_vec3 normal = isotropic(u[0], u[1]);
        return (murk_ray){murk_along(l->position, l->radius_m, normal),
                          cosine_law(normal, u[2], u[3])};
    }
    case MURK_LIGHT_RECT: {
        const murk_vec3 p = murk_along(l->position, u[0], l->edge1);
        return (murk_ray){murk_along(p, u[1], l->edge2),
                          cosine_law(s->normal, u[2], u[3])};
    }
    case MURK_LIGHT_BEAM:
        return emit_beam(s, u);
    case MURK_LIGHT_DIRECTIONAL:
        return emit_directional(s, box, u);
    case MURK_LIGHT_POINT:
        break;
    }
    return (murk_ray){l->position, isotropic(u[0], u[1])};
}

murk_ray murk_source_emit(const murk_source *s, const murk_box *box,
                          const double u[4])
{
    murk_ray ray = start_of(s, box, u);
    ray.origin = inside(box, ray.origin);
    return ray;
}
