/* Computes the extinction of all media at points, and transmittance by
 * Beer-Lambert along straight segments, with the same
 * passage through media as sightlines (path/viewpoint.h), and refuses segments
 * that a surface blocks or on which light does not travel straight. */
#include "calibrate/beams.h"

#include "base/position.h"
#include "medium/rescaled.h"
#include "path/viewpoint.h"
#include "world/stage_build.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

struct murk_beams {
    murk_domain domain; /* not periodic: segments are straight */
    const murk_boundary_meshes *boundary_meshes;
    murk_fillings fillings; /* grids of the stage; profiles of the scene of the
                             * optics */
    murk_profile *profile;
    murk_media *media;
    int bands;
};

static murk_domain open_domain(const murk_stage *stage)
{
    murk_domain domain = stage->world.domain;
    domain.is_periodic = false;
    return domain;
}

/* True if a surface lies between the ends; surfaces at the ends do not count.
 */
static bool is_blocked(const murk_surfaces *surfaces, const murk_reading *r)
{
    const murk_vec3 between = murk_sub(r->to, r->position);
    const double length = murk_length(between);
    const murk_vec3 along = murk_scale(1 / length, between);
    const murk_vec3 from = murk_surfaces_leave(surfaces, r->position, along);
    const murk_vec3 to =
        murk_surfaces_leave(surfaces, r->to, murk_scale(-1, along));
    const bool is_open = murk_dot(murk_sub(to, from), between) > 0;
    return is_open && murk_surfaces_blocked(surfaces, from, to, false);
}

/* The acceptance angle needs an apparent extinction. */
static murk_status check_acceptance(const murk_stage *stage,
                                    const murk_reading *r, murk_error *err)
{
    return isnan(r->acceptance_rad)
               ? MURK_OK
               : murk_media_check_acceptance(stage->media, err);
}

/* Checks one point. */
static murk_status check_point(const murk_stage *stage, const murk_reading *r,
                               const char *where, murk_error *err)
{
    return murk_surfaces_solid_at(stage->surfaces, r->position)
               ? murk_fail(err, MURK_BAD_VALUE, where,
                           "the point %s m is inside a solid, must be outside "
                           "of all",
                           murk_position_show(r->position).text)
               : check_acceptance(stage, r, err);
}

/* Checks one segment or point. */
static murk_status check_reading(const murk_stage *stage,
                                 const murk_domain *domain,
                                 const murk_reading *r, const char *where,
                                 murk_error *err)
{
    if (r->kind == MURK_READ_EXTINCTION) {
        return check_point(stage, r, where, err);
    }
    /* Ends must not lie in a solid. */
    const murk_vec3 a = r->position, b = r->to;
    if (murk_surfaces_solid_at(stage->surfaces, a) ||
        murk_surfaces_solid_at(stage->surfaces, b)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "the segment %s to %s m ends "
                         "inside a solid, must be outside of all",
                         murk_position_show(a).text,
                         murk_position_show(b).text);
    }
    /* No surface may block the segment, and light must not be refracted. */
    if (is_blocked(stage->surfaces, r)) {
        return murk_fail(
            err, MURK_BAD_VALUE, where,
            "a surface stands across the segment %s to %s m, which "
            "must be open",
            murk_position_show(a).text, murk_position_show(b).text);
    }
    const murk_path_space space = murk_path_space_of(
        stage->surfaces, stage->media, stage->boundary_meshes, domain);
    const murk_path_viewpoint end = murk_path_viewpoint_at(&space, a);
    if (murk_path_bends_to(&end, b)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "the index of refraction changes on the segment "
                         "%s to %s m, which must be "
                         "straight for light",
                         murk_position_show(a).text,
                         murk_position_show(b).text);
    }
    return check_acceptance(stage, r, err);
}

