/* Attenuates distant light outside of an open domain whose media continue.
 *
 * The column of media just inside of the side, above the place where light
 * enters (below it for light that travels upwards), stands for the layers
 * outside. In each layer a direct beam loses exp(-tau / cosine), with tau the
 * optical depth of the layer along z; at a level boundary Snell's law turns the
 * beam and Fresnel's reflectance is lost (waves count as level). The flux
 * through an upright side is the vertical flux times the tangent of the zenith
 * angle, so bending also changes the flux by the ratio of the tangents. All
 * factors are at most 1, except for this ratio if the last layer has a lower
 * index of refraction than the first. The share of the light is the product of
 * all factors, and 1 if the product is larger. */
#include "transport/outside.h"

#include "medium/fresnel.h"
#include "path/path.h"

/* Share of the domain's diagonal by which the column lies inside of the side:
 * above what single-precision meshes are off by, below any layer's size. */
#define INSET 1e-7

/* Layers of one column; far above what 64 regions can bound. */
#define LAYERS_MAX 256

/* A level beam is taken to come from 1e9 heights away, instead of from
 * infinity: any medium extinguishes it, and no product is 0 times infinity. */
#define COSINE_MIN 1e-9

/* The beam while it descends through the layers. */
typedef struct beam {
    double index, cosine; /* of the layer; the cosine is of the zenith angle */
    double share;
    bool is_bent;
} beam;

/* Takes the beam through a level boundary to another index of refraction. */
static void refract(beam *b, double index)
{
    double cosine;
    b->share *= 1 - murk_fresnel(b->index, index, b->cosine, &cosine);
    b->index = index;
    b->cosine = fmax(COSINE_MIN, cosine);
    b->is_bent = true;
}

/* Attenuates and refracts the beam in the layers of the column that begins at
 * `at` and extends over length_m in the direction `along`, up or down. */
static void descend(beam *b, const murk_transport_world *world, int band,
                    murk_vec3 at, murk_vec3 along, double length_m)
{
    const murk_path_space space = murk_path_space_of(
        world->surfaces, world->media, world->boundary_meshes, &world->domain);
    murk_path path = {.space = &space,
                      .position = at,
                      .direction = along,
                      .length_m = length_m,
                      .inside = murk_path_inside_ahead(&space, at, along)};
    b->index = murk_media_index(world->media, path.inside);
    for (int i = 0; i < LAYERS_MAX && b->share > 0; ++i) {
        /* The layer ends at the next boundary, or at the place. */
        murk_path_boundary next;
        const bool is_boundary =
            murk_path_next_boundary(&path, length_m, &next) &&
            next.met.distance_m < length_m;
        const double end_m = is_boundary ? next.met.distance_m : length_m;
        const double depth = murk_media_optical_depth(
            world->media, band, path.inside, murk_along(at, path.gone_m, along),
            along, end_m - path.gone_m);
        b->share *= exp(-depth / b->cosine);
        if (!is_boundary) {
            return;
        }
        /* Beyond the boundary. */
        murk_path_pass(&path, &next);
        const double index = murk_media_index(world->media, path.inside);
        if (index != b->index) {
            refract(b, index);
        }
    }
}

double murk_outside_share(const murk_transport_world *world, int band,
                          murk_vec3 place, murk_vec3 *direction, bool *is_bent)
{
    const murk_box *box = &world->domain.box;
    const murk_vec3 d = *direction;
    const bool goes_up = d.z > 0;
    const double from_z = goes_up ? box->min.z : box->max.z;
    const double height_m = fabs(place.z - from_z);
    if (is_bent) {
        *is_bent = false;
    }
    const murk_media *media = world->media;
    if (!world->continues || !(height_m > 0) ||
        !(murk_media_any(media) || murk_media_bends(media))) {
        return 1;
    }
    /* the column stands a little inside of the side */
    const murk_vec3 middle = murk_scale(0.5, murk_add(box->min, box->max));
    const double inset = INSET * murk_length(murk_sub(box->max, box->min));
    const murk_vec3 top = {place.x + copysign(inset, middle.x - place.x),
                           place.y + copysign(inset, middle.y - place.y),
                           from_z};
    const double cosine = fmax(COSINE_MIN, fabs(d.z));
    beam b = {.cosine = cosine, .share = 1};
    descend(&b, world, band, top, murk_vec(0, 0, goes_up ? 1 : -1), height_m);
    const double level = hypot(d.x, d.y);
    if (b.is_bent && level > 0) {
        /* Snell: index times sine is the same in all layers */
        const double sine = sqrt((1 - b.cosine) * (1 + b.cosine));
        direction->x *= sine / level;
        direction->y *= sine / level;
        direction->z = goes_up ? b.cosine : -b.cosine;
        b.share *= sine / b.cosine / (level / cosine);
    }
    if (is_bent) {
        *is_bent = b.is_bent;
    }
    return fmin(1, b.share);
}

double murk_outside_straight(const murk_transport_world *world, int band,
                             murk_vec3 place, murk_vec3 direction)
{
    bool is_bent;
    const double share =
        murk_outside_share(world, band, place, &direction, &is_bent);
    return is_bent ? 0 : share;
}
