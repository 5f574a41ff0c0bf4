/* Names the JSON and CSV files of results, and describes each by walking over
 * the table of fields that also writes it. */
#include "results/catalogue.h"

#include "results/condition_results.h"
#include "results/explore.h"
#include "results/exports.h"
#include "results/fit.h"
#include "results/follow.h"
#include "results/geo.h"
#include "results/ledger.h"
#include "results/matrix.h"
#include "results/plan.h"
#include "results/sense.h"
#include "results/study.h"
#include "results/tallies.h"

typedef struct result_file {
    const char *name;
    murk_results_list list; /* of a JSON */
    murk_results_item item; /* of a CSV */
} result_file;

static const result_file files[] = {
    {"Every JSON", .list = murk_results_list_every},
    {"plan.json", .list = murk_results_list_plan},
    {"Matrix: plan.json", .list = murk_results_list_matrix_plan},
    {"coverage.json", .list = murk_results_list_sense},
    {"ledger.json", .list = murk_results_list_ledger},
    {"study.json", .list = murk_results_list_study},
    {"fit.json", .list = murk_results_list_fit},
    {"follow.json", .list = murk_results_list_follow},
    {"sensors.csv", .item = murk_results_list_place},
    {"coverage.csv", .item = murk_results_list_sensor},
    {"sensors_geo.csv", .item = murk_results_list_geo},
    {"tallies.csv", .item = murk_results_list_tally},
    {"explore.csv", .item = murk_results_list_step},
    {"repeat.csv", .item = murk_results_list_run},
    {"regret.csv", .item = murk_results_list_use},
    {"candidates.csv", .item = murk_results_list_candidate},
    {"fit.csv", .item = murk_results_list_fit_row},
    {"follow.csv", .item = murk_results_list_follow_row},
    {"moves.csv", .item = murk_results_list_move}};

void murk_results_catalogue(FILE *to)
{
    for (size_t i = 0; i < sizeof files / sizeof *files; ++i) {
        fprintf(to, "## %s\n\n| %s | what |\n| --- | --- |\n", files[i].name,
                files[i].list ? "key" : "column");
        if (files[i].list) {
            murk_results_describe(to, files[i].list);
        } else {
            murk_results_describe_csv(to, files[i].item);
        }
        fputc('\n', to);
    }
}
