/* What several sensors see of each photon together, as plans count it
 * (placement/problem.h). */
#ifndef MURK_SENSING_VIEWS_H
#define MURK_SENSING_VIEWS_H

#include "placement/dose.h"

typedef struct murk_views {
    size_t photons, layers; /* views of a photon that count */
    uint32_t *sensors;      /* [photons] that see it at all */
    uint16_t *clarity;      /* [photons][layers + 1] the clearest, falling */
    uint32_t *clearest;     /* [photons][layers] whose */
    /* Independent chances, in place of both. */
    uint64_t *dose; /* [photons] */
    murk_doses *doses;
} murk_views;

/* Nobody looks yet. False when out of memory; release it also then. */
bool murk_views_init(murk_views *out, size_t photons, murk_combining combining,
                     size_t layers);
void murk_views_release(murk_views *views);

/* One sensor more, in rising number: of equals the first is the clearest. */
void murk_views_add(murk_views *views, uint32_t sensor,
                    const murk_sparse_row *row);

/* What is seen of photon i, 0 .. layers * MURK_CLEAR. */
uint32_t murk_views_worth(const murk_views *views, size_t i);

/* Once all are added: only[sensor] += what all see less what all but it do,
 * times weight. Clearest views alone. */
void murk_views_only(const murk_views *views, const uint32_t *weight,
                     uint64_t *only);

/* The same of one sensor whose look this is; independent chances alone. */
uint64_t murk_views_only_of(const murk_views *views, const uint32_t *weight,
                            const murk_sparse_row *row);

#endif
