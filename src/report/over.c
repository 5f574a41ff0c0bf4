/* A plan over conditions, in the report: what it sees in each, and what plans
 * made for one of them see in the others. */
#include "report/html.h"
#include "report/plan.h"

#include <math.h>

#define HEADS_MAX (CONDITIONS_MAX + 3) /* and the columns that all have */

#define CONDITIONS_MAX 24 /* columns of the table */

/* A regret of a quarter has the deepest shade. */
#define REGRET_SHADE 4

static void write_conditions(FILE *to, const murk_yaml *list, size_t n)
{
    static const char *const heads[] = {
        "condition", "weight",    "photons emitted", "stored on surfaces",
        "in media",  "in sample", "held out"};
    murk_page_table_begin(to, "The plan in each condition", heads, 7);
    for (size_t i = 0; i < n && i < MURK_PAGE_ROWS_MAX; ++i) {
        const murk_yaml *row = list->child[i];
        murk_page_row_begin(to, murk_result_text(row, "name"));
        murk_page_cell_number(to, murk_result_number(row, "weight"));
        murk_page_cell_number(to, murk_result_number(row, "photons.emitted"));
        murk_page_cell_number(to, murk_result_number(row, "photons.surface"));
        murk_page_cell_number(to, murk_result_number(row, "photons.volume"));
        murk_page_cell_share(
            to, murk_result_number(row, "in_sample"),
            murk_result_number(row, "in_sample_standard_error"));
        murk_page_cell_share(
            to, murk_result_number(row, "held_out"),
            murk_result_number(row, "held_out_standard_error"));
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
    murk_page_more(to, n, "plan.json");
}

static double item_of(const murk_yaml *plan, const char *key, size_t i)
{
    return i < murk_result_count(plan, key)
               ? murk_result_number(murk_result_at(plan, key)->child[i], "")
               : NAN;
}

/* Dark conditions, which come last, are no columns. */
static size_t lit_of(const murk_yaml *plans, size_t n)
{
    size_t max = 0;
    for (size_t i = 0; i < n; ++i) {
        const size_t has = murk_result_count(plans->child[i], "coverage");
        max = has > max ? has : max;
    }
    return max < CONDITIONS_MAX ? max : CONDITIONS_MAX;
}

static void write_regret(FILE *to, const murk_yaml *plan)
{
    const char *heads[HEADS_MAX] = {"made for"};
    const murk_yaml *list = murk_result_at(plan, "conditions");
    const murk_yaml *plans = murk_result_at(plan, "regret.plans");
    const size_t n = murk_result_count(plan, "regret.plans");
    const size_t named = murk_result_count(plan, "conditions");
    const size_t lit = n > 0 ? lit_of(plans, n) : 0;
    const size_t columns = lit < named ? lit : named;
    if (columns == 0) {
        return;
    }
    for (size_t c = 0; c < columns; ++c) {
        const char *name = murk_result_text(list->child[c], "name");
        heads[c + 1] = name ? name : "";
    }
    heads[columns + 1] = "mean";
    heads[columns + 2] = "worst";
    fputs("<h4>Plans made for one condition, used in another</h4>\n", to);
    murk_page_paragraph(
        to, "Each row is a plan, each column a condition; shown is what the "
            "plan covers there. The deeper the shade, the more the plan that "
            "was made for this condition covers beyond it (its regret).");
    murk_page_table_begin(to, "Coverage by plan and condition", heads,
                          columns + 3);
    for (size_t i = 0; i < n && i < MURK_PAGE_ROWS_MAX; ++i) {
        const murk_yaml *one = plans->child[i];
        murk_page_row_begin(to, murk_result_text(one, "made_for"));
        for (size_t c = 0; c < columns; ++c) {
            murk_page_shaded_begin(to,
                                   -REGRET_SHADE * item_of(one, "regret", c));
            murk_page_share(to, item_of(one, "coverage", c),
                            item_of(one, "standard_error", c));
            murk_page_shaded_end(to);
        }
        murk_page_cell_share(to, murk_result_number(one, "mean"),
                             murk_result_number(one, "mean_standard_error"));
        murk_page_cell_share(to, murk_result_number(one, "worst"),
                             murk_result_number(one, "worst_standard_error"));
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
}

bool murk_report_over(FILE *to, const murk_yaml *plan)
{
    const size_t n = murk_result_count(plan, "conditions");
    if (n > 0) {
        fputs("<h3>Conditions</h3>\n", to);
        write_conditions(to, murk_result_at(plan, "conditions"), n);
        write_regret(to, plan);
    }
    return true;
}
