/* The kernel of each photon record: tests points of the disc or ball around
 * the record, in a pattern that is turned at random, and integrates the kernel
 * over the points that lie on the same surface or in the medium and are
 * visible from the record. The radius is halved until enough of the kernel is
 * visible. */
#include "render/kernel.h"

#include "base/rng.h"
#include "geometry/disc.h"
#include "path/viewpoint.h"

/* The smallest visible share of a kernel that is accepted; for a smaller one
 * the radius is halved: a corner between three walls leaves a quarter of a disc
 * and an eighth of a ball. */
#define MIN_SHARE 0.1

/* The largest number of halvings of the radius: down to a thousandth. */
#define HALVINGS 10

/* The least cosine between two normals of one surface, which may be curved. */
#define ALIKE 0.5

/* The height of rays along a surface as a share of the radius, so that they
 * pass curved parts and small steps. */
#define EYE 0.25

/* The golden ratio minus 1: angles that rise by this part of a full turn are
 * spread evenly for any number of points. */
#define GOLDEN 0.6180339887498949

/* The step in spherical layers from one test point of a ball to the next:
 * coprime to the number of points, so that each point has a layer of its own.
 */
#define LAYER_STEP 29

static double index_at(const murk_scenery *scenery, murk_vec3 place)
{
    return scenery->bends ? murk_path_index_at(&scenery->tiling.space, place)
                          : 1;
}

static double scattering_at(const murk_scenery *scenery, int band,
                            murk_vec3 place)
{
    return murk_media_scattering(
        scenery->world->media, band,
        murk_path_inside(&scenery->tiling.space, place), place);
}

murk_probing murk_probing_of(const murk_scenery *scenery, uint32_t seed)
{
    murk_probing p = {.scenery = scenery, .seed = seed};
    for (int i = 0; i < MURK_PROBES; ++i) {
        const double angle = 2 * MURK_PI * i * GOLDEN;
        const double off = sqrt((i + 0.5) / MURK_PROBES);
        p.disc[i][0] = off * cos(angle);
        p.disc[i][1] = off * sin(angle);
        const double mu = 1 - 2 * (i + 0.5) / MURK_PROBES;
        const int layer = i * LAYER_STEP % MURK_PROBES;
        const double r = cbrt((layer + 0.5) / MURK_PROBES);
        p.ball[i][0] = r * sqrt(1 - mu * mu) * cos(angle);
        p.ball[i][1] = r * sqrt(1 - mu * mu) * sin(angle);
        p.ball[i][2] = r * mu;
    }
    return p;
}

/* ---- on surfaces ---- */

/* True if a point of a surface is visible from a point above the record, by a
 * path parallel to the surface and down to the point. */
static bool sees_surface(const murk_scenery *scenery, murk_vec3 from,
                         murk_vec3 up, double eye_m, murk_vec3 place)
{
    const murk_surfaces *surfaces = scenery->world->surfaces;
    const murk_vec3 offset = murk_sub(place, from);
    const double height = murk_dot(offset, up);
    const murk_vec3 eye = murk_along(from, eye_m, up);
    const murk_vec3 above = murk_along(place, eye_m - height, up);
    return height < eye_m &&
           !murk_surfaces_blocked(surfaces, eye, above, false) &&
           !murk_surfaces_blocked(surfaces, above, place, false);
}

/* The visible part of the mass of the kernel, as a share of the mass of a flat
 * disc that is visible as a whole. The part may exceed 1 on a curved
 * surface. */
