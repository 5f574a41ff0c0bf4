/* Makes a context of one thread, which starts none, and asks it. */
#include "app/lookup.h"

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
