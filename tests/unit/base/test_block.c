/* Blocks of memory: the content stays when a block grows, shrinks or moves to a
 * scratch file; a disk that is full is an error; ranks of a machine share the
 * memory of a block. */
#include "base/block.h"
#include "check.h"
#include "thread_ranks.h"

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#define WORDS ((size_t)1 << 20) /* 8 MB */

static void fill(murk_block *block, size_t first, size_t end)
{
    uint64_t *word = block->bytes;
    for (size_t i = first; i < end; ++i) {
        word[i] = i * UINT64_C(0x9e3779b97f4a7c15);
    }
}

static bool has_content(const murk_block *block, size_t end)
{
    const uint64_t *word = block->bytes;
    bool is_equal = true;
    for (size_t i = 0; i < end; ++i) {
        is_equal = is_equal && word[i] == i * UINT64_C(0x9e3779b97f4a7c15);
    }
    return is_equal;
}

/* Grows in steps up to WORDS, shrinks to a third, and grows again, with at most
 * memory_max bytes in memory. */
static void test_content_stays(bool is_for_ranks, double memory_max,
                               murk_block_place place)
{
    murk_block block = {.is_for_ranks = is_for_ranks};
    murk_error err = {0};
    size_t n = 0;
    for (size_t next = 1000; next <= WORDS; next *= 4) {
        CHECK(!murk_block_resize(&block, next * 8, memory_max, &err));
        fill(&block, n, next);
        n = next;
        CHECK(block.size == n * 8 && has_content(&block, n));
    }
    CHECK(block.place == place);
    CHECK(!murk_block_resize(&block, n / 3 * 8, memory_max, &err));
    CHECK(has_content(&block, n / 3) && block.place == place);
    CHECK(!murk_block_resize(&block, n * 8, memory_max, &err));
    fill(&block, n / 3, n);
    CHECK(has_content(&block, n));
    CHECK(!murk_block_resize(&block, 0, memory_max, &err));
    CHECK(!block.bytes && block.size == 0);
    CHECK(block.is_for_ranks == is_for_ranks);
}

/* A block may also come from malloc() and move to a file later. */
static void test_taken_memory_moves(void)
{
    murk_error err = {0};
    murk_block block = murk_block_of(malloc(80), 80);
    fill(&block, 0, 10);
    CHECK(!murk_block_resize(&block, 800, 100, &err));
    CHECK(block.place == MURK_BLOCK_IN_SCRATCH_FILE);
    CHECK(has_content(&block, 10));
    murk_block_release(&block);
    murk_block_release(&block);
}

static void test_full_disk_is_an_error(void)
{
    murk_error err = {0};
    murk_block block = {.size = 0};
    struct rlimit before, small;
    signal(SIGXFSZ, SIG_IGN);
    CHECK(getrlimit(RLIMIT_FSIZE, &before) == 0);
    small = before;
    small.rlim_cur = 100000;
    CHECK(!murk_block_resize(&block, 80000, 0, &err));
    fill(&block, 0, 10000);
    CHECK(setrlimit(RLIMIT_FSIZE, &small) == 0);
    CHECK(murk_block_resize(&block, 200000, 0, &err) == MURK_RUN_FAILED);
    CHECK_MENTIONS(err.text, "cannot write a scratch file: File too large");
    CHECK(setrlimit(RLIMIT_FSIZE, &before) == 0);
    CHECK(block.size == 80000 && has_content(&block, 10000));
    murk_block_release(&block);
    /* More than any disk has, and a folder without a disk. */
    err = (murk_error){0};
    CHECK(murk_block_resize(&block, SIZE_MAX / 4, 0, &err) == MURK_RUN_FAILED);
    CHECK_MENTIONS(err.text, "No space left on device");
    err = (murk_error){0};
    CHECK(setenv("TMPDIR", "/nowhere/at/all", 1) == 0);
    CHECK(murk_block_resize(&block, 800, 0, &err) == MURK_RUN_FAILED);
    CHECK_MENTIONS(err.where, "/nowhere/at/all");
    CHECK(unsetenv("TMPDIR") == 0);
}

