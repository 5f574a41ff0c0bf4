/* Reads SYNOP reports. Section 0 says what the station is and where; section 1
 * has groups whose first digit tells what they state. */
#include "weather/groups.h"

#include <math.h>
#include <string.h>

#define HOUR_MIN 60 /* minutes of an hour */

/* The words of section 0 up to the group iRixhVV, by the kind of station: land
 * stations state time and number, ships call sign, time and two groups of
 * position, mobile land stations also their square and height. */
static const struct {
    const char *begin;
    size_t time;  /* number of the group with day, hour and wind unit */
    size_t first; /* number of the group iRixhVV */
} KINDS[] = {{"AAXX", 1, 3}, {"BBXX", 2, 5}, {"OOXX", 2, 7}};

typedef struct synop {
    murk_groups groups;
    murk_observation *out;
    int rain_code; /* iR: 0, 1 a group 6 follows; 3 no rain; 4 not observed */
    int weather_code; /* ix: 1, 4, 7 a group 7 follows */
} synop;

/* Visibility by code table 4377. */
static void take_visibility(synop *s, const char *vv)
{
    static const double nineties[] = {50,   50,   200,   500,   1000,
                                      2000, 4000, 10000, 20000, 50000};
    const int code = murk_group_number(vv, 2);
    murk_observation *out = s->out;
    if (code >= 51 && code <= 55) { /* not used by the table */
        murk_group_append(out->unknown, vv);
        return;
    }
    out->visibility_m = code <= 50   ? code * 100.0
                        : code <= 80 ? (code - 50) * 1000.0
                        : code <= 88 ? (code - 74) * 5000.0
                        : code == 89 ? 70000
                                     : nineties[code - 90];
    if (code == 0) {
        out->visibility_m = 100;
    }
    out->visibility_limit = code == 0 || code == 90 ? MURK_VISIBILITY_LESS_THAN
                            : code == 89 || code == 99
                                ? MURK_VISIBILITY_AT_LEAST
                                : MURK_VISIBILITY_EXACT;
}

/* ---- weather ---- */

/* A range of codes of present weather. */
typedef struct weather_codes {
    int from, to;
    murk_weather_kind kind;
    bool is_drizzle, is_rain;
    int intensity; /* 0 light, 1 moderate, 2 heavy */
} weather_codes;

/* Code table 4677, of observers. 20 to 29 are weather that has ceased; 40 is
 * fog at a distance, 10 mist, 11 and 12 shallow fog, 36 and 37 snow that drifts
 * below the eyes. */
static const weather_codes BY_OBSERVER[] = {
    {4, 10, MURK_WEATHER_HAZE, false, false, 0},
    {30, 35, MURK_WEATHER_HAZE, false, false, 0},
    {38, 39, MURK_WEATHER_SNOW, false, false, 0},
    {41, 49, MURK_WEATHER_FOG, false, false, 0},
    {50, 51, MURK_WEATHER_NONE, true, false, 0},
    {52, 53, MURK_WEATHER_NONE, true, false, 1},
    {54, 55, MURK_WEATHER_NONE, true, false, 2},
    {56, 56, MURK_WEATHER_NONE, true, false, 0},
    {57, 57, MURK_WEATHER_NONE, true, false, 1},
    {58, 58, MURK_WEATHER_NONE, true, true, 0},
    {59, 59, MURK_WEATHER_NONE, true, true, 1},
    {60, 61, MURK_WEATHER_NONE, false, true, 0},
    {62, 63, MURK_WEATHER_NONE, false, true, 1},
    {64, 65, MURK_WEATHER_NONE, false, true, 2},
    {66, 66, MURK_WEATHER_NONE, false, true, 0},
    {67, 67, MURK_WEATHER_NONE, false, true, 1},
    {68, 79, MURK_WEATHER_SNOW, false, false, 0},
    {80, 80, MURK_WEATHER_NONE, false, true, 0},
    {81, 81, MURK_WEATHER_NONE, false, true, 1},
    {82, 82, MURK_WEATHER_NONE, false, true, 2},
    {83, 88, MURK_WEATHER_SNOW, false, false, 0},
    {91, 91, MURK_WEATHER_NONE, false, true, 0},
    {92, 92, MURK_WEATHER_NONE, false, true, 1},
    {93, 94, MURK_WEATHER_SNOW, false, false, 0},
    {95, 95, MURK_WEATHER_NONE, false, true, 1},
    {97, 97, MURK_WEATHER_NONE, false, true, 2},
};

