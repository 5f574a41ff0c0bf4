/* Views (murk_array, murk.h): of arrays of the caller, whose elements are read
 * one by one, and of arrays of murk. Also the lists of arrays of murk that are
 * made when the caller asks for them. */
#include "api/handles.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

size_t murk_type_bytes(murk_type type)
{
    /* Bytes of one element, by type. */
    static const size_t bytes[] = {
        [MURK_TYPE_UINT8] = 1,   [MURK_TYPE_UINT16] = 2,
        [MURK_TYPE_UINT32] = 4,  [MURK_TYPE_UINT64] = 8,
        [MURK_TYPE_FLOAT32] = 4, [MURK_TYPE_FLOAT64] = 8};
    return (unsigned)type < sizeof bytes / sizeof *bytes ? bytes[type] : 0;
}

/* Sets dimensions and shape, and the strides of a dense array in the order of
 * C, of view->type. */
static void lay_out(murk_array *view, int dimensions, const size_t *shape)
{
    view->dimensions = dimensions;
    ptrdiff_t stride = (ptrdiff_t)murk_type_bytes(view->type);
    for (int k = dimensions - 1; k >= 0; --k) {
        view->shape[k] = shape[k];
        view->stride[k] = stride;
        stride *= (ptrdiff_t)shape[k];
    }
}

murk_array murk_array_of(const void *data, murk_type type, int dimensions,
                         const size_t *shape)
{
    murk_array out = {.size = sizeof out, .data = data, .type = type};
    if (shape && dimensions > 0 && dimensions <= MURK_ARRAY_DIMENSIONS) {
        lay_out(&out, dimensions, shape);
    }
    return out;
}

murk_status murk_array_fill(murk_array *view, const void *data, murk_type type,
                            int dimensions, const size_t *shape, bool is_copy,
                            murk_error *err)
{
    if (!view) {
        return murk_call_bad_argument(err, "view", "is NULL");
    }
    const murk_status status = murk_struct_check(view, sizeof *view, SIZE_MAX,
                                                 "view", "murk_array", err);
    if (status) {
        return status;
    }
    *view = (murk_array){
        .size = view->size, .data = data, .type = type, .is_copy = is_copy};
    lay_out(view, dimensions, shape);
    return MURK_OK;
}

murk_status murk_array_check(const murk_array *view, int dimensions,
                             const char *name, murk_error *err)
{
    if (!view) {
        return murk_call_bad_argument(err, name, "is NULL");
    }
    const murk_status status = murk_struct_check(
        view, sizeof *view, sizeof *view, name, "murk_array", err);
    if (status) {
        return status;
    }
    if (view->dimensions != dimensions || murk_type_bytes(view->type) == 0) {
        return murk_call_bad_argument(
            err, name,
            "has %d dimensions and type %d, must have %d and a "
            "murk_type",
            view->dimensions, (int)view->type, dimensions);
    }
    if (!view->data && murk_array_count(view) > 0) {
        return murk_call_bad_argument(err, name, "data is NULL");
    }
    return MURK_OK;
}

size_t murk_array_count(const murk_array *view)
{
    size_t n = 1;
    for (int k = 0; k < view->dimensions; ++k) {
        n *= view->shape[k];
    }
    return n;
}

double murk_array_number(const murk_array *view, size_t i)
{
    const char *at = view->data;
    for (int k = view->dimensions - 1; k >= 0; --k) {
        at += (ptrdiff_t)(i % view->shape[k]) * view->stride[k];
        i /= view->shape[k];
    }
    /* Copy the element, because arrays of the caller need not be aligned. */
    union {
        uint8_t uint8;
        uint16_t uint16;
        uint32_t uint32;
        uint64_t uint64;
        float float32;
        double float64;
    } value;
    memcpy(&value, at, murk_type_bytes(view->type));
    switch (view->type) {
    case MURK_TYPE_UINT8:
        return value.uint8;
    case MURK_TYPE_UINT16:
        return value.uint16;
    case MURK_TYPE_UINT32:
        return value.uint32;
    case MURK_TYPE_UINT64:
        return (double)value.uint64;
    case MURK_TYPE_FLOAT32:
        return (double)value.float32;
    case MURK_TYPE_FLOAT64:
        break;
    }
    return value.float64;
}

/* ---- arrays that are made on request ---- */

void *murk_made_find(const murk_made *list, const char *name)
{
    for (; list; list = list->next) {
        if (strcmp(list->name, name) == 0) {
            return list->data;
        }
    }
    return NULL;
}

void *murk_made_add(murk_made **list, const char *name, size_t bytes,
                    murk_error *err)
{
    murk_made *made = calloc(1, sizeof *made);
    void *data = made ? calloc(1, bytes + 1) : NULL;
    if (!data) {
        free(made);
        (void)murk_no_memory(err, "", "for the array %s", name);
        return NULL;
    }
    snprintf(made->name, sizeof made->name, "%s", name);
    made->data = data;
    made->next = *list;
    *list = made;
    return data;
}

void murk_made_release(murk_made *list)
{
    while (list) {
        murk_made *next = list->next;
        free(list->data);
        free(list);
        list = next;
    }
}
