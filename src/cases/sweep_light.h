/* The light of a group: the scenes and worlds of its rows, and what is traced
 * once for all of them (lightmap/relight.h). Private to the sweep. */
#ifndef MURK_CASES_SWEEP_LIGHT_H
#define MURK_CASES_SWEEP_LIGHT_H

#include "cases/row_tallies.h"
#include "cases/sweep.h"

#define MURK_SWEEP_STREAMS 2 /* the light that chooses, and the held out */

typedef struct murk_sweep_light {
    const murk_sweep *sweep;
    const murk_sweep_group *group;
    size_t n;
    murk_scene_desc **scene; /* [n] of all rows of the group */
    murk_stage **stage;      /* [n] NULL: not wanted, or why[] it has none */
    murk_error *why;         /* [n] */
    double **power_w;        /* [n][channels] */
    const murk_stage *first; /* built: its world is everyone's; or NULL */
    murk_row_tallies row_tallies;
    murk_sources *lights; /* of all rows; NULL: they have the same, their own */
    murk_scene_desc lit_scene; /* what is traced: `first` under these lights */
    murk_stage lit_stage;
    murk_traced *traced[MURK_SWEEP_STREAMS]; /* once somebody asked */
} murk_sweep_light;

/* Reads all scenes and imports what is_wanted[n] says, before any ray device is
 * made. Release *out also after a failure. */
murk_status murk_sweep_light_import(murk_sweep_light *out,
                                    const murk_sweep *sweep,
                                    const murk_sweep_group *group,
                                    const bool *is_wanted, murk_error *err);
void murk_sweep_light_release(murk_sweep_light *light);

/* Builds the first world that was imported, and makes ready what is traced in
 * it; with gauges where they are asked for. Where this fails no row of the
 * group can be lit. */
murk_status murk_sweep_light_prepare(murk_sweep_light *light,
                                     bool with_row_tallies, murk_error *err);

/* Builds the world of row k, where it is not the first one. */
murk_status murk_sweep_light_build(murk_sweep_light *light, size_t k,
                                   murk_error *err);
/* Row k is not needed any more. */
void murk_sweep_light_drop(murk_sweep_light *light, size_t k);

/* Whether anything shines in row k. */
bool murk_sweep_light_shines(const murk_sweep_light *light, size_t k);

/* The light of row k, of a stream; *is_own: for murk_traced_destroy(). */
murk_status murk_sweep_light_of(murk_sweep_light *light, size_t k,
                                uint32_t stream, murk_traced **out,
                                bool *is_own, murk_error *err);

#endif
