/* A request to another process as one run of bytes: blocks, each with a length,
 * taken in the order in which they were put. */
#ifndef MURK_BASE_PARCEL_H
#define MURK_BASE_PARCEL_H

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_parcel {
    unsigned char *bytes;
    size_t size, capacity;
    size_t at;     /* the next block to be taken */
    bool is_short; /* a block had no memory, or is not there */
} murk_parcel;

/* Appends a block; a text with the '\0', and NULL as a block without bytes.
 * When out of memory, is_short is set. */
void murk_parcel_put(murk_parcel *to, const void *block, size_t size);
void murk_parcel_put_text(murk_parcel *to, const char *text);

/* Takes the next block, which lies at a multiple of 16 bytes from the first
 * one. A block of another size sets is_short and gives NULL, as does the end;
 * size 0: any size. A text that was put as NULL is taken as NULL. */
const void *murk_parcel_take(murk_parcel *from, size_t size);
const char *murk_parcel_take_text(murk_parcel *from);

void murk_parcel_release(murk_parcel *parcel);

#endif
