/* Hostile scene and table files: one line that says why, soon, in little
 * memory. Nothing here is random; the time allowed is the 10 s, of
 * which each case takes under one. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include <sys/stat.h>
#include <time.h>

#include "../unit/scene/scene_files.h"
#include "broken.h"
#include "scene/table.h"

#define FULL 15900000 /* bytes: just below the limit of a scene */
#define RUN  8000000  /* of one thing repeated */

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static double peak_bytes(void)
{
    return 1024.0 * (double)broken_peak_kb();
}

/* The file is refused, and the message holds that part. */
static void check_file(const char *path, const char *part)
{
    murk_scene_desc *scene = NULL;
    murk_error err = {0};
    const double start = seconds();
    const murk_status status =
        murk_scene_desc_read(&scene, path, NULL, 0, &err);
    const double took = seconds() - start;
    CHECK(status != MURK_OK && scene == NULL);
    CHECK(murk_status_exit_code(status) == 2);
    CHECK_MENTIONS(err.text, part);
    CHECK(strchr(err.text, '\n') == NULL && strchr(err.where, '\n') == NULL);
    CHECK(took < BROKEN_SLOWEST_S);
    murk_scene_desc_destroy(scene);
}

static void check_bytes(const char *bytes, size_t size, const char *part)
{
    write_bytes("fog.yaml", bytes, size);
    check_file("fog.yaml", part);
}

static void check_text(const char *text, const char *part)
{
    check_bytes(text, strlen(text), part);
}

/* head, then `unit` until the file is full. */
static void check_repeated(const char *head, const char *unit, const char *part)
{
    char *bytes = malloc(RUN + 1);
    if (!bytes) {
        CHECK(bytes != NULL);
        return;
    }
    size_t size = strlen(head);
    memcpy(bytes, head, size);
    for (const size_t n = strlen(unit); size + n <= RUN; size += n) {
        memcpy(bytes + size, unit, n);
    }
    check_bytes(bytes, size, part);
    free(bytes);
}

static void test_not_a_file(void)
{
    check_file("none.yaml", "No such file");
    check_file(".", "a folder, must be a regular file");
    CHECK(mkfifo("pipe.yaml", 0600) == 0);
    check_file("pipe.yaml", "must be a regular file");
    unlink("pipe.yaml");
    check_text("", "empty, must be YAML");
}

static void test_a_huge_file_is_not_read(void)
{
    FILE *file = fopen("fog.yaml", "wb");
    CHECK(file && ftruncate(fileno(file), 1 << 30) == 0 && fclose(file) == 0);
    const double before = peak_bytes();
    check_file("fog.yaml", "1074 MB, must be at most 16 MB");
    CHECK(peak_bytes() - before < 1e8);
}

static void test_deep_nesting(void)
{
    char text[200001];
    memset(text, '[', 200000);
    text[200000] = '\0';
    check_text(text, "nested too deep, must be at most 64 levels");
    for (size_t i = 0; i < 200000; ++i) {
        text[i] = "{a: "[i % 4];
    }
    check_text(text, "nested too deep, must be at most 64 levels");
    for (size_t i = 0; i < 200000; ++i) {
        text[i] = "- "[i % 2];
    }
    check_text(text, "nested too deep, must be at most 64 levels");
    for (size_t i = 0; i < 200000; ++i) {
        text[i] = "? "[i % 2];
    }
    check_text(text, "not a key, must be a plain text");
}

static void test_a_billion_laughs(void)
{
    char text[2000] = "a0: &a0 [lol, lol, lol, lol, lol, lol, lol, lol, lol]\n";
    for (int i = 1; i < 30; ++i) {
        const size_t length = strlen(text);
        const int j = i - 1;
        snprintf(text + length, sizeof text - length,
                 "a%d: &a%d [*a%d, *a%d, *a%d, *a%d, *a%d]\n", i, i, j, j, j, j,
                 j);
    }
    check_text(text, "at most 1e6 nodes with all aliases written out");
}

/* One long text, used again and again. */
static void test_a_long_text_repeated(void)
{
    check_repeated("a: [&a \"\"", ", &a x", "more than 1000 anchors");
    char *bytes = malloc(FULL);
    if (!bytes) {
        CHECK(bytes != NULL);
        return;
    }
    memset(bytes, 'x', FULL);
    memcpy(bytes, "a: &a ", 6);
    size_t size = FULL - 1000;
    memcpy(bytes + size, "\nb: [*a", 7);
    size += 7;
    for (int i = 0; i < 100; ++i, size += 4) {
        memcpy(bytes + size, ", *a", 4);
    }
    bytes[size++] = ']';
    check_bytes(bytes, size, "at most 32 MB with all aliases written out");
    free(bytes);
}

