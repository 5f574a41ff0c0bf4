/* Blocks of memory on the heap or in mapped files (base/block.h). The space of
 * a scratch file is reserved on the disk before the file is mapped, because a
 * write to a mapped page for which the disk has no space ends the process. File
 * systems that write changed data to another place (btrfs, ZFS) or that are
 * shared by a network cannot promise so much. */
#include "base/block.h"

#include "base/machine.h"
#include "base/number.h"
#include "base/ranks.h"
#include "base/scratch_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

/* The share of the free memory for blocks (a choice). */
#define FREE_SHARE 0.7

double murk_block_memory_bytes(void)
{
    const char *text = getenv("MURK_MEMORY_MB");
    double megabytes;
    return text && murk_number_parse(text, &megabytes) && megabytes >= 0
               ? megabytes * MURK_BYTES_PER_MB
               : FREE_SHARE * murk_machine_memory_bytes();
}

murk_block murk_block_of(void *bytes, size_t size)
{
    if (size == 0) {
        free(bytes);
        bytes = NULL;
    }
    return (murk_block){.bytes = bytes, .size = size};
}

void murk_block_release(murk_block *block)
{
    if (block->bytes && block->place == MURK_BLOCK_ON_HEAP) {
        free(block->bytes);
    } else if (block->bytes) {
        munmap(block->bytes, block->size);
        close(block->fd);
    }
    *block = (murk_block){.is_for_ranks = block->is_for_ranks};
}

static murk_status no_memory(size_t size, murk_error *err)
{
    return murk_no_memory(err, "", "for %.4g MB", (double)size / 1e6);
}

/* ---- blocks in files ---- */

static murk_status not_shared(size_t size, int reason, murk_error *err)
{
    return murk_fail(err, MURK_NO_MEMORY, "",
                     "cannot share %.4g MB with another process: %s",
                     (double)size / 1e6, strerror(reason));
}

/* Reserves space on the disk for a scratch file. Where the file system cannot
 * reserve space, the C library writes to the file, so the free space is
 * compared first. Returns 0 or errno. */
static int reserve(int fd, size_t size)
{
    struct stat facts;
    const double has =
        fstat(fd, &facts) == 0 ? 512 * (double)facts.st_blocks : 0;
    int reason = EINTR;
    if ((double)size - has > murk_scratch_free_bytes()) {
        return ENOSPC;
    }
    while (reason == EINTR) {
        reason = posix_fallocate(fd, 0, (off_t)size);
    }
    return reason;
}

/* Gives the file of a block the size. A scratch file that grows gets its space
 * on the disk. */
static murk_status size_file(int fd, murk_block_place place, size_t size,
                             bool grows, murk_error *err)
{
    int reason = 0;
    if (place == MURK_BLOCK_IN_SCRATCH_FILE && grows) {
        reason = reserve(fd, size);
    } else if (ftruncate(fd, (off_t)size) != 0) {
        reason = errno;
    }
    return !reason ? MURK_OK
           : place == MURK_BLOCK_IN_SCRATCH_FILE
               ? murk_scratch_fail(reason, err)
               : not_shared(size, reason, err);
}

/* Maps a file into memory; NULL if that is impossible. */
static void *map_file(int fd, size_t size)
{
    void *bytes = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    return bytes == MAP_FAILED ? NULL : bytes;
}

/* Makes a block of this size in a new file. */
static murk_status create_in_file(murk_block *out, size_t size,
                                  murk_block_place place, murk_error *err)
{
    murk_block made = {.size = size, .place = place, .fd = -1};
    murk_status status = MURK_OK;
    if (place == MURK_BLOCK_IN_SCRATCH_FILE) {
        status = murk_scratch_open(&made.fd, err);
    } else {
        made.fd = memfd_create("murk", MFD_CLOEXEC);
        status = made.fd < 0 ? not_shared(size, errno, err) : MURK_OK;
    }
    if (!status) {
        status = size_file(made.fd, place, size, true, err);
    }
    if (!status) {
        made.bytes = map_file(made.fd, size);
        status = made.bytes ? MURK_OK : no_memory(size, err);
    }
    /* A file that is not used vanishes when it is closed. */
    if (status && made.fd >= 0) {
        close(made.fd);
    }
    if (!status) {
        *out = made;
    }
    return status;
}

/* Changes the size of a block that is in a file. */
static murk_status resize_in_file(murk_block *block, size_t size,
                                  murk_error *err)
{
    const bool grows = size > block->size;
    murk_status status = MURK_OK;
    if (grows) {
        status = size_file(block->fd, block->place, size, true, err);
    }
    void *bytes = status ? NULL : map_file(block->fd, size);
    if (!bytes) {
        return status ? status : no_memory(size, err);
    }
    munmap(block->bytes, block->size);
    block->bytes = bytes;
    block->size = size;
    /* A file that cannot be cut is longer than the block. */
    if (!grows) {
        (void)size_file(block->fd, block->place, size, false, NULL);
    }
    return MURK_OK;
}

