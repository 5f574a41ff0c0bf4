/* The rows of preset/words.h as a table, and the search for a name. */
#include "preset/words.h"

#include <string.h>

const murk_word_row murk_word_rows[MURK_WORDS] = {
#define X(id, name, unit, numbers, is_amount) {name, unit, numbers, is_amount},
    MURK_WORD_ROWS(X)
#undef X
};

int murk_word_find(const char *name)
{
    for (int i = 0; i < MURK_WORDS; ++i) {
        if (strcmp(murk_word_rows[i].name, name) == 0) {
            return i;
        }
    }
    return -1;
}
