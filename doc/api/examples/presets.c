/* The extinction of a fog by a preset, at a visibility of 200 m. */
#include "example.h"

int main(void)
{
    static const char *const key[] = {"visibility_m", "bands_nm"};
    static const char *const value[] = {"200", "[550]"};
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    const murk_fields *fields = NULL;
    double extinction_per_m = 0;
    must(murk_context_create(&context, NULL, &error), &error);
    must(murk_context_preset(context, NULL, NULL, NULL, 0, NULL, &fields,
                             &error),
         &error);
    printf("fog and more: %s\n",
           murk_fields_length(fields, "presets") > 10 ? "yes" : "no");
    must(murk_context_preset(context, "fog/kruse", key, value, 2, NULL, &fields,
                             &error),
         &error);
    must(murk_fields_double(fields, "bands.0.extinction_per_m",
                            &extinction_per_m, &error),
         &error);
    printf("%.4f per m\n", extinction_per_m);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * fog and more: yes
 * 0.0196 per m
 */
