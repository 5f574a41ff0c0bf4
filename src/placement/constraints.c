#include "placement/constraints.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct keyed {
    uint64_t key, then;
    uint32_t candidate;
} keyed;

static int by_key(const void *a, const void *b)
{
    const keyed *x = a, *y = b;
    if (x->key != y->key) {
        return x->key < y->key ? -1 : 1;
    }
    if (x->then != y->then) {
        return x->then < y->then ? -1 : 1;
    }
    return (x->candidate > y->candidate) - (x->candidate < y->candidate);
}

static bool is_near(const murk_constraints *constraints, uint32_t a, uint32_t b)
{
    if (!(constraints->spacing_m > 0)) {
        return false;
    }
    double square = 0;
    for (size_t axis = 0; axis < 3; ++axis) {
        const double d =
            constraints->position_m[a][axis] - constraints->position_m[b][axis];
        square += d * d;
    }
    return square < constraints->spacing_m * constraints->spacing_m;
}

/* Whether b is in a's list of conflicts. */
static bool is_listed(const murk_constraints *constraints, uint32_t a,
                      uint32_t b)
{
    if (!constraints->conflict_first) {
        return false;
    }
    size_t low = constraints->conflict_first[a],
           high = constraints->conflict_first[a + 1];
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (constraints->conflict[middle] == b) {
            return true;
        }
        if (constraints->conflict[middle] < b) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return false;
}

/* ---- for messages ---- */

typedef struct name {
    char text[80];
} name;

static const char *class_name(const murk_constraints *constraints, size_t class,
                              char out[sizeof(name)])
{
    if (constraints->class_name) {
        snprintf(out, sizeof(name), "type %s", constraints->class_name[class]);
    } else {
        snprintf(out, sizeof(name), "class %zu", class);
    }
    return out;
}

static double as_told(const murk_rulebook *book, uint64_t cost)
{
    const double unit = book->constraints->cost_unit;
    return (double)cost * (unit > 0 ? unit : 1);
}

/* Of two fixed sensors, by number, that do. */
static const char *why_excluded(const murk_rulebook *book, size_t i, size_t k)
{
    const uint32_t a = (uint32_t)book->constraints->fixed[i],
                   b = (uint32_t)book->constraints->fixed[k];
    return book->site && book->site[a] == book->site[b]
               ? "one sensor may stand at a site"
           : is_near(book->constraints, a, b)
               ? "they stand closer than the least spacing"
               : "they are given as a conflict";
}

bool murk_rulebook_excludes(const murk_rulebook *book, uint32_t a, uint32_t b)
{
    return (book->site && book->site[a] == book->site[b]) ||
           is_near(book->constraints, a, b) ||
           is_listed(book->constraints, a, b);
}

/* Whether whatever excludes a is b, or excludes b as well: sites and spacing by
 * the plain cases, one site or one place. */
static bool is_freer(const murk_rulebook *book, uint32_t a, uint32_t b)
{
    const murk_constraints *constraints = book->constraints;
    if (book->site && book->site[a] != book->site[b]) {
        return false;
    }
    if (constraints->spacing_m > 0 &&
        memcmp(constraints->position_m[a], constraints->position_m[b],
               sizeof constraints->position_m[a]) != 0) {
        return false;
    }
    if (constraints->conflict_first) {
        for (size_t k = constraints->conflict_first[a];
             k < constraints->conflict_first[a + 1]; ++k) {
            const uint32_t c = constraints->conflict[k];
            if (c != b && !is_listed(constraints, b, c)) {
                return false;
            }
        }
    }
    return true;
}

bool murk_rulebook_may_drop(const murk_rulebook *book, uint32_t a, uint32_t b)
{
    const uint32_t class = book->class_of[a];
    if (book->is_fixed[b] || class != book->class_of[b] ||
        murk_rulebook_cost(book, a) > murk_rulebook_cost(book, b) ||
        !is_freer(book, a, b)) {
        return false;
    }
    /* Where both may stand, b may be needed for the mere number: a plan of
     * exactly n can be filled up again only where nothing excludes. */
    const bool may_go =
        book->has_budget ? book->min[class] == 0 : !book->has_conflicts;
    return may_go || murk_rulebook_excludes(book, a, b);
}

