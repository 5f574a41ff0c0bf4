/* Weights of bands for linear RGB: colour matching functions by the fits of
 * Wyman, Sloan and Shirley (2013), averaged over each band, and the matrix
 * from XYZ to the primaries of ITU-R BT.709. */
#include "render/colour.h"

#include <math.h>

/* The largest step of the midpoint sum over a band. */
#define STEP_NM 5.0

/* Bands are invisible if the sum of y over the bands is below this share of the
 * maximum of y. */
#define UNSEEN 1e-4

typedef struct lobe {
    double height, middle_nm, below_nm, above_nm; /* widths on both sides */
} lobe;

static double lobe_at(const lobe *l, double nm)
{
    const double t =
        (nm - l->middle_nm) / (nm < l->middle_nm ? l->below_nm : l->above_nm);
    return l->height * exp(-t * t / 2);
}

/* Wyman, Sloan and Shirley, table 1 (multi-lobe fits). */
static void matching(double nm, double xyz[3])
{
    static const lobe lobes[3][3] = {
        {{1.056, 599.8, 37.9, 31.0},
         {0.362, 442.0, 16.0, 26.7},
         {-0.065, 501.1, 20.4, 26.2}},
        {{0.821, 568.8, 46.9, 40.5}, {0.286, 530.9, 16.3, 31.1}, {0, 1, 1, 1}},
        {{1.217, 437.0, 11.8, 36.0}, {0.681, 459.0, 26.0, 13.8}, {0, 1, 1, 1}}};
    for (int i = 0; i < 3; ++i) {
        xyz[i] = lobe_at(&lobes[i][0], nm) + lobe_at(&lobes[i][1], nm) +
                 lobe_at(&lobes[i][2], nm);
    }
}

static void mean_of_band(double from_nm, double to_nm, double xyz[3])
{
    const int steps = (int)fmin(1e4, ceil((to_nm - from_nm) / STEP_NM)) + 1;
    xyz[0] = xyz[1] = xyz[2] = 0;
    for (int k = 0; k < steps; ++k) {
        double at[3];
        matching(from_nm + (k + 0.5) / steps * (to_nm - from_nm), at);
        for (int i = 0; i < 3; ++i) {
            xyz[i] += at[i] / steps;
        }
    }
}

void murk_colour_weights(int bands, const double *from_nm, const double *to_nm,
                         double weight[3][MURK_BANDS_MAX])
{
    /* XYZ to linear RGB, from the primaries and the white of IEC 61966-2-1. */
    static const double rgb[3][3] = {{3.2404542, -1.5371385, -0.4985314},
                                     {-0.9692660, 1.8760108, 0.0415560},
                                     {0.0556434, -0.2040259, 1.0572252}};
    double xyz[MURK_BANDS_MAX][3], seen = 0;
    for (int b = 0; b < bands; ++b) {
        mean_of_band(from_nm[b], to_nm[b], xyz[b]);
        seen += xyz[b][1];
    }
    for (int b = 0; b < bands; ++b) {
        for (int i = 0; i < 3; ++i) {
            weight[i][b] =
                bands == 1 || !(seen > UNSEEN)
                    ? 1.0 / bands
                    : (rgb[i][0] * xyz[b][0] + rgb[i][1] * xyz[b][1] +
                       rgb[i][2] * xyz[b][2]) /
                          seen;
        }
    }
}
