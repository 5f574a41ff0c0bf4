/* HTML for the report: escaped text, bytes, hashes. Text from files and names
 * is written by murk_html_text(), so that it cannot be markup. Failures of
 * writing show when the file is committed. */
#ifndef MURK_REPORT_HTML_H
#define MURK_REPORT_HTML_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#define MURK_HTML_NONE "\xe2\x80\x93" /* en dash: no value */

/* Writes text between tags or in a quoted attribute. Bytes that are not UTF-8
 * and control characters except tab and line feed become U+FFFD. NULL writes
 * nothing. */
void murk_html_text(FILE *to, const char *text);

void murk_html_base64(FILE *to, const void *bytes, size_t size);

/* Writes "sha256-..." in base64: the source of a content security policy that
 * allows only a script or style of this text. */
#define MURK_HTML_HASH_SIZE 56
void murk_html_hash(char out[MURK_HTML_HASH_SIZE], const char *text,
                    size_t size);

#endif
