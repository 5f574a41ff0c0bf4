/* Absorption and scattering of pure water and of its contents against
 * published tables, and the attenuation of daylight in Jerlov's water types.
 */
#include "library/library.h"

#include <math.h>
#include <string.h>

#include "cases/reference.h"
#include "daylight.h"
#include "preset/case_1.h"
#include "preset/water_contents.h"
#include "preset/water_pure.h"

#define SUN_DEG 30
#define TYPES   10
#define CELLS   7 /* of a type: 450 to 600 nm */

#define OCEANS      5
#define OCEAN_CELLS 11 /* of a type: 400 to 650 nm */

/* ---- water by itself ---- */

static void compare_water(murk_library *library, const char *what, double nm,
                          double reference, double value, double limit,
                          const char *source)
{
    char name[80];
    snprintf(name, sizeof name, "%s at %g nm", what, nm);
    if (!isnan(reference)) {
        murk_library_row(library, name, "1/m", reference, value, limit,
                         "half the last digit printed", source);
    }
}

static void water_itself(murk_library *library)
{
    murk_table *t = reference_read("pure_water.csv");
    murk_library_title(library, "Pure water and sea water",
                       "Absorption, and scattering at 20 degrees C, of "
                       "presets water/pure and water/sea.");
    for (size_t row = 0; row < t->rows; ++row) {
        const double nm = reference_number(t, row, "wavelength_nm");
        if (nm >= MURK_WATER_MIN_NM && nm <= MURK_WATER_MAX_NM) {
            compare_water(library, "absorption", nm,
                          reference_number(t, row, "absorption"),
                          murk_water_absorption(nm), 5e-6, "Pope & Fry 1997");
        }
        compare_water(library, "scattering, fresh", nm,
                      reference_number(t, row, "scattering_fresh"),
                      murk_water_scattering(nm, 20, 0), 5.01e-7,
                      "Zhang, Hu & He 2009");
        compare_water(library, "scattering, 35 psu", nm,
                      reference_number(t, row, "scattering_35_psu"),
                      murk_water_scattering(nm, 20, 35), 5.01e-7,
                      "Zhang, Hu & He 2009");
    }
    murk_table_destroy(t);
}

/* ---- Jerlov ---- */

typedef struct cells {
    const char *type;
    size_t n;
    int nm[OCEAN_CELLS];
    double per_m[OCEAN_CELLS];
} cells;

static cells cells_of(const murk_table *t, size_t first)
{
    cells out = {.type = reference_text(t, first, "type")};
    for (size_t row = first; row < t->rows && out.n < OCEAN_CELLS; ++row) {
        if (strcmp(reference_text(t, row, "type"), out.type) == 0) {
            out.nm[out.n] = (int)reference_number(t, row, "wavelength_nm");
            out.per_m[out.n++] = reference_number(t, row, "attenuation_per_m");
        }
    }
    return out;
}

/* How many of a type's cells are within a tenth. */
static int compare_type(murk_library *library, const cells *c)
{
    char water[64];
    murk_estimate murk[OCEAN_CELLS];
    int within = 0;
    snprintf(water, sizeof water, "preset: water/jerlov-%s", c->type);
    static const double share[2] = {.1, .01};
    daylight_attenuation(murk, water, SUN_DEG, share, c->n, c->nm, c->per_m,
                         library->is_nightly ? 50000 : 8000, 1);
    for (size_t i = 0; i < c->n; ++i) {
        char name[80];
        snprintf(name, sizeof name,
                 "type %s at %d nm (error %.1f %%, off %+.1f"
                 " %%)",
                 c->type, c->nm[i],
                 100 * murk[i].standard_error / murk[i].value,
                 100 * (murk[i].value / c->per_m[i] - 1));
        murk_library_row(library, name, "1/m", c->per_m[i], murk[i].value,
                         .2 * c->per_m[i], "20 %, required",
                         "Jerlov 1976, table XXVII");
        within += fabs(murk[i].value / c->per_m[i] - 1) <= .1;
    }
    return within;
}

