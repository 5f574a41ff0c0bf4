/* A light.murk that is not whole is refused in one line; nothing crashes, hangs
 * or takes memory that the file does not fill. */
#include "check.h"

#include "base/file.h"
#include "base/rng.h"
#include "base/scratch_file.h"
#include "photonmap/map_file.h"
#include "written.h"

#include <stdint.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

static char path[64];

/* The line that refuses the file; "" where it was taken. */
static const char *refusal(murk_status want)
{
    static murk_error err;
    murk_section *sections = NULL;
    size_t n = 0;
    err = (murk_error){0};
    const murk_status status = murk_map_file_read(&sections, &n, path, &err);
    if (!status) {
        murk_map_file_release(sections, n);
        return "";
    }
    CHECK(status == want && sections == NULL && n == 0);
    CHECK_TEXT(err.where, path);
    CHECK(strchr(err.text, '\n') == NULL);
    return err.text;
}

static char *make_small_file(size_t *size)
{
    char surface[96], scene[] = "murk: 1";
    memset(surface, 7, sizeof surface);
    const murk_section sections[] = {
        murk_section_of("surface", surface, sizeof surface),
        murk_section_of("scene", scene, sizeof scene)};
    char *bytes = NULL;
    CHECK(murk_map_file_write(path, sections, 2, NULL) == MURK_OK);
    CHECK(murk_file_read(&bytes, size, path, 1000, NULL) == MURK_OK);
    CHECK_TEXT(refusal(MURK_OK), "");
    return bytes;
}

static void test_every_length_is_refused(const char *bytes, size_t size)
{
    for (size_t n = 0; n < size; ++n) {
        write_bytes(path, bytes, n);
        const char *line = refusal(MURK_BAD_FILE);
        CHECK_MENTIONS(line, n < 8 ? "not a light.murk file" : "cut short: ");
    }
    write_bytes(path, bytes, 0);
    CHECK_TEXT(refusal(MURK_BAD_FILE),
               "not a light.murk file or a part of a run: it is empty");
    write_bytes(path, bytes, 100);
    CHECK_TEXT(refusal(MURK_BAD_FILE), "cut short: 100 bytes, must be 264");
}

static void test_every_changed_byte_is_seen(char *bytes, size_t size)
{
    for (size_t i = 0; i < size; ++i) {
        const char flips[] = {1, 64, (char)128, (char)255};
        for (size_t j = 0; j < sizeof flips; ++j) {
            bytes[i] = (char)(bytes[i] ^ flips[j]);
            write_bytes(path, bytes, size);
            const char *line = refusal(MURK_BAD_FILE);
            CHECK_MENTIONS(line, i < 8              ? "not a light.murk file"
                                 : i >= 8 && i < 12 ? "version "
                                 : i < 64 ? "changed bytes in the header"
                                 : i < 64 + 2 * 48
                                     ? "changed bytes in the table"
                                 : i < size - 8 ? "in section surface"
                                                : "in section scene");
            bytes[i] = (char)(bytes[i] ^ flips[j]);
        }
    }
}

static void test_more_bytes_are_refused(const char *bytes, size_t size)
{
    char longer[1001] = {0};
    memcpy(longer, bytes, size);
    write_bytes(path, longer, size + 1);
    CHECK_TEXT(refusal(MURK_BAD_FILE),
               "265 bytes, must be 264: something stands behind its end");
    write_bytes(path, longer, 1001);
    CHECK_MENTIONS(refusal(MURK_BAD_FILE), "something stands behind");
}

