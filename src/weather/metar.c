/* Reads METAR reports: station and time, then groups in the order wind,
 * visibility, runway visual range, weather, clouds, temperatures, pressure;
 * then remarks. Groups are recognised by their form. */
#include "weather/groups.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define MILE_M   1609.344 /* statute mile, exactly */
#define HOUR_MIN 60       /* minutes of an hour */
#define INCH_MM  25.4     /* exactly */
#define INHG_HPA 33.86389 /* conventional inch of mercury, at 0 degrees C */

typedef struct metar {
    murk_groups groups;
    murk_observation *out;
    bool has_visibility, has_cover, has_rain_class;
    int stated; /* groups of the observation that were read */
} metar;

/* ---- visibility ---- */

static void set_visibility(metar *m, double visibility_m,
                           murk_visibility_limit limit)
{
    m->out->visibility_m = visibility_m;
    m->out->visibility_limit = limit;
    m->has_visibility = true;
}

/* Reads a number of statute miles without its unit: 10, 1/4, 1 1/4 (the whole
 * miles from the group before). */
static bool read_miles(const char *text, double whole, double *out)
{
    static const char digits[] = "0123456789";
    const size_t up = strspn(text, digits);
    const char *under = text[up] == '/' ? text + up + 1 : "1";
    const size_t down = strspn(under, digits);
    if (up < 1 || up > 3 || down < 1 || down > 2 || under[down] != '\0' ||
        (text[up] != '/' && text[up] != '\0') ||
        (text[up] == '/' &&
         murk_group_number(under, down) <= murk_group_number(text, up))) {
        return false; /* also 11/2, which lacks a blank */
    }
    *out = whole +
           (double)murk_group_number(text, up) / murk_group_number(under, down);
    return true;
}

/* Groups such as 10SM, P6SM, M1/4SM; `whole` is 1 of "1 1/4SM". */
static bool take_miles(metar *m, const char *group, double whole)
{
    const size_t length = strlen(group);
    const bool is_more = group[0] == 'P', is_less = group[0] == 'M';
    char number[16];
    double miles;
    if (length < 3 || length > sizeof number ||
        strcmp(group + length - 2, "SM") != 0) {
        return false;
    }
    snprintf(number, sizeof number, "%.*s",
             (int)(length - 2 - (is_more || is_less)),
             group + (is_more || is_less));
    if (strspn(number, "/") == strlen(number)) {
        m->has_visibility = true; /* missing */
        return true;
    }
    const double farthest = 100; /* no station sees farther */
    if (!read_miles(number, whole, &miles) || miles > farthest) {
        return false;
    }
    /* 10 miles are the farthest that stations of the United States report, a
     * sixteenth the nearest. */
    set_visibility(m, miles > 0 ? miles * MILE_M : MILE_M / 16,
                   is_less || miles == 0    ? MURK_VISIBILITY_LESS_THAN
                   : is_more || miles >= 10 ? MURK_VISIBILITY_AT_LEAST
                                            : MURK_VISIBILITY_EXACT);
    return true;
}

/* Visibility in metres, such as 0500, 9999 or 4000NDV, or CAVOK. A second one
 * with a direction (4500NW) is that of one direction alone and passed over. */
static bool take_metres(metar *m, const char *group)
{
    static const char *const behind[] = {"",   "NDV", "N",  "NE", "E",
                                         "SE", "S",   "SW", "W",  "NW"};
    const double cavok_m = 10000, farthest = 9999, nearest_m = 50;
    bool is_known = false;
    if (strcmp(group, "CAVOK") == 0) {
        set_visibility(m, cavok_m, MURK_VISIBILITY_AT_LEAST);
        m->out->sky_cover = 0;
        m->has_cover = true;
        return true;
    }
    if (strcmp(group, "////") == 0) {
        m->has_visibility = true;
        return true;
    }
    if (strlen(group) < 4 || strspn(group, "0123456789") != 4) {
        return false;
    }
    for (size_t i = 0; i < sizeof behind / sizeof *behind; ++i) {
        is_known = is_known || strcmp(group + 4, behind[i]) == 0;
    }
    /* The first counts, which is the prevailing one. */
    if (is_known && !m->has_visibility) {
        const int metres = murk_group_number(group, 4);
        set_visibility(m,
                       metres == farthest ? cavok_m
                       : metres == 0      ? nearest_m
                                          : metres,
                       metres == farthest ? MURK_VISIBILITY_AT_LEAST
                       : metres == 0      ? MURK_VISIBILITY_LESS_THAN
                                          : MURK_VISIBILITY_EXACT);
    }
    return is_known;
}

