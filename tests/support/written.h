/* Files of tests, written plainly: murk_file_write() would wait for the disk
 * each time. */
#ifndef MURK_TESTS_WRITTEN_H
#define MURK_TESTS_WRITTEN_H

#include "check.h"

static inline void write_bytes(const char *path, const void *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    CHECK(file && fwrite(bytes, 1, size, file) == size && fclose(file) == 0);
}

static inline void write_text(const char *path, const char *text)
{
    write_bytes(path, text, strlen(text));
}

#endif
