/* Reads and writes whole files. A file is written under a temporary name
 * (base/staging.c), flushed to the disk and renamed, so that a crash leaves
 * either the old file or the complete new one. Checksums are XXH3 (xxHash) and
 * SHA-256 (libmd, with the SHA instructions of the processor for whole blocks
 * of files). */
#include "base/file.h"

#include "base/inputs.h"
#include "base/memory_files.h"
#include "base/sha256_blocks.h"
#include "base/staging.h"

#include <errno.h>
#include <fcntl.h>
#include <sha256.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#define PIECE_BYTES ((size_t)1 << 20) /* read at once for a checksum */
/* Bytes that are searched for the mark of murk. In an OpenEXR image the mark
 * stands behind the list of channels; a list of 200 channels fits. */
#define HEAD_BYTES ((size_t)1 << 16)

struct murk_file {
    FILE *stream;
    char *path, *temporary;
};

/* Flushes the folder of a file: only then is the new folder entry on the disk.
 * Failure does not make the file fail, because some file systems refuse to
 * flush folders. */
static void sync_folder_of(const char *path)
{
    char *folder = murk_path_beside(path, ".");
    if (folder) {
        murk_folder_sync(folder);
    }
    free(folder);
}

void murk_folder_sync(const char *path)
{
    const int fd = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd >= 0) {
        (void)fsync(fd);
        close(fd);
    }
}

murk_status murk_file_check_input(const char *path, murk_error *err)
{
    return murk_inputs_has(path)
               ? murk_fail(err, MURK_BAD_VALUE, path,
                           "is read by this run, which does not write over "
                           "it; must be another file or folder")
               : MURK_OK;
}

/* Fails with MURK_RUN_FAILED and "WHAT: REASON". `made` is the file or folder
 * that could not be created; if the folder that would hold it does not permit
 * writing, the message names that folder. */
static murk_status cannot_make(const char *what, const char *path,
                               const char *made, int reason, murk_error *err)
{
    const char *slash = strrchr(made, '/');
    const int length = !slash ? 1 : slash == made ? 1 : (int)(slash - made);
    char *folder = strndup(slash ? made : ".", (size_t)length);
    struct stat info;
    murk_status status;
    if (folder && stat(folder, &info) == 0 && S_ISDIR(info.st_mode) &&
        access(folder, W_OK | X_OK) != 0) {
        status = murk_fail(err, MURK_RUN_FAILED, path,
                           "%s: %s may not be written into: %s", what, folder,
                           strerror(errno));
    } else {
        status = murk_fail(err, MURK_RUN_FAILED, path, "%s: %s", what,
                           strerror(reason));
    }
    free(folder);
    return status;
}

murk_status murk_file_create(murk_file **out, const char *path, murk_error *err)
{
    murk_status status = MURK_OK;
    murk_file *file = calloc(1, sizeof *file);
    struct stat known;
    int fd = -1;
    /* Refuse a path that leads to something other than a regular file or to an
     * input of this run. */
    if (!file || !(file->path = strdup(path))) {
        status = murk_no_memory(err, path, "to open it");
        goto done;
    }
    if (stat(path, &known) == 0 && !S_ISREG(known.st_mode)) {
        status = murk_fail(err, MURK_RUN_FAILED, path,
                           "cannot write: not a regular file");
        goto done;
    }
    status = murk_file_check_input(path, err);
    if (status) {
        goto done;
    }
    /* Open the temporary file, locked. */
    fd = murk_staging_file(path, &file->temporary);
    if (fd < 0) {
        status = cannot_make("cannot write", path, path, errno, err);
        goto done;
    }
    const mode_t mask = umask(0); /* mkstemp() gives mode 0600; set the usual
                                   * mode. */
    umask(mask);
    (void)fchmod(fd, 0666 & ~mask);
    file->stream = fdopen(fd, "wb");
    if (!file->stream) {
        close(fd);
        status = murk_fail(err, MURK_RUN_FAILED, path, "cannot write: %s",
                           strerror(errno));
        goto done;
    }
    *out = file;
    file = NULL;
done:
    murk_file_discard(file);
    return status;
}

FILE *murk_file_stream(murk_file *file)
{
    return file->stream;
}

