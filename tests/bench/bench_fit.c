/* Case fit: calibrations of 200 rows as a whole: light traced, followed and
 * re-weighted until the search ends. Reference: as many bare traces of the same
 * photons through the same world, with nothing followed. fit-water is
 * irradiance by depth in three bands, six parameters, 1e5 photons; fit-mixed,
 * light and coverage of a foggy warehouse with four lamps of unknown power,
 * five parameters, 3,000 photons (40 places look at each of their records):
 * as many photons as the tests of the two scenes trace (planted.c), so that
 * all repeats end within a minute.
 * Two threads, time by the clock; figures for people on standard error. */
#include "base/log.h"
#include "base/machine.h"
#include "calibrate/histories.h"
#include "planted.h"
#include "times.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#define THREADS 2

#define WATER_PHOTONS 100000
#define MIXED_PHOTONS 3000

static void write_water(FILE *out)
{
    static const int bands_nm[] = {450, 530, 600};
    fprintf(out, "kind,x_m,y_m,z_m,direction_x,direction_y,direction_z,"
                 "radius_m,band_nm,unit,value,standard_error\n");
    for (int i = 0; i < 200; ++i) {
        const int depth = i / 6, band = i % 6 / 2;
        fprintf(out, "irradiance,1,1,%g,0,0,%d,0.8,%d,W/m2,1,1\n",
                -.9 - .5 * depth, i % 2 ? -1 : 1, bands_nm[band]);
    }
}

static void write_mixed(FILE *out)
{
    fprintf(out, "kind,x_m,y_m,z_m,radius_m,sensor,unit,value,"
                 "standard_error\n");
    for (int i = 0; i < 160; ++i) {
        static const double x_m[] = {2, 11, 19, 28};
        fprintf(out, "fluence,%g,%g,%g,0.9,,W/m2,1,1\n", x_m[i % 4],
                1.5 + .85 * (i / 4 % 20), i < 80 ? 2. : 5.);
    }
    for (int i = 0; i < 40; ++i) {
        static const double x_m[] = {2, 11, 19, 28};
        fprintf(out, "coverage,%g,%g,3,,node,fraction,1,1\n", x_m[i % 4],
                1. + 2 * (i / 4 % 10));
    }
}

/* Seconds of one bare trace; less than 0 after printing. */
static double trace_s(const planted_field *field, unsigned photons)
{
    const murk_histories_desc desc = {
        .stage = field->stage, .photons = photons, .threads = THREADS};
    murk_histories *followed = NULL;
    murk_error err = {0};
    if (murk_histories_trace(&followed, &desc, &err)) {
        fprintf(stderr, "%s: %s\n", err.where, err.text);
        return -1;
    }
    const double seconds = followed->trace_s;
    murk_histories_destroy(followed);
    return seconds;
}

/* Rows are as predicted, with errors of 2 %. */
static bool plant(planted_field *field)
{
    if (!planted_light(field, 2, field->of->emit, THREADS)) {
        return false;
    }
    for (size_t i = 0; i < field->measured->rows; ++i) {
        const size_t first = field->measured->row[i].first;
        field->measured->reading[first].standard_error = .02 * field->truth[i];
    }
    planted_read(field, 1);
    return true;
}

static bool fit(planted_field *field)
{
    murk_free_keys *keys = planted_keys(field, field->of->emit, 1);
    if (!keys) {
        return false;
    }
    const murk_calibration_desc desc = {.keys = keys,
                                        .measured = field->measured,
                                        .imported = &field->imported,
                                        .loss_width = 1,
                                        .starts = 1,
                                        .threads = THREADS,
                                        .seed = 1};
    murk_calibration found;
    murk_error err = {0};
    /* Time the fit and one bare trace of the same number of photons in turns.
     */
    bench_times ours = {0}, bare = {0};
    double bare_s = 0;
    murk_status status = MURK_OK;
    for (int i = 0; i < BENCH_REPEATS && !status && bare_s >= 0; ++i) {
        if (i > 0) {
            murk_calibration_release(&found);
        }
        bench_moment begun = bench_now();
        status = murk_calibrate(&found, &desc, &err);
        bench_add(&ours, i, begun);
        begun = bench_now();
        bare_s = status ? -1 : trace_s(field, field->of->emit);
        bench_add(&bare, i, begun);
    }
    /* The ratio is the share of tracing in a fit. */
    if (status) {
        fprintf(stderr, "%s: %s\n", err.where, err.text);
    } else if (bare_s > 0) {
        bench_print(&(bench_row){.name = field->of->name,
                                 .unit = "traces/s",
                                 .reference = "bare traces",
                                 .threads = THREADS,
                                 .work = (double)found.traces,
                                 .reference_work = 1,
                                 .ours = &ours,
                                 .theirs = &bare});
        fprintf(stderr,
                "%s: %zu rows, %zu keys, %llu photons: %zu traces in %.1f s, "
                "%zu evaluations; memory %.3g GB, of the fit %.3g foretold; "
                "%s\n",
                field->of->name, field->measured->rows, found.n,
                (unsigned long long)found.photons, found.traces, found.trace_s,
                found.evaluations, murk_machine_peak_bytes() / 1e9,
                murk_model_facts_of(found.model)->memory_bytes / 1e9,
                found.converged ? "converged" : "not converged");
    }
    murk_calibration_release(&found);
    murk_free_keys_destroy(keys);
    return bare_s > 0;
}

static bool bench(const planted_case *like, const char *name,
                  void (*write_rows)(FILE *), unsigned emit)
{
    char path[] = "/tmp/murk_bench_fit_XXXXXX";
    const int fd = mkstemp(path);
    FILE *out = fd < 0 ? NULL : fdopen(fd, "w");
    if (!out) {
        fprintf(stderr, "cannot write %s\n", path);
        return false;
    }
    write_rows(out);
    fclose(out);
    planted_case of = *like;
    of.name = name;
    of.data = path;
    of.emit = emit;
    planted_field field;
    const bool is_well =
        planted_open(&field, &of) && plant(&field) && fit(&field);
    planted_close(&field);
    unlink(path);
    return is_well;
}

int main(void)
{
    planted_case warehouse = planted_coverage;
    static const char *const lamps[] = {"lights.0.power_w", "lights.1.power_w",
                                        "lights.2.power_w", "lights.3.power_w"};
    for (size_t i = 0; i < 4; ++i) {
        warehouse.key[i + 1] = lamps[i];
        warehouse.truth[i + 1] = 40 + 5 * (double)i;
    }
    warehouse.n = 5;
    (void)murk_warn_to(NULL);
    const bool is_well =
        bench(&planted_water, "fit-water", write_water, WATER_PHOTONS) &&
        bench(&warehouse, "fit-mixed", write_mixed, MIXED_PHOTONS);
    return is_well ? 0 : 1;
}