static void test_memory_by_the_environment(void)
{
    const double automatic = murk_block_memory_bytes();
    CHECK(automatic > 0);
    CHECK(setenv("MURK_MEMORY_MB", "2.5", 1) == 0);
    CHECK(murk_block_memory_bytes() == 2.5 * 1048576);
    CHECK(setenv("MURK_MEMORY_MB", "much", 1) == 0);
    CHECK(murk_block_memory_bytes() > 3e6);
    CHECK(setenv("MURK_MEMORY_MB", "-1", 1) == 0);
    CHECK(murk_block_memory_bytes() > 3e6);
    CHECK(unsetenv("MURK_MEMORY_MB") == 0);
}

/* ---- ranks ---- */

typedef struct sharing {
    bool is_for_ranks, is_empty;
    double memory_max;
    const void *bytes[THREAD_RANKS_MAX];
    bool has_content[THREAD_RANKS_MAX];
} sharing;

/* The first rank of each machine has a block, of which all see a change. */
static murk_status share(void *context, unsigned number, murk_error *err)
{
    sharing *s = context;
    const murk_ranks_here here = murk_ranks_on_machine();
    murk_block block = {.is_for_ranks = s->is_for_ranks};
    murk_status status = MURK_OK;
    if (here.number == 0 && !s->is_empty) {
        status = murk_block_resize(&block, WORDS * 8, s->memory_max, err);
        if (!status) {
            fill(&block, 0, WORDS / 2);
        }
    }
    status = murk_ranks_share_block(&block, status, err);
    /* The last rank of the machine writes the other half. */
    if (!status && here.number == here.count - 1 && !s->is_empty) {
        fill(&block, WORDS / 2, WORDS);
    }
    status = murk_ranks_agree(status, err);
    if (!status) {
        s->bytes[number] = block.bytes;
        s->has_content[number] =
            s->is_empty ? block.size == 0 : has_content(&block, WORDS);
    }
    status = murk_ranks_agree(status, err);
    murk_block_release(&block);
    return status;
}

static void test_ranks_share(unsigned count, bool is_for_ranks, bool is_empty,
                             double memory_max)
{
    sharing s = {.is_for_ranks = is_for_ranks,
                 .is_empty = is_empty,
                 .memory_max = memory_max};
    const thread_ranks_end end =
        thread_ranks_run(count, THREAD_RANKS_SOUND, share, &s);
    CHECK(thread_ranks_succeeded(&end, count));
    for (unsigned r = 0; r < count; ++r) {
        CHECK(s.has_content[r]);
    }
}

/* An address that leads to another file is refused. */
static void test_wrong_address_is_refused(void)
{
    murk_error err = {0};
    murk_block block = {.is_for_ranks = true}, other = {0};
    CHECK(!murk_block_resize(&block, 800, INFINITY, &err));
    murk_block_address address = murk_block_address_of(&block);
    CHECK(!murk_block_open(&other, &address, &err));
    fill(&block, 0, 100);
    CHECK(has_content(&other, 100));
    murk_block_release(&other);
    ++address.inode;
    CHECK(murk_block_open(&other, &address, &err) == MURK_NO_MEMORY);
    CHECK_MENTIONS(err.text, "cannot share");
    murk_block_release(&block);
}

int main(void)
{
    test_content_stays(false, INFINITY, MURK_BLOCK_ON_HEAP);
    test_content_stays(true, INFINITY, MURK_BLOCK_IN_MEMORY_FILE);
    test_content_stays(false, 1e5, MURK_BLOCK_IN_SCRATCH_FILE);
    test_content_stays(true, 1e5, MURK_BLOCK_IN_SCRATCH_FILE);
    test_content_stays(false, 0, MURK_BLOCK_IN_SCRATCH_FILE);
    test_taken_memory_moves();
    test_full_disk_is_an_error();
    test_memory_by_the_environment();
    test_ranks_share(1, false, false, INFINITY);
    test_ranks_share(3, false, false, INFINITY);
    test_ranks_share(3, true, false, INFINITY);
    test_ranks_share(5, true, false, INFINITY);
    test_ranks_share(5, true, true, INFINITY);
    test_ranks_share(5, true, false, 0);
    test_wrong_address_is_refused();
    return check_done();
}
