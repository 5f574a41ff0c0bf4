/* Presets describe fog, rain, smoke, air and water in the words of users;
 * src/preset turns presets into extinction, albedo and phase function for each
 * band.
 *
 * A preset is a small file, media/FAMILY/NAME.yaml, which is built into the
 * library (files.h) and which scene/presets.h reads into the plain structs
 * below. A preset is a sum of parts. A part takes coefficients from a law
 * (law.h) or from a table by wavelength, and a phase function from the law or
 * from the file. Nothing is extrapolated: a band outside the wavelengths of the
 * file is refused.
 *
 * Visibility is defined by Koschmieder: extinction at 550 nm = -ln(.02) /
 * visibility_m = -ln(.05) / mor_m (WMO Guide to Instruments and Methods of
 * Observation, WMO-8, chapter on visibility). */
#ifndef MURK_PRESET_PRESET_H
#define MURK_PRESET_PRESET_H

#include "base/bands.h"
#include "base/phase_kind.h"
#include "base/status.h"
#include "preset/words.h"

#include <stdbool.h>
#include <stddef.h>

/* Parts and parameters: more than any preset in media/ has. */
#define MURK_PRESET_PARTS_MAX      8
#define MURK_PRESET_PARAMETERS_MAX 8
#define MURK_PRESET_SAMPLES        16  /* midpoints of a band with edges */
#define MURK_VISIBILITY_NM         550 /* WMO-8 */

typedef struct murk_law murk_law; /* law.h */

/* Tabulated phase functions by angle: one or more columns, each with an
 * arbitrary scale. */
typedef struct murk_preset_angles {
    size_t angles, columns;
    double *wavelength_nm; /* [columns] rising; NULL: one column for all
                            * wavelengths, or columns that a law selects by
                            * murk_preset_phase.column */
    double *angle_deg;     /* [angles] rising, the first 0..10, the last
                            * 150..180 (murk_phase_rows of
                            * medium/phase_table.h) */
    double *phase_per_sr;  /* [columns * angles], column by column */
} murk_preset_angles;

/* The caller destroys *out with murk_preset_angles_destroy(). Arrays are filled
 * with 0. The array wavelength_nm is made if by_wavelength is set, else NULL.
 * Fails with MURK_NO_MEMORY. */
murk_status murk_preset_angles_create(murk_preset_angles **out, size_t angles,
                                      size_t columns, bool by_wavelength,
                                      murk_error *err);
void murk_preset_angles_destroy(murk_preset_angles *angles); /* NULL is fine */

typedef struct murk_preset_phase {
    murk_phase_kind kind;
    double value[MURK_PHASE_NUMBERS_MAX];
    const murk_preset_angles *angles; /* of a table: the column `column` */
    size_t column;
} murk_preset_phase;

/* Coefficients by wavelength, linear between rows. A NULL column means 0. */
typedef struct murk_preset_table {
    size_t n;
    double *wavelength_nm; /* rising */
    double *absorption_per_m, *scattering_per_m;
    double *mean_cosine;               /* of Henyey-Greenstein; NULL: none */
    double *diffuse_attenuation_per_m; /* for laws that use it (by_table); else
                                        * NULL */
} murk_preset_table;

/* The index of the interval of n >= 2 rising wavelengths that contains a
 * wavelength, or of the nearest interval; *share is the position between the
 * two ends, 0..1 inside. */
size_t murk_preset_interval(const double *at, size_t n, double wavelength_nm,
                            double *share);

/* The value of a column of a table at a wavelength, linear between rows. Beyond
 * the first and the last row the nearest line is continued; a table of one row
 * is constant. */
double murk_preset_table_at(const murk_preset_table *table,
                            const double *column, double wavelength_nm);

/* A part of a preset. The coefficients of all parts add up, and the phase
 * functions are mixed by scattering. */
