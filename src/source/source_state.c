#include "source/source_state.h"

#include "base/position.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>

#define TWO_PI (2 * MURK_PI)

/* A lamp may touch the domain's faces: sums of coordinates there may be off by
 * a few roundings of the largest. */
#define TOUCH_ROUNDINGS 4

/* A cross product is off by some roundings of |a||b|: a shorter one says
 * nothing of where the rectangle faces. */
#define CROSS_ROUNDINGS 8

/* The negated comparisons also refuse NaN. */
static murk_status check_power(const murk_source *l, size_t bands,
                               murk_error *err)
{
    const bool distant = murk_source_is_distant(l);
    const char *name = distant ? "irradiance_w_per_m2" : "power_w";
    const char *unit = distant ? "W/m2" : "W";
    for (size_t b = 0; b < bands; ++b) {
        const double power = l->power_w.band[b];
        if (!(power >= 0 && isfinite(power))) {
            return murk_fail(err, MURK_BAD_VALUE, l->where,
                             "%s is %g %s in band %zu, must be 0 %s or more",
                             name, power, unit, b, unit);
        }
    }
    return MURK_OK;
}

static bool is_dark(const murk_source *l, size_t bands)
{
    for (size_t b = 0; b < bands; ++b) {
        if (l->power_w.band[b] > 0) {
            return false;
        }
    }
    return true;
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
        "%s at %s m %s the domain %s .. %s m, must be inside", what,
        murk_position_show(p).text,
        murk_box_contains(box, p) ? "reaches out of" : "is outside",
        murk_position_show(box->min).text, murk_position_show(box->max).text);
}

static murk_status prepare_direction(murk_source_state *s, murk_error *err)
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

static murk_status prepare_sphere(murk_source_state *s,
                                  const murk_domain *domain, murk_error *err)
{
    const murk_source *l = &s->light;
    const double r = l->radius_m;
    if (!(r > 0 && isfinite(r))) {
        return murk_fail(err, MURK_BAD_VALUE, l->where,
                         "radius_m is %g m, must be above 0 m", r);
    }
    return check_inside(domain, l->position, murk_vec(r, r, r), "the lamp",
                        l->where, err);
}

/* A parallelogram of a lamp or a portal; what: "the lamp's". */
static murk_status check_sheet(const murk_portal *sheet,
                               const murk_domain *domain, const char *what,
                               const char *where, murk_error *err)
{
    const murk_vec3 e = sheet->edge1, f = sheet->edge2;
    const double minimum =
        CROSS_ROUNDINGS * DBL_EPSILON * murk_length(e) * murk_length(f);
    if (!(murk_length(murk_cross(e, f)) > minimum)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "%s edge1_m [%g, %g, %g] and edge2_m [%g, %g, %g] "
                         "span no area, must not be zero or parallel",
                         what, e.x, e.y, e.z, f.x, f.y, f.z);
    }
    const murk_vec3 none = {0, 0, 0};
    char corner_of[64];
    snprintf(corner_of, sizeof corner_of, "%s corner", what);
    for (int corner = 0; corner < 4; ++corner) {
        murk_vec3 p = murk_along(sheet->corner, corner % 2, e);
        p = murk_along(p, corner / 2, f);
        const murk_status status =
            check_inside(domain, p, none, corner_of, where, err);
        if (status) {
            return status;
        }
    }
    return MURK_OK;
}

static murk_status prepare_rect(murk_source_state *s, const murk_domain *domain,
                                murk_error *err)
{
    const murk_source *l = &s->light;
    const murk_portal sheet = {l->position, l->edge1, l->edge2};
    s->normal = murk_unit(murk_cross(l->edge1, l->edge2));
    return check_sheet(&sheet, domain, "the lamp's", l->where, err);
}

static murk_status prepare_beam(murk_source_state *s, const murk_domain *domain,
                                murk_error *err)
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

