/* The table of library.h's subjects, as Markdown.
 *
 *   library [--nightly] [SUBJECT...]
 *
 * Exit 1 when a row is off or nothing was compared. */
#include "library/library.h"

#include <math.h>
#include <string.h>

typedef struct subject {
    const char *name;
    void (*compare)(murk_library *library);
} subject;

static const subject SUBJECTS[] = {
#define X(name) {#name, murk_library_##name},
    MURK_LIBRARY_SUBJECTS(X)
#undef X
        {NULL, NULL},
};

void murk_library_title(murk_library *library, const char *title,
                        const char *text)
{
    fprintf(library->out,
            "\n### %s\n\n%s\n\n| quantity | unit | reference | murk | off by | "
            "limit | source |\n|---|---|---|---|---|---|---|\n",
            title, text);
}

void murk_library_row(murk_library *library, const char *quantity,
                      const char *unit, double reference, double value,
                      double limit, const char *why, const char *source)
{
    const double off = value - reference;
    const bool holds = fabs(off) <= limit; /* a NaN does not */
    library->rows += 1;
    library->off += !holds;
    fprintf(library->out,
            "| %s | %s | %.10g | %.10g | %+.2g | %.2g (%s)%s | %s |\n",
            quantity, unit, reference, value, off, limit, why,
            holds ? "" : " **off**", source);
}

static const subject *find(const char *name)
{
    const subject *s = SUBJECTS;
    while (s->name && strcmp(s->name, name) != 0) {
        ++s;
    }
    return s->name ? s : NULL;
}

int main(int n, char **word)
{
    /* Check the words before the first comparison, since a misspelled
     * subject would otherwise end a long run. */
    murk_library library = {.out = stdout};
    bool is_chosen = false;
    for (int i = 1; i < n; ++i) {
        if (strcmp(word[i], "--nightly") == 0) {
            library.is_nightly = true;
            continue;
        }
        const subject *s = find(word[i]);
        if (!s) {
            fprintf(stderr, "library: no subject %s\n", word[i]);
            return 2;
        }
        is_chosen = true;
    }
    /* Compare the subjects that are named, or all of them if none is. */
    printf("## Media and sky\n");
    for (const subject *s = SUBJECTS; s->name; ++s) {
        bool is_wanted = !is_chosen;
        for (int i = 1; i < n; ++i) {
            is_wanted = is_wanted || strcmp(word[i], s->name) == 0;
        }
        if (is_wanted) {
            s->compare(&library);
        }
    }
    /* Fail if a row is off, or if nothing was compared. */
    printf("\n%d rows, %d off.\n", library.rows, library.off);
    return library.off > 0 || library.rows == 0;
}
