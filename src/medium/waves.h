/* Slopes of a wind-blown water surface, and the slope of the facet that a ray
 * hits.
 *
 * The surface consists of small facets. The slopes along two axes are
 * independent and normally distributed, with equal variances;
 * `mean_square_slope` is the sum of both variances. Heights and slopes are
 * independent, and so are neighbouring facets (Smith). A ray then hits a facet
 * with a probability proportional to the area that the facet turns towards the
 * ray.
 *
 * `cosine` is the cosine of the angle between the direction against the ray and
 * the normal of the mean surface on the ray's side: 1 at normal incidence, 0 at
 * grazing incidence, below 0 for a ray that leads away from the mean surface
 * and may still hit a steep facet.
 *
 * Sources: Cox and Munk, J. Opt. Soc. Am. 44 (1954) 838,
 * doi:10.1364/JOSA.44.000838; Smith, IEEE Trans. Antennas Propag. 15 (1967)
 * 668, doi:10.1109/TAP.1967.1138991; facets by visible area: Heitz and
 * d'Eon, Comput. Graph. Forum 33 (2014) 103, doi:10.1111/cgf.12417. */
#ifndef MURK_MEDIUM_WAVES_H
#define MURK_MEDIUM_WAVES_H

/* Range of wind speeds that Cox and Munk measured, some 12.5 m above the sea
 * [m/s]. */
#define MURK_WIND_MEASURED_MIN 0.7
#define MURK_WIND_MEASURED_MAX 14

/* Upper limit for a region; no sea is steeper. */
#define MURK_MEAN_SQUARE_SLOPE_MAX 1

/* Cox and Munk's fit for a clean surface, 0.003 + 0.00512 wind: the total
 * mean square slope, whatever the direction of the wind. (0.00316 wind is
 * the upwind part and 0.003 + 0.00192 wind the crosswind part: at 10 m/s the
 * square roots are 0.18 and 0.15, and 0.16 in both directions here.) */
double murk_wind_mean_square_slope(double wind_m_per_s);

/* Projected area of all facets that face the ray, per area of the mean
 * surface; -1 <= cosine <= 1, width = sqrt(mean_square_slope) > 0. It is
 * `cosine` plus the projected area of the facets that face away from the
 * ray, that is, the cosine times Smith's 1 + Lambda. */
double murk_facets_projected_area(double width, double cosine);

typedef struct murk_slope {
    double along; /* slope along the horizontal direction of the ray: above 0
                     if the facet rises in that direction, which turns it
                     towards the ray */
    double across;
} murk_slope;

/* The slope of the facet that a ray hits, for three random numbers u in (0, 1).
 * -along is the inverse at u[0] of the cumulative distribution of -along,
 * accurate to 1e-7 in probability, so `along` falls as u[0] rises. */
murk_slope murk_facet_sample(double width, double cosine, const double u[3]);

#endif
