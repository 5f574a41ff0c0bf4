/* Tabulates a mixture of phase functions: evaluates each part at a common set
 * of scattering angles (medium/phase.h), adds the values weighted by the
 * shares, and passes the rows to the table builder of medium/phase_table.h. The
 * rows of a mixture whose only part is a given table are passed on unchanged.
 */
#include "world/mixtures.h"

#include "base/quantile.h"
#include "medium/phase.h"

#include <math.h>
#include <stdlib.h>

#define RADIANS (3.14159265358979323846 / 180) /* radians in a degree */

/* The scattering angles of the rows: logarithmic steps from FIRST_DEG to
 * EVEN_DEG, even steps from there to 180 degrees. Between two rows log value is
 * linear in log angle. The relative error is step^2 / 8 times the second
 * derivative of log value by log angle; step is the difference of the
 * logarithms of the two angles. Up to EVEN_DEG the step is ln(10) / LOG_STEPS
 * and the derivative of Henyey-Greenstein at most 1.5: the error is 6e-6. The
 * even steps begin with a step of .01, for which the error is 2e-5, and end
 * with .0006, for which a derivative of 10 (Rayleigh at 180 degrees) gives
 * 4e-7. */
#define FIRST_DEG      1e-3
#define LOG_STEPS      400 /* per decade, up to EVEN_DEG */
#define EVEN_DEG       10.0
#define EVEN_STEP_DEG  .1
#define STEPS_MAX      (4 * LOG_STEPS + 1700 + 1)
#define EVEN_STEPS_DEG 170.0

typedef struct mixing {
    const murk_mixture *mixture;
    murk_phase *phase;        /* [mixture->n] */
    murk_phase_table **table; /* [mixture->n]; NULL where there is none */
    double *angle_deg;        /* [angles] rising */
    size_t angles;
} mixing;

/* Makes the table of a part whose cumulative distribution has no inverse in
 * closed form: given rows, or a kind for which murk_phase_is_tabulated() is
 * true (Fournier-Forand). */
static murk_status table_of(murk_phase_table **out,
                            const murk_mixture_part *part, const char *where,
                            murk_error *err)
{
    if (part->kind != MURK_PHASE_TABLE) {
        return murk_phase_tabulate(out, part->kind, part->value, where, err);
    }
    const murk_phase_rows rows = {.rows = part->angles,
                                  .angle_deg = part->angle_deg,
                                  .phase_per_sr = part->phase_per_sr,
                                  .where = where};
    return murk_phase_table_create(out, &rows, err);
}

static murk_status make_part(mixing *m, size_t i, const char *where,
                             murk_error *err)
{
    const murk_mixture_part *part = &m->mixture->part[i];
    if (part->kind == MURK_PHASE_TABLE || murk_phase_is_tabulated(part->kind)) {
        const murk_status status = table_of(&m->table[i], part, where, err);
        m->phase[i] = murk_phase_tabulated(m->table[i]);
        return status;
    }
    m->phase[i] = murk_phase_of(part->kind, part->value);
    return murk_phase_check(&m->phase[i], 0, where, err);
}

/* Fills m->angle_deg with the logarithmic and even steps from FIRST_DEG to 180
 * degrees and with those angles of given tables that are above FIRST_DEG, in
 * rising order, each angle once; m->angles becomes their number. */
static void fill_angles(mixing *m)
{
    double *at = m->angle_deg;
    size_t n = 0;
    /* Logarithmic steps up to EVEN_DEG, even steps to 180 degrees. */
    const double decades = log10(EVEN_DEG / FIRST_DEG);
    for (double i = 0; i < decades * LOG_STEPS; ++i) {
        at[n++] = FIRST_DEG * pow(10, i / LOG_STEPS);
    }
    for (double i = 0; i <= EVEN_STEPS_DEG / EVEN_STEP_DEG; ++i) {
        at[n++] = fmin(EVEN_DEG + i * EVEN_STEP_DEG, 180);
    }
    /* The angles of given tables, because the slope of their values may change
     * there. */
    for (size_t i = 0; i < m->mixture->n; ++i) {
        const murk_mixture_part *part = &m->mixture->part[i];
        for (size_t k = 0; k < part->angles; ++k) {
            if (part->angle_deg[k] > FIRST_DEG) {
                at[n++] = part->angle_deg[k];
            }
        }
    }
    /* Sort, and drop an angle that exceeds the angle before it by 1e-9 of the
     * value or less: with so small a step, rounding would determine the slope
     * of the table. */
    murk_sort(at, n);
    m->angles = 0;
    for (size_t i = 0; i < n; ++i) {
        if (m->angles == 0 || at[i] > at[m->angles - 1] * (1 + 1e-9)) {
            at[m->angles++] = at[i];
        }
    }
}

/* Evaluates the mixture at every angle and builds the table. */
static murk_status add_up(murk_phase_table **out, const mixing *m,
                          const char *where, murk_error *err)
{
    double *value = calloc(m->angles, sizeof *value);
    if (!value) {
        return murk_no_memory(err, where, "for a phase function");
    }
    for (size_t k = 0; k < m->angles; ++k) {
        const double mu = cos(m->angle_deg[k] * RADIANS);
        for (size_t i = 0; i < m->mixture->n; ++i) {
            value[k] += m->mixture->part[i].share *
                        murk_phase_density(&m->phase[i], mu);
        }
    }
    const murk_phase_rows rows = {.rows = m->angles,
                                  .angle_deg = m->angle_deg,
                                  .phase_per_sr = value,
                                  .where = where};
    const murk_status status = murk_phase_table_create(out, &rows, err);
    free(value);
    return status;
}

murk_status murk_mixture_table(murk_phase_table **out,
                               const murk_mixture *mixture, const char *where,
                               murk_error *err)
{
    if (mixture->n == 1 && mixture->part[0].kind == MURK_PHASE_TABLE) {
        return table_of(out, &mixture->part[0], where, err);
    }
    size_t max = STEPS_MAX;
    for (size_t i = 0; i < mixture->n; ++i) {
        max += mixture->part[i].angles;
    }
    /* Evaluate each part at all angles and add. */
    mixing m = {.mixture = mixture,
                .phase = calloc(mixture->n, sizeof *m.phase),
                .table = calloc(mixture->n, sizeof *m.table),
                .angle_deg = calloc(max, sizeof *m.angle_deg)};
    murk_status status =
        m.phase && m.table && m.angle_deg
            ? MURK_OK
            : murk_no_memory(err, where, "for a phase function");
    for (size_t i = 0; i < mixture->n && !status; ++i) {
        status = make_part(&m, i, where, err);
    }
    if (!status) {
        fill_angles(&m);
        status = add_up(out, &m, where, err);
    }
    /* Free the tables of the parts: the result has rows of its own. */
    for (size_t i = 0; m.table && i < mixture->n; ++i) {
        murk_phase_table_destroy(m.table[i]);
    }
    free(m.phase);
    free(m.table);
    free(m.angle_deg);
    return status;
}
