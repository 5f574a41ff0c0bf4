/* A request to another process as one run of bytes: blocks, each with a length,
 * taken in the order in which they were put. A parcel begins as zeros. */
#ifndef MURK_BASE_PARCEL_H
#define MURK_BASE_PARCEL_H

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_parcel {
    unsigned char *bytes;
    size_t size, capacity;
    size_t at;     /* offset of the next block to be taken */
    bool is_short; /* a block had no memory, is not there, or has another size
                    * than the one asked for */
} murk_parcel;

/* murk_parcel_put() appends a block of `size` bytes. murk_parcel_put_text()
 * appends a text with the '\0', or, for NULL, a block without bytes. When out
 * of memory, both set is_short and append nothing. */
void murk_parcel_put(murk_parcel *to, const void *block, size_t size);
void murk_parcel_put_text(murk_parcel *to, const char *text);

/* Take the next block, which lies at a multiple of 16 bytes from the first one.
 * If there is no further block, or the block has not `size` bytes (0: any
 * number), murk_parcel_take() sets is_short and returns NULL; so do all later
 * calls. murk_parcel_take_text() also returns NULL for a text that was put as
 * NULL. */
const void *murk_parcel_take(murk_parcel *from, size_t size);
const char *murk_parcel_take_text(murk_parcel *from);

void murk_parcel_release(murk_parcel *parcel);

#endif
