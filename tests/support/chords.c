/* Fluence rates by track length, computed from the events of the tracer: the
 * length of each flight inside a ball or box is added up by photon, and
 * divided by the volume at the end. */
#include "chords.h"

chord_place chord_ball(murk_vec3 center, double radius_m)
{
    return (chord_place){.center = center, .radius_m = radius_m};
}

chord_place chord_box(murk_vec3 min, murk_vec3 max)
{
    return (chord_place){.is_box = true, .box = {min, max}};
}

static double volume_m3(const chord_place *place)
{
    const murk_vec3 size = murk_sub(place->box.max, place->box.min);
    return place->is_box ? size.x * size.y * size.z
                         : 4 * MURK_PI / 3 * pow(place->radius_m, 3);
}

static double chord_m(const chord_place *place, murk_vec3 from,
                      murk_vec3 direction, double length_m)
{
    double t0 = 0, t1 = length_m;
    if (place->is_box) {
        return murk_box_clip(&place->box, from, direction, &t0, &t1) ? t1 - t0
                                                                     : 0;
    }
    const murk_vec3 to_center = murk_sub(place->center, from);
    const double nearest = murk_dot(to_center, direction);
    const double half2 = place->radius_m * place->radius_m -
                         murk_dot(to_center, to_center) + nearest * nearest;
    if (!(half2 > 0)) {
        return 0;
    }
    t0 = fmax(t0, nearest - sqrt(half2));
    t1 = fmin(t1, nearest + sqrt(half2));
    return fmax(0, t1 - t0);
}

void chords_note(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    chords *c = context;
    for (size_t i = 0; i < c->n; ++i) {
        if (event->kind == MURK_EVENT_EMITTED) {
            c->sum[i] += c->now[i];
            c->sum2[i] += c->now[i] * c->now[i];
            c->now[i] = 0;
        } else {
            c->now[i] += c->weight * chord_m(&c->place[i], c->from,
                                             c->direction, event->path_m);
        }
    }
    c->photons += event->kind == MURK_EVENT_EMITTED;
    c->from = event->position;
    c->direction = event->direction_out;
    c->weight = event->leaving;
}

murk_estimate chords_fluence(const chords *c, size_t i)
{
    const double n = (double)c->photons, v = volume_m3(&c->place[i]);
    const double mean = (c->sum[i] + c->now[i]) / n;
    const double square = (c->sum2[i] + c->now[i] * c->now[i]) / n;
    return (murk_estimate){mean / v,
                           sqrt((square - mean * mean) / (n - 1)) / v};
}
