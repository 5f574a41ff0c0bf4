/* The photons of several conditions side by side, as one placement problem:
 * each condition is a block of photons, and a candidate sees of each what it
 * sees in that condition's air and light.
 *
 * Weights are scaled block by block, so that a condition's whole weighs its
 * weight in the mean, and rounded: that moves a photon's by half a unit, less
 * than 2^-20 of its condition's mean photon up to 2^25 photons in all, unless
 * conditions' weights or photons of one condition differ by so much that the
 * lightest lose digits to the 32 bits of the heaviest. One condition alone
 * keeps its weights. */
#ifndef MURK_CASES_JOINT_H
#define MURK_CASES_JOINT_H

#include "placement/blocks.h"
#include "sensing/sight.h"

typedef struct murk_joint {
    murk_problem problem;
    murk_blocks blocks;
    uint32_t *weight; /* [photons] of the mean: the problem's */
    murk_sight_problem part[MURK_BLOCKS_MAX];
    struct murk_joint_workspace *workspace; /* [threads] */
} murk_joint;

/* sight[n] look at the same poses[n_poses], borrowed; shares[n] > 0. */
murk_status murk_joint_create(murk_joint **out, murk_sight *const *sight,
                              const double *shares, size_t n,
                              const murk_pose *pose, size_t n_poses,
                              murk_error *err);
void murk_joint_destroy(murk_joint *joint); /* NULL is fine */

/* Weights, for free(), of block c as its own sight counts them, or as the joint
 * problem does, 0 elsewhere; NULL when out of memory. */
uint32_t *murk_joint_weights_of(const murk_joint *joint, size_t c,
                                bool as_joint);

/* What a plan must be worth to cover a share, 0..1, of the mean or of the worst
 * block: the target of a placement. */
uint64_t murk_joint_target(const murk_joint *joint, double share,
                           bool is_worst);

#endif
