/* Scratch files (base/scratch_file.h). Addresses for the largest possible file
 * are reserved by one mapping at the start, which costs no memory; a block is
 * written with pwrite(), so that a full disk is an error of that call, and is
 * read through the mapping only after it is written. */
#include "base/scratch_file.h"

#include "base/tally.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/statvfs.h>
#include <unistd.h>

/* Alignment of blocks: one cache line, the widest vector register. */
#define ALIGNMENT 64

/* Fewer addresses than this are not worth a file: the process is at its limit.
 */
#define MAP_MIN ((size_t)1 << 20)

struct murk_scratch_file {
    int fd;
    char *map;
    size_t map_bytes;
    murk_tally end;   /* offset behind the last block */
    murk_tally error; /* errno of a write that failed; 0: none */
};

const char *murk_scratch_folder(void)
{
    const char *folder = getenv("TMPDIR");
    return folder && *folder ? folder : "/var/tmp";
}

double murk_scratch_free_bytes(void)
{
    struct statvfs system;
    return statvfs(murk_scratch_folder(), &system) == 0
               ? (double)system.f_bavail * (double)system.f_frsize
               : INFINITY;
}

murk_status murk_scratch_fail(int reason, murk_error *err)
{
    return murk_fail(err, MURK_RUN_FAILED, murk_scratch_folder(),
                     "cannot write a scratch file: %s; TMPDIR may name another "
                     "folder",
                     strerror(reason));
}

murk_status murk_scratch_open(int *fd, murk_error *err)
{
    char path[4096];
    const int length =
        snprintf(path, sizeof path, "%s/murk-XXXXXX", murk_scratch_folder());
    if (length < 0 || (size_t)length >= sizeof path) {
        return murk_scratch_fail(ENAMETOOLONG, err);
    }
    *fd = mkostemp(path, O_CLOEXEC);
    if (*fd < 0) {
        return murk_scratch_fail(errno, err);
    }
    (void)unlink(path);
    return MURK_OK;
}

/* Reserves addresses for bytes_max bytes, or for a half, a quarter and so on,
 * because the addresses of a process may be limited. False if there are hardly
 * any; errno has the reason. */
static bool reserve(murk_scratch_file *file, uint64_t bytes_max)
{
    const uint64_t minimum = MAP_MIN;
    uint64_t bytes = bytes_max > minimum ? bytes_max : minimum;
    struct rlimit limit;
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur / 2 < bytes) {
        bytes = limit.rlim_cur / 2; /* the other half is for memory */
    }
    for (; bytes >= minimum; bytes /= 2) {
        void *map = bytes <= SIZE_MAX / 2 ? mmap(NULL, (size_t)bytes, PROT_READ,
                                                 MAP_SHARED, file->fd, 0)
                                          : MAP_FAILED;
        if (map != MAP_FAILED) {
            file->map = map;
            file->map_bytes = (size_t)bytes;
            return true;
        }
    }
    return false;
}

murk_status murk_scratch_file_create(murk_scratch_file **out,
                                     uint64_t bytes_max, murk_error *err)
{
    murk_scratch_file *file = calloc(1, sizeof *file);
    if (!file) {
        return murk_no_memory(err, "", "for a scratch file");
    }
    file->fd = -1;
    murk_status status = murk_scratch_open(&file->fd, err);
    if (!status && !reserve(file, bytes_max)) {
        status = murk_scratch_fail(errno, err);
    }
    if (status) {
        murk_scratch_file_destroy(file);
        return status;
    }
    *out = file;
    return MURK_OK;
}

void murk_scratch_file_destroy(murk_scratch_file *file)
{
    if (!file) {
        return;
    }
    if (file->map) {
        munmap(file->map, file->map_bytes);
    }
    if (file->fd >= 0) {
        close(file->fd);
    }
    free(file);
}

/* Writes all bytes of a block. Returns 0 or errno. */
static int write_block(int fd, const char *block, size_t size, off_t offset)
{
    while (size > 0) {
        const ssize_t n = pwrite(fd, block, size, offset);
        if (n < 0 && errno != EINTR) {
            return errno;
        }
        if (n > 0) {
            block += n;
            offset += n;
            size -= (size_t)n;
        }
    }
    return 0;
}

void *murk_scratch_file_append(murk_scratch_file *file, const void *block,
                               size_t size)
{
    const size_t padded = (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    const int64_t at = atomic_fetch_add(&file->end, (int64_t)padded);
    const int reason = (uint64_t)at + padded > file->map_bytes
                           ? ENOMEM
                           : write_block(file->fd, block, size, at);
    if (reason) {
        atomic_store(&file->error, reason);
        return NULL;
    }
    return file->map + at;
}

double murk_scratch_file_left(const murk_scratch_file *file)
{
    const double end = (double)murk_tally_read(&file->end);
    double left = (double)file->map_bytes - end;
    struct statvfs system;
    if (fstatvfs(file->fd, &system) == 0) {
        left = fmin(left, (double)system.f_bavail * (double)system.f_frsize);
    }
    struct rlimit limit;
    if (getrlimit(RLIMIT_FSIZE, &limit) == 0 &&
        limit.rlim_cur != RLIM_INFINITY) {
        left = fmin(left, (double)limit.rlim_cur - end);
    }
    return fmax(left, 0);
}

murk_status murk_scratch_file_check(const murk_scratch_file *file,
                                    murk_error *err)
{
    const int reason = (int)murk_tally_read(&file->error);
    return reason ? murk_scratch_fail(reason, err) : MURK_OK;
}

void murk_scratch_file_discard(murk_scratch_file *file, const void *block,
                               size_t size)
{
#ifdef FALLOC_FL_PUNCH_HOLE
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    const size_t at = (size_t)((const char *)block - file->map);
    const size_t first = (at + page - 1) / page * page;
    const size_t end = (at + size) / page * page;
    if (first < end) {
        (void)fallocate(file->fd, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE,
                        (off_t)first, (off_t)(end - first));
    }
#else
    (void)file;
    (void)block;
    (void)size;
#endif
}

void murk_scratch_file_evict(murk_scratch_file *file)
{
#ifdef MADV_DONTNEED
    const size_t end = (size_t)murk_tally_read(&file->end);
    (void)madvise(file->map, end < file->map_bytes ? end : file->map_bytes,
                  MADV_DONTNEED);
#else
    (void)file;
#endif
}
