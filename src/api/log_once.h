/* Filters the notes on the rows of a study, so that each note is shown once.
 * Notes that differ in their numbers alone count as the same note: if the sun
 * is below the horizon in a hundred rows, the note on the first of them is
 * shown. */
#ifndef MURK_API_LOG_ONCE_H
#define MURK_API_LOG_ONCE_H

#include <stdbool.h>
#include <stddef.h>

/* Writes to out[size] those of `notes`, a text with "; " between the notes,
 * that are not in *seen, and adds them to *seen. Returns false if all of them
 * were seen. *seen is a text of one line for each note, without numbers; it is
 * NULL at first, and the caller frees it with free(). Out of memory, notes are
 * written and not added. */
bool murk_log_once_news(char **seen, const char *notes, char *out, size_t size);

#endif