murk_status murk_file_commit(murk_file **file_io, murk_error *err)
{
    murk_file *file = *file_io;
    *file_io = NULL;
    errno = 0;
    /* Flush first: a full disk is often reported only here. */
    const int failed = ferror(file->stream) | fflush(file->stream) |
                       fsync(fileno(file->stream));
    const int reason = errno;
    murk_status status = MURK_OK;
    if (failed) {
        status = murk_fail(err, MURK_RUN_FAILED, file->path, "cannot write: %s",
                           reason ? strerror(reason)
                                  : "an error while writing (disk full?)");
    } else if (murk_file_check_input(file->path,
                                     err)) { /* read since murk_file_create() */
        status = MURK_BAD_VALUE;
    } else if (rename(file->temporary, file->path) != 0) {
        status = murk_fail(err, MURK_RUN_FAILED, file->path, "cannot write: %s",
                           strerror(errno));
    } else {
        sync_folder_of(file->path);
        free(file->temporary);
        file->temporary = NULL;
    }
    murk_file_discard(file);
    return status;
}

void murk_file_discard(murk_file *file)
{
    if (file) {
        if (file->stream) {
            fclose(file->stream);
        }
        if (file->temporary) {
            unlink(file->temporary);
        }
        free(file->temporary);
        free(file->path);
        free(file);
    }
}

murk_status murk_file_write(const char *path, const void *bytes, size_t size,
                            murk_error *err)
{
    murk_file *file = NULL;
    murk_status status = murk_file_create(&file, path, err);
    if (status) {
        return status;
    }
    (void)fwrite(bytes, 1, size, file->stream); /* murk_file_commit() asks
                                                 * ferror() */
    return murk_file_commit(&file, err);
}

/* The owner of a file that is read. */
typedef enum owner {
    INPUT, /* the user: this run must not write over the file */
    OWN    /* murk: this run may replace the file */
} owner;

/* Opens a regular file of at most `max` bytes for reading. */
static murk_status open_regular(int *out, struct stat *info, uint64_t max,
                                owner whose, const char *path, murk_error *err)
{
    /* non-blocking, so that a pipe without a writer cannot block the run */
    const int fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0 || fstat(fd, info) != 0) {
        const int reason = errno;
        if (fd >= 0) {
            close(fd);
        }
        return murk_fail(err, MURK_BAD_FILE, path, "cannot read: %s",
                         strerror(reason));
    }
    if (!S_ISREG(info->st_mode)) {
        close(fd);
        return murk_fail(err, MURK_BAD_FILE, path,
                         "cannot read: %s, must be a regular file",
                         S_ISDIR(info->st_mode) ? "a folder" : "not a file");
    }
    if ((uintmax_t)info->st_size > max) {
        close(fd);
        return murk_fail(err, MURK_BAD_FILE, path,
                         "%.4g MB, must be at most %.4g MB",
                         (double)info->st_size / 1e6, (double)max / 1e6);
    }
    if (whose == INPUT) {
        murk_inputs_add(fd);
    }
    *out = fd;
    return MURK_OK;
}

murk_status murk_file_open(int *fd, uint64_t *size, const char *path,
                           murk_error *err)
{
    struct stat info;
    const murk_status status =
        open_regular(fd, &info, UINT64_MAX, INPUT, path, err);
    if (!status) {
        *size = (uint64_t)info.st_size;
    }
    return status;
}

murk_file_identity murk_file_identity_of(const struct stat *file)
{
    return (murk_file_identity){
        .part = {(uint64_t)file->st_dev, (uint64_t)file->st_ino,
                 (uint64_t)file->st_size, (uint64_t)file->st_mtim.tv_sec,
                 (uint64_t)file->st_mtim.tv_nsec,
                 (uint64_t)file->st_ctim.tv_sec,
                 (uint64_t)file->st_ctim.tv_nsec}};
}

murk_status murk_file_identify(murk_file_identity *out, const char *path,
                               murk_error *err)
{
    murk_status status;
    if (murk_memory_is(path)) {
        const murk_memory_file *file = NULL;
        status = murk_memory_find(&file, path, MURK_MEMORY_TABLE, path, err);
        *out = (murk_file_identity){.part = {0}};
        if (!status) {
            memcpy(out->part, file->checksum, sizeof file->checksum);
        }
        return status;
    }
    struct stat info;
    int fd = -1;
    status = open_regular(&fd, &info, UINT64_MAX, INPUT, path, err);
    if (!status) {
        *out = murk_file_identity_of(&info);
        close(fd);
    }
    return status;
}

