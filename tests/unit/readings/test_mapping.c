/* Mapping files and the files of measurements that they name: which readings
 * are made, what is left out, and one clear line for whatever is wrong, at the
 * line of the mapping or of the file. Deterministic. */
#define _DEFAULT_SOURCE /* mkdtemp */
#include "base/log.h"
#include "check.h"
#include "readings/readings.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

static const char *const SCENE =
    "murk: 1\n"
    "bands_nm: [380, 440, 532]\n"
    "domain: {min_m: [0, 0, -100], max_m: [30, 20, 9000]}\n"
    "lights: [{type: point, position_m: [1, 1, 1], power_w: 1}]\n"
    "conditions: {dawn: {}, noon: {}}\n";

static murk_scene_desc *scene;
static char folder[] = "/tmp/murk-mapping-XXXXXX";
static char map_path[64], data_path[64];
static char noted[500];

static void keep_note(const char *where, const char *text)
{
    (void)where;
    snprintf(noted, sizeof noted, "%s", text);
}

static murk_readings *read_both(const char *map, const char *data,
                                murk_error *err)
{
    murk_readings *m = NULL;
    write_text(map_path, map);
    write_text(data_path, data);
    *err = (murk_error){0};
    noted[0] = '\0';
    const murk_status status =
        murk_readings_read(&m, map_path, scene, &scene->domain, err);
    CHECK((status == MURK_OK) == (m != NULL));
    return m;
}

static murk_readings *read_well(const char *map, const char *data)
{
    murk_error err;
    murk_readings *m = read_both(map, data, &err);
    if (!m) {
        printf("%s: %s\n", err.where, err.text);
    }
    CHECK(m != NULL);
    return m;
}

/* `where`: the place without the folder. */
static void refused(const char *map, const char *data, const char *where,
                    const char *why)
{
    murk_error err;
    murk_readings *m = read_both(map, data, &err);
    CHECK(m == NULL);
    CHECK(strncmp(err.where, folder, strlen(folder)) == 0);
    if (strlen(err.where) > strlen(folder)) {
        CHECK_TEXT(err.where + strlen(folder) + 1, where);
    }
    CHECK_MENTIONS(err.text, why);
    CHECK(!strchr(err.text, '\n'));
    murk_readings_destroy(m);
}

#define MAP "murk_readings: 1\nfile: data\n"

/* ---- CSV ---- */

#define CASTS                      \
    "# remarks\n"                  \
    "site,depth_cm,percent,sd,q\n" \
    "dawn,50,80,2,1\n"             \
    "noon,100,70,,1\n"             \
    "dawn,200,NA,1,1\n"            \
    "dawn,400,40,-1,1.0\n"         \
    "noon,300,50,1,2\n"
#define CAST                                                              \
    "x_m: 1, y_m: 2, z_m: 0, x2_m: 1, y2_m: 2, z2_m: {column: depth_cm, " \
    "factor: -0.01, offset: -0.5}, kind: transmittance, unit: percent, "  \
    "condition: {column: site}"

static void test_columns_are_converted(void)
{
    murk_readings *m = read_well(
        MAP "missing: [-1]\nreadings:\n"
            "  - {" CAST ", value: {column: percent}, standard_error: "
            "{column: sd, relative: 0.1, at_least: 6}}\n"
            "  - {kind: extinction, x_m: 1, y_m: 2, z_m: 3, value: 0.25, "
            "standard_error: {relative: 0.5}, select: {q: [1.5, 3], site: "
            "noon}}\n",
        CASTS);
    if (!m) {
        return;
    }
    /* Of five rows, two have no error and one no value. */
    CHECK(m->rows == 3);
    CHECK_TEXT(noted, "3 readings are left out: a cell is missing, first in "
                      "line 4");
    const murk_reading *r = m->reading;
    CHECK(r[0].line == 3 && r[0].condition == 0 && r[0].value == 80);
    CHECK_NEAR(r[0].to.z, -1, 1e-15);
    CHECK_NEAR(r[0].standard_error, hypot(2, 8), 1e-15);
    CHECK(r[1].line == 7 && r[1].condition == 1);
    CHECK(r[1].standard_error == 6);
    CHECK(r[2].line == 7 && r[2].kind == MURK_READ_EXTINCTION);
    CHECK(r[2].value == .25 && r[2].standard_error == .125);
    CHECK(r[2].unit == MURK_UNIT_EXTINCTION_PER_M);
    CHECK_TEXT(m->path, data_path);
    murk_readings_destroy(m);
}

static void test_selections_compare_numbers(void)
{
    murk_readings *m =
        read_well(MAP "select: {q: 1}\nreadings: [{" CAST
                      ", value: {column: percent}, standard_error: 1}]\n",
                  CASTS);
    CHECK(m && m->rows == 3 && m->reading[2].line == 6);
    murk_readings_destroy(m);
}

