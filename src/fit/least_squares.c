/* Bounded minimisation by unbounded runs of Ceres.
 *
 * Ceres enforces bounds by projecting each step of the unbounded problem. A
 * parameter that presses against a bound then still receives a component of
 * every step, and with correlated parameters the search zigzags (one in fifteen
 * of the problems of tests/unit/fit/test_bounds.c is not solved in 100
 * iterations). Therefore Ceres is not told about bounds. Ceres receives the
 * residuals at the nearest point within the bounds, which do not depend on a
 * parameter that is beyond a bound, so that this parameter drops out of all
 * steps. When a run of Ceres converges, a new pass begins at the point reached:
 * parameters with equal bounds and parameters whose gradient presses them
 * against a bound are held, and all others are free again. The passes end when
 * one changes neither the set of held parameters nor, beyond the tolerance, the
 * cost, when no parameter is free, or at a limit of iterations or passes
 * (Bertsekas, SIAM J. Control Optim. 20 (1982) 221, doi:10.1137/0320018). Each
 * pass begins with a new trust region, so that steps that had become short are
 * not mistaken for convergence. */
#include "fit/least_squares.h"

#include "base/arena.h"
#include "base/c_locale.h"
#include "fit/ceres_bridge.h"

#include <assert.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define ITERATIONS_DEFAULT 100   /* unless the caller sets a limit */
#define TOLERANCE_DEFAULT  1e-10 /* far below a change of chi-squared by 1 */

/* The largest number of passes: sets of held parameters could alternate at the
 * same cost. */
#define PASSES_MAX 100

/* The result of the callback of the caller at one x. */
typedef struct place {
    double *x, *residual, *jacobian;
    bool has_residual, has_jacobian;
} place;

typedef struct search {
    const murk_least_squares *problem;
    bool *is_held;     /* [n] parameters that are held in this pass */
    double *within;    /* [n] point of Ceres, moved within the bounds */
    place best, other; /* two points are stored, so that results that are known
                        * are not requested again */
    double *start;     /* [n] start of a pass */
    double *gradient;  /* [n] gradient at the best point */
    double cost;       /* cost of the best point */
    bool is_refused;   /* the last call of the callback in this pass gave no
                        * finite residuals */
    int evaluations;
    int iterations, iterations_before; /* in total; before this pass */
    murk_arena arena;                  /* of all arrays */
} search;

/* Computes cost and gradient at the best point. */
static void read_best(search *s)
{
    const size_t n = s->problem->n;
    double sum = 0;
    memset(s->gradient, 0, n * sizeof *s->gradient);
    for (size_t i = 0; i < s->problem->rows; ++i) {
        const double r = s->best.residual[i];
        double slope;
        sum += murk_loss_at(s->problem->loss, s->problem->loss_width, r * r,
                            &slope);
        for (size_t j = 0; j < n; ++j) {
            s->gradient[j] += slope * r * s->best.jacobian[i * n + j];
        }
    }
    s->cost = sum / 2;
}

/* Makes the other point the best one. */
static void take_other(search *s)
{
    const place best = s->other;
    s->other = s->best;
    s->best = best;
    read_best(s);
}

/* True if all numbers and the sum of their squares are finite: Ceres fails
 * otherwise. */
static bool is_summable(const double *x, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; ++i) {
        sum += x[i] * x[i];
    }
    return isfinite(sum);
}

static bool knows(const place *at, const double *x, size_t n,
                  bool with_jacobian)
{
    return at->has_residual && (at->has_jacobian || !with_jacobian) &&
           memcmp(x, at->x, n * sizeof *x) == 0;
}

/* Returns the residuals at x, and the Jacobian if with_jacobian: stored ones,
 * or new ones from the callback of the caller. Returns NULL if the callback
 * returns false or its numbers are not finite. */
