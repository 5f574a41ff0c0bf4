/* Listed sites, free or mounted, and the test which of them are usable.
 * For use inside src/sensing only. */
#ifndef MURK_SENSING_LISTED_H
#define MURK_SENSING_LISTED_H

#include "sensing/reach.h"

typedef enum murk_verdict {
    MURK_SITE_USABLE,
    MURK_SITE_DOUBTFUL, /* usable, but nearer to a surface than twice
                           murk_path_surface_tolerance_m() */
    MURK_SITE_DUPLICATE,
    MURK_SITE_FORBIDDEN,
    MURK_SITE_TOO_CLOSE,
    MURK_SITE_UNREACHED,
    MURK_SITE_BARELY_UNREACHED, /* grid points only: unreached, although a
                                   diagonal step from a reached point is open */
    MURK_SITE_VERDICTS
} murk_verdict;

typedef struct murk_listed {
    murk_vec3 position;
    murk_vec3 normal; /* out of the surface; zero: a free site */
    double offset_m;  /* from the mounting point */
} murk_listed;

/* Lists the points, then the mounts, in the order that sensing/candidates.h
 * states, and counts them in *n. The caller frees *out. Fails with
 * MURK_NO_MEMORY at `where`. A mount that leaves a periodic domain through a
 * side enters through the opposite side. */
murk_status murk_listed_all(murk_listed **out, size_t *n,
                            const murk_candidate_desc *desc,
                            const murk_domain *domain, const char *where,
                            murk_error *err);

/* Fills verdict[n] for sites[n], n may be 0. `space` is the free space of
 * desc->grid. Fails with MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_listed_judge(uint8_t *verdict, const murk_listed *sites,
                              size_t n, const murk_candidate_desc *desc,
                              const murk_free_space *space, unsigned threads,
                              murk_error *err);

#endif
