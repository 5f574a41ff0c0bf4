/* The cells of a box that the path of each emitted photon crosses, one word of
 * 64 bits a photon: a photon whose path crosses no cell of a changed place is
 * the same afterwards. */
#ifndef MURK_LIGHTMAP_PATH_CELLS_H
#define MURK_LIGHTMAP_PATH_CELLS_H

#include "base/box_list.h"
#include "base/status.h"
#include "transport/trace.h"

/* The bits of a word. */
#define MURK_PATH_CELLS 64

typedef struct murk_path_cells {
    murk_box box;
    int size[3];       /* cells along each axis, MURK_PATH_CELLS in all */
    uint64_t *crossed; /* [photons]: bit x + size[0] (y + size[1] z) */
    uint64_t photons;
} murk_path_cells;

/* Divides the box, at its longest edges, for so many emitted photons. The
 * caller owns *out and releases it with murk_path_cells_destroy(). Fails with
 * MURK_NO_MEMORY. */
murk_status murk_path_cells_create(murk_path_cells **out, const murk_box *box,
                                   uint64_t photons, murk_error *err);
void murk_path_cells_destroy(murk_path_cells *cells); /* NULL is fine */

/* Adds the segment that ends at an event of a photon. Events of one photon must
 * not come from two threads at once. All cells count as crossed by photons that
 * are lost, and by those that pass a side of a periodic domain in a direction
 * in which photons may jump, because jumps depend on all heights. */
void murk_path_cells_add(murk_path_cells *cells, const murk_domain *domain,
                         const murk_event *event);

/* The cells that have a point in one of the boxes. False if a box reaches out
 * of the cells within `domain`, beyond which no photon goes: then the cells do
 * not tell which photons meet the boxes. */
bool murk_path_cells_of(uint64_t *out, const murk_path_cells *cells,
                        const murk_box_list *list, const murk_box *domain);

#endif
