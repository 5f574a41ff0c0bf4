/* Readings of a CSV file: what each kind has, what makes a row, and one clear
 * line with the file's line for whatever is wrong. Deterministic. */
#include "base/log.h"
#include "check.h"
#include "readings/readings.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

static const char *const SCENE =
    "murk: 1\n"
    "bands_nm: [450, 532, 850]\n"
    "domain: {min_m: [0, 0, 0], max_m: [30, 20, 10]}\n"
    "lights: [{type: point, position_m: [1, 1, 1], power_w: 1}]\n"
    "sensors:\n"
    "  types:\n"
    "    - {name: node, range_m: 12}\n"
    "    - {name: cam, range_m: 30, view: {cone_deg: 60}, headings: 4,"
    " tilts_deg: [0]}\n"
    "conditions: {dawn: {}, noon: {}}\n";

static murk_scene_desc *scene;
static char path[] = "/tmp/murk-readings-XXXXXX";
static char noted[1000];

static void keep_note(const char *where, const char *text)
{
    const size_t used = strlen(noted);
    (void)where;
    snprintf(noted + used, sizeof noted - used, "%s\n", text);
}

static murk_status read_bytes(murk_readings **out, const char *text,
                              size_t size, murk_error *err)
{
    write_bytes(path, text, size);
    *err = (murk_error){0};
    noted[0] = '\0';
    return murk_readings_read(out, path, scene, &scene->domain, err);
}

static murk_readings *read_text(const char *text)
{
    murk_readings *m = NULL;
    murk_error err;
    if (read_bytes(&m, text, strlen(text), &err)) {
        printf("%s: %s\n", err.where, err.text);
    }
    CHECK(m != NULL);
    return m;
}

/* `place`: what stands behind the file's name. */
static void refused(const char *text, const char *place, const char *why)
{
    murk_readings *m = NULL;
    murk_error err;
    const murk_status status = read_bytes(&m, text, strlen(text), &err);
    CHECK(status == MURK_BAD_VALUE || status == MURK_BAD_FILE);
    CHECK(m == NULL);
    CHECK(strncmp(err.where, path, strlen(path)) == 0);
    if (strlen(err.where) >= strlen(path)) {
        CHECK_TEXT(err.where + strlen(path), place);
    }
    CHECK_MENTIONS(err.text, why);
    CHECK(!strchr(err.text, '\n'));
}

/* ---- what is read ---- */

