/* Checks the words of a user against the ranges of a preset and completes them
 * with the defaults of the preset. Of the words that state an amount only one
 * may be given. */
#include "preset/check_words.h"

#include "preset/visibility.h"

#include <stdio.h>

/* The range of mor_m: that of visibility_m, converted to the other contrast. */
static murk_preset_word of_mor(const murk_preset_word *visibility)
{
    murk_preset_word mor = *visibility;
    const double factor = murk_visibility_of_mor(1);
    mor.min[0] /= factor;
    mor.max[0] /= factor;
    mor.has_preset = false;
    return mor;
}

murk_preset_word murk_preset_word_of(const murk_preset *preset,
                                     murk_word_id word)
{
    return word == MURK_WORD_MOR && preset->word[MURK_WORD_VISIBILITY].is_known
               ? of_mor(&preset->word[MURK_WORD_VISIBILITY])
               : preset->word[word];
}

static murk_status fail_unknown(const murk_preset *preset, const char *where,
                                murk_error *err)
{
    char list[300] = "";
    size_t length = 0;
    for (int i = 0; i < MURK_WORDS; ++i) {
        if (murk_preset_word_of(preset, (murk_word_id)i).is_known) {
            length +=
                (size_t)snprintf(list + length, sizeof list - length, "%s%s",
                                 length ? ", " : "", murk_word_rows[i].name);
        }
    }
    return murk_fail(err, MURK_BAD_VALUE, where,
                     length ? "%s does not know it, must be one of %s"
                            : "%s does not know it%s: it has no words",
                     preset->name, list);
}

murk_status murk_preset_check_word(const murk_preset *preset, murk_word_id word,
                                   const double *value, const char *where,
                                   murk_error *err)
{
    const murk_preset_word range = murk_preset_word_of(preset, word);
    if (!range.is_known) {
        return fail_unknown(preset, where, err);
    }
    for (int k = 0; k < murk_word_rows[word].numbers; ++k) {
        if (!(value[k] >= range.min[k] && value[k] <= range.max[k])) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "%.9g, must be %.6g..%.6g %s for %s", value[k],
                             range.min[k], range.max[k],
                             murk_word_rows[word].unit, preset->name);
        }
    }
    return MURK_OK;
}

static murk_status check_amounts(const murk_words *words, const char *where,
                                 murk_error *err)
{
    const char *first = NULL;
    for (int i = 0; i < MURK_WORDS; ++i) {
        if (words->given[i] && murk_word_rows[i].is_amount) {
            const char *name = murk_word_rows[i].name;
            if (first) {
                return murk_fail(err, MURK_BAD_VALUE, where,
                                 "has %s and %s, must have one of them", first,
                                 name);
            }
            first = name;
        }
    }
    return MURK_OK;
}

murk_status murk_preset_complete(murk_words *words, const murk_preset *preset,
                                 const char *where, murk_error *err)
{
    /* Check ranges and that at most one amount is given. */
    for (int i = 0; i < MURK_WORDS; ++i) {
        if (words->given[i]) {
            const murk_status status = murk_preset_check_word(
                preset, (murk_word_id)i, words->value[i], where, err);
            if (status) {
                return status;
            }
        }
    }
    const murk_status status = check_amounts(words, where, err);
    if (status) {
        return status;
    }
    /* Convert mor_m, then fill in defaults. */
    if (words->given[MURK_WORD_MOR]) {
        words->given[MURK_WORD_VISIBILITY] = true;
        words->value[MURK_WORD_VISIBILITY][0] =
            murk_visibility_of_mor(words->value[MURK_WORD_MOR][0]);
    }
    for (int i = 0; i < MURK_WORDS; ++i) {
        const murk_preset_word *word = &preset->word[i];
        if (word->is_known && word->has_preset && !words->given[i]) {
            words->given[i] = true;
            for (int k = 0; k < MURK_WORD_NUMBERS_MAX; ++k) {
                words->value[i][k] = word->preset[k];
            }
        }
    }
    return MURK_OK;
}
