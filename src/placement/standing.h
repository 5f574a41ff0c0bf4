/* What stands of a plan, and who may join it under the rules. */
#ifndef MURK_PLACEMENT_STANDING_H
#define MURK_PLACEMENT_STANDING_H

#include "placement/rules.h"

typedef struct murk_standing {
    const murk_rulebook *book;
    size_t wanted; /* sensors that the plan is to have; with a budget at most */
    uint32_t *member; /* [size], the fixed ones first */
    size_t size;
    size_t *have;   /* [classes] members */
    size_t missing; /* sensors that least counts still ask for */
    uint64_t cost;
} murk_standing;

murk_status murk_standing_init(murk_standing *out, const murk_rulebook *book,
                               murk_error *err);
void murk_standing_release(murk_standing *standing);

/* Nobody stands. wanted is at most the book's most_sensors. */
void murk_standing_clear(murk_standing *standing, size_t wanted);
void murk_standing_add(murk_standing *standing, uint32_t candidate);
void murk_standing_drop_last(murk_standing *standing);

/* Whether the candidate may join, with what least counts ask for still in
 * reach (certainly so where nothing excludes); with is_last, in place. */
bool murk_standing_admits(const murk_standing *standing, uint32_t candidate,
                          bool is_last);

/* Whether all that is asked for stands. */
bool murk_standing_is_plan(const murk_standing *standing);

/* Fills what stands up to a plan, whatever it sees. False when there is none,
 * *is_sure, or when too many were tried. */
bool murk_standing_find_plan(murk_standing *standing, bool *is_sure);

#endif
