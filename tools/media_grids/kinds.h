/* Kinds of media that tools/make_media makes grids of. Each is a function of
 * place and time alone: no random number but those addressed by the seed, so a
 * file has the same content on every run and machine with the same libm.
 *
 * z is up and 0 at the ground, or at the surface of water, which is the top of
 * the grid. x and y run from 0. What wind or a current carries moves along +x.
 */
#ifndef MURK_TOOLS_KINDS_H
#define MURK_TOOLS_KINDS_H

#include "base/vector.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define KIND_WORDS_MAX 16

/* A number that a user may give as NAME=VALUE. */
typedef struct media_word {
    const char *name;
    double usual, min, max;
    const char *about;
} media_word;

typedef struct media_frame {
    size_t size[3];
    double voxel_m;
    uint32_t seed;
    double time_s;
    double word[KIND_WORDS_MAX]; /* in the order of the kind's */
} media_frame;

typedef struct media_kind {
    const char *name, *about, *unit;
    bool is_water;                    /* lies below z = 0 */
    size_t size[3];                   /* usual */
    double voxel_m;                   /* usual */
    media_word words[KIND_WORDS_MAX]; /* up to one without a name */
    /* The mean over the voxel about `middle`, as far as it is known in closed
     * form; else the value there. */
    double (*value)(const media_frame *frame, murk_vec3 middle);
} media_kind;

extern const media_kind *const kinds[];
extern const size_t kinds_count;

extern const media_kind kind_fog_bank, kind_rain_shafts, kind_plume,
    kind_chlorophyll, kind_smoke;

/* The middle of voxel (0, 0, 0). */
murk_vec3 kind_first_middle(const media_kind *kind, const media_frame *frame);

/* Fills value[size[0] size[1] size[2]], x fastest. */
void kind_fill(const media_kind *kind, const media_frame *frame, float *value);

/* A normal number of mean 0 and variance 1 at every place, smooth over the unit
 * of length and without memory beyond two; layer: independent fields. With
 * octaves > 1 each further one is half as large and adds half as much variance.
 */
double noise_normal(uint32_t seed, uint32_t layer, int octaves, murk_vec3 p);

/* exp(spread noise - spread^2 / 2): its mean is 1, whatever the spread. */
double noise_patches(double spread, double noise);

/* Share of a normal law about 0 between two places. */
double normal_share(double deviation, double from, double to);

#endif
