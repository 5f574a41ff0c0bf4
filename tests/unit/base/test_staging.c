/* Locks of what is being written, and the list of what was read, across
 * processes that live and that were killed. */
#define _DEFAULT_SOURCE /* mkdtemp */
#include "base/file.h"
#include "base/host.h"
#include "base/inputs.h"
#include "base/staging.h"
#include "check.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static char folder[] = "test_staging.XXXXXX";

static size_t entries(void)
{
    size_t n = 0;
    DIR *at = opendir(folder);
    while (at && readdir(at)) {
        ++n;
    }
    closedir(at);
    return n - 2; /* "." and ".." */
}

static const char *path_of(const char *name)
{
    static char path[2][64];
    static int which;
    which = !which;
    snprintf(path[which], sizeof path[which], "%s/%s", folder, name);
    return path[which];
}

static void put(const char *name)
{
    CHECK(!murk_file_write(path_of(name), "x", 1, NULL));
}

/* Starts a process that holds a staged folder with a file, and one staged
 * file beside the folder, and reports so through the pipe; the process
 * lives until it is killed. */
static pid_t hold(bool is_moving)
{
    /* A pipe for the report. */
    int ends[2];
    char word = 0;
    CHECK(pipe(ends) == 0);
    const pid_t pid = fork();
    /* The new process stages, reports, and waits. */
    if (pid == 0) {
        murk_staging staging = {0};
        char inner[96], *name = NULL;
        if (murk_staging_begin(&staging, folder, NULL)) {
            _exit(1);
        }
        snprintf(inner, sizeof inner, "%s/a.csv", staging.folder);
        if (murk_file_write(inner, "x", 1, NULL) ||
            murk_staging_file(path_of("b"), &name) < 0) {
            _exit(1);
        }
        if (is_moving) {
            murk_staging_moving(&staging);
        }
        (void)!write(ends[1], "!", 1);
        for (;;) {
            pause();
        }
    }
    /* This process returns after the report. */
    close(ends[1]);
    CHECK(read(ends[0], &word, 1) == 1);
    close(ends[0]);
    return pid;
}

static void end(pid_t pid)
{
    kill(pid, SIGKILL);
    waitpid(pid, NULL, 0);
}

static void test_held_stays_and_left_goes(void)
{
    const pid_t pid = hold(false);
    CHECK(entries() == 2);
    murk_staging_clean(folder, true);
    CHECK(entries() == 2);
    end(pid);
    CHECK(entries() == 2);
    murk_staging_clean(folder, false);
    CHECK(entries() == 0);
}

static void test_moving_stays_until_all_go(void)
{
    end(hold(true));
    murk_staging_clean(folder, false);
    CHECK(entries() == 1);
    murk_staging_clean(folder, true);
    CHECK(entries() == 0);
}

static void test_only_leftovers_go(void)
{
    static const char *const mine[] = {".murk.staged.abc",   ".murk.staged",
                                       "murk.staged.abcdef", ".x.staged.y",
                                       ".staged.12",         "x.staged.1"};
    for (size_t i = 0; i < sizeof mine / sizeof *mine; ++i) {
        put(mine[i]);
    }
    char living[64];
    snprintf(living, sizeof living, ".x.csv.staged.%ld", (long)getpid());
    put(living);
    put(".x.csv.staged.999999999"); /* above any process number */
    put(".x.csv.staged.999999999.tmp.a1B2c3");
    put(".murk.staged.abcdef");
    murk_staging_clean(folder, false);
    CHECK(entries() == 7);
    for (size_t i = 0; i < sizeof mine / sizeof *mine; ++i) {
        CHECK(unlink(path_of(mine[i])) == 0);
    }
    CHECK(unlink(path_of(living)) == 0);
}

