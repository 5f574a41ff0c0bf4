/* Plots as inline SVG: lines with bands, points with whiskers, axes, a legend.
 *
 * They need no script, scale with the page and print. Colours and strokes are
 * the page's style sheet's, by class: series 0 to 7, each with a mark of its
 * own shape. What is drawn is also said in words, for who does not see it. */
#ifndef MURK_REPORT_CHART_H
#define MURK_REPORT_CHART_H

#include "report/chart_axis.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#define MURK_CHART_SERIES_MAX 8
#define MURK_CHART_POINTS_MAX \
    2000 /* of a series; more are drawn evenly chosen */

typedef struct murk_chart_series {
    const char *name;
    size_t n;
    const double *x, *y;      /* [n]; where one is not finite, a line breaks */
    const double *low, *high; /* [n] or NULL: a band about a line, whiskers of
                                 points */
    bool is_line;
} murk_chart_series;

typedef struct murk_chart {
    const char *title; /* also what is read out */
    const char *x_title, *y_title;
    const char *const *x_name; /* [x_names] of x = 0, 1, ..; NULL: numbers */
    size_t x_names;
    murk_axis_scale x, y;
    const double *y_line; /* [y_lines] drawn across */
    size_t y_lines;
} murk_chart;

/* Draws nothing where no point is finite. */
void murk_chart_draw(FILE *to, const murk_chart *chart,
                     const murk_chart_series *series, size_t n);

#endif
