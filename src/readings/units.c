/* The table of units of readings, and conversions from the quantity of the
 * model to each unit. */
#include "readings/units.h"

#include "base/words.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Visibility is defined by a contrast of 2 % (Koschmieder: ln 50 = 3.912),
 * meteorological optical range by 5 % (ln 20 = 2.996). */
#define VISIBILITY    3.912
#define OPTICAL_RANGE 2.996
/* 10 / ln 10: -10 log10 T = DECIBEL * -ln T */
#define DECIBEL (10 / 2.302585092994046)

/* Transmittance is limited to this range, and no measured value lies beyond it.
 * The inverse of T_MIN, which the slope contains, is representable. T_MAX is
 * the largest number below 1, at which the visibility would be infinite. */
#define T_MIN 1e-300
#define T_MAX (1 - 0x1p-53)
/* Visibilities are those of an extinction of at least this, the mean along 1 m
 * at T_MAX. */
#define EXTINCTION_MIN 0x1p-53

/* Sets of kinds. */
#define BIT      MURK_READING_KIND_BIT
#define COVERAGE BIT(MURK_READ_COVERAGE)
#define LIGHT    (BIT(MURK_READ_FLUENCE) | BIT(MURK_READ_IRRADIANCE))
#define BEAM     BIT(MURK_READ_TRANSMITTANCE)
#define POINT    BIT(MURK_READ_EXTINCTION)

/* Ranges of values, as min, max and text: any number; percents of what is
 * transmitted or obscured from 0 to 100, wider by 50 on both sides, because
 * noise may carry readings there; lengths above 0. */
#define ANY             -INFINITY, INFINITY, ""
#define PERCENT_PER_M   -50, 150, "0..100, and noise up to half beyond"
#define POSITIVE_LENGTH 0, INFINITY, "more than 0 m"

typedef struct unit_row {
    const char *name;
    unsigned kinds;
    double min, max; /* outside of this range, a reading must be of another
                      * unit; min = 0 is outside, too */
    const char *range;
    const char *law;
} unit_row;

const char *const murk_reading_kinds[MURK_READING_KINDS] = {
    [MURK_READ_COVERAGE] = "coverage",
    [MURK_READ_FLUENCE] = "fluence",
    [MURK_READ_IRRADIANCE] = "irradiance",
    [MURK_READ_TRANSMITTANCE] = "transmittance",
    [MURK_READ_EXTINCTION] = "extinction"};

static const unit_row UNITS[MURK_READING_UNITS] = {
    [MURK_UNIT_FRACTION] = {"fraction", COVERAGE | BEAM, -.5, 1.5,
                            "0..1, and noise up to half beyond", NULL},
    [MURK_UNIT_PERCENT] = {"percent", COVERAGE | BEAM | LIGHT, ANY, NULL},
    [MURK_UNIT_W_PER_M2] = {"W/m2", LIGHT, ANY, NULL},
    [MURK_UNIT_LUX] = {"lux", LIGHT, ANY, NULL},
    [MURK_UNIT_PHOTONS] = {"1/s/m2", LIGHT, ANY, NULL},
    [MURK_UNIT_PAR] = {"umol/s/m2", LIGHT, ANY, NULL},
    [MURK_UNIT_RELATIVE] = {"relative", LIGHT, ANY, NULL},
    [MURK_UNIT_TRANSMISSION_PERCENT_PER_M] = {"transmission_percent_per_m",
                                              BEAM | POINT, PERCENT_PER_M,
                                              "100 T^(1/L)"},
    [MURK_UNIT_OBSCURATION_PERCENT_PER_M] = {"obscuration_percent_per_m",
                                             BEAM | POINT, PERCENT_PER_M,
                                             "100 (1 - T^(1/L))"},
    [MURK_UNIT_OBSCURATION_PERCENT] = {"obscuration_percent", BEAM,
                                       PERCENT_PER_M, "100 (1 - T)"},
    [MURK_UNIT_OPTICAL_DEPTH] = {"optical_depth", BEAM, ANY, "-ln(T)"},
    [MURK_UNIT_DB_PER_KM] = {"db_per_km", BEAM | POINT, ANY,
                             "-10 log10(T) / L, L in km"},
    [MURK_UNIT_EXTINCTION_PER_M] = {"extinction_per_m", BEAM | POINT, ANY,
                                    "-ln(T) / L"},
    [MURK_UNIT_VISIBILITY_M] = {"visibility_m", BEAM | POINT, POSITIVE_LENGTH,
                                "3.912 L / -ln(T)"},
    [MURK_UNIT_MOR_M] = {"mor_m", BEAM | POINT, POSITIVE_LENGTH,
                         "2.996 L / -ln(T)"},
};

