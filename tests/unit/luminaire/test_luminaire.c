/* The readers of LM-63 and EULUMDAT: versions, factors, symmetries, openings,
 * TILT data, and refusals that name the line. */
#include "base/file.h"
#include "base/log.h"
#include "check.h"
#include "luminaire/photometric_file.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

#define MAX_TEXT 20000

static murk_luminaire *parse(const char *path, const char *text,
                             murk_error *err)
{
    static char copy[MAX_TEXT];
    murk_luminaire *out = NULL;
    snprintf(copy, sizeof copy, "%s", text);
    *err = (murk_error){0};
    murk_luminaire_parse(&out, path, copy, strlen(copy), err);
    return out;
}

static murk_luminaire *good(const char *text)
{
    murk_error err;
    murk_luminaire *out = parse("a.ies", text, &err);
    CHECK_TEXT(err.where, "");
    CHECK_TEXT(err.text, "");
    return out;
}

static void refused(const char *text, const char *where, const char *why)
{
    murk_error err;
    murk_luminaire *out = parse("a.ies", text, &err);
    CHECK(out == NULL);
    CHECK(err.code == MURK_BAD_FILE);
    CHECK_TEXT(err.where, where);
    CHECK_MENTIONS(err.text, why);
    murk_luminaire_destroy(out);
}

/* A file of LM-63 with that head, numbers and table. */
static const char *ies(const char *head, const char *numbers, const char *table)
{
    static char text[MAX_TEXT];
    snprintf(text, sizeof text, "%s%s%s", head, numbers, table);
    return text;
}

#define HEAD  "IESNA:LM-63-2002\n[LUMINAIRE] Lamp\n[TEST] 1\nTILT=NONE\n"
#define ROUND "1 1000 2 3 1 1 2 0.3 0.5 0\n0.9 0.5 40\n"
#define TABLE "0 45 90\n0\n100 50 0\n"

static double at(const murk_luminaire *lamp, double gamma, double c)
{
    return murk_intensity_at_angles(lamp->intensity, gamma, c);
}

/* The third factor counts up to 2002; in 2019 it is a code. */
static void test_versions_and_factors(void)
{
    static const struct {
        const char *head, *format;
        double factor;
    } known[] = {
        {"Label\n second label\nTILT=NONE\n", "LM-63-1986", 0.9},
        {"IESNA91\n[TEST] a\nTILT=NONE\n", "LM-63-1991", 0.9},
        {"IESNA:LM-63-1995\r\n[TEST] a\r\nTILT=NONE\r\n", "LM-63-1995", 0.9},
        {"IESNA:LM-63-2002\n[TEST] a\nTILT=NONE\n", "LM-63-2002", 0.9},
        {"IES:LM-63-2019\n[TEST] a\n[TESTLAB] b\n[ISSUEDATE] c\n[MANUFAC] d\n"
         "[FILEGENINFO] e\n[_OWN] f\n[MORE] g\nTILT=NONE\n",
         "LM-63-2019", 1.8},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; ++i) {
        /* Each version has the same table. */
        murk_luminaire *lamp = good(ies(known[i].head, ROUND, TABLE));
        if (lamp) {
            CHECK_TEXT(lamp->format, known[i].format);
            CHECK_NEAR(at(lamp, 45, 0), 50 * known[i].factor, 1e-12);
            CHECK(lamp->input_w == 40);
            CHECK(lamp->declared_lumens == 1000);
            CHECK(lamp->verticals == 3 && lamp->horizontals == 1);
        }
        murk_luminaire_destroy(lamp);
    }
    refused("IESNA:LM-63-2010\nTILT=NONE\n" ROUND TABLE, "a.ies:1",
            "must be IESNA91");
}

