/* Axes of plots: where a value lies, where ticks stand and what they say. */
#ifndef MURK_REPORT_CHART_AXIS_H
#define MURK_REPORT_CHART_AXIS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#define MURK_TICKS_MAX 16

typedef enum murk_axis_scale {
    MURK_SCALE_EVEN,
    MURK_SCALE_LOG,   /* what is not above 0 has no place */
    MURK_SCALE_WHOLE, /* counts: ticks at whole numbers */
    MURK_SCALE_SHARE, /* 0..1, shown in per cent */
    MURK_SCALE_CLOCK  /* hours of a day, shown as 06:00 */
} murk_axis_scale;

typedef struct murk_axis {
    double low, high; /* in the middle of it logarithms, for MURK_SCALE_LOG */
    double from, to;  /* on the drawing */
    murk_axis_scale scale;
} murk_axis;

/* An axis of nothing yet, to be widened; from..to on the drawing. */
murk_axis murk_axis_of(double from, double to, murk_axis_scale scale);

/* So that the value, where it has a place, lies on it. */
void murk_axis_widen(murk_axis *axis, double value);

/* Room about a single value; and about the ends, in shares of the length. */
void murk_axis_close(murk_axis *axis, double room);

/* What is beyond lies at the end; finite for any value but NaN. */
double murk_axis_place(const murk_axis *axis, double value);

/* At round numbers: 1, 2 or 5 times powers of ten, or whole parts of a day.
 * *step: between two of them, 0 for logarithms. */
size_t murk_axis_ticks(double out[MURK_TICKS_MAX], double *step,
                       const murk_axis *axis);

/* A tick's number, with as many digits as the step needs; powers of ten from
 * 10^5 on and below 10^-4. */
void murk_axis_write(FILE *to, const murk_axis *axis, double value,
                     double step);

#endif
