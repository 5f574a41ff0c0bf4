/* Reads the names of exports, which settings and options list with commas
 * between them: the position of a name in the list of names is the number of
 * the bit in murk_export. */
#include "base/export_kind.h"

#include <string.h>

murk_status murk_exports_read(unsigned *out, const char *words,
                              const char *where, murk_error *err)
{
    static const char *const known[] = {"matrix", "or-library", "lp",
                                        "fields", "photons",    "surfaces"};
    /* Word by word between commas; bit i of the result is word i. */
    for (const char *word = words;;) {
        const size_t length = strcspn(word, ",");
        unsigned bit = 0;
        for (unsigned i = 0; i < sizeof known / sizeof *known; ++i) {
            if (strlen(known[i]) == length &&
                strncmp(known[i], word, length) == 0) {
                bit = 1u << i;
            }
        }
        if (!bit) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "%s, must be of matrix, or-library, lp, fields, "
                             "photons, surfaces, with commas between",
                             words);
        }
        *out |= bit;
        if (!word[length]) {
            return MURK_OK;
        }
        word += length + 1;
    }
}
