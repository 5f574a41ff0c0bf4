/* Words of the user in messages: safe printing, and suggestions for
 * misspelled words. */
#ifndef MURK_BASE_WORDS_H
#define MURK_BASE_WORDS_H

#include <stddef.h>

/* Copies text for a message. Control characters are escaped as by
 * murk_utf8_escape(). If the escaped text is longer than size - 1 bytes, the
 * copy is cut at a whole character and ends with "..." (4 <= size <= 512).
 * `out` must not be `text`. */
void murk_words_show(char *out, size_t size, const char *text);

/* The word of known[n] (NULL entries are skipped) that the user most likely
 * meant by `word`: the nearest by insertions, deletions, changes and swaps of
 * neighbours, if the distance is at most a third of the length (at least 1);
 * otherwise, for a `word` of 3 bytes or more, the first that begins with
 * `word`. Of equally near words the first counts. NULL if no word is near, or
 * `word` is empty or longer than 64 bytes. */
const char *murk_words_meant(const char *word, const char *const *known,
                             size_t n);

/* ", did you mean WORD?" for the word that was meant, with control characters
 * escaped; empty if no word is near. */
typedef struct murk_suggestion {
    char text[96];
} murk_suggestion;
murk_suggestion murk_words_suggest(const char *word, const char *const *known,
                                   size_t n);

#endif
