/* The files under src/report/web/ that pages are made of, built in. Written by
 * cmake/built_in_files.cmake. */
#ifndef MURK_REPORT_WEB_FILES_H
#define MURK_REPORT_WEB_FILES_H

#include <stddef.h>

typedef struct murk_web_file {
    const char *name; /* "page.css" */
    const char *text; /* with a '\0' behind it */
    size_t size;      /* without it */
} murk_web_file;

extern const murk_web_file murk_web_files[];
extern const size_t murk_web_files_count;

#endif
