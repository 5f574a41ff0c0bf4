/* Paths of light from a sensor to a photon across one flat boundary between two
 * refractive indices, by Snell's law. Internal to the room.
 *
 * A path goes straight to a flat face (the plane of a half space, a face of a
 * box; of meshes the face that the straight line meets first), is refracted
 * there (sensing/snell.h), and goes straight on to the photon; the index
 * changes nowhere else. There may be several paths, through different faces of
 * a box: the photon is then seen several times, and the path of the largest
 * clarity counts. If sensor and photon lie in media of the same index, the
 * straight line is the only path. */
#ifndef MURK_SENSING_REFRACT_H
#define MURK_SENSING_REFRACT_H

#include "medium/interfaces.h"
#include "path/viewpoint.h"
#include "sensing/snell.h"

/* The refracting boundaries of a world, prepared once. */
typedef struct murk_interfaces {
    double near_m; /* faces closer than this to each other count as one */
    bool any_mesh; /* some mesh is a region with a refractive index */
    size_t n, indices;
    murk_flat flat[MURK_FLATS_MAX];
    double index[MURK_REGIONS_MAX + 1];
} murk_interfaces;

/* Collects the refracting boundaries of a space. */
void murk_interfaces_find(murk_interfaces *out, const murk_path_space *space);

typedef struct murk_refracted_path {
    murk_snell snell;
    murk_vec3 photon; /* the image of the photon that is next to the crossing */
} murk_refracted_path;

/* At most three faces of a box face a point; one more is for a mesh. */
#define MURK_REFRACTED_PATHS_MAX 4

/* Writes the paths to a photon in a medium of index photon_index, which differs
 * from the index at the sensor. Returns their number. If there is none,
 * *is_reflected tells whether the straight line meets the first boundary from
 * the denser side beyond the critical angle. */
size_t murk_refracted_paths_find(
    const murk_interfaces *interfaces, const murk_path_viewpoint *sensor,
    murk_vec3 photon, double photon_index,
    murk_refracted_path path[MURK_REFRACTED_PATHS_MAX], bool *is_reflected);

/* Upper bound on the distance of objects that appear nearer than range_m
 * through a face [m]; may be infinite. */
double murk_refracted_paths_range(const murk_interfaces *interfaces,
                                  const murk_path_viewpoint *sensor,
                                  double range_m);

/* Both parts of a path together: transmittance of the media, test against
 * surfaces, and transmittance of thin sheets. A surface that lies in the
 * boundary counts once. */
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
