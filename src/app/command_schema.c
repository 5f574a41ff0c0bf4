/* murk schema: prints the JSON Schema of murk_context_reference(). */
#include "app/options.h"
#include "base/print.h"

murk_status murk_command_schema(const murk_options *options, murk_error *err)
{
    const murk_fields *fields = NULL;
    if (options->input) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "schema: takes no file, %s is given", options->input);
    }
    const murk_status status =
        murk_context_reference(options->context, "schema", &fields, err);
    if (!status) {
        murk_print_json(murk_fields_json(fields));
    }
    return status;
}