static void test_inputs_by_any_name_and_process(void)
{
    put("in");
    put("other");
    const int known = open(path_of("in"), O_RDONLY);
    CHECK(known >= 0);
    murk_inputs_add(known);
    CHECK(!murk_inputs_has(path_of("in"))); /* nobody has begun the list */
    murk_inputs_begin();
    const pid_t pid = fork();
    if (pid == 0) {
        murk_inputs_add(known);
        _exit(0);
    }
    waitpid(pid, NULL, 0);
    CHECK(close(known) == 0);
    CHECK(symlink("in", path_of("soft")) == 0);
    CHECK(link(path_of("in"), path_of("hard")) == 0);
    static const char *const names[] = {"in", "soft", "hard"};
    for (size_t i = 0; i < 3; ++i) {
        murk_error err = {0};
        CHECK(murk_inputs_has(path_of(names[i])));
        CHECK(murk_file_write(path_of(names[i]), "y", 1, &err) ==
              MURK_BAD_VALUE);
        CHECK_TEXT(err.where, path_of(names[i]));
    }
    CHECK(!murk_inputs_has(path_of("other")));
    CHECK(!murk_inputs_has(path_of("none")));
    CHECK(!murk_file_write(path_of("other"), "y", 1, NULL));
    /* what is murk's own may be read and written again */
    char *text = NULL;
    size_t size = 0;
    CHECK(!murk_file_read_own(&text, &size, path_of("other"), 9, NULL));
    CHECK(!murk_file_write(path_of("other"), "z", 1, NULL));
    free(text);
    CHECK(!murk_file_read(&text, &size, path_of("other"), 9, NULL));
    CHECK(murk_file_write(path_of("other"), "z", 1, NULL) == MURK_BAD_VALUE);
    free(text);
    CHECK(entries() == 4);
    CHECK(!unlink(path_of("in")) && !unlink(path_of("soft")) &&
          !unlink(path_of("hard")) && !unlink(path_of("other")));
}

/* A file that is made after an input was removed is no input, though it may
 * have the inode of the input: ext4 gives the inode at once. The times of files
 * advance every 10 ms at least. */
static void test_a_new_file_is_no_input(void)
{
    const struct timespec tick = {0, 20000000};
    char *text = NULL;
    size_t size = 0;
    murk_inputs_begin();
    put("in");
    CHECK(!murk_file_read(&text, &size, path_of("in"), 9, NULL));
    free(text);
    CHECK(murk_inputs_has(path_of("in")));
    CHECK(!unlink(path_of("in")));
    CHECK(!murk_inputs_has(path_of("in")));
    CHECK(nanosleep(&tick, NULL) == 0);
    put("in");
    CHECK(!murk_inputs_has(path_of("in")));
    CHECK(!unlink(path_of("in")));
    murk_inputs_end();
}

/* A full set counts every file as an input, but only until the set ends. */
static void test_a_full_set_ends(void)
{
    put("in");
    murk_inputs_begin();
    atomic_store(&murk_host_now()->inputs_are_full, true);
    CHECK(murk_inputs_has(path_of("in")));
    murk_inputs_end();
    CHECK(!murk_inputs_has(path_of("in")));
    CHECK(!unlink(path_of("in")));
}

static void test_marks(void)
{
    static const char mark[] = "made\0by";
    static const char text[] = "head made\0by murk";
    CHECK(!murk_file_write(path_of("own"), text, sizeof text, NULL));
    put("mine");
    const char *own = "own";
    CHECK(!murk_file_check_owner(path_of(own), mark, 7, false, NULL));
    CHECK(!murk_file_check_owner(path_of("none"), mark, 7, false, NULL));
    CHECK(murk_file_check_owner(path_of("mine"), mark, 7, false, NULL) ==
          MURK_BAD_VALUE);
    CHECK(!murk_file_check_owner(path_of("mine"), mark, 7, true, NULL));
    CHECK(!unlink(path_of("own")) && !unlink(path_of("mine")));
}

int main(void)
{
    CHECK(mkdtemp(folder) != NULL);
    test_held_stays_and_left_goes();
    test_moving_stays_until_all_go();
    test_only_leftovers_go();
    test_marks();
    test_inputs_by_any_name_and_process();
    test_a_new_file_is_no_input();
    test_a_full_set_ends();
    CHECK(rmdir(folder) == 0);
    return check_failures != 0;
}
