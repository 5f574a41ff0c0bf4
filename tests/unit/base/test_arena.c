/* Arrays of an arena are 0, do not overlap, and a request that no memory can
 * meet is remembered. Deterministic. */
#include "base/arena.h"
#include "check.h"

#include <stdint.h>
#include <string.h>

#define ARRAYS 100

int main(void)
{
    murk_arena arena = {0};
    unsigned char *array[ARRAYS];
    for (size_t i = 0; i < ARRAYS; ++i) {
        array[i] = murk_arena_array(&arena, i, 8);
        CHECK(array[i] && (uintptr_t)array[i] % _Alignof(max_align_t) == 0);
        for (size_t k = 0; k < 8 * i; ++k) {
            CHECK(array[i][k] == 0);
        }
        memset(array[i], (int)i, 8 * i);
    }
    for (size_t i = 0; i < ARRAYS; ++i) {
        for (size_t k = 0; k < 8 * i; ++k) {
            CHECK(array[i][k] == i);
        }
    }
    CHECK(!arena.is_short);
    CHECK(!murk_arena_array(&arena, SIZE_MAX / 4, 8) && arena.is_short);
    CHECK(!murk_arena_array(&arena, SIZE_MAX / 16, 8) && arena.is_short);
    murk_arena_release(&arena);
    CHECK(!arena.last && !arena.is_short);
    return check_done();
}
