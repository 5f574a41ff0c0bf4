/* The times of the ceiling kdtree.c, in place of its own bench.h: one run after
 * a warm-up, as bench_kd --even has it, by the clock and of the processors. Its
 * own times need a machine that nothing else uses. Prints both as JSON, and
 * gives kdtree.c the time by the clock. */
#ifndef MURK_BENCH_CEILING_TIMES_H
#define MURK_BENCH_CEILING_TIMES_H

#include <stdio.h>
#include <time.h>

static double cpunow(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double bench_med(double (*run)(void *), void *context, int threads,
                        int *good)
{
    (void)threads;
    run(context);
    const double begun_s = cpunow();
    const double clock_s = run(context);
    printf("{\"clock_s\": %.6g, \"cpu_s\": %.6g}\n", clock_s,
           cpunow() - begun_s);
    *good = 1;
    return clock_s;
}

#endif