static void test_absolute_photometry(void)
{
    murk_luminaire *lamp =
        good(ies(HEAD, "1 -1 1 3 1 1 2 0 0 0 1 1 40\n", TABLE));
    CHECK(lamp && isnan(lamp->declared_lumens));
    CHECK(lamp && lamp->aperture == MURK_APERTURE_POINT);
    CHECK_TEXT(lamp ? lamp->name : "", "Lamp");
    murk_luminaire_destroy(lamp);
}

/* Four planes and the symmetry that their angles tell. */
static void test_symmetries_of_lm_63(void)
{
    static const struct {
        const char *angles;
        int planes;
        murk_luminaire_symmetry symmetry;
        double c[8], want[8]; /* at gamma 90: plane p has p + 1 candela */
    } known[] = {
        {"0 30 90",
         3,
         MURK_SYMMETRY_QUADRANT,
         {30, 150, 210, 330, 90, 270, 180, 0},
         {2, 2, 2, 2, 3, 3, 1, 1}},
        {"0 30 180",
         3,
         MURK_SYMMETRY_0_180,
         {30, 330, 180, 0, 105, 255, 360, -30},
         {2, 2, 3, 1, 2.5, 2.5, 1, 2}},
        {"90 210 270",
         3,
         MURK_SYMMETRY_90_270,
         {210, 330, 90, 270, 150, 30, 240, 300},
         {2, 2, 1, 3, 1.5, 1.5, 2.5, 2.5}},
        {"0 90 180 360",
         4,
         MURK_SYMMETRY_NONE,
         {0, 90, 180, 270, 45, 135, 300, 90},
         {1, 2, 3, 3.5, 1.5, 2.5, 11. / 3, 2}},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; ++i) {
        char table[400];
        int n = snprintf(table, sizeof table, "0 90\n%s\n", known[i].angles);
        for (int p = 0; p < known[i].planes; ++p) {
            n += snprintf(table + n, sizeof table - (size_t)n, "7 %d\n", p + 1);
        }
        char numbers[80];
        snprintf(numbers, sizeof numbers, "1 1 1 2 %d 1 2 0 0 0 1 1 1\n",
                 known[i].planes);
        murk_luminaire *lamp = good(ies(HEAD, numbers, table));
        CHECK(lamp && lamp->symmetry == known[i].symmetry);
        /* The unfolded planes are one full turn. */
        if (lamp) {
            const murk_intensity_angles a =
                murk_intensity_angles_of(lamp->intensity);
            CHECK(a.verticals == 2 && a.vertical_deg[1] == 90);
            CHECK(a.horizontal_deg[a.horizontals - 1] ==
                  a.horizontal_deg[0] + 360);
        }
        for (int k = 0; lamp && k < 8; ++k) {
            CHECK_NEAR(at(lamp, 90, known[i].c[k]), known[i].want[k], 1e-12);
            CHECK_NEAR(at(lamp, 0, known[i].c[k]), 7, 1e-12);
        }
        murk_luminaire_destroy(lamp);
    }
}

/* Types A and B that begin at H = 0 are mirrored to the left. */
static void test_types_a_and_b(void)
{
    for (int type = 2; type <= 3; ++type) {
        char numbers[80];
        snprintf(numbers, sizeof numbers, "1 1 1 2 3 %d 2 0 0 0 1 1 1\n", type);
        murk_luminaire *lamp =
            good(ies(HEAD, numbers, "-90 90\n0 45 90\n1 2\n3 4\n5 6\n"));
        CHECK(lamp && lamp->symmetry == MURK_SYMMETRY_LEFT_RIGHT);
        for (int side = -1; lamp && side <= 1; side += 2) {
            CHECK(at(lamp, -90, side * 45.0) == 3);
            CHECK(at(lamp, 90, side * 90.0) == 6);
        }
        murk_luminaire_destroy(lamp);
        lamp = good(ies(HEAD, numbers, "0 90\n-90 0 90\n1 2\n3 4\n5 6\n"));
        CHECK(lamp && lamp->symmetry == MURK_SYMMETRY_NONE);
        CHECK(lamp && at(lamp, 90, -90) == 2);
        CHECK(lamp && at(lamp, -1, -90) == 0);
        murk_luminaire_destroy(lamp);
    }
}