static void test_each_kind_is_read(void)
{
    /* A file with a reading of each kind, a comment and an empty line. */
    murk_readings *m = read_text(
        "# by hand\n"
        "use,standard_error,value,unit,kind,x_m,y_m,z_m,x2_m,y2_m,z2_m,"
        "direction_x,direction_y,direction_z,radius_m,acceptance_deg,band_nm,"
        "sensor,heading_deg,tilt_deg,group,gain,condition\n"
        "fit,.02,.4,,coverage,1,2,3,,,,,,,,,,cam,90,-30,A,,dawn\n"
        "\n"
        "hold_out,2,50,lux,fluence,4,5,6,,,,,,,.5,,532,,,,,,\n"
        ",.1,1.5,W/m2,irradiance,4,5,6,,,,0,0,-2,.5,60,,,,,,,noon\n"
        ",3,87,transmission_percent_per_m,transmittance,1,1,1,1,1,4,,,,,1,,,,,,"
        ",\n"
        ",5,40,percent,fluence,4,5,6,,,,,,,.5,,,,,,,probe,\n");
    const murk_reading *r = m->reading;
    CHECK(m->readings == 5 && m->rows == 5 && m->held_out == 1);
    CHECK(strlen(m->sha256) == 64);

    /* Coverage, with the pose of the sensor. */
    CHECK(r[0].kind == MURK_READ_COVERAGE && r[0].line == 3);
    CHECK(r[0].condition == 0 && r[0].pose.type == 1);
    CHECK(r[0].pose.position.x == 1 && r[0].pose.position.z == 3);
    CHECK_NEAR(r[0].pose.heading_rad, MURK_PI / 2, 1e-15);
    CHECK_NEAR(r[0].pose.tilt_rad, -MURK_PI / 6, 1e-15);
    CHECK(r[0].unit == MURK_UNIT_FRACTION && r[0].value == .4);
    CHECK(r[0].standard_error == .02 && r[0].gain == SIZE_MAX);
    CHECK_TEXT(m->group[0], "A");

    /* Fluence, held out, in one band. */
    CHECK(r[1].kind == MURK_READ_FLUENCE && r[1].line == 5);
    CHECK(r[1].is_held_out && !r[0].is_held_out && !r[2].is_held_out);
    CHECK(r[1].band == 1 && r[1].radius_m == .5);
    CHECK(r[1].condition == SIZE_MAX && r[1].unit == MURK_UNIT_LUX);
    CHECK(isnan(r[1].acceptance_rad));

    /* Irradiance, with the direction at unit length. */
    CHECK(r[2].kind == MURK_READ_IRRADIANCE && r[2].condition == 1);
    CHECK(r[2].direction.z == -1 && r[2].direction.x == 0);
    CHECK_NEAR(r[2].acceptance_rad, MURK_PI / 3, 1e-15);
    CHECK(r[2].band == -1 && r[2].unit == MURK_UNIT_W_PER_M2);

    /* Transmittance in the unit of transmissometers, and a reading with a
     * gain. */
    CHECK(r[3].kind == MURK_READ_TRANSMITTANCE && r[3].to.z == 4);
    CHECK(r[3].unit == MURK_UNIT_TRANSMISSION_PERCENT_PER_M);
    CHECK(r[4].gain == 0 && m->gains == 1);
    CHECK_TEXT(m->gain[0], "probe");
    murk_readings_destroy(m);
}

/* Lines of a group may stand apart. Rows are in the order of their first
 * lines, and another condition is another reading of the same plan. */
static void test_a_group_of_coverage_is_one_row(void)
{
    /* Lines of two groups in turn, without a group, and of another
     * condition. */
    murk_readings *m =
        read_text("kind,x_m,y_m,z_m,sensor,group,condition,value,"
                  "standard_error\n"
                  "coverage,1,1,1,node,B,,.5,.1\n"
                  "coverage,2,1,1,node,A,,.6,.1\n"
                  "coverage,3,1,1,node,B,,.5,.1\n"
                  "coverage,4,1,1,node,,,.7,.1\n"
                  "coverage,5,1,1,node,,,.7,.1\n"
                  "coverage,6,1,1,node,B,dawn,.3,.1\n"
                  "coverage,7,1,1,node,A,,.6,.1\n");
    /* Readings are sorted by row. */
    static const size_t want_first[] = {0, 2, 4, 5, 6},
                        want_n[] = {2, 2, 1, 1, 1};
    static const double want_x[] = {1, 3, 2, 7, 4, 5, 6};
    CHECK(m->rows == 5 && m->readings == 7);
    for (size_t i = 0; i < 5 && m->rows == 5; ++i) {
        CHECK(m->row[i].first == want_first[i] && m->row[i].n == want_n[i]);
    }
    for (size_t i = 0; i < 7; ++i) {
        CHECK(m->reading[i].position.x == want_x[i]);
    }
    /* Groups are named in the order of rows. */
    CHECK_TEXT(m->group[0], "B");
    CHECK_TEXT(m->group[1], "A");
    CHECK_TEXT(m->group[2], "");
    murk_readings_destroy(m);
}

#define BEAM \
    "kind,x_m,y_m,z_m,x2_m,y2_m,z2_m,unit,value,standard_error,gain,group\n"
#define AT "transmittance,1,1,1,1,1,3,"