/* ---- any block ---- */

static murk_status resize_on_heap(murk_block *block, size_t size,
                                  murk_error *err)
{
    void *bytes = realloc(block->bytes, size);
    if (!bytes) {
        return no_memory(size, err);
    }
    block->bytes = bytes;
    block->size = size;
    return MURK_OK;
}

/* Moves a block to another place, with another size. */
static murk_status move(murk_block *block, size_t size, murk_block_place place,
                        murk_error *err)
{
    murk_block made = {0};
    const murk_status status = create_in_file(&made, size, place, err);
    if (status) {
        return status;
    }
    if (block->bytes) {
        memcpy(made.bytes, block->bytes,
               size < block->size ? size : block->size);
    }
    made.is_for_ranks = block->is_for_ranks;
    murk_block_release(block);
    *block = made;
    return MURK_OK;
}

murk_status murk_block_resize(murk_block *block, size_t size, double memory_max,
                              murk_error *err)
{
    const murk_block_place place =
        (double)size > memory_max ||
                (block->bytes && block->place == MURK_BLOCK_IN_SCRATCH_FILE)
            ? MURK_BLOCK_IN_SCRATCH_FILE
        : block->is_for_ranks ? MURK_BLOCK_IN_MEMORY_FILE
                              : MURK_BLOCK_ON_HEAP;
    if (size == 0) {
        murk_block_release(block);
        return MURK_OK;
    }
    if (place == MURK_BLOCK_ON_HEAP) {
        return resize_on_heap(block, size, err);
    }
    return block->bytes && block->place == place
               ? resize_in_file(block, size, err)
               : move(block, size, place, err);
}

/* ---- ranks ---- */

murk_block_address murk_block_address_of(const murk_block *block)
{
    struct stat facts = {0};
    if (block->place != MURK_BLOCK_ON_HEAP) {
        (void)fstat(block->fd, &facts);
    }
    return (murk_block_address){.process = (uint64_t)getpid(),
                                .fd = (uint64_t)block->fd,
                                .size = block->size,
                                .place = block->place,
                                .device = facts.st_dev,
                                .inode = facts.st_ino};
}

murk_status murk_block_open(murk_block *out, const murk_block_address *a,
                            murk_error *err)
{
    char path[64];
    struct stat facts = {0};
    murk_block made = {.size = a->size,
                       .is_for_ranks = true,
                       .place = (murk_block_place)a->place};
    if (a->size == 0) {
        *out = (murk_block){.is_for_ranks = true};
        return MURK_OK;
    }
    /* Another file may have taken the descriptor meanwhile. */
    snprintf(path, sizeof path, "/proc/%llu/fd/%llu",
             (unsigned long long)a->process, (unsigned long long)a->fd);
    made.fd = open(path, O_RDWR | O_CLOEXEC);
    int reason = made.fd < 0 ? errno : ESTALE;
    const bool is_right = made.fd >= 0 && fstat(made.fd, &facts) == 0 &&
                          facts.st_dev == a->device && facts.st_ino == a->inode;
    made.bytes = is_right ? map_file(made.fd, made.size) : NULL;
    if (!made.bytes) {
        if (made.fd >= 0) {
            close(made.fd);
        }
        reason = is_right ? ENOMEM : reason;
        return not_shared(a->size, reason, err);
    }
    *out = made;
    return MURK_OK;
}

murk_status murk_ranks_share_block(murk_block *block, murk_status status,
                                   murk_error *err)
{
    const murk_ranks_here here = murk_ranks_on_machine();
    murk_gathered all = {0};
    if (murk_ranks_count() == 1) {
        return status;
    }
    if (here.number > 0) {
        murk_block_release(block);
    } else if (!status && block->bytes && here.count > 1 &&
               block->place == MURK_BLOCK_ON_HEAP) {
        status = move(block, block->size, MURK_BLOCK_IN_MEMORY_FILE, err);
    }
    const murk_block_address mine = murk_block_address_of(block);
    status = murk_ranks_gather(&all, &mine, sizeof mine, status, err);
    if (!status && here.number > 0) {
        murk_block_address first;
        memcpy(&first, all.bytes + here.first * sizeof first, sizeof first);
        status = murk_block_open(block, &first, err);
    }
    murk_gathered_release(&all);
    return murk_ranks_agree(status, err);
}
