/* The slopes of a wind-blown water surface, and which of them a ray meets.
 *
 * The surface is made of small facets. Their slopes along two axes are
 * independent and normal, alike in all directions; `mean_square_slope` is the
 * sum of both variances. Heights do not go with slopes, and neighbouring facets
 * do not know of each other (Smith): then of all that a ray may meet each
 * facet counts by the area that it turns towards the ray.
 *
 * `cosine` is that of the angle between the ray and the way against the mean
 * surface's normal on the ray's side: 1 straight at the surface, 0 along it,
 * below 0 for a ray that leads away from the mean surface and may still meet
 * a steep facet.
 *
 * Sources: Cox and Munk, J. Opt. Soc. Am. 44 (1954) 838,
 * doi:10.1364/JOSA.44.000838; Smith, IEEE Trans. Antennas Propag. 15 (1967)
 * 668, doi:10.1109/TAP.1967.1138991; facets by the area seen: Heitz and d'Eon,
 * Comput. Graph. Forum 33 (2014) 103, doi:10.1111/cgf.12417. */
#ifndef MURK_MEDIUM_WAVES_H
#define MURK_MEDIUM_WAVES_H

/* Winds that Cox and Munk measured in, some 12.5 m above the sea [m/s]. */
#define MURK_WIND_MEASURED_MIN 0.7
#define MURK_WIND_MEASURED_MAX 14

/* No sea is steeper; bounds what a region may have. */
#define MURK_MEAN_SQUARE_SLOPE_MAX 1

/* Their fit for a clean surface, .003 + .00512 wind: the whole mean square
 * slope, wherever the wind comes from. (Of it .00316 wind is the upwind part
 * and .003 + .00192 wind the crosswind part: at 10 m/s the square roots are
 * .18 and .15, and .16 in both directions here.) */
double murk_wind_mean_square_slope(double wind_m_per_s);

/* Area that facets turn towards a ray, a unit of the mean surface; -1 <= cosine
 * <= 1, width = sqrt(mean_square_slope) > 0. It is `cosine` plus what is turned
 * away from the ray: Smith's 1 + Lambda times the cosine. */
double murk_facets_seen(double width, double cosine);

typedef struct murk_slope {
    double along; /* rise of the facet a metre in the direction in which the
                     ray goes over the mean surface: above 0 it faces the ray */
    double across;
} murk_slope;

/* A facet that the ray meets; u in (0, 1) each. `along` falls as u[0] rises:
 * it is the inverse of its distribution, to 1e-7 in probability. */
murk_slope murk_facet_met(double width, double cosine, const double u[3]);

#endif
