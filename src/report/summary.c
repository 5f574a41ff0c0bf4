/* The summary of the page: what was asked, the answer with its error and its
 * bound, what it took, and what the words mean. It is text, so that it needs no
 * script. */
#include "report/answers.h"
#include "report/html.h"
#include "report/sections.h"

#include <math.h>
#include <string.h>

/* ---- what it took ---- */

/* "2026-11-21T18:49:26Z" as "2026-11-21, 18:49 UTC"; else as it is. */
static void write_date(FILE *to, const char *date)
{
    char shown[40];
    if (strlen(date) == 20 && date[10] == 'T' && date[19] == 'Z') {
        snprintf(shown, sizeof shown, "%.10s, %.5s UTC", date, date + 11);
        murk_html_text(to, shown);
    } else {
        murk_html_text(to, date);
    }
}

static void write_effort(FILE *to, const murk_yaml *root,
                         const murk_yaml *ledger)
{
    const double seconds = murk_result_number(root, "run.seconds.total");
    const char *date = murk_result_text(root, "run.date");
    const bool is_known = isfinite(murk_result_number(root, "photons.emitted"));
    /* time and memory, photons, who and when */
    fputs("<div><dt>It took</dt><dd>", to);
    murk_html_number(to, seconds < 100 ? round(100 * seconds) / 100
                                       : round(seconds));
    murk_report_say(to, root,
                    " s on {run.threads#thread|threads} and "
                    "{run.peak_memory_bytes*} MB of memory");
    if (is_known || isfinite(murk_result_number(ledger, "photons_emitted"))) {
        murk_report_say(
            to, is_known ? root : ledger,
            is_known
                ? ", for {photons.emitted#photon|photons} that left the lights"
                : ", for {photons_emitted#photon|photons} that left the "
                  "lights");
    }
    murk_report_say(to, root, "; murk {murk.version$}");
    if (date) {
        fputs(", on ", to);
        write_date(to, date);
    }
    fputs(".</dd></div>\n", to);
}

/* ---- words ---- */

typedef struct word {
    const char *name, *meaning;
} word;

static void write_words(FILE *to, const word *words, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        fprintf(to, "<div><dt>%s</dt><dd>%s</dd></div>\n", words[i].name,
                words[i].meaning);
    }
}

static void explain(FILE *to, const murk_results_in *results)
{
    static const word of_all[] = {
        {"photon",
         "A packet of light that is followed from a lamp or the sky. Where it "
         "is reflected by a surface or scattered in a medium (fog, smoke, "
         "water), a record of it is stored: the maps of photons."},
        {"± and 95 % interval",
         "A number after ± is one standard error: what chance in the photons "
         "does to the result. The true value lies within twice that in 19 of "
         "20 cases, which is the 95 % interval."}};
    static const word of_plans[] = {
        {"coverage",
         "The share of the stored light (or of the targets that stand in its "
         "place) that at least one sensor sees, weighed by how clearly. With "
         "weights: balanced, which is the default, it is the mean of two "
         "shares, that of light on surfaces and that of light in media, "
         "however much of the light either is; with weights: {surface: 1, "
         "volume: 1} all light counts by its power."},
        {"in sample, held out",
         "In sample: measured with the photons or targets that the plan was "
         "chosen by, so it reads high. Held out: measured with others. Quote "
         "that one."},
        {"upper bound, gap",
         "No plan with as many sensors covers more than the upper bound, in "
         "sample. The gap is how far the plan is from it, as a share of the "
         "bound: 0 means that the plan is the best there is."},
        {"ceiling", "What all places together would cover: what is beyond "
                    "cannot be seen from anywhere that was allowed."},
        {"it covers, only it covers",
         "What a sensor sees, and what would be lost without it."}};
    static const word of_fits[] = {
        {"residual", "Measured less predicted, in standard errors of the "
                     "reading. One in twenty is beyond ±1.96 by chance."},
        {"chi², degrees of freedom",
         "The sum of squared residuals; and how many readings there are beyond "
         "those that the values take. Both should be about the same."},
        {"correlation",
         "From -1 to 1: how much an error of one value goes along with one of "
         "another. Near ±1 the readings tell only a combination of both."},
        {"held out", "Readings that had no say in the fit, to check it by."}};
    /* the words of each kind of result that is there */
    const bool has_plan =
        results->json[MURK_RESULT_PLAN] || results->json[MURK_RESULT_COVERAGE];
    const bool has_study = results->json[MURK_RESULT_STUDY] != NULL;
    fputs("<details><summary>Words on this page</summary>\n<dl "
          "class=\"facts\">\n",
          to);
    write_words(to, of_all, sizeof of_all / sizeof *of_all);
    if (has_plan || has_study) {
        write_words(to, of_plans, sizeof of_plans / sizeof *of_plans);
    }
    if (results->json[MURK_RESULT_FIT]) {
        write_words(to, of_fits, sizeof of_fits / sizeof *of_fits);
    }
    fputs("</dl>\n</details>\n", to);
}

static void write_one(FILE *to, murk_result_file which, const murk_yaml *root)
{
    switch (which) {
    case MURK_RESULT_PLAN:
    case MURK_RESULT_COVERAGE:
        murk_answer_plan(to, root, which == MURK_RESULT_PLAN);
        break;
    case MURK_RESULT_STUDY:
        murk_answer_study(to, root);
        break;
    case MURK_RESULT_FIT:
        murk_answer_fit(to, root);
        break;
    case MURK_RESULT_LEDGER:
    case MURK_RESULT_FILES:
        murk_answer_light(to, root);
        break;
    }
}

void murk_report_summary(FILE *to, const murk_results_in *results)
{
    size_t n = 0;
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        n += murk_results_is_main(results, (murk_result_file)i);
    }
    fputs("<section id=\"summary\" data-title=\"In short\">\n"
          "<h2>In short</h2>\n",
          to);
    if (!murk_results_are_one_run(results)) {
        fputs("<p>This folder holds files of several runs. The scene, the "
              "light and the tallies are those of the last that wrote them, "
              "and need not be those of the answers here: see how each file "
              "was made.</p>\n",
              to);
    }
    if (results->strangers && *results->strangers) {
        fputs("<p>Not as the run of this page wrote them: ", to);
        murk_html_text(to, results->strangers);
        fputs(". They were edited since, or are of an earlier run, or of one "
              "that was killed while it wrote them.</p>\n",
              to);
    }
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        const murk_yaml *root = results->json[i];
        if (!murk_results_is_main(results, (murk_result_file)i)) {
            continue;
        }
        if (n > 1) {
            fprintf(to, "<h3>%s</h3>\n", murk_result_kinds[i].title);
        }
        fputs("<dl class=\"facts\">\n", to);
        write_one(to, (murk_result_file)i, root);
        /* light of several runs is not told apart */
        write_effort(to, root,
                     n == 1 ? results->json[MURK_RESULT_LEDGER] : NULL);
        fputs("</dl>\n", to);
    }
    explain(to, results);
    fputs("</section>\n", to);
}
