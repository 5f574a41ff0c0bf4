/* Adds the local origin to positions and prints them. The origin belongs to the
 * host of the calling thread and is set while a world is built. */
#include "base/position.h"

#include "base/host.h"

#include <stdio.h>

void murk_position_origin(murk_vec3 at)
{
    murk_host_now()->origin = at;
}

murk_position_text murk_position_show(murk_vec3 local)
{
    murk_position_text out;
    const murk_vec3 origin = murk_host_now()->origin;
    const murk_vec3 p = murk_add(local, origin);
    const bool is_far = origin.x != 0 || origin.y != 0 || origin.z != 0;
    const int digits = is_far ? 12 : 9;
    (void)snprintf(out.text, sizeof out.text, "[%.*g, %.*g, %.*g]", digits, p.x,
                   digits, p.y, digits, p.z);
    return out;
}