static void test_apertures(void)
{
    static const struct {
        const char *year, *size;
        murk_luminaire_aperture aperture;
        double along_c0_m, along_c90_m, height_m;
    } known[] = {
        {"2002", "2 0 0 0", MURK_APERTURE_POINT, 0, 0, 0},
        {"2002", "2 .3 .5 0", MURK_APERTURE_RECT, .5, .3, 0},
        {"2002", "1 1 2 .1", MURK_APERTURE_RECT, .6096, .3048, .03048},
        {"2002", "2 -.4 -.4 0", MURK_APERTURE_DISC, .4, 0, 0},
        {"1995", "2 -.4 0 .05", MURK_APERTURE_DISC, .4, 0, .05},
        {"1995", "2 0 -.4 .05", MURK_APERTURE_DISC, .4, 0, .05},
        {"1995", "2 -.4 .9 0", MURK_APERTURE_DISC, .6, 0, 0},
        {"2002", "2 -.4 -.4 .7", MURK_APERTURE_DISC, .4, 0, .7},
        {"2002", "2 -.4 .9 -.4", MURK_APERTURE_RECT, .9, .4, 0},
        {"1995", "2 0 .9 -.2", MURK_APERTURE_RECT, .9, .2, 0},
        {"2002", "2 -.2 -.2 -.2", MURK_APERTURE_DISC, .2, 0, 0},
        {"2002", "2 -.4 0 -.4", MURK_APERTURE_RECT, 0, .4, 0},
        {"2002", "2 0 -.4 -.4", MURK_APERTURE_RECT, .4, 0, 0},
        {"1995", "2 -.4 0 -.4", MURK_APERTURE_DISC, .4, 0, 0},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; ++i) {
        /* units, width, length, height */
        char head[80], numbers[80];
        snprintf(head, sizeof head, "IESNA:LM-63-%s\nTILT=NONE\n",
                 known[i].year);
        snprintf(numbers, sizeof numbers, "1 1 1 3 1 1 %s 1 1 1\n",
                 known[i].size);
        murk_luminaire *lamp = good(ies(head, numbers, TABLE));
        CHECK(lamp && lamp->aperture == known[i].aperture);
        CHECK_NEAR(lamp ? lamp->along_c0_m : 0, known[i].along_c0_m, 1e-12);
        CHECK_NEAR(lamp ? lamp->along_c90_m : 0, known[i].along_c90_m, 1e-12);
        CHECK_NEAR(lamp ? lamp->height_m : 0, known[i].height_m, 1e-12);
        murk_luminaire_destroy(lamp);
    }
}

#define TILT "2\n3\n0 30 90\n1 .9 .6\n"

static void check_tilt(murk_luminaire *lamp)
{
    CHECK(lamp && lamp->tilts == 3);
    if (lamp) {
        CHECK(murk_luminaire_tilt_factor(lamp, 0) == 1);
        CHECK_NEAR(murk_luminaire_tilt_factor(lamp, 15), .95, 1e-15);
        CHECK_NEAR(murk_luminaire_tilt_factor(lamp, 60), .75, 1e-15);
        CHECK(murk_luminaire_tilt_factor(lamp, 180) == .6);
        CHECK(at(lamp, 0, 0) == 90); /* the table itself has no tilt */
    }
    murk_luminaire_destroy(lamp);
}

