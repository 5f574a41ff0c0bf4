/* Tests which places a sensor sees in free space, in the order of cost: range
 * and field of view, periodic images, surfaces, and transmittance. */
#include "sensing/outlook.h"

#include "path/viewpoint.h"

void murk_outlook_init(murk_outlook *out, const murk_sight_desc *sight,
                       int bands)
{
    *out = (murk_outlook){
        .sight = sight,
        .bands = bands,
        .segments = murk_free_segments_of(sight->surfaces, &sight->domain)};
}

static bool is_same(murk_vec3 a, murk_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool comes_first(murk_vec3 a, murk_vec3 b)
{
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

/* The segment is always tested from the same end, so both directions give the
 * same answer. */
bool murk_outlook_is_open(murk_outlook *o, murk_vec3 from, murk_vec3 to)
{
    const bool is_turned = comes_first(to, from);
    const murk_vec3 a = is_turned ? to : from, b = is_turned ? from : to;
    murk_tally_add(&o->tried, 1);
    return !murk_surfaces_blocked(o->sight->surfaces, a, b, false) &&
           murk_free_segment_is_open(&o->segments, a, b);
}

murk_outlook_view murk_outlook_from(murk_outlook *outlook,
                                    const murk_pose *pose)
{
    const murk_sight_desc *sight = outlook->sight;
    const murk_sensor_type *type = &sight->type[pose->type];
    return (murk_outlook_view){.outlook = outlook,
                               .place = pose->position,
                               .range_m = type->range_m,
                               .field = murk_field_of(type, pose, sight->north),
                               .bands = type->bands ? type->bands : UINT32_MAX};
}

static bool is_clear_enough(const murk_outlook_view *view, murk_vec3 place)
{
    const murk_sight_desc *sight = view->outlook->sight;
    if (!murk_media_any(sight->media) && !murk_media_bends(sight->media)) {
        return true;
    }
    const murk_path_space space = murk_path_space_of(
        sight->surfaces, sight->media, sight->boundary_meshes, &sight->domain);
    const murk_path_viewpoint viewpoint =
        murk_path_viewpoint_at(&space, view->place);
    if (murk_path_bends_to(&viewpoint, place)) {
        return false;
    }
    for (int band = 0; band < view->outlook->bands; ++band) {
        if ((view->bands >> band & 1) &&
            murk_path_transmittance_to(&viewpoint, band, place) >=
                MURK_OUTLOOK_MIN) {
            return true;
        }
    }
    return false;
}

bool murk_outlook_sees(const murk_outlook_view *view, murk_vec3 place)
{
    const murk_domain *domain = &view->outlook->sight->domain;
    const murk_vec3 offset = murk_sub(place, view->place);
    if (is_same(place, view->place)) {
        return true;
    }
    return murk_dot(offset, offset) <= view->range_m * view->range_m &&
           murk_field_contains(&view->field, offset) &&
           is_same(murk_path_nearest_image(domain, place, view->place),
                   place) &&
           murk_outlook_is_open(view->outlook, view->place, place) &&
           is_clear_enough(view, place);
}
