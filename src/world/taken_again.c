#include "world/taken_again.h"

#include "medium/interfaces.h"

#define BEAM_SQUARES 16 /* along either side of the floor */
#define DOME_SQUARES 6
#define DOME_RINGS   4
#define DOME_SPOKES  8

/* Beyond this many pieces (wraps of a periodic domain, regions crossed) the
 * rest of a way is taken to be as what was passed. */
#define MAX_PIECES 200

/* Of the domain's size: how far behind a place the regions around it are asked
 * for, since in a boundary itself either answer may come. */
#define BEHIND 1e-7

/* A ray on its way. */
typedef struct way {
    const murk_transport_world *world;
    murk_vec3 place, direction;
    murk_inside inside;
    double skip_m;   /* no mesh's boundary is looked for before */
    double length_m; /* to the floor, unless something stands before */
    double passed_m;
    double behind_m;
} way;

/* Whether a way that leaves through a side goes on in the same media: in a
 * domain that repeats, and where media continue outside (surfaces are taken to
 * repeat there, too, which only matters to how far light comes). */
static bool goes_on_outside(const murk_transport_world *world)
{
    return world->domain.is_periodic || world->continues;
}

static murk_inside around(const way *w)
{
    const murk_vec3 place = murk_along(w->place, w->behind_m, w->direction);
    return murk_media_inside(w->world->media, place) |
           (w->world->boundary_meshes
                ? murk_boundary_meshes_at(w->world->boundary_meshes, place)
                : 0);
}

/* The next boundary of a region at most *length_m ahead: shortens *length_m to
 * it and tells the set beyond. */
static bool next_boundary(way *w, double *length_m, murk_inside *beyond,
                          double *skip_m)
{
    bool found = false;
    murk_boundary boundary;
    murk_crossing crossing;
    const murk_transport_world *world = w->world;
    *skip_m = 0;
    if (murk_media_boundary(world->media, w->inside, w->place, w->direction,
                            *length_m, &boundary)) {
        *length_m = boundary.distance_m;
        *beyond = w->inside ^ boundary.crossed;
        found = true;
    }
    if (world->boundary_meshes) {
        const murk_inside meshes =
            murk_boundary_meshes_regions(world->boundary_meshes);
        murk_inside of_meshes = w->inside & meshes;
        if (murk_boundary_meshes_next(world->boundary_meshes, w->place,
                                      w->direction, w->skip_m, *length_m,
                                      &of_meshes, &crossing)) {
            *length_m = crossing.distance_m;
            *beyond = (w->inside & ~meshes) | crossing.inside;
            *skip_m = murk_boundary_meshes_tolerance_m(world->boundary_meshes);
            found = true;
        }
    }
    return found;
}

/* Where a way leaves a periodic domain: the same place of the other side. */
static void wrap(way *w, double side_m)
{
    const murk_box *box = &w->world->domain.box;
    const murk_vec3 size = murk_sub(box->max, box->min);
    const murk_vec3 d = w->direction;
    const double x_m = ((d.x > 0 ? box->max.x : box->min.x) - w->place.x) / d.x;
    const bool is_x = d.x != 0 && fabs(x_m - side_m) <= w->behind_m;
    w->place = murk_along(w->place, side_m, d);
    if (is_x) {
        w->place.x += d.x > 0 ? -size.x : size.x;
    } else {
        w->place.y += d.y > 0 ? -size.y : size.y;
    }
    w->inside = around(w);
    w->skip_m = 0;
}

/* Optical depths per band from the way's start to its end. */
static murk_spectrum depth_of(way *w)
{
    const murk_transport_world *world = w->world;
    const murk_domain *domain = &world->domain;
    murk_spectrum depth = {{0}};
    int pieces = 0;
    bool goes_on = true;
    while (goes_on && pieces++ < MAX_PIECES && w->passed_m < w->length_m) {
        double from = 0, side = w->length_m - w->passed_m;
        const double left = side;
        (void)murk_box_clip(&domain->box, w->place, w->direction, &from, &side);
        double length = fmin(side, left);
        murk_hit hit;
        murk_inside beyond = w->inside;
        double skip_m = 0;
        const bool is_hit = murk_surfaces_hit(world->surfaces, w->place,
                                              w->direction, length, &hit);
        length = is_hit ? hit.distance_m : length;
        const bool is_boundary = next_boundary(w, &length, &beyond, &skip_m);
        for (int b = 0; b < world->bands; ++b) {
            depth.band[b] += murk_media_optical_depth(
                world->media, b, w->inside, w->place, w->direction, length);
        }
        w->passed_m += length;
        if (is_boundary) {
            goes_on = murk_media_index(world->media, beyond) ==
                      murk_media_index(world->media, w->inside);
            w->place = murk_along(w->place, length, w->direction);
            w->inside = beyond;
            w->skip_m = skip_m;
        } else if (is_hit || !goes_on_outside(world) || side >= left) {
            goes_on = false;
        } else {
            wrap(w, length);
        }
    }
    if (goes_on && w->passed_m > 0 && w->passed_m < w->length_m) {
        for (int b = 0; b < world->bands; ++b) {
            depth.band[b] *= w->length_m / w->passed_m;
        }
    }
    return depth;
}

