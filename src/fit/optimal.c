/* D-optimal selection of measurements by greedy selection and exchanges
 * (fit/optimal.h).
 *
 * With the information matrix A and the variance v = r^T A^-1 r of a predicted
 * reading with row r, the reading multiplies det A by 1 + v. Replacing reading
 * i by c multiplies det A by (1 + v_c)(1 - v_i) + (r_c^T A^-1 r_i)^2. The
 * variances of all candidates are stored; adding a reading p subtracts (r^T
 * u)^2 from each, with u = A^-1 r_p / sqrt(1 + v_p). */
#include "fit/optimal.h"

#include "base/arena.h"
#include "base/sort.h"
#include "fit/ceres_bridge.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Information that is added to each parameter, as if it had been measured once
 * with an error of a thousand scales. */
#define KNOWN_BEFORE 1e-6

/* The least share by which an exchange must increase det A: smaller increases
 * may be rounding errors and could be reversed. */
#define EXCHANGE_MIN 1e-9

/* After this number of multiplications no further exchange is tried (some five
 * seconds). Scalar products with the rows of all candidates count. Later
 * exchanges gain little: greedy selection alone has at least 1 - 1/e of the
 * largest possible gain of log det A (Nemhauser, Wolsey and Fisher, Math.
 * Program. 14 (1978) 265, doi:10.1007/BF01588971). */
#define EXCHANGE_WORK_MAX 1e10

/* The number of candidates that are processed together: their sums stay in
 * registers. */
#define TOGETHER 4

typedef struct choice {
    size_t n, candidates, k;
    const double *row;         /* [candidates][n] */
    const double *information; /* [n * n] of the existing readings alone */
    double *lower;             /* [n * n] Cholesky factor of the information A
                                * when factorise() was called last */
    double *variance;          /* [candidates] v with all candidates that are
                                * selected so far */
    double *update;            /* [k][n] vectors u (formula above) of the
                                * candidates selected since `lower` was
                                * computed; a workspace during exchanges */
    double *work;              /* [n * TOGETHER] */
    bool *is_picked;           /* [candidates] */
    size_t *pick;              /* [k] */
    murk_arena arena;          /* of all arrays */
} choice;

/* Scalar product with four independent sums, which the processor computes in
 * parallel. */
static double dot(const double *a, const double *b, size_t n)
{
    double sum[4] = {0};
    size_t i = 0;
    for (; i + 4 <= n; i += 4) {
        for (size_t lane = 0; lane < 4; ++lane) {
            sum[lane] += a[i + lane] * b[i + lane];
        }
    }
    for (; i < n; ++i) {
        sum[0] += a[i] * b[i];
    }
    return sum[0] + sum[1] + (sum[2] + sum[3]);
}

static const double *row_of(const choice *c, size_t candidate)
{
    return c->row + candidate * c->n;
}

/* Computes the Cholesky factor of the information with the first `picks`
 * selected candidates and KNOWN_BEFORE on the diagonal. */
static murk_status factorise(choice *c, size_t picks, murk_error *err)
{
    const size_t n = c->n;
    memcpy(c->lower, c->information, n * n * sizeof *c->lower);
    for (size_t i = 0; i < n; ++i) {
        c->lower[i * n + i] += KNOWN_BEFORE;
    }
    /* Add r r^T of each selected candidate. */
    for (size_t p = 0; p < picks; ++p) {
        const double *r = row_of(c, c->pick[p]);
        for (size_t i = 0; i < n; ++i) {
            for (size_t j = 0; j <= i; ++j) {
                c->lower[i * n + j] += r[i] * r[j];
            }
        }
    }
    bool is_positive;
    const murk_ceres *ceres = murk_ceres_load(err);
    const murk_status status =
        ceres ? ceres->cholesky(c->lower, n, &is_positive, err)
              : MURK_RUN_FAILED;
    if (!status && !is_positive) {
        return murk_fail(err, MURK_RUN_FAILED, "fit",
                         "the information about %zu parameters is not positive "
                         "semidefinite",
                         n);
    }
    return status;
}

/* x = A^-1 r. */
static void solve(const choice *c, double *x, const double *r)
{
    const size_t n = c->n;
    for (size_t i = 0; i < n; ++i) {
        x[i] = (r[i] - dot(c->lower + i * n, x, i)) / c->lower[i * n + i];
    }
    for (size_t i = n; i-- > 0;) {
        x[i] /= c->lower[i * n + i];
        for (size_t k = 0; k < i; ++k) {
            x[k] -= c->lower[i * n + k] * x[i];
        }
    }
}

