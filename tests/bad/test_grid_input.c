/* Broken OpenVDB files: cut off anywhere, with flipped bits, with noise in the
 * header, or not files at all. Whatever they are: a grid that is sane or one
 * line of error, within bounded time and memory, and the program goes on.
 * Deterministic. */
#include "base/log.h"
#include "base/progress.h"
#include "broken.h"
#include "check.h"
#include "grid_line.h"
#include "medium/grid.h"
#include "written.h"

#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#define FOLDER "tests/unit/medium/grids/"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define UNDER_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define UNDER_SANITIZER 1
#endif
#endif

#ifdef UNDER_SANITIZER
/* The child has no limit there (base/subprocess.h): the sanitizer sets one. */
const char *__asan_default_options(void);
const char *__asan_default_options(void)
{
    return "max_allocation_size_mb=500";
}
#endif

static char folder[] = "/tmp/murk-grids-XXXXXX";
static char path[64];

/* True when the file still gives a grid. */
static bool survives(void)
{
    const double start_s = murk_clock_s();
    murk_grid *grid = NULL;
    murk_error err = {0};
    const murk_status status =
        murk_grid_read(&grid, path, NULL, "bad.yaml:1:1: media.m.vdb", &err);
    CHECK(murk_clock_s() - start_s < BROKEN_SLOWEST_S);
    if (status) {
        CHECK(grid == NULL);
        CHECK(status == MURK_BAD_FILE || status == MURK_BAD_VALUE);
        CHECK_MENTIONS(err.where, "bad.yaml:1:1: media.m.vdb: ");
        broken_check_refusal(&err);
        return false;
    }
    const murk_grid_facts *facts = murk_grid_describe(grid);
    CHECK(facts->minimum >= 0 && facts->maximum >= facts->minimum);
    CHECK(isfinite(facts->maximum) && isfinite(facts->sum));
    const double integral = grid_line_integral(
        grid, murk_vec(-100, 0, 0), murk_unit(murk_vec(1, 0.01, 0.02)), 1e4);
    CHECK(integral >= 0 && isfinite(integral));
    murk_grid_destroy(grid);
    return true;
}

static void test_cut_off_anywhere(const char *file, size_t cuts)
{
    const broken_bytes whole = broken_load(file);
    write_bytes(path, whole.at, whole.size);
    CHECK(survives());
    for (size_t i = 0; i < cuts; ++i) {
        write_bytes(path, whole.at, whole.size * i / cuts);
        CHECK(!survives());
    }
    write_bytes(path, whole.at, whole.size - 1);
    (void)survives();
    free(whole.at);
}

/* One to eight bits somewhere among the first `among` bytes. */
static void test_flipped_bits(const char *file, size_t among, uint64_t flips)
{
    const broken_bytes whole = broken_load(file);
    among = among < whole.size ? among : whole.size;
    int refused = 0;
    for (uint64_t i = 0; i < flips; ++i) {
        unsigned char *copy = malloc(whole.size);
        CHECK(copy != NULL);
        memcpy(copy, whole.at, whole.size);
        broken_flip(copy, among, 7, i, 0, i % 8 + 1);
        write_bytes(path, copy, whole.size);
        refused += !survives();
        free(copy);
    }
    CHECK(refused > 0);
    free(whole.at);
}

/* Whole words of the header set to what hurts most. */
static void test_hostile_words(const char *file, size_t words)
{
    static const unsigned char worst[][4] = {{0xff, 0xff, 0xff, 0xff},
                                             {0xff, 0xff, 0xff, 0x7f},
                                             {0x00, 0x00, 0x00, 0x80},
                                             {0x00, 0x00, 0x00, 0x10}};
    const broken_bytes whole = broken_load(file);
    unsigned char *copy = malloc(whole.size);
    CHECK(copy != NULL);
    for (size_t i = 0; i < words; ++i) {
        const size_t at = 8 + i * 5;
        if (at + 4 <= whole.size) {
            memcpy(copy, whole.at, whole.size);
            memcpy(copy + at, worst[i % 4], 4);
            write_bytes(path, copy, whole.size);
            (void)survives();
        }
    }
    free(copy);
    free(whole.at);
}

static void refuses(const char *file, const char *part)
{
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_read(&grid, file, NULL, "test", &err) == MURK_BAD_FILE);
    CHECK(grid == NULL);
    CHECK_MENTIONS(err.text, part);
}

static void test_no_file_at_all(void)
{
    refuses("/nowhere/at/all.vdb", "No such file");
    refuses(folder, "is a folder");
    write_bytes(path, "", 0);
    refuses(path, "is empty");
    write_bytes(path, " BDV", 4);
    refuses(path, "is not an OpenVDB file");
    write_bytes(path, "NanoVDB0 and so on", 18);
    refuses(path, "is a NanoVDB file");
    unlink(path);
    CHECK(mkfifo(path, 0600) == 0); /* opening it would wait for ever */
    refuses(path, "is not a regular file");
    unlink(path);

    /* A billion bytes of something else. */
    write_bytes(path, "text", 4);
    CHECK(truncate(path, 1000000000) == 0);
    refuses(path, "is not an OpenVDB file");

    /* Behind a good magic, nothing but zeros. */
    write_bytes(path, " BDV\0\0\0\0", 8);
    CHECK(truncate(path, 100000000) == 0);
    CHECK(!survives());
}

int main(void)
{
    CHECK(mkdtemp(folder) != NULL);
    snprintf(path, sizeof path, "%s/grid.vdb", folder);
    murk_warn_to(NULL);

    test_no_file_at_all();
    test_cut_off_anywhere(FOLDER "tiles.vdb", 80);
    test_cut_off_anywhere(FOLDER "moved.vdb", 80);
    test_flipped_bits(FOLDER "tiles.vdb", 1000, 150);
    test_flipped_bits(FOLDER "moved.vdb", 100000, 100);
    test_hostile_words(FOLDER "moved.vdb", 150);

    struct rusage children;
    CHECK(getrusage(RUSAGE_CHILDREN, &children) == 0);
#ifndef UNDER_SANITIZER
    CHECK(children.ru_maxrss < BROKEN_MAX_KB);
#endif

    unlink(path);
    rmdir(folder);
    return check_done();
}
