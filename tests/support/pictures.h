/* Pictures and sceneries of test worlds; a test ends where one cannot be made.
 */
#ifndef MURK_TESTS_PICTURES_H
#define MURK_TESTS_PICTURES_H

#include "render/render.h"
#include "render/scenery.h"
#include "worlds.h"

#include <stdio.h>
#include <stdlib.h>

/* The picture of `render` at 550 nm, of the light that `trace` describes. */
static inline murk_image *picture_of_trace(murk_render render,
                                           const murk_trace *trace)
{
    render.trace = trace;
    render.from_nm[0] = render.to_nm[0] = 550;
    murk_image *picture = NULL;
    murk_error err = {0};
    if (murk_render_run(&picture, &render, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    return picture;
}

/* The same of a world by seed 1. */
static inline murk_image *picture_of_world(murk_render render,
                                           const test_world *world)
{
    murk_trace trace = murk_trace_defaults();
    trace.world = &world->world;
    trace.seed = 1;
    return picture_of_trace(render, &trace);
}

static inline murk_scenery scenery_of_world(const test_world *world)
{
    murk_scenery scenery;
    murk_error err = {0};
    if (murk_scenery_prepare(&scenery, &world->world, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    return scenery;
}

#endif