/* Computes the variances |L^-1 r|^2 of `count` candidates, at most TOGETHER. */
static void read_variances_at(choice *c, size_t first, size_t count)
{
    double sum[TOGETHER] = {0};
    for (size_t i = 0; i < c->n; ++i) {
        const double *lower = c->lower + i * c->n;
        double at[TOGETHER] = {0};
        for (size_t lane = 0; lane < count; ++lane) {
            at[lane] = row_of(c, first + lane)[i];
        }
        for (size_t k = 0; k < i; ++k) {
            const double *above = c->work + k * TOGETHER;
            for (size_t lane = 0; lane < TOGETHER; ++lane) {
                at[lane] -= lower[k] * above[lane];
            }
        }
        for (size_t lane = 0; lane < TOGETHER; ++lane) {
            at[lane] /= lower[i];
            c->work[i * TOGETHER + lane] = at[lane];
            sum[lane] += at[lane] * at[lane];
        }
    }
    memcpy(c->variance + first, sum, count * sizeof *sum);
}

static void read_variances(choice *c)
{
    for (size_t i = 0; i < c->candidates; i += TOGETHER) {
        const size_t left = c->candidates - i;
        read_variances_at(c, i, left < TOGETHER ? left : TOGETHER);
    }
}

/* Computes the vector u of a candidate that is selected as number p, after the
 * previous ones, which `lower` does not contain. Returns the variance of the
 * candidate. */
static double compute_update(choice *c, size_t p, size_t candidate)
{
    const double *r = row_of(c, candidate);
    double *u = c->update + p * c->n;
    solve(c, u, r);
    for (size_t q = 0; q < p; ++q) {
        const double *before = c->update + q * c->n;
        const double share = dot(before, r, c->n);
        for (size_t i = 0; i < c->n; ++i) {
            u[i] -= share * before[i];
        }
    }
    const double variance = fmax(dot(u, r, c->n), 0);
    for (size_t i = 0; i < c->n; ++i) {
        u[i] /= sqrt(1 + variance);
    }
    return variance;
}

static void take_from_variances(choice *c, const double *u)
{
    for (size_t i = 0; i < c->candidates; ++i) {
        const double share = dot(row_of(c, i), u, c->n);
        c->variance[i] = fmax(c->variance[i] - share * share, 0);
    }
}

static void choose_greedily(choice *c)
{
    for (size_t p = 0; p < c->k; ++p) {
        size_t best = c->candidates;
        for (size_t i = 0; i < c->candidates; ++i) {
            if (!c->is_picked[i] &&
                (best == c->candidates || c->variance[i] > c->variance[best])) {
                best = i;
            }
        }
        c->pick[p] = best;
        c->is_picked[best] = true;
        (void)compute_update(c, p, best);
        take_from_variances(c, c->update + p * c->n);
    }
}

/* Finds the best candidate to replace selected candidate p, and the factor by
 * which det A grows; returns `candidates` if no factor exceeds 1 +
 * EXCHANGE_MIN. `lower` contains all selected candidates. x becomes A^-1 r of
 * candidate p. */
static size_t better_than(const choice *c, size_t p, double *x, double *factor)
{
    const double *r = row_of(c, c->pick[p]);
    solve(c, x, r);
    const double own = dot(x, r, c->n);
    size_t best = c->candidates;
    *factor = 1 + EXCHANGE_MIN;
    for (size_t i = 0; i < c->candidates; ++i) {
        if (c->is_picked[i]) {
            continue;
        }
        const double shared = dot(row_of(c, i), x, c->n);
        const double by = (1 + c->variance[i]) * (1 - own) + shared * shared;
        if (by > *factor) {
            *factor = by;
            best = i;
        }
    }
    return best;
}

/* Replaces selected candidate p by `in`; x is A^-1 r of candidate p and is
 * overwritten. The new candidate is added before the old one is removed, so
 * that the information never becomes singular in between. The divisor of the
 * removal follows from the factor without cancellation. */
static murk_status exchange(choice *c, size_t p, size_t in, double factor,
                            double *x, murk_error *err)
{
    const size_t n = c->n;
    /* Add `in`. */
    const double *out = row_of(c, c->pick[p]);
    double *u = c->work;
    solve(c, u, row_of(c, in));
    const double joins = 1 + fmax(dot(u, row_of(c, in), n), 0);
    for (size_t i = 0; i < n; ++i) {
        u[i] /= sqrt(joins);
    }
    /* Remove the old one. */
    const double share = dot(u, out, n);
    for (size_t i = 0; i < n; ++i) {
        x[i] = (x[i] - share * u[i]) / sqrt(factor / joins);
    }
    for (size_t i = 0; i < c->candidates; ++i) {
        const double *r = row_of(c, i);
        const double less = dot(r, u, n), more = dot(r, x, n);
        c->variance[i] = fmax(c->variance[i] - less * less + more * more, 0);
    }
    c->is_picked[c->pick[p]] = false;
    c->is_picked[in] = true;
    c->pick[p] = in;
    return factorise(c, c->k, err);
}

