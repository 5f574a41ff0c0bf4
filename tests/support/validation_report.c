/* The verdicts of a validation run: distances in standard errors, the limit
 * that shares the false-alarm budget among all checks, and the table in
 * Markdown or CSV. */
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "validation_rows.h"

double validation_sigmas(const validation_row *row)
{
    const double sigma = hypot(row->murk.standard_error, row->uncertainty);
    const double off = (row->murk.value - row->reference) / sigma;
    return sigma > 0 && !isnan(off) ? off : INFINITY;
}

static bool is_twin(const validation_row *row)
{
    return row->wrong[0] != '\0';
}

/* Those that share the false alarm: bounds are no z-tests. */
static size_t checks(const validation *v)
{
    size_t n = 0;
    for (size_t i = 0; i < v->rows; ++i) {
        n += !is_twin(&v->row[i]) && !v->row[i].is_bound;
    }
    return n;
}

static double limit_of(const validation *v)
{
    const size_t n = checks(v);
    return murk_sidak_limit(VALIDATION_FALSE_ALARM, n > 0 ? (double)n : 1);
}

/* How far a row is off in the way that counts against it. */
static double against(const validation_row *row)
{
    const double off = validation_sigmas(row);
    return row->is_bound ? fmax(off, 0) : fabs(off);
}

static bool is_refused(const validation_row *row, double limit)
{
    const double own = row->sigmas_max > 0 ? row->sigmas_max : limit;
    return !(against(row) <= (row->is_bound ? 0 : fmin(own, limit)));
}

/* The quick form only marks it. */
static bool is_wrongly_short(const validation_row *row)
{
    return row->is_short && !row->is_quick && row->why_short[0] == '\0';
}

static bool is_one_case(const validation_row *a, const validation_row *b)
{
    return strcmp(a->group, b->group) == 0 && strcmp(a->name, b->name) == 0 &&
           strcmp(a->wrong, b->wrong) == 0;
}

/* The row that is farthest off of the case that begins at row i; *end is where
 * the next case begins. */
static const validation_row *farthest(const validation *v, size_t i,
                                      size_t *end)
{
    const validation_row *first = &v->row[i], *max = first;
    for (; i < v->rows && is_one_case(&v->row[i], first); ++i) {
        if (against(&v->row[i]) > against(max)) {
            max = &v->row[i];
        }
    }
    *end = i;
    return max;
}

typedef struct verdict {
    size_t rows, off, wrongly_short, unsound; /* rows, twins' only in unsound */
    size_t accepted_twins, twins;             /* cases */
    double rms, farthest;
} verdict;

/* A twin must be farther off than the run's limit, whatever its rows' own. */
static verdict verdict_of(const validation *v)
{
    const double limit = limit_of(v);
    verdict out = {0};
    for (size_t i = 0; i < v->rows; ++i) {
        out.unsound += v->row[i].is_unsound;
    }
    /* A twin counts once for all its rows; other rows count singly. */
    for (size_t i = 0; i < v->rows;) {
        const validation_row *row = &v->row[i];
        if (is_twin(row)) {
            ++out.twins;
            out.accepted_twins += !(against(farthest(v, i, &i)) > limit);
            continue;
        }
        ++i;
        ++out.rows;
        out.off += is_refused(row, limit);
        out.wrongly_short += is_wrongly_short(row);
        if (!row->is_bound) {
            out.rms += against(row) * against(row);
            out.farthest = fmax(out.farthest, against(row));
        }
    }
    out.rms = checks(v) > 0 ? sqrt(out.rms / (double)checks(v)) : 0;
    return out;
}

static const char *form_of(const validation_row *row)
{
    return row->is_quick ? "quick" : "nightly";
}

/* Of all rows, or what says that they differ. */
static const char *form_of_all(const validation *v)
{
    for (size_t i = 1; i < v->rows; ++i) {
        if (v->row[i].is_quick != v->row[0].is_quick) {
            return "nightly and quick";
        }
    }
    return v->rows > 0 ? form_of(&v->row[0])
                       : (v->settings.is_quick ? "quick" : "nightly");
}

static void markdown_row(const validation_row *row, double limit, FILE *out)
{
    const char *bold = is_refused(row, limit) ? "**" : "";
    fprintf(out, "| %s | %s | %s%.7g | %.7g | %.1e%s | %s%+.2f%s", row->name,
            row->quantity, row->is_bound ? "at most " : "", row->reference,
            row->murk.value, row->murk.standard_error,
            is_wrongly_short(row) ? " **short**"
            : row->is_short       ? " *"
                                  : "",
            bold, validation_sigmas(row), bold);
    if (row->sigmas_max > 0) {
        fprintf(out, " (limit %g)", row->sigmas_max);
    }
    fprintf(out, " | %.2e | %s%s |\n", (double)row->photons, row->source,
            row->is_unsound ? " **unsound**" : "");
}

