/* Feet laid evenly over surfaces: where something may be mounted.
 *
 * Feet lie about spacing_m apart, whatever the triangles: large ones get many,
 * of many small ones most get none. First come those on lines along the axis
 * that a face looks along most, in a square pattern that is centred in the box
 * of all that is laid over; so a wall along the axes gets rows and columns
 * spacing_m apart. Then what lies farther than 3/4 spacing_m from any foot (on
 * slanting faces and small parts) gets feet of its own. No foot is nearer to
 * another of the same surface than 3/4 spacing_m, and no place of a surface
 * farther from all of them than 1.1 spacing_m, along it.
 *
 * Feet are of the same surface when neither rises above the other's plane by
 * more than half their distance and the planes are turned by at most 60
 * degrees: the two faces of a wall, floor and wall in a corner, shelves one
 * above the other all get feet. */
#ifndef MURK_GEOMETRY_LAY_H
#define MURK_GEOMETRY_LAY_H

#include "geometry/surfaces.h"

typedef struct murk_foot {
    murk_vec3 position;
    murk_vec3 normal; /* unit, to either side */
} murk_foot;

typedef struct murk_lay {
    double spacing_m;      /* more than murk_lay_min_m() */
    murk_box within;       /* feet lie in it; it may be flat */
    const bool *materials; /* [murk_surfaces_materials()] which are laid over;
                              NULL: all */
    double min_rise, max_rise; /* of |normal.z|: 1 is level, 0 upright */
    size_t max;                /* more feet fail */
} murk_lay;

/* Spacings up to this [m] are lost in rounding. */
double murk_lay_min_m(const murk_surfaces *surfaces);

/* (*out)[*n] is the caller's: free(). Order: by pattern or not, then by the
 * order of triangles and spheres. Fails with MURK_BAD_VALUE at `where` when
 * more than `most` feet would be laid, with MURK_NO_MEMORY or
 * MURK_INTERRUPTED. */
murk_status murk_surfaces_lay(murk_foot **out, size_t *n,
                              const murk_surfaces *surfaces,
                              const murk_lay *lay, const char *where,
                              murk_error *err);

/* murk_surfaces_near() for what stands in front of a foot, at `point` on the
 * side of its normal: the surface that it is mounted on is not asked. That is
 * all that rises less than above_m over the foot's plane; faces turned by less
 * than 45 degrees that rise no steeper than they are turned, as those of a
 * tunnel do; and the sphere that the foot is on. */
bool murk_surfaces_near_mount(const murk_surfaces *surfaces, murk_vec3 point,
                              double radius_m, const murk_foot *foot,
                              double above_m);

#endif
