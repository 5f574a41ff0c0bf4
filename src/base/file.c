#include "base/file.h"

#include <errno.h>
#include <fcntl.h>
#include <sha256.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#define PIECE_BYTES ((size_t)1 << 20)

struct murk_file {
    FILE *stream;
    char *path, *temporary;
};

static char *join(const char *a, const char *b)
{
    char *out = malloc(strlen(a) + strlen(b) + 1);
    if (out) {
        strcpy(out, a);
        strcat(out, b);
    }
    return out;
}

/* The folder entry itself reaches the disk only with the folder. Failure is
 * no failure of the file: some file systems refuse it. */
static void sync_folder_of(const char *path)
{
    char *folder = murk_path_beside(path, ".");
    const int fd = folder ? open(folder, O_RDONLY | O_DIRECTORY) : -1;
    if (fd >= 0) {
        (void)fsync(fd);
        close(fd);
    }
    free(folder);
}

/* Fails with "WHAT: REASON", or with the name of the folder that would hold
 * `made` where nothing may be written into that folder. */
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
    if (!file || !(file->path = join(path, "")) ||
        !(file->temporary = join(path, ".tmp.XXXXXX"))) {
        status = murk_fail(err, MURK_NO_MEMORY, path, "no memory to open it");
        goto done;
    }
    if (stat(path, &known) == 0 && !S_ISREG(known.st_mode)) {
        status = murk_fail(err, MURK_RUN_FAILED, path,
                           "cannot write: not a regular file");
        goto done;
    }
    fd = mkstemp(file->temporary);
    if (fd < 0) {
        status = cannot_make("cannot write", path, path, errno, err);
        free(file->temporary);
        file->temporary = NULL;
        goto done;
    }
    const mode_t mask = umask(0); /* mkstemp gives 0600: back to the usual */
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
    const int failed = ferror(file->stream) | fflush(file->stream) |
                       fsync(fileno(file->stream));
    const int reason = errno;
    const int not_closed = fclose(file->stream);
    file->stream = NULL;
    murk_status status = MURK_OK;
    if (failed || not_closed) {
        status = murk_fail(err, MURK_RUN_FAILED, file->path, "cannot write: %s",
                           reason ? strerror(reason)
                                  : "an error while writing (disk full?)");
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
    (void)fwrite(bytes, 1, size, file->stream); /* commit asks ferror */
    return murk_file_commit(&file, err);
}

/* Opens a regular file of at most `most` bytes for reading. */
static murk_status open_regular(int *out, struct stat *info, uint64_t most,
                                const char *path, murk_error *err)
{
    /* not blocking, so that a pipe without a writer cannot hang us */
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
    if ((uintmax_t)info->st_size > most) {
        close(fd);
        return murk_fail(err, MURK_BAD_FILE, path,
                         "%.4g MB, must be at most %.4g MB",
                         (double)info->st_size / 1e6, (double)most / 1e6);
    }
    *out = fd;
    return MURK_OK;
}

murk_status murk_file_read(char **out, size_t *size, const char *path,
                           size_t most, murk_error *err)
{
    char *bytes = NULL;
    struct stat info;
    int fd = -1;
    murk_status status = open_regular(&fd, &info, most, path, err);
    if (status) {
        return status;
    }
    const size_t length = (size_t)info.st_size;
    bytes = malloc(length + 1);
    if (!bytes) {
        status = murk_fail(err, MURK_NO_MEMORY, path, "no memory to read it");
        goto done;
    }
    size_t got = 0;
    while (got < length) {
        const ssize_t n = read(fd, bytes + got, length - got);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            status = murk_fail(err, MURK_BAD_FILE, path, "cannot read: %s",
                               n < 0 ? strerror(errno) : "it grew shorter");
            goto done;
        }
        got += (size_t)n;
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

murk_status murk_folder_make(const char *path, murk_error *err)
{
    char *part = join(path, "/");
    if (!part) {
        return murk_fail(err, MURK_NO_MEMORY, path, "no memory for its name");
    }
    /* make each folder on the way that is not there yet */
    int refusal = 0;
    for (char *slash = strchr(part + 1, '/'); slash && !refusal;
         slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        refusal = mkdir(part, 0777) == 0 || errno == EEXIST ? 0 : errno;
        *slash = refusal ? '\0' : '/'; /* `part` ends where it is refused */
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

char *murk_path_beside(const char *beside, const char *path)
{
    const char *slash = strrchr(beside, '/');
    if (path[0] == '/' || !slash) {
        return join(path, "");
    }
    const size_t folder = (size_t)(slash - beside) + 1;
    char *out = malloc(folder + strlen(path) + 1);
    if (out) {
        memcpy(out, beside, folder);
        strcpy(out + folder, path);
    }
    return out;
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

murk_status murk_file_checksum(const char *path, uint64_t most, uint64_t out[2],
                               murk_error *err)
{
    struct stat info;
    int fd = -1;
    murk_status status = open_regular(&fd, &info, most, path, err);
    if (status) {
        return status;
    }
    XXH3_state_t *state = XXH3_createState();
    unsigned char *piece = malloc(PIECE_BYTES);
    if (!state || !piece) {
        status = murk_fail(err, MURK_NO_MEMORY, path, "no memory to read it");
        goto done;
    }
    XXH3_128bits_reset(state);
    ssize_t n;
    while ((n = read(fd, piece, PIECE_BYTES)) != 0) {
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n < 0) {
            status = murk_fail(err, MURK_BAD_FILE, path, "cannot read: %s",
                               strerror(errno));
            goto done;
        }
        XXH3_128bits_update(state, piece, (size_t)n);
    }
    const XXH128_hash_t hash = XXH3_128bits_digest(state);
    out[0] = hash.low64;
    out[1] = hash.high64;
done:
    free(piece);
    XXH3_freeState(state);
    close(fd);
    return status;
}