static void test_tilt(void)
{
    check_tilt(good("IESNA91\nTILT=INCLUDE\n" TILT ROUND TABLE));
    /* A file beside the file. */
    char folder[] = "/tmp/murk-tilt-XXXXXX", path[80], text[2000];
    CHECK(mkdtemp(folder) != NULL);
    snprintf(path, sizeof path, "%s/lamp.tlt", folder);
    write_bytes(path, TILT, sizeof TILT - 1);
    snprintf(text, sizeof text, "IESNA91\nTILT=lamp.tlt\n" ROUND TABLE);
    snprintf(path, sizeof path, "%s/a.ies", folder);
    murk_error err;
    check_tilt(parse(path, text, &err));
    CHECK_TEXT(err.text, "");
    snprintf(path, sizeof path, "%s/lamp.tlt", folder);
    write_bytes(path, TILT "1", sizeof TILT);
    snprintf(path, sizeof path, "%s/a.ies", folder);
    CHECK(parse(path, text, &err) == NULL);
    CHECK_MENTIONS(err.where, "lamp.tlt:5");
    snprintf(path, sizeof path, "%s/lamp.tlt", folder);
    unlink(path);
    rmdir(folder);
    refused("IESNA91\nTILT=../lamp.tlt\n" ROUND TABLE, "a.ies:2",
            "must be NONE, INCLUDE or the name of a file beside");
    refused("IESNA91\nTILT=/etc/passwd\n" ROUND TABLE, "a.ies:2", "must be");
    refused("IESNA91\nTILT=\n" ROUND TABLE, "a.ies:2", "must be");
    refused("IESNA91\nTILT=INCLUDE\n1 2 30 30 1 1\n" ROUND TABLE, "a.ies:3",
            "must rise");
}

static void test_refusals_of_lm_63(void)
{
    refused("", "a.ies:1", "an empty file");
    refused("IESNA91\n[TEST] no tilt\n", "a.ies:2", "without a line TILT=");
    refused(HEAD "1 1000 2 3 1 4 2 0 0 0\n", "a.ies:5", "photometric type: 4");
    refused(HEAD "1 1000 0 3 1 1 2 0 0 0\n", "a.ies:5", "candela multiplier");
    refused(HEAD "1 -7 1 3 1 1 2 0 0 0\n1 1 1\n", "a.ies:5",
            "lumens per lamp: -7");
    refused(HEAD ROUND "0 45 45\n0\n1 2 3\n", "a.ies:7", "must rise");
    refused(HEAD ROUND "0 45 181\n0\n1 2 3\n", "a.ies:7",
            "vertical angle: 181, must be a number 0..180");
    refused(HEAD ROUND "0 45 90\n10\n1 2 3\n", "a.ies:8",
            "horizontal angles 10..10, must be 0");
    refused(HEAD ROUND "0 45 90\n0\n1 -2 3\n", "a.ies:9", "intensity: -2");
    refused(HEAD ROUND "0 45 90\n0\n1 nan 3\n", "a.ies:9", "intensity: nan");
    refused(HEAD ROUND "0 45 90\n0\n1 2\n", "a.ies:10", "the file ends");
    refused(HEAD ROUND "0 45 90\n0\n1 2 3\n4\n", "a.ies:10",
            "4 behind the last value");
    refused(HEAD ROUND "0 45 90\n0\n0 0 0\n", "a.ies", "0 lm");
    refused(HEAD ROUND "0 45 90\n0\n1,,2 3\n", "a.ies:9", "two commas");
    refused(HEAD "1 1 1 100000\n100000 1 2 0 0 0\n1 1 1\n", "a.ies:6",
            "must be at most");
}

/* A number of 63 characters is read; a longer one is refused, and not read up
 * to its 63rd character. */
static void test_long_numbers(void)
{
    char table[200];
    for (int zeros = 59; zeros <= 62; ++zeros) {
        snprintf(table, sizeof table, "0 45 90\n0\n1 %0*d%s 0\n", zeros, 2,
                 zeros == 59 ? ".5e0" : ".5e1");
        if (zeros == 59) {
            murk_luminaire *lamp = good(ies(HEAD, ROUND, table));
            CHECK(lamp && fabs(at(lamp, 45, 0) - 2.5 * .9) < 1e-12);
            murk_luminaire_destroy(lamp);
        } else {
            refused(ies(HEAD, ROUND, table), "a.ies:9",
                    "must be a number of at most 63");
        }
    }
}

