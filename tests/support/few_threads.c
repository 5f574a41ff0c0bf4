/* Preloaded into the program (LD_PRELOAD): a machine on which only the first
 * FEW_THREADS threads can be started, as under ulimit -u. Without FEW_THREADS
 * all can. The number that was asked for goes to the file THREADS_ASKED at the
 * end of the program. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static atomic_int asked;

int pthread_create(pthread_t *thread, const pthread_attr_t *attributes,
                   void *(*start)(void *), void *argument)
{
    int (*real)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);
    void *symbol = dlsym(RTLD_NEXT, "pthread_create");
    memcpy(&real, &symbol, sizeof real); /* ISO C has no cast for it */
    const char *few = getenv("FEW_THREADS");
    const int before = atomic_fetch_add(&asked, 1);
    return few && before >= atoi(few)
               ? EAGAIN
               : real(thread, attributes, start, argument);
}

__attribute__((destructor)) static void say(void)
{
    const char *path = getenv("THREADS_ASKED");
    FILE *to = path ? fopen(path, "w") : NULL;
    if (to) {
        fprintf(to, "%d\n", atomic_load(&asked));
        fclose(to);
    }
}
