/* Reads a photometric file of either format. A line that begins with TILT=,
 * which LM-63 asks for, tells the formats apart; ies.c and eulumdat.c read
 * them. */
#include "luminaire/photometric_file.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/file.h"
#include "luminaire/table.h"

/* True if a line of the text begins with "TILT=", which every file of LM-63
 * has. */
static bool has_tilt_line(const char *text, size_t size)
{
    static const char mark[] = "TILT=";
    const size_t length = sizeof mark - 1;
    bool begins_line = true;
    for (size_t i = 0; i + length <= size; ++i) {
        if (begins_line && strncasecmp(text + i, mark, length) == 0) {
            return true;
        }
        begins_line = text[i] == '\n' || text[i] == '\r' ||
                      (begins_line && (text[i] == ' ' || text[i] == '\t'));
    }
    return false;
}

static bool ends_with_ies(const char *path)
{
    const size_t n = strlen(path);
    return n >= 4 && strcasecmp(path + n - 4, ".ies") == 0;
}

murk_status murk_luminaire_parse(murk_luminaire **out, const char *path,
                                 char *text, size_t size, murk_error *err)
{
    murk_luminaire *made = calloc(1, sizeof *made);
    if (!made) {
        return murk_no_memory(err, path, "for a luminaire");
    }
    const murk_status status =
        has_tilt_line(text, size) || ends_with_ies(path)
            ? murk_luminaire_read_ies(made, path, text, size, err)
            : murk_luminaire_read_eulumdat(made, path, text, size, err);
    if (status) {
        murk_luminaire_destroy(made);
        return status;
    }
    *out = made;
    return MURK_OK;
}

murk_status murk_luminaire_read(murk_luminaire **out, const char *path,
                                murk_error *err)
{
    char *text = NULL;
    size_t size = 0;
    murk_status status =
        murk_file_read(&text, &size, path, MURK_LUMINAIRE_BYTES_MAX, err);
    if (!status) {
        status = murk_luminaire_parse(out, path, text, size, err);
    }
    free(text);
    return status;
}