static murk_status check_costs(const murk_constraints *constraints,
                               size_t candidates, murk_error *err)
{
    for (size_t j = 0; constraints->cost && j < candidates; ++j) {
        if (constraints->cost[j] < 0 || constraints->cost[j] > MURK_COST_MAX) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "cost of candidate %zu is %lld, must be 0..%lld",
                             j, (long long)constraints->cost[j],
                             (long long)MURK_COST_MAX);
        }
    }
    if (constraints->budget < 0) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "budget is %lld, must be 0 or more",
                         (long long)constraints->budget);
    }
    if (constraints->budget > 0 && !constraints->cost) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "budget is %lld, but no candidate has a cost",
                         (long long)constraints->budget);
    }
    return MURK_OK;
}

static murk_status check_conflicts(const murk_constraints *constraints,
                                   size_t candidates, murk_error *err)
{
    if (!(constraints->spacing_m >= 0 && isfinite(constraints->spacing_m))) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "spacing is %g m, must be 0 or more",
                         constraints->spacing_m);
    }
    if (constraints->spacing_m > 0 && !constraints->position_m) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "spacing is %g m, but no candidate has a position",
                         constraints->spacing_m);
    }
    if (!constraints->conflict_first) {
        return MURK_OK;
    }
    for (size_t j = 0; j < candidates; ++j) {
        const size_t first = constraints->conflict_first[j];
        for (size_t k = first; k < constraints->conflict_first[j + 1]; ++k) {
            const uint32_t other = constraints->conflict[k];
            if (other >= candidates || other == j ||
                (k > first && other <= constraints->conflict[k - 1]) ||
                !is_listed(constraints, other, (uint32_t)j)) {
                return murk_fail(err, MURK_BAD_VALUE, "",
                                 "conflict of candidate %zu with %u: must "
                                 "name another one below %zu, once, rising, "
                                 "and be named there, too",
                                 j, other, candidates);
            }
        }
    }
    return MURK_OK;
}

static bool allocate(murk_rulebook *book)
{
    const size_t n = book->candidates + 1, classes = book->classes + 1;
    book->class_of = calloc(n, sizeof *book->class_of);
    book->min = calloc(classes, sizeof *book->min);
    book->max = calloc(classes, sizeof *book->max);
    book->is_fixed = calloc(n, sizeof *book->is_fixed);
    book->by_cost = calloc(n, sizeof *book->by_cost);
    book->class_first = calloc(classes + 1, sizeof *book->class_first);
    if (book->constraints->site) {
        book->site = calloc(n, sizeof *book->site);
    }
    return book->class_of && book->min && book->max && book->is_fixed &&
           book->by_cost && book->class_first &&
           (book->site || !book->constraints->site);
}

/* Numbers the sites anew, without gaps. scratch[candidates]. */
static void index_sites(murk_rulebook *book, keyed *scratch)
{
    for (size_t j = 0; j < book->candidates; ++j) {
        scratch[j] = (keyed){book->constraints->site[j], 0, (uint32_t)j};
    }
    qsort(scratch, book->candidates, sizeof *scratch, by_key);
    for (size_t k = 0; k < book->candidates; ++k) {
        book->sites += k == 0 || scratch[k].key != scratch[k - 1].key;
        book->site[scratch[k].candidate] = (uint32_t)(book->sites - 1);
    }
}

static void index_costs(murk_rulebook *book, keyed *scratch)
{
    for (size_t j = 0; j < book->candidates; ++j) {
        const uint32_t class = book->class_of[j];
        scratch[j] =
            (keyed){class, murk_rulebook_cost(book, (uint32_t)j), (uint32_t)j};
        ++book->class_first[class + 1];
    }
    for (size_t c = 0; c < book->classes; ++c) {
        book->class_first[c + 1] += book->class_first[c];
    }
    qsort(scratch, book->candidates, sizeof *scratch, by_key);
    for (size_t k = 0; k < book->candidates; ++k) {
        book->by_cost[k] = scratch[k].candidate;
    }
}