/* Blanks, commas, tabs and all kinds of line ends; Ctrl-Z at the end. */
static void test_separators(void)
{
    murk_luminaire *lamp =
        good("IESNA91\r[TEST] a\rTILT=NONE\r1,1000,2,3,1,1,2,0,0,0\r1 , 1\t1\r"
             "0,45, 90\r0\r1,\r2, 3\r\x1a");
    CHECK(lamp && at(lamp, 90, 0) == 6);
    murk_luminaire_destroy(lamp);
}

/* ---- EULUMDAT ---- */

/* An intensity with the symmetry of the number. */
static double wanted(int symmetry, double gamma, double c)
{
    const double rad = MURK_PI / 180;
    const double x = sin(gamma * rad) * cos(c * rad),
                 y = sin(gamma * rad) * sin(c * rad);
    switch (symmetry) {
    case 1:
        return 100 + gamma;
    case 2:
        return 100 + 30 * x + 20 * y * y;
    case 3:
        return 100 + 30 * y + 20 * x * x;
    case 4:
        return 100 + 30 * x * x + 20 * y * y * y * y;
    default:
        return 100 + 30 * x + 20 * y;
    }
}

enum { C_PLANES = 24, GAMMAS = 7 };

/* A file with that symmetry: planes every 15 degrees, gamma every 30. */
static const char *ldt(int symmetry, const char *factor)
{
    static char text[MAX_TEXT];
    static const int first[] = {0, 0, 0, 18, 0}, n[] = {24, 1, 13, 13, 7};
    /* The head, with two sets of lamps. */
    size_t k = (size_t)snprintf(
        text, sizeof text,
        "Maker\n1\n%d\n%d\n15\n%d\n30\nreport\nLamp \xe4\nnumber\nfile\ndate\n"
        "600\n300\n100\n500\n200\n0\n0\n0\n0\n100\n80\n%s\n0\n2\n1\nLED\n"
        "1500\nw\n80\n20\n1\nLED\n500\nw\n80\n10\n",
        symmetry, C_PLANES, GAMMAS, factor);
    for (int i = 0; i < 10; ++i) {
        k += (size_t)snprintf(text + k, sizeof text - k, "0.%d\n", i);
    }
    for (int i = 0; i < C_PLANES; ++i) {
        k += (size_t)snprintf(text + k, sizeof text - k, "%d\n", 15 * i);
    }
    for (int i = 0; i < GAMMAS; ++i) {
        k += (size_t)snprintf(text + k, sizeof text - k, "%d\n", 30 * i);
    }
    for (int i = 0; i < n[symmetry] * GAMMAS; ++i) {
        const double c = 15.0 * ((first[symmetry] + i / GAMMAS) % C_PLANES);
        k += (size_t)snprintf(text + k, sizeof text - k, "%.17g\n",
                              wanted(symmetry, 30.0 * (i % GAMMAS), c));
    }
    return text;
}

static void test_symmetries_of_eulumdat(void)
{
    for (int symmetry = 0; symmetry <= 4; ++symmetry) {
        murk_error err;
        murk_luminaire *lamp = parse("a.ldt", ldt(symmetry, "1.5"), &err);
        CHECK_TEXT(err.text, "");
        double off = 0;
        for (int i = 0; lamp && i < C_PLANES * GAMMAS; ++i) {
            const double c = 15.0 * (i / GAMMAS), g = 30.0 * (i % GAMMAS);
            /* 2 klm times the factor 1.5 */
            off = fmax(off, fabs(at(lamp, g, c) - 3 * wanted(symmetry, g, c)));
        }
        CHECK(lamp && off < 1e-12 * 400);
        if (lamp) {
            CHECK_TEXT(lamp->format, "EULUMDAT");
            CHECK_TEXT(lamp->name, "Lamp ?");
            CHECK(lamp->lamp_lumens == 2000 && lamp->declared_lumens == 1600);
            CHECK(lamp->input_w == 30);
            CHECK(lamp->aperture == MURK_APERTURE_RECT);
            CHECK_NEAR(lamp->along_c0_m, .2, 1e-15);
            CHECK_NEAR(lamp->along_c90_m, .5, 1e-15);
        }
        murk_luminaire_destroy(lamp);
    }
}

