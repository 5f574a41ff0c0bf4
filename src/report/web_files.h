/* The files under src/report/web/, of which pages are made, as part of the
 * program. cmake/built_in_files.cmake writes the definition. */
#ifndef MURK_REPORT_WEB_FILES_H
#define MURK_REPORT_WEB_FILES_H

#include <stddef.h>

typedef struct murk_web_file {
    const char *name; /* "page.css" */
    const char *text; /* ends with '\0' */
    size_t size;      /* without the '\0' */
} murk_web_file;

extern const murk_web_file murk_web_files[];
extern const size_t murk_web_files_count;

#endif
