/* A luminaire as a photometric file describes it
 * (luminaire/photometric_file.h).
 *
 * The luminous intensity is that of the file with all factors applied. LM-63:
 * candela multiplier, ballast factor and, before 2019, the ballast-lamp
 * photometric factor (the field that 1995 and 2002 reserve; in 2019 the field
 * is the file generation type and no factor). EULUMDAT: cd/klm times the flux
 * of all sets of lamps in klm times the conversion factor. The flux of a
 * luminaire is the integral of the intensity, not the flux that the file
 * declares.
 */
#ifndef MURK_LUMINAIRE_LUMINAIRE_H
#define MURK_LUMINAIRE_LUMINAIRE_H

#include "base/status.h"
#include "luminaire/intensity.h"

/* Largest number of pairs of TILT data: one a degree of 0..180. */
#define MURK_TILTS_MAX 181

/* The symmetry that the file states and the reader unfolds. */
typedef enum murk_luminaire_symmetry {
    MURK_SYMMETRY_NONE,
    MURK_SYMMETRY_AXIAL,     /* about the vertical axis */
    MURK_SYMMETRY_0_180,     /* about the plane C0-C180 */
    MURK_SYMMETRY_90_270,    /* about the plane C90-C270 */
    MURK_SYMMETRY_QUADRANT,  /* about both planes */
    MURK_SYMMETRY_LEFT_RIGHT /* types A and B: about H = 0 */
} murk_luminaire_symmetry;

/* The luminous opening, seen along the photometric zero. */
typedef enum murk_luminaire_aperture {
    MURK_APERTURE_POINT,
    MURK_APERTURE_RECT, /* along_c0_m times along_c90_m */
    MURK_APERTURE_DISC  /* of diameter along_c0_m */
} murk_luminaire_aperture;

typedef struct murk_luminaire {
    char format[24]; /* "LM-63-2002", "EULUMDAT" */
    char name[80];   /* printable ASCII; may be empty */
    murk_goniometer type;
    murk_luminaire_symmetry symmetry;
    size_t verticals, horizontals; /* angles in the file */
    double lamp_lumens; /* declared flux of all lamps; NAN: absolute photometry,
                         * or not stated */
    double declared_lumens; /* declared flux of the luminaire, EULUMDAT: of the
                             * lamps times the light output ratio; LM-63: that
                             * of the lamps; NAN as above */
    double input_w;         /* electrical input; 0: not stated */
    murk_luminaire_aperture aperture;
    double along_c0_m, along_c90_m;
    double height_m; /* of luminous sides, which make the opening a box or an
                      * upright cylinder; 0: none, or another shape */
    /* Factors of the flux by the tilt of the luminaire from straight down, of a
     * file with TILT data. */
    size_t tilts;
    double tilt_deg[MURK_TILTS_MAX]; /* [tilts], rising */
    double tilt_factor[MURK_TILTS_MAX];
    murk_intensity *intensity;
} murk_luminaire;

/* A copy that shares the table of intensities; NULL when out of memory. */
murk_luminaire *murk_luminaire_share(const murk_luminaire *luminaire);
void murk_luminaire_destroy(murk_luminaire *luminaire); /* NULL is fine */

/* The factor of the flux of a luminaire that points `tilt_deg` away from
 * straight down: linear between the angles of the TILT data, constant beyond
 * them, 1 without such data. The axis of the tilt does not count, which is
 * exact for a vertical lamp (lamp-to-luminaire geometry 1 of LM-63); the
 * reader warns of horizontal lamps. */
double murk_luminaire_tilt_factor(const murk_luminaire *luminaire,
                                  double tilt_deg);

/* The words of check, such as "symmetry about the axis". */
const char *murk_luminaire_symmetry_name(murk_luminaire_symmetry symmetry);
/* "C", "B", "A" */
const char *murk_luminaire_type_name(murk_goniometer type);

#endif
