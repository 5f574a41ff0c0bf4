/* SPOQ starts, each followed by relocation. Several run at once, with the same
 * result as one after the other: each thread makes a start of its own, or, with
 * rows of clarities, several starts share each pass over the rows
 * (placement/lanes.h). */
#ifndef MURK_PLACEMENT_STARTS_H
#define MURK_PLACEMENT_STARTS_H

#include "placement/lanes.h"
#include "placement/search.h"

typedef struct murk_starts {
    murk_gain_scan *search; /* [searches] */
    unsigned searches;      /* starts that are made at the same time */
    bool has_lanes;         /* the searches share each pass over the rows */
    murk_lanes lanes;
    size_t wave_max; /* starts made before the first of them is accepted */
    size_t count;    /* maximum number of sensors of a plan */
    uint32_t *plan;  /* [wave_max][count] */
    struct murk_start *start; /* [wave_max] */
    size_t n;                 /* sensors wanted by the present call */
    uint32_t seed;
    uint64_t first; /* number of the first start of the wave */
    uint64_t all_evaluations, all_queries; /* of all starts accepted so far */
    uint64_t all_rows; /* rows of all starts accepted so far; beyond the limit
                          on work no start is made */
    bool is_cut;       /* the limit on work ended the starts */
    murk_arena arena;
} murk_starts;

/* For plans of at most `count` sensors. Call murk_starts_release() also after a
 * failure. */
murk_status murk_starts_init(murk_starts *out, const murk_evaluator *evaluator,
                             size_t count, uint32_t seed, murk_error *err);
void murk_starts_release(murk_starts *starts);

/* Makes the starts 0..max-1 in order for plans of n sensors, and keeps a plan
 * that is strictly better than plan[*size] with value `value`. Stops after
 * MURK_STARTS_WITHOUT_GAIN starts in a row without gain, when the value reaches
 * `upper`, when the limit on work is spent, or if asked to finish or to stop;
 * starts that have begun then count as they are. `search` has the
 * fallback plan for random starts that constraints stop early. Returns the best
 * value; *made grows by the number of starts. */
uint64_t murk_starts_try(murk_starts *starts, const murk_gain_scan *search,
                         uint32_t *plan, size_t *size, size_t n, uint64_t value,
                         uint64_t upper, size_t max, size_t *made);

#endif
