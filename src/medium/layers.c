/* Walk of a ray through a profile, layer by layer. The layer beyond a height
 * is known by number, not by position, so the walk cannot stall: every step
 * advances by one layer. */
#include "medium/layers.h"

#include "base/interval.h"
#include "medium/grid_ray.h"

#include <float.h>
#include <math.h>

/* The ray parameter at which the ray reaches a height. */
static double crossing(const murk_layers *m, double z_m)
{
    return (z_m - m->origin) / m->direction;
}

/* The last layer whose lower height is at most z, or the first layer. */
static size_t layer_at(const murk_profile *profile, double z)
{
    return murk_interval_of(profile->z_m, 1, profile->n, z);
}

/* The extinction of a layer at height z, clamped to the layer. */
static double extinction_in(const murk_profile *profile, int band, size_t layer,
                            double z)
{
    const double low = profile->z_m[layer], high = profile->z_m[layer + 1];
    const double a = profile->extinction_per_m[layer].band[band];
    const double b = profile->extinction_per_m[layer + 1].band[band];
    const double share =
        high > low ? murk_smaller(murk_larger((z - low) / (high - low), 0), 1)
                   : 0;
    return a + share * (b - a);
}

/* Sets `to` to the end of the layer, at most to the end of the walk. The first
 * and the last layer, and each layer for a level ray, reach to the end of the
 * walk. */
static void cross_layer(murk_layers *m)
{
    double to = m->end;
    if (m->direction > 0 && m->layer + 2 < m->profile->n) {
        to = crossing(m, m->profile->z_m[m->layer + 1]);
    } else if (m->direction < 0 && m->layer > 0) {
        to = crossing(m, m->profile->z_m[m->layer]);
    }
    m->to = murk_smaller(murk_larger(to, m->from), m->end);
}

bool murk_layers_clip(const murk_profile *profile, double origin,
                      double direction, double *t0, double *t1)
{
    return murk_clip_axis(profile->z_m[0], profile->z_m[profile->n - 1], origin,
                          murk_invert(direction), t0, t1);
}

void murk_layers_begin(murk_layers *layers, const murk_profile *profile,
                       int band, double origin, double direction, double t0,
                       double t1)
{
    murk_layers *m = layers;
    *m = (murk_layers){.profile = profile,
                       .band = band,
                       .origin = origin,
                       .direction = murk_invert(direction) == 0 ? 0 : direction,
                       .end = fmin(t1, DBL_MAX),
                       .from = t0,
                       .to = t0};
    m->layer = layer_at(profile, m->origin + t0 * m->direction);
}

bool murk_layers_next(murk_layers *layers)
{
    murk_layers *m = layers;
    m->from = m->to;
    if (!(m->from < m->end)) {
        return false;
    }
    if (m->is_begun) {
        m->layer += m->direction > 0 ? 1 : (size_t)-1;
    }
    m->is_begun = true;
    cross_layer(m);
    return true;
}

murk_cubic murk_layers_cubic(const murk_layers *layers, double t0, double t1)
{
    const murk_layers *m = layers;
    const double a = extinction_in(m->profile, m->band, m->layer,
                                   m->origin + t0 * m->direction);
    const double b = extinction_in(m->profile, m->band, m->layer,
                                   m->origin + t1 * m->direction);
    return (murk_cubic){{a, b - a, 0, 0}};
}

bool murk_layers_integrate(murk_layers *layers, double scale, double offset,
                           double limit, double *sum)
{
    murk_layers *m = layers;
    while (murk_layers_next(m)) {
        /* Extinction on this segment: a linear function plus the offset. */
        const murk_cubic line = murk_layers_cubic(m, m->from, m->to);
        murk_cubic whole = {{offset, 0, 0, 0}};
        murk_cubic_add(&whole, scale, &line);
        const double mean = murk_cubic_integral(&whole, 1);
        const double length = m->to - m->from;
        const double more = *sum + mean * length;
        if (more >= limit && mean > 0) {
            /* The limit is reached in this segment. */
            const double s =
                murk_cubic_reach(&whole, (limit - *sum) / (mean * length));
            m->to = murk_smaller(m->to, m->from + s * length);
            m->value = murk_cubic_value(&line, s);
            m->value = m->value > 0 ? m->value : murk_cubic_integral(&line, 1);
            *sum = limit;
            return true;
        }
        *sum = more;
    }
    return false;
}

bool murk_layers_density(const murk_profile *profile, int band, double z,
                         double *density)
{
    if (!(z >= profile->z_m[0] && z < profile->z_m[profile->n - 1])) {
        return false;
    }
    *density = extinction_in(profile, band, layer_at(profile, z), z);
    return true;
}