static murk_status check_portals(const murk_source *l,
                                 const murk_domain *domain, murk_error *err)
{
    if (l->portals > MURK_PORTALS_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, l->where,
                         "%zu portals, must be %d or less", l->portals,
                         MURK_PORTALS_MAX);
    }
    if (l->portals > 0 && domain->is_periodic) {
        return murk_fail(err, MURK_BAD_VALUE, l->where,
                         "aimed at portals in a periodic domain, which light "
                         "enters through its top only; its sides must be open");
    }
    for (size_t i = 0; i < l->portals; ++i) {
        char what[32];
        snprintf(what, sizeof what, "portal %zu:", i);
        const murk_status status =
            check_sheet(&l->portal[i], domain, what, l->where, err);
        if (status) {
            return status;
        }
    }
    return MURK_OK;
}

/* Shares of the faces across x, y and z in the light that enters; returns its
 * power for 1 W/m2. */
static double share_faces(murk_source_state *s, const murk_domain *domain)
{
    const murk_vec3 d = s->light.direction;
    const murk_vec3 size = murk_sub(domain->box.max, domain->box.min);
    double face[3] = {fabs(d.x) * size.y * size.z, fabs(d.y) * size.z * size.x,
                      fabs(d.z) * size.x * size.y};
    if (domain->is_periodic) {
        face[0] = face[1] = 0;
    }
    const double area_m2 = face[0] + face[1] + face[2];
    s->face_end[0] = face[0] / area_m2;
    s->face_end[1] = (face[0] + face[1]) / area_m2;
    s->face_end[2] = 1;
    return area_m2;
}

static murk_status open_up(murk_source_state *s, const murk_domain *domain,
                           double *area_m2, murk_error *err)
{
    const murk_status status =
        murk_entry_faces_create(&s->entry_faces, &s->light, domain, err);
    if (!status) {
        *area_m2 = murk_entry_faces_area_m2(s->entry_faces);
    }
    return status;
}

static murk_status prepare_directional(murk_source_state *s,
                                       const murk_domain *domain, bool dark,
                                       double *area_m2, murk_error *err)
{
    const double radius = s->light.angular_radius_rad;
    murk_status status = prepare_direction(s, err);
    if (!status && !(radius >= 0 && radius <= MURK_DISC_RAD_MAX)) {
        status = murk_fail(err, MURK_BAD_VALUE, s->light.where,
                           "angular radius is %g rad, must be 0..%g rad",
                           radius, MURK_DISC_RAD_MAX);
    }
    const murk_vec3 d = s->light.direction;
    if (!status && domain->is_periodic && !dark && !(d.z < 0)) {
        status = murk_fail(err, MURK_BAD_VALUE, s->light.where,
                           "direction is [%g, %g, %g], must go down: light "
                           "enters a periodic domain through its top only",
                           d.x, d.y, d.z);
    }
    if (!status && (radius > 0 || s->light.portals > 0)) {
        status = open_up(s, domain, area_m2, err);
    } else if (!status) {
        *area_m2 = share_faces(s, domain);
    }
    return status;
}

static murk_status prepare_dome(murk_source_state *s, const murk_domain *domain,
                                double *area_m2, murk_error *err)
{
    const murk_dome *dome = &s->light.dome;
    const double k[] = {dome->a, dome->b, dome->c, dome->d, dome->e};
    for (size_t i = 0; i < sizeof k / sizeof *k; ++i) {
        if (!isfinite(k[i])) {
            return murk_fail(err, MURK_BAD_VALUE, s->light.where,
                             "coefficient %c of the sky is %g, must be finite",
                             "abcde"[i], k[i]);
        }
    }
    const murk_vec3 sun = dome->towards;
    if ((dome->c != 0 || dome->e != 0) &&
        !(murk_is_finite(sun) && largest_of(sun) > 0)) {
        return murk_fail(err, MURK_BAD_VALUE, s->light.where,
                         "towards is [%g, %g, %g], must be finite and not "
                         "zero: this sky is brightest about the sun",
                         sun.x, sun.y, sun.z);
    }
    return open_up(s, domain, area_m2, err);
}

