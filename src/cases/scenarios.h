/* Several scenarios as one placement problem, and plans for them by any
 * objective: the mean, the worst scenario, or the largest regret.
 *
 * A scenario is one state of the world (a condition of a scene, a row of a
 * study) with its own light and sight. The photons of all scenarios lie side by
 * side: each scenario is a block of photons, and a candidate sees in each block
 * the photons that it sees in that scenario's air and light.
 *
 * The weights of the photons are scaled block by block, so that the sum over a
 * block is proportional to the weight of its scenario in the mean, and then
 * rounded. Rounding changes the weight of a photon by at most half a unit. With
 * a redundancy of 1, up to 2^25 photons in all, and scenarios of about equal
 * numbers of photons, this is less than 2^-20 of the mean weight in the
 * scenario of the photon, unless the weights of the scenarios or those of the
 * photons of one scenario differ so much that the heaviest photon would exceed
 * 32 bits. A single scenario keeps its weights. */
#ifndef MURK_CASES_SCENARIOS_H
#define MURK_CASES_SCENARIOS_H

#include "placement/blocks.h"
#include "placement/place.h"
#include "plan/poses.h"
#include "sensing/sight.h"

typedef struct murk_scenarios {
    const murk_scene_desc *scene; /* borrowed: method, knowledge, target */
    const murk_poses *poses;      /* borrowed: the candidates */
    murk_problem problem;         /* of all photons, for the mean */
    murk_blocks blocks;  /* blocks.reference: for each block the value of the
                          * best plan known for that block alone, which the
                          * caller fills before a plan for the least regret */
    murk_matrix *matrix; /* of all photons; NULL: unknown environment */
    double sense_s;      /* seconds that filling the matrix took */
    uint32_t *weight;    /* [photons] of the mean: problem.weight */
    murk_sight_problem part[MURK_BLOCKS_MAX];
    struct murk_scenarios_workspace *workspace; /* [threads] */
} murk_scenarios;

/* Fills the coverage matrix if the environment is known. sight[n], scene and
 * poses are borrowed, n is 1..MURK_BLOCKS_MAX, and shares[n] > 0 are the
 * weights of the scenarios. Fails with MURK_RUN_FAILED (more than 2^32 - 1
 * photons together, or a matrix that does not fit in memory), MURK_NO_MEMORY or
 * MURK_INTERRUPTED. *out is the caller's: murk_scenarios_destroy(). */
murk_status murk_scenarios_create(murk_scenarios **out,
                                  const murk_scene_desc *scene,
                                  murk_sight *const *sight,
                                  const double *shares, size_t n,
                                  const murk_poses *poses, murk_error *err);
/* The same with rows of an earlier plan. */
typedef struct murk_scenarios_rows {
    const murk_known_rows *const *known; /* [n] of each scenario; an element
                                          * NULL: none */
    murk_row_counts *tested; /* [n][candidates] gets the sightlines of each row;
                              * NULL: nobody asks */
    const murk_pose *const *pose; /* [n][candidates] the candidates as they are
                                   * in each scenario; NULL: as in `poses` */
    uint64_t memory_taken;        /* of the memory for rows, in bytes */
    bool has_columns;             /* as in murk_problem */
} murk_scenarios_rows;
murk_status
murk_scenarios_create_from(murk_scenarios **out, const murk_scene_desc *scene,
                           murk_sight *const *sight, const double *shares,
                           size_t n, const murk_poses *poses,
                           const murk_scenarios_rows *rows, murk_error *err);
void murk_scenarios_destroy(murk_scenarios *scenarios); /* NULL is fine */

/* Method, constraints, and number, target or budget of the sensors as the scene
 * asks for them, for a plan by the objective. */
murk_place_desc murk_scenarios_desc(const murk_scenarios *scenarios,
                                    murk_scene_objective objective);

/* The plan for all scenarios by an objective: mean, worst or regret; the last
 * two need a known environment. */
murk_status murk_scenarios_place(murk_place_result *out,
                                 const murk_scenarios *scenarios,
                                 murk_scene_objective objective,
                                 const murk_place_desc *desc, murk_error *err);

/* The plan for the scenario of one block alone, in a known environment. Weights
 * are those of the scenario's own sight, or with with_problem_weights those of
 * the problem of all scenarios, in which the references of a regret must be
 * counted. */
murk_status murk_scenarios_place_one(murk_place_result *out,
                                     const murk_scenarios *scenarios,
                                     size_t block, bool with_problem_weights,
                                     const murk_place_desc *desc,
                                     murk_error *err);

#endif
