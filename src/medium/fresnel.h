/* How much light the boundary between two indices of refraction reflects:
 * Fresnel's exact reflectance for unpolarised light, the mean of both planes
 * of polarisation.
 *
 * Source: Born and Wolf, Principles of Optics, 7th ed. (1999), 1.5.2. */
#ifndef MURK_MEDIUM_FRESNEL_H
#define MURK_MEDIUM_FRESNEL_H

/* Reflectance from index n_from into n_to at the cosine of incidence 0..1.
 * Fills the cosine of refraction: 0 where all is reflected. */
double murk_fresnel(double n_from, double n_to, double cosine,
                    double *cosine_refracted);

#endif
