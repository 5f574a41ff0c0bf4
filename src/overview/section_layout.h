/* Where views, legend and texts of the picture of murk check lie on the sheet,
 * and which part of the world the views show. */
#ifndef MURK_OVERVIEW_SECTION_LAYOUT_H
#define MURK_OVERVIEW_SECTION_LAYOUT_H

#include "overview/section_request.h"

typedef struct murk_section_layout {
    size_t width, height; /* of the sheet [pixels] */
    double unit;          /* 1 for a sheet 1600 pixels wide: sizes of letters
                           * and lines are multiples of it */
    double text;          /* height of letters */
    murk_box shown;       /* part of the world that the views show */
    bool is_part;         /* the domain is larger */
    murk_section_view view[MURK_SECTIONS];
    double legend[2]; /* upper left corner of the legend */
} murk_section_layout;

/* legend_lines: the number of lines of the legend. */
murk_section_layout
murk_section_layout_make(const murk_section_request *request,
                         size_t legend_lines);

#endif
