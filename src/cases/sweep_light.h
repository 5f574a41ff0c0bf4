/* The light of a group of rows: the scenes and worlds of the rows, and the
 * light that is traced once for all of them (lightmap/scaled_light.h). For
 * use inside src/cases only. */
#ifndef MURK_CASES_SWEEP_LIGHT_H
#define MURK_CASES_SWEEP_LIGHT_H

#include "cases/row_tallies.h"
#include "cases/sweep.h"

#define MURK_SWEEP_STREAMS                             \
    2 /* the light that chooses and the held-out light \
       */

/* The work of a subprocess on a group. */
typedef struct murk_sweep_job {
    const murk_sweep *sweep;
    const murk_sweep_group *group;
    enum {
        MURK_SWEEP_RUN,     /* runs the rows that are not done */
        MURK_SWEEP_MEASURE, /* measures the plans for all rows, in the rows that
                             * are done and lack these values */
        MURK_SWEEP_CHOOSE /* chooses these plans, by the rows that take part */
    } work;
} murk_sweep_job;

/* True if row k of the group is left for the job to do; and the number of such
 * rows. */
bool murk_sweep_job_wants(const murk_sweep_job *job, size_t k);
size_t murk_sweep_job_left(const murk_sweep_job *job);

typedef struct murk_sweep_light {
    const murk_sweep *sweep;
    const murk_sweep_group *group;
    size_t n;                /* rows of the group */
    murk_scene_desc **scene; /* [n] NULL: read when the row is built */
    murk_stage **stage;      /* [n] NULL: not wanted, failed: why[], or late */
    bool *is_late; /* [n] wanted, and imported when the row is built: all files
                    * of the row are those of `other`, so that no subprocess is
                    * needed, and a year of rows needs the memory of one */
    murk_error *why;         /* [n] */
    double **power_w;        /* [n][channels] */
    const murk_stage *other; /* the first stage that was imported; owned by
                              * stage[] */
    const murk_stage *first; /* the first stage that was imported, in whose
                              * world light is traced; NULL: not built yet */
    murk_row_tallies row_tallies;
    murk_sources *lights; /* light sources whose traced light is scaled to each
                           * row; NULL: all rows have equal lights, or none
                           * shines */
    murk_scene_desc lit_scene; /* the scene that is traced: that of `first` with
                                  more photons if the lights of the rows
                                  differ */
    murk_stage lit_stage;      /* the stage that is traced: `first` with
                                  lit_scene, `lights` and the tallies of the
                                  rows */
    murk_traced *traced[MURK_SWEEP_STREAMS]; /* NULL before the first use */
} murk_sweep_light;

/* Reads the scenes of all rows, and imports the files of the rows that the job
 * wants, before any ray device is made. If a row cannot be imported, why[] has
 * the reason, and that is no failure. Release *out also after a failure. */
murk_status murk_sweep_light_import(murk_sweep_light *out,
                                    const murk_sweep_job *job, murk_error *err);
void murk_sweep_light_release(murk_sweep_light *light);

/* Builds the first imported world and prepares the trace in it, with the
 * tallies of the rows if they are wanted. Does nothing if no row is imported.
 * If this fails, no row of the group has light. */
murk_status murk_sweep_light_prepare(murk_sweep_light *light,
                                     bool with_row_tallies, murk_error *err);

/* True if row k is left for murk_sweep_light_build(): it is wanted, and was
 * imported without a failure or is late. */
bool murk_sweep_light_has(const murk_sweep_light *light, size_t k);

/* Imports row k if it is late, and builds its world, unless it is the first
 * one. */
murk_status murk_sweep_light_build(murk_sweep_light *light, size_t k,
                                   murk_error *err);
/* Releases the world of row k, and the scene of a late row, unless it is the
 * first one. */
void murk_sweep_light_drop(murk_sweep_light *light, size_t k);

/* True if any light of row k has power. */
bool murk_sweep_light_shines(const murk_sweep_light *light, size_t k);

/* The light of row k for a stream of random numbers, below MURK_SWEEP_STREAMS;
 * the first call for a stream traces the light of the group. If *is_own is set,
 * the caller owns *out (murk_traced_destroy()); else *out belongs to
 * `light`. */
murk_status murk_sweep_light_of(murk_sweep_light *light, size_t k,
                                uint32_t stream, murk_traced **out,
                                bool *is_own, murk_error *err);

#endif
