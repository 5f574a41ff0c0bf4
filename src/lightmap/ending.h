/* Checks, with a few photons, that the light of a scene ends by absorption or
 * escape, before many photons are traced. */
#ifndef MURK_LIGHTMAP_ENDING_H
#define MURK_LIGHTMAP_ENDING_H

#include "world/stage.h"

/* Traces the first photons of each band. Fails with MURK_BAD_VALUE if all
 * photons of a band were lost because they exceeded the limits on events or on
 * wraps through periodic sides: such a scene would be refused for lost photons
 * (murk_emission_check_losses()) after hours of tracing. */
murk_status murk_ending_check(const murk_stage *stage, uint32_t stream,
                              murk_error *err);

#endif