static void test_derived_units_are_logged_once(void)
{
    murk_readings *m =
        read_text(BEAM AT "visibility_m,50,1,,\n" AT "visibility_m,60,1,,\n" AT
                          "db_per_km,9,1,,\n" AT ",.5,.1,,\n");
    CHECK_TEXT(noted,
               "1 reading in db_per_km: compared as -10 log10(T) / L, L in km, "
               "T the transmittance of a segment of L metres\n"
               "2 readings in visibility_m: compared as 3.912 L / -ln(T), T "
               "the transmittance of a segment of L metres\n");
    murk_readings_destroy(m);
}

/* ---- units ---- */

static void check_unit(murk_reading_unit unit, double t, double length_m,
                       double want)
{
    double slope, unused;
    const double got = murk_reading_in_unit(unit, t, length_m, &slope);
    const double h = 1e-5 * t;
    const double low = murk_reading_in_unit(unit, t - h, length_m, &unused);
    const double high = murk_reading_in_unit(unit, t + h, length_m, &unused);
    CHECK_NEAR(got, want, 1e-12 * fabs(want));
    /* the third derivative's share, h^2 / t^2, times a few, and rounding */
    CHECK_NEAR(slope * t, (high - low) / (2 * h) * t, 1e-8 * fabs(want));
}

static void test_units_compare_with_a_transmittance(void)
{
    const double t = exp(-.6); /* .2 per m over 3 m */
    check_unit(MURK_UNIT_FRACTION, t, 3, t);
    check_unit(MURK_UNIT_PERCENT, t, 3, 100 * t);
    check_unit(MURK_UNIT_EXTINCTION_PER_M, t, 3, .2);
    check_unit(MURK_UNIT_VISIBILITY_M, t, 3, 3.912 / .2);
    check_unit(MURK_UNIT_MOR_M, t, 3, 2.996 / .2);
    check_unit(MURK_UNIT_TRANSMISSION_PERCENT_PER_M, t, 3, 100 * exp(-.2));
    check_unit(MURK_UNIT_OBSCURATION_PERCENT_PER_M, t, 3, 100 * (1 - exp(-.2)));
    check_unit(MURK_UNIT_OBSCURATION_PERCENT, t, 3, 100 * (1 - t));
    check_unit(MURK_UNIT_OPTICAL_DEPTH, t, 3, .6);
    /* 10 dB a decade: 200 /km * 4.342944819 */
    check_unit(MURK_UNIT_DB_PER_KM, t, 3, 868.5889638065036);
}

/* The same units of an extinction of .2 per m, which is .6 over 3 m. */
static void test_units_of_an_extinction(void)
{
    double unused;
    /* Units with a law, but those of a whole segment. */
    for (int u = 0; u < MURK_READING_UNITS; ++u) {
        const murk_reading_unit unit = (murk_reading_unit)u;
        murk_reading_unit found;
        murk_error err = {0};
        const murk_status status =
            murk_reading_unit_find(&found, murk_reading_unit_name(unit),
                                   MURK_READ_EXTINCTION, "here", &err);
        const bool is_total = unit == MURK_UNIT_OBSCURATION_PERCENT ||
                              unit == MURK_UNIT_OPTICAL_DEPTH;
        CHECK((status == MURK_OK) ==
              (murk_reading_unit_law(unit) != NULL && !is_total));
        if (!status) {
            const double want =
                murk_reading_in_unit(unit, exp(-.6), 3, &unused);
            CHECK_NEAR(murk_reading_of_extinction(unit, .2), want,
                       1e-12 * want);
            CHECK(isfinite(murk_reading_of_extinction(unit, 0)));
        }
    }
    murk_reading_unit usual = MURK_UNIT_FRACTION;
    CHECK(murk_reading_unit_find(&usual, "", MURK_READ_EXTINCTION, "here",
                                 NULL) == MURK_OK);
    CHECK(usual == MURK_UNIT_EXTINCTION_PER_M);
}

