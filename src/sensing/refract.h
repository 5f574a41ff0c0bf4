/* Paths of light between a sensor and a photon in media of different refractive
 * indices, across one flat boundary, by Snell's law. For use inside src/sensing
 * only.
 *
 * A path goes straight from the sensor to a flat face, is refracted there
 * (sensing/snell.h), and goes straight on to the photon. The face is the plane
 * of a half space, a face of a box, or that face of a mesh at which the index
 * first changes on the straight line from the sensor to the photon. A path on
 * which the index also changes elsewhere, or changes at the boundary of a
 * sphere, is not found. There may be several paths, through different faces of
 * a box: the photon is then seen along each path, and the largest transmittance
 * counts; with detection by power the signals of all paths add up. Photons in a
 * medium of the same index as at the sensor are not treated here: for these
 * src/sensing considers the straight line only. */
#ifndef MURK_SENSING_REFRACT_H
#define MURK_SENSING_REFRACT_H

#include "medium/interfaces.h"
#include "path/viewpoint.h"
#include "sensing/snell.h"

/* The refracting boundaries of a world, prepared once. */
typedef struct murk_interfaces {
    double near_m; /* faces closer than this to each other count as one */
    bool any_mesh; /* the index inside some region that is a mesh, looked at
                      alone, is not 1 */
    size_t n, indices;
    murk_flat flat[MURK_FLATS_MAX]; /* [n] planes of half spaces and boxes */
    double index[MURK_REGIONS_MAX + 1]; /* [indices] as murk_media_indices() */
} murk_interfaces;

/* Collects the refracting boundaries of a space. */
void murk_interfaces_find(murk_interfaces *out, const murk_path_space *space);

typedef struct murk_refracted_path {
    murk_snell snell;
    murk_vec3 photon; /* the image of the photon that is nearest to the
                         sensor */
} murk_refracted_path;

/* At most three faces of a box face a point; one more is for a mesh. Further
 * paths are left out. */
#define MURK_REFRACTED_PATHS_MAX 4

/* Writes the paths to a photon in a medium of index photon_index, which differs
 * from the index at the sensor. Returns their number. *is_reflected is true if
 * there is no path and the straight line meets the first boundary, from either
 * side, at the critical angle or beyond. */
size_t murk_refracted_paths_find(
    const murk_interfaces *interfaces, const murk_path_viewpoint *sensor,
    murk_vec3 photon, double photon_index,
    murk_refracted_path path[MURK_REFRACTED_PATHS_MAX], bool *is_reflected);

/* Upper bound on the distance of objects that appear nearer than range_m,
 * directly or through a face [m]; at least range_m, may be infinite. */
double murk_refracted_paths_range(const murk_interfaces *interfaces,
                                  const murk_path_viewpoint *sensor,
                                  double range_m);

/* Over both parts of a path, before and beyond the boundary: the transmittance
 * of the media in a band; true if a surface blocks either part (thin sheets
 * block unless through_sheets); and the transmittance of thin sheets, of which
 * a sheet that lies in the boundary counts once. */
double murk_refracted_path_transmittance(const murk_refracted_path *path,
                                         const murk_path_viewpoint *sensor,
                                         int band);
bool murk_refracted_path_blocked(const murk_refracted_path *path,
                                 const murk_path_viewpoint *sensor,
                                 const murk_surfaces *surfaces,
                                 bool through_sheets);
double murk_refracted_path_sheets(const murk_refracted_path *path,
                                  const murk_path_viewpoint *sensor,
                                  const murk_surfaces *surfaces, int band);

#endif
