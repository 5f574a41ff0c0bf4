/* Checks one light source against the domain, through the row of functions of
 * the type of the light (source/source_state.h). Contains the checks that
 * several types share. */
#include "source/source_state.h"

#include "base/position.h"

#include <float.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* A lamp may touch the faces of the domain: sums of coordinates may be off
 * there by a few roundings of the largest coordinate. */
#define TOUCH_ROUNDINGS 4

/* The rounding error of a cross product is a few roundings of |a||b|: the
 * orientation of a rectangle with a shorter cross product is undefined. */
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

murk_status murk_source_check_inside(const murk_domain *domain, murk_vec3 p,
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

murk_status murk_source_prepare_direction(murk_source_state *s, murk_error *err)
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

murk_status murk_source_check_sheet(const murk_portal *sheet,
                                    const murk_domain *domain, const char *what,
                                    const char *where, murk_error *err)
{
    const murk_vec3 e = sheet->edge1, f = sheet->edge2;
    /* The edges must span an area. */
    const double minimum =
        CROSS_ROUNDINGS * DBL_EPSILON * murk_length(e) * murk_length(f);
    if (!(murk_length(murk_cross(e, f)) > minimum)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "%s edge1_m [%g, %g, %g] and edge2_m [%g, %g, %g] "
                         "span no area, must not be zero or parallel",
                         what, e.x, e.y, e.z, f.x, f.y, f.z);
    }
    /* All corners must lie in the domain. */
    const murk_vec3 none = {0, 0, 0};
    char corner_of[64];
    snprintf(corner_of, sizeof corner_of, "%s corner", what);
    for (int corner = 0; corner < 4; ++corner) {
        murk_vec3 p = murk_along(sheet->corner, corner % 2, e);
        p = murk_along(p, corner / 2, f);
        const murk_status status =
            murk_source_check_inside(domain, p, none, corner_of, where, err);
        if (status) {
            return status;
        }
    }
    return MURK_OK;
}

const murk_source_row *murk_source_row_of(const murk_source *light)
{
    return murk_source_is_distant(light) ? murk_source_distant_row(light)
           : light->type == MURK_SOURCE_LUMINAIRE
               ? &murk_source_luminaire_row
               : &murk_source_lamp_rows[light->type];
}

murk_status murk_source_state_prepare(murk_source_state *s, size_t bands,
                                      murk_error *err)
{
    const murk_status status = check_power(&s->light, bands, err);
    s->power_scale = 1;
    s->is_dark = is_dark(&s->light, bands);
    return status ? status : murk_source_row_of(&s->light)->prepare(s, err);
}

void murk_source_state_release(murk_source_state *s)
{
    free((char *)(uintptr_t)s->light.where);
    free((murk_portal *)(uintptr_t)s->light.portal);
    murk_intensity_destroy((murk_intensity *)(uintptr_t)s->light.intensity);
    murk_entry_faces_destroy(s->entry_faces);
}

static double clamp(double x, double minimum, double maximum)
{
    return x < minimum ? minimum : x > maximum ? maximum : x;
}

/* Moves a start that lies outside by rounding, because a lamp may touch a face
 * of the domain, back into the box. */
static murk_vec3 inside(const murk_box *box, murk_vec3 p)
{
    return murk_vec(clamp(p.x, box->min.x, box->max.x),
                    clamp(p.y, box->min.y, box->max.y),
                    clamp(p.z, box->min.z, box->max.z));
}

murk_ray murk_source_state_emit(const murk_source_state *s,
                                const double u[MURK_ENTRY_FACES_NUMBERS])
{
    murk_ray ray = murk_source_row_of(&s->light)->emit(s, u);
    ray.origin = inside(&s->domain->box, ray.origin);
    return ray;
}

/* ---- lamps, for other folders of src ---- */

murk_box murk_source_box(const murk_source *light)
{
    const murk_source_row *row = murk_source_row_of(light);
    return row->box ? row->box(light) : murk_box_empty();
}

double murk_source_extent_m(const murk_source *lamp)
{
    return murk_source_row_of(lamp)->extent_m(lamp);
}

murk_vec3 murk_source_face(const murk_source *light, murk_vec3 otherwise)
{
    const murk_source_row *row = murk_source_row_of(light);
    return row->normal && !(light->height_m > 0) ? row->normal(light)
                                                 : otherwise;
}

double murk_source_irradiance_near(const murk_source *lamp, int band,
                                   murk_vec3 to_lamp, bool has_images)
{
    const murk_source_row *row = murk_source_row_of(lamp);
    const double power = lamp->power_w.band[band];
    const double extent = row->extent_m(lamp);
    const double square = fmax(murk_dot(to_lamp, to_lamp), extent * extent);
    if (!(square > 0)) {
        return power;
    }
    return row->irradiance_near
               ? row->irradiance_near(lamp, band, to_lamp, has_images)
               : power / (4 * MURK_PI * square);
}
