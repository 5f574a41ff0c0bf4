/* Distant light: parallel rays, the disc of sun or moon, and the sky.
 *
 * Distant light enters the domain through the faces of the domain, or through
 * the portals at which it is aimed (source/entry_faces.h). There are two rows
 * of functions, one for parallel rays and discs and one for the sky. Each has
 * the check against the domain, the start of a photon, a sampled direction from
 * which the light reaches a point (shine), and the light along a line of sight
 * (glare). For shine, a disc is sampled by area and the sky by solid angle; for
 * a sky that is aimed at portals, a point of a portal is sampled by area. */
#include "source/source_state.h"

#include <math.h>
#include <stdio.h>

#include "source/entry_faces.h"
#include "source/patch_table.h"

#define TWO_PI (2 * MURK_PI) /* a full turn */

/* The irradiance [W/m2]. */
static double power_of(const murk_source *light, int band)
{
    return light->power_w.band[band];
}

/* ---- portals ---- */

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
            murk_source_check_sheet(&l->portal[i], domain, what, l->where, err);
        if (status) {
            return status;
        }
    }
    return MURK_OK;
}

/* True if distant light may arrive at `place` in the direction `travel`: if the
 * line through `place` passes a portal inward, on either side of `place`, or if
 * there are no portals. */
static bool enters(const murk_source *light, murk_vec3 place, murk_vec3 travel)
{
    double ahead_m, cosine;
    for (size_t i = 0; i < light->portals; ++i) {
        if (murk_source_passes(&light->portal[i], place, travel, &ahead_m,
                               &cosine)) {
            return true;
        }
    }
    return light->portals == 0;
}

/* The probability density [1/sr] with which sample_portal() draws the direction
 * `travel`. */
static double portals_per_sr(const murk_source *l, murk_vec3 place,
                             murk_vec3 travel)
{
    double per_sr = 0;
    for (size_t i = 0; i < l->portals; ++i) {
        const murk_portal *p = &l->portal[i];
        double ahead_m, cosine;
        if (murk_source_passes(p, place, travel, &ahead_m, &cosine)) {
            const double area = murk_length(murk_cross(p->edge1, p->edge2));
            per_sr += ahead_m * ahead_m / (area * cosine * (double)l->portals);
        }
    }
    return per_sr;
}

/* Draws a direction through a uniform point of a portal that is drawn with
 * equal probability. Returns false if `place` lies in the plane of that portal,
 * or if the density of the direction is 0 by rounding. */
static bool sample_portal(const murk_source *l, murk_vec3 place,
                          const double u[MURK_SHINE_NUMBERS], murk_shine *shine)
{
    const size_t drawn = (size_t)(u[2] * (double)l->portals);
    const murk_portal *k = &l->portal[drawn < l->portals ? drawn : 0];
    murk_vec3 on = murk_along(k->corner, u[0], k->edge1);
    on = murk_along(on, u[1], k->edge2);
    const murk_vec3 to_place = murk_sub(place, on);
    const double length = murk_length(to_place);
    const double side = murk_dot(to_place, murk_cross(k->edge1, k->edge2));
    if (!(length > 0) || side == 0) {
        return false;
    }
    shine->direction = murk_scale((side > 0 ? 1 : -1) / length, to_place);
    shine->per_sr = portals_per_sr(l, place, shine->direction);
    return shine->per_sr > 0;
}

/* ---- parallel light and discs ---- */

/* Computes s->face_end: the cumulative shares of the faces across x, y and z in
 * the parallel light that enters. A periodic domain is entered through the top
 * only. Returns the power [W] for an irradiance of 1 W/m2. */
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

static murk_status create_entry_faces(murk_source_state *s, murk_error *err)
{
    const murk_status status =
        murk_entry_faces_create(&s->entry_faces, &s->light, s->domain, err);
    if (!status) {
        s->power_scale = murk_entry_faces_area_m2(s->entry_faces);
    }
    return status;
}

static murk_status prepare_directional(murk_source_state *s, murk_error *err)
{
    /* Check portals, direction and angular radius; in a periodic domain, light
     * with power must go down. */
    const double radius = s->light.angular_radius_rad;
    murk_status status = check_portals(&s->light, s->domain, err);
    if (!status) {
        status = murk_source_prepare_direction(s, err);
    }
    if (!status && !(radius >= 0 && radius <= MURK_DISC_RAD_MAX)) {
        status = murk_fail(err, MURK_BAD_VALUE, s->light.where,
                           "angular radius is %g rad, must be 0..%g rad",
                           radius, MURK_DISC_RAD_MAX);
    }
    const murk_vec3 d = s->light.direction;
    if (!status && s->domain->is_periodic && !s->is_dark && !(d.z < 0)) {
        status = murk_fail(err, MURK_BAD_VALUE, s->light.where,
                           "direction is [%g, %g, %g], must go down: light "
                           "enters a periodic domain through its top only",
                           d.x, d.y, d.z);
    }
    /* Parallel light that is not aimed at portals needs no entry faces. */
    if (!status && (radius > 0 || s->light.portals > 0)) {
        status = create_entry_faces(s, err);
    } else if (!status) {
        s->power_scale = share_faces(s, s->domain);
    }
    return status;
}

