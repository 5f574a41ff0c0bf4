/* A field over two axes as inline SVG, in colours from dark (little) to bright
 * (much), with a legend. */
#ifndef MURK_REPORT_CHART_HEAT_H
#define MURK_REPORT_CHART_HEAT_H

#include "report/chart_axis.h"

/* Cells along an axis at most; a field of more is to be thinned before. */
#define MURK_HEAT_MAX 128

typedef struct murk_heat {
    const char *title;
    const char *x_title, *y_title, *value_title; /* with their units */
    double x[2], y[2];                           /* the edges of the field */
    size_t size[2];      /* cells along x and y, 1..MURK_HEAT_MAX */
    const double *value; /* [size[0] * size[1]], x fastest, y upwards; NaN:
                            nothing is known there */
    double min, max;     /* the legend's range; NaN: that of the values */
    bool is_log;         /* cells that are not above 0 are left blank */
    bool is_equal;       /* both axes are lengths: drawn to one scale */
} murk_heat;

/* Draws nothing where no cell is finite. */
void murk_heat_draw(FILE *to, const murk_heat *heat);

#endif
