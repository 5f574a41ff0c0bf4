/* Prints words of the user in messages, and finds the word that was meant by
 * the optimal string alignment distance (Damerau, Commun. ACM 7 (1964) 171,
 * doi:10.1145/363958.363994). */
#include "base/words.h"

#include "base/utf8.h"

#include <assert.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* A row of the distance table has one more entry than a word has letters. */
#define ROW_LENGTH (MAX_LETTERS + 1)

#define LONGER_SIZE (SHOWN_MAX + ESCAPE_MAX)

#define MAX_LETTERS 64 /* longer words are not compared */

#define SHOWN_MAX  512 /* bytes of a copy */
#define ESCAPE_MAX 16  /* bytes of one character, escaped */

void murk_words_show(char *out, size_t size, const char *text)
{
    static const char cut[] = "...";
    char longer[LONGER_SIZE];
    assert(out != text && size >= sizeof cut && size <= SHOWN_MAX);
    /* One more character than fits shows that the text is longer than the
     * copy. */
    const size_t whole = murk_utf8_escape(longer, size + ESCAPE_MAX, text);
    if (whole < size) {
        memcpy(out, longer, whole + 1);
        return;
    }
    const size_t length = murk_utf8_escape(out, size - (sizeof cut - 1), text);
    memcpy(out + length, cut, sizeof cut);
}

static size_t min(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Optimal string alignment distance, row by row. */
static size_t distance(const char *a, size_t n, const char *b, size_t m)
{
    size_t rows[3][ROW_LENGTH];
    size_t *before = rows[0], *above = rows[1], *row = rows[2];
    for (size_t j = 0; j <= m; ++j) {
        before[j] = 0; /* read only from the second row on */
        above[j] = j;
    }
    for (size_t i = 1; i <= n; ++i) {
        row[0] = i;
        for (size_t j = 1; j <= m; ++j) {
            const size_t change = above[j - 1] + (a[i - 1] != b[j - 1]);
            row[j] = min(change, min(above[j], row[j - 1]) + 1);
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] &&
                a[i - 2] == b[j - 1]) {
                row[j] = min(row[j], before[j - 2] + 1);
            }
        }
        size_t *const free_row = before;
        before = above;
        above = row;
        row = free_row;
    }
    return above[m];
}

const char *murk_words_meant(const char *word, const char *const *known,
                             size_t n)
{
    const size_t length = strlen(word);
    const char *meant = NULL;
    size_t nearest =
        (length < 3 ? 1 : length / 3) + 1; /* one more than allowed */
    if (length == 0 || length > MAX_LETTERS) {
        return NULL;
    }
    for (size_t i = 0; i < n; ++i) {
        const size_t other = known[i] ? strlen(known[i]) : 0;
        if (other == 0 || other > MAX_LETTERS) {
            continue;
        }
        const size_t d = distance(word, length, known[i], other);
        if (d < nearest) {
            nearest = d;
            meant = known[i];
        }
    }
    for (size_t i = 0; i < n && !meant && length >= 3; ++i) {
        if (known[i] && strncmp(known[i], word, length) == 0) {
            meant = known[i];
        }
    }
    return meant;
}

murk_suggestion murk_words_suggest(const char *word, const char *const *known,
                                   size_t n)
{
    murk_suggestion out = {""};
    char shown[64];
    const char *meant = murk_words_meant(word, known, n);
    if (meant) {
        murk_words_show(shown, sizeof shown, meant);
        snprintf(out.text, sizeof out.text, ", did you mean %s?", shown);
    }
    return out;
}
