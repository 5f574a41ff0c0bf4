/* light.murk returns the sections that were written, also if the system reads
 * in small parts; equal sections make equal files, and an unwritable path is
 * named. */
#include "check.h"

#include "photonmap/map_file.h"

#include <stdint.h>
#include <stdlib.h>
#include <sys/uio.h>
#include <unistd.h>

static char path[64];

/* In place of the C library's: reads of no more than this, as a network's file
 * system or a very large file may give less than was asked for. */
static size_t read_max = SIZE_MAX;

ssize_t read(int fd, void *out, size_t size)
{
    const struct iovec part = {out, size < read_max ? size : read_max};
    return readv(fd, &part, 1);
}

static void test_sections_come_back(void)
{
    /* Sections of many bytes, of none and of one. */
    static unsigned char first[100003], third[1];
    for (size_t i = 0; i < sizeof first; ++i) {
        first[i] = (unsigned char)(i * 7 + i / 256);
    }
    const murk_section given[] = {
        murk_section_of("surface", first, sizeof first),
        murk_section_of("empty", NULL, 0),
        murk_section_of("fifteen-letters", third, 1)};
    /* Write and read the file. */
    murk_section *got = NULL;
    size_t n = 0;
    murk_error err = {0};
    CHECK(murk_map_file_write(path, given, 3, &err) == MURK_OK);
    CHECK(murk_map_file_read(&got, &n, path, &err) == MURK_OK);
    CHECK(n == 3);
    for (size_t i = 0; got && i < n; ++i) {
        /* Names and bytes come back, aligned to 64 bytes. */
        CHECK_TEXT(got[i].name, given[i].name);
        CHECK(got[i].size == given[i].size);
        CHECK(got[i].size == 0 ||
              memcmp(got[i].bytes, given[i].bytes, got[i].size) == 0);
        CHECK((uintptr_t)got[i].bytes % 64 == 0);
        CHECK(murk_map_file_find(got, n, given[i].name) == &got[i]);
    }
    /* Names must match as a whole; to release nothing is allowed. */
    CHECK(murk_map_file_find(got, n, "surf") == NULL);
    CHECK(murk_map_file_find(got, n, "surfaces") == NULL);
    murk_map_file_release(got, n);
    murk_map_file_release(NULL, 0);
}

static void test_no_sections_are_fine(void)
{
    murk_section *got = NULL;
    size_t n = 9;
    CHECK(murk_map_file_write(path, NULL, 0, NULL) == MURK_OK);
    CHECK(murk_map_file_read(&got, &n, path, NULL) == MURK_OK);
    CHECK(n == 0 && got);
    CHECK(murk_map_file_find(got, n, "surface") == NULL);
    murk_map_file_release(got, n);
}

static void test_same_sections_same_file(void)
{
    char bytes[2][200];
    const murk_section given = murk_section_of("scene", path, sizeof path);
    size_t size[2] = {0};
    for (int i = 0; i < 2; ++i) {
        CHECK(murk_map_file_write(path, &given, 1, NULL) == MURK_OK);
        FILE *file = fopen(path, "rb");
        size[i] = file ? fread(bytes[i], 1, sizeof bytes[i], file) : 0;
        if (file) {
            fclose(file);
        }
    }
    CHECK(size[0] == 64 + 48 + sizeof path && size[1] == size[0]);
    CHECK(memcmp(bytes[0], bytes[1], size[0]) == 0);
}

static void test_unwritable_place_is_named(void)
{
    murk_error err = {0};
    const murk_section given = murk_section_of("scene", path, sizeof path);
    CHECK(murk_map_file_write("no/such/folder/x", &given, 1, &err) ==
          MURK_RUN_FAILED);
    CHECK_TEXT(err.where, "no/such/folder/x");
    CHECK_MENTIONS(err.text, "cannot write");
}

static void test_what_comes_in_parts(void)
{
    read_max = 7;
    test_sections_come_back();
    read_max = SIZE_MAX;
}

int main(void)
{
    snprintf(path, sizeof path, "test_light_file.tmp.%ld", (long)getpid());
    test_sections_come_back();
    test_what_comes_in_parts();
    test_no_sections_are_fine();
    test_same_sections_same_file();
    test_unwritable_place_is_named();
    remove(path);
    return check_done();
}
