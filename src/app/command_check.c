/* murk check: reads and builds a scene, and reports surfaces, media, lights,
 * candidates, sensors, cameras, doubtful points and the memory that a run
 * takes. */
#include "app/session.h"
#include "overview/overview.h"

#include <string.h>

/* Fails with the message of the overview, in which "a picture" becomes the
 * option of the program. */
static murk_status refuse(const murk_error *why, murk_error *err)
{
    static const char of_library[] = "goes with a picture";
    const char *at = strstr(why->text, of_library);
    return at ? murk_fail(err, why->code, why->where,
                          "goes with --picture FILE.png%s",
                          at + strlen(of_library))
              : murk_fail(err, why->code, why->where, "%s", why->text);
}

murk_status murk_command_check(const murk_options *options, murk_error *err)
{
    murk_session session;
    murk_overview overview = {0};
    murk_error why = {0};
    const murk_section_file picture = {
        .path = murk_option_text(options, "--picture"),
        .cut_m = options->section.has_cut ? options->section.cut_m : NULL,
        .pixels = {options->render.pixels[0], options->render.pixels[1]}};
    murk_status status = murk_session_begin(&session, options, err);
    if (!status && murk_overview_make(&overview, &session, &picture, &why)) {
        status = refuse(&why, err);
    }
    /* The report as JSON or as text. */
    if (!status && options->json) {
        status = murk_session_finish(
            &session, NULL, murk_overview_json(&overview), NULL, NULL, err);
    } else if (!status && murk_session_speaks(&session)) {
        murk_overview_print(&overview);
    }
    murk_overview_release(&overview);
    murk_session_end(&session);
    return status;
}