typedef struct murk_preset_part {
    const murk_law *law;                          /* NULL: the table gives the
                                                   * coefficients */
    double parameter[MURK_PRESET_PARAMETERS_MAX]; /* parameters of the law, in
                                                   * the order of murk_law */
    murk_preset_table table;                      /* n 0: no table */
    int times;      /* the murk_word_id by which the part is multiplied; -1:
                     * none */
    bool scaled;    /* the part is scaled to the visibility, if one is given */
    bool has_phase; /* if false, the law or the mean cosine of the table gives
                     * the phase function; without these the part
                     * scatters isotropically */
    murk_preset_phase phase;
    murk_preset_angles *angles; /* columns of `phase` by wavelength; or NULL */
} murk_preset_part;

/* A literature reference of a preset. */
typedef struct murk_preset_source {
    char *what, *from; /* subject; citation */
    char *quoted_by;   /* a secondary source from which the numbers of `from`
                        * were taken; NULL: taken from the source itself */
} murk_preset_source;

/* A list of texts. */
typedef struct murk_preset_texts {
    size_t n;
    char **text; /* [n] */
} murk_preset_texts;

/* A word of a preset, with the default `preset` and the range of each number.
 * is_known: the preset declares the word; has_preset: there is a default. */
typedef struct murk_preset_word {
    bool is_known, has_preset;
    double preset[MURK_WORD_NUMBERS_MAX];
    double min[MURK_WORD_NUMBERS_MAX], max[MURK_WORD_NUMBERS_MAX];
} murk_preset_word;

typedef struct murk_preset {
    char *name; /* e.g. "fog/kruse" */
    char *about;
    murk_preset_source *source; /* [sources], at least 1 */
    size_t sources;
    murk_preset_texts doubts;
    double wavelength_nm[2]; /* smallest, largest */
    bool scaled_may_vanish;  /* if the other parts have more extinction than the
                              * visibility says, the scaled parts have none;
                              * false: that is refused */
    murk_preset_word word[MURK_WORDS]; /* without mor_m: murk_preset_word_of()
                                        * of check_words.h */
    murk_preset_part part[MURK_PRESET_PARTS_MAX];
    size_t parts;
} murk_preset;

void murk_preset_destroy(murk_preset *preset); /* NULL is fine */

/* The phase function of a band: a mixture with weights in proportion to
 * scattering. */
typedef struct murk_mixture_part {
    double share;
    murk_phase_kind kind;
    double value[MURK_PHASE_NUMBERS_MAX];
    size_t angles; /* of a table (MURK_PHASE_TABLE), else 0 */
    double *angle_deg, *phase_per_sr;
} murk_mixture_part;

typedef struct murk_mixture {
    size_t n;
    murk_mixture_part *part; /* [n]; shares sum to 1 */
} murk_mixture;

void murk_mixture_destroy(murk_mixture *mixture); /* NULL is fine */

/* The bands of the scene: n wavelengths, or n + 1 edges. */
typedef struct murk_preset_bands {
    int n;
    const double *line_nm; /* [n] */
    const double *edge_nm; /* [n + 1]; NULL: wavelengths */
} murk_preset_bands;

/* The optical properties of a preset, band by band. */
typedef struct murk_preset_result {
    murk_spectrum extinction_per_m, albedo; /* albedo 1 if extinction is 0 */
    murk_mixture *mixture[MURK_BANDS_MAX];  /* NULL for bands past the last */
} murk_preset_result;

/* Evaluates a preset: at a single wavelength the value there, for a band with
 * edges the mean over MURK_PRESET_SAMPLES wavelengths. `albedo` is the ratio of
 * the mean scattering to the mean extinction. Fails with MURK_BAD_VALUE at
 * `where` if a word is unknown to the preset or outside the range of the
 * preset, if several words state an amount, if a band is outside the
 * wavelengths of the preset, if parts cannot be scaled to the visibility, or if
 * a part has an extinction above 1e9 1/m; also as laws do, and with
 * MURK_NO_MEMORY. The caller releases *out with murk_preset_result_release();
 * on failure *out is unchanged. */
murk_status murk_preset_evaluate(murk_preset_result *out,
                                 const murk_preset *preset,
                                 const murk_words *words,
                                 const murk_preset_bands *bands,
                                 const char *where, murk_error *err);
void murk_preset_result_release(murk_preset_result *result);

#endif