static void markdown_rows(const validation *v, FILE *out)
{
    const validation_row *before = NULL;
    for (size_t i = 0; i < v->rows; ++i) {
        const validation_row *row = &v->row[i];
        if (is_twin(row)) {
            continue;
        }
        if (!before || strcmp(row->group, before->group) != 0 ||
            row->is_quick != before->is_quick) {
            fprintf(out,
                    "\n## %s, %s form\n\n| case | quantity | reference | murk "
                    "| standard error | sigmas off | photons | source |\n"
                    "|---|---|---|---|---|---|---|---|\n",
                    row->group, form_of(row));
        }
        markdown_row(row, limit_of(v), out);
        before = row;
    }
}

static void markdown_twins(const validation *v, FILE *out)
{
    fprintf(out, "\n## Wrong constants, which must be refused\n\n"
                 "| group | form | case | wrong | farthest quantity | "
                 "reference | murk | standard error | sigmas off |\n"
                 "|---|---|---|---|---|---|---|---|---|\n");
    for (size_t i = 0; i < v->rows;) {
        if (!is_twin(&v->row[i])) {
            ++i;
            continue;
        }
        const validation_row *row = farthest(v, i, &i);
        fprintf(out,
                "| %s | %s | %s | %s | %s | %.7g | %.7g | %.1e | %+.1f%s%s "
                "|\n",
                row->group, form_of(row), row->name, row->wrong, row->quantity,
                row->reference, row->murk.value, row->murk.standard_error,
                validation_sigmas(row),
                against(row) > limit_of(v) ? "" : " **not refused**",
                row->is_unsound ? " **unsound**" : "");
    }
}

/* Why photons ended before errors were reached, once a case. */
static void markdown_notes(const validation *v, FILE *out)
{
    const validation_row *before = NULL;
    for (size_t i = 0; i < v->rows; ++i) {
        const validation_row *row = &v->row[i];
        if (row->why_short[0] == '\0' || (before && is_one_case(row, before))) {
            continue;
        }
        if (!before) {
            fprintf(out, "\n## Notes: errors marked *\n\n");
        }
        fprintf(out, "* %s, %s: %s\n", row->group, row->name, row->why_short);
        before = row;
    }
}

void validation_markdown(const validation *v, FILE *out)
{
    const verdict all = verdict_of(v);
    /* How the table was made, and the verdict; then the tables. */
    fprintf(out,
            "# murk against its references, %s form\n\n"
            "Seed %" PRIu32 ". Photons go on until each standard error is at "
            "most 0.1 %% of the reference or 3e-05, in the quick form four "
            "times that (* where a case's photons end before: the quick form "
            "lets that pass, the nightly form for a reason only, see the "
            "notes); errors are by emitted photon. Sigmas off: murk less "
            "reference, over the root of standard error^2 + the reference's "
            "own uncertainty^2 (half a unit of its last digit, and what the "
            "source column adds).\n\n"
            "%zu checks share a %g chance of a false alarm: the limit is %.2f "
            "sigmas (Sidak, two-sided). Bounds, which are not to be exceeded "
            "at all: %zu. Off: %zu. Farthest %.2f, root mean square %.2f. "
            "Errors not reached, without a reason: %zu. Rows of cases that "
            "lost light or whose ledger is off: %zu. Wrong constants: %zu, not "
            "refused: %zu.\n",
            form_of_all(v), v->settings.seed, checks(v), VALIDATION_FALSE_ALARM,
            limit_of(v), all.rows - checks(v), all.off, all.farthest, all.rms,
            all.wrongly_short, all.unsound, all.twins, all.accepted_twins);
    markdown_rows(v, out);
    markdown_twins(v, out);
    markdown_notes(v, out);
}

/* Names, sources and reasons hold no quotes. */
void validation_csv(const validation *v, FILE *out)
{
    fprintf(out, "group,form,seed,case,wrong,quantity,reference,uncertainty,"
                 "murk,standard_error,sigmas_off,sigmas_most,is_bound,is_short,"
                 "why_short,is_unsound,photons,source\n");
    for (size_t i = 0; i < v->rows; ++i) {
        const validation_row *row = &v->row[i];
        fprintf(out,
                "%s,%s,%" PRIu32 ",\"%s\",\"%s\",\"%s\",%.17g,%.9g,%.17g,%.9g,"
                "%.3f,%.9g,%d,%d,\"%s\",%d,%" PRIu64 ",\"%s\"\n",
                row->group, form_of(row), v->settings.seed, row->name,
                row->wrong, row->quantity, row->reference, row->uncertainty,
                row->murk.value, row->murk.standard_error,
                validation_sigmas(row), row->sigmas_max, row->is_bound,
                row->is_short, row->why_short, row->is_unsound, row->photons,
                row->source);
    }
}

bool validation_passed(const validation *v)
{
    const verdict all = verdict_of(v);
    return all.rows > 0 && all.off == 0 && all.wrongly_short == 0 &&
           all.accepted_twins == 0 && all.unsound == 0;
}
