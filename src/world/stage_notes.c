/* Warns of settings that are valid but probably not meant: among others,
 * geometry and regions that reach out of the domain, media that touch an open
 * side of the domain if there is distant light, portals that face away from
 * their light source, and a scene in which no light source has power. */
#include "world/stage_build.h"

#include "base/log.h"
#include "base/position.h"
#include "medium/waves.h"
#include "world/extent.h"
#include "world/mesh_materials.h"

/* Warns if the box of an item reaches out of the domain; not if the box is
 * empty. */
static void warn_if_cut(const char *where, const murk_box *box,
                        const murk_box *domain)
{
    if (box->min.x <= box->max.x && (!murk_box_contains(domain, box->min) ||
                                     !murk_box_contains(domain, box->max))) {
        murk_warn(where,
                  "reaches out of the domain and is cut off there: it spans %s "
                  "to %s m",
                  murk_position_show(box->min).text,
                  murk_position_show(box->max).text);
    }
}

/* Warns if a region with an index of refraction reaches one side in x or y of a
 * periodic domain but not the opposite side. Light that leaves through the one
 * side and comes in again through the other then changes its index without
 * being refracted, because light is not refracted in a side of the domain. */
static void warn_if_cut_once(const murk_stage *stage,
                             const murk_scene_region *r, const murk_box *box)
{
    const murk_domain *domain = &stage->world.domain;
    const murk_box *d = &domain->box;
    const bool x = (box->min.x <= d->min.x) != (box->max.x >= d->max.x);
    const bool y = (box->min.y <= d->min.y) != (box->max.y >= d->max.y);
    if (domain->is_periodic && r->ior > 0 && (x || y)) {
        murk_warn(r->where,
                  "reaches one %c side of the periodic domain and not the "
                  "other: light that wraps there changes its index of "
                  "refraction without being bent",
                  x ? 'x' : 'y');
    }
}

static void warn_of_cuts(const murk_stage *stage)
{
    const murk_box *domain = &stage->world.domain.box;
    const murk_scene_desc *scene = stage->scene;
    for (size_t i = 0; i < scene->geometries; ++i) {
        const murk_box box =
            murk_extent_geometry(&scene->geometry[i], stage->mesh[i]);
        warn_if_cut(scene->geometry[i].where, &box, domain);
    }
    for (size_t i = 0; i < scene->n_regions; ++i) {
        const murk_scene_region *r = &scene->regions[i];
        if (murk_extent_is_bounded(r)) {
            const murk_box box = murk_extent_region(
                stage->scene, r, stage->grid[r->medium], stage->region_mesh[i]);
            warn_if_cut(r->where, &box, domain);
            warn_if_cut_once(stage, r, &box);
        }
    }
}

/* True if region i, or its bounding box, reaches any side of the domain. */
static bool touches_sides(const murk_stage *stage, size_t i)
{
    const murk_scene_region *r = &stage->scene->regions[i];
    const murk_box *domain = &stage->world.domain.box;
    if (r->shape == MURK_REGION_EVERYWHERE) {
        return true;
    }
    if (r->shape == MURK_REGION_BELOW) {
        return r->below_z_m > domain->min.z;
    }
    const murk_box box = murk_extent_region(
        stage->scene, r, stage->grid[r->medium], stage->region_mesh[i]);
    return box.min.x <= domain->min.x || box.max.x >= domain->max.x ||
           box.min.y <= domain->min.y || box.max.y >= domain->max.y ||
           box.min.z <= domain->min.z || box.max.z >= domain->max.z;
}

/* Prints a note for each sun and moon that is not above the horizon. */
static void note_of_set(const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const murk_scene_light *l = &scene->lights[i];
        const bool is_body =
            murk_source_type_group(l->type) == MURK_SOURCE_BODY;
        const double elevation = stage->sky[i].elevation_deg;
        if (is_body && !(elevation > 0)) {
            murk_note(l->where,
                      "the %s is %.3g degrees below the horizon: no light "
                      "from it",
                      murk_source_type_name(l->type), -elevation);
        }
    }
}

/* Prints a note if a weather year states no light of the sky while the sun is
 * up, because the sky is not dark then. */
