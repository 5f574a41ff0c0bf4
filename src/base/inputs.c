/* The set of files that a run reads: a hash table with open addressing in
 * memory that processes share.
 *
 * A slot holds a 64-bit hash of device and inode, or 0 if the slot is free.
 * Slots are claimed by compare-and-swap and never freed, so no lock is needed,
 * and a process that is killed cannot leave a lock behind. Two files with the
 * same hash would at worst make a run refuse to write one of them: the
 * probability is 2^-64 for a pair. */
#include "base/inputs.h"

#include <stdatomic.h>
#include <stdint.h>
#include <sys/mman.h>
#include <xxhash.h>

/* Eight times the number of files that the largest studies name. Pages that are
 * never touched take no memory. */
#define SLOTS ((size_t)1 << 20)

static _Atomic uint64_t *slots; /* [SLOTS]; NULL: the set was not begun */
static atomic_bool is_full;     /* set when a file did not fit: then every file
                                 * counts as an input */

void murk_inputs_begin(void)
{
    void *memory = mmap(NULL, SLOTS * sizeof *slots, PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    slots = memory == MAP_FAILED ? NULL : memory;
    atomic_store(&is_full, !slots);
}

static uint64_t hash_of(const struct stat *file)
{
    const uint64_t name[2] = {(uint64_t)file->st_dev, (uint64_t)file->st_ino};
    const uint64_t hash = XXH3_64bits(name, sizeof name);
    return hash ? hash : 1;
}

void murk_inputs_add(const struct stat *file)
{
    const uint64_t hash = hash_of(file);
    if (!slots) {
        return;
    }
    for (size_t tried = 0; tried < SLOTS; ++tried) {
        uint64_t found = 0;
        _Atomic uint64_t *slot = &slots[(hash + tried) % SLOTS];
        if (atomic_compare_exchange_strong(slot, &found, hash) ||
            found == hash) {
            return;
        }
    }
    atomic_store(&is_full, true);
}

FILE *murk_inputs_open(const char *path)
{
    struct stat known;
    FILE *file = fopen(path, "rb");
    if (file && fstat(fileno(file), &known) == 0) {
        murk_inputs_add(&known);
    }
    return file;
}

bool murk_inputs_has(const char *path)
{
    struct stat known;
    if (stat(path, &known) != 0) {
        return false;
    }
    if (atomic_load(&is_full)) {
        return true;
    }
    const uint64_t hash = hash_of(&known);
    for (size_t tried = 0; slots && tried < SLOTS; ++tried) {
        const uint64_t found = atomic_load(&slots[(hash + tried) % SLOTS]);
        if (found == hash || found == 0) {
            return found == hash;
        }
    }
    return false;
}
