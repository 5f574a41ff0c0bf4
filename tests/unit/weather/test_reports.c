/* METAR and SYNOP reports: groups of every kind, missing groups, and texts that
 * are no reports. */
#include "check.h"
#include "weather/report.h"

static murk_observation metar(const char *text)
{
    murk_observation out;
    murk_error err = {0};
    CHECK(murk_metar_read(&out, text, "here", &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return out;
}

static murk_observation synop(const char *text)
{
    murk_observation out;
    murk_error err = {0};
    CHECK(murk_synop_read(&out, text, "here", &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return out;
}

static void test_visibility(void)
{
    static const struct {
        const char *group;
        double m;
        murk_visibility_limit limit;
    } cases[] = {
        {"0500", 500, MURK_VISIBILITY_EXACT},
        {"0000", 50, MURK_VISIBILITY_LESS_THAN},
        {"9999", 10000, MURK_VISIBILITY_AT_LEAST},
        {"CAVOK", 10000, MURK_VISIBILITY_AT_LEAST},
        {"4000NDV", 4000, MURK_VISIBILITY_EXACT},
        {"6000 1200SW", 6000, MURK_VISIBILITY_EXACT},
        {"10SM", 16093.44, MURK_VISIBILITY_AT_LEAST},
        {"P6SM", 9656.064, MURK_VISIBILITY_AT_LEAST},
        {"M1/4SM", 402.336, MURK_VISIBILITY_LESS_THAN},
        {"1 1/4SM", 2011.68, MURK_VISIBILITY_EXACT},
        {"3/4SM", 1207.008, MURK_VISIBILITY_EXACT},
        {"7SM", 11265.408, MURK_VISIBILITY_EXACT},
        {"20KM", 20000, MURK_VISIBILITY_EXACT},
    };
    /* Each group in a report. */
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        char text[128];
        snprintf(text, sizeof text, "EGHI 150650Z 06001KT %s 11/10 Q1003",
                 cases[i].group);
        const murk_observation got = metar(text);
        CHECK_NEAR(got.visibility_m, cases[i].m, 1e-9);
        CHECK(got.visibility_limit == cases[i].limit);
        CHECK_TEXT(got.unknown, "");
        CHECK_NEAR(got.temperature_c, 11, 0);
    }
    CHECK(isnan(metar("EGHI 150650Z AUTO ///SM 11/10").visibility_m));
    CHECK(isnan(metar("EGHI 150650Z AUTO //// 11/10").visibility_m));
    CHECK(isnan(metar("EGHI 150650Z AUTO 11/10").visibility_m));
}

static void test_weather(void)
{
    static const struct {
        const char *groups;
        murk_weather_kind kind;
        double mm_per_h;
    } cases[] = {
        {"FG", MURK_WEATHER_FOG, 0},       {"FZFG", MURK_WEATHER_FOG, 0},
        {"MIFG", MURK_WEATHER_NONE, 0},    {"VCFG", MURK_WEATHER_NONE, 0},
        {"BR", MURK_WEATHER_HAZE, 0},      {"HZ", MURK_WEATHER_HAZE, 0},
        {"-RA", MURK_WEATHER_NONE, 1.25},  {"RA", MURK_WEATHER_NONE, 5},
        {"+TSRA", MURK_WEATHER_NONE, 15},  {"-DZ BR", MURK_WEATHER_HAZE, .12},
        {"+RASN", MURK_WEATHER_SNOW, 15},  {"-SN", MURK_WEATHER_SNOW, 0},
        {"SHSN FG", MURK_WEATHER_SNOW, 0}, {"VCSH", MURK_WEATHER_NONE, 0},
        {"//", MURK_WEATHER_NONE, 0},      {"RERA", MURK_WEATHER_NONE, 0},
        {"DRSN", MURK_WEATHER_NONE, 0},    {"-DRSN FG", MURK_WEATHER_FOG, 0},
        {"+DRSN", MURK_WEATHER_NONE, 0},   {"-BLSN", MURK_WEATHER_SNOW, 0},
    };
    /* Each group in a report. */
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        char text[128];
        snprintf(text, sizeof text, "EGHI 150650Z 06001KT 3000 %s 11/10",
                 cases[i].groups);
        const murk_observation got = metar(text);
        CHECK(got.kind == cases[i].kind);
        CHECK_NEAR(got.rain_mm_per_h, cases[i].mm_per_h, 0);
        CHECK(got.rain_is_by_word == (cases[i].mm_per_h > 0));
        CHECK_TEXT(got.unknown, "");
        if (strcmp(cases[i].groups, "RERA") != 0) {
            CHECK_TEXT(got.weather, cases[i].groups);
        }
    }
}

static void test_others(void)
{
    /* The rain of the hour and tenths of degrees are remarks; a forecast is no
     * observation. */
    murk_observation got =
        metar("METAR KEWR 111851Z VRB03G19KT 2SM R04R/3000VP6000FT TSRA BR "
              "FEW015 BKN040CB OVC200 22/22 A2987 RMK AO2 P0013 T02270215=");
    CHECK_NEAR(got.rain_mm_per_h, 3.302, 1e-9);
    CHECK(!got.rain_is_by_word);
    CHECK_NEAR(got.temperature_c, 22.7, 1e-9);
    CHECK_NEAR(got.dew_point_c, 21.5, 1e-9);
    CHECK_NEAR(got.pressure_hpa, 1011.51, .01);
    CHECK_NEAR(got.sky_cover, 1, 0);
    got =
        metar("RJAA 061930Z 31010KT 9999 SCT002 M01/M06 Q0993 TEMPO 3000 -RA");
    CHECK_NEAR(got.rain_mm_per_h, 0, 0);
    CHECK_NEAR(got.visibility_m, 10000, 0);
    CHECK_NEAR(got.temperature_c, -1, 0);
    CHECK_NEAR(got.dew_point_c, -6, 0);
    CHECK_NEAR(got.sky_cover, 3.5 / 8, 0);
    CHECK(
        isnan(metar("EGHI 150650Z 06001KT 9999 ////// //// Q////").sky_cover));
    CHECK_TEXT(metar("EGHI 150650Z 06001KT 11/2SM 11/10").unknown, "11/2SM");
    CHECK_TEXT(metar("EGHI 150650Z 06001KT 9999 QFE99 11/10").unknown, "QFE99");
}

/* All groups that are not known are named; day and time are of the report;
 * temperatures that no air has are not known. */
static void test_named(void)
{
    murk_observation got =
        metar("EGHI 150650Z QFE99 06001KT 0500FG 11/10 RMK T19990000");
    CHECK_TEXT(got.unknown, "QFE99 0500FG");
    CHECK(isnan(got.visibility_m));
    CHECK_NEAR(got.temperature_c, 11, 0);
    CHECK(got.day == 15 && got.minute == 6 * 60 + 50);
    got = metar("EGHI 150650Z 06001KT 9999 99/10");
    CHECK_TEXT(got.unknown, "99/10");
    CHECK_NEAR(metar("EGHI 150650Z 9999 M85/M90").temperature_c, -85, 0);
    got = synop("AAXX 15061 10384 11465 80302 11999 21899 74544");
    CHECK_TEXT(got.unknown, "11999");
    CHECK(isnan(got.temperature_c));
    CHECK_NEAR(got.dew_point_c, -89.9, 1e-9);
    CHECK(got.day == 15 && got.minute == 6 * 60);
    CHECK_TEXT(synop("AAXX 15061 10384 11465 80302 10711 29085").unknown,
               "10711");
}

static void test_synop(void)
{
    murk_observation got =
        synop("AAXX 15061 10384 11465 80302 10052 21050 30111 40123 60025 "
              "76366 8807/ 333 10178 71234=");
    CHECK_NEAR(got.visibility_m, 15000, 0);
    CHECK_NEAR(got.temperature_c, 5.2, 1e-9);
    CHECK_NEAR(got.dew_point_c, -5, 1e-9);
    CHECK_NEAR(got.pressure_hpa, 1011.1, 1e-9);
    CHECK_NEAR(got.rain_mm_per_h, 2, 0); /* of the hour */
    CHECK(!got.rain_is_by_word);
    CHECK_NEAR(got.sky_cover, 1, 0);
    CHECK_TEXT(got.weather, "63");
    /* Without the amount of the hour the class counts. */
    got = synop("AAXX 15061 10384 11465 80302 10052 60021 76366");
    CHECK_NEAR(got.rain_mm_per_h, 5, 0);
    CHECK(got.rain_is_by_word);
    got = synop("AAXX 15061 10384 41/05 90302 10052 74544");
    CHECK(got.kind == MURK_WEATHER_FOG);
    CHECK_NEAR(got.visibility_m, 500, 0);
    CHECK_NEAR(got.sky_cover, 1, 0);
    /* An automatic station has another table of weather. */
    CHECK(synop("AAXX 15061 10384 17/05 /0302 73144").kind == MURK_WEATHER_FOG);
    CHECK(synop("AAXX 15061 10384 11/05 /0302 73144").kind ==
          MURK_WEATHER_HAZE);
    CHECK(isnan(synop("AAXX 15061 10384 46/// /0302 10052").visibility_m));
    /* A group that is not known is named, and those behind it count. */
    got = synop("AAXX 15061 10384 11/05 80302 1005 77344 333 74544");
    CHECK_TEXT(got.unknown, "1005");
    CHECK(got.kind == MURK_WEATHER_SNOW);
}

static void test_refused(void)
{
    static const struct {
        bool is_synop;
        const char *text, *part; /* of the message */
    } cases[] = {
        {false, "", "an empty METAR report, must have a station"},
        {false, "hello", "capital letters"},
        {false, "EGHI 150650Z 9999 mist", "'mist' in a weather report"},
        {false, "EGHI", "day and time"},
        {false, "EGHI 320650Z 9999", "day and time"},
        {false, "EGHI 152450Z 9999", "day and time"},
        {false, "EGHI 150650Z NIL", "observation"},
        {false, "EGHI 150650Z AUTO COR", "observation"},
        {false, "EGHI 150650Z 9999=EGHI 150750Z 0100 FG=", "one report"},
        {true, "AAXX 15061 10384 80302 10052 74544", "visibility"},
        {true, "AAXX 15061 10384 10/05 80302 10052", "visibility"},
        {false, "EGHI 150650Z",
         "ends behind '150650Z', must go on with an obs"},
        {true, "AAXX 15061 10384 11/05",
         "a SYNOP report ends behind '11/05', must go on with cloud cover"},
        {false, "TAF EGHI 150650Z 9999", "station"},
        {true, "ZZXX 15061", "AAXX"},
        {true, "AAXX 15061 10384 NIL", "observation"},
        {true, "AAXX 1506 10384 11/05 80302", "day, hour"},
        {true, "AAXX 15061 10384 11/0 80302", "visibility"},
        {true, "AAXX 15061 10384 11/05 803", "cloud cover"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        murk_observation out;
        murk_error err = {0};
        const murk_status status =
            cases[i].is_synop
                ? murk_synop_read(&out, cases[i].text, "here", &err)
                : murk_metar_read(&out, cases[i].text, "here", &err);
        CHECK(status == MURK_BAD_VALUE);
        CHECK_TEXT(err.where, "here");
        CHECK(strstr(err.text, cases[i].part) != NULL);
    }
}

int main(void)
{
    test_visibility();
    test_weather();
    test_others();
    test_named();
    test_synop();
    test_refused();
    return check_done();
}