murk_status murk_file_read_bytes(int fd, void *out, size_t size,
                                 const char *path, murk_error *err)
{
    /* A read may return fewer bytes than asked for. */
    size_t got = 0;
    while (got < size) {
        const ssize_t n = read(fd, (char *)out + got, size - got);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            return murk_fail(err, MURK_BAD_FILE, path, "cannot read: %s",
                             n < 0 ? strerror(errno) : "it grew shorter");
        }
        got += (size_t)n;
    }
    return MURK_OK;
}

static murk_status read_whole(char **out, size_t *size, const char *path,
                              size_t max, owner whose, murk_error *err)
{
    char *bytes = NULL;
    struct stat info;
    int fd = -1;
    murk_status status = open_regular(&fd, &info, max, whose, path, err);
    if (status) {
        return status;
    }
    /* The size of the file at opening counts, with one byte more for '\0'. */
    const size_t length = (size_t)info.st_size;
    bytes = malloc(length + 1);
    if (!bytes) {
        status = murk_no_memory(err, path, "to read it");
        goto done;
    }
    status = murk_file_read_bytes(fd, bytes, length, path, err);
    if (status) {
        goto done;
    }
    bytes[length] = '\0';
    *size = length;
    *out = bytes;
    bytes = NULL;
done:
    close(fd);
    free(bytes);
    return status;
}

murk_status murk_file_read(char **out, size_t *size, const char *path,
                           size_t max, murk_error *err)
{
    if (!murk_memory_is(path)) {
        return read_whole(out, size, path, max, INPUT, err);
    }
    const murk_memory_file *file = NULL;
    const murk_status status =
        murk_memory_find(&file, path, MURK_MEMORY_TABLE, path, err);
    if (status) {
        return status;
    }
    *size = strlen(file->data);
    *out = strdup(file->data);
    return *out ? MURK_OK : murk_no_memory(err, path, "to read it");
}

murk_status murk_file_read_own(char **out, size_t *size, const char *path,
                               size_t max, murk_error *err)
{
    return read_whole(out, size, path, max, OWN, err);
}

static bool has_mark(const char *path, const char *mark, size_t size)
{
    struct stat info;
    int fd = -1;
    char *head = calloc(1, HEAD_BYTES);
    bool has = false;
    if (head && !open_regular(&fd, &info, UINT64_MAX, OWN, path, NULL)) {
        const ssize_t n = read(fd, head, HEAD_BYTES);
        for (ssize_t i = 0; !has && i + (ssize_t)size <= n; ++i) {
            has = memcmp(head + i, mark, size) == 0;
        }
        close(fd);
    }
    free(head);
    return has;
}

murk_status murk_file_not_ours(const char *path, murk_error *err)
{
    return murk_fail(err, MURK_BAD_VALUE, path, MURK_NOT_OURS);
}

murk_status murk_file_check_owner(const char *path, const char *mark,
                                  size_t size, bool force, murk_error *err)
{
    struct stat known;
    const murk_status status = murk_file_check_input(path, err);
    if (status || force || lstat(path, &known) != 0 ||
        (stat(path, &known) == 0 && !S_ISREG(known.st_mode))) {
        return status; /* paths that are no regular file are refused when they
                        * are written */
    }
    return has_mark(path, mark, size) ? MURK_OK : murk_file_not_ours(path, err);
}

murk_status murk_folder_make(const char *path, murk_error *err)
{
    char *part = murk_path_join(path, "");
    if (!part) {
        return murk_no_memory(err, path, "for its name");
    }
    /* create each folder on the path that does not exist yet */
    int refusal = 0;
    for (char *slash = strchr(part + 1, '/'); slash && !refusal;
         slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        refusal = mkdir(part, 0777) == 0 || errno == EEXIST ? 0 : errno;
        *slash = refusal ? '\0' : '/'; /* `part` ends with the refused folder */
    }
    struct stat info;
    murk_status status = MURK_OK;
    if (stat(path, &info) != 0) {
        status = cannot_make("cannot make the folder", path, part,
                             refusal ? refusal : errno, err);
    }
    free(part);
    if (status) {
        return status;
    }
    if (!S_ISDIR(info.st_mode)) {
        return murk_fail(err, MURK_RUN_FAILED, path, "not a folder");
    }
    if (access(path, W_OK | X_OK) != 0) {
        return murk_fail(err, MURK_RUN_FAILED, path,
                         "cannot write into the folder: %s", strerror(errno));
    }
    return MURK_OK;
}

