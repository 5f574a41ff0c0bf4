/* Files of studies: what a range comes to on each of its scales, how rows are
 * numbered, and what is refused at the edges of what is allowed, to the letter.
 * Nothing here is random. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "scene_files.h"

#include "scene/study_file.h"

#define HEAD "murk_study: 1\nbase: fog.yaml\n"

static murk_status study_of(murk_study_file **out, const char *text,
                            murk_error *err)
{
    *out = NULL;
    *err = (murk_error){0};
    write_text("study.yaml", text);
    return murk_study_file_read(out, "study.yaml", err);
}

/* ---- ranges ---- */

typedef struct range_case {
    const char *range, *values; /* as rows show them, a space between two */
} range_case;

static const range_case RANGES[] = {
    {"{from: 2, to: 7, steps: 1}", "2"},
    {"{from: 2, to: 7, steps: 2}", "2 7"},
    {"{from: 0.1, to: 0.7, steps: 3}", "0.1 0.4 0.7"},
    {"{from: 0, to: 0.3, steps: 4}", "0 0.1 0.2 0.3"},
    {"{from: 7, to: -5, steps: 4}", "7 3 -1 -5"},
    {"{from: 4, to: 4, steps: 3}", "4 4 4"},
    {"{from: 1, to: 1000, steps: 4, spacing: log}", "1 10 100 1000"},
    {"{from: 8, to: 2, steps: 3, spacing: log}", "8 4 2"},
    {"{from: 1, to: 3, steps: 3, spacing: linear}", "1 2 3"},
    {"{from: 2026-02-27, to: 2026-03-02, steps: 4}",
     "2026-02-27 2026-02-28 2026-03-01 2026-03-02"},
    {"{from: 2026-12-30, to: 2027-01-02, steps: 3}",
     "2026-12-30 2027-01-01 2027-01-02"},
    {"{from: \"05:00\", to: \"06:00\", steps: 3}",
     "05:00:00 05:30:00 06:00:00"},
    {"{from: \"00:00\", to: \"00:01\", steps: 4}",
     "00:00:00 00:00:20 00:00:40 00:01:00"},
    {"{from: \"2026-06-21T23:00:00+02:00\", to: \"2026-06-22T01:00:00+02:00\", "
     "steps: 3}",
     "2026-06-21T23:00:00+02:00 2026-06-22T00:00:00+02:00 "
     "2026-06-22T01:00:00+02:00"},
};

static void test_ranges(void)
{
    for (size_t k = 0; k < sizeof RANGES / sizeof *RANGES; ++k) {
        char text[500], values[500] = "";
        murk_study_file *study;
        murk_error err;
        snprintf(text, sizeof text, HEAD "axes: {seed: %s}\n", RANGES[k].range);
        CHECK(study_of(&study, text, &err) == MURK_OK);
        CHECK_TEXT(err.text, "");
        if (!study) {
            continue;
        }
        for (size_t i = 0, at = 0; i < study->axis[0].n; ++i) {
            at += (size_t)snprintf(values + at, sizeof values - at, "%s%s",
                                   i ? " " : "", study->axis[0].text[i]);
            CHECK_TEXT(study->axis[0].value[i]->text, study->axis[0].text[i]);
        }
        CHECK_TEXT(values, RANGES[k].values);
        CHECK(study->rows == study->axis[0].n);
        murk_study_file_destroy(study);
    }
}

/* ---- refusals ---- */

typedef struct refusal {
    const char *study; /* behind the head, from line 3 on; NULL: all is well */
    const char *where, *text;
} refusal;

#define RANGE_END                                                            \
    "must be a number, a time with the zone (2026-06-21T00:00:00+02:00), a " \
    "date or a time of day"