static void jerlov(murk_library *library)
{
    murk_table *t = reference_read("jerlov.csv");
    const size_t step = library->is_nightly ? 1 : 4;
    int asked = 0, within = 0;
    murk_library_title(
        library, "Jerlov's water types",
        "Attenuation of downward irradiance between the depths of 10 % and 1 "
        "% of the light, the sun at 30 degrees from the zenith above a level "
        "surface of index 1.34; presets water/jerlov-*, lit by murk.");
    for (size_t type = 0; type < TYPES && type * CELLS < t->rows;
         type += step) {
        const cells c = cells_of(t, type * CELLS);
        within += compare_type(library, &c);
        asked += (int)c.n;
    }
    murk_library_row(library, "cells within 10 %", "of all", 1,
                     (double)within / asked, .1, "90 % of them, required",
                     "Jerlov 1976, table XXVII");
    murk_table_destroy(t);
}

/* ---- open ocean ---- */

static void case_1(murk_library *library)
{
    /* The quick form takes every fifth concentration only. */
    static const double chlorophyll[] = {.03, .1, .3, 1, 3, 10};
    static const int nm[] = {412, 443, 490, 555};
    static const double share[2] = {1, .1};
    enum { LINES = sizeof nm / sizeof *nm };
    const size_t step = library->is_nightly ? 1 : 5;
    murk_library_title(
        library, "Open ocean by chlorophyll",
        "Attenuation of downward irradiance from just below the surface to the "
        "depth of 10 % of the light, the sun at 30 degrees from the zenith "
        "above a level surface of index 1.34; preset water/case-1, lit by "
        "murk. The preset derives its absorption from the same law, so these "
        "rows show that its inversion and the tracing agree with the law, and "
        "are no independent check of the law: the two tables that "
        "follow are.");
    for (size_t i = 0; i < sizeof chlorophyll / sizeof *chlorophyll;
         i += step) {
        double observed[LINES];
        char water[100];
        murk_estimate k[LINES];
        /* The attenuation that the law gives in each band. */
        for (int b = 0; b < LINES; ++b) {
            observed[b] = murk_case_1_kd(nm[b], chlorophyll[i]);
        }
        /* Trace the preset at this concentration. */
        snprintf(water, sizeof water,
                 "preset: water/case-1, chlorophyll_mg_per_m3: %g",
                 chlorophyll[i]);
        daylight_attenuation(k, water, SUN_DEG, share, LINES, nm, observed,
                             library->is_nightly ? 50000 : 8000, 1);
        /* One row for each band. */
        for (int b = 0; b < LINES; ++b) {
            char name[100];
            snprintf(name, sizeof name,
                     "%g mg/m3 at %d nm (error %.1f %%, off %+.1f %%)",
                     chlorophyll[i], nm[b],
                     100 * k[b].standard_error / k[b].value,
                     100 * (k[b].value / observed[b] - 1));
            murk_library_row(library, name, "1/m", observed[b], k[b].value,
                             .1 * observed[b], "10 %, required",
                             nm[b] == 490 ? "Morel et al. 2007"
                                          : "Morel & Maritorena 2001 (second "
                                            "hand)");
        }
    }
}

/* ---- open ocean, by other authors ---- */

/* Where a type's chlorophyll is told by: the least attenuation of most. */
#define CLASSIFIED_BY_NM 475

/* The most that was seen, not what is required: it holds the model there. */
#define ELSEWHERE_OFF .4

/* The chlorophyll at which the preset's own law has that attenuation. */
static double chlorophyll_of(double kd_per_m)
{
    double low = 1e-4, high = 100;
    for (int i = 0; i < 60; ++i) {
        const double middle = sqrt(low * high);
        *(murk_case_1_kd(CLASSIFIED_BY_NM, middle) < kd_per_m ? &low : &high) =
            middle;
    }
    return sqrt(low * high);
}