static const place *evaluate(search *s, const double *x, bool with_jacobian)
{
    const murk_least_squares *p = s->problem;
    if (knows(&s->best, x, p->n, with_jacobian)) {
        return &s->best; /* a step that is too short to change x ends here,
                          * too */
    }
    place *at = &s->other;
    if (knows(at, x, p->n, with_jacobian)) {
        return at;
    }
    memcpy(at->x, x, p->n * sizeof *x);
    at->has_residual = at->has_jacobian = false;
    ++s->evaluations;
    s->is_refused =
        !p->residuals(p->context, at->x, at->residual,
                      with_jacobian ? at->jacobian : NULL) ||
        !is_summable(at->residual, p->rows) ||
        (with_jacobian && !is_summable(at->jacobian, p->rows * p->n));
    if (s->is_refused) {
        return NULL;
    }
    at->has_residual = true;
    at->has_jacobian = with_jacobian;
    return at;
}

static const double *bring_within(search *s, const double *x)
{
    const murk_least_squares *p = s->problem;
    for (size_t j = 0; j < p->n; ++j) {
        s->within[j] = fmin(fmax(x[j], p->lower[j]), p->upper[j]);
    }
    return s->within;
}

static bool answer_residuals(void *context, const double *x, double *residual,
                             double *jacobian)
{
    search *s = context;
    const murk_least_squares *p = s->problem;
    const place *at = evaluate(s, bring_within(s, x),
                               jacobian != NULL || p->is_jacobian_free);
    if (!at) {
        return false;
    }
    memcpy(residual, at->residual, p->rows * sizeof *residual);
    for (size_t i = 0; jacobian && i < p->rows; ++i) {
        for (size_t j = 0; j < p->n; ++j) {
            const bool is_beyond = x[j] < p->lower[j] || x[j] > p->upper[j];
            jacobian[i * p->n + j] = is_beyond ? 0 : at->jacobian[i * p->n + j];
        }
    }
    return true;
}

static bool report(const search *s, bool is_successful)
{
    const murk_least_squares *p = s->problem;
    const murk_least_squares_step step = {s->iterations, is_successful, s->cost,
                                          s->best.x};
    return !p->watch || p->watch(p->context, &step);
}

/* Reports an iteration of Ceres. Before the report, the point of a successful
 * step becomes the best point: Ceres has requested its residuals and Jacobian
 * by then, so they are stored in `other`. */
static bool answer_watch(void *context, const murk_least_squares_step *step)
{
    search *s = context;
    if (step->iteration == 0) {
        return true; /* the start of a pass was reported before */
    }
    s->iterations = s->iterations_before + step->iteration;
    if (step->is_successful &&
        knows(&s->other, bring_within(s, step->x), s->problem->n, true)) {
        take_other(s);
    }
    return report(s, step->is_successful);
}

/* Selects the parameters that are held in the next pass: those with equal
 * bounds, and those that the gradient presses against a bound. Returns the
 * number of free parameters; *has_changed: the set differs from the previous
 * one. */
static size_t hold(search *s, bool *has_changed)
{
    const murk_least_squares *p = s->problem;
    size_t left = 0;
    *has_changed = false;
    for (size_t j = 0; j < p->n; ++j) {
        const double x = s->best.x[j], slope = s->gradient[j];
        const bool holds = !(p->lower[j] < p->upper[j]) ||
                           (x <= p->lower[j] && slope > 0) ||
                           (x >= p->upper[j] && slope < 0);
        *has_changed = *has_changed || holds != s->is_held[j];
        s->is_held[j] = holds;
        left += !holds;
    }
    return left;
}

/* Sets the kind of end, and the reason in one line: our own words and, unless
 * it is empty, the start of the message of Ceres. */
static void say(murk_least_squares_found *found, murk_least_squares_end end,
                const char *ours, const char *ceres)
{
    found->end = end;
    (void)snprintf(found->why, sizeof found->why, "%s%s%.160s%s", ours,
                   ceres[0] ? " (Ceres: " : "", ceres, ceres[0] ? ")" : "");
}

/* Sets the reason why a pass ended. Returns true if a further pass is
 * useful. */
