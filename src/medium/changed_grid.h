/* The cells at which two grids differ. For use inside src/medium only. */
#ifndef MURK_MEDIUM_CHANGED_GRID_H
#define MURK_MEDIUM_CHANGED_GRID_H

#include "base/box_list.h"
#include "medium/tree.h"

/* Adds the boxes, in index space where voxel i covers [i, i + 1), of all leaves
 * and larger cells of the trees that have different values or are divided
 * otherwise. If the roots have other cells, all places have changed. The boxes
 * of active voxels must be equal. */
void murk_changed_cells(murk_box_list *changed, const murk_tree *a,
                        const murk_tree *b);

#endif
