/* Participating media and the regions that they fill: extinction, scattering,
 * free flight and optical depth.
 *
 * sigma_t(x) = density(x) * extinction_per_m. The density is 1, or the value of
 * a grid, or a function of height (profile). Media of overlapping regions add:
 * extinctions are summed, and a collision belongs to a medium in proportion to
 * extinction. A region that replaces others removes the regions listed before
 * it, inside its own shape; so does a region with an index of refraction
 * (medium/interfaces.h). The region of a grid is the box of active voxels (with
 * linear interpolation half a voxel more on each side), moved with the grid. A
 * box contains its faces at the low end of each axis and not those at the high
 * end, so boxes that share a face never count a point twice.
 *
 * Free flight and optical depth are computed exactly, region by region: in
 * grids cell by cell through the tree, in profiles layer by layer. Hence
 * transmittances multiply: T(ac) = T(ab) T(bc) for points a, b, c in a line.
 * Only murk_media_prepare_delta() changes media after their creation; otherwise
 * any number of threads may use them. */
#ifndef MURK_MEDIUM_MEDIA_H
#define MURK_MEDIUM_MEDIA_H

#include "base/bands.h"
#include "base/rng.h"
#include "base/shape.h"
#include "base/status.h"
#include "base/vector.h"
#include "medium/grid.h"
#include "medium/phase.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* More media than any scene has needed; bounds the size of tables. */
#define MURK_MEDIA_MAX 256

/* One bit of a 64-bit mask for each region (murk_inside). */
#define MURK_REGIONS_MAX 64

/* Above the index of any transparent material: germanium has 4. */
#define MURK_IOR_MAX 10

/* Boundaries of regions closer than this are one boundary, as a fraction of the
 * largest coordinate of the domain: far above rounding (some 1e-15), far below
 * the thickness of any film that rays can describe. */
#define MURK_INTERFACE_NEAR 1e-12

/* Interpolation between voxels of a grid. */
typedef enum murk_interpolation {
    MURK_NEAREST, /* constant in each voxel */
    MURK_LINEAR   /* trilinear between the centres of voxels; 0 from one voxel
                     beyond the outermost centres */
} murk_interpolation;

/* Extinction as a function of height in the region's frame: linear between
 * the heights, which rise. A height given twice is a jump. No extinction
 * below the first and above the last height. */
typedef struct murk_profile {
    size_t n; /* 2 or more */
    const double *z_m;
    const murk_spectrum *extinction_per_m;
} murk_profile;

typedef struct murk_medium {
    /* >= 0; multiplied by the density of a grid or profile */
    murk_spectrum extinction_per_m;
    murk_spectrum albedo; /* scattered / extinguished, 0..1 */
    const murk_grid
        *albedo_grid; /* not NULL: albedo at each place, the same in all bands,
                         instead of `albedo`; from murk_grid_read_albedo() */
    murk_phase phase[MURK_BANDS_MAX]; /* all zero: isotropic */
    /* Density: from the grid, or from the profile (whose values are
     * extinctions), otherwise 1. Borrowed for the lifetime of the media. */
    const murk_grid *grid;
    murk_interpolation interpolation;
    const murk_profile *profile;
    const char *where;
} murk_medium;

typedef struct murk_region {
    size_t medium;
    murk_region_shape shape;
    murk_box box; /* box; for a mesh: its bounding box in world coordinates */
    murk_vec3 center; /* sphere */
    double radius_m;
    double
        below_z_m; /* half space; in world coordinates, not moved by to_world */
    murk_affine to_world; /* moves the shape with its grids or profile. For
                             everywhere and below it moves grids only, for a
                             mesh grids or profile only: the mesh itself has
                             been moved */
    bool replaces;
    double ior; /* index of refraction, 1..MURK_IOR_MAX; 0: none. Refractive
                   regions are nested or separate (for meshes the caller checks
                   this) and have no grid as shape */
    double mean_square_slope; /* mean square slope of the waves on a half space
                                 with an index: medium/waves.h; 0: flat */
    const char *where;
} murk_region;

