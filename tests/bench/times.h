/* Times of a bench and of the reference beside it, by the clock and of the
 * processor, and the one form in which bench programs print them.
 *
 * A program prints raw times, a JSON object a line; tools/bench makes rates,
 * ratios, medians and spreads of them. */
#ifndef MURK_BENCH_TIMES_H
#define MURK_BENCH_TIMES_H

/* Repeats of each timing: the fewest whose median two outliers cannot move. */
#define BENCH_REPEATS 5

typedef struct bench_moment {
    double clock_s, cpu_s; /* cpu_s: of all threads of the process */
} bench_moment;

/* Seconds of each repeat; begin with zeros. */
typedef struct bench_times {
    double clock_s[BENCH_REPEATS], cpu_s[BENCH_REPEATS];
} bench_times;

typedef struct bench_row {
    const char *name, *unit, *reference;
    unsigned threads;
    /* Work of a repeat, in the unit's numerator: the value is work / time. 0:
     * the value is the time, and the unit is s. */
    double work, reference_work;
    const bench_times *ours, *theirs;
} bench_row;

bench_moment bench_now(void);

/* Adds the time since `begun` to a repeat. */
void bench_add(bench_times *times, int repeat, bench_moment begun);

/* The median time by the clock. */
double bench_median_s(const bench_times *times);

void bench_print(const bench_row *row);

#endif
