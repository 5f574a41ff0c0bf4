/* Weights of bands in linear RGB, held against the definition of the BT.709
 * primaries and the CIE 1931 standard observer's own table. Nothing here is
 * random. */
#include "check.h"
#include "render/colour.h"

#include <math.h>

/* CIE 1931 colour matching functions at lines (ISO/CIE 11664-1:2019). */
#define LINES 7
static const double nm[LINES] = {430, 450, 480, 510, 550, 600, 630};
static const double cie[LINES][3] = {
    {0.28390, 0.01160, 1.38560}, {0.33620, 0.03800, 1.77211},
    {0.09564, 0.13902, 0.81295}, {0.00930, 0.50300, 0.15820},
    {0.43345, 0.99495, 0.00875}, {1.06220, 0.63100, 0.00080},
    {0.64240, 0.26500, 0.00005}};

/* The fits of Wyman, Sloan and Shirley are off by no more at these lines. */
#define FIT_OFF 0.03

/* XYZ of an RGB: the columns are the primaries' XYZ, scaled so that the white
 * (1, 1, 1) is D65, for chromaticities as BT.709 defines them. */
static void xyz_of(const double rgb[3], double xyz[3])
{
    static const double x[3] = {0.64, 0.30, 0.15}, y[3] = {0.33, 0.60, 0.06};
    const double white[3] = {0.3127 / 0.3290, 1,
                             (1 - 0.3127 - 0.3290) / 0.3290};
    double m[3][3];
    for (int k = 0; k < 3; ++k) {
        m[0][k] = x[k] / y[k];
        m[1][k] = 1;
        m[2][k] = (1 - x[k] - y[k]) / y[k];
    }
    /* luminances of the primaries by Cramer's rule: m * s = white */
    double s[3];
    const double whole = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    for (int k = 0; k < 3; ++k) {
        double n[3][3];
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                n[i][j] = j == k ? white[i] : m[i][j];
            }
        }
        s[k] = (n[0][0] * (n[1][1] * n[2][2] - n[1][2] * n[2][1]) -
                n[0][1] * (n[1][0] * n[2][2] - n[1][2] * n[2][0]) +
                n[0][2] * (n[1][0] * n[2][1] - n[1][1] * n[2][0])) /
               whole;
    }
    for (int i = 0; i < 3; ++i) {
        xyz[i] = m[i][0] * s[0] * rgb[0] + m[i][1] * s[1] * rgb[1] +
                 m[i][2] * s[2] * rgb[2];
    }
}

/* Lines as bands: the XYZ that their weights stand for are the observer's over
 * the sum of y, and their Y together is 1. */
static void test_lines_have_the_observers_colours(void)
{
    double weight[3][MURK_BANDS_MAX], sum = 0, seen = 0;
    murk_colour_weights(LINES, nm, nm, weight);
    for (int b = 0; b < LINES; ++b) {
        seen += cie[b][1];
    }
    for (int b = 0; b < LINES; ++b) {
        const double rgb[3] = {weight[0][b], weight[1][b], weight[2][b]};
        double xyz[3];
        xyz_of(rgb, xyz);
        sum += xyz[1];
        for (int i = 0; i < 3; ++i) {
            CHECK_NEAR(xyz[i] * seen, cie[b][i], FIT_OFF);
        }
    }
    CHECK_NEAR(sum, 1, 2e-4); /* the white point's four digits */
}

/* A band is the mean over its width: that of a line for a narrow one, and of
 * its halves for a wide one. */
static void test_bands_are_means_over_their_width(void)
{
    const double from[4] = {500, 549.999, 600, 640};
    const double to[4] = {540, 550.001, 640, 680};
    const double parts_from[6] = {500, 520, 550, 600, 620, 640};
    const double parts_to[6] = {520, 540, 550, 620, 640, 680};
    double whole[3][MURK_BANDS_MAX], part[3][MURK_BANDS_MAX];
    murk_colour_weights(4, from, to, whole);
    murk_colour_weights(6, parts_from, parts_to, part);
    for (int k = 0; k < 3; ++k) {
        /* both sums of y are alike but for halves that count one by one */
        const double scale = whole[k][1] / part[k][2];
        CHECK_NEAR((part[k][0] + part[k][1]) / 2 * scale / whole[k][0], 1,
                   0.01);
        CHECK_NEAR((part[k][3] + part[k][4]) / 2 * scale / whole[k][2], 1,
                   0.01);
        CHECK_NEAR(part[k][5] * scale / whole[k][3], 1, 1e-6);
    }
}

int main(void)
{
    test_lines_have_the_observers_colours();
    test_bands_are_means_over_their_width();
    return check_done();
}