/* The set of regions with a boundary (an index, or a mesh) that a ray is in:
 * bit i stands for region i. Free flight and optical depth use the bits of
 * meshes only, so the part of the ray that they follow must not cross a face of
 * a mesh. For regions of other shapes the position decides. */
typedef uint64_t murk_inside;

typedef struct murk_media murk_media;

/* Places media in regions. n_regions may be 0: clear air. A region that is
 * everywhere has no bounds: the caller ends its rays at the domain. Warns of
 * regions outside of the domain, and of refractive regions inside of one that
 * is listed later. Fails with MURK_BAD_VALUE at the `where` of a medium or
 * region, or with MURK_NO_MEMORY. The array `media` is copied; grids,
 * profiles, phase tables and `where` are borrowed. The caller owns *out and
 * releases it with murk_media_destroy(). */
murk_status murk_media_create(murk_media **out, const murk_medium *media,
                              size_t n_media, const murk_region *regions,
                              size_t n_regions, const murk_box *domain,
                              murk_error *err);
void murk_media_destroy(murk_media *media); /* NULL is fine */

/* The number of media, whether regions use them or not. */
size_t murk_media_count(const murk_media *media);

/* The phase function of a medium in a band. */
const murk_phase *murk_media_phase(const murk_media *media, size_t medium,
                                   int band);

/* False if no region has a medium with an extinction above 0 in any band; a
 * medium whose grid has no active voxels, or whose profile is 0 at all heights,
 * does not count. */
bool murk_media_any(const murk_media *media);

/* Optical depth from `origin` along the unit vector `direction` over
 * length_m. */
double murk_media_optical_depth(const murk_media *media, int band,
                                murk_inside inside, murk_vec3 origin,
                                murk_vec3 direction, double length_m);

/* exp(-optical depth) between two points. */
double murk_media_transmittance(const murk_media *media, int band,
                                murk_inside inside, murk_vec3 from,
                                murk_vec3 to);

typedef struct murk_collision {
    double distance_m;
    size_t medium;           /* the medium of the collision */
    double albedo;           /* albedo of that medium in this band */
    const murk_phase *phase; /* phase function of that medium in this band */
    double scattering_per_m; /* scattering coefficient of all media at the
                                collision */
} murk_collision;

/* Free flight of a photon, which does not leave the domain: beyond the domain a
 * collision has no meaning, because boxes around the domain are taken to be
 * everywhere. Follows the ray until the optical depth reaches tau or the length
 * is used up. True, with *collision filled, if there is a collision; u in (0,
 * 1) selects the medium. */
bool murk_media_fly(const murk_media *media, int band, murk_inside inside,
                    murk_vec3 origin, murk_vec3 direction, double length_m,
                    double tau, double u, murk_collision *collision);

/* True if one homogeneous medium fills the domain: then *extinction_per_m is
 * the extinction of that medium, and *collision any collision, with distance_m
 * 0. */
bool murk_media_even(const murk_media *media, int band,
                     double *extinction_per_m, murk_collision *collision);

/* Computes the majorants per brick that murk_media_fly_delta() needs. Fails
 * with MURK_NO_MEMORY. */
murk_status murk_media_prepare_delta(murk_media *media, murk_error *err);

/* Free flight with the same distribution, by delta tracking through grids,
 * after murk_media_prepare_delta(). tau and u come from slot 0 of the address;
 * further numbers are drawn from slot 1 on. */
bool murk_media_fly_delta(const murk_media *media, int band, murk_inside inside,
                          murk_vec3 origin, murk_vec3 direction,
                          double length_m, double tau, double u,
                          const murk_address *address,
                          murk_collision *collision);

/* Extinction and scattering coefficient of all media at a point [1/m]. */
double murk_media_extinction(const murk_media *media, int band,
                             murk_inside inside, murk_vec3 p);
double murk_media_scattering(const murk_media *media, int band,
                             murk_inside inside, murk_vec3 p);

/* The part of the extinction at a point that one medium contributes [1/m]. */
double murk_media_extinction_of(const murk_media *media, size_t medium,
                                int band, murk_inside inside, murk_vec3 p);

/* Bounding box of all regions but half spaces and regions that are everywhere;
 * empty if there are none. */
murk_box murk_media_bounds(const murk_media *media);

#endif
