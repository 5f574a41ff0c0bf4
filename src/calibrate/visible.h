/* The records that groups of sensors see, and the media along the sightlines:
 * found once for traced light, valid for any extinctions. For
 * use inside src/calibrate only.
 *
 * Surfaces and boundaries determine which records are seen. The transmittance
 * follows from the density path of each re-weighted medium along the straight
 * sightline, and from the transmittance of sheets and other media. Density
 * paths are stored in single precision and not as clarities, because a clarity
 * is rounded to 1/65535 and has no derivative. */
#ifndef MURK_CALIBRATE_VISIBLE_H
#define MURK_CALIBRATE_VISIBLE_H

#include "base/arena.h"
#include "calibrate/histories.h"
#include "calibrate/optics.h"
#include "calibrate/sightlines.h"

typedef struct murk_visible {
    size_t groups, media, acceptances;
    murk_sightlines *of;    /* [groups] */
    double *acceptance_rad; /* [acceptances]; distinct acceptance angles of the
                             * sensors */
    size_t n;               /* number of contributions */
    double *worth_w;        /* [n]; power times factors of regions of interest;
                             * 0 for chords */
    uint8_t *kind;          /* [n]; band * 2, plus 1 in the volume map */
    murk_arena arena;       /* of all arrays */
} murk_visible;

typedef struct murk_visible_desc {
    const murk_stage *stage;         /* the stage that was traced */
    const murk_optics *optics;       /* that the light was traced with */
    const murk_histories *histories; /* with records */
    const murk_pose *pose;           /* [poses]; of all groups */
    const size_t *group;             /* [poses]; rising, below groups */
    size_t poses, groups;
    unsigned threads;
} murk_visible_desc;

/* The extinction coefficient of a medium of the scene in a band for a sensor
 * with this acceptance angle [1/m, times density]. */
double murk_visible_extinction(const murk_optics *optics, size_t medium,
                               size_t band, double acceptance_rad);

/* Fills extinction[acceptances][bands][media] of the re-weighted media. */
void murk_visible_extinctions(double *extinction, const murk_visible *visible,
                              const murk_histories *histories,
                              const murk_optics *optics);

/* True if the density paths of a medium of the scene are recorded. */
bool murk_visible_has_paths(const murk_histories *histories, size_t medium);

/* Poses must lie in the domain. Fails with MURK_BAD_VALUE (an acceptance angle
 * together with a grid of albedo, or no memory for the sightlines),
 * MURK_RUN_FAILED (no record has weight), MURK_INTERRUPTED or MURK_NO_MEMORY.
 * Does not keep references to desc. */
murk_status murk_visible_create(murk_visible **out,
                                const murk_visible_desc *desc, murk_error *err);
void murk_visible_destroy(murk_visible *visible); /* NULL is fine */

#endif