static void test_units_are_finite_everywhere(void)
{
    static const double ends[] = {-.1, 0, 5e-324, 1e-200, 1, 1.5};
    for (int u = 0; u < MURK_READING_UNITS; ++u) {
        for (size_t i = 0; i < sizeof ends / sizeof *ends; ++i) {
            double slope;
            const double v = murk_reading_in_unit((murk_reading_unit)u, ends[i],
                                                  .01, &slope);
            CHECK(isfinite(v) && isfinite(slope));
        }
    }
}

static void test_light_counts_by_band(void)
{
    const murk_spectrum w = murk_reading_per_watt(MURK_UNIT_W_PER_M2, scene);
    const murk_spectrum lux = murk_reading_per_watt(MURK_UNIT_LUX, scene);
    const murk_spectrum quanta =
        murk_reading_per_watt(MURK_UNIT_PHOTONS, scene);
    const murk_spectrum par = murk_reading_per_watt(MURK_UNIT_PAR, scene);
    CHECK(w.band[0] == 1 && w.band[2] == 1);
    CHECK(lux.band[1] > 500 && lux.band[2] == 0); /* 683 at its best */
    CHECK_NEAR(quanta.band[1], 532e-9 / 1.98644586e-25, 1e12);
    CHECK_NEAR(par.band[1], quanta.band[1] / 6.02214076e17, 1e-6);
    CHECK(par.band[2] == 0);
}

/* ---- what is refused ---- */

static void test_columns_are_refused(void)
{
    refused("", "", "empty");
    refused("kind,x_m,value,standard_eror\n", ":1",
            "column standard_eror is none of a reading's, did you mean "
            "standard_error?");
    refused("# a\nkind,x_m,value,standard_error,colour\n", ":2",
            "column colour is none of a reading's");
    refused("time,LT_Fwd,LT_Mid\n0,100,100\n", ":1",
            "no table of readings: must have columns kind, value");
    refused("kind,x_m,value\n", ":1", "misses column standard_error");
    refused("kind,kind,value\n", ":1", "twice");
    refused("kind,x_m,y_m,z_m,value,standard_error\n", "",
            "0 readings, must be 1..100000");
    refused("{\"murk\": {\"version\": 1}, \"chi2\": 3}\n", ":1", "");
    refused(BEAM AT ",.5,.1,\n", ":2", "11 cells, must be 12");
}

static void test_other_files_are_refused(void)
{
    murk_readings *m = NULL;
    murk_error err;
    char noise[1000];
    for (size_t i = 0; i < sizeof noise; ++i) {
        noise[i] = (char)(i * 7919 + i * i);
    }
    CHECK(read_bytes(&m, noise, sizeof noise, &err) != MURK_OK);
    CHECK(murk_readings_read(&m, "/tmp", scene, &scene->domain, &err) !=
          MURK_OK);
    CHECK(murk_readings_read(&m, "/nowhere/x.csv", scene, &scene->domain,
                             &err) != MURK_OK);
    CHECK(m == NULL);
    char *many = malloc(3000000);
    size_t used = (size_t)sprintf(many, "kind,value,standard_error\n");
    for (int i = 0; i <= MURK_READINGS_MAX; ++i) {
        used += (size_t)sprintf(many + used, "coverage,.5,.1\n");
    }
    refused(many, "", "100001 readings, must be 1..100000");
    free(many);
}

