/* The share of light from outside that the media of the domain absorb or
 * scatter before the light meets a surface, a change of the index of refraction
 * or the floor (the lower side of the domain). The file computes the
 * transmittance along rays to a fixed pattern of rectangles of the floor, from
 * the direction of a beam or from the directions of a dome. All rays have equal
 * weight, and the bands are weighted by power. The pattern has no random
 * numbers, so the same scene gives the same share for any seed. */
#include "world/daylight_loss.h"

#include "path/pieces.h"

/* The numbers of rectangles into which the floor is divided along x and along
 * y: BEAM_SQUARES for a beam, DOME_SQUARES for each direction of a dome. A dome
 * has DOME_SPOKES directions on each of DOME_RINGS rings around the zenith,
 * which have equal parts of the irradiance. The numbers are a choice. */
#define BEAM_SQUARES 16
#define DOME_SQUARES 6
#define DOME_RINGS   4
#define DOME_SPOKES  8

/* A ray that reaches a side in x or y of a domain that repeats begins a new
 * piece at the opposite side. After this many pieces, the rest of the ray is
 * taken to have the mean extinction of the pieces. */
#define PIECES_MAX 200

/* The properties that all rays through one world share. */
typedef struct rays {
    const murk_transport_world *world;
    murk_path_tiling tiling;
} rays;

/* Sets *r for a world. A ray that leaves through a side in x or y continues at
 * the opposite side if the domain is periodic or if the media continue outside.
 * (If the media continue outside, the surfaces are repeated, too, although
 * there are none outside, so a ray may end early at one of them.) */
static void begin(rays *r, const murk_transport_world *world)
{
    r->world = world;
    r->tiling = (murk_path_tiling){
        .space = murk_path_space_of(world->surfaces, world->media,
                                    world->boundary_meshes, &world->domain),
        .repeats = world->domain.is_periodic || world->continues,
        .sideways_max_m = INFINITY,
        .free_below_m = -INFINITY,
        .free_above_m = INFINITY};
}

/* The ray along `direction`, which points downwards, for one point of the
 * floor. If the domain repeats (begin()), the ray begins straight above the
 * point at the top of the domain and ends at the height of the floor. Otherwise
 * the ray ends at the point and begins where it enters the domain through the
 * top or a side. */
static murk_path_pieces ray_to(const rays *r, murk_vec3 floor,
                               murk_vec3 direction)
{
    const murk_box *box = &r->world->domain.box;
    double from = 0, length = (box->max.z - box->min.z) / -direction.z;
    if (r->tiling.repeats) {
        return murk_path_pieces_of(&r->tiling,
                                   murk_vec(floor.x, floor.y, box->max.z),
                                   direction, length);
    }
    const murk_vec3 back = murk_scale(-1, direction);
    (void)murk_box_clip(box, floor, back, &from, &length);
    return murk_path_pieces_of(&r->tiling, murk_along(floor, length, back),
                               direction, length);
}

/* Optical depths by band from the beginning of the ray to its end, or to the
 * first surface or bend (change of the index of refraction) before the end. A
 * ray of more than PIECES_MAX pieces is extrapolated. */
static murk_spectrum depth_of(const rays *r, murk_path_pieces ray)
{
    const double length_m = ray.left_m;
    murk_spectrum depth = {{0}};
    /* Add up the pieces until a surface or a bend ends the ray. */
    double passed_m = 0;
    bool is_free = true;
    for (int n = 0; n < PIECES_MAX && is_free && murk_path_next_piece(&ray);
         ++n) {
        const murk_path_stop stop = murk_path_piece_stop(&ray, 0);
        is_free = !stop.is_surface && !stop.is_bend;
        const murk_path path = {
            .space = &r->tiling.space,
            .position = ray.piece.from,
            .direction = ray.direction,
            .length_m = stop.length_m,
            .inside = murk_path_inside_ahead(&r->tiling.space, ray.piece.from,
                                             ray.direction)};
        for (int b = 0; b < r->world->bands; ++b) {
            depth.band[b] += murk_path_depth(&path, b);
        }
        passed_m += stop.length_m;
    }
    /* Extrapolate a ray that had pieces left. */
    if (is_free && passed_m > 0 && passed_m < length_m) {
        for (int b = 0; b < r->world->bands; ++b) {
            depth.band[b] *= length_m / passed_m;
        }
    }
    return depth;
}

/* Adds the means, over squares * squares rectangles of the floor, of optical
 * depth and transmittance along `direction`, times weight. */
static void add_direction(murk_daylight_loss *out, const rays *r,
                          murk_vec3 direction, int squares, double weight)
{
    const murk_transport_world *world = r->world;
    const murk_box *box = &world->domain.box;
    const double one = weight / squares / squares;
    for (int i = 0; i < squares * squares; ++i) {
        const double u = (i % squares + 0.5) / squares;
        const double v = (i / squares + 0.5) / squares;
        const murk_vec3 floor =
            murk_vec(box->min.x + u * (box->max.x - box->min.x),
                     box->min.y + v * (box->max.y - box->min.y), box->min.z);
        const murk_spectrum depth = depth_of(r, ray_to(r, floor, direction));
        for (int b = 0; b < world->bands; ++b) {
            out->optical_depth.band[b] += one * depth.band[b];
            out->transmittance.band[b] += one * exp(-depth.band[b]);
        }
    }
}

/* Adds the directions of a dome. Equal steps in sin^2 of the zenith angle and
 * in azimuth give equal parts of the irradiance of an even sky on a level
 * plane, so all directions have equal weight. */
static void add_dome(murk_daylight_loss *out, const rays *r)
{
    const murk_vec3 down = murk_vec(0, 0, -1);
    for (int i = 0; i < DOME_RINGS; ++i) {
        const double cosine = sqrt(1 - (i + 0.5) / DOME_RINGS);
        for (int k = 0; k < DOME_SPOKES; ++k) {
            const double azimuth = 2 * MURK_PI * (k + 0.5) / DOME_SPOKES;
            add_direction(out, r, murk_about(down, cosine, azimuth),
                          DOME_SQUARES, 1.0 / (DOME_RINGS * DOME_SPOKES));
        }
    }
}

murk_daylight_loss murk_daylight_loss_of(const murk_stage *stage, size_t light)
{
    const murk_source *l = murk_sources_get(stage->lights, light);
    const murk_transport_world *world = &stage->world;
    murk_daylight_loss out = {.is_known = false};
    double power = 0, through = 0;
    for (int b = 0; b < world->bands; ++b) {
        power += l->power_w.band[b];
    }
    /* The share is known only for distant light with power from above. */
    const bool is_dome = murk_source_type_group(l->type) == MURK_SOURCE_DOME;
    if (!murk_source_is_distant(l) || !(power > 0) ||
        (!is_dome && !(l->direction.z < 0))) {
        return out;
    }
    rays r;
    begin(&r, world);
    if (!is_dome) {
        add_direction(&out, &r, murk_unit(l->direction), BEAM_SQUARES, 1);
    } else {
        add_dome(&out, &r);
    }
    for (int b = 0; b < world->bands; ++b) {
        through += l->power_w.band[b] * out.transmittance.band[b];
    }
    out.is_known = true;
    out.share = fmax(0, 1 - through / power);
    return out;
}
