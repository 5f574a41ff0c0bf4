/* Directions from a patch of the sky: the irradiance of a face against an
 * integral on a fine lattice, and the mean direction that is drawn against that
 * of a density in proportion to the cosine. A face that looks away gets
 * nothing; drawing without the cosine fails. */
#include "source/patch_table.h"

#include "base/rng.h"
#include "check.h"

#define LATTICE 400
#define DRAWN   40000
/* Error of a bilinear cosine over cells of 1.5 degrees, a share of the solid
 * angle: where the plane of the face cuts a cell. */
#define CELL_ERROR 2e-3

typedef struct integral {
    double irradiance;
    murk_vec3 mean, variance; /* of directions, weighted by the cosine */
} integral;

/* The integral over the patch, with weights cosine or, for the check of the
 * test, 1. */
static integral integrate(const murk_sky_patch *patch, murk_vec3 outward,
                          bool by_cosine)
{
    integral out = {0};
    double weight = 0, sums[6] = {0};
    /* Sums over the lattice: weights, coordinates and their squares. */
    for (int i = 0; i < LATTICE; ++i) {
        for (int j = 0; j < LATTICE; ++j) {
            const murk_vec3 d = murk_sky_patch_at(patch, (i + .5) / LATTICE,
                                                  (j + .5) / LATTICE);
            const double cosine = fmax(0, murk_dot(d, outward));
            const double w = by_cosine ? cosine : cosine > 0;
            const double c[] = {d.x, d.y, d.z};
            weight += w;
            for (int k = 0; k < 3; ++k) {
                sums[k] += w * c[k];
                sums[3 + k] += w * c[k] * c[k];
            }
        }
    }
    out.irradiance = weight / LATTICE / LATTICE * murk_sky_patch_sr(patch);
    out.mean = murk_vec(sums[0] / weight, sums[1] / weight, sums[2] / weight);
    out.variance = murk_vec(sums[3] / weight - out.mean.x * out.mean.x,
                            sums[4] / weight - out.mean.y * out.mean.y,
                            sums[5] / weight - out.mean.z * out.mean.z);
    return out;
}

static murk_vec3 mean_drawn(const murk_patch_table *table)
{
    murk_vec3 sum = {0, 0, 0};
    for (uint64_t i = 0; i < DRAWN; ++i) {
        const murk_random4 r = murk_random(3, MURK_TEST, i, 0, 0);
        const murk_vec3 d = murk_patch_table_draw(table, r.u);
        CHECK_NEAR(murk_length(d), 1, 1e-12);
        CHECK(murk_dot(d, table->outward) > 0);
        sum = murk_add(sum, d);
    }
    return murk_scale(1. / DRAWN, sum);
}

static double off(murk_vec3 got, const integral *want)
{
    const double n = DRAWN;
    return fmax(
        fabs(got.x - want->mean.x) / sqrt(want->variance.x / n + 1e-8),
        fmax(fabs(got.y - want->mean.y) / sqrt(want->variance.y / n + 1e-8),
             fabs(got.z - want->mean.z) / sqrt(want->variance.z / n + 1e-8)));
}

static double worst_without_cosine;

static void check_face(const murk_sky_patch *patch, murk_vec3 outward)
{
    murk_patch_table table;
    const integral want = integrate(patch, outward, true),
                   even = integrate(patch, outward, false);
    murk_patch_table_fill(&table, patch, outward);
    CHECK_NEAR(table.irradiance, want.irradiance,
               CELL_ERROR * murk_sky_patch_sr(patch));
    if (want.irradiance < .02 * murk_sky_patch_sr(patch)) {
        return; /* nearly behind the face */
    }
    /* 5 sigma over some 60 comparisons. */
    const murk_vec3 mean = mean_drawn(&table);
    CHECK(off(mean, &want) < 5);
    worst_without_cosine = fmax(worst_without_cosine, off(mean, &even));
}

int main(void)
{
    const double deg = MURK_PI / 180;
    const murk_sky_patch patches[] = {
        {0, sin(12 * deg), 0, 12 * deg},
        {sin(12 * deg), sin(24 * deg), 6, 6 + 12 * deg},
        {sin(60 * deg), sin(72 * deg), 2, 2 + 30 * deg},
        {sin(84 * deg), 1, 0, 360 * deg},
    };
    const murk_vec3 faces[] = {{0, 0, 1},  {1, 0, 0},   {0, 1, 0},
                               {0, -1, 0}, {.6, 0, .8}, {.5, -.5, -.1}};
    for (size_t p = 0; p < sizeof patches / sizeof *patches; ++p) {
        for (size_t f = 0; f < sizeof faces / sizeof *faces; ++f) {
            check_face(&patches[p], murk_unit(faces[f]));
        }
    }
    CHECK(worst_without_cosine > 20);
    /* A patch in the west gives nothing to a face that looks east. */
    murk_patch_table table;
    murk_patch_table_fill(&table,
                          &(murk_sky_patch){0, .2, 170 * deg, 190 * deg},
                          murk_vec(1, 0, 0));
    CHECK_NEAR(table.irradiance, 0, 1e-12);
    return check_done();
}
