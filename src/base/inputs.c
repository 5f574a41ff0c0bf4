/* The set of files that a run reads: a hash table with open addressing in
 * memory that processes share.
 *
 * A slot holds a 64-bit hash of the device, the inode and the time of creation
 * of a file, or 0 if the slot is free. Without the time, a new file that got
 * the inode of a file that was read and then removed would count as an input; a
 * file system that does not tell the time has that fault. The table belongs to
 * a host (base/host.h). Once a file did not fit, every file counts as an input.
 * Slots are claimed by compare-and-swap and never freed, so no lock is needed,
 * and a process that is killed cannot leave a lock behind. Two files with the
 * same hash would at worst make a run refuse to write one of them: the
 * probability is 2^-64 for a pair. */
#include "base/inputs.h"

#include "base/host.h"

#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <xxhash.h>

/* Eight times the number of files that the largest studies name. Pages that are
 * never touched take no memory. */
#define SLOTS ((size_t)1 << 20)

void murk_inputs_begin(void)
{
    murk_host *host = murk_host_now();
    void *memory =
        mmap(NULL, SLOTS * sizeof *host->inputs, PROT_READ | PROT_WRITE,
             MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    host->inputs = memory == MAP_FAILED ? NULL : memory;
    atomic_store(&host->inputs_are_full, !host->inputs);
}

void murk_inputs_end(void)
{
    murk_host *host = murk_host_now();
    if (host->inputs) {
        (void)munmap((void *)host->inputs, SLOTS * sizeof *host->inputs);
    }
    host->inputs = NULL;
    atomic_store(&host->inputs_are_full, false);
}

/* The hash of the file `path` in the folder `folder`, or of the open file
 * `folder` if `path` is empty; 0 if the file cannot be examined. */
static uint64_t hash_of(int folder, const char *path)
{
    struct statx made = {0};
    struct stat file;
    if (fstatat(folder, path, &file, AT_EMPTY_PATH)) {
        return 0;
    }
    const bool tells_time =
        !statx(folder, path, AT_EMPTY_PATH, STATX_BTIME, &made) &&
        (made.stx_mask & STATX_BTIME);
    const uint64_t name[] = {(uint64_t)file.st_dev, (uint64_t)file.st_ino,
                             tells_time ? (uint64_t)made.stx_btime.tv_sec : 0,
                             tells_time ? (uint64_t)made.stx_btime.tv_nsec : 0};
    const uint64_t hash = XXH3_64bits(name, sizeof name);
    return hash ? hash : 1;
}

static void add(uint64_t hash)
{
    murk_host *host = murk_host_now();
    if (!host->inputs || hash == 0) {
        return;
    }
    for (size_t tried = 0; tried < SLOTS; ++tried) {
        uint64_t found = 0;
        _Atomic uint64_t *slot = &host->inputs[(hash + tried) % SLOTS];
        if (atomic_compare_exchange_strong(slot, &found, hash) ||
            found == hash) {
            return;
        }
    }
    atomic_store(&host->inputs_are_full, true);
}

void murk_inputs_add(int file)
{
    add(hash_of(file, ""));
}

void murk_inputs_list(uint64_t **hash, size_t *n)
{
    const murk_host *host = murk_host_now();
    *hash = NULL;
    *n = 0;
    for (size_t i = 0; host->inputs && i < SLOTS; ++i) {
        const uint64_t found = atomic_load(&host->inputs[i]);
        uint64_t *grown =
            found ? realloc(*hash, (*n + 1) * sizeof *grown) : NULL;
        if (grown) {
            *hash = grown;
            (*hash)[(*n)++] = found;
        }
    }
}

void murk_inputs_add_listed(const void *hash, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        uint64_t one;
        memcpy(&one, (const char *)hash + i * sizeof one, sizeof one);
        add(one);
    }
}

murk_inputs_before murk_inputs_try(void)
{
    murk_host *host = murk_host_now();
    const murk_inputs_before before = {host->inputs,
                                       atomic_load(&host->inputs_are_full)};
    uint64_t *hash;
    size_t n;
    murk_inputs_list(&hash, &n);
    murk_inputs_begin();
    murk_inputs_add_listed(hash, n);
    if (before.are_full) {
        atomic_store(&host->inputs_are_full, true);
    }
    free(hash);
    return before;
}

void murk_inputs_forget(const murk_inputs_before *before)
{
    murk_inputs_end();
    murk_host *host = murk_host_now();
    host->inputs = before->inputs;
    atomic_store(&host->inputs_are_full, before->are_full);
}

FILE *murk_inputs_open(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (file) {
        murk_inputs_add(fileno(file));
    }
    return file;
}

bool murk_inputs_has(const char *path)
{
    const murk_host *host = murk_host_now();
    const uint64_t hash = path[0] ? hash_of(AT_FDCWD, path) : 0;
    if (!hash || atomic_load(&host->inputs_are_full)) {
        return hash != 0;
    }
    for (size_t tried = 0; host->inputs && tried < SLOTS; ++tried) {
        const uint64_t found =
            atomic_load(&host->inputs[(hash + tried) % SLOTS]);
        if (found == hash || found == 0) {
            return found == hash;
        }
    }
    return false;
}
