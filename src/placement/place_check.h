/* What can be wrong with a wish for a plan. */
#ifndef MURK_PLACEMENT_PLACE_CHECK_H
#define MURK_PLACEMENT_PLACE_CHECK_H

#include "placement/place.h"

/* Fails with MURK_BAD_VALUE. */
murk_status murk_place_check(const murk_problem *problem, bool known,
                             const murk_place_desc *desc, murk_error *err);

#endif
