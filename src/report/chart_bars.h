/* Bars from the left, of one part or of several behind each other, as inline
 * SVG with names, values and, where there are errors, whiskers. */
#ifndef MURK_REPORT_CHART_BARS_H
#define MURK_REPORT_CHART_BARS_H

#include "report/chart_axis.h"

/* Rows at most; what is beyond is said. */
#define MURK_BARS_MAX 60

typedef struct murk_bars {
    const char *title, *axis_title;
    size_t rows, parts;       /* parts 1..8 */
    const char *const *name;  /* [rows] */
    const char *const *part;  /* [parts] of the legend; NULL for one part */
    const double *value;      /* [rows * parts], row by row; of several parts
                                 none is negative */
    const double *low, *high; /* [rows] or NULL: of the whole bar */
    murk_axis_scale scale;    /* not by logarithms */
} murk_bars;

/* Draws nothing where no value is finite. */
void murk_bars_draw(FILE *to, const murk_bars *bars);

#endif