/* Kilometres, as some stations report: 20KM. */
static bool take_kilometres(metar *m, const char *group)
{
    if (!murk_group_is(group, "0KM") && !murk_group_is(group, "00KM")) {
        return false;
    }
    const int km = murk_group_number(group, strlen(group) - 2);
    set_visibility(m, km > 0 ? 1000.0 * km : 1000,
                   km > 0 ? MURK_VISIBILITY_EXACT : MURK_VISIBILITY_LESS_THAN);
    return true;
}

/* ---- weather ---- */

/* Reads a weather group: intensity or VC, descriptor, phenomena of two letters
 * each. */
static bool take_weather(metar *m, const char *group)
{
    static const char descriptors[] = "MI PR BC DR BL SH TS FZ";
    static const char phenomena[] = "DZ RA SN SG IC PL GR GS UP BR FG FU VA DU "
                                    "SA HZ PY PO SQ FC SS DS";
    const int intensity = group[0] == '-' ? 0 : group[0] == '+' ? 2 : 1;
    const bool is_near = strncmp(group, "VC", 2) == 0;
    const char *const form = group + (is_near ? 2 : intensity != 1), *at = form;
    bool is_rain = false, is_drizzle = false, is_snow = false, is_fog = false,
         is_haze = false;
    if (strcmp(group, "//") == 0) {
        murk_group_append(m->out->weather, group);
        return true;
    }
    if (*at == '\0' || strlen(at) % 2 != 0 || strlen(at) > 8) {
        return false;
    }
    /* Each pair of letters is a descriptor or a phenomenon. */
    for (; *at; at += 2) {
        const char two[3] = {at[0], at[1], '\0'};
        if (!strstr(descriptors, two) && !strstr(phenomena, two)) {
            return false;
        }
        is_rain = is_rain || strcmp(two, "RA") == 0 || strcmp(two, "UP") == 0;
        is_drizzle = is_drizzle || strcmp(two, "DZ") == 0;
        is_snow = is_snow || strstr("SN SG IC PL GS", two);
        is_fog = is_fog || strcmp(two, "FG") == 0;
        is_haze = is_haze || strstr("BR FU VA DU SA HZ SS DS PO", two);
    }
    murk_group_append(m->out->weather, group);
    /* Weather in the vicinity is not at the station, and shallow fog and low
     * drifting snow lie below the eyes of the observer. */
    if (is_near || strncmp(form, "MIFG", 4) == 0 ||
        strncmp(form, "DR", 2) == 0) {
        return true;
    }
    const murk_weather_kind kind = is_snow   ? MURK_WEATHER_SNOW
                                   : is_fog  ? MURK_WEATHER_FOG
                                   : is_haze ? MURK_WEATHER_HAZE
                                             : MURK_WEATHER_NONE;
    m->out->kind = kind > m->out->kind ? kind : m->out->kind;
    if ((is_rain || is_drizzle) && !m->has_rain_class) {
        m->out->rain_mm_per_h =
            murk_rain_of_class(is_drizzle && !is_rain, intensity);
        m->out->rain_is_by_word = m->has_rain_class = true;
    }
    return true;
}

/* ---- clouds, temperatures, pressure ---- */

static bool take_clouds(metar *m, const char *group)
{
    static const struct {
        const char *word;
        double cover; /* middle of the class in eighths; NAN: not seen */
    } clouds[] = {{"SKC", 0},       {"CLR", 0},         {"NSC", 0},
                  {"NCD", 0},       {"FEW", 1.5 / 8},   {"SCT", 3.5 / 8},
                  {"BKN", 6.0 / 8}, {"OVC", 1},         {"VV", 1},
                  {"//////", NAN},  {"/////////", NAN}, {"///", NAN}};
    for (size_t i = 0; i < sizeof clouds / sizeof *clouds; ++i) {
        const char *word = clouds[i].word;
        const size_t length = strlen(word);
        const char *behind = group + length;
        /* Behind the word: three digits or slashes, then a kind of cloud. */
        if (strncmp(group, word, length) == 0 &&
            (*behind == '\0' ||
             (i > 3 && strspn(behind, "0123456789/") >= 3 &&
              strspn(behind + 3, "ABCDEFGHIJKLMNOPQRSTUVWXYZ/") ==
                  strlen(behind + 3)))) {
            if (!(clouds[i].cover <= m->out->sky_cover)) {
                m->out->sky_cover = isnan(clouds[i].cover) ? m->out->sky_cover
                                                           : clouds[i].cover;
            }
            return true;
        }
    }
    return false;
}

