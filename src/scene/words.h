/* Words of the user in messages: shown safely, and the one that was meant. */
#ifndef MURK_SCENE_WORDS_H
#define MURK_SCENE_WORDS_H

#include <stddef.h>

/* Copies text for a message: control characters escaped as murk_utf8_escape()
 * does, cut at a whole character with "..." when it is longer than size - 1
 * bytes (4 < size <= 512). `out` is not `text`. */
void murk_words_show(char *out, size_t size, const char *text);

/* Of `known[n]` (NULL entries are passed over) the word that was most likely
 * meant by `word`: the nearest by insertions, deletions, changes and swaps of
 * neighbours, if it takes at most a third of its letters (at least 1); else one
 * that begins with it. NULL when none is near; the earlier of equals. */
const char *murk_words_meant(const char *word, const char *const *known,
                             size_t n);

#endif
