/* Clocks of the benches, and the writer of their lines. */
#include "times.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double seconds_of(clockid_t id)
{
    struct timespec t;
    clock_gettime(id, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

bench_moment bench_now(void)
{
    return (bench_moment){seconds_of(CLOCK_MONOTONIC),
                          seconds_of(CLOCK_PROCESS_CPUTIME_ID)};
}

void bench_add(bench_times *times, int repeat, bench_moment begun)
{
    const bench_moment end = bench_now();
    times->clock_s[repeat] += end.clock_s - begun.clock_s;
    times->cpu_s[repeat] += end.cpu_s - begun.cpu_s;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double bench_median_s(const bench_times *times)
{
    bench_times sorted = *times;
    qsort(sorted.clock_s, BENCH_REPEATS, sizeof *sorted.clock_s, ascending);
    return sorted.clock_s[BENCH_REPEATS / 2];
}

static void print_list(const char *name, const double value[BENCH_REPEATS])
{
    for (int i = 0; i < BENCH_REPEATS; ++i) {
        if (i == 0) {
            printf(", \"%s\": [%.6g", name, value[i]);
        } else {
            printf(", %.6g", value[i]);
        }
    }
    printf("]");
}

void bench_print(const bench_row *row)
{
    printf("{\"case\": \"%s\", \"threads\": %u, \"unit\": \"%s\", "
           "\"reference\": \"%s\", \"work\": %.9g, \"reference_work\": %.9g",
           row->name, row->threads, row->unit, row->reference, row->work,
           row->reference_work);
    print_list("clock_s", row->ours->clock_s);
    print_list("cpu_s", row->ours->cpu_s);
    print_list("reference_clock_s", row->theirs->clock_s);
    print_list("reference_cpu_s", row->theirs->cpu_s);
    printf("}\n");
    fflush(stdout);
}
