/* A child's death, greed or silence becomes one clear error, and nothing
 * else. */
#include "base/log.h"
#include "base/pipe.h"
#include "base/subprocess.h"
#include "check.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

static murk_status sends(murk_subprocess *child, void *context, murk_error *err)
{
    (void)err;
    const char *text = context;
    murk_status status = murk_subprocess_send(child, text, strlen(text));
    return status ? status : murk_subprocess_send(child, "!", 2);
}

static murk_status fails(murk_subprocess *child, void *context, murk_error *err)
{
    (void)child;
    (void)context;
    return murk_fail(err, MURK_BAD_VALUE, "deep.vdb", "density is -1");
}

static murk_status crashes(murk_subprocess *child, void *context,
                           murk_error *err)
{
    (void)child;
    (void)context;
    (void)err;
    raise(SIGKILL);
    return MURK_OK;
}

static murk_status exits(murk_subprocess *child, void *context, murk_error *err)
{
    (void)child;
    (void)context;
    if (!err->code) {
        _exit(3);
    }
    return MURK_OK;
}

/* A message that a reader may send if a hostile file has made it execute code:
 * its kind, and the number of bytes that it announces. */
typedef struct lie {
    uint32_t kind;
    uint64_t size;
} lie;

static murk_status lies(murk_subprocess *child, void *context, murk_error *err)
{
    const lie *l = context;
    static unsigned char bytes[sizeof *err];
    (void)err;
    memset(bytes, 'x', sizeof bytes);
    /* The pipe is the first member of the struct. */
    const int fd = *(const int *)(const void *)child;
    const murk_pipe_head head = {l->kind, MURK_OK, l->size};
    (void)murk_pipe_write(fd, &head, sizeof head);
    (void)murk_pipe_write(fd, bytes, sizeof bytes);
    volatile unsigned wait = 0;
    while (wait != 1) { /* counts in twos from 0: never 1 */
        wait += 2;
    }
    return MURK_OK;
}

static murk_status spins(murk_subprocess *child, void *context, murk_error *err)
{
    (void)child;
    (void)err;
    volatile unsigned *count = context;
    while (*count != 1) { /* counts in twos from 0: never 1 */
        *count += 2;
    }
    return MURK_OK;
}

static murk_status floods(murk_subprocess *child, void *context,
                          murk_error *err)
{
    (void)context;
    (void)err;
    static const char block[65536] = {1};
    for (int i = 0; i < 1000; ++i) {
        if (murk_subprocess_send(child, block, sizeof block)) {
            break;
        }
    }
    return MURK_OK;
}

#define ATTEMPTS 14

typedef struct attempt_context {
    char fresh[64], there[64];
    int fd;
} attempt_context;

static murk_error run(murk_subprocess_work work, void *context,
                      const murk_subprocess_limits *limits,
                      unsigned char **bytes, size_t *size)
{
    murk_error err = {0};
    *bytes = NULL;
    *size = 0;
    const murk_status status =
        murk_subprocess_run(bytes, size, work, context, limits, "a.vdb", &err);
    CHECK(status == err.code);
    return err;
}

/* What a hostile file could try through its reader. Each attempt sends one
 * letter: 'y' when it succeeded. */
static murk_status tries(murk_subprocess *child, void *context, murk_error *err)
{
    const attempt_context *c = context;
    (void)err;
    char *const arguments[] = {"true", NULL};
    char done[ATTEMPTS + 1];
    memset(done, 'n', ATTEMPTS);
    done[ATTEMPTS] = '\0';
    done[0] = open(c->fresh, O_WRONLY | O_CREAT, 0600) >= 0 ? 'y' : 'n';
    done[1] = open(c->there, O_RDWR) >= 0 ? 'y' : 'n';
    done[2] = unlink(c->there) == 0 ? 'y' : 'n';
    done[3] = rename(c->there, c->fresh) == 0 ? 'y' : 'n';
    done[4] = mkdir(c->fresh, 0700) == 0 ? 'y' : 'n';
    done[5] = symlink(c->there, c->fresh) == 0 ? 'y' : 'n';
    done[6] = socket(AF_INET, SOCK_STREAM, 0) >= 0 ? 'y' : 'n';
    done[7] = write(c->fd, "x", 1) == 1 ? 'y' : 'n'; /* the parent's file */
    done[8] = kill(getppid(), 0) == 0 ? 'y' : 'n';
    const pid_t pid = fork();
    if (pid == 0) {
        _exit(0);
    }
    done[9] = pid > 0 ? 'y' : 'n';
    done[10] = truncate(c->there, 0) == 0 ? 'y' : 'n';
    done[11] = chmod(c->there, 0) == 0 ? 'y' : 'n';
    /* and what a parser needs */
    const int fd = open(c->there, O_RDONLY | O_CLOEXEC);
    char byte = 0;
    done[12] = fd >= 0 && read(fd, &byte, 1) == 1 && byte == 'a' ? 'Y' : 'N';
    void *much = malloc(50000000);
    done[13] = much ? 'Y' : 'N';
    free(much);
    const murk_status status = murk_subprocess_send(child, done, sizeof done);
    execv("/bin/true", arguments); /* success: the end below is not sent */
    return status;
}

