/* Phase functions: densities, sampling by the inverse of the cumulative
 * distribution, and the share of light inside a cone (medium/phase.h). */
#include "medium/phase.h"

#include <assert.h>
#include <math.h>
#include <string.h>

/* Solid angle of the sphere. */
#define FOUR_PI 12.566370614359172

double murk_hg_density(double g, double mu)
{
    assert(g > -1 && g < 1 && mu >= -1 && mu <= 1);
    const double d = 1 + g * g - 2 * g * mu;
    return (1 - g * g) / (FOUR_PI * d * sqrt(d));
}

/* u chooses one of the two terms. The position of u within the share of that
 * term is uniform again and gives the cosine. */
static double two_hg_sample(const murk_phase *p, double u)
{
    const double weight = p->value[2];
    if (u < weight) {
        return murk_hg_sample(p->value[0], u / weight);
    }
    const double rest = (u - weight) / (1 - weight);
    return murk_hg_sample(p->value[1], fmax(rest, 0x1p-54)); /* u == weight */
}

static double two_hg_density(const murk_phase *p, double mu)
{
    return p->value[2] * murk_hg_density(p->value[0], mu) +
           (1 - p->value[2]) * murk_hg_density(p->value[1], mu);
}

/* Share of the light that is scattered by less than the angle with 1 -
 * cos(angle) = s. With mu = 1 - s, root^2 is 1 + g^2 - 2 g mu, in a form that
 * loses no digits for small s. */
static double hg_share(double g, double s)
{
    const double root = sqrt((1 - g) * (1 - g) + 2 * g * s);
    return (1 + g) * s / (root * (root + 1 - g));
}

static double two_hg_share(const murk_phase *p, double s)
{
    return p->value[2] * hg_share(p->value[0], s) +
           (1 - p->value[2]) * hg_share(p->value[1], s);
}

static double two_hg_mean(const murk_phase *p)
{
    return p->value[2] * p->value[0] + (1 - p->value[2]) * p->value[1];
}

static double one_hg_density(const murk_phase *p, double mu)
{
    return murk_hg_density(p->value[0], mu);
}

static double one_hg_sample(const murk_phase *p, double u)
{
    return murk_hg_sample(p->value[0], u);
}

static double one_hg_share(const murk_phase *p, double s)
{
    return hg_share(p->value[0], s);
}

static double one_hg_mean(const murk_phase *p)
{
    return p->value[0];
}

static double rayleigh_density(const murk_phase *p, double mu)
{
    (void)p;
    return .75 * (1 + mu * mu) / FOUR_PI;
}

/* The inverse CDF: the one real root of mu^3 + 3 mu = 8 u - 4 (Cardano). */
static double rayleigh_sample(const murk_phase *p, double u)
{
    (void)p;
    const double q = fabs(4 * u - 2);
    const double root = cbrt(q + sqrt(q * q + 1));
    const double mu = fmin(1, root - 1 / root);
    return u < .5 ? -mu : mu;
}

static double rayleigh_share(const murk_phase *p, double s)
{
    (void)p;
    return .125 * s * (6 - s * (3 - s));
}

static double rayleigh_mean(const murk_phase *p)
{
    (void)p;
    return 0; /* forward and backward are alike */
}

static double table_density(const murk_phase *p, double mu)
{
    return murk_phase_table_density(p->table, mu);
}

static double table_sample(const murk_phase *p, double u)
{
    return murk_phase_table_sample(p->table, u);
}

static double table_share(const murk_phase *p, double s)
{
    return murk_phase_table_share(p->table, s);
}

static double table_mean(const murk_phase *p)
{
    return murk_phase_table_facts(p->table)->mean_cosine;
}

static murk_status fournier_forand_table(murk_phase_table **out,
                                         const double *value, const char *where,
                                         murk_error *err)
{
    return murk_phase_table_fournier_forand(out, value[0], value[1], where,
                                            err);
}

/* The accepted range of one number. */
typedef struct phase_number {
    const char *name;
    double min, max;
    bool is_open;        /* min and max themselves are refused */
    const char *allowed; /* for the message */
} phase_number;

/* At -1 and 1 the function is a delta function and has no density. */
#define MEAN_COSINE                                                     \
    {                                                                   \
        "mean cosine g", -1, 1, true, "between -1 and 1, both excluded" \
    }

/* A kind of phase functions. A kind has either the four functions of a closed
 * form or of a given table, or `tabulate`, which computes a table from the
 * numbers. */
