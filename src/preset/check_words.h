/* Checks the words that a user gave for a preset, and fills in defaults. */
#ifndef MURK_PRESET_CHECK_WORDS_H
#define MURK_PRESET_CHECK_WORDS_H

#include "preset/preset.h"

/* The declaration of a word in a preset. That of mor_m follows from the
 * declaration of visibility_m. */
murk_preset_word murk_preset_word_of(const murk_preset *preset,
                                     murk_word_id word);

/* Fails with MURK_BAD_VALUE at `where` if the preset does not declare the word,
 * or a number is outside the range that the preset states. The ends of the
 * range are allowed. `value` has as many numbers as the word. */
murk_status murk_preset_check_word(const murk_preset *preset, murk_word_id word,
                                   const double *value, const char *where,
                                   murk_error *err);

/* Checks the given words, adds visibility_m if mor_m is given, and adds the
 * defaults of the preset for words that are not given. Fails with
 * MURK_BAD_VALUE at `where` as murk_preset_check_word() does, or if more than
 * one word that states an amount is given. */
murk_status murk_preset_complete(murk_words *words, const murk_preset *preset,
                                 const char *where, murk_error *err);

#endif