/* Code table 4680, of automatic stations. */
static const weather_codes BY_STATION[] = {
    {4, 5, MURK_WEATHER_HAZE, false, false, 0},
    {10, 10, MURK_WEATHER_HAZE, false, false, 0},
    {27, 29, MURK_WEATHER_HAZE, false, false, 0},
    {30, 35, MURK_WEATHER_FOG, false, false, 0},
    {40, 41, MURK_WEATHER_NONE, false, true, 0},
    {42, 42, MURK_WEATHER_NONE, false, true, 2},
    {43, 43, MURK_WEATHER_NONE, false, true, 0},
    {44, 44, MURK_WEATHER_NONE, false, true, 2},
    {45, 46, MURK_WEATHER_SNOW, false, false, 0},
    {47, 47, MURK_WEATHER_NONE, false, true, 0},
    {48, 48, MURK_WEATHER_NONE, false, true, 2},
    {50, 51, MURK_WEATHER_NONE, true, false, 0},
    {52, 52, MURK_WEATHER_NONE, true, false, 1},
    {53, 53, MURK_WEATHER_NONE, true, false, 2},
    {54, 54, MURK_WEATHER_NONE, true, false, 0},
    {55, 55, MURK_WEATHER_NONE, true, false, 1},
    {56, 56, MURK_WEATHER_NONE, true, false, 2},
    {57, 57, MURK_WEATHER_NONE, true, true, 0},
    {58, 58, MURK_WEATHER_NONE, true, true, 1},
    {60, 61, MURK_WEATHER_NONE, false, true, 0},
    {62, 62, MURK_WEATHER_NONE, false, true, 1},
    {63, 63, MURK_WEATHER_NONE, false, true, 2},
    {64, 64, MURK_WEATHER_NONE, false, true, 0},
    {65, 65, MURK_WEATHER_NONE, false, true, 1},
    {66, 66, MURK_WEATHER_NONE, false, true, 2},
    {67, 78, MURK_WEATHER_SNOW, false, false, 0},
    {80, 81, MURK_WEATHER_NONE, false, true, 0},
    {82, 82, MURK_WEATHER_NONE, false, true, 1},
    {83, 84, MURK_WEATHER_NONE, false, true, 2},
    {85, 87, MURK_WEATHER_SNOW, false, false, 0},
    {92, 92, MURK_WEATHER_NONE, false, true, 1},
    {95, 95, MURK_WEATHER_NONE, false, true, 2},
};

/* Group 7wwW1W2. */
static void take_weather(synop *s, const char *group)
{
    const bool is_automatic = s->weather_code == 7;
    const weather_codes *codes = is_automatic ? BY_STATION : BY_OBSERVER;
    const size_t n = is_automatic ? sizeof BY_STATION / sizeof *BY_STATION
                                  : sizeof BY_OBSERVER / sizeof *BY_OBSERVER;
    const int ww = murk_group_number(group + 1, 2);
    const char text[3] = {group[1], group[2], '\0'};
    murk_group_append(s->out->weather, text);
    for (size_t i = 0; i < n; ++i) {
        if (ww >= codes[i].from && ww <= codes[i].to) {
            s->out->kind = codes[i].kind;
            if (codes[i].is_drizzle || codes[i].is_rain) {
                s->out->rain_mm_per_h =
                    murk_rain_of_class(!codes[i].is_rain, codes[i].intensity);
                s->out->rain_is_by_word = true;
            }
        }
    }
}

/* Group 6RRRt: the amount replaces the rate by the intensity if it fell within
 * the last hour, while it rains. */
static void take_rain(synop *s, const char *group)
{
    const int amount = murk_group_number(group + 1, 3);
    const bool is_hour = group[4] == '5'; /* code table 4019 */
    const double mm = amount > 990 ? (amount - 990) / 10.0 : amount;
    if (is_hour && amount != 990 && mm > 0 && mm <= MURK_RAIN_MM_PER_H_MAX &&
        s->out->rain_mm_per_h > 0) {
        s->out->rain_mm_per_h = mm;
        s->out->rain_is_by_word = false;
    }
}

/* ---- the report ---- */

/* Names a group that is not understood. */
static void name_unknown(synop *s, const char *group)
{
    murk_group_append(s->out->unknown, group);
}

/* Groups 1sTTT and 2sTTT: sign and tenths of a degree. */
static void take_temperature(synop *s, const char *group, double *out)
{
    const double t = murk_group_number(group + 2, 3) / 10.0;
    const double temperature_c = group[1] == '1' ? -t : t;
    if (group[1] <= '1' && murk_is_of_air(temperature_c)) {
        *out = temperature_c;
    } else {
        name_unknown(s, group);
    }
}

