/* The fluence at a level is a sum of weight / |cosine|, whose variance is
 * infinite where radiance does not vanish along the level. Below a cosine of
 * GRAZING the mean of 1 / cosine for even radiance, 2 / GRAZING, takes its
 * place: that errs by (pi / 3) GRAZING^2 dL/dmu, 1e-5 of an even radiance's
 * fluence where L changes by as much as itself from level to upright. */
#include "scores.h"

#include <math.h>

#define GRAZING .01

static bool is_direct(const murk_event *event)
{
    return event->event_class != MURK_CLASS_LATER;
}

static bool counts(const score_of *s, const murk_event *event, double mu)
{
    if ((s->side > 0 && !(mu > 0)) || (s->side < 0 && !(mu < 0))) {
        return false;
    }
    if (s->light != SCORE_ALL_LIGHT &&
        is_direct(event) != (s->light == SCORE_DIRECT)) {
        return false;
    }
    return s->mu_max == 0 || (fabs(mu) >= s->mu_min && fabs(mu) < s->mu_max);
}

static double over_cosine(double mu)
{
    const double m = fabs(mu);
    return m < GRAZING ? 2 / GRAZING : 1 / m;
}

/* A level belongs to the segment that ends on it, not to one that starts
 * there. */
static bool passes(double from_z, double to_z, double z)
{
    return from_z < to_z ? from_z < z && z <= to_z : to_z <= z && z < from_z;
}

void scores_add(const void *context, const murk_event *before,
                const murk_event *event, double *out)
{
    const scores *all = context;
    const double mu = event->direction_in.z;
    const double from = before->position.z, to = event->position.z;
    const bool escapes = event->kind == MURK_EVENT_ESCAPED;
    const bool collides = event->kind == MURK_EVENT_MEDIUM;
    for (size_t i = 0; i < all->n; ++i) {
        const score_of *s = &all->of[i];
        /* Power through a level, or fluence rate there: power over
         * |cosine|. */
        if (s->kind == SCORE_POWER || s->kind == SCORE_FLUENCE) {
            if (passes(from, to, s->z_m) && counts(s, event, mu)) {
                out[i] += event->weight *
                          (s->kind == SCORE_POWER ? 1 : over_cosine(mu));
            }
        } else if (s->kind == SCORE_ESCAPED) {
            /* Power that leaves the world. */
            if (escapes && counts(s, event, mu)) {
                out[i] += event->weight;
            }
        } else if (collides) {
            /* Number of collisions, or power absorbed at them. */
            out[i] += s->kind == SCORE_COLLISIONS
                          ? 1
                          : event->weight - event->leaving;
        }
    }
}