/* Aliases that each add a level: a chain, not a tree. */
static void test_a_chain_of_aliases(void)
{
    char text[20000] = "a0: &a0 [x]\n";
    for (int i = 1; i < 500; ++i) {
        const size_t length = strlen(text);
        snprintf(text + length, sizeof text - length, "a%d: &a%d [*a%d]\n", i,
                 i, i - 1);
    }
    check_text(text, "nested too deep, must be at most 64 levels");
}

static void test_many_keys(void)
{
    char *bytes = malloc(FULL);
    size_t size = 0;
    if (!bytes) {
        CHECK(bytes != NULL);
        return;
    }
    for (int i = 0; i < 900000; ++i) {
        size += (size_t)snprintf(bytes + size, FULL - size, "k%d: 1\n", i);
    }
    check_bytes(bytes, size, "unknown key");
    size += (size_t)snprintf(bytes + size, FULL - size, "k123456: 1\n");
    check_bytes(bytes, size, "k123456 is given twice, first in line 123457");
    free(bytes);
    check_repeated("", "a: 1\n", "at most 1e6 nodes");
}

static void test_long_runs(void)
{
    check_repeated("murk: 1\nlights: ", "9",
                   "must be a list of at least one light");
    check_repeated("murk: 1\nlights: ", "x",
                   "must be a list of at least one light");
    check_repeated("", "\n", "empty");
    check_repeated("", "# x\n", "empty");
    check_repeated("murk: [", "1,", "at most 1e6 nodes");
    check_repeated("murk: \"", "\\x41", "not YAML");
    check_repeated("murk: \"", "x ", "not YAML");
    check_repeated("murk: 1\nlights: |\n", "  x\n",
                   "must be a list of at least one light");
    check_repeated("", "x", "must be a scene");
    check_repeated("", "x ", "must be a scene");
    check_repeated("%YAML 1.1 ", "1", "not YAML");
    check_repeated("", "!", "a tag");
    check_repeated("", "&a ", "not YAML");
    check_repeated("", "{}", "not YAML");
    check_repeated("", "---\n", "a second document");
    check_repeated("materials:\n  ", "m", "misses murk");
}

static void test_bytes_that_are_no_text(void)
{
    check_bytes("murk: 1\nseed: \0\n", 16, "control character 0x00");
    check_bytes("murk: 1\nseed: \xFF\n", 16, "byte 0xFF, must be UTF-8");
    check_bytes("\xFF\xFEm\0u\0r\0k\0", 10, "byte 0xFF, must be UTF-8");
    check_bytes("murk: 1\nseed: \xF4\x90\x80\x80\n", 19, "byte 0xF4");
    check_bytes("m\xC3", 2, "byte 0xC3");
}

static void check_table(const char *text, size_t size, const char *part)
{
    murk_table *table = NULL;
    murk_error err = {0};
    if (text) {
        write_bytes("a.csv", text, size);
    }
    const double start = seconds();
    const murk_status status = murk_table_read(&table, "a.csv", &err);
    CHECK(status != MURK_OK && table == NULL);
    CHECK(murk_status_exit_code(status) == 2);
    CHECK_MENTIONS(err.text, part);
    CHECK(seconds() - start < BROKEN_SLOWEST_S);
    murk_table_destroy(table);
}

static void test_tables(void)
{
    char *bytes = malloc(FULL);
    if (!bytes) {
        CHECK(bytes != NULL);
        return;
    }
    memset(bytes, ',', FULL);
    check_table(bytes, FULL, "column 1 has no name");
    memcpy(bytes, "a\n", 2);
    check_table(bytes, FULL, "cells, must be 1");
    memset(bytes, '"', FULL);
    check_table(bytes, FULL - 1, "a quote is not closed");
    for (size_t i = 0; i < 15000; i += 6) {
        snprintf(bytes + i, 8, "c%04zu,", i / 6);
    }
    check_table(bytes, 15000, "more than 1000 columns");
    free(bytes);

    FILE *file = fopen("a.csv", "wb");
    CHECK(file && ftruncate(fileno(file), 1 << 30) == 0 && fclose(file) == 0);
    check_table(NULL, 0, "1074 MB, must be at most 256 MB");
}

int main(void)
{
    if (!folder_enter()) {
        check_skip("no folder for temporary files");
    }
    test_not_a_file();
    test_a_huge_file_is_not_read();
    test_deep_nesting();
    test_a_billion_laughs();
    test_a_long_text_repeated();
    test_a_chain_of_aliases();
    test_many_keys();
    test_long_runs();
    test_bytes_that_are_no_text();
    test_tables();
    CHECK(broken_peak_kb() < BROKEN_MAX_KB);
    folder_leave((const char *const[]){"fog.yaml", "a.csv", NULL});
    return check_done();
}
