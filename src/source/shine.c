/* Samples light sources from a point and evaluates them along a line of sight,
 * through the row of functions of the type of the light. The formulas are in
 * lamps.c and distant.c. */
#include "source/shine.h"

#include "source/source_state.h"

bool murk_source_passes(const murk_portal *portal, murk_vec3 place,
                        murk_vec3 travel, double *ahead_m, double *cosine)
{
    const murk_vec3 cross = murk_cross(portal->edge1, portal->edge2);
    const double area = murk_length(cross);
    *cosine = murk_dot(travel, cross) / area;
    if (!(*cosine > 0)) {
        return false;
    }
    const murk_vec3 to = murk_sub(portal->corner, place);
    *ahead_m = murk_dot(to, cross) / area / *cosine;
    const murk_vec3 on = murk_sub(murk_scale(*ahead_m, travel), to);
    const double a =
        murk_dot(murk_cross(on, portal->edge2), cross) / (area * area);
    const double b =
        murk_dot(murk_cross(portal->edge1, on), cross) / (area * area);
    return a >= 0 && a < 1 && b >= 0 && b < 1;
}

bool murk_sources_can_shine(const murk_sources *lights, size_t light)
{
    const murk_source *l = murk_sources_get(lights, light);
    const murk_source_row *row = murk_source_row_of(l);
    return !row->can_shine || row->can_shine(l);
}

bool murk_sources_shine(const murk_sources *lights, size_t light, int band,
                        murk_vec3 place, const double u[MURK_SHINE_NUMBERS],
                        murk_shine *shine)
{
    const murk_source_state *s = murk_sources_state(lights, light);
    *shine = (murk_shine){.distance_m = INFINITY, .per_sr = INFINITY};
    return s->light.power_w.band[band] > 0 &&
           murk_source_row_of(&s->light)->shine(s, band, place, u, shine);
}

murk_glare murk_sources_glare(const murk_sources *lights, size_t light,
                              int band, murk_vec3 place, murk_vec3 sight)
{
    const murk_source_state *s = murk_sources_state(lights, light);
    const murk_source_row *row = murk_source_row_of(&s->light);
    return row->glare ? row->glare(s, band, place, sight) : (murk_glare){0};
}
