/* The functions behind laws.c; inside this room only. What each takes and
 * where it comes from is said in its own file. */
#ifndef MURK_PRESET_LAWS_H
#define MURK_PRESET_LAWS_H

#include "preset/law.h"

/* visibility.c */
murk_status murk_law_kruse(murk_optics *, const murk_law_call *, murk_error *);
murk_status murk_law_kim(murk_optics *, const murk_law_call *, murk_error *);

#endif
