/* Tabulates the cosine over a patch of the sky and draws directions: a cell by
 * the cumulative shares, then a point of the cell evenly in solid angle. */
#include "source/patch_table.h"

#include <math.h>
#include <stddef.h>

#define CELLS MURK_PATCH_CELLS
#define ALL   ((size_t)CELLS * CELLS)

murk_vec3 murk_sky_patch_at(const murk_sky_patch *patch, double up,
                            double around)
{
    const double z = patch->low + up * (patch->high - patch->low);
    const double azimuth =
        patch->from_rad + around * (patch->to_rad - patch->from_rad);
    const double level = sqrt(fmax(0, (1 - z) * (1 + z)));
    return murk_vec(level * cos(azimuth), level * sin(azimuth), z);
}

double murk_sky_patch_sr(const murk_sky_patch *patch)
{
    return (patch->high - patch->low) * (patch->to_rad - patch->from_rad);
}

void murk_patch_table_fill(murk_patch_table *out, const murk_sky_patch *patch,
                           murk_vec3 outward)
{
    double sum = 0;
    out->patch = *patch;
    out->outward = outward;
    for (size_t i = 0; i <= CELLS; ++i) {
        for (size_t j = 0; j <= CELLS; ++j) {
            const murk_vec3 d =
                murk_sky_patch_at(patch, (double)i / CELLS, (double)j / CELLS);
            out->cosine[i][j] = fmax(0, murk_dot(d, outward));
        }
    }
    /* A bilinear function has the mean of its corners. */
    for (size_t c = 0; c < ALL; ++c) {
        const double *low = &out->cosine[c / CELLS][c % CELLS],
                     *high = &out->cosine[c / CELLS + 1][c % CELLS];
        sum += (low[0] + low[1] + high[0] + high[1]) / 4;
        out->end[c] = sum;
    }
    for (size_t c = 0; c < ALL; ++c) {
        out->end[c] = sum > 0 ? out->end[c] / sum : 1;
    }
    out->irradiance = sum / (double)ALL * murk_sky_patch_sr(patch);
}

double murk_draw_slanted(double from, double to, double u)
{
    return u * (from + to) /
           (from + sqrt(from * from + u * (to - from) * (to + from)));
}

murk_vec3 murk_patch_table_draw(const murk_patch_table *t, const double u[4])
{
    size_t first = 0, last = ALL - 1;
    while (first < last) {
        const size_t middle = (first + last) / 2;
        if (u[0] < t->end[middle]) {
            last = middle;
        } else {
            first = middle + 1;
        }
    }
    /* A point of the cell. */
    const size_t i = first / CELLS, j = first % CELLS;
    const double *low = &t->cosine[i][j], *high = &t->cosine[i + 1][j];
    const double p =
        murk_draw_slanted(low[0] + low[1], high[0] + high[1], u[2]);
    const double q = murk_draw_slanted(low[0] + p * (high[0] - low[0]),
                                       low[1] + p * (high[1] - low[1]), u[3]);
    const murk_vec3 d = murk_sky_patch_at(&t->patch, ((double)i + p) / CELLS,
                                          ((double)j + q) / CELLS);
    /* A direction behind the face, from a cell that the face cuts, is mirrored
     * at its plane. */
    const double cosine = murk_dot(d, t->outward);
    return cosine > 0 ? d : murk_along(d, -2 * cosine, t->outward);
}
