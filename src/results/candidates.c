/* Numbers of candidates by outcome, as fields of JSON and as a line of the
 * summary. */
#include "results/candidates.h"

#include "results/summary.h"

#include <stdio.h>

void murk_results_list_candidates(murk_results_fields *f, const void *of)
{
    const murk_candidates *c = of;
    MURK_COUNT(f, "asked", "places", c->asked);
    MURK_COUNT(f, "usable", "places in free space", c->usable);
    MURK_COUNT(f, "doubtful",
               "places whose reach is decided by less than rounding",
               c->doubtful);
    MURK_COUNT(f, "unreached", "places not reached from a light", c->unreached);
    MURK_COUNT(f, "too_close", "places too close to a surface", c->too_close);
    MURK_COUNT(f, "forbidden", "places in forbidden zones", c->forbidden);
    MURK_COUNT(f, "duplicates", "places listed before", c->duplicates);
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
