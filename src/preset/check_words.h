/* The words of one preset: known ones, within their ranges, with defaults. */
#ifndef MURK_PRESET_CHECK_WORDS_H
#define MURK_PRESET_CHECK_WORDS_H

#include "preset/preset.h"

/* What the preset says of a word; mor_m by what it says of visibility_m. */
murk_preset_word murk_preset_word_of(const murk_preset *preset,
                                     murk_word_id word);

/* MURK_BAD_VALUE at `where` when the preset does not know the word, or a number
 * of it is outside the preset's range. `value` has the word's numbers. */
murk_status murk_preset_check_word(const murk_preset *preset, murk_word_id word,
                                   const double *value, const char *where,
                                   murk_error *err);

/* Words that each say how much there is: a user may say one of them, and then
 * no default of another holds. */
bool murk_word_is_amount(murk_word_id word);

/* Checks the words that are given, turns mor_m into visibility_m, and adds the
 * preset's defaults. */
murk_status murk_preset_complete(murk_words *words, const murk_preset *preset,
                                 const char *where, murk_error *err);

#endif
