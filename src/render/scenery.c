#include "render/scenery.h"

#include "medium/interfaces.h"
#include "transport/outside.h"

#include <stdlib.h>

/* Share of the domain's largest coordinate that surfaces may be off by: some
 * times what murk_surfaces_leave() moves by. */
#define OFF_BY 1e-5

/* Sightlines go to a point's nearest image, so pieces stay below half a
 * period sideways. */
#define PIECE_OF_PERIOD 0.45

/* A jump through free heights must rise by this share of the domain's largest
 * coordinate at least: the optical depth of the rise then keeps 6 digits. */
#define MIN_RISE 1e-9

/* A way that has wrapped so often is almost level: its light has crossed the
 * domain often enough to be taken for lost. */
#define PIECES_MAX 10000

/* ---- pieces of a way ---- */

typedef struct pieces {
    const murk_scenery *scenery;
    murk_vec3 at, direction;
    double left_m;
    int n;
    murk_vec3 from, to; /* the present piece */
    bool leaves;        /* it ends at the domain's open side */
    double stretch;     /* length of the way over that of the piece: not 1 where
                           the piece is the rise of a jump (jump_ahead()) */
} pieces;

static murk_vec3 held(const murk_box *box, murk_vec3 p)
{
    return murk_vec(fmin(fmax(p.x, box->min.x), box->max.x),
                    fmin(fmax(p.y, box->min.y), box->max.y),
                    fmin(fmax(p.z, box->min.z), box->max.z));
}

/* To the side ahead along one axis; INFINITY where there is none. */
static double side_ahead(double p, double d, double low, double high)
{
    return d > 0   ? fmax(0, (high - p) / d)
           : d < 0 ? fmax(0, (low - p) / d)
                   : INFINITY;
}

/* How far the way leads through heights where nothing depends on x and y: no
 * surface and no bounded region lies there. 0 in a domain that is not
 * periodic, and where the way is too short or too level for a jump. */
static double jump_ahead(const pieces *p)
{
    const murk_scenery *scenery = p->scenery;
    const murk_domain *domain = &scenery->world->domain;
    const double z = p->at.z, dz = p->direction.z;
    if (!domain->is_periodic ||
        (z < scenery->free_above_m && z > scenery->free_below_m)) {
        return 0;
    }
    /* The end of the free heights: a side of the domain, or what lies between
     * the free heights. */
    double end = dz > 0 ? domain->box.max.z : domain->box.min.z;
    if (dz > 0 && z <= scenery->free_below_m) {
        end = fmin(end, scenery->free_below_m);
    } else if (dz < 0 && z >= scenery->free_above_m) {
        end = fmax(end, scenery->free_above_m);
    }
    const double run = fmin((end - z) / dz, p->left_m);
    const double sideways = fmax(fabs(p->direction.x), fabs(p->direction.y));
    const double minimum = MIN_RISE / OFF_BY * scenery->margin_m;
    return run * sideways > scenery->piece_m && run * fabs(dz) > minimum ? run
                                                                         : 0;
}

static double wrapped(double x, double min, double max)
{
    const double period = max - min;
    return fmin(fmax(x - period * floor((x - min) / period), min), max);
}

/* The piece is the rise alone; the way goes on where it leads to. */
static void jump(pieces *p, double run)
{
    const murk_box *box = &p->scenery->world->domain.box;
    const murk_vec3 end = murk_along(p->at, run, p->direction);
    p->from = p->at;
    p->to = held(box, murk_vec(p->at.x, p->at.y, end.z));
    p->at = murk_vec(wrapped(end.x, box->min.x, box->max.x),
                     wrapped(end.y, box->min.y, box->max.y), p->to.z);
    p->stretch = 1 / fabs(p->direction.z);
    p->left_m -= run;
    p->leaves =
        p->direction.z > 0 ? p->to.z >= box->max.z : p->to.z <= box->min.z;
}