/* Other spellings. */
static const struct {
    const char *name;
    murk_reading_unit unit;
} ALSO[] = {
    {"1", MURK_UNIT_FRACTION},
    {"%", MURK_UNIT_PERCENT},
    {"w_per_m2", MURK_UNIT_W_PER_M2},
    {"lx", MURK_UNIT_LUX},
    {"photons_per_s_m2", MURK_UNIT_PHOTONS},
    {"par_umol_per_s_m2", MURK_UNIT_PAR},
    {"umol/m2/s", MURK_UNIT_PAR},
    {"umol_per_s_m2", MURK_UNIT_PAR},
    {"umol_per_m2_s", MURK_UNIT_PAR},
    {"par", MURK_UNIT_PAR},
    {"photons", MURK_UNIT_PHOTONS},
    {"photons_per_m2_s", MURK_UNIT_PHOTONS},
    {"dB/km", MURK_UNIT_DB_PER_KM},
    {"1/m", MURK_UNIT_EXTINCTION_PER_M},
    {"per_m", MURK_UNIT_EXTINCTION_PER_M},
};

static const char *const AMBIGUOUS[] = {"percent_per_m", "%/m", "pct_per_m",
                                        "percent/m"};

const char *murk_reading_unit_name(murk_reading_unit unit)
{
    return UNITS[unit].name;
}

const char *murk_reading_unit_law(murk_reading_unit unit)
{
    return UNITS[unit].law;
}

bool murk_reading_unit_needs_gain(murk_reading_unit unit,
                                  murk_reading_kind kind)
{
    return (BIT(kind) & LIGHT) &&
           (unit == MURK_UNIT_PERCENT || unit == MURK_UNIT_RELATIVE);
}

/* Lists the units of a kind, for a message. */
static void list_of(char *out, size_t size, murk_reading_kind kind)
{
    size_t used = 0;
    out[0] = '\0';
    for (int i = 0; i < MURK_READING_UNITS; ++i) {
        if ((UNITS[i].kinds & BIT(kind)) && used + 40 < size) {
            used += (size_t)snprintf(out + used, size - used, "%s%s",
                                     used ? ", " : "", UNITS[i].name);
        }
    }
}

/* Fails because a word is not a unit of the kind; the message has a suggestion,
 * or all units of the kind. */
static murk_status wrong_unit(const char *word, murk_reading_kind kind,
                              const char *where, murk_error *err)
{
    const char *names[MURK_READING_UNITS];
    char shown[48], all[400];
    for (int i = 0; i < MURK_READING_UNITS; ++i) {
        names[i] = UNITS[i].kinds & BIT(kind) ? UNITS[i].name : NULL;
    }
    murk_words_show(shown, sizeof shown, word);
    const char *meant = murk_words_meant(word, names, MURK_READING_UNITS);
    if (meant) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "%s is no unit, did you mean %s?", shown, meant);
    }
    list_of(all, sizeof all, kind);
    return murk_fail(err, MURK_BAD_VALUE, where, "%s, must be one of %s",
                     shown[0] ? shown : "nothing", all);
}

static int unit_of(const char *word)
{
    for (int i = 0; i < MURK_READING_UNITS; ++i) {
        if (strcmp(UNITS[i].name, word) == 0) {
            return i;
        }
    }
    for (size_t i = 0; i < sizeof ALSO / sizeof *ALSO; ++i) {
        if (strcmp(ALSO[i].name, word) == 0) {
            return (int)ALSO[i].unit;
        }
    }
    return -1;
}

murk_status murk_reading_unit_find(murk_reading_unit *out, const char *word,
                                   murk_reading_kind kind, const char *where,
                                   murk_error *err)
{
    /* Words that could mean two units. */
    for (size_t i = 0; i < sizeof AMBIGUOUS / sizeof *AMBIGUOUS; ++i) {
        if (strcmp(word, AMBIGUOUS[i]) == 0) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "%s is ambiguous, must be "
                             "transmission_percent_per_m (100 is clear) or "
                             "obscuration_percent_per_m (0 is clear)",
                             word);
        }
    }
    /* Find the unit; it must be one of the kind. */
    const int usual = kind == MURK_READ_EXTINCTION ? MURK_UNIT_EXTINCTION_PER_M
                                                   : MURK_UNIT_FRACTION;
    const int unit =
        word[0] == '\0' && !(BIT(kind) & LIGHT) ? usual : unit_of(word);
    if (unit < 0) {
        return wrong_unit(word, kind, where, err);
    }
    if (!(UNITS[unit].kinds & BIT(kind))) {
        char all[400];
        list_of(all, sizeof all, kind);
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "%s is no unit of such a reading, must be one of %s",
                         UNITS[unit].name, all);
    }
    *out = (murk_reading_unit)unit;
    return MURK_OK;
}