static void test_averages_keep_the_stated_error(void)
{
    murk_readings *m = read_well(
        MAP "readings: [{kind: extinction, x_m: 1, y_m: 1, z_m: 1, value: "
            "{column: v}, standard_error: {column: e}, average: true}]\n",
        "v,e\n1,0.2\n2,0.2\n,0.2\n6,0.5\n");
    CHECK(m && m->rows == 1);
    if (m) {
        CHECK_NEAR(m->reading[0].value, 3, 1e-15);
        /* squared deviations 4 + 1 + 9, two degrees of freedom, three rows */
        CHECK_NEAR(m->reading[0].standard_error, hypot(.3, sqrt(14. / 6)),
                   1e-15);
        CHECK(m->reading[0].line == 2);
    }
    murk_readings_destroy(m);
    refused(MAP "readings: [{kind: extinction, x_m: {column: x}, y_m: 1, z_m: "
                "1, value: 1, standard_error: 1, average: true}]\n",
            "x\n1\n1\n2\n", "data:4: x_m",
            "2, but 1 in line 2, must be the same in all rows of an average");
    refused(MAP "readings: [{kind: extinction, x_m: {column: x, factor: 0.1}, "
                "y_m: {column: x, factor: 0.3}, z_m: 1, value: {column: x, "
                "offset: 1}, standard_error: 1, average: true}]\n",
            "x\n3\n3.0\n4\n", "data:4: x_m",
            "0.4, but 0.30000000000000004 in line 2, must be the same");
}

/* ---- AERONET ---- */

#define AERONET                                                    \
    "AERONET Data Download\n"                                      \
    "Level 1.5, a site, of no date\n"                              \
    "AERONET_Site,Date(dd:mm:yyyy),AOD_440nm,AOD_380nm,AOD_Empty," \
    "AOD_Empty\n"                                                  \
    "Nowhere,01:06:2000,0.120000,-0.002000,-999.000000,-999.\n"    \
    "Nowhere,02:06:2000,-999.000000,0.170000,-999.000000,-999.\n"  \
    "Nowhere,03:06:2000,0.100000,0.150000,-999.000000,-999.\n"
#define AEROSOL \
    MAP "format: aeronet\nreadings: [{x_m: 1, y_m: 2, z_m: 10, z2_m: 8000, "

static void test_aeronet(void)
{
    murk_readings *m = read_well(AEROSOL "aod_nm: [380, 440]}]\n", AERONET);
    if (!m) {
        return;
    }
    /* Row by row, and in each row by wavelength. */
    static const double value[] = {-.002, .12, .17, .15, .1};
    static const size_t line[] = {4, 4, 5, 6, 6};
    static const int band[] = {0, 1, 0, 0, 1};
    CHECK(m->rows == 5);
    CHECK_TEXT(noted, "5 readings in optical_depth: compared as -ln(T), T the "
                      "transmittance of a segment of L metres");
    for (size_t i = 0; i < m->rows && i < 5; ++i) {
        const murk_reading *r = &m->reading[i];
        CHECK(r->kind == MURK_READ_TRANSMITTANCE && r->band == band[i]);
        CHECK(r->unit == MURK_UNIT_OPTICAL_DEPTH && r->line == line[i]);
        CHECK(r->value == value[i]);
        CHECK(r->standard_error == (band[i] == 0 ? .02 : .01));
        CHECK(r->position.z == 10 && r->to.z == 8000);
        CHECK(r->to.x == 1 && r->to.y == 2);
    }
    murk_readings_destroy(m);
    m = read_well(AEROSOL "aod_nm: 440, standard_error: 0.015, select: "
                          "{\"Date(dd:mm:yyyy)\": \"03:06:2000\"}}]\n",
                  AERONET);
    CHECK(m && m->rows == 1 && m->reading[0].standard_error == .015);
    murk_readings_destroy(m);
}

static void test_aeronet_is_refused(void)
{
    refused(AEROSOL "aod_nm: [440]}]\n", "a,b\n1,2\n", "data",
            "no AERONET file: no row of names with a column Date");
    refused(AEROSOL "aod_nm: [440]}]\n", AERONET "Nowhere,04:06:2000,0.1\n",
            "data:7", "3 cells, must be 6");
    refused(AEROSOL "aod_nm: [440]}]\n",
            AERONET "Nowhere,04:06:2000,0.1x,0,0,0\n", "data:7: AOD_440nm",
            "0.1x, must be a number");
    refused(AEROSOL "aod_nm: [441]}]\n", AERONET, "map.yaml:4:59",
            "AOD_441nm is no column of");
    refused(AEROSOL "aod_nm: [440], unit: fraction}]\n", AERONET,
            "map.yaml:4:12", "aod_nm states kind, unit and value");
    refused(MAP "readings: [{aod_nm: [440]}]\n", AERONET, "map.yaml:3:13",
            "aod_nm is no key of a mapping here");
}

