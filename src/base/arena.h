/* An arena: arrays that are released together. A new arena is {0}. */
#ifndef MURK_BASE_ARENA_H
#define MURK_BASE_ARENA_H

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_arena {
    struct murk_arena_array *last; /* internal */
    bool is_short;                 /* an array is missing for lack of memory */
} murk_arena;

/* Returns a new array of n >= 0 elements of `size` bytes, all 0, which the
 * arena owns. The function returns NULL and sets is_short if there is no
 * memory, so that a caller can ask for all arrays first and check once. */
void *murk_arena_array(murk_arena *arena, size_t n, size_t size);

/* Frees all arrays; the arena is then empty and may be used again. */
void murk_arena_release(murk_arena *arena);

#endif