static void note_of_unresolved(const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const murk_scene_light *l = &scene->lights[i];
        if (l->by_weather && l->type == MURK_SOURCE_SKY &&
            scene->weather.seen.diffuse_w_per_m2 == 0 &&
            stage->sky[i].elevation_deg > 0) {
            murk_note(scene->weather.where,
                      "states a diffuse irradiance of 0 while the sun is up: "
                      "the sky has the light of twilight, at most %g W/m2",
                      MURK_WEATHER_RESOLVED_W_PER_M2);
            return;
        }
    }
}

/* Prints a note for each portal of a source with power that no light of this
 * source passes, because the portal faces away from the light. */
static void note_of_portals(const murk_stage *stage)
{
    for (size_t i = 0; i < murk_sources_count(stage->lights); ++i) {
        const murk_source *l = murk_sources_get(stage->lights, i);
        for (size_t k = 0; k < l->portals; ++k) {
            if (stage->sky[i].is_on &&
                !murk_sources_portal_is_lit(stage->lights, i, k)) {
                murk_note(l->where,
                          "aim %zu: no light passes it, as it passes towards "
                          "edge1_m x edge2_m",
                          k);
            }
        }
    }
}

static void note_of_dark(const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    if (murk_sources_lit(stage->lights) == 0) {
        murk_note(scene->where[0] ? scene->where : scene->path,
                  "it is dark: no light has any power, so nothing is emitted, "
                  "tallies are 0 and %s",
                  murk_stage_has_nothing_to_see(stage)
                      ? "coverage is null"
                      : "coverage is of the targets");
    }
}

/* Warns of regions that touch a side of the domain, if there is distant light
 * and any medium, and if the domain is neither periodic nor continued outside
 * (domain.outside: continued). A medium that touches a side usually continues
 * outside, but in such a domain distant light is not attenuated outside. */
static void warn_of_lit_sides(const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    bool is_lit = false;
    for (size_t i = 0; i < scene->n_lights; ++i) {
        is_lit |= murk_scene_light_is_distant(&scene->lights[i]);
    }
    if (stage->world.domain.is_periodic || scene->continues || !is_lit ||
        !murk_media_any(stage->media)) {
        return;
    }
    for (size_t i = 0; i < scene->n_regions; ++i) {
        if (touches_sides(stage, i)) {
            murk_warn(scene->regions[i].where,
                      "light of sun or sky meets a medium that touches an "
                      "open side: it is unattenuated where it enters, so it "
                      "is too bright near the sides. Where the medium goes on "
                      "outside, use domain.sides: periodic, or "
                      "domain.outside: continued");
        }
    }
}

/* For each region with wind, warns if the wind speed is outside the range in
 * which the slopes of waves were measured (medium/waves.h), and if sightlines
 * are refracted, because these take the water surface to be level. */
static void warn_of_winds(const murk_scene_desc *scene)
{
    for (size_t i = 0; i < scene->n_regions; ++i) {
        const murk_scene_region *r = &scene->regions[i];
        if (!(r->wind_m_per_s > 0)) {
            continue;
        }
        if (r->wind_m_per_s < MURK_WIND_MEASURED_MIN ||
            r->wind_m_per_s > MURK_WIND_MEASURED_MAX) {
            murk_warn(r->where,
                      "wind_m_per_s is %g m/s: slopes were measured at %g to "
                      "%g m/s, beyond that the same line goes on",
                      r->wind_m_per_s, MURK_WIND_MEASURED_MIN,
                      (double)MURK_WIND_MEASURED_MAX);
        }
        if (scene->placement.through == MURK_SCENE_REFRACT) {
            murk_warn(r->where, "sightlines (through: refract) cross these "
                                "waves as if they were level");
        }
    }
}

void murk_stage_warn(const murk_stage *stage)
{
    warn_of_cuts(stage);
    murk_warn_of_materials(stage);
    warn_of_lit_sides(stage);
    note_of_set(stage);
    note_of_unresolved(stage);
    warn_of_winds(stage->scene);
    note_of_portals(stage);
    note_of_dark(stage);
}