static murk_status index_classes(murk_rulebook *book, murk_error *err)
{
    const murk_constraints *constraints = book->constraints;
    for (size_t j = 0; constraints->classes > 0 && j < book->candidates; ++j) {
        book->class_of[j] = constraints->class_of[j];
        if (constraints->class_of[j] >= constraints->classes) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "class of candidate %zu is %u, must be below %zu",
                             j, constraints->class_of[j], constraints->classes);
        }
    }
    return MURK_OK;
}

static murk_status index_counts(murk_rulebook *book, murk_error *err)
{
    const murk_constraints *constraints = book->constraints;
    for (size_t c = 0; c < book->classes; ++c) {
        const size_t size = book->class_first[c + 1] - book->class_first[c];
        const bool is_given = constraints->classes > 0;
        const size_t min =
            is_given && constraints->min ? constraints->min[c] : 0;
        const size_t max =
            is_given && constraints->max ? constraints->max[c] : size;
        if (min > size) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "%s must have at least %zu sensors, but has "
                             "only %zu usable candidates",
                             class_name(book->constraints, c, (name){{0}}.text),
                             min, size);
        }
        if (min > max) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "%s must have at least %zu sensors, but at most "
                             "%zu",
                             class_name(book->constraints, c, (name){{0}}.text),
                             min, max);
        }
        book->min[c] = min;
        book->max[c] = max < size ? max : size;
        book->has_min |= min > 0;
        book->has_caps |= max < size;
    }
    return MURK_OK;
}

static murk_status index_fixed(murk_rulebook *book, murk_error *err)
{
    const murk_constraints *constraints = book->constraints;
    for (size_t k = 0; k < constraints->fixed_count; ++k) {
        const size_t j = constraints->fixed[k];
        if (j >= book->candidates) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "fixed sensor at candidate %zu, must be below "
                             "%zu",
                             j, book->candidates);
        }
        if (book->is_fixed[j]) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "fixed sensor at candidate %zu is given twice", j);
        }
        for (size_t i = 0; i < k; ++i) {
            if (murk_rulebook_excludes(book, (uint32_t)constraints->fixed[i],
                                       (uint32_t)j)) {
                return murk_fail(
                    err, MURK_BAD_VALUE, "",
                    "fixed sensors %zu and %zu exclude each other: "
                    "%s",
                    i, k, why_excluded(book, i, k));
            }
        }
        book->is_fixed[j] = true;
    }
    return MURK_OK;
}

static size_t fixed_of_class(const murk_rulebook *book, size_t class)
{
    size_t sum = 0;
    for (size_t k = 0; k < book->constraints->fixed_count; ++k) {
        sum += book->class_of[book->constraints->fixed[k]] == class;
    }
    return sum;
}

/* What fixed sensors and least counts cost at least. */
static uint64_t min_cost(const murk_rulebook *book)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < book->constraints->fixed_count; ++k) {
        sum += murk_rulebook_cost(book, (uint32_t)book->constraints->fixed[k]);
    }
    for (size_t c = 0; c < book->classes; ++c) {
        size_t have = fixed_of_class(book, c);
        for (size_t k = book->class_first[c];
             k < book->class_first[c + 1] && have < book->min[c]; ++k) {
            if (!book->is_fixed[book->by_cost[k]]) {
                sum += murk_rulebook_cost(book, book->by_cost[k]);
                ++have;
            }
        }
    }
    return sum;
}

