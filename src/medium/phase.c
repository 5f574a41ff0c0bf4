#include "medium/phase.h"

#include <assert.h>
#include <math.h>

#define FOUR_PI 12.566370614359172

/* Below this the inverse CDF loses digits to cancellation (error ~ eps / |g|),
 * while treating the phase function as isotropic costs at most |g|. */
#define G_ISOTROPIC 1e-8

double murk_hg_density(double g, double mu)
{
    assert(g > -1 && g < 1 && mu >= -1 && mu <= 1);
    const double d = 1 + g * g - 2 * g * mu;
    return (1 - g * g) / (FOUR_PI * d * sqrt(d));
}

double murk_hg_sample(double g, double u)
{
    assert(g > -1 && g < 1 && u > 0 && u < 1);
    if (fabs(g) < G_ISOTROPIC) {
        return 2 * u - 1;
    }
    const double s = (1 - g * g) / (1 - g + 2 * g * u);
    const double mu = (1 + g * g - s * s) / (2 * g);
    return mu > 1 ? 1 : mu < -1 ? -1 : mu; /* rounding near the ends of u */
}

/* The inverse CDF: the one real root of mu^3 + 3 mu = 8 u - 4 (Cardano). */
static double rayleigh_sample(double u)
{
    const double q = fabs(4 * u - 2);
    const double root = cbrt(q + sqrt(q * q + 1));
    const double mu = fmin(1, root - 1 / root);
    return u < .5 ? -mu : mu;
}

/* u chooses the term; how far it lies in that term's share is uniform again. */
static double two_hg_sample(const murk_phase *p, double u)
{
    if (u < p->weight) {
        return murk_hg_sample(p->g, u / p->weight);
    }
    const double rest = (u - p->weight) / (1 - p->weight);
    return murk_hg_sample(p->g2, fmax(rest, 0x1p-54)); /* u may be the weight */
}

murk_phase murk_phase_hg(double g)
{
    return (murk_phase){.kind = MURK_PHASE_HG, .g = g};
}

murk_phase murk_phase_rayleigh(void)
{
    return (murk_phase){.kind = MURK_PHASE_RAYLEIGH};
}

murk_phase murk_phase_two_hg(double g1, double g2, double weight1)
{
    return (murk_phase){
        .kind = MURK_PHASE_TWO_HG, .g = g1, .g2 = g2, .weight = weight1};
}

murk_phase murk_phase_tabulated(const murk_phase_table *table)
{
    return (murk_phase){.kind = MURK_PHASE_TABLE, .table = table};
}

/* The negated comparisons also refuse NaN. */
murk_status murk_phase_check(const murk_phase *phase, int band,
                             const char *where, murk_error *err)
{
    const double g[] = {phase->g, phase->g2};
    for (int i = 0; i < 2; ++i) {
        if (!(g[i] > -1 && g[i] < 1)) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "mean cosine g is %g (band %d), must be between "
                             "-1 and 1, both excluded",
                             g[i], band);
        }
    }
    if (!(phase->weight >= 0 && phase->weight <= 1)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "weight of g1 is %g (band %d), must be 0..1",
                         phase->weight, band);
    }
    if ((phase->kind == MURK_PHASE_TABLE) != (phase->table != NULL)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "phase function %s a table (band %d)",
                         phase->table ? "of another kind has" : "misses", band);
    }
    return MURK_OK;
}

double murk_phase_density(const murk_phase *phase, double mu)
{
    switch (phase->kind) {
    case MURK_PHASE_RAYLEIGH:
        return .75 * (1 + mu * mu) / FOUR_PI;
    case MURK_PHASE_TWO_HG:
        return phase->weight * murk_hg_density(phase->g, mu) +
               (1 - phase->weight) * murk_hg_density(phase->g2, mu);
    case MURK_PHASE_TABLE:
        return murk_phase_table_density(phase->table, mu);
    case MURK_PHASE_HG:
        break;
    }
    return murk_hg_density(phase->g, mu);
}

double murk_phase_sample(const murk_phase *phase, double u)
{
    switch (phase->kind) {
    case MURK_PHASE_RAYLEIGH:
        return rayleigh_sample(u);
    case MURK_PHASE_TWO_HG:
        return two_hg_sample(phase, u);
    case MURK_PHASE_TABLE:
        return murk_phase_table_sample(phase->table, u);
    case MURK_PHASE_HG:
        break;
    }
    return murk_hg_sample(phase->g, u);
}

/* s is 1 - mu, root^2 is 1 + g^2 - 2 g mu: nothing cancels, for any g. */
static double hg_share(double g, double s)
{
    const double root = sqrt((1 - g) * (1 - g) + 2 * g * s);
    return (1 + g) * s / (root * (root + 1 - g));
}

double murk_phase_share_within(const murk_phase *phase, double angle_rad)
{
    assert(angle_rad >= 0 && angle_rad <= 3.1415926535897936);
    const double half = sin(.5 * angle_rad);
    const double s = 2 * half * half; /* 1 - cos(angle) */
    switch (phase->kind) {
    case MURK_PHASE_RAYLEIGH:
        return .125 * s * (6 - s * (3 - s));
    case MURK_PHASE_TWO_HG:
        return phase->weight * hg_share(phase->g, s) +
               (1 - phase->weight) * hg_share(phase->g2, s);
    case MURK_PHASE_TABLE:
        return murk_phase_table_share(phase->table, s);
    case MURK_PHASE_HG:
        break;
    }
    return hg_share(phase->g, s);
}

double murk_phase_mean_cosine(const murk_phase *phase)
{
    switch (phase->kind) {
    case MURK_PHASE_RAYLEIGH:
        return 0;
    case MURK_PHASE_TWO_HG:
        return phase->weight * phase->g + (1 - phase->weight) * phase->g2;
    case MURK_PHASE_TABLE:
        return murk_phase_table_facts(phase->table)->mean_cosine;
    case MURK_PHASE_HG:
        break;
    }
    return phase->g;
}

bool murk_phase_is_same(const murk_phase *a, const murk_phase *b)
{
    if (a->kind != b->kind) {
        return false;
    }
    return a->kind == MURK_PHASE_TABLE
               ? murk_phase_table_is_same(a->table, b->table)
               : a->g == b->g && a->g2 == b->g2 && a->weight == b->weight;
}
