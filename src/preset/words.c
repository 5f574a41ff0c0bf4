/* Looks up names, units and numbers of words in the table of preset/words.h. */
#include "preset/words.h"

#include <string.h>

static const struct {
    const char *name, *unit;
    int numbers;
} WORDS[] = {
#define X(id, name, unit, numbers) {name, unit, numbers},
    MURK_WORD_ROWS(X)
#undef X
};

const char *murk_word_name(murk_word_id word)
{
    return WORDS[word].name;
}

const char *murk_word_unit(murk_word_id word)
{
    return WORDS[word].unit;
}

int murk_word_numbers(murk_word_id word)
{
    return WORDS[word].numbers;
}

int murk_word_find(const char *name)
{
    for (int i = 0; i < MURK_WORDS; ++i) {
        if (strcmp(WORDS[i].name, name) == 0) {
            return i;
        }
    }
    return -1;
}
