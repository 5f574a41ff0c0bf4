/* A list of boxes that do not overlap: a new box is joined with those that it
 * overlaps, so the list stays short. */
#include "base/box_list.h"

static murk_box joined(const murk_box *a, const murk_box *b)
{
    return murk_box_with(murk_box_with(*a, b->min), b->max);
}

/* The diagonal of the box that joins two boxes, squared [m2]. */
static double spread(const murk_box *a, const murk_box *b)
{
    const murk_box both = joined(a, b);
    const murk_vec3 diagonal = murk_sub(both.max, both.min);
    return murk_dot(diagonal, diagonal);
}

static murk_box take_out(murk_box_list *list, size_t i)
{
    const murk_box box = list->box[i];
    list->box[i] = list->box[--list->n];
    return box;
}

/* The box with which a full list joins a new one: that of the smallest
 * result. */
static size_t nearest(const murk_box_list *list, const murk_box *box)
{
    size_t found = 0;
    for (size_t i = 1; i < list->n; ++i) {
        found = spread(&list->box[i], box) < spread(&list->box[found], box)
                    ? i
                    : found;
    }
    return found;
}

void murk_box_list_add(murk_box_list *list, murk_box box)
{
    const bool is_empty =
        box.min.x > box.max.x || box.min.y > box.max.y || box.min.z > box.max.z;
    if (is_empty || list->are_all) {
        return;
    }
    if (!murk_is_finite(box.min) || !murk_is_finite(box.max)) {
        list->are_all = true;
        return;
    }
    /* Each join may make the box overlap further ones. */
    for (size_t i = 0; i < list->n;) {
        if (murk_box_overlaps(&list->box[i], &box)) {
            const murk_box other = take_out(list, i);
            box = joined(&box, &other);
            i = 0;
        } else {
            ++i;
        }
    }
    if (list->n == MURK_BOX_LIST_MAX) {
        const murk_box other = take_out(list, nearest(list, &box));
        murk_box_list_add(list, joined(&box, &other));
        return;
    }
    list->box[list->n++] = box;
}

void murk_box_list_grow(murk_box_list *list, double margin_m)
{
    const murk_vec3 margin = {margin_m, margin_m, margin_m};
    const murk_box_list old = *list;
    list->n = 0;
    for (size_t i = 0; i < old.n; ++i) {
        murk_box_list_add(list, (murk_box){murk_sub(old.box[i].min, margin),
                                           murk_add(old.box[i].max, margin)});
    }
}
