/* File access for Assimp (aiFileIO): restricts which files a mesh may open, and
 * serves the mesh's own file from memory if its vertices were shifted.
 *
 * Paths are compared after realpath(), so that links cannot lead outside of
 * the allowed folders. */
#include "geometry/import_files.h"

#include "base/file.h"
#include "base/inputs.h"
#include "geometry/import_shift.h"

#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct source {
    struct aiFile file;
    FILE *stream;
    size_t size;
    unsigned empty_reads;
} source;

/* Assimp's PLY reader loops for ever if a header is truncated. A parser that
 * continues to read at the end of the file is stuck: the subprocess aborts, and
 * the parent reports a malformed file. Intact files need a handful of such
 * reads; the limit is far above that and is reached within milliseconds. */
#define EMPTY_READS_MAX 1000

static FILE *stream_of(struct aiFile *file)
{
    return ((source *)(void *)file->UserData)->stream;
}

static size_t file_read(struct aiFile *file, char *to, size_t size, size_t n)
{
    source *from = (source *)(void *)file->UserData;
    const size_t got = fread(to, size, n, from->stream);
    from->empty_reads += got == 0;
    if (from->empty_reads > EMPTY_READS_MAX) {
        abort();
    }
    return got;
}

static size_t file_write(struct aiFile *file, const char *from, size_t size,
                         size_t n)
{
    (void)file, (void)from, (void)size, (void)n;
    return 0;
}

static size_t file_tell(struct aiFile *file)
{
    const long at = ftell(stream_of(file));
    return at < 0 ? 0 : (size_t)at;
}

static size_t file_size(struct aiFile *file)
{
    return ((source *)(void *)file->UserData)->size;
}

static enum aiReturn file_seek(struct aiFile *file, size_t to,
                               enum aiOrigin from)
{
    const int whence = from == aiOrigin_SET   ? SEEK_SET
                       : from == aiOrigin_CUR ? SEEK_CUR
                                              : SEEK_END;
    return fseek(stream_of(file), (long)to, whence) == 0 ? aiReturn_SUCCESS
                                                         : aiReturn_FAILURE;
}

static void file_flush(struct aiFile *file)
{
    (void)file;
}

/* Opens a regular file; NULL for anything else. */
static FILE *open_regular(const char *path, size_t *size)
{
    struct stat is;
    FILE *stream = NULL;
    const int fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (fd >= 0 && fstat(fd, &is) == 0 && S_ISREG(is.st_mode)) {
        stream = fdopen(fd, "rb");
    }
    if (stream) {
        *size = (size_t)is.st_size;
        murk_inputs_add(fd);
    } else if (fd >= 0) {
        close(fd);
    }
    return stream;
}

/* True if `path` lies in `folder`; both have no links. An empty folder
 * contains nothing. */
static bool is_in(const char *path, const char *folder)
{
    const size_t n = strlen(folder);
    const bool is_root = strcmp(folder, "/") == 0;
    return n > 0 && strncmp(path, folder, n) == 0 &&
           (is_root || path[n] == '/');
}

/* True if the access rules allow the file; remembers the first refused file
 * for the message. */
static bool may_open(murk_import_access *access, const char *real)
{
    if (strcmp(real, access->mesh) == 0 || is_in(real, access->folder) ||
        is_in(real, access->allowed)) {
        return true;
    }
    if (!access->refused[0]) {
        memcpy(access->refused, real, strlen(real) + 1);
    }
    return false;
}

static void access_of(murk_import_access *out, const char *mesh,
                      const char *allow)
{
    *out = (murk_import_access){0};
    char folder[PATH_MAX];
    const char *slash = strrchr(mesh, '/');
    const size_t n = slash ? (size_t)(slash - mesh) : 0;
    if (n >= sizeof folder) {
        return;
    }
    /* The folder of the path as the user wrote it; the mesh itself may be a
     * link into another folder. */
    memcpy(folder, mesh, n);
    folder[n] = '\0';
    if (!realpath(n > 0 ? folder : slash ? "/" : ".", out->folder)) {
        out->folder[0] = '\0';
    }
    if (!realpath(mesh, out->mesh)) {
        out->mesh[0] = '\0';
    }
    if (allow && !realpath(allow, out->allowed)) {
        out->allowed[0] = '\0';
    }
}

/* Opens the mesh or a file that the mesh names; NULL if the file does not
 * exist, is not allowed or is no regular file. */
static FILE *open_named(murk_import_access *access, const char *path,
                        size_t *size)
{
    char real[PATH_MAX];
    return realpath(path, real) && may_open(access, real)
               ? open_regular(real, size)
               : NULL;
}

static struct aiFile *file_open(struct aiFileIO *io, const char *path,
                                const char *mode)
{
    (void)mode;
    murk_import_source *own = (void *)io->UserData;
    /* A rewritten mesh is served from memory, any other file from the disk. */
    const bool is_mesh = strcmp(path, own->path) == 0;
    const bool is_own = own->bytes && is_mesh;
    own->names_others = own->names_others || !is_mesh;
    source *from = calloc(1, sizeof *from);
    if (!from) {
        return NULL;
    }
    from->size = own->size;
    from->stream = is_own ? fmemopen(own->bytes, own->size, "rb")
                          : open_named(&own->access, path, &from->size);
    if (!from->stream) {
        free(from);
        return NULL;
    }
    /* Assimp works with a table of functions. */
    from->file = (struct aiFile){.ReadProc = file_read,
                                 .WriteProc = file_write,
                                 .TellProc = file_tell,
                                 .FileSizeProc = file_size,
                                 .SeekProc = file_seek,
                                 .FlushProc = file_flush,
                                 .UserData = (aiUserData)(void *)from};
    return &from->file;
}

static void file_close(struct aiFileIO *io, struct aiFile *file)
{
    (void)io;
    fclose(stream_of(file));
    free(file->UserData);
}

void murk_import_source_of(murk_import_source *out, const char *path,
                           const char *allow)
{
    *out = (murk_import_source){.path = path};
    access_of(&out->access, path, allow);
    char *bytes = NULL;
    size_t size = 0;
    if (murk_import_may_shift(path) &&
        murk_file_read(&bytes, &size, path, SIZE_MAX, NULL) == MURK_OK &&
        !murk_import_shift(path, bytes, size, &out->bytes, &out->size,
                           out->shift)) {
        memset(out->shift, 0, sizeof out->shift);
    }
    free(bytes);
}

struct aiFileIO murk_import_files(murk_import_source *own)
{
    return (struct aiFileIO){.OpenProc = file_open,
                             .CloseProc = file_close,
                             .UserData = (aiUserData)(void *)own};
}
