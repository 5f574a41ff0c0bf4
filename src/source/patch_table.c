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

/* The mean cosine of a cell at the face: that of its middle, or of its corners
 * if some of them are behind the face. */
static double cosine_of(const murk_patch_table *t, size_t i, size_t j)
{
    double corners = 0;
    bool is_cut = false;
    for (size_t k = 0; k < 4; ++k) {
        const double up = (double)(i + k / 2) / CELLS,
                     around = (double)(j + k % 2) / CELLS;
        const double cosine =
            murk_dot(murk_sky_patch_at(&t->patch, up, around), t->outward);
        is_cut = is_cut || cosine < 0;
        corners += fmax(0, cosine) / 4;
    }
    return is_cut
               ? corners
               : murk_dot(murk_sky_patch_at(&t->patch, ((double)i + .5) / CELLS,
                                            ((double)j + .5) / CELLS),
                          t->outward);
}

void murk_patch_table_fill(murk_patch_table *out, const murk_sky_patch *patch,
                           murk_vec3 outward)
{
    double sum = 0;
    out->patch = *patch;
    out->outward = outward;
    for (size_t c = 0; c < ALL; ++c) {
        sum += cosine_of(out, c / CELLS, c % CELLS);
        out->end[c] = sum;
    }
    for (size_t c = 0; c < ALL; ++c) {
        out->end[c] = sum > 0 ? out->end[c] / sum : 1;
    }
    out->irradiance = sum / (double)ALL * murk_sky_patch_sr(patch);
}

murk_vec3 murk_patch_table_draw(const murk_patch_table *t, const double u[4])
{
    size_t low = 0, high = ALL - 1;
    while (low < high) {
        const size_t middle = (low + high) / 2;
        if (u[0] < t->end[middle]) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    const murk_vec3 d =
        murk_sky_patch_at(&t->patch, ((double)(low / CELLS) + u[2]) / CELLS,
                          ((double)(low % CELLS) + u[3]) / CELLS);
    /* A direction behind the face, from a cell that the face cuts, is mirrored
     * at its plane. */
    const double cosine = murk_dot(d, t->outward);
    return cosine > 0 ? d : murk_along(d, -2 * cosine, t->outward);
}