static double share_on_surface(const murk_probing *probing, murk_vec3 from,
                               murk_vec3 up, const murk_kernel *kernel,
                               double turn)
{
    const murk_scenery *scenery = probing->scenery;
    const murk_transport_world *world = scenery->world;
    const double r = kernel->radius_m, eye_m = EYE * r;
    const murk_vec3 eye = murk_along(from, eye_m, up);
    const murk_vec3 down = murk_scale(-1, up);
    murk_vec3 t, b, above[MURK_PROBES];
    murk_frame(up, &t, &b);
    /* Test points at the height of the eye, turned about the normal. */
    const double c = r * cos(2 * MURK_PI * turn),
                 s = r * sin(2 * MURK_PI * turn);
    for (int i = 0; i < MURK_PROBES; ++i) {
        const double *at = probing->disc[i];
        above[i] = murk_along(murk_along(eye, c * at[0] - s * at[1], t),
                              s * at[0] + c * at[1], b);
    }
    /* Points that a surface hides from the eye do not count. */
    bool hidden[MURK_PROBES] = {false};
    if (kernel->is_cut) {
        if (murk_surfaces_blocked(world->surfaces, from, eye, false)) {
            return 0;
        }
        murk_surfaces_blocked_many(world->surfaces, above, MURK_PROBES, eye,
                                   false, hidden);
    }
    /* Project each visible test point along the normal onto the surface, and
     * integrate the kernel 1 - d^2 / r^2 over the surface at these points. If
     * nothing cuts the disc, the points stay in the plane of the disc. `whole`
     * is the sum of a disc that is visible as a whole. */
    double sum = 0, whole = 0;
    for (int i = 0; i < MURK_PROBES; ++i) {
        const double *at = probing->disc[i];
        const double square = at[0] * at[0] + at[1] * at[1];
        whole += 1 - square;
        murk_hit hit = {.distance_m = eye_m, .normal = up};
        if (hidden[i] ||
            (kernel->is_cut && !murk_surfaces_hit(world->surfaces, above[i],
                                                  down, eye_m + r, &hit))) {
            continue;
        }
        const double height = eye_m - hit.distance_m;
        const double far = square + height * height / (r * r);
        const double cosine = murk_dot(hit.normal, up);
        const murk_vec3 place = murk_along(above[i], hit.distance_m, down);
        if (far < 1 && cosine > ALIKE &&
            murk_box_contains(&world->domain.box, place) &&
            index_at(scenery, murk_along(place, scenery->margin_m,
                                         hit.normal)) == kernel->index) {
            sum += (1 - far) / cosine;
        }
    }
    return sum / whole;
}

static bool is_within(const murk_box *box, murk_vec3 p, murk_vec3 reach)
{
    return murk_box_contains(box, murk_sub(p, reach)) &&
           murk_box_contains(box, murk_add(p, reach));
}

/* The extent of a disc along the axes. */
static murk_vec3 reach_of(murk_vec3 up, double radius)
{
    return murk_vec(radius * sqrt(fmax(0, 1 - up.x * up.x)),
                    radius * sqrt(fmax(0, 1 - up.y * up.y)),
                    radius * sqrt(fmax(0, 1 - up.z * up.z)));
}

static murk_kernel on_surface(const murk_probing *probing,
                              const murk_photon *photon, double radius_m,
                              double turn)
{
    const murk_scenery *scenery = probing->scenery;
    const murk_transport_world *world = scenery->world;
    const murk_vec3 from = murk_photon_place(photon);
    const murk_vec3 up = murk_photon_normal(photon);
    murk_kernel kernel = {
        .radius_m = radius_m,
        .index = index_at(scenery, murk_along(from, scenery->margin_m, up))};
    /* A disc that nothing cuts needs no test points, unless the index of
     * refraction changes somewhere. */
    double share = 1;
    kernel.is_cut =
        !is_within(&world->domain.box, from, reach_of(up, radius_m)) ||
        !murk_surfaces_fill_disc(world->surfaces, from, up, radius_m);
    for (int i = 0; (kernel.is_cut || scenery->bends) && i < HALVINGS; ++i) {
        share = share_on_surface(probing, from, up, &kernel, turn);
        if (share >= MIN_SHARE) {
            break;
        }
        kernel.radius_m /= 2;
        share = 1;
    }
    /* The integral of 1 - d^2 / r^2 over a disc is pi r^2 / 2. */
    kernel.mass = share * MURK_PI / 2 * kernel.radius_m * kernel.radius_m;
    return kernel;
}

/* ---- in media ---- */

/* A random orthonormal frame (uniform rotations by Shoemake, Graphics Gems III,
 * 1992, p. 124). */
static void turned_frame(const double u[3], murk_vec3 axis[3])
{
    const double a = sqrt(1 - u[0]), b = sqrt(u[0]);
    const double x = a * sin(2 * MURK_PI * u[1]),
                 y = a * cos(2 * MURK_PI * u[1]);
    const double z = b * sin(2 * MURK_PI * u[2]),
                 w = b * cos(2 * MURK_PI * u[2]);
    axis[0] = murk_vec(1 - 2 * (y * y + z * z), 2 * (x * y + w * z),
                       2 * (x * z - w * y));
    axis[1] = murk_vec(2 * (x * y - w * z), 1 - 2 * (x * x + z * z),
                       2 * (y * z + w * x));
    axis[2] = murk_vec(2 * (x * z + w * y), 2 * (y * z - w * x),
                       1 - 2 * (x * x + y * y));
}

