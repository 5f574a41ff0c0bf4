/* Memory of the machine as the operating system reports it: /proc/meminfo and
 * the limits and usage of the process and of its control groups. */
#include "base/machine.h"

#include "base/memory_group.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

/* The size of a huge page of x86 and of most ARM machines. */
#define HUGE_PAGE ((uintptr_t)1 << 21)

/* Advices of Linux, the second one of 6.1 and later, which earlier ones refuse.
 * The headers of the C library may lack the names. */
#ifndef MADV_HUGEPAGE
#define MADV_HUGEPAGE 14
#endif
#ifndef MADV_COLLAPSE
#define MADV_COLLAPSE 25
#endif

double murk_machine_address_bytes(void)
{
    struct rlimit limit;
    return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY
               ? (double)limit.rlim_cur
               : INFINITY;
}

double murk_machine_memory_bytes(void)
{
    double bytes = INFINITY;
    FILE *file = fopen("/proc/meminfo", "r");
    if (file) {
        char line[128];
        double kilobytes = 0;
        while (fgets(line, sizeof line, file)) {
            if (sscanf(line, "MemAvailable: %lf kB", &kilobytes) == 1) {
                bytes = kilobytes * 1024;
            }
        }
        fclose(file);
    }
    bytes = fmin(bytes, murk_machine_address_bytes());
    return fmin(bytes,
                murk_memory_group_bytes("/proc/self/cgroup", "/sys/fs/cgroup"));
}

double murk_machine_peak_bytes(void)
{
    struct rusage usage;
    return getrusage(RUSAGE_SELF, &usage) == 0 ? (double)usage.ru_maxrss * 1024
                                               : NAN;
}

void murk_machine_drop(void *memory, size_t bytes)
{
#ifdef MADV_DONTNEED
    const uintptr_t page = (uintptr_t)sysconf(_SC_PAGESIZE);
    const uintptr_t first = ((uintptr_t)memory + page - 1) / page * page;
    const uintptr_t end = ((uintptr_t)memory + bytes) / page * page;
    if (memory && first < end) {
        (void)madvise((void *)first, end - first, MADV_DONTNEED);
    }
#else
    (void)memory;
    (void)bytes;
#endif
}

/* Gives the operating system an advice about the huge pages that lie wholly
 * within the memory. */
static void advise(void *memory, size_t bytes, int advice)
{
#if defined(__linux__) && defined(MADV_DONTNEED)
    const uintptr_t page = HUGE_PAGE;
    const uintptr_t first = ((uintptr_t)memory + page - 1) / page * page;
    const uintptr_t end = ((uintptr_t)memory + bytes) / page * page;
    if (memory && first < end) {
        (void)madvise((void *)first, end - first, advice);
    }
#else
    (void)memory;
    (void)bytes;
    (void)advice;
#endif
}

void murk_machine_use_huge_pages(void *memory, size_t bytes)
{
    advise(memory, bytes, MADV_HUGEPAGE);
}

void murk_machine_join_pages(void *memory, size_t bytes)
{
    advise(memory, bytes, MADV_COLLAPSE);
}

void murk_machine_trim(void)
{
#ifdef __GLIBC__
    (void)malloc_trim(0);
#endif
}
