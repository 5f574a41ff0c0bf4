/* Validation: murk against reference numbers, one row a quantity.
 *
 * A case is a world, the quantities that one emitted photon scores to, and the
 * reference values. Photons go on in blocks until the standard error of every
 * quantity is at most 0.1 % of its reference or 3e-5 (nightly form), or four
 * times that (quick form), and at least VALIDATION_SCORERS photons scored to
 * each. Errors are by emitted photon. The number of photons depends on errors
 * and references only, never on the difference of the two.
 *
 * The verdict is a z-test a quantity, |murk - reference| over the square root
 * of standard error^2 + uncertainty^2, against the two-sided Sidak limit that
 * spends VALIDATION_FALSE_ALARM over all checks of the run; a row may have a
 * narrower limit of its own, or be a bound that murk must not exceed. Each
 * group of cases has a twin with a slightly wrong constant, which must be
 * refused by the same limits.
 *
 * In the nightly form a row whose error did not come down to what is asked
 * fails, unless its case says why its photons end before.
 *
 * A group is a file tests/physics/cases/NAME.c with a function
 * `void cases_NAME(validation *v)` and a row in cases/groups.h; it makes its
 * worlds one by one and calls validation_trace() or validation_check(). */
#ifndef MURK_TESTS_VALIDATION_H
#define MURK_TESTS_VALIDATION_H

#include "base/stats.h"
#include "transport/trace.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Chance that a run with another seed cries wolf though murk is right. */
#define VALIDATION_FALSE_ALARM 1e-3

/* With fewer scores than these a mean is too far from normal for its z. */
#define VALIDATION_SCORERS 200

#define VALIDATION_QUANTITIES_MAX 64

typedef struct validation validation;

typedef struct validation_reference {
    const char *quantity; /* "reflected"; copied */
    double value;
    double uncertainty; /* of the value: half a unit of its last printed digit,
                           and whatever else the case states, in quadrature */
} validation_reference;

/* What happened to a photon on one segment: `before` is the event that the
 * segment starts from, `event` the one it ends with (never the emission);
 * between them it flew straight along event->direction_in with event->weight of
 * its packet. Adds to scores[quantities]. Called on many threads: must change
 * nothing else. */
typedef void (*validation_score)(const void *context, const murk_event *before,
                                 const murk_event *event, double *scores);

/* A quantity that one of murk's own tallies measures: `scale` times a cell of
 * it. */
typedef struct validation_cell {
    size_t tally, cell; /* murk_tally_cells() says their order */
    double scale;       /* 0: 1 */
} validation_cell;

/* Members not named are zero: defaults. */
typedef struct validation_case {
    const char *name;     /* within its group: "n 1 albedo .9 g .75 tau 2" */
    const char *source;   /* of the reference: author, year, table or doi */
    const char *is_wrong; /* not NULL: a twin, and what is wrong: "g .70" */
    const murk_transport_world *world;
    const validation_reference *reference; /* [quantities] */
    size_t quantities;
    validation_score score; /* mean score of a photon = reference value; NULL:
                               nothing is scored */
    const void *context;
    const murk_tally_desc *tally; /* [tallies] in the world */
    size_t tallies;
    const validation_cell *cell; /* [cells] the last quantities, which are read
                                    from the tallies (one band); the first
                                    quantities - cells are scored */
    size_t cells;
    double least_weight;   /* 0: 1, roulette alone */
    double error_scale;    /* references are in units of this; 0: 1. The
                              absolute bound on errors is 3e-5 of it */
    double exactness;      /* errors asked for are divided by this; 0: 1 */
    uint64_t photons_max;  /* 0: 2^32. Rows whose errors are not reached then
                               are marked */
    const char *why_short; /* they may be in the nightly form, too, for this
                              reason, which is printed; NULL: they fail */
    uint32_t events_max;   /* 0: the tracer's own */
} validation_case;

/* Runs the case, if it is wanted, and keeps its rows for the verdict. */
void validation_trace(validation *v, const validation_case *c);

/* A row whose estimate was made elsewhere, by photons emitted photons; is_wrong
 * as above. */
void validation_check(validation *v, const char *name, const char *source,
                      const char *is_wrong,
                      const validation_reference *reference, murk_estimate murk,
                      uint64_t photons);

/* Of the last row. Its photons ended before its error was reached, for that
 * reason, or NULL: none that the nightly form lets pass. It is refused beyond
 * that many sigmas, where the run's own limit is wider. Its reference is a
 * bound: murk may be as far below as it likes, and not above. */
void validation_mark_short(validation *v, const char *why_short);
void validation_mark_limit(validation *v, double sigmas_max);
void validation_mark_bound(validation *v);

/* For groups: whether a case of that name runs at all; the form; the error that
 * a quantity must reach, with the absolute bound scaled as above; threads. */
bool validation_wants(const validation *v, const char *name);
bool validation_is_quick(const validation *v);
double validation_error_wanted(const validation *v, double reference,
                               double error_scale);
uint32_t validation_seed(const validation *v); /* of the run: mix in the case */
unsigned validation_threads(const validation *v);

/* The uncertainty of a number printed with that many digits after the point:
 * half a unit of the last. */
double validation_half_digit(int digits);
/* The same of the text of a number, "1.738497e+00" or ".09739". */
double validation_half_digit_of(const char *text);

/* ---- for the program that runs groups ---- */

typedef struct validation_settings {
    bool is_quick;
    unsigned threads;
    uint32_t seed;
    const char *const *wanted; /* [n_wanted] GROUP, or GROUP/PART-OF-A-NAME;
                                  none: all */
    size_t n_wanted;
} validation_settings;

/* Ends the program where memory is short. */
validation *validation_create(const validation_settings *settings);
void validation_destroy(validation *v);

/* All cases up to the next call belong to that group. */
void validation_group(validation *v, const char *group);

/* Prints all rows, twins, and the verdict as Markdown. */
void validation_markdown(const validation *v, FILE *out);
void validation_csv(const validation *v, FILE *out);

/* The rows of a file that validation_csv() wrote, as if they were traced here:
 * for runs in parts. Files may be of either form, of one seed: the first one's
 * takes the place of the run's. Ends the program where a file cannot be read or
 * has another seed. */
void validation_join(validation *v, const char *path);

/* True when at least one row was made, all of them lie within their limits, all
 * twins do not, errors are as small as they should be, and nothing was lost. */
bool validation_passed(const validation *v);

#endif
