/* Reads a photometric file of either format, and releases luminaires. */
#include "luminaire/luminaire.h"

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

murk_luminaire *murk_luminaire_share(const murk_luminaire *luminaire)
{
    murk_luminaire *copy = malloc(sizeof *copy);
    if (copy) {
        *copy = *luminaire;
        copy->intensity = murk_intensity_share(luminaire->intensity);
    }
    return copy;
}

void murk_luminaire_destroy(murk_luminaire *luminaire)
{
    if (luminaire) {
        murk_intensity_destroy(luminaire->intensity);
        free(luminaire);
    }
}

double murk_luminaire_tilt_factor(const murk_luminaire *luminaire,
                                  double tilt_deg)
{
    const size_t n = luminaire->tilts;
    const double *deg = luminaire->tilt_deg, *factor = luminaire->tilt_factor;
    if (n == 0 || !(tilt_deg > deg[0])) {
        return n == 0 ? 1 : factor[0];
    }
    for (size_t i = 1; i < n; ++i) {
        if (tilt_deg < deg[i]) {
            const double t = (tilt_deg - deg[i - 1]) / (deg[i] - deg[i - 1]);
            return (1 - t) * factor[i - 1] + t * factor[i];
        }
    }
    return factor[n - 1];
}

const char *murk_luminaire_symmetry_name(murk_luminaire_symmetry symmetry)
{
    static const char *const name[] = {
        [MURK_SYMMETRY_NONE] = "no symmetry",
        [MURK_SYMMETRY_AXIAL] = "symmetry about the axis",
        [MURK_SYMMETRY_0_180] = "symmetry about the plane C0-C180",
        [MURK_SYMMETRY_90_270] = "symmetry about the plane C90-C270",
        [MURK_SYMMETRY_QUADRANT] = "symmetry about C0-C180 and C90-C270",
        [MURK_SYMMETRY_LEFT_RIGHT] = "symmetry about H = 0"};
    return name[symmetry];
}

const char *murk_luminaire_type_name(murk_goniometer type)
{
    return type == MURK_GONIOMETER_C   ? "C"
           : type == MURK_GONIOMETER_B ? "B"
                                       : "A";
}
