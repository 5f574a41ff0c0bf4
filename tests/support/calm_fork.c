/* Lets a sanitized program fork safely: linked into all of them, and into
 * nothing else.
 *
 * The allocators of the sanitizers, unlike glibc's, are not made ready for
 * fork(): a child inherits the locks that other threads hold at that moment,
 * and then waits for them for ever. murk forks while it has no threads of its
 * own, but log4cplus (which OpenVDB loads) starts four when the program
 * starts, and a fork soon after meets them in their first calloc. So each
 * fork() waits here until all other threads sleep. */
#define _GNU_SOURCE /* pthread_setattr_default_np */
#include <dirent.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define LONGEST_WAIT_MS 5000 /* a thread that never sleeps is let be */

/* The state is the letter after the program's name, which ends in ')'. */
static bool sleeps(const char *thread)
{
    char path[300], line[300] = "";
    snprintf(path, sizeof path, "/proc/self/task/%s/stat", thread);
    FILE *stat = fopen(path, "r");
    if (!stat) {
        return true; /* has ended */
    }
    const bool is_read = fgets(line, sizeof line, stat) != NULL;
    fclose(stat);
    const char *end = is_read ? strrchr(line, ')') : NULL;
    return !end || strncmp(end, ") S", 3) == 0;
}

static bool others_sleep(void)
{
    DIR *tasks = opendir("/proc/self/task");
    if (!tasks) {
        return true;
    }
    char self[24];
    snprintf(self, sizeof self, "%ld", (long)getpid());
    bool all_sleep = true;
    const struct dirent *task;
    while (all_sleep && (task = readdir(tasks)) != NULL) {
        all_sleep = task->d_name[0] == '.' || strcmp(task->d_name, self) == 0 ||
                    sleeps(task->d_name);
    }
    closedir(tasks);
    return all_sleep;
}

/* Twice in a row: one look at the threads is not one moment. */
static void wait_for_calm(void)
{
    const struct timespec millisecond = {.tv_nsec = 1000000};
    int calm = 0;
    for (int i = 0; i < LONGEST_WAIT_MS && calm < 2; ++i) {
        calm = others_sleep() ? calm + 1 : 0;
        nanosleep(&millisecond, NULL);
    }
}

/* TSan knows threads by where their stack lies, and ends a child whose first
 * thread gets the stack that one of the parent's had. A larger stack lies
 * elsewhere. */
static void want_new_stacks(void)
{
    pthread_attr_t attributes;
    size_t size;
    if (pthread_attr_init(&attributes) == 0) {
        if (pthread_attr_getstacksize(&attributes, &size) == 0 &&
            pthread_attr_setstacksize(&attributes, 4 * size) == 0) {
            (void)pthread_setattr_default_np(&attributes);
        }
        pthread_attr_destroy(&attributes);
    }
}

__attribute__((constructor)) static void make_forks_calm(void)
{
    pthread_atfork(wait_for_calm, NULL, want_new_stacks);
}
