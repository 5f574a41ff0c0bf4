/* What a plan is worth at least, by theorem.
 *
 * Greedy under rules is greedy over sets that are k-extendible: k is 1 for
 * counts, caps and least counts together (a matroid), 1 more for one sensor a
 * site, 12 more for a spacing (at most 12 sensors that keep it lie closer than
 * that to one place: the kissing number); a plain count is in these already.
 * All of it needs that a plan's worth is submodular, as every way of combining
 * views is; where they are independent chances, up to rounding: 2 / 65535 of
 * what is seen.
 *
 * Source: Nemhauser, Wolsey, Fisher, Math. Program. 14 (1978) 265,
 * doi:10.1007/BF01588971 (count); Calinescu, Chekuri, Pal, Vondrak, SIAM J.
 * Comput. 40 (2011) 1740, doi:10.1137/080733991 (1 / (k + 1)); Tang, Tang, Lim,
 * Han, Li, Yuan, Proc. ACM Meas. Anal. Comput. Syst. 5 (2021) 8,
 * doi:10.1145/3447386 (budget). */
#ifndef MURK_PLACEMENT_GUARANTEE_H
#define MURK_PLACEMENT_GUARANTEE_H

#include "placement/constraints.h"

/* Static text, for a plan that is at least greedy's; book NULL: no rules but a
 * count. "none" where nothing is known. */
const char *murk_guarantee(const murk_rulebook *book);

#endif
