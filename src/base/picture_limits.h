/* The limits of pictures. */
#ifndef MURK_BASE_PICTURE_LIMITS_H
#define MURK_BASE_PICTURE_LIMITS_H

#include <stdint.h>

/* Largest number of pixels of a picture: 256 MiB for each channel. */
#define MURK_PIXELS_MAX (UINT64_C(1) << 26)
/* Largest number of samples of a pixel; the error of a mean is then 0.4 % of
 * the error of a sample. */
#define MURK_SAMPLES_MAX 65536

#endif
