#include "geometry/import_files.h"

#include "base/inputs.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct source {
    struct aiFile file;
    FILE *stream;
    unsigned empty_reads;
} source;

/* Assimp's PLY reader asks for ever when a header is cut short. A parser that
 * goes on at the end of the file is stuck: the child ends, and the parent
 * calls the file malformed. */
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
    struct stat is;
    return fstat(fileno(stream_of(file)), &is) == 0 ? (size_t)is.st_size : 0;
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

static struct aiFile *file_open(struct aiFileIO *io, const char *path,
                                const char *mode)
{
    (void)io, (void)mode;
    struct stat is;
    const int fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0) {
        return NULL;
    }
    source *from = calloc(1, sizeof *from);
    if (!from || fstat(fd, &is) != 0 || !S_ISREG(is.st_mode) ||
        !(from->stream = fdopen(fd, "rb"))) {
        close(fd);
        free(from);
        return NULL;
    }
    murk_inputs_add(&is);
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

struct aiFileIO murk_import_files(void)
{
    return (struct aiFileIO){.OpenProc = file_open, .CloseProc = file_close};
}
