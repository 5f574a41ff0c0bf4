/* Random walk among the facets of a rough water surface (transport/facets.h).
 *
 * A height is measured by the share h of the surface that lies lower, 1 above
 * all of it; ln h keeps full precision near the top, to which grazing light
 * stays close. Let `cosine` be the cosine of the angle between the direction
 * against the ray and the vertical; it is above 0 on the way down. Let `seen`
 * be the projected area of the facets that face the ray, per area of the mean
 * surface (medium/waves.h). While h changes by dh, the probability of not
 * having hit a facet is multiplied by 1 - (seen / |cosine|) |dh| / h. A uniform
 * number u therefore changes h to h u^(cosine / seen) on the way down and to h
 * u^(-|cosine| / seen) on the way up. From below, the share that lies lower is
 * 1 - h. */
#include "transport/facets.h"

#include "medium/waves.h"

/* ln(1 - h) from ln h: the first form is precise for h near 1, the second for h
 * near 0. */
static double log_of_rest(double log_h)
{
    return log_h > -0.7 ? log(-expm1(log_h)) : log1p(-exp(log_h));
}

/* The unit normal of a random facet that light in this direction hits. */
static murk_vec3 facet_normal(murk_vec3 direction, murk_vec3 up, double width,
                              double cosine, const double u[3])
{
    const murk_slope slope = murk_facet_sample(width, cosine, u);
    const murk_vec3 over = murk_along(direction, cosine, up);
    const double length = murk_length(over);
    murk_vec3 along, across;
    murk_frame(up, &along, &across);
    if (length > 0) { /* if the ray is vertical, any horizontal direction will
                       * do */
        along = murk_scale(1 / length, over);
        across = murk_cross(up, along);
    }
    return murk_unit(
        murk_along(murk_along(up, -slope.along, along), -slope.across, across));
}

bool murk_meet_facets(const murk_address *address, double n_from, double n_to,
                      double mean_square_slope, murk_vec3 direction,
                      murk_vec3 normal, murk_bounce *bounce)
{
    /* The ray starts above all of the surface: the share h that lies lower is
     * 1. */
    const double width = sqrt(mean_square_slope);
    murk_vec3 up = normal;
    double index = n_from, beyond = n_to, log_h = 0;
    bool is_through = false;
    for (uint32_t k = 0; k < MURK_FACETS_MAX; ++k) {
        const double cosine = fmax(-1, fmin(1, -murk_dot(direction, up)));
        const murk_random4 height = murk_random_at(address, 1 + 2 * k);
        /* Draw the height of the next facet, or leave if none is left. */
        const double seen = murk_facets_projected_area(width, cosine);
        log_h += cosine / seen * log(height.u[0]);
        if (cosine < 0 && !(log_h < 0)) {
            *bounce = (murk_bounce){
                is_through ? MURK_TRANSMITTED : MURK_MIRRORED, direction};
            return true;
        }
        /* Draw the facet at that height, and reflect or refract there. */
        const murk_random4 drawn = murk_random_at(address, 2 + 2 * k);
        const murk_vec3 facet =
            facet_normal(direction, up, width, cosine, drawn.u);
        const murk_bounce met =
            murk_refract(index, beyond, direction, facet, drawn.u[3]);
        direction = met.direction;
        /* Through the facet: the same surface seen from the other side. */
        if (met.outcome == MURK_TRANSMITTED) {
            const double other = index;
            index = beyond;
            beyond = other;
            up = murk_scale(-1, up);
            log_h = log_of_rest(log_h);
            is_through = !is_through;
        }
    }
    return false;
}