/* The file with one line replaced; NULL: removed. */
static const char *changed(size_t line, const char *by)
{
    static char text[MAX_TEXT];
    const char *from = ldt(4, "1");
    size_t k = 0;
    for (size_t i = 1; *from; ++i) {
        const size_t length = strcspn(from, "\n") + 1;
        if (i == line) {
            k += by ? (size_t)snprintf(text + k, sizeof text - k, "%s\n", by)
                    : 0;
        } else {
            memcpy(text + k, from, length);
            k += length;
        }
        from += length;
    }
    text[k] = '\0';
    return text;
}

static void test_refusals_of_eulumdat(void)
{
    static const struct {
        size_t line;
        const char *by, *where, *why;
    } known[] = {
        {3, "5", "a.ldt:3", "symmetry: 5, must be a number 0..4"},
        {4, "0", "a.ldt:4", "number of C planes"},
        {4, "12.5", "a.ldt:4", "must be a whole number"},
        {6, "x", "a.ldt:6", "number of gamma angles: x"},
        {16, "", "a.ldt:16", "length of luminous area: nothing"},
        {24, "0", "a.ldt:24", "conversion factor"},
        {29, "-3", "a.ldt:29", "flux of the lamps: -3"},
        {49, "5", "a.ldt:49", "must begin at 0"},
        {51, "10", "a.ldt:51", "must rise"},
        {55, "91", "a.ldt:55", "must be 90 by symmetry 4 with 24 planes"},
        {74, "", "a.ldt:74", "gamma angle: nothing"},
        {80, "-1", "a.ldt:80", "intensity: -1"},
        {128, NULL, "a.ldt:128", "the file ends"},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; ++i) {
        murk_error err;
        murk_luminaire *lamp =
            parse("a.ldt", changed(known[i].line, known[i].by), &err);
        CHECK(lamp == NULL);
        CHECK_TEXT(err.where, known[i].where);
        CHECK_MENTIONS(err.text, known[i].why);
        murk_luminaire_destroy(lamp);
    }
    /* A line more; a decimal comma is read. */
    murk_error err;
    CHECK(parse("a.ldt", changed(128, "1\n2"), &err) == NULL);
    CHECK_TEXT(err.where, "a.ldt:129");
    murk_luminaire *lamp = parse("a.ldt", changed(24, "1,5"), &err);
    CHECK_TEXT(err.text, "");
    CHECK_NEAR(lamp ? at(lamp, 0, 0) : 0, 300, 1e-12);
    murk_luminaire_destroy(lamp);
}

/* ---- warnings ---- */

static char warned[600];

static void note_warning(const char *where, const char *text)
{
    const size_t n = strlen(warned);
    snprintf(warned + n, sizeof warned - n, "%s: %s\n", where, text);
}

/* The file is read with one warning that has those words, or with none. */
static void check_warning(const char *path, const char *text, const char *words)
{
    murk_error err;
    warned[0] = '\0';
    murk_warn_to(note_warning);
    murk_luminaire *lamp = parse(path, text, &err);
    murk_warn_to(NULL);
    CHECK_TEXT(err.text, "");
    if (words) {
        CHECK_MENTIONS(warned, words);
        CHECK(strchr(warned, '\n') == strrchr(warned, '\n'));
    } else {
        CHECK_TEXT(warned, "");
    }
    murk_luminaire_destroy(lamp);
}

