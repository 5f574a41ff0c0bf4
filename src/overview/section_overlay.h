/* What a view of the picture of murk check shows beside surfaces: bounds of
 * media and zones, the domain, light sources, sensors, cameras and targets; and
 * the symbols of the legend. */
#ifndef MURK_OVERVIEW_SECTION_OVERLAY_H
#define MURK_OVERVIEW_SECTION_OVERLAY_H

#include "overview/section_request.h"

/* Planes of the other views; no other thing has this colour. */
#define MURK_SECTION_MARK ((murk_ink){{190, 0, 110}, 1})

typedef enum murk_section_symbol {
    MURK_SYMBOL_NONE,
    MURK_SYMBOL_SCALE, /* drawn by the caller */
    MURK_SYMBOL_NORTH,
    MURK_SYMBOL_WALL,
    MURK_SYMBOL_SHEET,
    MURK_SYMBOL_SOLID,
    MURK_SYMBOL_BEYOND,
    MURK_SYMBOL_MEDIUM,
    MURK_SYMBOL_REGION,
    MURK_SYMBOL_DOMAIN,
    MURK_SYMBOL_LAMP,
    MURK_SYMBOL_SUN,
    MURK_SYMBOL_CANDIDATE,
    MURK_SYMBOL_SENSOR,
    MURK_SYMBOL_AVOID,
    MURK_SYMBOL_WITHIN,
    MURK_SYMBOL_CAMERA,
    MURK_SYMBOL_TARGET,
    MURK_SYMBOL_INTEREST,
    MURK_SYMBOL_MARK
} murk_section_symbol;

/* Draws the symbol of a line of the legend around a place, at most 32 pixels
 * wide at unit 1. */
void murk_section_draw_symbol(murk_canvas *canvas, murk_section_symbol symbol,
                              const double middle[2], double unit,
                              murk_vec3 north);

/* Draws text on white paper, from a place on the base line. */
void murk_section_draw_label(murk_canvas *canvas, double x, double y,
                             double unit, murk_ink ink, const char *text);

/* Draws the domain and the bounds of media, zones and regions of interest,
 * which lie below the surfaces of the cut. */
void murk_section_draw_bounds(murk_canvas *canvas,
                              const murk_section_view *view,
                              const murk_section_request *request, double unit);

/* Draws targets, candidates, sensors, cameras, light sources and the names of
 * media. */
void murk_section_draw_items(murk_canvas *canvas, const murk_section_view *view,
                             const murk_section_request *request, double unit);

#endif
