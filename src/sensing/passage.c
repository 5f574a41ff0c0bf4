#include "sensing/passage.h"

#include "medium/interfaces.h"
#include "sensing/segment.h"

/* More boundaries than this on one way are no scene's: rounding has caught the
 * ray between two of them. */
#define STEPS_MAX 100000

murk_passages murk_passages_from(const murk_media *media,
                                 const murk_hulls *hulls,
                                 const murk_domain *domain, murk_vec3 sensor)
{
    return (murk_passages){.media = media,
                           .hulls = hulls,
                           .domain = domain,
                           .sensor = sensor,
                           .around = hulls ? murk_hulls_at(hulls, sensor) : 0};
}

/* The pieces from the sensor on, in their order. */
static int cut(const murk_passages *p, murk_vec3 photon, murk_segment *piece)
{
    return murk_segment_cut(p->domain, p->sensor,
                            murk_nearest_image(p->domain, photon, p->sensor), 0,
                            piece);
}

/* A piece of the way. After the first it begins in a side of the domain, where
 * a mesh's face is no boundary and is looked past. */
typedef struct leg {
    murk_vec3 from, direction;
    double length_m, look_from_m;
    murk_inside inside; /* meshes */
} leg;

static leg leg_of(const murk_passages *p, int piece, const murk_segment *way)
{
    const murk_vec3 along = murk_sub(way->to, way->from);
    const double length = murk_length(along);
    leg l = {.from = way->from, .length_m = length, .inside = p->around};
    if (length > 0) {
        l.direction = murk_scale(1 / length, along);
    }
    if (piece > 0) {
        l.look_from_m = murk_hulls_tolerance_m(p->hulls);
        l.inside = murk_hulls_at(
            p->hulls, murk_along(l.from, 2 * l.look_from_m, l.direction));
    }
    return l;
}

static double depth_through_meshes(const murk_passages *p, int band,
                                   const leg *l)
{
    const double tolerance = murk_hulls_tolerance_m(p->hulls);
    double depth = 0, from = 0, look_from = l->look_from_m;
    murk_inside inside = l->inside;
    murk_crossing c;
    for (int step = 0; step < STEPS_MAX &&
                       murk_hulls_next(p->hulls, l->from, l->direction,
                                       look_from, l->length_m, &inside, &c);
         ++step) {
        depth += murk_media_optical_depth(
            p->media, band, inside, murk_along(l->from, from, l->direction),
            l->direction, c.distance_m - from);
        from = c.distance_m;
        look_from = from + tolerance;
        inside = c.inside;
    }
    return depth +
           murk_media_optical_depth(p->media, band, inside,
                                    murk_along(l->from, from, l->direction),
                                    l->direction, l->length_m - from);
}

double murk_passage_transmittance(const murk_passages *p, int band,
                                  murk_vec3 photon)
{
    murk_segment piece[MURK_SEGMENT_PIECES];
    double through = 1;
    if (!p->hulls) {
        /* From the photon on. */
        const murk_vec3 to = murk_nearest_image(p->domain, p->sensor, photon);
        const int n = murk_segment_cut(p->domain, photon, to, 0, piece);
        for (int i = 0; i < n; ++i) {
            through *= murk_media_transmittance(p->media, band, 0,
                                                piece[i].from, piece[i].to);
        }
        return through;
    }
    const int n = cut(p, photon, piece);
    for (int i = 0; i < n; ++i) {
        const leg l = leg_of(p, i, &piece[i]);
        if (l.length_m > 0) {
            through *= exp(-depth_through_meshes(p, band, &l));
        }
    }
    return through;
}

/* Follows boundaries of both kinds, each as the set says; those of meshes and
 * others within the tolerance are passed at once. */
static bool bends_through_meshes(const murk_passages *p, const leg *l)
{
    const double tolerance = murk_hulls_tolerance_m(p->hulls);
    double from = 0, look_from = l->look_from_m, ior = 0;
    murk_inside inside = l->inside | murk_media_inside(p->media, l->from);
    for (int step = 0; step < STEPS_MAX; ++step) {
        murk_boundary b;
        murk_crossing c;
        const bool any_plain = murk_media_boundary(
            p->media, inside, murk_along(l->from, from, l->direction),
            l->direction, l->length_m - from, &b);
        const double plain = any_plain ? from + b.distance_m : INFINITY;
        const double most = fmin(l->length_m - tolerance, plain + tolerance);
        const bool any_mesh = murk_hulls_next(p->hulls, l->from, l->direction,
                                              look_from, most, &inside, &c);
        const double mesh = any_mesh ? c.distance_m : INFINITY;
        if (step == 0) {
            ior = murk_media_index(p->media, inside);
        }
        if (!any_plain && !any_mesh) {
            return false;
        }
        if (any_mesh) {
            inside ^= c.changed;
            from = mesh;
            look_from = mesh + tolerance;
        }
        if (plain <= mesh + tolerance) {
            inside ^= b.crossed;
            from = plain;
        }
        if (murk_media_index(p->media, inside) != ior) {
            return true;
        }
    }
    return false;
}

bool murk_passage_bends(const murk_passages *p, murk_vec3 photon)
{
    if (!p->hulls) {
        return murk_segment_bends(p->media, p->domain, photon, p->sensor);
    }
    murk_segment piece[MURK_SEGMENT_PIECES];
    const int n = cut(p, photon, piece);
    for (int i = 0; i < n; ++i) {
        const leg l = leg_of(p, i, &piece[i]);
        if (l.length_m > 0 && bends_through_meshes(p, &l)) {
            return true;
        }
    }
    return false;
}