/* ---- SeaBASS ---- */

#define HEADER                          \
    "/begin_header\n"                   \
    "/investigators=Nobody\n"           \
    "! depth is positive down\n"        \
    "/missing=-999\n"                   \
    "/below_detection_limit=-888\n"     \
    "/fields=date,depth,c532,c532_sd\n" \
    "/units=yyyymmdd,m,1/m,1/m\n"
#define SEABASS                              \
    HEADER "/delimiter=space\n"              \
           "/end_header\n"                   \
           "20200101 1.5 0.21 0.01\n"        \
           "20200101   3  -999.0  0.01 \r\n" \
           "! a remark\n"                    \
           "20200102\t4 0.25\t0.02\n"        \
           "20200102 5 -888 0.02\n"
#define ATTENUATION                                                          \
    MAP "format: seabass\nreadings: [{kind: extinction, band_nm: 532, x_m: " \
        "1, "                                                                \
        "y_m: 1, z_m: {column: depth, factor: -1, units: m}, "               \
        "standard_error: {column: c532_sd}, value: {column: "

static void test_seabass(void)
{
    murk_readings *m = read_well(ATTENUATION "c532, units: 1/m}}]\n", SEABASS);
    if (!m) {
        return;
    }
    CHECK(m->rows == 2);
    CHECK_TEXT(noted, "2 readings are left out: a cell is missing, first in "
                      "line 11");
    CHECK(m->reading[0].line == 10 && m->reading[1].line == 13);
    CHECK(m->reading[1].position.z == -4 && m->reading[1].value == .25);
    CHECK(m->reading[1].standard_error == .02 && m->reading[1].band == 2);
    murk_readings_destroy(m);
    m = read_well(ATTENUATION "c532}}]\n", HEADER
                  "/delimiter=comma\n/end_header\n1, 2,.3 ,.1\n1,3,,.1\n");
    CHECK(m && m->rows == 1 && m->reading[0].value == .3);
    murk_readings_destroy(m);
    /* A byte order mark means nothing. */
    m = read_well(ATTENUATION "c532}}]\n", "\xEF\xBB\xBF" SEABASS);
    CHECK(m && m->rows == 2 && m->reading[0].line == 10);
    murk_readings_destroy(m);
}

static void test_seabass_is_refused(void)
{
    /* Units and columns, then headers and rows. */
    refused(ATTENUATION "c532, units: 1/cm}}]\n", SEABASS, "map.yaml:4:147",
            "units 1/cm, but line 7 of");
    refused(ATTENUATION "c531}}]\n", SEABASS, "map.yaml:4:147",
            "did you mean c532?");
    refused(ATTENUATION "c532}}]\n", "depth,c532\n1,2\n", "data:1",
            "no SeaBASS file: must begin with /begin_header");
    refused(ATTENUATION "c532}}]\n", HEADER, "data:7",
            "the file ends within its header");
    refused(ATTENUATION "c532}}]\n", HEADER "1 2 3 4\n", "data:8",
            "no line of a header");
    refused(ATTENUATION "c532}}]\n", HEADER "/end_header\n1 2 3\n", "data:9",
            "3 cells, must be 4");
    refused(ATTENUATION "c532}}]\n", HEADER "/delimiter=semicolon\n/end_header",
            "data", "must be comma, space or tab");
    refused(ATTENUATION "c532}}]\n", HEADER "/above_detection_limit=none\n",
            "data:8", "must be a number");
    refused(ATTENUATION "c532}}]\n", HEADER "/missing=1\n", "data:8",
            "/missing is there twice");
    refused(ATTENUATION "c532}}]\n", HEADER "/Fields=a,b,c,d\n", "data:8",
            "/fields is there twice");
    refused(ATTENUATION "c}}]\n", "/begin_header\n/fields=c,d,c\n/end_header\n",
            "data:2", "/fields has c twice");
    refused(ATTENUATION "c}}]\n", "/begin_header\n/fields=c,,d\n/end_header\n",
            "data:2", "/fields has an empty name");
    refused(ATTENUATION "c532}}]\n",
            "/begin_header\n/fields=a,b\n/units=m\n/end_header\n", "data:3",
            "as many items as /fields");
    refused(ATTENUATION "c532}}]\n", "/begin_header\n/end_header\n", "data:2",
            "without /fields");
}

/* ---- mappings ---- */

#define POINT "kind: extinction, x_m: 1, y_m: 1, z_m: 1, "