murk_status murk_beams_check(const murk_stage *stage,
                             const murk_readings *measured, size_t condition,
                             murk_error *err)
{
    const murk_domain domain = open_domain(stage);
    murk_status status = MURK_OK;
    for (size_t i = 0; i < measured->readings && !status; ++i) {
        const murk_reading *r = &measured->reading[i];
        if (!murk_reading_needs_light(r->kind) && r->condition == condition) {
            char where[sizeof err->where];
            snprintf(where, sizeof where, "%s:%zu", measured->path, r->line);
            status = check_reading(stage, &domain, r, where, err);
        }
    }
    return status;
}

murk_status murk_beams_create(murk_beams **out, const murk_stage *stage,
                              const murk_optics *optics, murk_error *err)
{
    const murk_scene_desc *scene = optics->scene;
    assert(scene->n_media == stage->scene->n_media &&
           scene->n_regions == stage->scene->n_regions);
    murk_status status = MURK_OK;
    murk_beams *beams = calloc(1, sizeof *beams);
    /* Allocate. Profiles are those of the scene of the optics, because they
     * depend on the parameters; grids do not. */
    if (beams) {
        beams->profile = calloc(scene->n_media + 1, sizeof *beams->profile);
    }
    if (!beams || !beams->profile) {
        status =
            murk_no_memory(err, scene->path, "for the media of its segments");
        goto done;
    }
    for (size_t i = 0; i < scene->n_media; ++i) {
        const murk_scene_medium *m = &scene->media[i];
        beams->profile[i] = (murk_profile){
            m->profile_z_m.n, m->profile_z_m.value, m->profile_per_m.value};
    }
    /* Build the media for an open domain. */
    beams->domain = open_domain(stage);
    beams->boundary_meshes = stage->boundary_meshes;
    beams->fillings = *stage->fillings;
    beams->fillings.profile = beams->profile;
    beams->bands = scene->bands;
    status = murk_stage_media(&beams->media, stage, scene, &beams->fillings,
                              optics->phases, err);
    if (status) {
        goto done;
    }
    *out = beams;
    beams = NULL;
done:
    murk_beams_destroy(beams);
    return status;
}

void murk_beams_destroy(murk_beams *beams)
{
    if (beams) {
        murk_media_destroy(beams->media);
        free(beams->profile);
        free(beams);
    }
}

/* The transmittance, or the extinction at the point, in the band of the
 * reading, or the mean over all bands. */
static double value_of(const murk_beams *beams, const murk_media *media,
                       const murk_reading *reading)
{
    const murk_path_space space =
        murk_path_space_of(NULL, media, beams->boundary_meshes, &beams->domain);
    const murk_path_viewpoint end =
        murk_path_viewpoint_at(&space, reading->position);
    const murk_inside inside = murk_path_inside(&space, reading->position);
    const bool is_all = reading->band < 0;
    const int first = is_all ? 0 : reading->band, n = is_all ? beams->bands : 1;
    double sum = 0;
    for (int band = first; band < first + n; ++band) {
        sum +=
            reading->kind == MURK_READ_EXTINCTION
                ? murk_media_extinction(media, band, inside, reading->position)
                : murk_path_transmittance_to(&end, band, reading->to);
    }
    return sum / n;
}

/* Converts the value of a reading to the unit of the reading. */
static double in_unit(const murk_reading *reading, double value)
{
    double unused;
    return reading->kind == MURK_READ_EXTINCTION
               ? murk_reading_of_extinction(reading->unit, value)
               : murk_reading_in_unit(
                     reading->unit, value,
                     murk_length(murk_sub(reading->to, reading->position)),
                     &unused);
}

murk_status murk_beam_read(double *out, const murk_beams *beams,
                           const murk_reading *reading, murk_error *err)
{
    if (isnan(reading->acceptance_rad)) {
        *out = in_unit(reading, value_of(beams, beams->media, reading));
        return MURK_OK;
    }
    murk_media *seen = NULL;
    const murk_status status =
        murk_media_accepting(&seen, beams->media, reading->acceptance_rad, err);
    if (!status) {
        *out = in_unit(reading, value_of(beams, seen, reading));
        murk_media_destroy(seen);
    }
    return status;
}