static const refusal REFUSALS[] = {
    {"axes: {seed: {from: 1, to: 2, steps: 0}}\n",
     "study.yaml:3:38: axes.seed.steps", "0, must be 1..10000"},
    {"axes: {seed: {from: 1, to: 2, steps: 10001}}\n",
     "study.yaml:3:38: axes.seed.steps", "10001, must be 1..10000"},
    {"axes: {seed: {from: 1, to: 2, steps: 1.5}}\n",
     "study.yaml:3:38: axes.seed.steps",
     "1.5, must be a whole number, 1..10000"},
    {"axes: {seed: {from: 1, to: 2}}\n", "study.yaml:3:8: axes.seed",
     "misses steps, must be a whole number, 1..10000"},
    {"axes: {seed: {from: 1, to: 2, steps: 3, stop: 4}}\n",
     "study.yaml:3:41: axes.seed.stop",
     "unknown key, must be one of from, to, steps, spacing"},
    {"axes: {seed: {by: 1, from: 1, to: 2, steps: 3}}\n",
     "study.yaml:3:15: axes.seed.by",
     "unknown key, must be one of from, to, steps, spacing"},
    {"axes: {seed: {from: 1, steps: 3}}\n", "study.yaml:3:8: axes.seed",
     "misses to, " RANGE_END},
    {"axes: {seed: {to: 1, steps: 3}}\n", "study.yaml:3:8: axes.seed",
     "misses from, " RANGE_END},
    {"axes: {seed: {from: 1, to: dusk, steps: 3}}\n",
     "study.yaml:3:28: axes.seed.to", "dusk, " RANGE_END},
    {"axes: {seed: {from: [1], to: 2, steps: 3}}\n",
     "study.yaml:3:15: axes.seed.from", "a list, " RANGE_END},
    {"axes: {seed: {from: 1, to: 2026-06-21, steps: 3}}\n",
     "study.yaml:3:8: axes.seed",
     "from and to, must be two numbers, two times with their zone, two dates "
     "or two times of day"},
    {"axes: {seed: {from: 1, to: 2, steps: 3, spacing: even}}\n",
     "study.yaml:3:50: axes.seed.spacing", "even, must be linear, log"},
    {"axes: {seed: {from: 1, to: 0, steps: 3, spacing: log}}\n",
     "study.yaml:3:8: axes.seed",
     "spacing: log, from and to must be numbers above 0"},
    {"axes: {seed: {from: 0, to: 1, steps: 3, spacing: log}}\n",
     "study.yaml:3:8: axes.seed",
     "spacing: log, from and to must be numbers above 0"},
    {"axes: {seed: {from: 2026-01-01, to: 2026-01-02, steps: 3, spacing: "
     "log}}\n",
     "study.yaml:3:8: axes.seed",
     "spacing: log, from and to must be numbers above 0"},
    {"axes: {seed: []}\n", "study.yaml:3:8: axes.seed",
     "0 values, must be 1..10000"},
    {"axes: {\"\": [1]}\n", "study.yaml:3:8: axes.", "an axis without a name"},
    {"axes: {a: {x: 1}}\n", "study.yaml:3:15: axes.a",
     "1, must be a map of keys and values, or from, to and steps"},
    {"axes: {a: {x: {seed: 1}, y: [1]}}\n", "study.yaml:3:26: axes.a",
     "a list, must be a map of keys and values, or from, to and steps"},
    {"axes: {a: {}}\n", "study.yaml:3:8: axes.a",
     "an empty map, must be a list of values, {from, to, steps}, {hours_of: "
     "FILE}, or names with "
     "their "
     "keys"},
    {"axes: {\"a\\u007f\": [1]}\n", "study.yaml:3:8: axes.a\\x7f",
     "a name with control characters"},
    {"axes: {condition: [dry, [wet]]}\n", "study.yaml:3:25: axes.condition",
     "must be the name of a condition"},
    {"axes: {seed: [1], photons.emit: [1], seed.x: [2]}\n",
     "study.yaml:3:38: axes.seed.x",
     "sets seed.x, and axis seed sets seed: a key belongs to one axis"},
    {"axes: {a: {x: {}, y: {seed: 1, bands_nm: [1]}}, bands_nm.0: [1]}\n",
     "study.yaml:3:49: axes.bands_nm.0",
     "sets bands_nm.0, and axis a sets bands_nm: a key belongs to one axis"},
    {"axes: {a: {x: {seed: 1, media.b: 2, media.b.c: 3}}}\n",
     "study.yaml:3:8: axes.a",
     "x sets media.b and media.b.c, of which one lies within the other"},
    {"axes: {date: [2026-01-01], site.date: [2026-01-02]}\n",
     "study.yaml:3:28: axes.site.date",
     "sets site.date, and axis date sets site.date: a key belongs to one axis"},
    {"mode: paired\naxes: {a.x: [1, 2], a.y: [1, 2], a.z: [1]}\n",
     "study.yaml:4:34: axes.a.z",
     "1 values, must be as many as axis a.x has, 2 (mode: paired)"},
    {"axes: {a: {from: 1, to: 2, steps: 101}, b: {from: 1, to: 2, steps: "
     "100}}\n",
     "study.yaml:3:1: axes", "10100 rows, must be at most 10000"},
    {"axes: {a: [1], b: [1], c: [1], d: [1], e: [1], f: [1], g: [1], h: [1], "
     "i: [1], j: [1], k: [1], l: [1], m: [1], n: [1], o: [1], p: [1], q: "
     "[1]}\n",
     "study.yaml:3:1: axes", "17 axes, must be at most 16"},
    {"axes: {}\nfluence_size: [1, 1, 0]\n", "study.yaml:4:22: fluence_size.2",
     "0, must be 1..4096"},
    {"axes: {}\nfluence_size: [1, 4097, 1]\n",
     "study.yaml:4:19: fluence_size.1", "4097, must be 1..4096"},
    {"axes: {}\nfluence_size: [1, 1]\n", "study.yaml:4:1: fluence_size",
     "a list, must be [nx, ny, nz], each a whole number, 1..4096"},
    {"axes: {}\nfluence_size: [1291, 1291, 1291]\n",
     "study.yaml:4:1: fluence_size",
     "[1291, 1291, 1291], must be at most 2^31 cells"},
    {"axes: {}\noutputs: []\n", "study.yaml:4:1: outputs",
     "an empty list, must be a list of 1..128 names"},
    {"axes: {}\noutputs: [a, b, a]\n", "study.yaml:4:17: outputs",
     "a stands there twice"},
    {"axes: {}\noutputs: [a, '']\n", "study.yaml:4:14: outputs",
     "\"\", must be the name of an output"},
    {"axes: {}\nunits: watts\n", "study.yaml:4:8: units",
     "watts, must be radiometric, photometric, photons, par"},
    {"axes: {}\nplan: ''\n", "study.yaml:4:7: plan",
     "\"\", must be the name of a file"},
    {"axes: {}\nunit: par\n", "study.yaml:4:1: unit",
     "unknown key, did you mean units?"},
    {"axes: {}\nsomething_else: par\n", "study.yaml:4:1: something_else",
     "unknown key, must be one of murk_study, base, plan, mode, axes, outputs, "
     "units, fluence_size"},
};

