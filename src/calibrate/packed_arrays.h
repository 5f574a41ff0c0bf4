/* Arrays one behind the other in a buffer, for exchanges between ranks
 * (base/ranks.h). For use inside src/calibrate only. */
#ifndef MURK_CALIBRATE_PACKED_ARRAYS_H
#define MURK_CALIBRATE_PACKED_ARRAYS_H

#include <stddef.h>
#include <string.h>

typedef struct murk_packed_array {
    void *data;
    size_t bytes; /* 0: the array may be NULL */
} murk_packed_array;

static inline size_t murk_arrays_bytes(const murk_packed_array *array, size_t n)
{
    size_t bytes = 0;
    for (size_t a = 0; a < n; ++a) {
        bytes += array[a].bytes;
    }
    return bytes;
}

/* Copies n arrays to `at`, and from `at`. Both return the end of what was
 * copied. */
static inline char *murk_arrays_pack(char *at, const murk_packed_array *array,
                                     size_t n)
{
    for (size_t a = 0; a < n; ++a) {
        if (array[a].bytes) {
            memcpy(at, array[a].data, array[a].bytes);
        }
        at += array[a].bytes;
    }
    return at;
}
static inline const char *murk_arrays_unpack(const murk_packed_array *array,
                                             size_t n, const char *at)
{
    for (size_t a = 0; a < n; ++a) {
        if (array[a].bytes) {
            memcpy(array[a].data, at, array[a].bytes);
        }
        at += array[a].bytes;
    }
    return at;
}

#endif
