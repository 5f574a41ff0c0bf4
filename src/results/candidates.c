#include "results/candidates.h"

#include "results/summary.h"

#include <stdio.h>

cJSON *murk_json_candidates(cJSON *root, const murk_candidates *c)
{
    cJSON *object = cJSON_AddObjectToObject(root, "candidates");
    cJSON_AddNumberToObject(object, "asked", (double)c->asked);
    cJSON_AddNumberToObject(object, "usable", (double)c->usable);
    cJSON_AddNumberToObject(object, "doubtful", (double)c->doubtful);
    cJSON_AddNumberToObject(object, "unreached", (double)c->unreached);
    cJSON_AddNumberToObject(object, "too_close", (double)c->too_close);
    cJSON_AddNumberToObject(object, "forbidden", (double)c->forbidden);
    cJSON_AddNumberToObject(object, "duplicates", (double)c->duplicates);
    return object;
}

void murk_print_candidates(const murk_candidates *c)
{
    murk_print(
        "candidates  %zu asked, %zu usable: %zu not reached from a light, "
        "%zu too close, ",
        c->asked, c->usable, c->unreached, c->too_close);
    if (c->forbidden + c->duplicates > 0) {
        murk_print("%zu forbidden by zones, %zu duplicates, ", c->forbidden,
                   c->duplicates);
    }
    murk_print("%zu doubtful\n", c->doubtful);
}
