/* A GeoTIFF file of elevations: the heights of a band, and the places of its
 * points on the earth.
 *
 * Points are the middles of pixels, counted by column and row from 0; between
 * them are fractions. Whether the file states the corners of pixels or their
 * middles makes no difference here. Longitudes and latitudes are those of
 * WGS84. */
#ifndef MURK_GDAL_READ_H
#define MURK_GDAL_READ_H

#include "base/status.h"
#include "terrain/geotiff_request.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_gdal_file murk_gdal_file;

/* Sets the library up for files that nobody trusts: one format, no network, no
 * files beside the one that is read. Once, before the process is confined. */
void murk_gdal_begin(void);

/* Opens the file of a request, which must outlive *out. The caller closes *out
 * with murk_gdal_close(). Fails with MURK_BAD_FILE or MURK_BAD_VALUE at
 * request->where. */
murk_status murk_gdal_open(murk_gdal_file **out,
                           const murk_geotiff_request *request,
                           murk_error *err);
void murk_gdal_close(murk_gdal_file *file); /* NULL is fine */

/* Facts of the whole file; the heights have not been read. */
murk_status murk_gdal_facts(const murk_gdal_file *file, murk_terrain_facts *out,
                            murk_error *err);

/* The part of the file that a request asks for. */
typedef struct murk_gdal_window {
    size_t column, row;   /* the first ones */
    size_t columns, rows; /* at least 2 */
} murk_gdal_window;

murk_status murk_gdal_window_of(const murk_gdal_file *file,
                                murk_gdal_window *out, murk_error *err);

/* Reads heights above that of z = 0, in metres, [rows][columns], into height_m;
 * NAN: missing. Counts the others and finds their range in *facts. */
murk_status murk_gdal_heights(const murk_gdal_file *file,
                              const murk_gdal_window *window, double *height_m,
                              murk_terrain_facts *facts, murk_error *err);

/* Converts n places, columns in x and rows in y, to the coordinates of the
 * request's frame. */
murk_status murk_gdal_places(const murk_gdal_file *file, double *x, double *y,
                             size_t n, murk_error *err);

#endif