/* The way along `direction` that ends in a place of the floor; the domain is
 * entered through a side where it is open. */
static way way_to(const murk_transport_world *world, murk_vec3 floor,
                  murk_vec3 direction)
{
    const murk_box *box = &world->domain.box;
    const double height = box->max.z - box->min.z;
    const murk_vec3 back = murk_scale(-1, direction);
    double from = 0, length = height / -direction.z;
    way w = {.world = world, .direction = direction, .length_m = length};
    w.behind_m = BEHIND * murk_length(murk_sub(box->max, box->min));
    if (!goes_on_outside(world)) {
        (void)murk_box_clip(box, floor, back, &from, &length);
        w.length_m = length;
        w.place = murk_along(floor, length, back);
    } else {
        w.place = murk_vec(floor.x, floor.y, box->max.z);
    }
    w.place = murk_vec(fmin(fmax(w.place.x, box->min.x), box->max.x),
                       fmin(fmax(w.place.y, box->min.y), box->max.y),
                       fmin(fmax(w.place.z, box->min.z), box->max.z));
    w.inside = around(&w);
    return w;
}

/* Adds the means over the squares of the floor, times weight. */
static void add_direction(murk_taken_again *out,
                          const murk_transport_world *world,
                          murk_vec3 direction, int squares, double weight)
{
    const murk_box *box = &world->domain.box;
    const double one = weight / squares / squares;
    for (int i = 0; i < squares * squares; ++i) {
        const double u = (i % squares + 0.5) / squares;
        const double v = (i / squares + 0.5) / squares;
        const murk_vec3 floor =
            murk_vec(box->min.x + u * (box->max.x - box->min.x),
                     box->min.y + v * (box->max.y - box->min.y), box->min.z);
        way w = way_to(world, floor, direction);
        const murk_spectrum depth = depth_of(&w);
        for (int b = 0; b < world->bands; ++b) {
            out->optical_depth.band[b] += one * depth.band[b];
            out->transmittance.band[b] += one * exp(-depth.band[b]);
        }
    }
}

/* Equal parts of an even sky's irradiance: sin^2 and azimuth in equal steps. */
static void add_dome(murk_taken_again *out, const murk_transport_world *world)
{
    const murk_vec3 down = murk_vec(0, 0, -1);
    for (int i = 0; i < DOME_RINGS; ++i) {
        const double cosine = sqrt(1 - (i + 0.5) / DOME_RINGS);
        for (int k = 0; k < DOME_SPOKES; ++k) {
            const double azimuth = 2 * MURK_PI * (k + 0.5) / DOME_SPOKES;
            add_direction(out, world, murk_about(down, cosine, azimuth),
                          DOME_SQUARES, 1.0 / (DOME_RINGS * DOME_SPOKES));
        }
    }
}

murk_taken_again murk_taken_again_of(const murk_stage *stage, size_t light)
{
    const murk_source *l = murk_sources_get(stage->lights, light);
    const murk_transport_world *world = &stage->world;
    murk_taken_again out = {.is_known = false};
    double power = 0, through = 0;
    for (int b = 0; b < world->bands; ++b) {
        power += l->power_w.band[b];
    }
    const bool is_dome = murk_source_type_group(l->type) == MURK_SOURCE_DOME;
    if (!murk_source_is_distant(l) || !(power > 0) ||
        (!is_dome && !(l->direction.z < 0))) {
        return out;
    }
    if (!is_dome) {
        add_direction(&out, world, murk_unit(l->direction), BEAM_SQUARES, 1);
    } else {
        add_dome(&out, world);
    }
    for (int b = 0; b < world->bands; ++b) {
        through += l->power_w.band[b] * out.transmittance.band[b];
    }
    out.is_known = true;
    out.share = fmax(0, 1 - through / power);
    return out;
}
