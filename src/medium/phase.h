/* Phase functions: the angular distribution of scattered light.
 *
 * Angles are between the directions of travel before and after, so mu = +1 is
 * straight on. The density is per steradian and integrates to 1 over the
 * sphere. Fournier-Forand and measured phase functions are tables:
 * phase_table.h.
 *
 * Sources: Henyey & Greenstein, Astrophys. J. 93 (1941) 70,
 * doi:10.1086/144246; Strutt (Rayleigh), Phil. Mag. 41 (1871) 107,
 * doi:10.1080/14786447108640452, without depolarisation; two terms of
 * Henyey-Greenstein: Irvine, Astrophys. J. 142 (1965) 1563,
 * doi:10.1086/148436. */
#ifndef MURK_MEDIUM_PHASE_H
#define MURK_MEDIUM_PHASE_H

#include "base/phase_kind.h"
#include "base/status.h"
#include "medium/phase_table.h"

#include <math.h>
#include <stdbool.h>

/* One phase function, held by value. All zero: isotropic. */
typedef struct murk_phase {
    murk_phase_kind kind;
    double value[MURK_PHASE_NUMBERS_MAX]; /* in the order of the scene's keys */
    const murk_phase_table *table;        /* borrowed; NULL: a closed form */
} murk_phase;

murk_phase murk_phase_hg(double g);
murk_phase murk_phase_rayleigh(void);
murk_phase murk_phase_two_hg(double g1, double g2, double weight1);
murk_phase murk_phase_tabulated(const murk_phase_table *table);

/* A phase function of a kind that has a closed form. */
murk_phase murk_phase_of(murk_phase_kind kind,
                         const double value[MURK_PHASE_NUMBERS_MAX]);

/* True for a kind whose numbers murk_phase_tabulate() turns into a table, which
 * stands for the function, because the distribution function has no closed
 * inverse. False for MURK_PHASE_TABLE, whose table is given. */
bool murk_phase_is_tabulated(murk_phase_kind kind);

/* Makes the table of a kind for which murk_phase_is_tabulated() is true. The
 * caller owns *out and releases it with murk_phase_table_destroy(). Fails at
 * `where` with MURK_BAD_VALUE if a number is outside of its range, or with
 * MURK_NO_MEMORY. */
murk_status murk_phase_tabulate(murk_phase_table **out, murk_phase_kind kind,
                                const double value[MURK_PHASE_NUMBERS_MAX],
                                const char *where, murk_error *err);

/* Fails with MURK_BAD_VALUE at `where` if a number is out of range, if a kind
 * MURK_PHASE_TABLE has no table, or if another kind has one; the message names
 * the band. */
murk_status murk_phase_check(const murk_phase *phase, int band,
                             const char *where, murk_error *err);

/* Density [1/sr] at mu = cos(angle), -1 <= mu <= 1. */
double murk_phase_density(const murk_phase *phase, double mu);

/* A cosine distributed as the density: the inverse CDF at u in (0, 1). */
double murk_phase_sample(const murk_phase *phase, double u);

/* Share of the light that is scattered by less than an angle, 0..pi: 2 pi times
 * the integral of density sin(angle). No digits are lost for small angles. */
double murk_phase_share_within(const murk_phase *phase, double angle_rad);

double murk_phase_mean_cosine(const murk_phase *phase);

/* True if both are of the same kind with equal numbers, or both are tables for
 * which murk_phase_table_is_same() is true. */
bool murk_phase_is_same(const murk_phase *a, const murk_phase *b);

/* Density [1/sr] at mu = cos(angle), for mean cosine g.
 * Needs -1 <= mu <= 1 and -1 < g < 1. */
double murk_hg_density(double g, double mu);

/* Below this |g| the inverse CDF loses digits to cancellation (error ~ eps /
 * |g|), while treating the phase function as isotropic costs at most |g|. */
#define MURK_HG_ISOTROPIC 1e-8

/* A cosine distributed as murk_hg_density: the inverse CDF at u in (0, 1), for
 * -1 < g < 1. Exact: mean is g, variance is (1 - g^2) / 3. Inline and without
 * branches, so that a compiler can compute it for several photons at once. */
static inline double murk_hg_sample(double g, double u)
{
    const double s = (1 - g * g) / (1 - g + 2 * g * u);
    const double inverse = (1 + g * g - s * s) / (2 * g);
    const double mu = fabs(g) < MURK_HG_ISOTROPIC ? 2 * u - 1 : inverse;
    return mu > 1 ? 1 : mu < -1 ? -1 : mu; /* rounding near the ends of u */
}

#endif