static void test_mappings_are_refused(void)
{
    /* What is wrong with the mapping, then with the file for it. */
    static const struct {
        const char *map, *where, *why;
    } bad[] = {
        {"file: data\n", "map.yaml", "must have murk_readings: 1"},
        {"murk: 1\nmedia: {}\n", "map.yaml", "must have murk_readings: 1"},
        {"murk_readings: 1\n", "map.yaml:1:1", "misses file"},
        {MAP, "map.yaml:1:1", "must have readings"},
        {MAP "readings: []\n", "map.yaml:3:11", "must have readings"},
        {MAP "formt: csv\n", "map.yaml:3:1", "did you mean format?"},
        {MAP "format: netcdf\n", "map.yaml:3:9",
         "netcdf, must be one of csv, aeronet, seabass"},
        {MAP "missing: -1\nreadings: [{}]\n", "map.yaml:3:10",
         "must be a list"},
        {MAP "readings: [{kind: extinction}]\n", "map.yaml:3:12",
         "misses value"},
        {MAP "readings: [{valeu: 1}]\n", "map.yaml:3:13",
         "did you mean value?"},
        {MAP "readings: [{kind: extinctoin}]\n", "map.yaml:3:19",
         "must be one of coverage, fluence"},
        {MAP "readings: [{" POINT "value: high}]\n", "map.yaml:3:62",
         "must be a number, or a map"},
        {MAP "readings: [{" POINT "value: {colum: v}}]\n", "map.yaml:3:63",
         "did you mean column?"},
        {MAP "readings: [{" POINT "value: {factor: 2}}]\n", "map.yaml:3:62",
         "must have a column"},
        {MAP "readings: [{unit: {column: v, factor: 2}}]\n", "map.yaml:3:19",
         "a text, which has no factor"},
        {MAP "readings: [{" POINT "standard_error: {relative: -1}}]\n",
         "map.yaml:3:82", "must be 0 or more"},
        {MAP "readings: [{" POINT "value: [1]}]\n", "map.yaml:3:62",
         "a list, must be a constant or a map"},
        {MAP "readings: [{select: {v: [2, 1]}}]\n", "map.yaml:3:25",
         "the least and the largest number"},
        {MAP "readings: [{average: maybe}]\n", "map.yaml:3:22",
         "must be true or false"},
        {MAP "select: {w: 1}\nreadings: [{" POINT
             "value: 1, standard_error: 1}]\n",
         "map.yaml:3:13", "w is no column of"},
        {MAP "readings: [{" POINT "value: {column: v, units: m}, "
             "standard_error: 1}]\n",
         "map.yaml:3:62", "units cannot be checked"},
        {MAP "readings: [{" POINT "value: {column: e}, standard_error: 1}]\n",
         "data", "the mapping makes no reading of its 2 rows, 2 are left out"},
        {MAP "readings: [{" POINT
             "value: {column: v, factor: 1e308}, standard_error: 1}]\n",
         "data:2: value", "must be a number"},
        {MAP "readings: [{" POINT "value: 1, standard_error: {column: v, "
             "factor: -1, at_least: 0.005}}]\n",
         "data:2: v", "20, a standard error must be 0 or more"},
        {MAP "readings: [{" POINT "value: 1, standard_error: {column: v, "
             "offset: -4, relative: 1}}]\n",
         "data:3: v", "3, a standard error must be 0 or more"},
        {MAP "readings: [{" POINT "value: {column: v}, standard_error: -1, "
             "average: true}]\n",
         "map.yaml:3:91", "-1, a standard error must be 0 or more"},
        {"murk_readings: 1\nfile: none\nreadings: [{" POINT
         "value: 1, standard_error: 1}]\n",
         "none", "cannot read"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        refused(bad[i].map, "v,e\n20,\n3,\n", bad[i].where, bad[i].why);
    }
}

int main(void)
{
    murk_error err = {0};
    CHECK(mkdtemp(folder) != NULL);
    snprintf(map_path, sizeof map_path, "%s/map.yaml", folder);
    snprintf(data_path, sizeof data_path, "%s/data", folder);
    (void)murk_warn_to(keep_note);
    CHECK(murk_scene_desc_parse(&scene, SCENE, "s.yaml", NULL, 0, &err) ==
          MURK_OK);
    if (scene) {
        test_columns_are_converted();
        test_selections_compare_numbers();
        test_averages_keep_the_stated_error();
        test_aeronet();
        test_aeronet_is_refused();
        test_seabass();
        test_seabass_is_refused();
        test_mappings_are_refused();
    }
    murk_scene_desc_destroy(scene);
    unlink(map_path);
    unlink(data_path);
    rmdir(folder);
    return check_done();
}
