/* A short list of boxes that together contain the places at which something
 * has changed, such as two worlds of one scene at different times. */
#ifndef MURK_BASE_BOX_LIST_H
#define MURK_BASE_BOX_LIST_H

#include "base/vector.h"

#include <stdbool.h>
#include <stddef.h>

/* A choice: a sightline is compared with each box. */
#define MURK_BOX_LIST_MAX 16

typedef struct murk_box_list {
    murk_box box[MURK_BOX_LIST_MAX]; /* [n] */
    size_t n;
    bool are_all; /* the boxes do not tell: any place may have changed */
} murk_box_list;

/* Adds a box, which is joined with the boxes that it overlaps, and with the
 * nearest one if the list is full. An empty box adds nothing; a box that is not
 * finite makes all places changed. */
void murk_box_list_add(murk_box_list *list, murk_box box);

/* Enlarges each box by margin_m on every side. */
void murk_box_list_grow(murk_box_list *list, double margin_m);

/* True if the segment from `from` to from + along has a point in a box, by the
 * test of separating axes: those of the box, and the vector products of each of
 * them with the segment (Ericson, Real-Time Collision Detection, 2005, 5.3.3).
 * The caller enlarges boxes for rounding. */
static inline bool murk_box_meets_segment(const murk_box *box, murk_vec3 from,
                                          murk_vec3 along)
{
    /* Half the edges of the box, half the segment, and the vector between the
     * middles of both. */
    const murk_vec3 edge = murk_scale(0.5, murk_sub(box->max, box->min)),
                    half = murk_scale(0.5, along),
                    offset =
                        murk_sub(murk_add(from, half),
                                 murk_scale(0.5, murk_add(box->min, box->max)));
    const double x = fabs(half.x), y = fabs(half.y), z = fabs(half.z);
    if (fabs(offset.x) > edge.x + x || fabs(offset.y) > edge.y + y ||
        fabs(offset.z) > edge.z + z) {
        return false;
    }
    return fabs(offset.y * half.z - offset.z * half.y) <=
               edge.y * z + edge.z * y &&
           fabs(offset.z * half.x - offset.x * half.z) <=
               edge.z * x + edge.x * z &&
           fabs(offset.x * half.y - offset.y * half.x) <=
               edge.x * y + edge.y * x;
}

/* True if the segment has a point in one of the boxes. */
static inline bool murk_box_list_meet(const murk_box_list *list, murk_vec3 from,
                                      murk_vec3 along)
{
    bool meets = list->are_all;
    for (size_t i = 0; i < list->n && !meets; ++i) {
        meets = murk_box_meets_segment(&list->box[i], from, along);
    }
    return meets;
}

#endif
