/* For tests of boundaries: regions with an index in a domain. */
#ifndef MURK_TESTS_INTERFACE_MEDIA_H
#define MURK_TESTS_INTERFACE_MEDIA_H

#include "base/log.h"
#include "base/rng.h"
#include "check.h"
#include "medium/interfaces.h"

#include <stdlib.h>

#define EVERY 64

static const murk_box DOMAIN = {{-20, -20, -20}, {20, 20, 20}};

static inline murk_region everywhere(double ior)
{
    return (murk_region){.shape = MURK_REGION_EVERYWHERE,
                         .to_world = murk_affine_identity(),
                         .ior = ior,
                         .where = "everywhere"};
}

static inline murk_region below(double z, double ior)
{
    murk_region region = everywhere(ior);
    region.shape = MURK_REGION_BELOW;
    region.below_z_m = z;
    region.where = "sea";
    return region;
}

static inline murk_region box(murk_vec3 min, murk_vec3 max, double ior)
{
    murk_region region = everywhere(ior);
    region.shape = MURK_REGION_BOX;
    region.box = (murk_box){min, max};
    region.where = "box";
    return region;
}

static inline murk_region ball(murk_vec3 center, double radius, double ior)
{
    murk_region region = everywhere(ior);
    region.shape = MURK_REGION_SPHERE;
    region.center = center;
    region.radius_m = radius;
    region.where = "ball";
    return region;
}

static inline murk_region moved(murk_region region, murk_vec3 rotate_deg,
                                double scale, murk_vec3 translate_m)
{
    region.to_world = murk_affine_place(rotate_deg, scale, translate_m);
    return region;
}

static inline murk_media *build_in(const murk_box *domain,
                                   const murk_region *regions, size_t n)
{
    const murk_medium clear = {.where = "clear"};
    murk_media *media = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&media, &clear, 1, regions, n, domain, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    return media;
}

static inline murk_media *build(const murk_region *regions, size_t n)
{
    return build_in(&DOMAIN, regions, n);
}

static const murk_vec3 up = {0, 0, 1}, down = {0, 0, -1};

#endif
