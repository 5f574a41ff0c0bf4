/* The names of kinds, made from the lists in the header. */
#include "base/kinds.h"

#define NAME(id, name) name,

const char *murk_place_method_name(murk_place_method method)
{
    static const char *const names[] = {MURK_PLACE_METHODS(NAME)};
    return names[method];
}

const char *murk_view_name(murk_view view)
{
    static const char *const names[] = {MURK_VIEW_SHAPES(NAME)};
    return names[view];
}

const char *murk_tally_type_name(murk_tally_type type)
{
    static const char *const names[] = {MURK_TALLY_TYPES(NAME)};
    return names[type];
}
