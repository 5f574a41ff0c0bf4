/* Presets: fog, rain, smoke, air and water in the words that users know, turned
 * into extinction, albedo and phase function, band by band.
 *
 * A preset is a small file, media/FAMILY/NAME.yaml, built into the library
 * (files.h) and read by scene/presets.h into the plain structs here. It is a
 * sum of parts; a part takes its coefficients from a law (law.h) or from a
 * table by wavelength, and its phase function from the law or from the file.
 * Nothing is extrapolated: outside the file's wavelengths a preset is refused.
 *
 * Visibility is Koschmieder's: extinction at 550 nm = -ln(.02) / visibility_m =
 * -ln(.05) / mor_m (WMO Guide to Instruments and Methods of Observation, WMO-8,
 * chapter on visibility). */
#ifndef MURK_PRESET_PRESET_H
#define MURK_PRESET_PRESET_H

#include "base/bands.h"
#include "base/phase_kind.h"
#include "base/status.h"
#include "preset/words.h"

#include <stdbool.h>
#include <stddef.h>

#define MURK_PRESET_PARTS_MAX      8
#define MURK_PRESET_PARAMETERS_MAX 8
#define MURK_PRESET_SAMPLES        16 /* wavelengths in a band with edges */
#define MURK_VISIBILITY_NM         550

typedef struct murk_law murk_law; /* law.h */

/* Phase functions by angle, one or more columns, each of any scale. */
typedef struct murk_preset_angles {
    size_t angles, columns;
    double *wavelength_nm; /* [columns] rising; NULL: one column, for all */
    double *angle_deg;     /* [angles] as murk_phase_rows wants them */
    double *phase_per_sr;  /* [columns * angles], column by column */
} murk_preset_angles;

/* *out is the caller's: murk_preset_angles_destroy(). Arrays are zero; without
 * columns that differ (by_wavelength) there is no wavelength_nm. */
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

/* Coefficients by wavelength, linear between. NULL columns are 0. */
typedef struct murk_preset_table {
    size_t n;
    double *wavelength_nm; /* rising */
    double *absorption_per_m, *scattering_per_m;
    double *mean_cosine;               /* NULL: none; of Henyey-Greenstein */
    double *diffuse_attenuation_per_m; /* for a law that is by it; else NULL */
} murk_preset_table;

/* A column of a table at a wavelength: linear between rows; before the first
 * and behind the last the line goes on. */
double murk_preset_table_at(const murk_preset_table *table,
                            const double *column, double wavelength_nm);

typedef struct murk_preset_part {
    const murk_law *law;                          /* NULL: the table */
    double parameter[MURK_PRESET_PARAMETERS_MAX]; /* the law's, in its order */
    murk_preset_table table;                      /* n 0: none */
    int times;      /* a murk_word that multiplies the part; -1: none */
    bool scaled;    /* to the visibility, where one is known */
    bool has_phase; /* else the law, or the table's mean cosine */
    murk_preset_phase phase;
    murk_preset_angles *angles; /* of `phase`, by wavelength; or NULL */
} murk_preset_part;

typedef struct murk_preset_source {
    char *what, *from;
    char *quoted_by; /* where it was read; NULL: in the source itself */
} murk_preset_source;

typedef struct murk_preset_word {
    bool is_known, has_preset;
    double preset[MURK_WORD_NUMBERS_MAX];
    double min[MURK_WORD_NUMBERS_MAX], max[MURK_WORD_NUMBERS_MAX];
} murk_preset_word;

typedef struct murk_preset {
    char *name; /* "fog/kruse" */
    char *about;
    murk_preset_source *source; /* [sources], at least 1 */
    size_t sources;
    char **doubt; /* [doubts] */
    size_t doubts;
    double wavelength_nm[2];           /* least, most */
    murk_preset_word word[MURK_WORDS]; /* mor_m is known where visibility_m is
                                        */
    murk_preset_part part[MURK_PRESET_PARTS_MAX];
    size_t parts;
} murk_preset;

void murk_preset_destroy(murk_preset *preset); /* NULL is fine */

/* How a band's light turns: phase functions by their share of scattering. */
typedef struct murk_mixture_part {
    double share;
    murk_phase_kind kind;
    double value[MURK_PHASE_NUMBERS_MAX];
    size_t angles; /* MURK_PHASE_TABLE */
    double *angle_deg, *phase_per_sr;
} murk_mixture_part;

typedef struct murk_mixture {
    size_t n;
    murk_mixture_part *part; /* [n]; shares sum to 1 */
} murk_mixture;

void murk_mixture_destroy(murk_mixture *mixture); /* NULL is fine */

/* The scene's bands: lines, or n + 1 edges. */
typedef struct murk_preset_bands {
    int n;
    const double *line_nm; /* [n] */
    const double *edge_nm; /* [n + 1]; NULL: lines */
} murk_preset_bands;

typedef struct murk_preset_result {
    murk_spectrum extinction_per_m, albedo; /* albedo 1 where there is none */
    murk_mixture *mixture[MURK_BANDS_MAX];  /* bands past the last: NULL */
} murk_preset_result;

/* At a line the value there, between edges the mean over the band. Fails with
 * MURK_BAD_VALUE at `where`: a word that the preset does not know, or outside
 * of the preset's range; a band outside of its wavelengths. The mixtures are
 * the caller's: murk_preset_result_release(). */
murk_status murk_preset_evaluate(murk_preset_result *out,
                                 const murk_preset *preset,
                                 const murk_words *words,
                                 const murk_preset_bands *bands,
                                 const char *where, murk_error *err);
void murk_preset_result_release(murk_preset_result *result);

#endif
