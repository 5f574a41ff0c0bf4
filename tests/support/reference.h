/* The pages of the reference (doc/reference), for tests that compare them with
 * the tables of the program. Tests run in the top folder. */
#ifndef MURK_TESTS_REFERENCE_H
#define MURK_TESTS_REFERENCE_H

#include <glob.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "check.h"

/* All pages one behind the other; NULL: there are none. The caller frees it. */
static inline char *reference_read(void)
{
    glob_t pages = {0};
    char *all = NULL;
    size_t length = 0;
    CHECK(glob("doc/reference/[a-z]*.md", 0, NULL, &pages) == 0);
    for (size_t i = 0; i < pages.gl_pathc; ++i) {
        char *page = NULL;
        size_t size = 0;
        murk_error err = {0};
        CHECK(!murk_file_read(&page, &size, pages.gl_pathv[i], 1000000, &err));
        CHECK_TEXT(err.text, "");
        char *longer = page ? realloc(all, length + size + 1) : NULL;
        if (longer) {
            all = longer;
            memcpy(all + length, page, size + 1);
            length += size;
        }
        free(page);
    }
    globfree(&pages);
    return all;
}

#endif
