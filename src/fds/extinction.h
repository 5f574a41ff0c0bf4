/* Extinction by the smoke of an FDS run at one time: one block of values for
 * each mesh, on the grid lines of the mesh.
 *
 * Sources of the extinction coefficient K [1/m], from soot density rho [kg/m3],
 * mass extinction coefficient K_m [m2/kg] and visibility S [m]:
 *
 * soot density, .s3d file  K = -ln(1 - b / 254) / DX, with b the byte of a node
 *                          and DX the first cell of the mesh along x; FDS wrote
 *                          b = 254 (1 - exp(-K_m DX rho)), so K_m is in it. b
 *                          is rounded: K is known to +-1 byte, and b = 254
 *                          means "at least": K of b = 253.5
 * soot density, slice      K = K_m rho; K_m is that of the .s3d files of soot,
 *                          8700 m2/kg (FDS's default) if there are none
 * extinction, slice        K as it is
 * visibility, slice        K = C / S with C = 3 (signs that reflect light); FDS
 *                          cuts S at a maximum, so cells with the largest S of
 *                          all have at most this K
 *
 * Source: FDS 6, Source/dump.f90, DUMP_SMOKE3D; K_m: Mulholland and Croarkin,
 * Fire and Materials 24 (2000) 227,
 * doi:10.1002/1099-1018(200009/10)24:5<227::AID-FAM742>3.0.CO;2-9. */
#ifndef MURK_FDS_EXTINCTION_H
#define MURK_FDS_EXTINCTION_H

#include "base/field_blocks.h"
#include "fds/run.h"

typedef enum murk_fds_quantity {
    MURK_FDS_SOOT_DENSITY,
    MURK_FDS_EXTINCTION,
    MURK_FDS_VISIBILITY
} murk_fds_quantity;

/* The words of users for the quantities, in the order of murk_fds_quantity. */
extern const char *const murk_fds_quantity_names[3];

typedef struct murk_fds_asked {
    murk_fds_quantity quantity;
    const double *mesh; /* numbers of meshes, from 1 on; all if n_meshes is 0 */
    size_t n_meshes;
    double time_s; /* between two frames: their mean, weighted by time */
} murk_fds_asked;

typedef struct murk_fds_field {
    size_t n;
    murk_field_block *block; /* [n], without overlap; K [1/m] */
    murk_fds_quantity quantity;
    bool is_rounded;     /* from bytes of .s3d files */
    double frame_s[2];   /* times of the frames before and after time_s */
    double weight;       /* of the frame after: 0 if time_s is at a frame */
    double step_per_m;   /* is_rounded: K of the byte 1, in the mesh where this
                          * is largest */
    uint64_t capped;     /* values known to be "at least" (bytes of 254) or "at
                          * most" (largest visibility) */
    double capped_per_m; /* K of those; the largest of all meshes */
    double mass_extinction; /* K_m [m2/kg] of a soot density in slices */
} murk_fds_field;

/* Reads the field. `path` is that of the .smv file; data files lie beside it.
 * The caller owns *out and releases it with murk_fds_field_destroy(). Fails at
 * `where` or a file's place with MURK_BAD_FILE (malformed files), with
 * MURK_BAD_VALUE (no such quantity, mesh or time, overlapping meshes; the
 * message lists what there is), or with MURK_NO_MEMORY. */
murk_status murk_fds_field_read(murk_fds_field **out, const char *path,
                                const murk_fds_asked *asked, const char *where,
                                murk_error *err);
void murk_fds_field_destroy(murk_fds_field *field); /* NULL is fine */

#endif
