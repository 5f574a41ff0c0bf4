/* Straight rays through the world for pictures: transmittance, the first thing
 * seen, and optical depth, piece by piece (path/pieces.h); and how often shadow
 * rays go to each light. */
#include "render/scenery.h"

#include "path/viewpoint.h"
#include "transport/outside.h"

#include <stdlib.h>

/* Share of the domain's largest coordinate that surfaces may be off by: some
 * ten times the step of murk_surfaces_leave(). */
#define OFF_BY 1e-5

/* Sightlines go to the nearest image of a point, so a piece stays below half a
 * period sideways. */
#define PIECE_OF_PERIOD 0.45

/* A ray with more pieces is almost level: its light has crossed the domain
 * often enough to be taken for lost. */
#define PIECES_MAX 10000

/* Transmittance of the present piece: 0 if the index of refraction changes. */
static double piece_through(const murk_scenery *scenery,
                            const murk_path_piece *piece, int band)
{
    const murk_path_viewpoint v =
        murk_path_viewpoint_at(&scenery->tiling.space, piece->from);
    if (scenery->bends && murk_path_bends_to(&v, piece->to)) {
        return 0;
    }
    return scenery->any_media
               ? exp(-piece->stretch * murk_path_depth_to(&v, band, piece->to))
               : 1;
}

double murk_scenery_through(const murk_scenery *scenery, int band,
                            murk_vec3 from, murk_vec3 direction,
                            double length_m, bool through_sheets)
{
    const murk_surfaces *surfaces = scenery->world->surfaces;
    double through = 1;
    int n = 0;
    murk_path_pieces p =
        murk_path_pieces_of(&scenery->tiling, from, direction, length_m);
    const murk_path_piece *piece = &p.piece;
    while (n < PIECES_MAX && murk_path_next_piece(&p) && through > 0) {
        ++n;
        if (scenery->any_surfaces && piece->stretch == 1) {
            /* A surface in the domain's side blocks the ray, too. */
            const murk_vec3 to =
                piece->leaves
                    ? murk_along(piece->to, scenery->margin_m, direction)
                    : piece->to;
            const bool sheets = through_sheets && scenery->any_sheets;
            if (murk_surfaces_blocked(surfaces, piece->from, to, sheets)) {
                return 0;
            }
            if (sheets) {
                through *= murk_surfaces_sheet_transmittance(
                    surfaces, piece->from, to, band);
            }
        }
        through *= piece_through(scenery, piece, band);
    }
    if (piece->leaves && length_m == INFINITY && through > 0) {
        /* to the sun or sky: the media outside of the domain */
        through *= murk_outside_straight(scenery->world, band, piece->to,
                                         murk_scale(-1, direction));
    }
    return n < PIECES_MAX ? through : 0;
}

murk_scenery_end murk_scenery_find_end(const murk_scenery *scenery,
                                       murk_vec3 from, murk_vec3 direction)
{
    const murk_path_sides *sides = &scenery->tiling.space.sides;
    murk_scenery_end end = {0};
    murk_path_pieces p =
        murk_path_pieces_of(&scenery->tiling, from, direction, INFINITY);
    for (int n = 0; n < PIECES_MAX && murk_path_next_piece(&p); ++n) {
        const murk_path_stop stop = murk_path_piece_stop(&p, scenery->margin_m);
        end.distance_m += stop.length_m * p.piece.stretch;
        if (stop.is_surface) {
            end.is_surface = true;
            end.position = murk_path_sides_hold(
                sides, murk_along(p.piece.from, stop.length_m, direction));
            end.normal = stop.hit.normal;
        }
        if (stop.is_surface || stop.is_bend) {
            break;
        }
    }
    return end;
}

bool murk_scenery_begin(const murk_scenery *scenery, murk_camera_ray *out,
                        const murk_camera *camera, double x, double y,
                        murk_vec3 direction)
{
    return murk_camera_begin(
        out, camera, x, y, direction, &scenery->world->domain.box,
        murk_surfaces_leave_step_m(scenery->world->surfaces));
}

double murk_scenery_depth(const murk_scenery *scenery, int band, murk_vec3 from,
                          murk_vec3 direction, double length_m)
{
    double depth = 0;
    murk_path_pieces p =
        murk_path_pieces_of(&scenery->tiling, from, direction, length_m);
    for (int n = 0;
         scenery->any_media && n < PIECES_MAX && murk_path_next_piece(&p);
         ++n) {
        const murk_path_viewpoint v =
            murk_path_viewpoint_at(&scenery->tiling.space, p.piece.from);
        depth += p.piece.stretch * murk_path_depth_to(&v, band, p.piece.to);
    }
    return depth;
}

/* ---- preparing ---- */

/* Lists the lights of a band with their chances: half by power and half equal,
 * so that a light near the camera has shadow rays even beside a bright one that
 * does not reach the picture. */
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
        return murk_no_memory(err, "render", "for %zu lights", n);
    }
    /* The lights that have power in the band. */
    size_t n_lit = 0;
    double all = 0;
    for (size_t i = 0; i < n; ++i) {
        const double power =
            murk_sources_channel_power_w(lights, i * bands + (size_t)band);
        if (power > 0) {
            chance[n_lit] = power;
            lit[n_lit++] = i;
            all += power;
        }
    }
    /* Cumulative chances of them. */
    double sum = 0;
    for (size_t i = 0; i < n_lit; ++i) {
        sum += 0.5 * chance[i] / all + 0.5 / (double)n_lit;
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
    const murk_box *box = &world->domain.box;
    const murk_box bounded = murk_media_bounds(world->media);
    const double margin_m = OFF_BY * murk_box_largest_coordinate(box);
    /* The heights beyond which nothing depends on x and y keep clear of
     * surfaces and bounded regions. */
    *scenery = (murk_scenery){
        .world = world,
        .tiling = {.space = murk_path_space_of(world->surfaces, world->media,
                                               world->boundary_meshes,
                                               &world->domain),
                   .repeats = world->domain.is_periodic,
                   .sideways_max_m =
                       world->domain.is_periodic
                           ? PIECE_OF_PERIOD * fmin(box->max.x - box->min.x,
                                                    box->max.y - box->min.y)
                           : INFINITY,
                   .free_below_m =
                       fmin(facts.bounds_m.min.z, bounded.min.z) - margin_m,
                   .free_above_m =
                       fmax(facts.bounds_m.max.z, bounded.max.z) + margin_m},
        .any_surfaces = facts.triangles + facts.spheres > 0,
        .any_sheets = facts.sheets > 0,
        .any_media = murk_media_any(world->media),
        .bends = murk_media_bends(world->media),
        .margin_m = margin_m};
    /* The lights of each band. */
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
