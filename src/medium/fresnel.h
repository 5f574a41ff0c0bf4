/* Fresnel reflectance of an interface for unpolarised light: the mean of both
 * planes of polarisation.
 *
 * Source: Born and Wolf, Principles of Optics, 7th ed. (1999), 1.5.2. */
#ifndef MURK_MEDIUM_FRESNEL_H
#define MURK_MEDIUM_FRESNEL_H

/* Reflectance from index n_from into n_to for a cosine of incidence 0..1.
 * Sets the cosine of refraction; 0 at total reflection. */
double murk_fresnel(double n_from, double n_to, double cosine,
                    double *cosine_refracted);

#endif