static void test_refusals(void)
{
    for (size_t k = 0; k < sizeof REFUSALS / sizeof *REFUSALS; ++k) {
        char text[1000];
        murk_study_file *study;
        murk_error err;
        snprintf(text, sizeof text, HEAD "%s", REFUSALS[k].study);
        CHECK(study_of(&study, text, &err) == MURK_BAD_VALUE);
        CHECK(study == NULL);
        CHECK_TEXT(err.where, REFUSALS[k].where);
        CHECK_TEXT(err.text, REFUSALS[k].text);
        murk_study_file_destroy(study);
    }
}

static void test_versions(void)
{
    static const char *const texts[] = {
        "murk_study: 2\nbase: a.yaml\naxes: {}\n",
        "murk_study: 0\nbase: a.yaml\naxes: {}\n",
        "murk_study: one\nbase: a.yaml\naxes: {}\n",
        "base: a.yaml\naxes: {}\n"};
    static const char *const wrong[] = {
        "2, must be 1", "0, must be 1", "one, must be a whole number, 1",
        "misses murk_study, must be a whole number, 1"};
    for (size_t k = 0; k < sizeof texts / sizeof *texts; ++k) {
        murk_study_file *study;
        murk_error err;
        CHECK(study_of(&study, texts[k], &err) == MURK_BAD_VALUE);
        CHECK_TEXT(err.text, wrong[k]);
        murk_study_file_destroy(study);
    }
}

/* ---- at the limits ---- */

static void test_largest(void)
{
    /* Most axes, rows and cells. */
    murk_study_file *study;
    murk_error err;
    CHECK(study_of(&study,
                   HEAD "axes: {a: [1], b: [1], c: [1], d: [1], e: [1], "
                        "f: [1], g: [1], h: [1], i: [1], j: [1], k: [1], "
                        "l: [1], m: [1], n: [1], o: [1], "
                        "p: {from: 1, to: 2, steps: 10000}}\n"
                        "fluence_size: [4096, 4096, 128]\n",
                   &err) == MURK_OK);
    CHECK(study && study->axes == 16 && study->rows == 10000);
    CHECK(study && study->fluence_size[0] == 4096 &&
          study->fluence_size[1] == 4096 && study->fluence_size[2] == 128);
    murk_study_file_destroy(study);

    /* Most outputs: 128 are read, and one more is refused. */
    char text[1000] = HEAD "axes: {}\noutputs: [o0";
    for (int i = 1; i < 128; ++i) {
        snprintf(text + strlen(text), sizeof text - strlen(text), ", o%d", i);
    }
    const size_t end = strlen(text);
    snprintf(text + end, sizeof text - end, "]\n");
    CHECK(study_of(&study, text, &err) == MURK_OK);
    CHECK(study && study->outputs == 128 && study->rows == 1);
    if (study) {
        CHECK_TEXT(study->output[127], "o127");
    }
    murk_study_file_destroy(study);
    snprintf(text + end, sizeof text - end, ", o128]\n");
    CHECK(study_of(&study, text, &err) == MURK_BAD_VALUE);
    CHECK_TEXT(err.text, "a list, must be a list of 1..128 names");
    murk_study_file_destroy(study);
}

/* The last axis varies fastest; paired axes go together. */
static void test_rows(void)
{
    murk_study_file *study;
    murk_error err;
    size_t index[3];
    CHECK(study_of(&study, HEAD "axes: {a: [1, 2], b: [1], c: [1, 2, 3]}\n",
                   &err) == MURK_OK);
    CHECK(study && study->rows == 6);
    for (size_t row = 0; study && row < 6; ++row) {
        murk_study_row_indices(study, row, index);
        CHECK(index[0] == row / 3 && index[1] == 0 && index[2] == row % 3);
    }
    murk_study_file_destroy(study);
    CHECK(study_of(&study, HEAD "mode: paired\naxes: {a: [1, 2], b: [3, 4]}\n",
                   &err) == MURK_OK);
    CHECK(study && study->rows == 2);
    for (size_t row = 0; study && row < 2; ++row) {
        murk_study_row_indices(study, row, index);
        CHECK(index[0] == row && index[1] == row);
    }
    murk_study_file_destroy(study);
}

int main(void)
{
    static const char *const files[] = {"study.yaml", NULL};
    CHECK(folder_enter());
    test_ranges();
    test_refusals();
    test_versions();
    test_largest();
    test_rows();
    folder_leave(files);
    return check_done();
}
