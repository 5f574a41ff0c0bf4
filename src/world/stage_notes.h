/* What a user should know of a stage, though it stops nothing: what is cut off
 * by the domain, what is dark. */
#ifndef MURK_WORLD_STAGE_NOTES_H
#define MURK_WORLD_STAGE_NOTES_H

#include "world/stage.h"

/* Warns and notes, once all is built. */
void murk_stage_tell(const murk_stage *stage);

#endif
