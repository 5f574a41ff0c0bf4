/* A block is 16 bytes that hold the length, then the bytes, filled up to a
 * multiple of 16: so numbers of any type can be read where they lie. */
#include "base/parcel.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define STEP ((size_t)16) /* alignment of the largest type of C */

static size_t rounded(size_t size)
{
    return (size + STEP - 1) / STEP * STEP;
}

void murk_parcel_put(murk_parcel *to, const void *block, size_t size)
{
    const size_t need = to->size + STEP + rounded(size);
    if (need > to->capacity) {
        unsigned char *grown =
            size < SIZE_MAX / 4 ? realloc(to->bytes, 2 * need) : NULL;
        if (!grown) {
            to->is_short = true;
            return;
        }
        to->bytes = grown;
        to->capacity = 2 * need;
    }
    const uint64_t length = size;
    memset(to->bytes + to->size, 0, need - to->size);
    memcpy(to->bytes + to->size, &length, sizeof length);
    if (size > 0) {
        memcpy(to->bytes + to->size + STEP, block, size);
    }
    to->size = need;
}

void murk_parcel_put_text(murk_parcel *to, const char *text)
{
    murk_parcel_put(to, text, text ? strlen(text) + 1 : 0);
}

const void *murk_parcel_take(murk_parcel *from, size_t size)
{
    uint64_t length = 0;
    if (from->is_short || from->size - from->at < STEP) {
        from->is_short = true;
        return NULL;
    }
    memcpy(&length, from->bytes + from->at, sizeof length);
    const size_t left = from->size - from->at - STEP;
    if (length > left || rounded((size_t)length) > left ||
        (size > 0 && length != size)) {
        from->is_short = true;
        return NULL;
    }
    const unsigned char *block = from->bytes + from->at + STEP;
    from->at += STEP + rounded((size_t)length);
    return block;
}

const char *murk_parcel_take_text(murk_parcel *from)
{
    const size_t at = from->at;
    const char *text = murk_parcel_take(from, 0);
    return text && from->at - at > STEP ? text : NULL;
}

void murk_parcel_release(murk_parcel *parcel)
{
    free(parcel->bytes);
    *parcel = (murk_parcel){0};
}