static int notes;

static void count_note(const char *where, const char *text)
{
    (void)where;
    notes += strstr(text, "seccomp") != NULL;
}

/* Fails without the filter, since each attempt then succeeds. A kernel
 * without the filter is mentioned in the output, and the attempts are not
 * judged. */
static void
test_hostile_readers_are_confined(const murk_subprocess_limits *limits)
{
    /* A file that exists, and the path of one that does not. */
    char folder[] = "/tmp/murk_child_XXXXXX";
    CHECK(mkdtemp(folder) != NULL);
    attempt_context c = {0};
    snprintf(c.fresh, sizeof c.fresh, "%s/fresh", folder);
    snprintf(c.there, sizeof c.there, "%s/there", folder);
    c.fd = open(c.there, O_RDWR | O_CREAT, 0600);
    CHECK(c.fd >= 0 && write(c.fd, "abc", 3) == 3);
    /* Make all attempts in a subprocess; a warning says that the kernel has
     * no filter. */
    unsigned char *bytes;
    size_t size;
    murk_warn_to(count_note);
    const murk_error err = run(tries, &c, limits, &bytes, &size);
    murk_warn_to(murk_warn_to_stderr);
    /* Every attempt failed, except those that a reader needs; the files are
     * as before. */
    if (notes > 0) {
        printf("this kernel confines nothing: not judged\n");
    } else {
        CHECK(err.code == MURK_OK);
        CHECK(bytes && size == ATTEMPTS + 1);
        CHECK_TEXT(bytes ? (const char *)bytes : "", "nnnnnnnnnnnnYY");
        struct stat is;
        CHECK(stat(c.there, &is) == 0 && is.st_size == 3);
        CHECK(stat(c.fresh, &is) != 0);
    }
    /* Clean up. */
    free(bytes);
    close(c.fd);
    unlink(c.there);
    unlink(c.fresh);
    rmdir(folder);
}

int main(void)
{
    /* The memory limit grows with the size of the file, from a minimum. */
    murk_subprocess_limits limits = murk_subprocess_limits_for(1000);
    CHECK(limits.memory_bytes == 2000000000);
    CHECK(murk_subprocess_limits_for(UINT64_C(1) << 40).memory_bytes ==
          UINT64_C(1) << 43);
    limits.seconds = 1;
    limits.handed_bytes = 1000000;
    unsigned char *bytes;
    size_t size;

    /* A result comes back. */
    char hello[] = "hello";
    murk_error err = run(sends, hello, &limits, &bytes, &size);
    CHECK(err.code == MURK_OK);
    CHECK(size == 7 && bytes && strcmp((char *)bytes, "hello!") == 0);
    free(bytes);

    /* An error of the work comes back with place and text. */
    err = run(fails, NULL, &limits, &bytes, &size);
    CHECK(err.code == MURK_BAD_VALUE && !bytes);
    CHECK_TEXT(err.where, "deep.vdb");
    CHECK_TEXT(err.text, "density is -1");

    /* A crash and an exit are a bad file. */
    err = run(crashes, NULL, &limits, &bytes, &size);
    CHECK(err.code == MURK_BAD_FILE && !bytes);
    CHECK_TEXT(err.where, "a.vdb");

    err = run(exits, NULL, &limits, &bytes, &size);
    CHECK(err.code == MURK_BAD_FILE && !bytes);
    CHECK_MENTIONS(err.text, "gave up");

    /* Work that takes too long or sends too much is ended. */
    unsigned count = 0;
    err = run(spins, &count, &limits, &bytes, &size);
    CHECK(err.code == MURK_BAD_FILE && !bytes);
    CHECK_MENTIONS(err.text, "takes more than 1 s");

    err = run(floods, NULL, &limits, &bytes, &size);
    CHECK(err.code == MURK_BAD_FILE && !bytes);
    CHECK_MENTIONS(err.text, "holds more than");

    /* An error whose bytes are all 'x' has texts that end, and a code that
     * exists. A message of unknown kind is refused at once. */
    lie end = {0x656e6421, sizeof(murk_error)}, unknown = {7, 5};
    err = run(lies, &end, &limits, &bytes, &size);
    CHECK(err.code == MURK_BAD_FILE && !bytes);
    CHECK(err.text[0] == 'x' && err.where[0] == 'x');
    err = run(lies, &unknown, &limits, &bytes, &size);
    CHECK(err.code == MURK_BAD_FILE && !bytes);
    CHECK_TEXT(err.where, "a.vdb");
    CHECK_TEXT(err.text, "malformed: its reader sent no result");

    test_hostile_readers_are_confined(&limits);
    return check_done();
}
