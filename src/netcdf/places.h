/* Internal: the part of a field that is asked for, and the places of axes of
 * longitude and latitude in the local frame of a scene. */
#ifndef MURK_NETCDF_PLACES_H
#define MURK_NETCDF_PLACES_H

#include "base/field_blocks.h"
#include "netcdf/variables.h"

/* Cuts the axes X and Y to the box of the request, with one coordinate more on
 * each side, and turns longitudes so that they surround the site. Axes in
 * degrees need a frame. Fails with MURK_BAD_FILE, MURK_BAD_VALUE (also if
 * nothing is inside of the box) or MURK_NO_MEMORY. */
murk_status murk_netcdf_cut(murk_netcdf_reader *r);

/* Converts grid lines of longitude and latitude to x and y in the frame, and
 * heights above the sea to those above z = 0. A line of longitude has the x in
 * the middle of the range that its points have, a line of latitude such a y;
 * *off_m is the largest distance of a crossing from the place it has on the
 * earth, 0 for axes in metres. Fails with MURK_BAD_FILE if this distance
 * is more than half a cell, or with MURK_NO_MEMORY. */
murk_status murk_netcdf_place(murk_netcdf_reader *r, murk_field_block *block,
                              double *off_m);

#endif
