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

static size_t checks(const validation *v)
{
    size_t n = 0;
    for (size_t i = 0; i < v->rows; ++i) {
        n += !is_twin(&v->row[i]);
    }
    return n;
}

static double limit_of(const validation *v)
{
    const size_t n = checks(v);
    return murk_sidak_limit(VALIDATION_FALSE_ALARM, n > 0 ? (double)n : 1);
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
    const validation_row *first = &v->row[i], *most = first;
    for (; i < v->rows && is_one_case(&v->row[i], first); ++i) {
        if (fabs(validation_sigmas(&v->row[i])) >
            fabs(validation_sigmas(most))) {
            most = &v->row[i];
        }
    }
    *end = i;
    return most;
}

typedef struct verdict {
    size_t off, accepted_twins, twins;
    double rms, farthest;
} verdict;

static verdict verdict_of(const validation *v)
{
    const double limit = limit_of(v);
    verdict out = {0};
    for (size_t i = 0; i < v->rows;) {
        if (is_twin(&v->row[i])) {
            const double off = validation_sigmas(farthest(v, i, &i));
            ++out.twins;
            out.accepted_twins += !(fabs(off) > limit);
            continue;
        }
        const double off = validation_sigmas(&v->row[i++]);
        out.off += !(fabs(off) <= limit);
        out.rms += off * off;
        out.farthest = fmax(out.farthest, fabs(off));
    }
    out.rms = sqrt(out.rms / (double)checks(v));
    return out;
}

static void markdown_rows(const validation *v, FILE *out)
{
    const double limit = limit_of(v);
    const char *group = "";
    for (size_t i = 0; i < v->rows; ++i) {
        const validation_row *row = &v->row[i];
        if (is_twin(row)) {
            continue;
        }
        if (strcmp(row->group, group) != 0) {
            group = row->group;
            fprintf(out,
                    "\n## %s\n\n| case | quantity | reference | murk | "
                    "standard error | sigmas off | photons | source |\n"
                    "|---|---|---|---|---|---|---|---|\n",
                    group);
        }
        const double off = validation_sigmas(row);
        const char *mark = fabs(off) <= limit ? "" : "**";
        fprintf(out,
                "| %s | %s | %.7g | %.7g | %.1e%s | %s%+.2f%s | %.2e | %s "
                "|\n",
                row->name, row->quantity, row->reference, row->murk.value,
                row->murk.standard_error, row->is_short ? " *" : "", mark, off,
                mark, (double)row->photons, row->source);
    }
}

static void markdown_twins(const validation *v, FILE *out)
{
    fprintf(out, "\n## Wrong constants, which must be refused\n\n"
                 "| group | case | wrong | farthest quantity | reference | "
                 "murk | standard error | sigmas off |\n"
                 "|---|---|---|---|---|---|---|---|\n");
    for (size_t i = 0; i < v->rows;) {
        if (!is_twin(&v->row[i])) {
            ++i;
            continue;
        }
        const validation_row *row = farthest(v, i, &i);
        const double off = validation_sigmas(row);
        fprintf(out, "| %s | %s | %s | %s | %.7g | %.7g | %.1e | %+.1f%s |\n",
                row->group, row->name, row->wrong, row->quantity,
                row->reference, row->murk.value, row->murk.standard_error, off,
                fabs(off) > limit_of(v) ? "" : " **not refused**");
    }
}

void validation_markdown(const validation *v, FILE *out)
{
    const verdict all = verdict_of(v);
    const int factor = validation_is_quick(v) ? 3 : 1;
    fprintf(out,
            "# murk against its references, %s form\n\n"
            "Seed %" PRIu32 ". Photons go on until each standard error is at "
            "most %.1f %% of the reference or %.0e (* where a case's photons "
            "end before); errors are by emitted photon. Sigmas off: murk less "
            "reference, over the root of standard error^2 + the reference's "
            "own uncertainty^2 (half a unit of its last digit, and what the "
            "source column adds).\n\n"
            "%zu checks share a %g chance of a false alarm: the limit is %.2f "
            "sigmas (Sidak, two-sided). Off: %zu. Farthest %.2f, root mean "
            "square %.2f. Wrong constants: %zu, not refused: %zu.\n",
            factor == 3 ? "quick" : "nightly", v->settings.seed, .1 * factor,
            3e-5 * factor, checks(v), VALIDATION_FALSE_ALARM, limit_of(v),
            all.off, all.farthest, all.rms, all.twins, all.accepted_twins);
    markdown_rows(v, out);
    markdown_twins(v, out);
}

/* Names and sources hold no quotes. */
void validation_csv(const validation *v, FILE *out)
{
    fprintf(out, "group,case,wrong,quantity,reference,uncertainty,murk,"
                 "standard_error,is_short,sigmas_off,photons,source\n");
    for (size_t i = 0; i < v->rows; ++i) {
        const validation_row *row = &v->row[i];
        fprintf(out,
                "%s,\"%s\",\"%s\",\"%s\",%.17g,%.9g,%.17g,%.9g,%d,%.3f,%" PRIu64
                ",\"%s\"\n",
                row->group, row->name, row->wrong, row->quantity,
                row->reference, row->uncertainty, row->murk.value,
                row->murk.standard_error, row->is_short, validation_sigmas(row),
                row->photons, row->source);
    }
}

bool validation_passed(const validation *v)
{
    const verdict all = verdict_of(v);
    return checks(v) > 0 && all.off == 0 && all.accepted_twins == 0 &&
           v->unsound == 0;
}
