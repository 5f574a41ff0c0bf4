/* Owners of luminaires, the factor of the flux by the tilt, linear between the
 * angles of the file, and the words for symmetries and photometric types. */
#include "luminaire/luminaire.h"

#include <stdlib.h>

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