static bool goes_on(murk_least_squares_found *found, const search *s,
                    const murk_ceres_found *pass)
{
    const char *ceres = pass->message;
    if (pass->end == MURK_CERES_STOPPED) {
        say(found, MURK_LEAST_SQUARES_STOPPED, "stopped by its watch", "");
        return false;
    }
    if (pass->end == MURK_CERES_ITERATIONS) {
        say(found, MURK_LEAST_SQUARES_ITERATIONS, "out of iterations", ceres);
        return false;
    }
    if (s->is_refused) { /* the steps may have become short because points had
                          * no finite residuals */
        say(found, MURK_LEAST_SQUARES_FAILED,
            "where the search goes there are no finite residuals", ceres);
        return false;
    }
    if (pass->end == MURK_CERES_FAILED) {
        say(found, MURK_LEAST_SQUARES_FAILED, "no step lowers the cost", ceres);
        return false;
    }
    say(found, MURK_LEAST_SQUARES_CONVERGED,
        pass->end == MURK_CERES_LEVEL        ? "the cost falls no further"
        : pass->end == MURK_CERES_SHORT_STEP ? "steps have become nothing"
                                             : "the gradient is 0",
        ceres);
    return true;
}

/* Improves the best point, whose residuals and Jacobian are known, pass by
 * pass. */
static murk_status search_on(murk_least_squares_found *found, search *s,
                             murk_error *err)
{
    murk_least_squares run = *s->problem;
    run.residuals = answer_residuals;
    run.watch = answer_watch;
    run.context = s;
    run.tolerance = run.tolerance > 0 ? run.tolerance : TOLERANCE_DEFAULT;
    const int limit =
        run.iterations_max ? run.iterations_max : ITERATIONS_DEFAULT;
    double *x = s->start;
    double before = INFINITY;
    for (int pass = 0; pass < PASSES_MAX; ++pass) {
        /* Stop if nothing is left to improve or no iteration is left. */
        bool has_changed;
        const size_t left = hold(s, &has_changed);
        if (left == 0) {
            say(found, MURK_LEAST_SQUARES_CONVERGED,
                "every parameter is fixed or held by a bound", "");
            return MURK_OK;
        }
        if (!has_changed && before - s->cost <= run.tolerance * s->cost) {
            return MURK_OK;
        }
        if (s->iterations >= limit) {
            say(found, MURK_LEAST_SQUARES_ITERATIONS, "out of iterations", "");
            return MURK_OK;
        }
        /* Run Ceres from the best point with the free parameters. */
        before = s->cost;
        s->iterations_before = s->iterations;
        run.iterations_max = limit - s->iterations;
        s->is_refused = false;
        memcpy(x, s->best.x, run.n * sizeof *x);
        murk_ceres_found of_pass;
        const murk_ceres *ceres = murk_ceres_load(err);
        if (!ceres) {
            return MURK_RUN_FAILED;
        }
        void *locale = murk_c_locale_enter(); /* Ceres prints numbers */
        const murk_status status =
            ceres->minimise(&of_pass, x, s->is_held, &run, err);
        murk_c_locale_leave(locale);
        if (status) {
            return status;
        }
        if (!goes_on(found, s, &of_pass)) {
            return MURK_OK;
        }
    }
    say(found, MURK_LEAST_SQUARES_ITERATIONS,
        "parameters come to bounds and leave them without end", "");
    return MURK_OK;
}

