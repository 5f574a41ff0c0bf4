/* Sessions of worlds. */
#ifndef MURK_API_LIGHT_H
#define MURK_API_LIGHT_H

#include "api/handles.h"

/* A session (results/session.h) that borrows scene and stage of a world. */
murk_session murk_world_session(const murk_world *world);

#endif
