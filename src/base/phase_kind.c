/* The table of the kinds of phase functions, made from the list in the header.
 */
#include "base/phase_kind.h"

#include <stddef.h>

#define ROW(id, name, numbers) [MURK_PHASE_##id] = {name, numbers},
const murk_phase_kind_row murk_phase_kinds[] = {MURK_PHASE_KINDS(ROW){NULL, 0}};
