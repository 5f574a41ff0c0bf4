/* Mapping files, and files in the formats of AERONET and SeaBASS and CSV, that
 * are cut off, changed, or noise: whatever they are, they are read or refused
 * in one line, within bounded time and memory. Deterministic. usage:
 * test_mapping_input [FILES]   (mutated files of each kind; 1000) */
#define _DEFAULT_SOURCE /* mkdtemp */
#include "base/log.h"
#include "base/progress.h"
#include "broken.h"
#include "check.h"
#include "readings/readings.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

static const char SCENE[] =
    "murk: 1\n"
    "bands_nm: [440, 532]\n"
    "domain: {min_m: [0, 0, -100], max_m: [30, 20, 9000]}\n"
    "lights: [{type: point, position_m: [1, 1, 1], power_w: 1}]\n"
    "conditions: {dawn: {}, noon: {}}\n";

/* A file of measurements and the mapping that reads it. */
static const struct {
    const char *map, *data;
} GOOD[] = {
    {"murk_readings: 1\nfile: data\nmissing: [-1]\nselect: {q: [0, 3]}\n"
     "readings:\n"
     "  - {kind: transmittance, condition: {column: site}, x_m: 1, y_m: 2, "
     "z_m: 0, x2_m: 1, y2_m: 2, z2_m: {column: cm, factor: -0.01}, unit: "
     "percent, value: {column: v}, standard_error: {column: sd, relative: .1, "
     "at_least: 1}}\n"
     "  - {kind: extinction, x_m: 1, y_m: 1, z_m: 1, value: {column: v, "
     "offset: 1}, standard_error: 1, average: true}\n",
     "site,cm,v,sd,q\ndawn,50,80,2,1\nnoon,100,\"70\",,1\ndawn,200,NA,1,1\n"
     "noon,300,50,1,2\n"},
    {"murk_readings: 1\nfile: data\nformat: aeronet\nreadings: [{aod_nm: "
     "[440, 532], x_m: 1, y_m: 2, z_m: 10, z2_m: 8000, average: true}]\n",
     "AERONET\nLevel 1.5\nSite,Date(dd:mm:yyyy),AOD_440nm,AOD_532nm,AOD_E,"
     "AOD_E\nA,01:06:2000,0.12,-0.002,-999.,-999.\n"
     "A,02:06:2000,-999.,0.17,-999.,-999.\n"},
    {"murk_readings: 1\nfile: data\nformat: seabass\nreadings: [{kind: "
     "extinction, band_nm: 532, x_m: 1, y_m: 1, z_m: {column: depth, factor: "
     "-1, units: m}, value: {column: c532, units: 1/m}, standard_error: "
     "{column: sd}}]\n",
     "/begin_header\n! remark\n/missing=-999\n/fields=depth,c532,sd\n"
     "/units=m,1/m,1/m\n/delimiter=space\n/end_header\n1.5 0.21 0.01\n"
     "3  -999 0.01\n! remark\n4\t0.25 0.02\n"}};
#define KINDS (sizeof GOOD / sizeof *GOOD)

static char folder[] = "/tmp/murk-mapping-XXXXXX";
static char map_path[64], data_path[64];
static murk_scene_desc *scene;
static size_t read_well;

/* Reads the mapping that is written, with the file of measurements. */
static void try_files(void)
{
    murk_readings *m = NULL;
    murk_error err = {0};
    const murk_status status =
        murk_readings_read(&m, map_path, scene, &scene->domain, &err);
    if (status) {
        CHECK(m == NULL);
        CHECK(status == MURK_BAD_FILE || status == MURK_BAD_VALUE);
        broken_check_refusal(&err);
        return;
    }
    ++read_well;
    CHECK(m->rows > 0 && m->rows <= m->readings);
    for (size_t i = 0; i < m->readings; ++i) {
        CHECK(isfinite(m->reading[i].value) && m->reading[i].line > 0);
        CHECK(m->reading[i].standard_error > 0);
        CHECK(murk_box_contains(&scene->domain.box, m->reading[i].position));
    }
    murk_readings_destroy(m);
}

static void test_cut_off_anywhere(void)
{
    for (size_t k = 0; k < KINDS; ++k) {
        write_text(map_path, GOOD[k].map);
        for (size_t size = 0; size <= strlen(GOOD[k].data); ++size) {
            write_bytes(data_path, GOOD[k].data, size);
            try_files();
        }
        write_text(data_path, GOOD[k].data);
        for (size_t size = 0; size <= strlen(GOOD[k].map); ++size) {
            write_bytes(map_path, GOOD[k].map, size);
            try_files();
        }
    }
    CHECK(read_well >= 2 * KINDS);
}

