/* Participating media in their places: what a photon meets between surfaces.
 *
 * sigma_t(x) = density(x) * extinction_per_m. Density is 1, or a grid's, or a
 * profile's by height. Media of overlapping regions add
 * (extinctions sum, the partner of a collision is drawn in proportion to its
 * extinction), except that a region that replaces takes the place of those
 * listed before it; one with an index of refraction replaces, too
 * (medium/interfaces.h). A grid's region is the box of its active voxels, moved
 * with it. Lower faces belong to a region, upper ones do not, so that regions
 * that share a face never count twice.
 *
 * Free flight and optical depth march exactly, region by region, in grids cell
 * by cell through the tree, in profiles layer by layer, so that
 * T(ac) = T(ab) T(bc). Immutable after creation: any number of threads. */
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

#define MURK_MEDIA_MAX   256
#define MURK_REGIONS_MAX 64
#define MURK_IOR_MAX     10

/* Between a grid's voxels. */
typedef enum murk_interpolation {
    MURK_NEAREST, /* a voxel has one value throughout */
    MURK_LINEAR   /* trilinear between the voxels' centres; 0 from one voxel
                     beyond the outermost centres on */
} murk_interpolation;

/* Extinction by height in the region's own frame: linear between the heights,
 * which rise; one given twice is a jump. Nothing below the first and above
 * the last. */
typedef struct murk_profile {
    size_t n; /* 2 or more */
    const double *z_m;
    const murk_spectrum *extinction_per_m;
} murk_profile;

typedef struct murk_medium {
    /* >= 0; times the density of a grid or profile */
    murk_spectrum extinction_per_m;
    murk_spectrum albedo;         /* scattered / extinguished, 0..1 */
    const murk_grid *albedo_grid; /* not NULL: albedo by place, in all bands,
                                     instead; murk_grid_read_albedo() */
    murk_phase phase[MURK_BANDS_MAX]; /* all zero: isotropic */
    /* Density: of the grid, or of the profile (whose extinction is one), else
     * 1. Borrowed for the lifetime. */
    const murk_grid *grid;
    murk_interpolation interpolation;
    const murk_profile *profile;
    const char *where;
} murk_medium;

typedef struct murk_region {
    size_t medium;
    murk_region_shape shape;
    murk_box box;     /* box; mesh: what holds it, in the world */
    murk_vec3 center; /* sphere */
    double radius_m;
    double below_z_m;     /* half space; in the world, wherever it is moved */
    murk_affine to_world; /* moves shape (and grid) as a whole; unused where
                             everywhere and below; of meshes, the filling: the
                             mesh has been moved */
    bool replaces;
    double ior; /* index of refraction, 1..MURK_IOR_MAX; 0: none. Refractive
                   regions lie in one another or apart (for meshes the caller
                   sees to it); no grids */
    double mean_square_slope; /* of the waves on a half space with an index:
                                 medium/waves.h; 0: level */
    const char *where;
} murk_region;

/* The regions with a boundary (an index, or a mesh) that a ray lies in: bit i
 * stands for region i. Flight and depth look at the bits of meshes alone, which
 * a ray must not leave on its way: regions of other shapes know by themselves
 * where they are. */
typedef uint64_t murk_inside;

typedef struct murk_media murk_media;

/* n_regions may be 0: clear air. What is everywhere has no bounds of its own:
 * light does not leave the domain. Warns of regions that lie outside of the
 * domain. Fails with MURK_BAD_VALUE at the `where` of a medium or region. *out
 * is the caller's: murk_media_destroy(). */
murk_status murk_media_create(murk_media **out, const murk_medium *media,
                              size_t n_media, const murk_region *regions,
                              size_t n_regions, const murk_box *domain,
                              murk_error *err);
void murk_media_destroy(murk_media *media); /* NULL is fine */

/* How many there are, in regions or not. */
size_t murk_media_count(const murk_media *media);

/* That of a medium, by number, in a band. */
const murk_phase *murk_media_phase(const murk_media *media, size_t medium,
                                   int band);

/* False when no ray can ever meet a medium in any band (no regions, or
 * extinction 0 everywhere). */
bool murk_media_any(const murk_media *media);

/* Optical depth from origin along unit direction over length_m. */
double murk_media_optical_depth(const murk_media *media, int band,
                                murk_inside inside, murk_vec3 origin,
                                murk_vec3 direction, double length_m);

/* exp(-optical depth) between two points. */
double murk_media_transmittance(const murk_media *media, int band,
                                murk_inside inside, murk_vec3 from,
                                murk_vec3 to);

typedef struct murk_collision {
    double distance_m;
    size_t medium;           /* the partner */
    double albedo;           /* the partner's, in this band */
    const murk_phase *phase; /* likewise */
    double scattering_per_m; /* of all media together at the place */
} murk_collision;

/* Flies until the optical depth reaches tau or the length is used up. True
 * and *collision filled when it collides; u in (0, 1) draws the partner. */
bool murk_media_fly(const murk_media *media, int band, murk_inside inside,
                    murk_vec3 origin, murk_vec3 direction, double length_m,
                    double tau, double u, murk_collision *collision);

/* Makes ready for murk_media_fly_delta(): bounds of the grids' densities, brick
 * by brick. Fails with MURK_NO_MEMORY. */
murk_status murk_media_prepare_delta(murk_media *media, murk_error *err);

/* The same in distribution, by delta tracking through grids: tau and u are of
 * slot 0 of the address, and from slot 1 on it draws as many as it needs. */
bool murk_media_fly_delta(const murk_media *media, int band, murk_inside inside,
                          murk_vec3 origin, murk_vec3 direction,
                          double length_m, double tau, double u,
                          const murk_address *address,
                          murk_collision *collision);

/* Sums over media at a point [1/m]. */
double murk_media_extinction(const murk_media *media, int band,
                             murk_inside inside, murk_vec3 p);
double murk_media_scattering(const murk_media *media, int band,
                             murk_inside inside, murk_vec3 p);

/* What one medium adds to the extinction there [1/m]. */
double murk_media_extinction_of(const murk_media *media, size_t medium,
                                int band, murk_inside inside, murk_vec3 p);

/* Box of all bounded regions; empty when there are none. */
murk_box murk_media_bounds(const murk_media *media);

#endif
