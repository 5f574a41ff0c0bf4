/* Reads the names of exports, which settings and options list with commas
 * between them, and blanks around them: the position of a name in the list of
 * names is the number of the bit in murk_export. */
#include "base/export_kind.h"

#include "base/words.h"

#include <stdio.h>
#include <string.h>

/* Bytes for a word in a message. */
#define SHOWN_SIZE 96

static const char blanks[] = " \t";

murk_status murk_exports_read(unsigned *out, const char *words,
                              const char *where, murk_error *err)
{
    static const char *const known[] = {"matrix", "or-library", "lp",
                                        "fields", "photons",    "surfaces",
                                        "light",  "geojson",    "geo-csv"};
    /* Word by word between commas; bit i of the result is word i. */
    for (const char *at = words;;) {
        const size_t length = strcspn(at, ",");
        const size_t before = strspn(at, blanks);
        const char *word = at + (before < length ? before : length);
        size_t letters = length - (size_t)(word - at);
        while (letters > 0 && strchr(blanks, word[letters - 1])) {
            --letters;
        }
        unsigned bit = 0;
        for (unsigned i = 0; i < sizeof known / sizeof *known; ++i) {
            if (strlen(known[i]) == letters &&
                strncmp(known[i], word, letters) == 0) {
                bit = 1u << i;
            }
        }
        if (!bit) {
            char cut[SHOWN_SIZE], shown[SHOWN_SIZE];
            snprintf(cut, sizeof cut, "%.*s", (int)letters, word);
            murk_words_show(shown, sizeof shown, cut);
            return murk_fail(
                err, MURK_BAD_VALUE, where,
                "\"%s\" is not an export; allowed are matrix, "
                "or-library, lp, fields, photons, surfaces, light, geojson and "
                "geo-csv, "
                "with commas between",
                shown);
        }
        *out |= bit;
        if (!at[length]) {
            return MURK_OK;
        }
        at += length + 1;
    }
}
