/* HTML as the report writes it: escaped text, bytes, hashes.
 *
 * Whatever comes out of a file or a name goes through murk_html_text(), so it
 * can never be markup. Errors of writing are the stream's: commit asks it. */
#ifndef MURK_REPORT_HTML_H
#define MURK_REPORT_HTML_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#define MURK_HTML_NONE "\xe2\x80\x93" /* en dash: there is no value */

/* Text between tags or in a quoted attribute. What is no UTF-8, and control
 * characters, become U+FFFD. NULL is no text. */
void murk_html_text(FILE *to, const char *text);

void murk_html_base64(FILE *to, const void *bytes, size_t size);

/* The source of a content security policy that lets this text, and no other,
 * run or style: sha256-... */
#define MURK_HTML_HASH_SIZE 56
void murk_html_hash(char out[MURK_HTML_HASH_SIZE], const char *text,
                    size_t size);

#endif
