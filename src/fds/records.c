/* Reads records of unformatted Fortran files (fds/records.h), subrecord by
 * subrecord. All lengths are checked against the file before they are used. */
#include "fds/records.h"

static uint32_t swapped(uint32_t word)
{
    return __builtin_bswap32(word);
}

/* Reads a length before or after a subrecord; false at the end of the file. */
static bool read_length(murk_fds_records *r, int32_t *out)
{
    uint32_t word;
    if (fread(&word, sizeof word, 1, r->file) != 1) {
        r->is_cut = true;
        return false;
    }
    *out = (int32_t)(r->is_swapped ? swapped(word) : word);
    return *out != INT32_MIN; /* has no positive counterpart */
}

bool murk_fds_records_begin(murk_fds_records *r, uint32_t expected)
{
    int32_t length = 0;
    r->is_swapped = false;
    if (!read_length(r, &length)) {
        return false;
    }
    r->is_swapped = swapped((uint32_t)length) == expected;
    rewind(r->file);
    return r->is_swapped || (uint32_t)length == expected;
}

/* The bytes of one subrecord, read to `out` or, if it is NULL, skipped. */
static bool take(murk_fds_records *r, unsigned char *out, uint32_t length)
{
    const off_t at = ftello(r->file);
    if (at < 0) {
        return false;
    }
    if (length > r->bytes - (uint64_t)at) {
        r->is_cut = true;
        return false;
    }
    if (!out) {
        return fseeko(r->file, (off_t)length, SEEK_CUR) == 0;
    }
    const bool is_read = fread(out, 1, length, r->file) == length;
    r->is_cut = r->is_cut || !is_read;
    return is_read;
}

/* Reads to `out`, or skips if it is NULL, a record of at most `max` bytes.
 * *size is the number of bytes in it. */
static bool take_record(murk_fds_records *r, unsigned char *out, uint64_t max,
                        uint64_t *size)
{
    bool is_last = false;
    *size = 0;
    for (uint64_t part = 0; !is_last; ++part) {
        int32_t before, after;
        if (!read_length(r, &before)) {
            return false;
        }
        is_last = before >= 0;
        const int32_t length = is_last ? before : -before;
        if ((uint64_t)length > max - *size ||
            !take(r, out ? out + *size : NULL, (uint32_t)length) ||
            !read_length(r, &after) || after != (part > 0 ? -length : length)) {
            return false;
        }
        *size += (uint64_t)length;
    }
    return true;
}

bool murk_fds_record_bytes(murk_fds_records *r, void *out, uint64_t n)
{
    uint64_t size;
    return take_record(r, out, n, &size) && size == n;
}

bool murk_fds_record_words(murk_fds_records *r, void *out, uint64_t n)
{
    if (!murk_fds_record_bytes(r, out, 4 * n)) {
        return false;
    }
    uint32_t *word = out;
    for (uint64_t i = 0; r->is_swapped && i < n; ++i) {
        word[i] = swapped(word[i]);
    }
    return true;
}

bool murk_fds_record_skip(murk_fds_records *r, uint64_t *size)
{
    return take_record(r, NULL, UINT64_MAX, size);
}
