/* Each array is a block of calloc() of its own: a header with a pointer to the
 * block before it, followed by the elements. Large arrays are therefore
 * returned to the system one by one. */
#include "base/arena.h"

#include <stdalign.h>
#include <stdint.h>
#include <stdlib.h>

struct murk_arena_array {
    struct murk_arena_array *before;
    alignas(max_align_t) unsigned char bytes[];
};

void *murk_arena_array(murk_arena *arena, size_t n, size_t size)
{
    const size_t header = sizeof(struct murk_arena_array);
    const bool fits = size == 0 || n <= (SIZE_MAX - header) / size;
    struct murk_arena_array *made = fits ? calloc(1, header + n * size) : NULL;
    if (!made) {
        arena->is_short = true;
        return NULL;
    }
    made->before = arena->last;
    arena->last = made;
    return made->bytes;
}

void murk_arena_release(murk_arena *arena)
{
    while (arena->last) {
        struct murk_arena_array *before = arena->last->before;
        free(arena->last);
        arena->last = before;
    }
    arena->is_short = false;
}
