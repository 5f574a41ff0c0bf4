/* Creates, locks and removes staged files.
 *
 * Creating and locking are two steps. Between them another run may find the new
 * file without a lock and remove it as a leftover. Therefore the creator checks
 * after locking that the name still leads to the locked file, and tries again
 * otherwise.
 *
 * On a file system without locks (some network file systems) nothing is locked,
 * and of the files of other runs nothing is removed. */
#include "base/staging.h"

#include "base/path.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#define PREFIX  ".murk.staged."
#define UNIQUE  6 /* length of the random end of a name, by mkstemp() */
#define LOCK    ".lock"
#define MOVING  ".moving"
#define TRIES   100 /* a try fails only if another run cleans at that moment */
#define DECIMAL "0123456789"

/* ---- locks ---- */

/* Locks an open file. Returns false if another process holds the lock, or if
 * `name` no longer leads to this file. On a file system without locks only the
 * name is checked. */
static bool hold(int fd, const char *name)
{
    struct stat locked, named;
    if (flock(fd, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        return false;
    }
    return fstat(fd, &locked) == 0 && stat(name, &named) == 0 &&
           locked.st_dev == named.st_dev && locked.st_ino == named.st_ino;
}

/* True if the file can be opened and has no lock; the file is then locked until
 * *fd is closed. *fd is -1 if the file cannot be opened; otherwise the caller
 * closes it. */
static bool is_left(const char *name, int *fd)
{
    *fd = open(name, O_RDWR | O_NONBLOCK | O_CLOEXEC | O_NOFOLLOW);
    return *fd >= 0 && flock(*fd, LOCK_EX | LOCK_NB) == 0;
}

/* ---- creating ---- */

int murk_staging_file(const char *path, char **name)
{
    for (int i = 0; i < TRIES; ++i) {
        char *made = murk_path_beside(path, PREFIX "XXXXXX");
        const int fd = made ? mkstemp(made) : -1;
        if (fd < 0) {
            const int reason = made ? errno : ENOMEM;
            free(made);
            errno = reason;
            return -1;
        }
        (void)fcntl(fd, F_SETFD, FD_CLOEXEC);
        if (hold(fd, made)) {
            *name = made;
            return fd;
        }
        close(fd);
        free(made);
    }
    errno = EAGAIN;
    return -1;
}

/* Locks the new folder, of which *staging takes ownership. Returns false if the
 * file .lock cannot be made or another run has removed the folder as a
 * leftover; the caller then still owns `folder`. */
static bool lock_folder(murk_staging *staging, char *folder)
{
    char *name = murk_path_join(folder, LOCK);
    staging->folder = NULL;
    staging->lock =
        name ? open(name, O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600) : -1;
    if (staging->lock >= 0 && hold(staging->lock, name)) {
        staging->folder = folder;
    } else if (staging->lock >= 0) {
        close(staging->lock);
    }
    free(name);
    return staging->folder != NULL;
}

murk_status murk_staging_begin(murk_staging *out, const char *parent,
                               murk_error *err)
{
    for (int i = 0; i < TRIES; ++i) {
        char *folder = murk_path_join(parent, PREFIX "XXXXXX");
        if (!folder) {
            return murk_no_memory(err, parent, "for it");
        }
        if (!mkdtemp(folder)) {
            free(folder);
            break;
        }
        if (lock_folder(out, folder)) {
            return MURK_OK;
        }
        const int reason = errno;
        (void)rmdir(folder);
        free(folder);
        errno = reason;
    }
    return murk_fail(err, MURK_RUN_FAILED, parent,
                     "cannot write into the folder: %s", strerror(errno));
}

void murk_staging_moving(const murk_staging *staging)
{
    char *name = murk_path_join(staging->folder, MOVING);
    const int fd = name ? open(name, O_WRONLY | O_CREAT | O_CLOEXEC, 0600) : -1;
    if (fd >= 0) {
        (void)fsync(fd);
        close(fd);
    }
    free(name);
}

/* ---- removing ---- */

static void remove_folder(const char *folder)
{
    DIR *files = opendir(folder);
    const struct dirent *entry;
    while (files && (entry = readdir(files))) {
        char *name = murk_path_join(folder, entry->d_name);
        if (name && strcmp(entry->d_name, LOCK) != 0) {
            (void)unlink(name); /* fails for "." and ".." */
        }
        free(name);
    }
    if (files) {
        closedir(files);
    }
    /* The lock goes last, so that the folder counts as staged until the end. */
    char *lock = murk_path_join(folder, LOCK);
    if (lock) {
        (void)unlink(lock);
    }
    free(lock);
    (void)rmdir(folder);
}

void murk_staging_end(murk_staging *staging)
{
    if (staging->folder) {
        remove_folder(staging->folder);
        close(staging->lock);
        free(staging->folder);
    }
    *staging = (murk_staging){0};
}

static void clean_folder(const char *folder, bool all)
{
    int fd = -1;
    char *lock = murk_path_join(folder, LOCK),
         *moving = murk_path_join(folder, MOVING);
    if (lock && moving && (all || access(moving, F_OK) != 0)) {
        if (is_left(lock, &fd)) {
            remove_folder(folder);
        } else if (fd < 0 && errno == ENOENT) {
            (void)rmdir(folder); /* the run was killed before it could lock the
                                  * folder */
        }
    }
    if (fd >= 0) {
        close(fd);
    }
    free(lock);
    free(moving);
}

static void clean_file(const char *name)
{
    int fd = -1;
    if (is_left(name, &fd)) {
        (void)unlink(name);
    }
    if (fd >= 0) {
        close(fd);
    }
}

static bool is_staged(const char *name)
{
    const size_t length = sizeof PREFIX - 1;
    return strncmp(name, PREFIX, length) == 0 &&
           strlen(name) == length + UNIQUE;
}

/* Recognises the staged names of older versions of murk: .NAME.staged.PID and
 * .NAME.staged.PID.tmp.XXXXXX. These files had no locks: they are leftovers if
 * no process with the number PID exists. */
static bool is_old_leftover(const char *name)
{
    static const char mark[] = ".staged.";
    const char *number = NULL;
    for (const char *at = name; (at = strstr(at + 1, mark));) {
        number = at + sizeof mark - 1;
    }
    if (name[0] != '.' || !number) {
        return false;
    }
    const size_t digits = strspn(number, DECIMAL);
    const char *behind = number + digits;
    const bool is_one = digits > 0 && digits < 10 &&
                        (!*behind || (strncmp(behind, ".tmp.", 5) == 0 &&
                                      strlen(behind) == 5 + UNIQUE));
    return is_one && kill((pid_t)strtol(number, NULL, 10), 0) != 0 &&
           errno == ESRCH;
}

static bool is_folder(const char *path)
{
    struct stat known;
    return lstat(path, &known) == 0 && S_ISDIR(known.st_mode);
}

void murk_staging_clean(const char *parent, bool all)
{
    DIR *folder = opendir(parent);
    const struct dirent *entry;
    while (folder && (entry = readdir(folder))) {
        const bool is_ours = is_staged(entry->d_name);
        if (!is_ours && !is_old_leftover(entry->d_name)) {
            continue;
        }
        char *path = murk_path_join(parent, entry->d_name);
        if (path && is_ours && is_folder(path)) {
            clean_folder(path, all);
        } else if (path) {
            clean_file(path);
        }
        free(path);
    }
    if (folder) {
        closedir(folder);
    }
}

void murk_staging_visit(const char *parent,
                        void (*visit)(void *context, const char *folder),
                        void *context)
{
    DIR *folder = opendir(parent);
    const struct dirent *entry;
    while (folder && (entry = readdir(folder))) {
        char *path = is_staged(entry->d_name)
                         ? murk_path_join(parent, entry->d_name)
                         : NULL;
        if (path && is_folder(path)) {
            visit(context, path);
        }
        free(path);
    }
    if (folder) {
        closedir(folder);
    }
}