static void test_numbers_are_refused(void)
{
    refused(BEAM AT ",nan,.1,,\n", ":2: value", "nan, must be a number");
    refused(BEAM AT ",,.1,,\n", ":2: value", "needs it");
    refused(BEAM AT ",.5,0,,\n", ":2: standard_error", "more than 0");
    refused(BEAM AT ",.5,-1,,\n", ":2: standard_error", "more than 0");
    refused(BEAM AT ",.5,,,\n", ":2: standard_error", "needs it");
    refused(BEAM AT ",.5,inf,,\n", ":2: standard_error", "a number");
    refused(BEAM AT ",.5,1e-300,,\n", ":2: standard_error", "1e-30");
    refused(BEAM AT "lux,5,1,,\n", ":2: unit", "lux is no unit of such");
    refused(BEAM AT "percent_per_m,5,1,,\n", ":2: unit",
            "ambiguous, must be transmission_percent_per_m (100 is clear) or "
            "obscuration_percent_per_m (0 is clear)");
    refused(BEAM AT "visiblity_m,5,1,,\n", ":2: unit",
            "did you mean visibility_m?");
    refused(BEAM AT "furlongs,5,1,,\n", ":2: unit", "must be one of fraction");
    refused(BEAM AT "visibility_m,-5,1,,\n", ":2: value", "more than 0 m");
    refused(BEAM AT ",87,1,,\n", ":2: value", "87 as a fraction, must be 0..1");
    refused(BEAM AT "visibility_m,50,1,a,\n", ":2: gain",
            "a free factor of what is in visibility_m");
    refused(BEAM AT ",.5,.1,a b,\n", ":2: gain", "letters, digits");
}

static void test_places_are_refused(void)
{
    /* Segments that leave the domain, have no length or no end, and
     * misspelt kinds. */
    refused(BEAM "transmittance,1,1,11,1,1,3,,.5,.1,,\n", ":2: x_m",
            "[1, 1, 11] m is outside the domain, [0, 0, 0] to [30, 20, 10] m");
    refused(BEAM "transmittance,1,1,1,1,1,-3,,.5,.1,,\n", ":2: x2_m",
            "outside the domain");
    refused(BEAM "transmittance,1,1,1,1,1,1,,.5,.1,,\n", ":2: x2_m",
            "the place itself");
    refused(BEAM "transmittance,1,1,1,1,,3,,.5,.1,,\n", ":2: y2_m", "needs it");
    refused(BEAM "transmitance,1,1,1,1,1,3,,.5,.1,,\n", ":2: kind",
            "did you mean transmittance?");
    refused(BEAM "beam,1,1,1,1,1,3,,.5,.1,,\n", ":2: kind",
            "beam, must be one of coverage, fluence, irradiance");
#define LIGHT                                                        \
    "kind,x_m,y_m,z_m,direction_x,direction_y,direction_z,radius_m," \
    "acceptance_deg,band_nm,unit,value,standard_error\n"
    /* Receivers without a valid radius, or with a direction that the kind does
     * not take. */
    refused(LIGHT "fluence,1,1,1,,,,,,,lux,1,1\n", ":2: radius_m", "needs it");
    refused(LIGHT "fluence,1,1,1,,,,0,,,lux,1,1\n", ":2: radius_m",
            "more than 0 m");
    refused(LIGHT "fluence,1,1,1,,,,2,,,lux,1,1\n", ":2: radius_m",
            "outside the domain");
    refused(LIGHT "fluence,1,1,1,0,0,1,.1,,,lux,1,1\n", ":2: direction_x",
            "a reading of fluence has none");
    refused(LIGHT "irradiance,1,1,1,0,0,0,.1,,,lux,1,1\n", ":2: direction_x",
            "no length");
    refused(LIGHT "irradiance,1,1,1,0,,0,.1,,,lux,1,1\n", ":2: direction_y",
            "needs it");
    /* Bad angles, bands and units. */
    refused(LIGHT "irradiance,1,1,1,0,0,1,.1,91,,lux,1,1\n",
            ":2: acceptance_deg", "at most 90 degrees");
    refused(LIGHT "fluence,1,1,1,,,,.1,,533,lux,1,1\n", ":2: band_nm",
            "533 nm is in no band of the scene, did you mean 532?");
    refused(LIGHT "fluence,1,1,1,,,,.1,,850,lux,1,1\n", ":2: unit",
            "light of this band counts nothing");
    refused(LIGHT "fluence,1,1,1,,,,.1,,,,1,1\n", ":2: unit", "needs it");
    refused(LIGHT "fluence,1,1,1,,,,.1,,,relative,1,1\n", ":2: gain",
            "make gain.NAME a free key");
}

