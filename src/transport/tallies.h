/* Tallies: light measured along the photons' ways, with its standard error.
 *
 * A plane counts the power through it; a grid and a sphere give the mean
 * scalar irradiance (fluence rate) by track length, which is right where
 * nothing is absorbed, too (Spanier and Gelbard, Monte Carlo Principles and
 * Neutron Transport Problems, 1969, ch. 2).
 *
 * What a photon brings to a cell is added up along its whole way and rounded
 * once, to quanta (planes) or to 2^-30 of a packet times the cell's diameter
 * (lengths). Its value and square go to whole-number sums by channel and cell,
 * so that no result depends on order or threads, and errors are by emitted
 * photon: all that one photon does belongs together.
 *
 * A plane and what lies in it: light is counted on the side that the normal
 * points away from. So in a floor, an interface or a side of the domain,
 * `forward` is the light that arrives along the normal. A surface nearer than
 * half of murk_surfaces_leave()'s step counts as in the plane. Light enters and
 * leaves through a side of the domain that has a plane in it on either side. */
#ifndef MURK_TRANSPORT_TALLIES_H
#define MURK_TRANSPORT_TALLIES_H

#include "base/kinds.h"
#include "base/stats.h"
#include "base/status.h"
#include "base/tally.h"
#include "base/vector.h"

#include <stddef.h>
#include <stdint.h>

/* Sums hold 2^32 photons of so many legs each. */
#define MURK_TALLY_LEGS_MAX (1 << 17)

/* Tallies of a scene, and bytes of the name of one, which becomes the name of a
 * file. */
#define MURK_TALLIES_MAX     64
#define MURK_TALLY_NAME_SIZE 64
#define MURK_TALLY_CELLS_MAX (UINT64_C(1) << 31) /* of all tallies together */
#define MURK_PLANE_CELLS_MAX 1000000             /* of one plane */

/* What is asked for; members of the other types are not looked at. */
typedef struct murk_tally_desc {
    char name[MURK_TALLY_NAME_SIZE]; /* letters, digits, . _ -, and a letter or
                                        digit first: it names files */
    const char *where;
    murk_tally_type type;
    murk_vec3 point, normal; /* plane; the normal need not be unit */
    size_t bins[2];          /* plane: see murk_tally_axes() */
    size_t angle_bins;       /* plane: equal in cosine with the normal, 0..1 */
    murk_box box;            /* grid */
    size_t size[3];          /* grid */
    murk_vec3 center;        /* sphere */
    double radius_m;         /* sphere */
    bool hemispheres;        /* sphere: by the sign of z of travel */
} murk_tally_desc;

/* Directions of a plane: forward, backward; of a sphere by hemispheres: up,
 * down; else one. */
size_t murk_tally_directions(const murk_tally_desc *desc);

/* Cells, the first index fastest: a plane's are [bins[0], bins[1], angle_bins,
 * directions], a grid's [size], a sphere's [directions]. */
size_t murk_tally_cells(const murk_tally_desc *desc);

/* A plane's bins lie along two axes of space (0 x, 1 y, 2 z), in that order:
 * those other than the one that the normal is longest along (of equal ones the
 * last), each over the domain's extent. */
void murk_tally_axes(const murk_tally_desc *desc, int axes[2]);

/* Refuses what cannot be measured: names twice, not safe or whose files would
 * be the same, places outside the domain, no normal, too many cells. */
murk_status murk_tallies_check(const murk_tally_desc *descs, size_t n,
                               const murk_domain *domain, murk_error *err);

/* Bytes that the tallies take while photons are traced, and on top of that the
 * writing of the largest grid. channels: lights * bands. */
double murk_tallies_memory(const murk_tally_desc *descs, size_t n,
                           size_t channels, int bands, unsigned threads);

typedef struct murk_tallies murk_tallies;

/* Checked as above, and refused where they take more than memory_most_bytes.
 * Made once for a run: tracing adds to it from at most that many threads.
 * *out is the caller's: murk_tallies_destroy(). */
murk_status murk_tallies_create(murk_tallies **out,
                                const murk_tally_desc *descs, size_t n,
                                const murk_domain *domain, size_t channels,
                                int bands, unsigned threads,
                                double memory_max_bytes, murk_error *err);
void murk_tallies_destroy(murk_tallies *tallies); /* NULL is fine */

/* Made for that many channels, and that many threads or more. */
bool murk_tallies_fit(const murk_tallies *tallies, size_t channels,
                      unsigned threads);

size_t murk_tallies_count(const murk_tallies *tallies);
const murk_tally_desc *murk_tallies_desc(const murk_tallies *tallies,
                                         size_t tally);

/* One cell in one band, of all lights together: W of a plane, W/m2 of grids
 * and spheres. emitted[channels] in quanta is the ledger's, packet_w[channels]
 * the power of one packet. The error is that of a sum over channels of n
 * independent photons each, packet_w^2 n/(n - 1) (sum x^2 - (sum x)^2 / n); a
 * channel that has one photon only counts with all that it brings. */
murk_estimate murk_tallies_read(const murk_tallies *tallies, size_t tally,
                                int band, size_t cell,
                                const murk_tally *emitted,
                                const double *packet_w);

#endif
