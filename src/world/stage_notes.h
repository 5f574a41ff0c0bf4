/* Warnings and notes about a stage that do not stop a run: items that the
 * domain cuts off, light sources that do not emit. */
#ifndef MURK_WORLD_STAGE_NOTES_H
#define MURK_WORLD_STAGE_NOTES_H

#include "world/stage.h"

/* Prints the warnings and notes. Call it when the stage is complete. */
void murk_stage_warn(const murk_stage *stage);

#endif
