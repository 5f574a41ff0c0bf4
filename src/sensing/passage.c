#include "sensing/passage.h"

#include "medium/interfaces.h"
#include "sensing/segment.h"

/* More boundaries than this on one way are no scene's: rounding has caught the
 * ray between two of them. */
#define STEPS_MAX 100000

murk_passages murk_passages_from(const murk_media *media,
                                 const murk_boundary_meshes *boundary_meshes,
                                 const murk_domain *domain, murk_vec3 sensor)
{
    murk_passages p = {.media = media,
                       .boundary_meshes = boundary_meshes,
                       .domain = domain,
                       .sensor = sensor,
                       .around = boundary_meshes ? murk_boundary_meshes_at(
                                                       boundary_meshes, sensor)
                                                 : 0};
    p.index =
        murk_media_index(media, p.around | murk_media_inside(media, sensor));
    return p;
}

double murk_passage_index(const murk_passages *p, murk_vec3 place)
{
    const murk_inside meshes =
        p->boundary_meshes ? murk_boundary_meshes_at(p->boundary_meshes, place)
                           : 0;
    return murk_media_index(p->media,
                            meshes | murk_media_inside(p->media, place));
}

/* A piece of the way. After the first it begins in a side of the domain, where
 * a mesh's face is no boundary and is looked past. */
static murk_leg leg_of(const murk_passages *p, int piece,
                       const murk_segment *way)
{
    const murk_vec3 along = murk_sub(way->to, way->from);
    const double length = murk_length(along);
    murk_leg l = {.from = way->from, .length_m = length, .inside = p->around};
    if (length > 0) {
        l.direction = murk_scale(1 / length, along);
    }
    if (piece > 0 && p->boundary_meshes) {
        l.look_from_m = murk_boundary_meshes_tolerance_m(p->boundary_meshes);
        l.inside = murk_boundary_meshes_at(
            p->boundary_meshes,
            murk_along(l.from, 2 * l.look_from_m, l.direction));
    }
    l.inside |= murk_media_inside(p->media, l.from);
    return l;
}

int murk_passage_legs(const murk_passages *p, murk_vec3 point,
                      murk_leg leg[MURK_SEGMENT_PIECES])
{
    murk_segment piece[MURK_SEGMENT_PIECES];
    const int n = murk_segment_cut(
        p->domain, p->sensor, murk_nearest_image(p->domain, point, p->sensor),
        0, piece);
    for (int i = 0; i < n; ++i) {
        leg[i] = leg_of(p, i, &piece[i]);
    }
    return n;
}

static double depth_through_meshes(const murk_passages *p, int band,
                                   const murk_leg *l)
{
    const double tolerance =
        murk_boundary_meshes_tolerance_m(p->boundary_meshes);
    double depth = 0, from = 0, look_from = l->look_from_m;
    murk_inside inside = l->inside;
    murk_crossing c;
    for (int step = 0;
         step < STEPS_MAX &&
         murk_boundary_meshes_next(p->boundary_meshes, l->from, l->direction,
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

/* Of the pieces of the way to a photon, in their order; returns how many. */
static int depths_of(const murk_passages *p, int band, murk_vec3 photon,
                     double depth[MURK_SEGMENT_PIECES])
{
    if (!p->boundary_meshes) {
        /* From the photon on. */
        murk_segment piece[MURK_SEGMENT_PIECES];
        const murk_vec3 to = murk_nearest_image(p->domain, p->sensor, photon);
        const int n = murk_segment_cut(p->domain, photon, to, 0, piece);
        for (int i = 0; i < n; ++i) {
            const murk_vec3 way = murk_sub(piece[i].to, piece[i].from);
            const double length = murk_length(way);
            depth[i] = length > 0 ? murk_media_optical_depth(
                                        p->media, band, 0, piece[i].from,
                                        murk_scale(1 / length, way), length)
                                  : 0;
        }
        return n;
    }
    murk_leg leg[MURK_SEGMENT_PIECES];
    const int n = murk_passage_legs(p, photon, leg);
    for (int i = 0; i < n; ++i) {
        depth[i] =
            leg[i].length_m > 0 ? depth_through_meshes(p, band, &leg[i]) : 0;
    }
    return n;
}

double murk_passage_depth(const murk_passages *p, int band, murk_vec3 photon)
{
    double piece[MURK_SEGMENT_PIECES], depth = 0;
    const int n = depths_of(p, band, photon, piece);
    for (int i = 0; i < n; ++i) {
        depth += piece[i];
    }
    return depth;
}

double murk_passage_transmittance(const murk_passages *p, int band,
                                  murk_vec3 photon)
{
    double piece[MURK_SEGMENT_PIECES], through = 1;
    const int n = depths_of(p, band, photon, piece);
    for (int i = 0; i < n; ++i) {
        through *= exp(-piece[i]);
    }
    return through;
}

bool murk_passage_change(const murk_passages *p, const murk_leg *l,
                         murk_index_change *change)
{
    const double tolerance =
        p->boundary_meshes
            ? murk_boundary_meshes_tolerance_m(p->boundary_meshes)
            : 0;
    double from = 0, look_from = l->look_from_m, before = 0;
    murk_inside inside = l->inside;
    for (int step = 0; step < STEPS_MAX; ++step) {
        murk_boundary b;
        murk_crossing c;
        const bool any_plain = murk_media_boundary(
            p->media, inside, murk_along(l->from, from, l->direction),
            l->direction, l->length_m - from, &b);
        const double plain = any_plain ? from + b.distance_m : INFINITY;
        const double max = fmin(l->length_m - tolerance, plain + tolerance);
        const bool any_mesh =
            p->boundary_meshes &&
            murk_boundary_meshes_next(p->boundary_meshes, l->from, l->direction,
                                      look_from, max, &inside, &c);
        const double mesh = any_mesh ? c.distance_m : INFINITY;
        if (step == 0) {
            before = murk_media_index(p->media, inside);
        }
        if (!any_plain && !any_mesh) {
            return false;
        }
        if (any_mesh) {
            inside ^= c.changed;
            from = mesh;
            look_from = mesh + tolerance;
            change->normal = c.normal;
            change->is_mesh = true;
        }
        if (plain <= mesh + tolerance) {
            inside ^= b.crossed;
            from = plain;
            change->normal = b.normal;
            change->is_mesh = false;
        }
        const double beyond = murk_media_index(p->media, inside);
        if (beyond != before) {
            change->distance_m = from;
            change->before = before;
            change->beyond = beyond;
            change->inside = inside;
            return true;
        }
    }
    return false;
}

bool murk_passage_bends(const murk_passages *p, murk_vec3 photon)
{
    if (!p->boundary_meshes) {
        return murk_segment_bends(p->media, p->domain, photon, p->sensor);
    }
    murk_leg leg[MURK_SEGMENT_PIECES];
    const int n = murk_passage_legs(p, photon, leg);
    for (int i = 0; i < n; ++i) {
        murk_index_change change;
        if (leg[i].length_m > 0 && murk_passage_change(p, &leg[i], &change)) {
            return true;
        }
    }
    return false;
}
