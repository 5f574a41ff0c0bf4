#include "preset/laws.h"

#include <string.h>

#define BIT(word) (1u << MURK_WORD_##word)

const murk_law murk_laws[] = {
    {.name = "kruse",
     .about = "extinction by visibility, Kruse 1962",
     .run = murk_law_kruse,
     .parameter = {{"albedo", 0, 1}},
     .needs = BIT(VISIBILITY)},
    {.name = "kim",
     .about = "extinction by visibility, Kim 2001",
     .run = murk_law_kim,
     .parameter = {{"albedo", 0, 1}},
     .needs = BIT(VISIBILITY)},
};
const size_t murk_laws_count = sizeof murk_laws / sizeof *murk_laws;

const murk_law *murk_law_find(const char *name)
{
    for (size_t i = 0; i < murk_laws_count; ++i) {
        if (strcmp(murk_laws[i].name, name) == 0) {
            return &murk_laws[i];
        }
    }
    return NULL;
}