static murk_status check(const double *x, const murk_least_squares *p,
                         murk_error *err)
{
    if (p->n < 1 || p->rows < 1 || p->rows > INT_MAX / p->n) {
        return murk_fail(err, MURK_BAD_VALUE, "fit",
                         "%zu rows of %zu parameters, must be 1 or more of "
                         "each and at most %d numbers together",
                         p->rows, p->n, INT_MAX);
    }
    /* Bounds and start of each parameter. */
    for (size_t j = 0; j < p->n; ++j) {
        if (!(p->lower[j] <= p->upper[j])) {
            return murk_fail(err, MURK_BAD_VALUE, "fit",
                             "the bounds of parameter %zu are %g..%g, must "
                             "be numbers, the lower first",
                             j, p->lower[j], p->upper[j]);
        }
        if (!(x[j] >= p->lower[j] && x[j] <= p->upper[j] && isfinite(x[j]))) {
            return murk_fail(err, MURK_BAD_VALUE, "fit",
                             "parameter %zu starts at %g, must be %g..%g", j,
                             x[j], p->lower[j], p->upper[j]);
        }
    }
    /* Loss and limits. */
    if (p->loss != MURK_LOSS_FUNCTION_NONE &&
        !(p->loss_width > 0 && isfinite(p->loss_width))) {
        return murk_fail(err, MURK_BAD_VALUE, "fit",
                         "the width of the loss is %g, must be above 0",
                         p->loss_width);
    }
    if (!(p->tolerance >= 0 && p->tolerance < 1)) {
        return murk_fail(err, MURK_BAD_VALUE, "fit",
                         "the tolerance is %g, must be 0 up to 1",
                         p->tolerance);
    }
    if (p->iterations_max < 0) {
        return murk_fail(err, MURK_BAD_VALUE, "fit",
                         "iterations_max is %d, must be 0 or more",
                         p->iterations_max);
    }
    return MURK_OK;
}

/* Allocates all arrays of a search; false if there is not enough memory. */
static bool allocate(search *s)
{
    const size_t n = s->problem->n, rows = s->problem->rows;
    double **const of_n[] = {&s->within, &s->gradient, &s->start, &s->best.x,
                             &s->other.x};
    for (size_t i = 0; i < sizeof of_n / sizeof *of_n; ++i) {
        *of_n[i] = murk_arena_array(&s->arena, n, sizeof(double));
    }
    place *const points[] = {&s->best, &s->other};
    for (size_t i = 0; i < 2; ++i) {
        points[i]->residual = murk_arena_array(&s->arena, rows, sizeof(double));
        points[i]->jacobian =
            murk_arena_array(&s->arena, rows * n, sizeof(double));
    }
    s->is_held = murk_arena_array(&s->arena, n, sizeof(bool));
    return !s->arena.is_short;
}

double murk_loss_at(murk_loss_function loss, double width, double s,
                    double *slope)
{
    const double b = width * width;
    switch (loss) {
    case MURK_LOSS_FUNCTION_HUBER:
        if (s > b) {
            *slope = width / sqrt(s);
            return 2 * width * sqrt(s) - b;
        }
        break;
    case MURK_LOSS_FUNCTION_CAUCHY:
        *slope = 1 / (1 + s / b);
        return b * log1p(s / b);
    case MURK_LOSS_FUNCTION_NONE:
        break;
    }
    *slope = 1;
    return s;
}

murk_status murk_least_squares_solve(murk_least_squares_found *found, double *x,
                                     const murk_least_squares *problem,
                                     murk_error *err)
{
    assert(found && x && problem && problem->lower && problem->upper &&
           problem->residuals);
    murk_status status = check(x, problem, err);
    if (status) {
        return status;
    }
    search s = {.problem = problem};
    if (!allocate(&s)) {
        status = murk_no_memory(err, "fit", "for %zu rows of %zu parameters",
                                problem->rows, problem->n);
        goto done;
    }
    /* Evaluate the start. */
    murk_least_squares_found out = {.initial_cost = NAN, .cost = NAN};
    if (!evaluate(&s, x, true)) {
        say(&out, MURK_LEAST_SQUARES_FAILED,
            "there are no finite residuals at the start", "");
        out.evaluations = s.evaluations;
        *found = out;
        goto done;
    }
    /* Search from there. */
    take_other(&s);
    out.initial_cost = s.cost;
    if (!report(&s, true)) {
        say(&out, MURK_LEAST_SQUARES_STOPPED, "stopped by its watch", "");
    } else {
        status = search_on(&out, &s, err);
        if (status) {
            goto done;
        }
    }
    out.cost = s.cost;
    out.iterations = s.iterations;
    out.evaluations = s.evaluations;
    memcpy(x, s.best.x, problem->n * sizeof *x);
    *found = out;
done:
    murk_arena_release(&s.arena);
    return status;
}
