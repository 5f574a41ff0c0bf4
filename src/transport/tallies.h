/* Tallies: measurements of light along the paths of photons, with standard
 * errors.
 *
 * A plane measures the power through the plane. A grid and a sphere measure the
 * mean scalar irradiance (fluence rate) by track length, which is correct in a
 * medium without absorption, too (Spanier and Gelbard, Monte Carlo Principles
 * and Neutron Transport Problems, 1969, ch. 2).
 *
 * The contributions of a photon to a cell are summed over the whole path and
 * rounded once, to quanta (planes) or to 2^-30 of a packet times the diagonal
 * of a grid cell or the diameter of a sphere (lengths). The value and its
 * square are added to integer sums by channel (light and band) and cell. No
 * result therefore depends on order or threads, and errors are by emitted
 * photon: all contributions of a photon are one sample.
 *
 * If a surface, an interface or a side of the domain lies in a plane, the plane
 * measures as if it lay just before that object, seen along the normal of the
 * plane: `forward` is the light that arrives at the object along the normal,
 * `backward` the light that leaves the object against the normal. A surface
 * nearer than half of the step of murk_surfaces_leave() counts as lying in the
 * plane. Light that enters or leaves through a side of the domain in which a
 * plane lies passes the plane. */
#ifndef MURK_TRANSPORT_TALLIES_H
#define MURK_TRANSPORT_TALLIES_H

#include "base/kinds.h"
#include "base/stats.h"
#include "base/status.h"
#include "base/tally.h"
#include "base/vector.h"

#include <stddef.h>
#include <stdint.h>

/* The largest number of segments of a photon: sums hold 2^32 photons with this
 * many segments each. */
#define MURK_TALLY_SEGMENTS_MAX (1 << 17)

/* The largest number of tallies of a scene, and the size in bytes of the name
 * of a tally, by which files are named. */
#define MURK_TALLIES_MAX     64
#define MURK_TALLY_NAME_SIZE 64
#define MURK_TALLY_CELLS_MAX (UINT64_C(1) << 31) /* of all tallies together */
#define MURK_PLANE_CELLS_MAX 1000000             /* of one plane */

/* The description of a tally; members of other types are ignored. */
typedef struct murk_tally_desc {
    char name[MURK_TALLY_NAME_SIZE]; /* letters, digits, . _ -, beginning with a
                                      * letter or digit: used in file names */
    const char *where;
    murk_tally_type type;
    murk_vec3 point, normal; /* plane; the normal need not be unit */
    size_t bins[2];          /* plane: see murk_tally_axes() */
    size_t angle_bins;       /* plane: equal in cosine with the normal, 0..1 */
    murk_box box;            /* grid */
    size_t size[3];          /* grid */
    murk_vec3 center;        /* sphere */
    double radius_m;         /* sphere */
    bool hemispheres; /* sphere: upward and downward directions of travel are
                         counted separately */
} murk_tally_desc;

/* The number of directions: of a plane 2, forward and backward; of a sphere
 * with hemispheres 2, up and down; else 1. */
size_t murk_tally_directions(const murk_tally_desc *desc);

/* The number of cells, with the first index fastest: [bins[0], bins[1],
 * angle_bins, directions] for a plane, [size] for a grid, [directions] for a
 * sphere. */
size_t murk_tally_cells(const murk_tally_desc *desc);

/* The axes of the bins of a plane: two axes of space (0 x, 1 y, 2 z) in that
 * order, without the axis along which the normal is longest (of equal ones the
 * last); the bins divide the extent of the domain. */
void murk_tally_axes(const murk_tally_desc *desc, int axes[2]);

/* Fails with MURK_BAD_VALUE, at the `where` of a tally, if the tallies cannot
 * be measured: more than MURK_TALLIES_MAX, equal or unsafe names, names that
 * would give the same files, positions outside the domain, a missing normal, a
 * radius that is not positive, too many cells. */
murk_status murk_tallies_check(const murk_tally_desc *descs, size_t n,
                               const murk_domain *domain, murk_error *err);

/* The memory in bytes of the tallies during tracing, and in addition of writing
 * the largest grid. channels: lights * bands. */
double murk_tallies_memory(const murk_tally_desc *descs, size_t n,
                           size_t channels, int bands, unsigned threads);

typedef struct murk_tallies murk_tallies;

/* Calls murk_tallies_check() and creates n > 0 tallies. Fails as that function
 * does, with MURK_BAD_VALUE if the tallies would take more than
 * memory_max_bytes, and with MURK_NO_MEMORY. The descriptions are copied, but
 * their `where` must outlive the tallies. At most `threads` threads (0 counts
 * as 1) may add to them. The caller destroys *out with
 * murk_tallies_destroy(). */
murk_status murk_tallies_create(murk_tallies **out,
                                const murk_tally_desc *descs, size_t n,
                                const murk_domain *domain, size_t channels,
                                int bands, unsigned threads,
                                double memory_max_bytes, murk_error *err);
void murk_tallies_destroy(murk_tallies *tallies); /* NULL is fine */

/* True if the tallies were created for that number of channels and have a
 * scorer for each of that number of threads (0 counts as 1). */
bool murk_tallies_fit(const murk_tallies *tallies, size_t channels,
                      unsigned threads);

/* All sums as one array of murk_tallies_words() numbers, by which tallies of
 * parts of a run are stored and added: for each channel and cell of all tallies
 * the sum and the sum of the squares, 128 bits each, the low half first. */
size_t murk_tallies_words(const murk_tallies *tallies);
void murk_tallies_read_sums(const murk_tallies *tallies, uint64_t *word);
void murk_tallies_add_sums(murk_tallies *tallies, const uint64_t *word);

size_t murk_tallies_count(const murk_tallies *tallies);
const murk_tally_desc *murk_tallies_desc(const murk_tallies *tallies,
                                         size_t tally);

/* The value of a cell in a band, summed over all lights: W for a plane, W/m2
 * for grids and spheres. emitted[channels] in quanta is from the ledger,
 * packet_w[channels] is the power of a packet. The square of the standard error
 * is a sum over the channels of the band. A channel with n independent photons,
 * whose contributions are x packets each, adds packet_w^2 n/(n - 1) (sum x^2 -
 * (sum x)^2 / n); a channel with a single photon adds packet_w^2 x^2, a channel
 * without photons adds nothing. For grids and spheres the standard error is
 * converted to W/m2 like the value. */
murk_estimate murk_tallies_read(const murk_tallies *tallies, size_t tally,
                                int band, size_t cell,
                                const murk_tally *emitted,
                                const double *packet_w);

#endif
