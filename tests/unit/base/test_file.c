/* Files appear whole or not at all; what cannot be read says why. */
#include "base/file.h"
#include "check.h"

#include <dirent.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[] = "/tmp/murk_test_file_XXXXXX";

static size_t entries(void)
{
    size_t n = 0;
    DIR *dir = opendir(folder);
    while (dir && readdir(dir)) {
        ++n;
    }
    if (dir) {
        closedir(dir);
    }
    return n - 2; /* . and .. */
}

static void test_write_and_read(const char *path)
{
    /* A file that is being written leaves the old one readable, and leaves
     * nothing behind if it is discarded. */
    murk_error err = {0};
    CHECK(murk_file_write(path, "old", 3, &err) == MURK_OK);
    murk_file *file = NULL;
    CHECK(murk_file_create(&file, path, &err) == MURK_OK);
    fputs("half of the ne", murk_file_stream(file));
    fflush(murk_file_stream(file));
    char *text = NULL;
    size_t size = 0;
    CHECK(murk_file_read(&text, &size, path, 100, &err) == MURK_OK);
    CHECK(size == 3);
    CHECK_TEXT(text, "old");
    free(text);
    murk_file_discard(file);
    CHECK(entries() == 1);

    /* A finished file replaces the old one. */
    CHECK(murk_file_write(path, "new", 3, &err) == MURK_OK);
    CHECK(murk_file_read(&text, &size, path, 100, &err) == MURK_OK);
    CHECK_TEXT(text, "new");
    free(text);
    CHECK(entries() == 1);

    /* The checksum of a file is that of the bytes, and a file that is too
     * long is refused. */
    uint64_t whole[2], pieces[2];
    murk_checksum("new", 3, whole);
    CHECK(murk_file_checksum(path, 2, pieces, NULL) == MURK_BAD_FILE);
    CHECK(murk_file_checksum(path, 3, pieces, &err) == MURK_OK);
    CHECK(whole[0] == pieces[0] && whole[1] == pieces[1]);
}

static void expect_unreadable(const char *path, size_t max, const char *why)
{
    murk_error err = {0};
    char *text = NULL;
    size_t size = 0;
    CHECK(murk_file_read(&text, &size, path, max, &err) == MURK_BAD_FILE);
    CHECK(text == NULL);
    CHECK_TEXT(err.where, path);
    CHECK_MENTIONS(err.text, why);
}

static void test_refusals(const char *path)
{
    expect_unreadable(path, 2, "must be at most");
    expect_unreadable(folder, 100, "a folder");
    expect_unreadable("/nowhere/at/all", 100, "No such file");
    char fifo[128];
    snprintf(fifo, sizeof fifo, "%s/fifo", folder);
    CHECK(mkfifo(fifo, 0600) == 0);
    expect_unreadable(fifo, 100, "not a file");
    unlink(fifo);

    murk_error err = {0};
    CHECK(murk_file_write(folder, "x", 1, &err) == MURK_RUN_FAILED);
    err = (murk_error){0};
    CHECK(murk_file_write("/dev/full", "x", 1, &err) == MURK_RUN_FAILED);
    err = (murk_error){0};
    CHECK(murk_folder_make(path, &err) == MURK_RUN_FAILED);
    CHECK_MENTIONS(err.text, "not a folder");
}

static void test_folders_and_paths(void)
{
    char deep[128];
    murk_error err = {0};
    snprintf(deep, sizeof deep, "%s/a/b/c", folder);
    CHECK(murk_folder_make(deep, &err) == MURK_OK);
    CHECK(murk_folder_make(deep, &err) == MURK_OK);
    struct stat info;
    CHECK(stat(deep, &info) == 0 && S_ISDIR(info.st_mode));

    const char *const cases[][3] = {{"scenes/a.yaml", "m.obj", "scenes/m.obj"},
                                    {"a.yaml", "m.obj", "m.obj"},
                                    {"scenes/a.yaml", "/m.obj", "/m.obj"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        char *path = murk_path_beside(cases[i][0], cases[i][1]);
        CHECK_TEXT(path, cases[i][2]);
        free(path);
    }
}

/* FIPS 180-2's example. */
static void test_sha256(void)
{
    char hex[65];
    murk_sha256_hex("abc", 3, hex);
    CHECK_TEXT(hex, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f"
                    "20015ad");
}

/* The hash of a file, for which the SHA instructions of the processor may be
 * used, is that of libmd for the same bytes: lengths around a block of 64
 * bytes, and around the pieces of 2^20 bytes that are read at once. */
static void test_sha256_of_a_file(const char *path)
{
    static unsigned char bytes[(1 << 21) + 65];
    for (size_t i = 0; i < sizeof bytes; ++i) {
        bytes[i] = (unsigned char)(i * i / 7 + i % 251);
    }
    const size_t lengths[] = {
        0,           1, 55, 56, 63, 64, 65, 127, 128, 1 << 20, (1 << 20) + 1,
        sizeof bytes};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; ++i) {
        murk_file *file = NULL;
        char of_file[65], of_bytes[65];
        CHECK(murk_file_create(&file, path, NULL) == MURK_OK);
        CHECK(fwrite(bytes, 1, lengths[i], murk_file_stream(file)) ==
              lengths[i]);
        CHECK(murk_file_commit(&file, NULL) == MURK_OK);
        CHECK(murk_file_sha256(path, of_file, NULL) == MURK_OK);
        murk_sha256_hex(bytes, lengths[i], of_bytes);
        CHECK_TEXT(of_file, of_bytes);
    }
}

int main(void)
{
    CHECK(mkdtemp(folder) != NULL);
    char path[128];
    snprintf(path, sizeof path, "%s/result.json", folder);
    test_write_and_read(path);
    test_refusals(path);
    test_folders_and_paths();
    test_sha256();
    test_sha256_of_a_file(path);
    char command[160];
    snprintf(command, sizeof command, "rm -r %s", folder);
    CHECK(system(command) == 0);
    return check_done();
}
