/* What the library knows of keys and of itself, for texts that need no scene:
 * help, schema, completion, man pages and --version. */
#ifndef MURK_APP_LOOKUP_H
#define MURK_APP_LOOKUP_H

#include "murk.h"

/* Fields of murk_context_reference(), in a context of their own. */
typedef struct murk_lookup {
    murk_context *context;
    const murk_fields *fields;
} murk_lookup;

/* Looks a name up: "scene", "scene.sensors.count", "version". Fails as
 * murk_context_create() and murk_context_reference(). Call murk_lookup_end()
 * also after a failure. */
murk_status murk_lookup_begin(murk_lookup *out, const char *name,
                              murk_error *err);
void murk_lookup_end(murk_lookup *lookup);

/* The version with the commit, as parts of runs state it. */
murk_status murk_lookup_version(char *out, size_t size, murk_error *err);

#endif