/* Writes `good` with up to four bytes changed, mostly to bytes that mean
 * something. */
static void write_mutated(const char *path, const char *good, uint64_t i,
                          uint32_t seed)
{
    static const char meant[] = ",\n\"#0123456789-+.eE \t/!=:[]{}&*~naif_";
    char text[1000];
    const size_t size = strlen(good);
    memcpy(text, good, size);
    broken_replace(text, size, seed, i, i / 4 % 4, meant, sizeof meant - 1);
    write_bytes(path, text, size);
}

static void test_changed_bytes(uint64_t files)
{
    const size_t before = read_well;
    for (size_t k = 0; k < KINDS; ++k) {
        write_text(map_path, GOOD[k].map);
        for (uint64_t i = 0; i < files; ++i) {
            write_mutated(data_path, GOOD[k].data, i, 21);
            try_files();
        }
        write_text(data_path, GOOD[k].data);
        for (uint64_t i = 0; i < files; ++i) {
            write_mutated(map_path, GOOD[k].map, i, 22);
            try_files();
        }
    }
    /* Some changes are harmless, many are not. */
    CHECK(read_well - before > files / 10 && read_well - before < 5 * files);
}

/* Two million rows of one cell; one row, and one list of fields, without end.
 */
static void test_too_large(void)
{
    static const char head[] = "/begin_header\n/fields=a\n/end_header\n";
    const size_t size = 4000000;
    char *text = malloc(size);
    CHECK(text != NULL);
    const size_t before = read_well;
    for (size_t k = 0; k < KINDS; ++k) {
        const double start_s = murk_clock_s();
        write_text(map_path, GOOD[k].map);
        for (size_t i = 0; i < size; ++i) {
            text[i] = i % 2 ? '\n' : '1';
        }
        memcpy(text, head, sizeof head - 1);
        write_bytes(data_path, text, size);
        try_files();
        memset(text + sizeof head - 1, ' ', size - sizeof head + 1);
        write_bytes(data_path, text, size);
        try_files();
        memset(text + 23, ',', size - 23); /* fields */
        write_bytes(data_path, text, size);
        try_files();
        CHECK(murk_clock_s() - start_s < BROKEN_SLOWEST_S);
    }
    CHECK(read_well == before);
    free(text);
}

/* Averages over 120,000 rows: those of ten entries are read, in memory that
 * does not grow with the averaged rows; 100 entries are refused. First of all
 * tests, because the peak of memory is that of the process. */
static void test_many_averaged_rows(void)
{
    enum { ROWS = 120000, ENTRIES = 100 };
    static const char head[] = "murk_readings: 1\nfile: data\nreadings:\n",
                      entry[] = " - {kind: extinction, x_m: {column: a}, y_m: "
                                "1, z_m: 1, value: {column: b, factor: 1.1}, "
                                "standard_error: 1, average: true}\n";
    static char rows[4 + 4 * ROWS + 1];
    static char map[sizeof head + ENTRIES * sizeof entry];
    memcpy(rows, "a,b\n", 4);
    for (size_t i = 0; i < ROWS; ++i) {
        memcpy(rows + 4 + 4 * i, "1,2\n", 5);
    }
    write_text(data_path, rows);
    memcpy(map, head, sizeof head);
    for (size_t i = 0; i < ENTRIES; ++i) {
        memcpy(map + sizeof head - 1 + i * (sizeof entry - 1), entry,
               sizeof entry);
    }
    /* Ten entries, then all. */
    const size_t before = read_well;
    const long before_kb = broken_peak_kb();
    write_bytes(map_path, map, sizeof head - 1 + 10 * (sizeof entry - 1));
    try_files();
    CHECK(read_well - before == 1);
    CHECK(broken_peak_kb() - before_kb < 60000);
    write_text(map_path, map);
    try_files();
    CHECK(read_well - before == 1);
}

int main(int argc, char **argv)
{
    const uint64_t files = argc > 1 ? strtoull(argv[1], NULL, 10) : 1000;
    murk_error err = {0};
    murk_warn_to(NULL);
    CHECK(mkdtemp(folder) != NULL);
    snprintf(map_path, sizeof map_path, "%s/map.yaml", folder);
    snprintf(data_path, sizeof data_path, "%s/data", folder);
    CHECK(murk_scene_desc_parse(&scene, SCENE, "s.yaml", NULL, 0, &err) ==
          MURK_OK);
    if (scene) {
        test_many_averaged_rows();
        test_cut_off_anywhere();
        test_changed_bytes(files);
        test_too_large();
    }
    murk_scene_desc_destroy(scene);
    CHECK(broken_peak_kb() < BROKEN_MAX_KB);
    unlink(map_path);
    unlink(data_path);
    rmdir(folder);
    return check_done();
}