/* The mean of the scattering coefficient over the kernel, 0 at invisible
 * points; *share: the share of the kernel that is visible and scatters. */
static double mean_scattering(const murk_probing *probing, int band,
                              murk_vec3 from, const murk_kernel *kernel,
                              const murk_vec3 axis[3], double *share)
{
    const murk_scenery *scenery = probing->scenery;
    const murk_transport_world *world = scenery->world;
    const double r = kernel->radius_m;
    /* Test points in the ball, in the turned frame. */
    murk_vec3 place[MURK_PROBES];
    for (int i = 0; i < MURK_PROBES; ++i) {
        const double *at = probing->ball[i];
        place[i] = murk_along(murk_along(murk_along(from, r * at[0], axis[0]),
                                         r * at[1], axis[1]),
                              r * at[2], axis[2]);
    }
    bool hidden[MURK_PROBES] = {false};
    if (kernel->is_cut) {
        murk_surfaces_blocked_many(world->surfaces, place, MURK_PROBES, from,
                                   false, hidden);
    }
    /* Add up the scattering coefficient at the visible points. */
    double sum = 0, whole = 0, there = 0;
    for (int i = 0; i < MURK_PROBES; ++i) {
        const double *at = probing->ball[i];
        const double weight =
            1 - (at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
        whole += weight;
        if (hidden[i] || !murk_box_contains(&world->domain.box, place[i]) ||
            index_at(scenery, place[i]) != kernel->index) {
            continue;
        }
        const double scattering = scattering_at(scenery, band, place[i]);
        sum += weight * scattering;
        there += scattering > 0 ? weight : 0;
    }
    *share = there / whole;
    return sum / whole;
}

static murk_kernel in_medium(const murk_probing *probing,
                             const murk_photon *photon, double radius_m,
                             const double u[3])
{
    const murk_scenery *scenery = probing->scenery;
    murk_vec3 axis[3];
    turned_frame(u, axis);
    const murk_vec3 from = murk_photon_place(photon);
    murk_kernel kernel = {.radius_m = radius_m,
                          .index = index_at(scenery, from)};
    kernel.is_cut =
        scenery->any_surfaces &&
        murk_surfaces_near(scenery->world->surfaces, from, radius_m);
    /* Halve the radius until enough of the ball is visible and scatters. */
    double mean = 0, share = 0;
    for (int i = 0; i < HALVINGS; ++i) {
        mean = mean_scattering(probing, murk_photon_band(photon), from, &kernel,
                               axis, &share);
        if (share >= MIN_SHARE) {
            break;
        }
        kernel.radius_m /= 2;
    }
    if (!(share >= MIN_SHARE)) {
        mean = scattering_at(scenery, murk_photon_band(photon), from);
    }
    /* The integral of 1 - d^2 / r^2 over a ball is 8 pi r^3 / 15. */
    const double r = kernel.radius_m;
    kernel.mass = mean * 8 * MURK_PI / 15 * r * r * r;
    return kernel;
}

murk_kernel murk_kernel_of(const murk_probing *probing,
                           const murk_photon *photon, double radius_m,
                           uint64_t number)
{
    const murk_random4 turn =
        murk_random(probing->seed, MURK_KERNEL, number, murk_photon_tag(photon),
                    murk_photon_band(photon));
    return murk_photon_is_volume(photon)
               ? in_medium(probing, photon, radius_m, turn.u)
               : on_surface(probing, photon, radius_m, turn.u[0]);
}

bool murk_kernel_holds(const murk_scenery *scenery, const murk_photon *photon,
                       const murk_kernel *kernel, murk_vec3 place,
                       murk_vec3 normal, double index)
{
    const bool is_volume = murk_photon_is_volume(photon);
    const murk_vec3 up = murk_photon_normal(photon);
    if ((!is_volume && murk_dot(up, normal) <= ALIKE) ||
        (scenery->bends && index != kernel->index)) {
        return false;
    }
    if (!kernel->is_cut) {
        return true;
    }
    const murk_vec3 from = murk_photon_place(photon);
    return is_volume
               ? !murk_surfaces_blocked(scenery->world->surfaces, from, place,
                                        false)
               : sees_surface(scenery, from, up, EYE * kernel->radius_m, place);
}