static murk_ray emit_directional(const murk_source_state *s,
                                 const double u[MURK_ENTRY_FACES_NUMBERS])
{
    if (s->entry_faces) {
        return murk_entry_faces_emit(s->entry_faces, u);
    }
    const murk_vec3 d = s->light.direction;
    const murk_box *box = &s->domain->box;
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

static double disc_per_sr(const murk_source *l, double cosine)
{
    const double radius = tan(l->angular_radius_rad);
    return 1 / (MURK_PI * radius * radius * cosine * cosine * cosine);
}

static bool shine_directional(const murk_source_state *s, int band,
                              murk_vec3 place,
                              const double u[MURK_SHINE_NUMBERS],
                              murk_shine *shine)
{
    const murk_source *l = &s->light;
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

static murk_glare disc_glare(const murk_source_state *s, int band,
                             murk_vec3 place, murk_vec3 sight)
{
    const murk_source *l = &s->light;
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

/* ---- the sky ---- */

static murk_status prepare_dome(murk_source_state *s, murk_error *err)
{
    const murk_status status = check_portals(&s->light, s->domain, err);
    if (status) {
        return status;
    }
    /* Check the numbers of the sky. */
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
        !(murk_is_finite(sun) && (sun.x != 0 || sun.y != 0 || sun.z != 0))) {
        return murk_fail(err, MURK_BAD_VALUE, s->light.where,
                         "towards is [%g, %g, %g], must be finite and not "
                         "zero: this sky is brightest about the sun",
                         sun.x, sun.y, sun.z);
    }
    return create_entry_faces(s, err);
}

static murk_ray emit_dome(const murk_source_state *s,
                          const double u[MURK_ENTRY_FACES_NUMBERS])
{
    return murk_entry_faces_emit(s->entry_faces, u);
}

static double sky_radiance(const murk_source_state *s, int band,
                           murk_vec3 sight)
{
    const murk_source *l = &s->light;
    murk_dome dome = l->dome;
    if (dome.c != 0 || dome.e != 0) {
        dome.towards = murk_unit(dome.towards);
    }
    return power_of(l, band) * murk_dome_radiance(&dome, sight) /
           murk_entry_faces_level(s->entry_faces);
}

static double sky_per_sr(const murk_source *l, murk_vec3 place,
                         murk_vec3 travel)
{
    const murk_sky_patch *patch = &l->dome.patch;
    return l->portals > 0    ? portals_per_sr(l, place, travel)
           : patch->high > 0 ? 1 / murk_sky_patch_sr(patch)
                             : 1 / TWO_PI;
}

static bool shine_sky(const murk_source_state *s, int band, murk_vec3 place,
                      const double u[MURK_SHINE_NUMBERS], murk_shine *shine)
{
    const murk_source *l = &s->light;
    if (l->portals > 0) {
        if (!sample_portal(l, place, u, shine)) {
            return false;
        }
    } else if (l->dome.patch.high > 0) {
        shine->direction =
            murk_scale(-1, murk_sky_patch_at(&l->dome.patch, u[0], u[1]));
        shine->per_sr = 1 / murk_sky_patch_sr(&l->dome.patch);
    } else {
        const double side = sqrt((1 - u[0]) * (1 + u[0])), phi = TWO_PI * u[1];
        shine->direction = murk_vec(-side * cos(phi), -side * sin(phi), -u[0]);
        shine->per_sr = 1 / TWO_PI;
    }
    shine->irradiance_w_per_m2 =
        sky_radiance(s, band, murk_scale(-1, shine->direction)) / shine->per_sr;
    return shine->irradiance_w_per_m2 > 0;
}

static murk_glare sky_glare(const murk_source_state *s, int band,
                            murk_vec3 place, murk_vec3 sight)
{
    const murk_source *l = &s->light;
    const murk_vec3 travel = murk_scale(-1, sight);
    if (!(sight.z >= 0) || !enters(l, place, travel)) {
        return (murk_glare){0};
    }
    return (murk_glare){.radiance = sky_radiance(s, band, sight),
                        .distance_m = INFINITY,
                        .per_sr = sky_per_sr(l, place, travel)};
}

/* ---- the rows ---- */

const murk_source_row *murk_source_distant_row(const murk_source *light)
{
    static const murk_source_row disc = {.prepare = prepare_directional,
                                         .emit = emit_directional,
                                         .shine = shine_directional,
                                         .glare = disc_glare};
    static const murk_source_row dome = {.prepare = prepare_dome,
                                         .emit = emit_dome,
                                         .shine = shine_sky,
                                         .glare = sky_glare};
    return murk_source_type_group(light->type) == MURK_SOURCE_DOME ? &dome
                                                                   : &disc;
}
