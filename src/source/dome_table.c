/* Tabulates the sky for one orientation of an entry face and draws directions:
 * a cell by the alias method, then a point of the cell by inverting the
 * bilinear density. */
#include "source/dome_table.h"

#include <stdint.h>
#include <stdlib.h>

#include "source/patch_table.h"

/* Cells and nodes of an axis, and all cells. */
#define CELLS MURK_DOME_CELLS
#define NODES (CELLS + 1)
#define ALL   ((size_t)CELLS * CELLS)

/* An entry of the alias table: with a probability of `keeps` / 2^18 the drawn
 * cell stays, otherwise the cell is replaced by `other`. Both numbers are
 * packed into one word, because the table is fast only if it fits into the
 * cache of a core. The 14 bits that choose a cell and the 18 bits of `keeps`
 * are 32 bits together, the resolution of one uniform number (base/rng.h). */
#define OTHER_BITS 14
#define KEEPS_BITS (32 - OTHER_BITS)
_Static_assert(CELLS *CELLS <= 1 << OTHER_BITS, "cells are numbered in a word");

typedef struct whole_sky {
    murk_vec3 along, up, outward; /* frame of the face; `along` is horizontal */
    double x[NODES], a[NODES];
    float density[NODES][NODES];  /* [x][a] */
    uint32_t cell[CELLS * CELLS]; /* [x * CELLS + a] keeps, other */
} whole_sky;

/* One of the two tables is owned, the other NULL. */
struct murk_dome_table {
    whole_sky *whole;
    murk_patch_table *patch;
    double irradiance;
};

static void set_nodes(whole_sky *t)
{
    const murk_vec3 m = t->outward;
    const double level = sqrt(m.x * m.x + m.y * m.y);
    t->along =
        level > 0 ? murk_vec(-m.y / level, m.x / level, 0) : murk_vec(1, 0, 0);
    t->up = murk_cross(m, t->along);
    const double horizon = -atan2(m.z, level);
    for (int i = 0; i < NODES; ++i) {
        const double part = (double)i / CELLS;
        t->x[i] = sin(MURK_PI * (part - 0.5));
        t->a[i] = sin(horizon + part * (MURK_PI / 2 - horizon));
    }
    t->x[CELLS / 2] = 0;
}

static inline double cosine_of(double sine)
{
    const double square = (1 - sine) * (1 + sine);
    return square > 0 ? sqrt(square) : 0;
}

/* The unit direction to the sky at a point of the rectangle. */
static inline murk_vec3 direction_at(const whole_sky *t, double x, double a)
{
    const double rest = cosine_of(x), cosine = rest * cosine_of(a);
    murk_vec3 d = murk_scale(x, t->along);
    d = murk_along(d, a * rest, t->up);
    return murk_along(d, cosine, t->outward);
}

static murk_status fill(whole_sky *t, const murk_dome *dome, const char *where,
                        murk_error *err)
{
    for (int i = 0; i < NODES; ++i) {
        const double width = cosine_of(t->x[i]);
        for (int j = 0; j < NODES; ++j) {
            murk_vec3 d = direction_at(t, t->x[i], t->a[j]);
            d.z = fmax(0, d.z); /* nodes on the horizon may be rounded below the
                                 * horizon */
            const double radiance = murk_dome_radiance(dome, d);
            if (!(radiance >= 0 && isfinite(radiance))) {
                return murk_fail(err, MURK_BAD_VALUE, where,
                                 "relative radiance of the sky is %g towards "
                                 "[%g, %g, %g], must be 0 or more",
                                 radiance, d.x, d.y, d.z);
            }
            t->density[i][j] = (float)(radiance * width);
        }
    }
    return MURK_OK;
}

/* Fills share[ALL] with the irradiance of each cell divided by the mean of all
 * cells; all are 0 if the sum is 0. Returns the sum of the irradiances. */
static double weigh(const whole_sky *t, double *share)
{
    double sum = 0;
    for (size_t i = 0; i < CELLS; ++i) {
        for (size_t j = 0; j < CELLS; ++j) {
            const double area =
                (t->x[i + 1] - t->x[i]) * (t->a[j + 1] - t->a[j]);
            const float *low = &t->density[i][j], *high = &t->density[i + 1][j];
            const double corners = (double)low[0] + (double)low[1] +
                                   (double)high[0] + (double)high[1];
            sum += share[i * CELLS + j] = area * corners / 4;
        }
    }
    for (size_t c = 0; sum > 0 && c < ALL; ++c) {
        share[c] *= (double)ALL / sum;
    }
    return sum;
}