static void compare_ocean(murk_library *library, const cells *c)
{
    /* Derive the chlorophyll from the attenuation at one wavelength. */
    char water[100];
    murk_estimate k[OCEAN_CELLS];
    double chlorophyll = NAN;
    for (size_t i = 0; i < c->n; ++i) {
        if (c->nm[i] == CLASSIFIED_BY_NM) {
            chlorophyll = chlorophyll_of(c->per_m[i]);
        }
    }
    /* Trace the preset with this chlorophyll at all wavelengths of the
     * table. */
    snprintf(water, sizeof water,
             "preset: water/case-1, chlorophyll_mg_per_m3: %.4g", chlorophyll);
    static const double share[2] = {1, .1};
    daylight_attenuation(k, water, SUN_DEG, share, c->n, c->nm, c->per_m,
                         library->is_nightly ? 50000 : 8000, 1);
    /* Compare all other wavelengths: at the one that gave the chlorophyll,
     * a comparison would prove nothing. */
    for (size_t i = 0; i < c->n; ++i) {
        char name[100];
        snprintf(name, sizeof name,
                 "type %s (%.2g mg/m3) at %d nm (error %.1f %%, off %+.1f %%)",
                 c->type, chlorophyll, c->nm[i],
                 100 * k[i].standard_error / k[i].value,
                 100 * (k[i].value / c->per_m[i] - 1));
        if (c->nm[i] != CLASSIFIED_BY_NM) {
            murk_library_row(library, name, "1/m", c->per_m[i], k[i].value,
                             ELSEWHERE_OFF * c->per_m[i], "40 %, as seen",
                             "Austin & Petzold 1986 (second hand)");
        }
    }
}

static void oceans(murk_library *library)
{
    murk_table *t = reference_read("austin_petzold.csv");
    const size_t step = library->is_nightly ? 1 : OCEANS;
    murk_library_title(
        library, "Open ocean by other observers",
        "Attenuation as above, of preset water/case-1 with the chlorophyll at "
        "which its own law has the attenuation of a type at 475 nm: so all "
        "else of the spectrum is by other observers, and most of it lies "
        "between or beyond the wavelengths of that law.");
    for (size_t type = 0; type * OCEAN_CELLS < t->rows; type += step) {
        const cells c = cells_of(t, type * OCEAN_CELLS);
        compare_ocean(library, &c);
    }
    murk_table_destroy(t);
}

/* Prieur & Sathyendranath, Limnol. Oceanogr. 26 (1981) 671,
 * doi:10.4319/lo.1981.26.4.0671, from measured absorption, as Morel, Prog.
 * Oceanogr. 26 (1991) 263, doi:10.1016/0079-6611(91)90004-6, writes it: (water
 * + .06 C^.65) (1 + .2) at 440 nm. Here without the water's own. */
static double prieurs(double chlorophyll)
{
    return 1.2 * .06 * pow(chlorophyll, .65) + .2 * murk_water_absorption(440);
}

/* Particles on filters, and dissolved matter by Morel & Gentili, Remote Sens.
 * Environ. 113 (2009) 998, doi:10.1016/j.rse.2009.01.008: .0524 C^.63 at 412
 * nm, .018 per nm. */
static double bricauds(double chlorophyll)
{
    return murk_chlorophyll_absorption(440, chlorophyll) +
           murk_cdom_absorption(
               440, .0524 * exp(.018 * (412 - 440)) * pow(chlorophyll, .63),
               .018);
}

static void ocean_absorption(murk_library *library)
{
    /* The laws of other authors. */
    static const double chlorophyll[] = {.03, .1, .3, 1, 3, 10};
    static const struct {
        double (*absorption)(double chlorophyll);
        const char *source;
    } other[] = {{prieurs, "Prieur & Sathyendranath 1981, after Morel 1991"},
                 {bricauds,
                  "Bricaud et al. 1998 with Morel & Gentili 2009 (second "
                  "hand)"}};
    murk_library_title(
        library, "Absorption of the open ocean",
        "Particles and dissolved matter together at 440 nm, of preset "
        "water/case-1, beside laws by other observations: of irradiance in "
        "1981; of particles on filters, with dissolved matter derived from the "
        "colour of the sea. At one chlorophyll, waters differ by a factor of "
        "two.");
    /* Compare the absorption by the preset with each law at each
     * concentration. */
    for (size_t i = 0; i < sizeof chlorophyll / sizeof *chlorophyll; ++i) {
        const double murk = murk_case_1_absorption(440, chlorophyll[i]);
        for (size_t k = 0; k < sizeof other / sizeof *other; ++k) {
            const double want = other[k].absorption(chlorophyll[i]);
            char name[80];
            snprintf(name, sizeof name, "%g mg/m3 (off %+.0f %%)",
                     chlorophyll[i], 100 * (murk / want - 1));
            murk_library_row(library, name, "1/m", want, murk,
                             ELSEWHERE_OFF * want, "40 %, as seen",
                             other[k].source);
        }
    }
}

void murk_library_water(murk_library *library)
{
    water_itself(library);
    jerlov(library);
    case_1(library);
    oceans(library);
    ocean_absorption(library);
}
