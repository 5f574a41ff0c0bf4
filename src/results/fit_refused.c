/* Recognises the values of a refused fit by the verdict that calibrated.yaml
 * carries in a comment: other keys would be set in the scene. */
#include "results/fit_refused.h"

#include "base/log.h"

#include <string.h>

bool murk_fit_refused_values(const char *text)
{
    static const char refusal[] = MURK_CALIBRATED_VERDICT MURK_VERDICT_REFUSED;
    const size_t length = sizeof refusal - 1;
    const char *line = text;
    while (line && strncmp(line, refusal, length) != 0) {
        line = strchr(line, '\n');
        line = line ? line + 1 : NULL;
    }
    return line != NULL;
}

void murk_fit_warn_refused(const char *file)
{
    murk_message("warning: ", file,
                 "of a fit whose model the data refuse, so its values are not "
                 "to be used");
}
