/* Filters the notes on the rows of a study, so that each note is shown once.
 * Notes that differ only in digits, '.' and '-', the characters of numbers,
 * count as the same note: if the sun is below the horizon in a hundred rows,
 * the note on the first of these rows is shown. */
#ifndef MURK_API_LOG_ONCE_H
#define MURK_API_LOG_ONCE_H

#include <stdbool.h>
#include <stddef.h>

/* Writes to out[size] those of `notes`, a text with "; " between the notes,
 * that are not in *seen, and adds these notes to *seen. Returns false, with an
 * empty `out`, if there are none. Text that does not fit into `out` is cut off.
 * *seen is the text of all notes seen so far, without numbers. *seen is NULL at
 * first, and the caller releases it with free(). Without memory for *seen, a
 * note is written and not added. */
bool murk_log_once_news(char **seen, const char *notes, char *out, size_t size);

#endif