/* What a header with its own checksum right may still ask for. */
static void test_signed_nonsense_is_refused(const char *bytes, size_t size)
{
    typedef struct change {
        size_t at, width;
        uint64_t value;
        const char *says;
    } change;
    const change changes[] = {
        {8, 4, 2, "version 2, this murk reads 1"},
        {12, 4, 0x04030201, "written in the other byte order"},
        {12, 4, 5, "changed bytes in the header"},
        {16, 4, 40, "records of 40 bytes, this murk reads 32"},
        {20, 4, 0xffffffff, "4294967295 sections, must be at most 64"},
        {20, 4, 60, "cut short: 264 bytes, must be 2944"},
        {20, 4, 1, "changed bytes in the table"},
        {20, 4, 3, "changed bytes in the table"},
        {24, 8, UINT64_MAX,
         "cut short: 264 bytes, must be 18446744073709551615"},
        {24, 8, 1, "264 bytes, must be 1: something stands behind"},
        /* in the table: sizes that do not add up, or only after overflow */
        {80, 8, 97, "changed bytes in the table"},
        {80, 8, 95, "changed bytes in the table"},
        {80, 8, UINT64_MAX, "changed bytes in the table"},
        {80, 8, (uint64_t)1 << 63, "changed bytes in the table"},
        {88, 8, 1, "changed bytes in the table"},
        {64, 8, 0, "changed bytes in the table"},
        {64, 8, 0x0a0a0a0a, "changed bytes in the table"},
        {112, 8, 0x65636166727573, "changed bytes in the table"}, /* twice */
    };
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; ++i) {
        char changed[1000];
        uint64_t checksum[2];
        memcpy(changed, bytes, size);
        memcpy(changed + changes[i].at, &changes[i].value, changes[i].width);
        murk_checksum(changed + 64, 96, checksum);
        memcpy(changed + 32, checksum, sizeof checksum);
        murk_checksum(changed, 48, checksum);
        memcpy(changed + 48, checksum, sizeof checksum);
        write_bytes(path, changed, size);
        CHECK_MENTIONS(refusal(MURK_BAD_FILE), changes[i].says);
    }
}

/* A sparse file that says truly how long it is, longer than any memory. */
static void test_more_than_memory_is_refused(const char *bytes)
{
    char head[112];
    uint64_t checksum[2];
    const uint64_t size = (uint64_t)1 << 42, rest = size - sizeof head;
    const uint32_t one = 1;
    memcpy(head, bytes, sizeof head);
    memcpy(head + 20, &one, sizeof one);
    memcpy(head + 24, &size, sizeof size);
    memcpy(head + 80, &rest, sizeof rest);
    murk_checksum(head + 64, 48, checksum);
    memcpy(head + 32, checksum, sizeof checksum);
    murk_checksum(head, 48, checksum);
    memcpy(head + 48, checksum, sizeof checksum);
    write_bytes(path, head, sizeof head);
    if (murk_scratch_free_bytes() < (double)rest &&
        truncate(path, (off_t)size) == 0) {
        CHECK_MENTIONS(refusal(MURK_NO_MEMORY), "needs 4398 GB, more than");
        /* another section is missing, however large this one is */
        murk_section *one_section = NULL;
        CHECK(murk_map_file_read_one(&one_section, path, "key", NULL) ==
              MURK_BAD_FILE);
    }
}

static void test_noise_is_refused(void)
{
    for (uint64_t i = 0; i < 300; ++i) {
        uint32_t noise[256];
        for (uint32_t j = 0; j < 64; ++j) {
            murk_random_words(3, MURK_TEST, i, j, 0, noise + 4 * j);
        }
        write_bytes(path, noise, (size_t)(i * 3));
        CHECK_MENTIONS(refusal(MURK_BAD_FILE), "not a light.murk file");
    }
    write_bytes(path, "murk: 1\nbands_nm: [532]\n", 24);
    CHECK_TEXT(refusal(MURK_BAD_FILE),
               "not a light.murk file or a part of a run");
}

static void test_what_is_no_file_is_refused(void)
{
    remove(path);
    CHECK_MENTIONS(refusal(MURK_BAD_FILE), "cannot read: No such file");
    CHECK(mkdir(path, 0700) == 0);
    CHECK_TEXT(refusal(MURK_BAD_FILE),
               "cannot read: a folder, must be a regular file");
    CHECK(rmdir(path) == 0);
    CHECK(mkfifo(path, 0600) == 0); /* nobody writes to it */
    CHECK_TEXT(refusal(MURK_BAD_FILE),
               "cannot read: not a file, must be a regular file");
    remove(path);
}

int main(void)
{
    snprintf(path, sizeof path, "test_light.tmp.%ld", (long)getpid());
    size_t size = 0;
    char *bytes = make_small_file(&size);
    CHECK(size == 264);
    if (bytes && size == 264) {
        test_every_length_is_refused(bytes, size);
        test_every_changed_byte_is_seen(bytes, size);
        test_more_bytes_are_refused(bytes, size);
        test_signed_nonsense_is_refused(bytes, size);
        test_more_than_memory_is_refused(bytes);
    }
    test_noise_is_refused();
    test_what_is_no_file_is_refused();
    free(bytes);
    remove(path);
    struct rusage use;
    CHECK(getrusage(RUSAGE_SELF, &use) == 0 && use.ru_maxrss < 200000); /* kB */
    return check_done();
}