static murk_status choose_better(choice *c, murk_error *err)
{
    murk_status status = factorise(c, c->k, err);
    if (status) {
        return status;
    }
    read_variances(c);
    double *x = c->update; /* `update` is no longer needed */
    const double a_pass = (double)c->candidates * (double)c->n;
    double work = 0;
    /* Try to replace one selected candidate after the other, until none was
     * replaced in a whole round or the limit on work is reached. */
    for (size_t since = 0, p = 0; since < c->k && work < EXCHANGE_WORK_MAX;
         p = (p + 1) % c->k) {
        double factor;
        const size_t in = better_than(c, p, x, &factor);
        work += a_pass;
        ++since;
        if (in < c->candidates) {
            status = exchange(c, p, in, factor, x, err);
            if (status) {
                return status;
            }
            work += 2 * a_pass;
            since = 0;
        }
    }
    return MURK_OK;
}

/* Orders the selected candidates: the candidate that comes next is the one
 * whose reading, added to those before, has the largest gain. */
static murk_status order(choice *c, murk_optimal_pick *pick, murk_error *err)
{
    murk_status status = factorise(c, 0, err);
    if (status) {
        return status;
    }
    qsort(c->pick, c->k, sizeof *c->pick, murk_by_size);
    for (size_t p = 0; p < c->k; ++p) {
        double max = -1;
        size_t at = p;
        for (size_t q = p; q < c->k; ++q) {
            const double variance = compute_update(c, p, c->pick[q]);
            if (variance > max) {
                max = variance;
                at = q;
            }
        }
        const size_t first = c->pick[at];
        memmove(c->pick + p + 1, c->pick + p, (at - p) * sizeof *c->pick);
        c->pick[p] = first;
        pick[p] = (murk_optimal_pick){first, log1p(max)};
        (void)compute_update(c, p, first);
    }
    return MURK_OK;
}

static murk_status check(size_t k, const double *information, const double *row,
                         size_t candidates, size_t n, murk_error *err)
{
    if (k > candidates) {
        return murk_fail(err, MURK_BAD_VALUE, "fit",
                         "%zu next readings of %zu candidates, must be at most "
                         "as many",
                         k, candidates);
    }
    /* All numbers must be finite. */
    for (size_t i = 0; i < n * n; ++i) {
        if (!isfinite(information[i])) {
            return murk_fail(err, MURK_BAD_VALUE, "fit",
                             "the information about parameters %zu and %zu is "
                             "%g, must be finite",
                             i / n, i % n, information[i]);
        }
    }
    for (size_t i = 0; i < candidates * n; ++i) {
        if (!isfinite(row[i])) {
            return murk_fail(err, MURK_BAD_VALUE, "fit",
                             "candidate %zu depends on parameter %zu by %g, "
                             "must be finite",
                             i / n, i % n, row[i]);
        }
    }
    return MURK_OK;
}

static murk_status choice_create(choice *c, murk_error *err)
{
    const size_t n = c->n, size = sizeof(double);
    murk_arena *arena = &c->arena;
    c->lower = murk_arena_array(arena, n * n, size);
    c->variance = murk_arena_array(arena, c->candidates, size);
    c->update = murk_arena_array(arena, c->k * n, size);
    c->work = murk_arena_array(arena, n * TOGETHER, size);
    c->is_picked = murk_arena_array(arena, c->candidates, sizeof(bool));
    c->pick = murk_arena_array(arena, c->k, sizeof *c->pick);
    return arena->is_short
               ? murk_no_memory(err, "fit", "to choose among %zu candidates",
                                c->candidates)
               : MURK_OK;
}

murk_status murk_optimal_choose(murk_optimal_pick *pick, size_t k,
                                const double *information, const double *row,
                                size_t candidates, size_t n, murk_error *err)
{
    assert(pick && information && row && n > 0);
    murk_status status = check(k, information, row, candidates, n, err);
    if (status || k == 0) {
        return status;
    }
    /* Select greedily, exchange, and sort by gain. */
    choice c = {.n = n,
                .candidates = candidates,
                .k = k,
                .row = row,
                .information = information};
    status = choice_create(&c, err);
    status = status ? status : factorise(&c, 0, err);
    if (!status) {
        read_variances(&c);
        choose_greedily(&c);
        status = choose_better(&c, err);
    }
    status = status ? status : order(&c, pick, err);
    murk_arena_release(&c.arena);
    return status;
}
