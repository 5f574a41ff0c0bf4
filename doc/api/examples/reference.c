/* The values, the unit and the default of a key of a scene. */
#include "example.h"

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    const murk_fields *fields = NULL;
    const char *value = NULL, *unit = NULL;
    must(murk_context_create(&context, NULL, &error), &error);
    must(murk_context_reference(context, "scene.media.fog.extinction_per_m",
                                &fields, &error),
         &error);
    must(murk_fields_string(fields, "rows.0.value", &value, &error), &error);
    must(murk_fields_string(fields, "rows.0.unit", &unit, &error), &error);
    printf("%s [%s]\n", value, unit);
    /* A misspelled key. */
    murk_error why = MURK_ERROR_NONE;
    (void)murk_context_reference(context, "scene.media.fog.albdeo", &fields,
                                 &why);
    printf("%s: %s\n", why.where, why.text);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * a number, 0..1e9 1/m, or a list of them, one a band [1/m]
 * media.fog.albdeo: no such key, did you mean media.fog.albedo?
 */
