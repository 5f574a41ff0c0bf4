/* The table of a photometric file as it stands in the file, and how symmetries
 * are unfolded. For use inside src/luminaire only. */
#ifndef MURK_LUMINAIRE_TABLE_H
#define MURK_LUMINAIRE_TABLE_H

#include "luminaire/luminaire.h"
#include "luminaire/text.h"

/* Ranges of numbers in both formats: what lies beyond is a mistake. */
#define MURK_LUMINAIRE_CANDELA_MAX 1e12
#define MURK_LUMINAIRE_FACTOR_MIN  1e-9
#define MURK_LUMINAIRE_FACTOR_MAX  1e9
#define MURK_LUMINAIRE_WATTS_MAX   1e9

/* Begins as zeros; the arrays belong to the struct. */
typedef struct murk_luminaire_table {
    size_t verticals, planes;
    double *vertical_deg, *plane_deg; /* rising */
    double *candela;                  /* [planes * verticals] */
} murk_luminaire_table;

/* Allocates the arrays. Fails with MURK_BAD_FILE at the line if the table is
 * too large (MURK_INTENSITY_VALUES_MAX after unfolding), and with
 * MURK_NO_MEMORY. */
murk_status murk_luminaire_table_create(murk_luminaire_table *out,
                                        size_t verticals, size_t planes,
                                        const murk_luminaire_text *text,
                                        size_t line);
void murk_luminaire_table_release(murk_luminaire_table *table);

/* Unfolds the table by out->symmetry and out->type into out->intensity. The
 * planes begin and end as the symmetry asks: axial: one plane; C0-C180: 0..180;
 * C90-C270: half a turn from one of both; quadrant: 0..90; none: one full turn;
 * left-right: from 0. Warns of angles that stop early. Fails as
 * murk_intensity_create(). */
murk_status murk_luminaire_unfold(murk_luminaire *out,
                                  const murk_luminaire_table *table,
                                  double scale, const char *where,
                                  murk_error *err);

/* The readers of both formats. They fill *out, which is zero, and return as
 * murk_luminaire_parse() does. */
murk_status murk_luminaire_read_ies(murk_luminaire *out, const char *path,
                                    char *text, size_t size, murk_error *err);
murk_status murk_luminaire_read_eulumdat(murk_luminaire *out, const char *path,
                                         char *text, size_t size,
                                         murk_error *err);

#endif