static void take_group(synop *s, const char *group)
{
    murk_observation *out = s->out;
    if (murk_group_is(group, "10000")) {
        take_temperature(s, group, &out->temperature_c);
    } else if (murk_group_is(group, "20000")) {
        if (group[1] != '9') { /* 29 is a humidity */
            take_temperature(s, group, &out->dew_point_c);
        }
    } else if (murk_group_is(group, "30000")) {
        const int tenths = murk_group_number(group + 1, 4);
        out->pressure_hpa = tenths / 10.0 + (tenths < 5000 ? 1000 : 0);
    } else if (murk_group_is(group, "70000") || murk_group_is(group, "700??")) {
        take_weather(s, group);
    }
}

/* True for a group that ends section 1: 333, 444, 555, or 222 with the course
 * of a ship. */
static bool ends_section(const char *group)
{
    return murk_group_is(group, "333") || murk_group_is(group, "444") ||
           murk_group_is(group, "555") || murk_group_is(group, "222??");
}

/* Reads the groups behind Nddff up to the end of section 1. The group of rain
 * comes before that of weather, so rain is read in a second pass. */
static void read_section(synop *s, size_t k)
{
    const char *const *group = s->groups.group;
    size_t end = k;
    for (; end < s->groups.n && !ends_section(group[end]); ++end) {
        if (murk_group_is(group[end], "?????")) {
            take_group(s, group[end]);
        } else {
            name_unknown(s, group[end]);
        }
    }
    for (; k < end; ++k) {
        if (murk_group_is(group[k], "60000") && s->rain_code < 2) {
            take_rain(s, group[k]);
        }
    }
}

static murk_status fail_group(const synop *s, size_t k, const char *must,
                              const char *where, murk_error *err)
{
    return murk_group_fail(&s->groups, k, "SYNOP", must, where, err);
}

murk_status murk_synop_read(murk_observation *out, const char *text,
                            const char *where, murk_error *err)
{
    synop s = {.out = out};
    size_t kind = 0;
    *out = murk_observation_empty();
    const murk_status status = murk_groups_cut(&s.groups, text, where, err);
    if (status) {
        return status;
    }
    /* Section 0. */
    const char *const *group = s.groups.group;
    const size_t kinds = sizeof KINDS / sizeof *KINDS;
    while (kind < kinds && strcmp(group[0], KINDS[kind].begin) != 0) {
        ++kind;
    }
    if (kind == kinds) {
        return fail_group(&s, 0, "AAXX, BBXX or OOXX at the beginning", where,
                          err);
    }
    const size_t time = KINDS[kind].time, first = KINDS[kind].first;
    if (!murk_group_is(group[time], "0000?") ||
        murk_group_number(group[time], 2) > 31 ||
        murk_group_number(group[time] + 2, 2) > 24) {
        return fail_group(&s, time, "day, hour and unit of wind, such as 15061",
                          where, err);
    }
    out->day = murk_group_number(group[time], 2);
    out->minute = HOUR_MIN * murk_group_number(group[time] + 2, 2);
    if (kind == 0 && !murk_group_is(group[2], "00000")) {
        return fail_group(&s, 2, "the number of a station", where, err);
    }
    if (kind == 0 && strcmp(group[first], "NIL") == 0) {
        return fail_group(&s, first, "an observation", where, err);
    }
    /* Section 1: iRixhVV and Nddff, then the groups by their first digit. */
    const char *head = group[first], *wind = group[first + 1];
    /* Indicators of rain are 0 to 4 and, in some countries, 6 to 8; those of
     * weather 1 to 7 (code tables 1819 and 1860). */
    if (!murk_group_is(head, "?????") || strchr("59", head[0]) ||
        strchr("089", head[1])) {
        return fail_group(&s, first, "indicators and visibility, such as 11/05",
                          where, err);
    }
    if (!murk_group_is(wind, "?????")) {
        return fail_group(&s, first + 1, "cloud cover and wind, such as 80302",
                          where, err);
    }
    s.rain_code = head[0] == '/' ? 4 : head[0] - '0';
    s.weather_code = head[1] == '/' ? 3 : head[1] - '0';
    if (murk_group_is(head + 3, "00")) {
        take_visibility(&s, head + 3);
    }
    if (wind[0] >= '0' && wind[0] <= '9') { /* eighths; 9: hidden by fog */
        out->sky_cover = wind[0] == '9' ? 1 : (wind[0] - '0') / 8.0;
    }
    read_section(&s, first + 2);
    return MURK_OK;
}
