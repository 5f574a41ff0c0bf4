#include "app/session.h"
#include "app/tallies_out.h"

murk_status murk_command_trace(const murk_options *options, murk_error *err)
{
    murk_session session;
    murk_status status = murk_session_begin(&session, options, err);
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
        status = murk_session_finish(&session, "ledger.json",
                                     murk_session_ledger(&session), err);
    }
    if (!status && murk_session_speaks(&session)) {
        murk_print_light(&session);
        murk_print_tallies(&session);
        printf("time        %.2f s: load %.2f, trace %.2f, maps %.2f\n",
               session.run.total_s, session.run.load_s, session.run.trace_s,
               session.run.map_s);
        murk_print_files(&session);
    }
    murk_session_end(&session);
    return status;
}
