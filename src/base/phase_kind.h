/* The kinds of phase functions in scenes and presets, and how many numbers
 * describe each.
 *
 * All of src uses this one list: the scene and the presets read the numbers,
 * and src/medium evaluates the function (medium/phase.c, one row for each
 * kind). The ranges that scenes and presets accept are in scene/keys_rows.h;
 * src/medium checks the numbers that it accepts, too. */
#ifndef MURK_BASE_PHASE_KIND_H
#define MURK_BASE_PHASE_KIND_H

/* X(enumerator, name in scenes, presets and results, count of numbers). The
 * numbers are: of HG (Henyey-Greenstein) the mean cosine g, 0 being isotropic;
 * of TWO_HG g1, g2 and the weight of g1; of FOURNIER_FORAND n and mu. RAYLEIGH
 * and TABLE, which is a tabulated density by angle, have no such numbers. */
#define MURK_PHASE_KINDS(X)                  \
    X(HG, "hg", 1)                           \
    X(RAYLEIGH, "rayleigh", 0)               \
    X(TWO_HG, "two_hg", 3)                   \
    X(FOURNIER_FORAND, "fournier_forand", 2) \
    X(TABLE, "table", 0)

#define MURK_PHASE_NUMBERS_MAX 3 /* of two_hg */

#define MURK_PHASE_ENUMERATOR(id, name, numbers) MURK_PHASE_##id,
typedef enum murk_phase_kind {
    MURK_PHASE_KINDS(MURK_PHASE_ENUMERATOR)
} murk_phase_kind;
#undef MURK_PHASE_ENUMERATOR

typedef struct murk_phase_kind_row {
    const char *name; /* NULL ends the table */
    int numbers;      /* count of numbers that describe such a function */
} murk_phase_kind_row;

/* Indexed by murk_phase_kind. */
extern const murk_phase_kind_row murk_phase_kinds[];

#endif
