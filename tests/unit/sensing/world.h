/* Small worlds for the tests of this room, built by hand. */
#ifndef MURK_TESTS_SENSING_WORLD_H
#define MURK_TESTS_SENSING_WORLD_H

#include "check.h"
#include "geometry/surfaces.h"
#include "medium/media.h"
#include "photonmap/map.h"
#include "sensing/sight.h"

#include <stdlib.h>

/* Sees all round, as far as this. */
static inline murk_sensor_type all_round(double range_m)
{
    return (murk_sensor_type){.range_m = range_m};
}

/* Sensors of the first type; valid until the next call. */
static inline const murk_pose *partial_at(const murk_vec3 *place, size_t n)
{
    static murk_pose pose[64];
    CHECK(n <= 64);
    for (size_t k = 0; k < n; ++k) {
        pose[k] = (murk_pose){.position = place[k]};
    }
    return pose;
}

/* Materials of every world here. */
enum { WALL, GLASS };
#define GLASS_TRANSMIT 0.8

static inline murk_surface_desc a_box(murk_vec3 min, murk_vec3 max)
{
    return (murk_surface_desc){.shape = MURK_SHAPE_BOX,
                               .box = {min, max},
                               .to_world = murk_affine_identity(),
                               .where = "box"};
}

static inline murk_surface_desc a_rect(murk_vec3 corner, murk_vec3 edge1,
                                       murk_vec3 edge2, int material)
{
    return (murk_surface_desc){.shape = MURK_SHAPE_RECT,
                               .corner = corner,
                               .edge1 = edge1,
                               .edge2 = edge2,
                               .material = material,
                               .to_world = murk_affine_identity(),
                               .where = "rect"};
}

static inline murk_surfaces *surfaces_of(const murk_surface_desc *desc,
                                         size_t n)
{
    const murk_material materials[2] = {
        {.name = "default", .diffuse = murk_spectrum_flat(0.5, 2)},
        {.name = "glass", .transmit = murk_spectrum_flat(GLASS_TRANSMIT, 2)}};
    murk_surfaces *surfaces = NULL;
    murk_error err = {0};
    CHECK(murk_surfaces_create(&surfaces, desc, n, materials, 2, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    return surfaces;
}

/* A photon of 1 W; no normal: of the volume map. */
static inline murk_photon a_photon(murk_vec3 p, murk_vec3 normal,
                                   uint32_t emitted)
{
    return murk_photon_make(
        &(murk_photon_values){.position_m = p,
                              .direction = murk_vec(0, 0, -1),
                              .normal = normal,
                              .power_w = 1,
                              .emitted = emitted,
                              .is_volume = murk_dot(normal, normal) == 0});
}

static inline murk_photon_map *map_of(const murk_photon *photons, size_t n)
{
    murk_photon *copy = malloc(n * sizeof *copy + 1);
    if (n) {
        memcpy(copy, photons, n * sizeof *copy);
    }
    murk_photon_map *map = NULL;
    murk_error err = {0};
    CHECK(murk_photon_map_create(&map, copy, n, 1, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return map;
}

static inline murk_media *clear_air(const murk_domain *domain)
{
    murk_media *media = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&media, NULL, 0, NULL, 0, &domain->box, &err) ==
          MURK_OK);
    return media;
}

/* One homogeneous medium, extinction per band, everywhere. */
static inline murk_media *mist(const murk_domain *domain, double per_m0,
                               double per_m1)
{
    const murk_medium medium = {.extinction_per_m = {{per_m0, per_m1}},
                                .albedo = murk_spectrum_flat(0.5, 2),
                                .where = "mist"};
    const murk_region region = {.shape = MURK_REGION_EVERYWHERE,
                                .to_world = murk_affine_identity(),
                                .where = "everywhere"};
    murk_media *media = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&media, &medium, 1, &region, 1, &domain->box,
                            &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return media;
}

/* Whether a look holds the photon stored with this emitted index, and how
 * clearly; 0 when unseen. */
static inline int clarity_of(const murk_sight *sight,
                             const murk_sparse_row *row, uint32_t emitted)
{
    const murk_sight_desc *desc = murk_sight_described(sight);
    const size_t surface = murk_photon_map_count(desc->surface_map);
    for (size_t k = 0; k < row->seen; ++k) {
        const uint32_t i = row->photon[k];
        const murk_photon *p =
            i < surface
                ? &murk_photon_map_photons(desc->surface_map)[i]
                : &murk_photon_map_photons(desc->volume_map)[i - surface];
        if (p->emitted == emitted) {
            return row->clarity ? row->clarity[k] : MURK_CLEAR;
        }
    }
    return 0;
}

#endif