/* False at the way's end. */
static bool next_piece(pieces *p)
{
    if (!(p->left_m > 0) || p->leaves || p->n >= PIECES_MAX) {
        return false;
    }
    ++p->n;
    const double run = jump_ahead(p);
    if (run > 0) {
        jump(p, run);
        return true;
    }
    p->stretch = 1;
    const murk_domain *domain = &p->scenery->world->domain;
    const murk_box *box = &domain->box;
    const murk_vec3 d = p->direction;
    const double x = side_ahead(p->at.x, d.x, box->min.x, box->max.x);
    const double y = side_ahead(p->at.y, d.y, box->min.y, box->max.y);
    const double z = side_ahead(p->at.z, d.z, box->min.z, box->max.z);
    const double side = fmin(x, fmin(y, z));
    const double sideways = fmax(fabs(d.x), fabs(d.y));
    const double step =
        fmin(side, fmin(p->left_m, p->scenery->piece_m / sideways));
    p->from = p->at;
    p->to = held(box, murk_along(p->at, step, d));
    p->at = p->to;
    p->left_m -= step;
    if (step < side) {
        return true;
    }
    p->leaves = !domain->is_periodic || z <= side;
    if (!p->leaves && x <= side) {
        p->at.x = d.x > 0 ? box->min.x : box->max.x;
    } else if (!p->leaves) {
        p->at.y = d.y > 0 ? box->min.y : box->max.y;
    }
    return true;
}

static pieces pieces_of(const murk_scenery *scenery, murk_vec3 from,
                        murk_vec3 direction, double length_m)
{
    return (pieces){.scenery = scenery,
                    .at = held(&scenery->world->domain.box, from),
                    .direction = direction,
                    .left_m = length_m};
}

/* What one piece lets through: nothing where the index of refraction changes.
 */
static double piece_through(const pieces *p, int band)
{
    const murk_scenery *scenery = p->scenery;
    const murk_transport_world *world = scenery->world;
    const murk_passages passages = murk_passages_from(
        world->media, world->boundary_meshes, &world->domain, p->from);
    if (scenery->bends && murk_passage_bends(&passages, p->to)) {
        return 0;
    }
    return scenery->any_media
               ? exp(-p->stretch * murk_passage_depth(&passages, band, p->to))
               : 1;
}

double murk_scenery_through(const murk_scenery *scenery, int band,
                            murk_vec3 from, murk_vec3 direction,
                            double length_m, bool through_sheets)
{
    const murk_surfaces *surfaces = scenery->world->surfaces;
    double through = 1;
    pieces p = pieces_of(scenery, from, direction, length_m);
    while (next_piece(&p) && through > 0) {
        if (scenery->any_surfaces && p.stretch == 1) {
            /* What lies in the domain's side stands in the way, too. */
            const murk_vec3 to =
                p.leaves ? murk_along(p.to, scenery->margin_m, direction)
                         : p.to;
            const bool sheets = through_sheets && scenery->any_sheets;
            if (murk_surfaces_blocked(surfaces, p.from, to, sheets)) {
                return 0;
            }
            if (sheets) {
                through *= murk_surfaces_sheet_transmittance(surfaces, p.from,
                                                             to, band);
            }
        }
        through *= piece_through(&p, band);
    }
    if (p.leaves && length_m == INFINITY && through > 0) {
        /* to the sun or sky: what the media outside of the domain take */
        through *= murk_outside_straight(scenery->world, band, p.to,
                                         murk_scale(-1, direction));
    }
    return p.n < PIECES_MAX ? through : 0;
}

murk_scenery_end murk_scenery_look(const murk_scenery *scenery, murk_vec3 from,
                                   murk_vec3 direction)
{
    const murk_transport_world *world = scenery->world;
    murk_scenery_end end = {0};
    pieces p = pieces_of(scenery, from, direction, INFINITY);
    while (next_piece(&p)) {
        const murk_vec3 way = p.stretch == 1
                                  ? direction
                                  : murk_vec(0, 0, copysign(1, direction.z));
        double length = murk_length(murk_sub(p.to, p.from));
        murk_hit hit;
        const bool met = scenery->any_surfaces && p.stretch == 1 &&
                         murk_surfaces_hit(world->surfaces, p.from, direction,
                                           length + scenery->margin_m, &hit);
        if (met) {
            length = hit.distance_m;
        }
        bool bends = false;
        if (scenery->bends) {
            const murk_passages passages = murk_passages_from(
                world->media, world->boundary_meshes, &world->domain, p.from);
            murk_leg leg[MURK_SEGMENT_PIECES];
            murk_index_change change;
            const murk_vec3 to =
                held(&world->domain.box, murk_along(p.from, length, way));
            bends = murk_passage_legs(&passages, to, leg) > 0 &&
                    murk_passage_change(&passages, &leg[0], &change);
            length = bends ? change.distance_m : length;
        }
        end.distance_m += length * p.stretch;
        if (met && !bends) {
            end.is_surface = true;
            end.position =
                held(&world->domain.box, murk_along(p.from, length, direction));
            end.normal = hit.normal;
        }
        if (met || bends) {
            break;
        }
    }
    return end;
}