murk_status murk_reading_unit_check(murk_reading_unit unit, double value,
                                    const char *where, murk_error *err)
{
    const unit_row *u = &UNITS[unit];
    const bool is_above = u->min != 0 || value > 0;
    return is_above && value >= u->min && value <= u->max
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, where,
                           "%.9g as a %s, must be %s", value, u->name,
                           u->range);
}

/* A unit with a law, as a function of the extinction; the optical depth is that
 * of 1 m. *slope: the derivative with respect to the extinction. */
static double by_extinction(murk_reading_unit unit, double per_m, double *slope)
{
    switch (unit) {
    case MURK_UNIT_TRANSMISSION_PERCENT_PER_M:
    case MURK_UNIT_OBSCURATION_PERCENT_PER_M: {
        const double transmitted = 100 * exp(-per_m);
        const bool is_transmission =
            unit == MURK_UNIT_TRANSMISSION_PERCENT_PER_M;
        *slope = is_transmission ? -transmitted : transmitted;
        return is_transmission ? transmitted : 100 - transmitted;
    }
    case MURK_UNIT_DB_PER_KM:
        *slope = 1000 * DECIBEL;
        return 1000 * DECIBEL * per_m;
    case MURK_UNIT_VISIBILITY_M:
        *slope = -VISIBILITY / (per_m * per_m);
        return VISIBILITY / per_m;
    case MURK_UNIT_MOR_M:
        *slope = -OPTICAL_RANGE / (per_m * per_m);
        return OPTICAL_RANGE / per_m;
    default:
        *slope = 1;
        return per_m;
    }
}

double murk_reading_in_unit(murk_reading_unit unit, double model,
                            double length_m, double *slope)
{
    /* Units without a law. */
    if (unit == MURK_UNIT_PERCENT) {
        *slope = 100;
        return 100 * model;
    }
    if (!UNITS[unit].law) {
        *slope = 1;
        return model;
    }
    if (unit == MURK_UNIT_OBSCURATION_PERCENT) {
        *slope = -100;
        return 100 - 100 * model;
    }
    /* The optical depth, and units derived from the mean extinction along the
     * segment. */
    const double t = model < T_MIN ? T_MIN : model > T_MAX ? T_MAX : model;
    const double length = unit == MURK_UNIT_OPTICAL_DEPTH ? 1 : length_m;
    const double value = by_extinction(unit, -log(t) / length, slope);
    *slope *= -1 / (t * length);
    return value;
}

double murk_reading_of_extinction(murk_reading_unit unit, double per_m)
{
    const bool is_length =
        unit == MURK_UNIT_VISIBILITY_M || unit == MURK_UNIT_MOR_M;
    double unused;
    return by_extinction(unit, is_length ? fmax(per_m, EXTINCTION_MIN) : per_m,
                         &unused);
}

murk_quantity murk_reading_quantity(murk_reading_unit unit)
{
    return unit == MURK_UNIT_LUX       ? MURK_PHOTOMETRIC
           : unit == MURK_UNIT_PHOTONS ? MURK_PHOTONS
           : unit == MURK_UNIT_PAR     ? MURK_PAR
                                       : MURK_RADIOMETRIC;
}

murk_spectrum murk_reading_per_watt(murk_reading_unit unit,
                                    const murk_scene_desc *scene)
{
    murk_spectrum out = murk_spectrum_flat(1, scene->bands);
    const murk_quantity quantity = murk_reading_quantity(unit);
    for (int b = 0; b < scene->bands; ++b) {
        out.band[b] =
            scene->has_edges
                ? murk_quantity_per_watt(quantity, scene->band_edge_nm[b],
                                         scene->band_edge_nm[b + 1])
                : murk_quantity_per_watt(quantity, scene->band_nm[b],
                                         scene->band_nm[b]);
    }
    return out;
}
