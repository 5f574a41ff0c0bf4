/* A picture of a world: radiance, its error, and where it came from, pixel by
 * pixel.
 *
 * Each pixel's samples are rays through places drawn evenly in it, a ray in
 * each band with the same random numbers. A sample's numbers are those of its
 * pixel and index, so the picture does not depend on threads. Standard errors
 * by maps are the samples' own and the records' (render/gather.h), which
 * samples share: both are added in squares. By paths they are the samples',
 * pooled over neighbouring pixels (render/pooled_errors.h). They are infinite
 * where there is one sample. */
#ifndef MURK_RENDER_RENDER_H
#define MURK_RENDER_RENDER_H

#include "render/camera.h"
#include "render/sample.h"

#define MURK_PIXELS_MAX  (UINT64_C(1) << 26) /* of a picture */
#define MURK_SAMPLES_MAX 65536               /* of a pixel */

typedef struct murk_render {
    const murk_trace *trace; /* world, seed, caps, flight; as for photons */
    murk_camera camera;
    size_t samples;
    murk_render_method method;
    const murk_photon_map *surface, *volume;               /* by maps */
    double from_nm[MURK_BANDS_MAX], to_nm[MURK_BANDS_MAX]; /* of each band */
    unsigned threads;
} murk_render;

/* Channels of a picture, one after the other, each height * width values by
 * rows from the top. */
typedef struct murk_image {
    size_t width, height;
    int bands;
    float *radiance[MURK_BANDS_MAX]; /* [W/m2/sr] */
    float *error[MURK_BANDS_MAX];    /* its standard error */
    float
        *surface[MURK_BANDS_MAX];  /* what came from surfaces and lights last */
    float *volume[MURK_BANDS_MAX]; /* what came from media last */
    float *depth[MURK_BANDS_MAX];  /* optical, along the pixel's middle as far
                                      as distance_m */
    float *rgb[3], *rgb_error[3];  /* render/colour.h */
    float *distance_m;  /* to the first surface, change of index or side of the
                           domain */
    float *position[3]; /* there */
    /* Of the first surface: how many sensors see it, and how clearly the
     * clearest of them; NAN where there is none. NULL before
     * murk_image_add_coverage(). */
    float *seen_by, *clarity;
    /* Of the picture: over its pixels, or all round over the solid angle, so
     * that 4 pi times it is the scalar irradiance. */
    double mean[MURK_BANDS_MAX], mean_error[MURK_BANDS_MAX];
    uint64_t rays, lost;
    /* By paths: pixels whose error rests on few bright paths, so that it is
     * unsure itself; of the band where they are most. */
    size_t unsure;
    /* By maps: what murk_gather_records() says of surface and volume map. */
    size_t records[2][MURK_BANDS_MAX];
} murk_image;

/* Bytes that a picture takes, */
double murk_image_bytes(size_t width, size_t height, int bands);
/* and with it what taking it needs, without the maps' part (render/gather.h).
 */
double murk_render_bytes(size_t width, size_t height, int bands,
                         murk_render_method method);

/* The camera stands within the domain. Progress by rays. *out is the caller's.
 * Fails with MURK_NO_MEMORY. Ends early when interrupted: ask
 * murk_interrupted(). */
murk_status murk_render_run(murk_image **out, const murk_render *render,
                            murk_error *err);
void murk_image_destroy(murk_image *picture); /* NULL is fine */

/* Sets the coverage's channels aside, NAN all over. Fails with MURK_NO_MEMORY.
 */
murk_status murk_image_add_coverage(murk_image *picture, murk_error *err);

#endif