void murk_sha256_hex(const void *bytes, size_t size, char out[65])
{
    SHA256Data(bytes, size, out);
}

void murk_checksum(const void *bytes, size_t size, uint64_t out[2])
{
    const XXH128_hash_t hash = XXH3_128bits(bytes, size);
    out[0] = hash.low64;
    out[1] = hash.high64;
}

/* Passes the bytes of a regular file to take(), one block after the other. */
static murk_status read_pieces(const char *path, uint64_t max, owner whose,
                               void (*take)(void *context, const void *bytes,
                                            size_t size),
                               void *context, murk_error *err)
{
    struct stat info;
    int fd = -1;
    murk_status status = open_regular(&fd, &info, max, whose, path, err);
    if (status) {
        return status;
    }
    unsigned char *piece = malloc(PIECE_BYTES);
    if (!piece) {
        status = murk_no_memory(err, path, "to read it");
    }
    /* Read block by block until the end of the file. */
    ssize_t n;
    while (!status && (n = read(fd, piece, PIECE_BYTES)) != 0) {
        if (n > 0) {
            take(context, piece, (size_t)n);
        } else if (errno != EINTR) {
            status = murk_fail(err, MURK_BAD_FILE, path, "cannot read: %s",
                               strerror(errno));
        }
    }
    free(piece);
    close(fd);
    return status;
}

static void take_copy(void *context, const void *bytes, size_t size)
{
    (void)fwrite(bytes, 1, size, context); /* murk_file_commit() asks ferror()
                                            */
}

murk_status murk_file_copy_own(const char *path, const char *from, uint64_t max,
                               murk_error *err)
{
    murk_file *file = NULL;
    murk_status status = murk_file_create(&file, path, err);
    if (!status) {
        status = read_pieces(from, max, OWN, take_copy, file->stream, err);
    }
    if (!status) {
        status = murk_file_commit(&file, err);
    }
    murk_file_discard(file);
    return status;
}

static void take_checksum(void *context, const void *bytes, size_t size)
{
    XXH3_128bits_update(context, bytes, size);
}

static murk_status checksum(const char *path, uint64_t max, uint64_t out[2],
                            owner whose, murk_error *err)
{
    XXH3_state_t *state = XXH3_createState();
    if (!state) {
        return murk_no_memory(err, path, "to read it");
    }
    XXH3_128bits_reset(state);
    const murk_status status =
        read_pieces(path, max, whose, take_checksum, state, err);
    const XXH128_hash_t hash = XXH3_128bits_digest(state);
    out[0] = hash.low64;
    out[1] = hash.high64;
    XXH3_freeState(state);
    return status;
}

murk_status murk_file_checksum(const char *path, uint64_t max, uint64_t out[2],
                               murk_error *err)
{
    const murk_memory_file *file = murk_memory_at(path);
    if (file) {
        memcpy(out, file->checksum, sizeof file->checksum);
        return MURK_OK;
    }
    return murk_memory_is(path)
               ? murk_fail(err, MURK_BAD_FILE, path,
                           "no array of that name was added to the scene; the "
                           "program that made the scene had one")
               : checksum(path, max, out, INPUT, err);
}

murk_status murk_file_checksum_own(const char *path, uint64_t max,
                                   uint64_t out[2], murk_error *err)
{
    return checksum(path, max, out, OWN, err);
}

/* Whole blocks go to the SHA instructions, if the machine has them and no part
 * of a block waits in the state; libmd takes the rest, and the padding. */
static void take_sha256(void *context, const void *bytes, size_t size)
{
    SHA2_CTX *state = context;
    size_t done = 0;
    if (state->bitcount[0] / 8 % SHA256_BLOCK_LENGTH == 0 &&
        murk_sha256_has_blocks()) {
        const size_t blocks = size / SHA256_BLOCK_LENGTH;
        murk_sha256_blocks(state->state.st32, bytes, blocks);
        done = blocks * SHA256_BLOCK_LENGTH;
        state->bitcount[0] += 8 * (uint64_t)done;
    }
    SHA256Update(state, (const unsigned char *)bytes + done, size - done);
}

murk_status murk_file_sha256(const char *path, char out[65], murk_error *err)
{
    SHA2_CTX state;
    SHA256Init(&state);
    const murk_status status =
        read_pieces(path, UINT64_MAX, OWN, take_sha256, &state, err);
    SHA256End(&state, out);
    return status;
}
