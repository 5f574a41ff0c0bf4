/* Long straight rays through a domain that may repeat: see path/pieces.h. */
#include "path/pieces.h"

/* A jump must rise or fall by more than this share of the domain's largest
 * coordinate: the difference of the two heights, and with it the optical depth
 * of the jump, then keeps 6 digits in double precision. */
#define RISE_MIN 1e-9

murk_path_pieces murk_path_pieces_of(const murk_path_tiling *tiling,
                                     murk_vec3 from, murk_vec3 direction,
                                     double length_m)
{
    return (murk_path_pieces){
        .tiling = tiling,
        .at = murk_path_sides_hold(&tiling->space.sides, from),
        .direction = direction,
        .left_m = length_m};
}

/* Length along the ray of a jump through heights in which nothing depends on x
 * and y (free heights). 0 if the domain does not repeat, if the ray is not at a
 * free height, if the jump would extend by no more than sideways_max_m in x and
 * in y, or if it would hardly rise or fall (RISE_MIN). */
static double jump_ahead(const murk_path_pieces *p)
{
    const murk_path_tiling *t = p->tiling;
    const murk_path_sides *sides = &t->space.sides;
    const double z = p->at.z, dz = p->direction.z;
    if (!t->repeats || (z < t->free_above_m && z > t->free_below_m)) {
        return 0;
    }
    /* The free heights end at a side of the domain, or at the heights between
     * the two free ranges. */
    double end = sides->z[dz > 0];
    if (dz > 0 && z <= t->free_below_m) {
        end = fmin(end, t->free_below_m);
    } else if (dz < 0 && z >= t->free_above_m) {
        end = fmax(end, t->free_above_m);
    }
    const double run = fmin((end - z) / dz, p->left_m);
    const double sideways = fmax(fabs(p->direction.x), fabs(p->direction.y));
    const double rise_min =
        RISE_MIN * murk_box_largest_coordinate(&t->space.domain->box);
    return run * sideways > t->sideways_max_m && run * fabs(dz) > rise_min ? run
                                                                           : 0;
}

static void jump(murk_path_pieces *p, double run)
{
    const murk_path_sides *sides = &p->tiling->space.sides;
    const murk_vec3 end = murk_along(p->at, run, p->direction);
    murk_path_piece *piece = &p->piece;
    piece->from = p->at;
    piece->to = murk_path_sides_hold(sides, murk_vec(p->at.x, p->at.y, end.z));
    p->at = murk_vec(murk_path_side_wrap(end.x, sides->x),
                     murk_path_side_wrap(end.y, sides->y), piece->to.z);
    piece->stretch = 1 / fabs(p->direction.z);
    p->left_m -= run;
    piece->leaves = p->direction.z > 0 ? piece->to.z >= sides->z[1]
                                       : piece->to.z <= sides->z[0];
}

bool murk_path_next_piece(murk_path_pieces *p)
{
    if (!(p->left_m > 0) || p->piece.leaves) {
        return false;
    }
    const double run = jump_ahead(p);
    if (run > 0) {
        jump(p, run);
        return true;
    }
    /* The piece ends at the side of the domain, at the end of the ray, or after
     * the largest extent of a piece. */
    const murk_path_tiling *t = p->tiling;
    const murk_path_sides *sides = &t->space.sides;
    const murk_vec3 d = p->direction;
    const double side_m = murk_path_sides_ahead(sides, p->at, d);
    const int axis = murk_path_sides_axis(sides, p->at, d);
    const double sideways = fmax(fabs(d.x), fabs(d.y));
    const double step =
        fmin(side_m, fmin(p->left_m, t->sideways_max_m / sideways));
    murk_path_piece *piece = &p->piece;
    piece->stretch = 1;
    piece->from = p->at;
    piece->to = murk_path_sides_hold(sides, murk_along(p->at, step, d));
    p->at = piece->to;
    p->left_m -= step;
    if (step < side_m) {
        return true;
    }
    /* The ray has reached a side: it leaves the domain, or continues at the
     * opposite side. */
    piece->leaves = !t->repeats || axis == 2;
    if (!piece->leaves) {
        murk_path_sides_put(sides, axis, (axis == 0 ? d.x : d.y) <= 0, &p->at);
    }
    return true;
}

murk_path_stop murk_path_piece_stop(const murk_path_pieces *p, double margin_m)
{
    const murk_path_space *space = &p->tiling->space;
    const murk_path_piece *piece = &p->piece;
    const bool is_jump = piece->stretch != 1;
    const murk_vec3 direction =
        is_jump ? murk_vec(0, 0, copysign(1, p->direction.z)) : p->direction;
    murk_path_stop stop = {.length_m =
                               murk_length(murk_sub(piece->to, piece->from))};
    /* The nearest surface; no surface lies in heights of a jump. */
    if (space->any_surfaces && !is_jump &&
        murk_surfaces_hit(space->surfaces, piece->from, direction,
                          stop.length_m + margin_m, &stop.hit)) {
        stop.is_surface = true;
        stop.length_m = stop.hit.distance_m;
    }
    /* A change of the index before the surface. */
    if (murk_media_bends(space->media)) {
        const murk_vec3 end = murk_path_sides_hold(
            &space->sides, murk_along(piece->from, stop.length_m, direction));
        murk_path path = murk_path_between(space, piece->from, end);
        murk_path_change change;
        if (path.length_m > 0 && murk_path_next_change(&path, &change)) {
            stop.is_surface = false;
            stop.is_bend = true;
            stop.length_m = change.distance_m;
        }
    }
    return stop;
}