#define COVER                                                             \
    "kind,x_m,y_m,z_m,sensor,heading_deg,tilt_deg,group,condition,value," \
    "standard_error,use\n"

static void test_sensors_and_groups_are_refused(void)
{
    /* Unknown sensors, and poses that are incomplete or out of limits. */
    refused(COVER "coverage,1,1,1,nod,,,A,,.5,.1,\n", ":2: sensor",
            "did you mean node?");
    refused(COVER "coverage,1,1,1,,,,A,,.5,.1,\n", ":2: sensor",
            "nothing, must be one of node, cam");
    refused(COVER "coverage,1,1,1,cam,,0,A,,.5,.1,\n", ":2: heading_deg",
            "needs it");
    refused(COVER "coverage,1,1,1,cam,10,95,A,,.5,.1,\n", ":2: tilt_deg",
            "-90..90 degrees");
    /* Unknown conditions and uses. */
    refused(COVER "coverage,1,1,1,node,,,A,dusk,.5,.1,\n", ":2: condition",
            "dusk, must be one of dawn, noon");
    refused(COVER "coverage,1,1,1,node,,,A,dwan,.5,.1,\n", ":2: condition",
            "did you mean dawn?");
    refused(COVER "coverage,1,1,1,node,,,A,,.5,.1,never\n", ":2: use",
            "must be one of fit, hold_out");
    /* Lines of one group that differ in value, use or unit, and names that
     * are too long. */
    refused(COVER "coverage,1,1,1,node,,,A,,.5,.1,\n"
                  "coverage,2,1,1,node,,,A,,.6,.1,\n",
            ":3: value", "differs from line 2 of this group");
    refused(COVER "coverage,1,1,1,node,,,A,,.5,.1,fit\n"
                  "coverage,2,1,1,node,,,A,,.5,.1,hold_out\n",
            ":3: use", "differs from line 2");
    refused(BEAM AT "db_per_km,5,1,,A\n" AT "extinction_per_m,5,1,,A\n",
            ":3: unit",
            "extinction_per_m, but line 2 of this group is in db_per_km");
    refused(BEAM AT ",.5,.1,k,\n" AT "percent,50,10,k,\n", ":3: unit",
            "percent, but line 2 of factor k is in fraction");
    refused(BEAM AT ",.5,.1,,aaaaaaaaaabbbbbbbbbbccccccccccddddddddddeeeeeeeeee"
                    "ffffffffffgggg\n",
            ":2: group", "63 bytes");
}

int main(void)
{
    /* The scene that the measurements belong to, and a file for their text. */
    murk_error err = {0};
    if (murk_scene_desc_parse(&scene, SCENE, "s.yaml", NULL, 0, &err)) {
        printf("%s: %s\n", err.where, err.text);
        return 1;
    }
    const int handle = mkstemp(path);
    CHECK(handle >= 0);
    close(handle);
    murk_warn_to(keep_note);
    /* Kinds, groups and units. */
    test_each_kind_is_read();
    test_a_group_of_coverage_is_one_row();
    test_derived_units_are_logged_once();
    test_units_compare_with_a_transmittance();
    test_units_of_an_extinction();
    test_units_are_finite_everywhere();
    test_light_counts_by_band();
    /* Refused files. */
    test_columns_are_refused();
    test_other_files_are_refused();
    test_numbers_are_refused();
    test_places_are_refused();
    test_sensors_and_groups_are_refused();
    unlink(path);
    murk_scene_desc_destroy(scene);
    return check_done();
}