double murk_scenery_depth(const murk_scenery *scenery, int band, murk_vec3 from,
                          murk_vec3 direction, double length_m)
{
    double depth = 0;
    pieces p = pieces_of(scenery, from, direction, length_m);
    while (scenery->any_media && next_piece(&p)) {
        const murk_transport_world *world = scenery->world;
        const murk_passages passages = murk_passages_from(
            world->media, world->boundary_meshes, &world->domain, p.from);
        depth += p.stretch * murk_passage_depth(&passages, band, p.to);
    }
    return depth;
}

/* ---- preparing ---- */

/* Drawn half by power, half evenly: none is starved by a bright one that does
 * not reach where the picture is taken. */
static murk_status add_lights(murk_scenery *scenery, int band, murk_error *err)
{
    const murk_sources *lights = scenery->world->lights;
    const size_t n = murk_sources_count(lights);
    const size_t bands = (size_t)scenery->world->bands;
    size_t *lit = calloc(n + 1, sizeof *lit);
    double *chance = calloc(n + 1, sizeof *chance);
    scenery->lit[band] = lit;
    scenery->chance[band] = chance;
    if (!lit || !chance) {
        return murk_fail(err, MURK_NO_MEMORY, "render",
                         "no memory for %zu lights", n);
    }
    size_t n_lit = 0;
    double all = 0;
    for (size_t i = 0; i < n; ++i) {
        const double power =
            murk_sources_channel_power_w(lights, i * bands + (size_t)band);
        if (power > 0) {
            lit[n_lit++] = i;
            all += power;
        }
    }
    double sum = 0;
    for (size_t i = 0; i < n_lit; ++i) {
        const double power =
            murk_sources_channel_power_w(lights, lit[i] * bands + (size_t)band);
        sum += 0.5 * power / all + 0.5 / (double)n_lit;
        chance[i] = sum;
    }
    scenery->n_lit[band] = n_lit;
    return MURK_OK;
}

murk_status murk_scenery_prepare(murk_scenery *scenery,
                                 const murk_transport_world *world,
                                 murk_error *err)
{
    const murk_surfaces_facts facts = murk_surfaces_describe(world->surfaces);
    const murk_vec3 a = world->domain.box.min, b = world->domain.box.max;
    const double size = fmax(fmax(fmax(fabs(a.x), fabs(a.y)), fabs(a.z)),
                             fmax(fmax(fabs(b.x), fabs(b.y)), fabs(b.z)));
    const murk_box bounded = murk_media_bounds(world->media);
    const double margin_m = OFF_BY * size;
    *scenery = (murk_scenery){
        .world = world,
        .free_below_m = fmin(facts.bounds_m.min.z, bounded.min.z) - margin_m,
        .free_above_m = fmax(facts.bounds_m.max.z, bounded.max.z) + margin_m,
        .any_surfaces = facts.triangles + facts.spheres > 0,
        .any_sheets = facts.sheets > 0,
        .any_media = murk_media_any(world->media),
        .bends = murk_media_bends(world->media),
        .margin_m = margin_m,
        .piece_m = world->domain.is_periodic
                       ? PIECE_OF_PERIOD * fmin(b.x - a.x, b.y - a.y)
                       : INFINITY};
    murk_status status = MURK_OK;
    for (int band = 0; band < world->bands && !status; ++band) {
        status = add_lights(scenery, band, err);
    }
    return status;
}

void murk_scenery_release(murk_scenery *scenery)
{
    for (int band = 0; band < MURK_BANDS_MAX; ++band) {
        free(scenery->lit[band]);
        free(scenery->chance[band]);
    }
    *scenery = (murk_scenery){0};
}
