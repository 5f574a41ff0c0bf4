/* Compares the surfaces, media and meshes of regions of two stages, which
 * decide about sightlines and paths. */
#include "world/changed_world.h"

#include "geometry/changed_surfaces.h"
#include "medium/changed_media.h"

#include <math.h>
#include <string.h>

/* The boxes are enlarged by so many steps off a surface
 * (murk_surfaces_leave_step_m()): a hit in a corner is drawn back by up to
 * eight steps from a neighbouring face (geometry/hit.c), a ray begins one step
 * off its surface, rounding moves it by less than one, and a face that it
 * passes at less than one may count. */
#define MARGIN_STEPS 12

murk_status murk_changed_world(murk_box_list *changed, const murk_stage *a,
                               const murk_stage *b, murk_world_use what,
                               murk_error *err)
{
    const murk_domain *p = &a->world.domain, *q = &b->world.domain;
    *changed = (murk_box_list){
        .are_all = p->is_periodic != q->is_periodic ||
                   memcmp(&p->box, &q->box, sizeof p->box) != 0};
    if (changed->are_all) {
        return MURK_OK;
    }
    /* Media, surfaces, meshes of regions, then the margin. */
    murk_changed_media(changed, a->media, b->media, what != MURK_USE_SIGHT);
    murk_status status = murk_changed_surfaces(
        changed, a->surfaces, b->surfaces, what == MURK_USE_LIGHT, err);
    if (!status) {
        status = murk_changed_boundary_meshes(changed, a->boundary_meshes,
                                              b->boundary_meshes, err);
    }
    double step_m = murk_surfaces_leave_step_m(b->surfaces);
    if (b->boundary_meshes) {
        step_m =
            fmax(step_m, murk_boundary_meshes_tolerance_m(b->boundary_meshes));
    }
    murk_box_list_grow(changed, MARGIN_STEPS * step_m);
    return status;
}