/* Reads a temperature such as 08 or M05; *n characters. Slashes are a missing
 * one. */
static bool read_temperature(const char *text, double *out, size_t *n)
{
    const bool is_below = text[0] == 'M';
    const char *digits = text + is_below;
    *n = 2 + is_below;
    if (strncmp(text, "//", 2) == 0) {
        *out = NAN;
        *n = 2;
        return true;
    }
    if (strspn(digits, "0123456789") < 2) {
        return false;
    }
    const int degrees = murk_group_number(digits, 2);
    *out = is_below ? -degrees : degrees;
    return murk_is_of_air(*out);
}

static bool take_temperatures(metar *m, const char *group)
{
    double temperature_c, dew_point_c = NAN;
    size_t n, end = 0;
    if (!read_temperature(group, &temperature_c, &n) || group[n] != '/') {
        return false;
    }
    const char *dew = group + n + 1;
    if (*dew != '\0' &&
        (!read_temperature(dew, &dew_point_c, &end) || dew[end] != '\0')) {
        return false;
    }
    m->out->temperature_c = temperature_c;
    m->out->dew_point_c = dew_point_c;
    return true;
}

static bool take_pressure(metar *m, const char *group)
{
    if (murk_group_is(group, "Q0000")) {
        m->out->pressure_hpa = murk_group_number(group + 1, 4);
    } else if (murk_group_is(group, "A0000")) {
        m->out->pressure_hpa =
            murk_group_number(group + 1, 4) / 100.0 * INHG_HPA;
    } else {
        return strcmp(group, "Q////") == 0 || strcmp(group, "A////") == 0;
    }
    return true;
}

/* ---- groups that photons do not depend on ---- */

static bool is_wind(const char *group)
{
    static const char *const units[] = {"KT", "MPS", "KMH", "KTS"};
    const size_t length = strlen(group);
    if (murk_group_is(group, "???V???")) {
        return true;
    }
    for (size_t i = 0; i < sizeof units / sizeof *units; ++i) {
        const size_t n = strlen(units[i]);
        if (length > n + 3 && strcmp(group + length - n, units[i]) == 0) {
            return strspn(group, "0123456789/VRBGP") >= length - n;
        }
    }
    return false;
}

/* Runway visual range and state of runways, sea state and wind shear, colour
 * codes, recent weather, and words that say how the report was made. */
static bool is_passed_over(const char *group)
{
    static const char *const words[] = {"AUTO", "COR", "CCA", "CCB", "NSW",
                                        "WS",   "ALL", "RWY", "$",   "BLU",
                                        "WHT",  "GRN", "YLO", "AMB", "RED",
                                        "BLU+", "RTD", "AMD", "CCC", "SNOCLO"};
    for (size_t i = 0; i < sizeof words / sizeof *words; ++i) {
        if (strcmp(group, words[i]) == 0) {
            return true;
        }
    }
    const bool is_runway = group[0] == 'R' && group[1] >= '0' &&
                           group[1] <= '9' && strchr(group, '/');
    const bool is_recent = strncmp(group, "RE", 2) == 0 &&
                           strlen(group) % 2 == 0 && strlen(group) <= 10;
    const bool is_sea = group[0] == 'W' && strchr(group, '/');
    return is_runway || is_recent || is_sea || murk_group_is(group, "????????");
}

static void take_tenths(double *out, double temperature_c)
{
    *out = murk_is_of_air(temperature_c) ? temperature_c : *out;
}

/* Remarks of the United States: the rain of the hour in hundredths of an inch
 * (P0013), and temperatures in tenths of a degree (T01780167). */
