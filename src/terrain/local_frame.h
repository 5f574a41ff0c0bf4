/* The local frame of a scene on the earth: the transverse Mercator projection
 * of the WGS84 ellipsoid whose scale is 1 along the meridian of a point, and
 * which has its origin at that point. Distances on the map are those on the
 * ellipsoid within 5e-9 of themselves 0.6 km from the meridian and 1.2e-6 of
 * themselves 10 km from it, whereas the scale of the UTM grid is off by 4e-4 at
 * its own meridian.
 *
 * Method: the series of Krueger in powers of the third flattening, up to the
 * sixth. Source: C. F. F. Karney, J. Geodesy 85 (2011) 475,
 * doi:10.1007/s00190-011-0445-3, eqs. 7 to 11, 35 and 36. */
#ifndef MURK_TERRAIN_LOCAL_FRAME_H
#define MURK_TERRAIN_LOCAL_FRAME_H

#include <stdbool.h>

/* Largest coordinate in a local frame [m]. Within it the error of the series is
 * a few nanometres (Karney 2011, table 1 and fig. 2), and a map of the ground
 * without the curvature of the earth has ended to make sense long before. */
#define MURK_LOCAL_MAX_M 2e6

typedef struct murk_local_frame {
    double latitude_deg, longitude_deg; /* of the origin; north and east are
                                         * positive */
    double north[2]; /* unit vector of north at the origin, in the frame */
    double origin;   /* rectifying latitude of the origin [rad] */
} murk_local_frame;

/* The frame about a point. north_x and north_y, of which one is not 0, tell in
 * which direction of the frame north is; east is 90 degrees clockwise of it. */
murk_local_frame murk_local_frame_at(double latitude_deg, double longitude_deg,
                                     double north_x, double north_y);

/* Converts a geographic position to the frame: at_m[2]. False if a coordinate
 * is more than MURK_LOCAL_MAX_M from the origin, or is no number. */
bool murk_local_from_geographic(const murk_local_frame *frame,
                                double latitude_deg, double longitude_deg,
                                double at_m[2]);

/* The inverse. Longitudes are -180..180 degrees. Coordinates must not be more
 * than MURK_LOCAL_MAX_M from the origin. */
void murk_geographic_from_local(const murk_local_frame *frame,
                                const double at_m[2], double *latitude_deg,
                                double *longitude_deg);

#endif
