/* Finds the spherical receivers that a path segment crosses, and the chord in
 * each. For use inside src/calibrate only. */
#ifndef MURK_CALIBRATE_RECEIVER_TREE_H
#define MURK_CALIBRATE_RECEIVER_TREE_H

#include "calibrate/histories.h"

typedef struct murk_chord {
    uint32_t receiver;
    double from_m, to_m; /* distances along the segment, from_m < to_m */
} murk_chord;

typedef struct murk_receiver_tree murk_receiver_tree;

/* Borrows receiver[n]. The caller owns *out (murk_receiver_tree_destroy()). */
murk_status murk_receiver_tree_create(murk_receiver_tree **out,
                                      const murk_receiver *receiver, size_t n,
                                      murk_error *err);
void murk_receiver_tree_destroy(murk_receiver_tree *tree); /* NULL is fine */

/* Fills chord[], which must have room for one chord of each receiver, and
 * returns the number of chords. The order depends on the receivers alone, not
 * on the segment. */
size_t murk_receiver_tree_chords(const murk_receiver_tree *tree, murk_vec3 from,
                                 murk_vec3 direction, double length_m,
                                 murk_chord *chord);

#endif
