/* The summary of the page: the lines of the summary of each run, which are
 * run.summary of its main JSON, and the meanings of words. It is text, which
 * needs no script. A line of a summary begins with a label, or with blanks if
 * it belongs to the label above. Such lines may be rows of tables, so the text
 * of all lines of a label keeps its columns. */
#include "report/html.h"
#include "report/sections.h"

#include <ctype.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Width of a label with the blanks after it (results/summary.h). */
#define LABEL 12

/* ---- lines ---- */

/* The length of the label at the beginning of a line: it ends before two
 * blanks, or at LABEL bytes. 0: the line does not begin with a letter, so it
 * has no label. */
static size_t label_length(const char *line)
{
    const char *gap = strstr(line, "  ");
    const size_t length = gap ? (size_t)(gap - line) : strlen(line);
    return !isalpha((unsigned char)*line) ? 0 : length < LABEL ? length : LABEL;
}

/* The column at which the text of a line begins, after the label. */
static size_t column_of(const char *line)
{
    const size_t label = label_length(line);
    return label + strspn(line + label, " ");
}

/* Writes lines i .. end - 1, which belong to one label: the label, then their
 * text from the first column in which any line has text. If any text has two
 * blanks between words, it is a table, whose lines are not broken. */
static void write_item(FILE *to, const char *const *line, size_t i, size_t end)
{
    const size_t label = label_length(line[i]);
    size_t first = SIZE_MAX;
    bool is_table = false;
    for (size_t k = i; k < end; ++k) {
        const size_t column = column_of(line[k]);
        first = column < first ? column : first;
        is_table |= strstr(line[k] + column, "  ") != NULL;
    }
    char name[LABEL + 1];
    snprintf(name, sizeof name, "%.*s", (int)label, line[i]);
    fputs("<div><dt>", to);
    murk_html_text(to, name);
    fputs(is_table ? "</dt><dd class=\"columns\" tabindex=\"0\">" : "</dt><dd>",
          to);
    for (size_t k = i; k < end; ++k) {
        const size_t column = column_of(line[k]);
        fprintf(to, "%s%*s", k > i ? "\n" : "", (int)(column - first), "");
        murk_html_text(to, line[k] + column);
    }
    fputs("</dd></div>\n", to);
}

/* Writes the summary that a main JSON has; a sentence if it has none. */
static void write_lines(FILE *to, const murk_yaml *root, const char *file)
{
    const murk_yaml *list = murk_result_at(root, "run.summary");
    const size_t n = murk_result_count(root, "run.summary");
    const char **line = calloc(n + 1, sizeof *line);
    size_t lines = 0;
    for (size_t i = 0; line && i < n; ++i) {
        const char *text = murk_result_text(list->child[i], "");
        if (text) {
            line[lines++] = text;
        }
    }
    if (lines == 0) {
        fprintf(to,
                "<p>%s holds no summary of its run: the sections below say "
                "what is in it.</p>\n",
                file);
        free(line);
        return;
    }
    /* An item for each label. */
    fputs("<dl class=\"facts lines\">\n", to);
    for (size_t i = 0, end; i < lines; i = end) {
        for (end = i + 1; end < lines && label_length(line[end]) == 0;) {
            ++end;
        }
        write_item(to, line, i, end);
    }
    fputs("</dl>\n", to);
    free(line);
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
        {"± or +-, 95 % interval",
         "A number after ± or +- is one standard error: what chance in the "
         "photons "
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
    static const word of_steps[] = {
        {"step",
         "A time at which the scene is looked at. The search for a plan "
         "begins at the plan of the step before, so that sensors stay "
         "unless another place is better; with the method greedy each "
         "step begins anew."},
        {"taken over", "Photons and sightlines of the step before that nothing "
                       "in the scene has changed. They are not computed again; "
                       "the results are the same as if they were."}};
    static const word of_readings[] = {
        {"residual", "Measured less predicted, in standard errors of the "
                     "reading. One in twenty is beyond ±1.96 by chance."}};
    static const word of_fits[] = {
        {"chi², degrees of freedom",
         "The sum of squared residuals; and how many readings there are beyond "
         "those that the values take. Both should be about the same."},
        {"correlation",
         "From -1 to 1: how much an error of one value goes along with one of "
         "another. Near ±1 the readings tell only a combination of both."},
        {"held out", "Readings that had no say in the fit, to check it by."}};
    /* the words that results in the folder use */
    const bool has_plan =
        results->json[MURK_RESULT_PLAN] || results->json[MURK_RESULT_COVERAGE];
    const bool has_study = results->json[MURK_RESULT_STUDY] != NULL;
    const bool has_steps = results->json[MURK_RESULT_FOLLOW] != NULL;
    fputs("<details><summary>Words on this page</summary>\n<dl "
          "class=\"facts\">\n",
          to);
    write_words(to, of_all, sizeof of_all / sizeof *of_all);
    if (has_plan || has_study || has_steps) {
        write_words(to, of_plans, sizeof of_plans / sizeof *of_plans);
    }
    if (has_steps) {
        write_words(to, of_steps, sizeof of_steps / sizeof *of_steps);
    }
    if (murk_results_has_readings(results)) {
        write_words(to, of_readings, sizeof of_readings / sizeof *of_readings);
    }
    if (results->json[MURK_RESULT_FIT]) {
        write_words(to, of_fits, sizeof of_fits / sizeof *of_fits);
    }
    fputs("</dl>\n</details>\n", to);
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
    /* Folders that hold more than the files of one run. */
    if (!murk_results_are_one_run(results)) {
        fputs("<p>This folder holds files of several runs. The scene, the "
              "light and the tallies are those of the last that wrote them, "
              "and need not be those of the results here: see how each file "
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
    /* The summary of each run, and the words. */
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        if (!murk_results_is_main(results, (murk_result_file)i)) {
            continue;
        }
        if (n > 1) {
            fprintf(to, "<h3>%s</h3>\n", murk_result_kinds[i].title);
        }
        write_lines(to, results->json[i], murk_result_kinds[i].file);
    }
    explain(to, results);
    fputs("</section>\n", to);
}