static void take_remark(metar *m, const char *group)
{
    if (murk_group_is(group, "P0000") && m->out->rain_mm_per_h > 0) {
        const double mm = murk_group_number(group + 1, 4) / 100.0 * INCH_MM;
        /* P0000 is less than a hundredth. */
        if (mm > 0 && mm <= MURK_RAIN_MM_PER_H_MAX) {
            m->out->rain_mm_per_h = mm;
            m->out->rain_is_by_word = false;
        }
    } else if (murk_group_is(group, "T00000000") && group[1] < '2' &&
               group[5] < '2') {
        const double t = murk_group_number(group + 2, 3) / 10.0,
                     dew = murk_group_number(group + 6, 3) / 10.0;
        take_tenths(&m->out->temperature_c, group[1] == '1' ? -t : t);
        take_tenths(&m->out->dew_point_c, group[5] == '1' ? -dew : dew);
    }
}

static bool is_trend(const char *group)
{
    return strcmp(group, "NOSIG") == 0 || strcmp(group, "TEMPO") == 0 ||
           strcmp(group, "BECMG") == 0 || strcmp(group, "INTER") == 0 ||
           strncmp(group, "PROB", 4) == 0;
}

/* ---- the report ---- */

/* Reads the group k of the body. */
static void take_group(metar *m, size_t k)
{
    const char *group = m->groups.group[k], *before = m->groups.group[k - 1];
    const bool has_whole =
        murk_group_is(before, "0") && strchr(group, '/') != NULL;
    /* "1" of "1 1/4SM" is read with the group behind it. */
    if (murk_group_is(group, "0") &&
        strstr(m->groups.group[k + 1], "SM") != NULL) {
        return;
    }
    if (take_miles(m, group, has_whole ? before[0] - '0' : 0) ||
        take_metres(m, group) || take_kilometres(m, group) ||
        take_weather(m, group) || take_clouds(m, group) ||
        take_temperatures(m, group) || take_pressure(m, group) ||
        is_wind(group)) {
        ++m->stated;
    } else if (!is_passed_over(group)) {
        murk_group_append(m->out->unknown, group);
    }
}

static murk_status fail_form(const murk_groups *groups, size_t k,
                             const char *must, const char *where,
                             murk_error *err)
{
    return murk_group_fail(groups, k, "METAR", must, where, err);
}

murk_status murk_metar_read(murk_observation *out, const char *text,
                            const char *where, murk_error *err)
{
    metar m = {.out = out};
    size_t k = 0;
    bool is_remark = false, is_forecast = false;
    *out = murk_observation_empty();
    const murk_status status = murk_groups_cut(&m.groups, text, where, err);
    if (status) {
        return status;
    }
    /* METAR or SPECI may be missing; then the station and the time. */
    const char *const *group = m.groups.group;
    k += strcmp(group[k], "METAR") == 0 || strcmp(group[k], "SPECI") == 0;
    k += strcmp(group[k], "COR") == 0;
    if (strlen(group[k]) != 4 || group[k][0] < 'A' ||
        strspn(group[k], "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789") != 4) {
        return fail_form(&m.groups, k,
                         "a station of four letters, such as EGHI", where, err);
    }
    ++k;
    if (!murk_group_is(group[k], "000000Z") ||
        murk_group_number(group[k], 2) > 31 ||
        murk_group_number(group[k], 2) == 0 ||
        murk_group_number(group[k] + 2, 2) > 23 ||
        murk_group_number(group[k] + 4, 2) > 59) {
        return fail_form(&m.groups, k, "day and time, such as 150650Z", where,
                         err);
    }
    out->day = murk_group_number(group[k], 2);
    out->minute = HOUR_MIN * murk_group_number(group[k] + 2, 2) +
                  murk_group_number(group[k] + 4, 2);
    if (strcmp(group[k + 1], "NIL") == 0 || group[k + 1][0] == '\0') {
        return fail_form(&m.groups, k + 1, "an observation", where, err);
    }
    for (++k; k < m.groups.n; ++k) {
        is_remark = is_remark || strcmp(group[k], "RMK") == 0;
        is_forecast = is_forecast || is_trend(group[k]);
        if (is_remark) {
            take_remark(&m, group[k]);
        } else if (!is_forecast) {
            take_group(&m, k);
        }
    }
    return m.stated > 0
               ? MURK_OK
               : fail_form(&m.groups, m.groups.n, "an observation", where, err);
}
