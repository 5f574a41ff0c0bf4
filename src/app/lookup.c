/* Makes a context of one thread, which starts none, and asks it. */
#include "app/lookup.h"

#include "app/field.h"

#include <stdio.h>

murk_status murk_lookup_begin(murk_lookup *out, const char *name,
                              murk_error *err)
{
    const murk_context_options options = {.size = sizeof options, .threads = 1};
    *out = (murk_lookup){.context = NULL};
    const murk_status status =
        murk_context_create(&out->context, &options, err);
    return status
               ? status
               : murk_context_reference(out->context, name, &out->fields, err);
}

void murk_lookup_end(murk_lookup *lookup)
{
    murk_context_destroy(lookup->context);
    *lookup = (murk_lookup){.context = NULL};
}

murk_status murk_lookup_version(char *out, size_t size, murk_error *err)
{
    murk_lookup lookup;
    const murk_status status = murk_lookup_begin(&lookup, "version", err);
    if (!status) {
        snprintf(out, size, "%s %s", murk_version(),
                 murk_field_text(lookup.fields, "commit"));
    }
    murk_lookup_end(&lookup);
    return status;
}