static murk_status prepare(murk_source_state *s, const murk_domain *domain,
                           bool dark, double *power_scale, murk_error *err)
{
    const murk_vec3 none = {0, 0, 0};
    *power_scale = 1;
    switch (s->light.type) {
    case MURK_SOURCE_SPHERE:
        return prepare_sphere(s, domain, err);
    case MURK_SOURCE_RECT:
        return prepare_rect(s, domain, err);
    case MURK_SOURCE_BEAM:
        return prepare_beam(s, domain, err);
    case MURK_SOURCE_DIRECTIONAL:
        return prepare_directional(s, domain, dark, power_scale, err);
    case MURK_SOURCE_DOME:
        return prepare_dome(s, domain, power_scale, err);
    case MURK_SOURCE_POINT:
        break;
    }
    return check_inside(domain, s->light.position, none, "the lamp",
                        s->light.where, err);
}

murk_status murk_source_state_prepare(murk_source_state *s, size_t bands,
                                      const murk_domain *domain,
                                      double *power_scale, murk_error *err)
{
    murk_status status = check_power(&s->light, bands, err);
    if (!status && murk_source_is_distant(&s->light)) {
        status = check_portals(&s->light, domain, err);
    }
    const bool dark = is_dark(&s->light, bands);
    return status ? status : prepare(s, domain, dark, power_scale, err);
}

void murk_source_state_release(murk_source_state *s)
{
    free((char *)(uintptr_t)s->light.where);
    free((murk_portal *)(uintptr_t)s->light.portal);
    murk_entry_faces_destroy(s->entry_faces);
}

static double held(double x, double minimum, double maximum)
{
    return x < minimum ? minimum : x > maximum ? maximum : x;
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

static murk_ray emit_beam(const murk_source_state *s, const double u[4])
{
    const murk_source *l = &s->light;
    murk_ray ray = {.origin = l->position, .direction = l->direction};
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

static murk_ray emit_directional(const murk_source_state *s,
                                 const murk_box *box, const double u[4])
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
    return (murk_ray){.origin = p, .direction = d};
}

static murk_ray start_of(const murk_source_state *s, const murk_box *box,
                         const double u[MURK_ENTRY_FACES_NUMBERS])
{
    const murk_source *l = &s->light;
    switch (l->type) {
    case MURK_SOURCE_SPHERE: {
        const murk_vec3 normal = isotropic(u[0], u[1]);
        return (murk_ray){.origin =
                              murk_along(l->position, l->radius_m, normal),
                          .direction = cosine_law(normal, u[2], u[3])};
    }
    case MURK_SOURCE_RECT: {
        const murk_vec3 p = murk_along(l->position, u[0], l->edge1);
        return (murk_ray){.origin = murk_along(p, u[1], l->edge2),
                          .direction = cosine_law(s->normal, u[2], u[3])};
    }
    case MURK_SOURCE_BEAM:
        return emit_beam(s, u);
    case MURK_SOURCE_DIRECTIONAL:
        return s->entry_faces ? murk_entry_faces_emit(s->entry_faces, u)
                              : emit_directional(s, box, u);
    case MURK_SOURCE_DOME:
        return murk_entry_faces_emit(s->entry_faces, u);
    case MURK_SOURCE_POINT:
        break;
    }
    return (murk_ray){.origin = l->position,
                      .direction = isotropic(u[0], u[1])};
}

murk_ray murk_source_state_emit(const murk_source_state *s, const murk_box *box,
                                const double u[MURK_ENTRY_FACES_NUMBERS])
{
    murk_ray ray = start_of(s, box, u);
    ray.origin = inside(box, ray.origin);
    return ray;
}
