/* A JSON Schema of scene and study files, for editors. */
#ifndef MURK_REFERENCE_SCHEMA_H
#define MURK_REFERENCE_SCHEMA_H

#include "results/json.h"

/* The schema, which the caller deletes. Without memory, parts may be
 * missing. */
cJSON *murk_reference_schema(void);

#endif
