/* murk trace: traces the light of a scene and writes the maps, the ledger and
 * the tallies. */
#include "app/session.h"
#include "results/exports.h"
#include "results/tallies.h"

murk_status murk_command_trace(const murk_options *options, murk_error *err)
{
    murk_session session;
    murk_error late = {0};
    murk_status status = murk_session_begin(&session, options, err);
    if (!status) {
        status = murk_exports_begin(&session, err);
    }
    if (!status) {
        static const char *const names[] = {NULL};
        status = murk_session_expect(&session, names, err);
        status = status ? status : murk_session_expect_light(&session, err);
    }
    if (!status) {
        status = murk_session_light(&session, err);
    }
    if (!status) {
        status = murk_session_add_light(&session, err);
    }
    if (!status) {
        status = murk_add_tallies(&session, err);
    }
    if (!status) {
        murk_exports_add_scene(&session, NULL, NULL, 0, &late);
    }
    if (!status) {
        status = murk_session_finish(
            &session, "ledger.json",
            murk_results_json(
                murk_results_list_ledger,
                &(murk_ledger_results){session.traced, session.stage}),
            murk_print_trace, &session, err);
    }
    if (!status) {
        murk_print_run(&session, NULL, 0);
    }
    if (!status) { /* the light is written, what is told late is not */
        status = murk_fail(err, late.code, late.where, "%s", late.text);
    }
    murk_session_end(&session);
    return status;
}
