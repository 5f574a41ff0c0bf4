/* Renders a picture of a world: radiance, standard error and the parts of the
 * radiance, pixel by pixel.
 *
 * The samples of a pixel are rays through uniform random points of the pixel,
 * with one ray in each band and the same random numbers for all bands. The
 * random numbers of a sample are addressed by pixel and index, so the picture
 * does not depend on threads. Standard errors by maps combine, in squares, the
 * variance of the samples and that of the records (render/gather.h), which all
 * samples share. Standard errors by paths are those of the samples, pooled over
 * neighbouring pixels (render/pooled_errors.h). With one sample they are
 * infinite. */
#ifndef MURK_RENDER_RENDER_H
#define MURK_RENDER_RENDER_H

#include "base/picture_limits.h"
#include "render/camera.h"
#include "render/sample.h"

/* The input of a rendering. */
typedef struct murk_render {
    const murk_trace *trace; /* world, seed, limits and flight, as for
                              * photons */
    murk_camera camera;
    size_t samples;
    murk_render_method method;
    const murk_photon_map *surface, *volume; /* used by maps */
    /* edges of each band */
    double from_nm[MURK_BANDS_MAX], to_nm[MURK_BANDS_MAX];
    unsigned threads;
} murk_render;

/* A picture. Each channel has height * width values, row by row from the top.
 * The channels lie in one block of memory one after the other, except seen_by
 * and clarity. */
typedef struct murk_image {
    size_t width, height;
    int bands;
    float *radiance[MURK_BANDS_MAX]; /* [W/m2/sr] */
    float *error[MURK_BANDS_MAX];    /* standard error of the radiance */
    float *surface[MURK_BANDS_MAX];  /* part whose last event was on a surface,
                                        or that arrives directly from a light */
    float *volume[MURK_BANDS_MAX];   /* part whose last event was in a medium */
    float *depth[MURK_BANDS_MAX];    /* optical depth along the ray through the
                                      * center of the pixel, up to distance_m */
    float *rgb[3], *rgb_error[3];    /* render/colour.h */
    float *distance_m;  /* from the camera to the first surface, change of index
                         * or side of the domain behind the clip plane; NAN if
                         * the ray shows nothing */
    float *position[3]; /* position at that distance */
    /* For the first surface: the number of sensors that see it, and the largest
     * clarity of their views (0..1: sensing/sight.h); NAN without a surface.
     * NULL before murk_image_add_coverage(). */
    float *seen_by, *clarity;
    /* Mean radiance of the picture: over the pixels, or over the solid angle of
     * a panorama, so that 4 pi times the mean is the scalar irradiance. */
    double mean[MURK_BANDS_MAX], mean_error[MURK_BANDS_MAX];
    uint64_t rays, lost;
    /* By paths: the number of pixels with an unsure error, which rests on few
     * bright paths, in the band with most of them. */
    size_t unsure;
    /* By maps: murk_gather_records() of the surface map and the volume map. */
    size_t records[2][MURK_BANDS_MAX];
} murk_image;

/* The memory of a picture without coverage, in bytes. */
double murk_image_bytes(size_t width, size_t height, int bands);
/* The memory for rendering a picture, including the picture, in bytes, without
 * that of the maps (murk_gather_memory_for()). */
double murk_render_bytes(size_t width, size_t height, int bands,
                         murk_render_method method);

/* Renders a picture; the camera is within the domain. Progress counts one ray
 * for each sample, whatever the number of bands. The caller destroys *out.
 * Fails with MURK_NO_MEMORY. Ends early after an interrupt: the caller checks
 * murk_interrupted(). */
murk_status murk_render_run(murk_image **out, const murk_render *render,
                            murk_error *err);
void murk_image_destroy(murk_image *picture); /* NULL is fine */

/* Adds the channels of coverage, filled with NAN; once for a picture. Fails
 * with MURK_NO_MEMORY. */
murk_status murk_image_add_coverage(murk_image *picture, murk_error *err);

#endif