#define FULL_TURN "1 1 1 2 3 1 2 0 0 0\n1 1 1\n0 90\n0 180 360\n100 8\n100 9\n"

#define LAST_GAMMA 79 /* the line of the last gamma angle */
#define LAST_C     72 /* and of the last C angle */

/* The planes are one turn: the last one comes before 360 degrees. */
static void test_last_plane(void)
{
    murk_error err;
    murk_luminaire *lamp = parse("a.ldt", changed(LAST_C, "360"), &err);
    CHECK(lamp == NULL);
    CHECK_TEXT(err.where, "a.ldt:72");
    CHECK_MENTIONS(err.text, "must end below 360");
}

static void test_warnings(void)
{
    /* The planes at 0 and 360 degrees are one plane. */
    check_warning("a.ies", HEAD FULL_TURN "100 9.9\n", NULL);
    check_warning("a.ies", HEAD FULL_TURN "100 11\n",
                  "a.ies:11: the plane at 360 degrees differs from that at 0 "
                  "degrees by up to 3 %");
    /* Angles that stop early. */
    check_warning("a.ies", HEAD ROUND "0 45 85\n0\n3 2 1\n",
                  "a.ies: vertical angles 0..85");
    check_warning("a.ies", HEAD ROUND TABLE, NULL);
    check_warning("a.ldt", ldt(4, "1"), NULL);
    /* Luminous sides of different heights. */
    check_warning("a.ldt", changed(19, "50"),
                  "a.ldt:18: height of luminous area C0 is 0 mm, but size: "
                  "file takes the highest, 50 mm");
    check_warning("a.ldt", changed(18, "50"), "a.ldt:19: height of luminous");
    check_warning("a.ldt", changed(20, "50"), "a.ldt:18: height of luminous");
    check_warning("a.ldt", changed(21, "50"), "a.ldt:18: height of luminous");
    check_warning("a.ldt", changed(LAST_GAMMA, "175"),
                  "a.ldt: vertical angles 0..175");
    for (int type = 2; type <= 3; ++type) {
        static const struct {
            const char *angles, *words;
        } known[] = {
            {"-90 90\n0 90", NULL},
            {"-90 90\n-90 90", NULL},
            {"-30 90\n0 90", "a.ies: vertical angles -30..90"},
            {"-90 90\n0 45", "a.ies: horizontal angles -45..45"},
            {"-90 90\n-20 90", "a.ies: horizontal angles -20..90"},
        };
        for (size_t i = 0; i < sizeof known / sizeof *known; ++i) {
            char text[400];
            snprintf(text, sizeof text,
                     HEAD "1 1 1 2 2 %d 2 0 0 0\n1 1 1\n%s\n1 2\n3 4\n", type,
                     known[i].angles);
            check_warning("a.ies", text, known[i].words);
        }
    }
    /* Horizontal lamps, and vertical discs. */
    check_warning("a.ies",
                  "IESNA91\nTILT=INCLUDE\n1\n3\n0 30 90\n1 .9 .6\n" ROUND TABLE,
                  NULL);
    check_warning("a.ies", "IESNA91\nTILT=INCLUDE\n" TILT ROUND TABLE,
                  "a.ies:3: lamp-to-luminaire geometry 2");
    check_warning("a.ies", HEAD "1 1 1 3 1 1 2 -.4 0 -.4\n1 1 1\n" TABLE,
                  "a.ies:5: the luminous area is a vertical disc");
}

int main(void)
{
    murk_warn_to(NULL);
    test_versions_and_factors();
    test_absolute_photometry();
    test_symmetries_of_lm_63();
    test_types_a_and_b();
    test_apertures();
    test_tilt();
    test_refusals_of_lm_63();
    test_long_numbers();
    test_separators();
    test_symmetries_of_eulumdat();
    test_refusals_of_eulumdat();
    test_last_plane();
    test_warnings();
    return check_done();
}
