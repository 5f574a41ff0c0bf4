/* The table of the types of light sources, made from the list in the header. */
#include "base/source_type.h"

static const struct {
    const char *name;
    murk_source_group group;
} ROWS[] = {
#define ROW(id, name, group) [MURK_SOURCE_##id] = {name, MURK_SOURCE_##group},
    MURK_SOURCE_TYPES(ROW)};

const char *murk_source_type_name(murk_source_type type)
{
    return ROWS[type].name;
}

murk_source_group murk_source_type_group(murk_source_type type)
{
    return ROWS[type].group;
}
