/* Scratch files: blocks read back as written, also after their pages have left
 * memory and after other blocks were discarded; and files that cannot be
 * written. */
#include "base/pool.h"
#include "base/scratch_file.h"
#include "check.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

enum { BLOCKS = 200 };

typedef struct blocks {
    murk_scratch_file *file;
    void *at[BLOCKS];
} blocks;

/* Blocks of 0 to some 20,000 bytes. */
static size_t size_of(size_t k)
{
    return k * 101;
}

static void write_one(void *context, unsigned worker, uint64_t k)
{
    blocks *b = context;
    unsigned char block[BLOCKS * 101];
    (void)worker;
    memset(block, (int)k, size_of(k));
    b->at[k] = murk_scratch_file_append(b->file, block, size_of(k));
}

static bool has_content(const blocks *b, size_t k)
{
    const unsigned char *block = b->at[k];
    bool is_equal = true;
    for (size_t i = 0; i < size_of(k); ++i) {
        is_equal = is_equal && block[i] == k;
    }
    return is_equal;
}

static void test_blocks_come_back(void)
{
    blocks b = {0};
    murk_error err = {0};
    CHECK(murk_scratch_file_create(&b.file, BLOCKS * 21000, &err) == MURK_OK);
    murk_pool_run_workers(2, BLOCKS, write_one, &b);
    CHECK(murk_scratch_file_check(b.file, &err) == MURK_OK);
    for (size_t k = 0; k < BLOCKS; ++k) {
        CHECK(b.at[k] && (uintptr_t)b.at[k] % 64 == 0 && has_content(&b, k));
    }
    /* Evicted pages are read again; the neighbours of discarded blocks stay. */
    murk_scratch_file_evict(b.file);
    for (size_t k = 0; k < BLOCKS; k += 2) {
        CHECK(has_content(&b, k));
        murk_scratch_file_discard(b.file, b.at[k], size_of(k));
    }
    for (size_t k = 1; k < BLOCKS; k += 2) {
        CHECK(has_content(&b, k));
    }
    murk_scratch_file_destroy(b.file);
}

/* Addresses of this process, and resident pages of files [bytes]. */
typedef struct memory {
    double addresses, mapped;
} memory;

static memory memory_now(void)
{
    FILE *file = fopen("/proc/self/statm", "r");
    long size = 0, resident = 0, shared = 0;
    CHECK(file && fscanf(file, "%ld %ld %ld", &size, &resident, &shared) == 3);
    if (file) {
        fclose(file);
    }
    const double page = (double)sysconf(_SC_PAGESIZE);
    return (memory){page * (double)size, page * (double)shared};
}

static double mapped_bytes(void)
{
    return memory_now().mapped;
}

/* The bytes of the disk that open files without a name take, or of the first of
 * them. */
static double disk_bytes(void)
{
    for (int fd = 3; fd < 64; ++fd) {
        struct stat status;
        if (fstat(fd, &status) == 0 && status.st_nlink == 0 &&
            S_ISREG(status.st_mode)) {
            return (double)status.st_blocks * 512;
        }
    }
    return NAN;
}

/* Pages that were read leave the memory, and discarded blocks the disk. */
static void test_pages_go(void)
{
    enum { SIZE = 1 << 24 };
    char *block = malloc(SIZE);
    murk_scratch_file *file = NULL;
    murk_error err = {0};
    memset(block, 7, SIZE);
    CHECK(murk_scratch_file_create(&file, 2 * SIZE, &err) == MURK_OK);
    const double empty = mapped_bytes();
    char *copy = murk_scratch_file_append(file, block, SIZE);
    CHECK(copy && memcmp(copy, block, SIZE) == 0);
    CHECK(mapped_bytes() - empty > .9 * SIZE);
    murk_scratch_file_evict(file);
    CHECK(mapped_bytes() - empty < .1 * SIZE);
    CHECK(disk_bytes() > .9 * SIZE);
    murk_scratch_file_discard(file, copy, SIZE);
    CHECK(disk_bytes() < .1 * SIZE);
    /* Addresses for two blocks were asked for. */
    CHECK(murk_scratch_file_append(file, block, SIZE));
    CHECK(!murk_scratch_file_append(file, block, SIZE));
    CHECK(murk_scratch_file_check(file, &err) == MURK_RUN_FAILED);
    CHECK_MENTIONS(err.text, "Cannot allocate memory");
    murk_scratch_file_destroy(file);
    free(block);
}

/* A process that may have few addresses gets a smaller file. Leaves the limit
 * as it was. */
static void test_few_addresses(void)
{
    struct rlimit before, few = {(rlim_t)1 << 36, (rlim_t)1 << 36};
    murk_scratch_file *file = NULL;
    murk_error err = {0};
    CHECK(getrlimit(RLIMIT_AS, &before) == 0);
    few.rlim_max = before.rlim_max;
    /* A sanitizer takes more addresses than that. */
    if (before.rlim_cur < few.rlim_cur || memory_now().addresses > 0x1p35 ||
        setrlimit(RLIMIT_AS, &few)) {
        return;
    }
    CHECK(murk_scratch_file_create(&file, UINT64_C(1) << 40, &err) == MURK_OK);
    CHECK(file && murk_scratch_file_left(file) <= 0x1p36);
    murk_scratch_file_destroy(file);
    CHECK(setrlimit(RLIMIT_AS, &before) == 0);
}

static void test_folder(void)
{
    murk_scratch_file *file = NULL;
    murk_error err = {0};
    unsetenv("TMPDIR");
    CHECK_TEXT(murk_scratch_folder(), "/var/tmp");
    CHECK(murk_scratch_free_bytes() > 0);
    setenv("TMPDIR", "/there/is/no/such/folder", 1);
    CHECK(murk_scratch_file_create(&file, 1, &err) == MURK_RUN_FAILED && !file);
    CHECK_TEXT(err.where, "/there/is/no/such/folder");
    CHECK_MENTIONS(err.text, "cannot write a scratch file: No such file");
    unsetenv("TMPDIR");
}

/* A limit on the size of files stands for a full disk. Last: the limit stays.
 */
static void test_full_disk(void)
{
    const struct rlimit limit = {1 << 20, 1 << 20};
    static const char block[1 << 19];
    murk_scratch_file *file = NULL;
    murk_error err = {0};
    CHECK(murk_scratch_file_create(&file, 1 << 24, &err) == MURK_OK);
    signal(SIGXFSZ, SIG_IGN);
    CHECK(setrlimit(RLIMIT_FSIZE, &limit) == 0);
    CHECK(murk_scratch_file_left(file) == 1 << 20);
    CHECK(murk_scratch_file_append(file, block, sizeof block));
    CHECK(murk_scratch_file_append(file, block, sizeof block));
    CHECK(murk_scratch_file_left(file) == 0);
    CHECK(murk_scratch_file_check(file, &err) == MURK_OK);
    CHECK(!murk_scratch_file_append(file, block, sizeof block));
    CHECK(murk_scratch_file_check(file, &err) == MURK_RUN_FAILED);
    CHECK_MENTIONS(err.text, "cannot write a scratch file: File too large");
    murk_scratch_file_destroy(file);
}

int main(void)
{
    test_blocks_come_back();
    test_pages_go();
    test_few_addresses();
    test_folder();
    test_full_disk();
    return check_done();
}