/* An entry of the alias table. */
static uint32_t packed(double keeps, uint32_t other)
{
    const double max = (1 << KEEPS_BITS) - 1;
    return (uint32_t)fmin(max, nearbyint(keeps * (max + 1))) << OTHER_BITS |
           other;
}

/* Builds the alias table by Vose's method: each cell below the mean is filled
 * up from a cell above the mean; cells that are left at the end have a share of
 * 1 but for rounding and are always kept. stack[ALL] holds the small cells at
 * the front and the large ones at the end. */
static void build_alias_table(whole_sky *t, double *share, uint32_t *stack)
{
    size_t small = 0, large = ALL;
    for (uint32_t c = 0; c < ALL; ++c) {
        t->cell[c] = packed(1, c);
        if (share[c] < 1) {
            stack[small++] = c;
        } else {
            stack[--large] = c;
        }
    }
    while (small > 0 && large < ALL) {
        const uint32_t poor = stack[--small], rich = stack[large];
        t->cell[poor] = packed(share[poor], rich);
        share[rich] -= 1 - share[poor];
        if (share[rich] < 1) {
            ++large;
            stack[small++] = rich;
        }
    }
}

static murk_status tabulate_whole(murk_dome_table *out, const murk_dome *dome,
                                  murk_vec3 outward, const char *where,
                                  murk_error *err)
{
    whole_sky *table = malloc(sizeof *table);
    double *share = malloc(ALL * sizeof *share);
    uint32_t *stack = malloc(ALL * sizeof *stack);
    murk_status status = MURK_OK;
    if (!table || !share || !stack) {
        status = murk_no_memory(err, where, "for a sky");
        goto done;
    }
    /* Tabulate the sky, then build the alias table of the cells. */
    table->outward = outward;
    set_nodes(table);
    status = fill(table, dome, where, err);
    if (!status) {
        out->irradiance = weigh(table, share);
        build_alias_table(table, share, stack);
        out->whole = table;
        table = NULL;
    }
done:
    free(table);
    free(share);
    free(stack);
    return status;
}

static murk_status tabulate_patch(murk_dome_table *out, const murk_dome *dome,
                                  murk_vec3 outward, const char *where,
                                  murk_error *err)
{
    out->patch = malloc(sizeof *out->patch);
    if (!out->patch) {
        return murk_no_memory(err, where, "for a sky");
    }
    murk_patch_table_fill(out->patch, &dome->patch, outward);
    out->irradiance = out->patch->irradiance;
    return MURK_OK;
}

murk_status murk_dome_table_create(murk_dome_table **out, const murk_dome *dome,
                                   murk_vec3 outward, const char *where,
                                   murk_error *err)
{
    murk_dome_table *table = calloc(1, sizeof *table);
    if (!table) {
        return murk_no_memory(err, where, "for a sky");
    }
    const murk_status status =
        dome->patch.high > 0 ? tabulate_patch(table, dome, outward, where, err)
                             : tabulate_whole(table, dome, outward, where, err);
    if (status) {
        murk_dome_table_destroy(table);
        return status;
    }
    *out = table;
    return MURK_OK;
}

void murk_dome_table_destroy(murk_dome_table *table)
{
    if (table) {
        free(table->whole);
        free(table->patch);
        free(table);
    }
}

double murk_dome_table_irradiance(const murk_dome_table *table)
{
    return table->irradiance;
}

static murk_vec3 draw_whole(const whole_sky *t, const double u[4])
{
    const size_t first = (size_t)(u[0] * (double)ALL);
    const uint32_t cell = t->cell[first];
    const bool keeps =
        (uint32_t)(u[1] * (1 << KEEPS_BITS)) < cell >> OTHER_BITS;
    const size_t c = keeps ? first : cell & ((1 << OTHER_BITS) - 1);
    const size_t i = c / CELLS, j = c % CELLS;
    const float *low = &t->density[i][j], *high = &t->density[i + 1][j];
    const double a0 = (double)low[0], a1 = (double)low[1];
    const double b0 = (double)high[0], b1 = (double)high[1];
    const double p = murk_draw_slanted(a0 + a1, b0 + b1, u[2]);
    const double q =
        murk_draw_slanted(a0 + p * (b0 - a0), a1 + p * (b1 - a1), u[3]);
    const double x = t->x[i] + p * (t->x[i + 1] - t->x[i]);
    const double a = t->a[j] + q * (t->a[j + 1] - t->a[j]);
    return direction_at(t, x, a);
}

murk_vec3 murk_dome_table_draw(const murk_dome_table *t, const double u[4])
{
    return t->patch ? murk_patch_table_draw(t->patch, u)
                    : draw_whole(t->whole, u);
}