static murk_status check_budget(const murk_rulebook *book, murk_error *err)
{
    if (!book->has_budget) {
        return MURK_OK;
    }
    const uint64_t needed = min_cost(book);
    if (needed > book->budget) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "budget is %.10g, but fixed sensors and least counts "
                         "cost %.10g at least",
                         as_told(book, book->budget), as_told(book, needed));
    }
    uint64_t cheapest = UINT64_MAX;
    for (uint32_t j = 0; j < book->candidates; ++j) {
        const uint64_t cost = murk_rulebook_cost(book, j);
        cheapest = cost < cheapest ? cost : cheapest;
    }
    if (book->constraints->fixed_count == 0 && cheapest > book->budget) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "budget is %.10g, but the cheapest candidate costs "
                         "%.10g",
                         as_told(book, book->budget), as_told(book, cheapest));
    }
    return MURK_OK;
}

/* What of the count can be seen at once. */
static murk_status check_count(murk_rulebook *book, size_t count, bool is_max,
                               murk_error *err)
{
    size_t needed = 0, allowed = 0;
    for (size_t c = 0; c < book->classes; ++c) {
        const size_t fixed = fixed_of_class(book, c);
        if (fixed > book->max[c]) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "%s may have at most %zu sensors, but %zu are "
                             "fixed",
                             class_name(book->constraints, c, (name){{0}}.text),
                             book->max[c], fixed);
        }
        needed += fixed > book->min[c] ? fixed : book->min[c];
        allowed += book->max[c];
    }
    if (needed > count) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "%zu sensors asked for, but fixed sensors and least "
                         "counts need %zu",
                         count, needed);
    }
    if (!is_max && allowed < count) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "%zu sensors asked for, but the classes' greatest "
                         "counts allow only %zu",
                         count, allowed);
    }
    if (!is_max && book->site && book->sites < count) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "%zu sensors asked for, but only %zu sites, with one "
                         "sensor each",
                         count, book->sites);
    }
    allowed = book->site && book->sites < allowed ? book->sites : allowed;
    book->max_sensors = count < allowed ? count : allowed;
    book->fewest_sensors = needed > 0 ? needed : 1;
    if (needed > book->max_sensors) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "fixed sensors and least counts need %zu sensors, "
                         "but only %zu may stand, one a site",
                         needed, book->max_sensors);
    }
    return MURK_OK;
}

murk_status murk_rulebook_init(murk_rulebook *out,
                               const murk_constraints *constraints,
                               size_t candidates, size_t count, bool is_max,
                               murk_error *err)
{
    assert(constraints->classes == 0 || constraints->class_of);
    *out = (murk_rulebook){
        .constraints = constraints,
        .candidates = candidates,
        .classes = constraints->classes > 0 ? constraints->classes : 1,
        .budget = constraints->budget > 0 ? (uint64_t)constraints->budget
                                          : UINT64_MAX,
        .has_budget = constraints->budget > 0,
        .has_conflicts = constraints->site || constraints->spacing_m > 0 ||
                         constraints->conflict_first};
    keyed *scratch = NULL;
    murk_status status = check_costs(constraints, candidates, err);
    if (!status) {
        status = check_conflicts(constraints, candidates, err);
    }
    if (status) {
        return status;
    }
    scratch = calloc(candidates + 1, sizeof *scratch);
    if (!scratch || !allocate(out)) {
        status =
            murk_fail(err, MURK_NO_MEMORY, "",
                      "no memory for the rules of %zu candidates", candidates);
    }
    if (!status) {
        status = index_classes(out, err);
    }
    if (!status) {
        if (constraints->site) {
            index_sites(out, scratch);
        }
        index_costs(out, scratch);
        status = index_counts(out, err);
    }
    if (!status) {
        status = index_fixed(out, err);
    }
    if (!status) {
        status = check_count(out, count, is_max, err);
    }
    if (!status) {
        status = check_budget(out, err);
    }
    free(scratch);
    if (status) {
        murk_rulebook_release(out);
    }
    return status;
}

void murk_rulebook_release(murk_rulebook *book)
{
    free(book->class_of);
    free(book->site);
    free(book->min);
    free(book->max);
    free(book->is_fixed);
    free(book->by_cost);
    free(book->class_first);
    *book = (murk_rulebook){0};
}
