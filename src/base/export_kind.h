/* The exports that a user may ask for beside the files of results, and their
 * names. */
#ifndef MURK_BASE_EXPORT_KIND_H
#define MURK_BASE_EXPORT_KIND_H

#include "base/status.h"

/* Bits, in the order of the names in export_kind.c. */
typedef enum murk_export {
    MURK_EXPORT_MATRIX = 1,
    MURK_EXPORT_OR_LIBRARY = 2,
    MURK_EXPORT_LP = 4,
    MURK_EXPORT_FIELDS = 8,
    MURK_EXPORT_PHOTONS = 16,
    MURK_EXPORT_SURFACES = 32,
    MURK_EXPORT_LIGHT = 64, /* light.murk, which all but murk follow write in
                             * any case */
    MURK_EXPORT_GEOJSON = 128,
    MURK_EXPORT_GEO_CSV = 256
} murk_export;

/* The exports of sensors alone. */
#define MURK_EXPORTS_OF_SENSORS (MURK_EXPORT_GEOJSON | MURK_EXPORT_GEO_CSV)

/* The exports of a plan alone, of a scene or of a matrix; all others need a
 * scene. */
#define MURK_EXPORTS_OF_PROBLEM \
    (MURK_EXPORT_MATRIX | MURK_EXPORT_OR_LIBRARY | MURK_EXPORT_LP)

/* Reads the names of exports, with commas between them and blanks around them,
 * and adds their murk_export bits to *out. where: the name of the setting, for
 * messages. */
murk_status murk_exports_read(unsigned *out, const char *words,
                              const char *where, murk_error *err);

#endif