typedef struct phase_row {
    phase_number number[MURK_PHASE_NUMBERS_MAX];
    double (*density)(const murk_phase *p, double mu); /* 1/sr */
    double (*sample)(const murk_phase *p, double u);   /* inverse CDF */
    /* share of the light that is scattered by less than the angle with the
     * cosine 1 - s */
    double (*share)(const murk_phase *p, double s);
    double (*mean_cosine)(const murk_phase *p);
    murk_status (*tabulate)(murk_phase_table **out, const double *value,
                            const char *where, murk_error *err);
} phase_row;

static const phase_row ROWS[] = {
    [MURK_PHASE_HG] = {.number = {MEAN_COSINE},
                       .density = one_hg_density,
                       .sample = one_hg_sample,
                       .share = one_hg_share,
                       .mean_cosine = one_hg_mean},
    [MURK_PHASE_RAYLEIGH] = {.density = rayleigh_density,
                             .sample = rayleigh_sample,
                             .share = rayleigh_share,
                             .mean_cosine = rayleigh_mean},
    [MURK_PHASE_TWO_HG] = {.number = {MEAN_COSINE,
                                      MEAN_COSINE,
                                      {"weight of g1", 0, 1, false, "0..1"}},
                           .density = two_hg_density,
                           .sample = two_hg_sample,
                           .share = two_hg_share,
                           .mean_cosine = two_hg_mean},
    [MURK_PHASE_FOURNIER_FORAND] = {.tabulate = fournier_forand_table},
    [MURK_PHASE_TABLE] = {.density = table_density,
                          .sample = table_sample,
                          .share = table_share,
                          .mean_cosine = table_mean},
};

murk_phase murk_phase_of(murk_phase_kind kind,
                         const double value[MURK_PHASE_NUMBERS_MAX])
{
    murk_phase phase = {.kind = kind};
    memcpy(phase.value, value, sizeof phase.value);
    return phase;
}

murk_phase murk_phase_hg(double g)
{
    return (murk_phase){.kind = MURK_PHASE_HG, .value = {g}};
}

murk_phase murk_phase_rayleigh(void)
{
    return (murk_phase){.kind = MURK_PHASE_RAYLEIGH};
}

murk_phase murk_phase_two_hg(double g1, double g2, double weight1)
{
    return (murk_phase){.kind = MURK_PHASE_TWO_HG, .value = {g1, g2, weight1}};
}

murk_phase murk_phase_tabulated(const murk_phase_table *table)
{
    return (murk_phase){.kind = MURK_PHASE_TABLE, .table = table};
}

bool murk_phase_is_tabulated(murk_phase_kind kind)
{
    return ROWS[kind].tabulate != NULL;
}

murk_status murk_phase_tabulate(murk_phase_table **out, murk_phase_kind kind,
                                const double value[MURK_PHASE_NUMBERS_MAX],
                                const char *where, murk_error *err)
{
    return ROWS[kind].tabulate(out, value, where, err);
}

/* The negated comparisons also refuse NaN. */
murk_status murk_phase_check(const murk_phase *phase, int band,
                             const char *where, murk_error *err)
{
    const phase_number *number = ROWS[phase->kind].number;
    for (int i = 0; i < MURK_PHASE_NUMBERS_MAX && number[i].name; ++i) {
        const double value = phase->value[i];
        const bool is_within =
            number[i].is_open
                ? value > number[i].min && value < number[i].max
                : value >= number[i].min && value <= number[i].max;
        if (!is_within) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "%s is %g (band %d), must be %s", number[i].name,
                             value, band, number[i].allowed);
        }
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
    return ROWS[phase->kind].density(phase, mu);
}

double murk_phase_sample(const murk_phase *phase, double u)
{
    return ROWS[phase->kind].sample(phase, u);
}

double murk_phase_share_within(const murk_phase *phase, double angle_rad)
{
    assert(angle_rad >= 0 && angle_rad <= 3.1415926535897936);
    const double half = sin(.5 * angle_rad);
    const double s = 2 * half * half; /* 1 - cos(angle) */
    return ROWS[phase->kind].share(phase, s);
}

double murk_phase_mean_cosine(const murk_phase *phase)
{
    return ROWS[phase->kind].mean_cosine(phase);
}

bool murk_phase_is_same(const murk_phase *a, const murk_phase *b)
{
    if (a->kind != b->kind) {
        return false;
    }
    bool are_equal = true;
    for (int i = 0; i < MURK_PHASE_NUMBERS_MAX; ++i) {
        are_equal = are_equal && a->value[i] == b->value[i];
    }
    return a->kind == MURK_PHASE_TABLE
               ? murk_phase_table_is_same(a->table, b->table)
               : are_equal;
}
