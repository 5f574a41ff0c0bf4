/* Phase functions of the named fogs, clouds and hazes as tables.
 *
 * Presets compute theirs when they are read. These files are for scenes that
 * give `phase: {table: FILE}`, for other programs, and as a record: what the
 * presets' spheres scattered when the files were written. */
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "preset/droplets.h"
#include "preset/refraction.h"

#define DEGREE    0.017453292519943295
#define TOLERANCE 5e-4

/* One in the last digit printed, which a mathematics library may turn. */
#define DIGIT 2e-5

#define COLUMNS_MAX 16

static const char HELP[] =
    "usage: mie_tables --write MEDIA | --check MEDIA [--quick]\n"
    "       mie_tables --shape A,B,C --nm NM[,NM...]\n"
    "\n"
    "Writes the phase functions of the named fogs, clouds and hazes into the\n"
    "folder MEDIA, or checks that those in it are what would be written\n"
    "(--quick: the fastest two). Or prints the one of droplets whose number\n"
    "goes as r^A exp(-B r^C), r in um, at up to 16 wavelengths of 300..2500\n"
    "nm. Exit: 0 done, 1 a file is not what would be written, 2 bad usage.\n";

typedef struct product {
    const char *file;
    murk_droplets shape;
    bool is_quick;
} product;

static const product PRODUCTS[] = {
    {"haze/l-phase.csv", {2, 15.1186, .5}, true},
    {"fog/radiation-phase.csv", {6, 3, 1}, true},
    {"cloud/c1-phase.csv", {6, 1.5, 1}, false},
    {"fog/advection-phase.csv", {3, .375, 1}, false},
    {"fog/advection-heavy-phase.csv", {3, .3, 1}, false},
};
#define PRODUCTS_COUNT (sizeof PRODUCTS / sizeof *PRODUCTS)

static const double LINES_NM[] = {450, 550, 650, 850, 1064, 1550};
#define LINES_COUNT (sizeof LINES_NM / sizeof *LINES_NM)

typedef struct table {
    size_t angles, columns;
    double nm[COLUMNS_MAX];
    double angle_deg[MURK_DROPLET_ANGLES_MAX];
    double phase[COLUMNS_MAX][MURK_DROPLET_ANGLES_MAX];
} table;

static bool compute(table *out, const murk_droplets *shape)
{
    double mu[MURK_DROPLET_ANGLES_MAX];
    out->angles = murk_droplet_angles(out->angle_deg);
    for (size_t i = 0; i < out->angles; ++i) {
        mu[i] = cos(out->angle_deg[i] * DEGREE);
    }
    murk_error err = {0};
    murk_droplet_optics optics;
    for (size_t c = 0; c < out->columns; ++c) {
        if (murk_droplets_solve(&optics, shape, out->nm[c],
                                murk_water_refraction(out->nm[c]), TOLERANCE,
                                out->angles, mu, out->phase[c], &err)) {
            fprintf(stderr, "mie_tables: at %g nm: %s\n", out->nm[c], err.text);
            return false;
        }
    }
    return true;
}

static bool compute_product(table *out, const product *which)
{
    out->columns = LINES_COUNT;
    memcpy(out->nm, LINES_NM, sizeof LINES_NM);
    return compute(out, &which->shape);
}

static void print(FILE *file, const table *from, const murk_droplets *shape)
{
    fprintf(file,
            "# Phase function [1/sr] of water droplets of sizes r^%g "
            "exp(-%g r^%g), r in um, by Lorenz and Mie: written by "
            "mie_tables\nangle_deg",
            shape->a, shape->b, shape->c);
    for (size_t c = 0; c < from->columns; ++c) {
        fprintf(file, ",%g_nm", from->nm[c]);
    }
    fputc('\n', file);
    for (size_t i = 0; i < from->angles; ++i) {
        fprintf(file, "%.6g", from->angle_deg[i]);
        for (size_t c = 0; c < from->columns; ++c) {
            fprintf(file, ",%.5g", from->phase[c][i]);
        }
        fputc('\n', file);
    }
}

static FILE *open_product(const char *folder, const product *which,
                          const char *mode)
{
    char path[4096];
    const int length =
        snprintf(path, sizeof path, "%s/%s", folder, which->file);
    FILE *file =
        length > 0 && (size_t)length < sizeof path ? fopen(path, mode) : NULL;
    if (!file) {
        fprintf(stderr, "mie_tables: %s/%s: %s\n", folder, which->file,
                strerror(errno));
    }
    return file;
}

static int write_all(const char *folder)
{
    static table made;
    for (size_t i = 0; i < PRODUCTS_COUNT; ++i) {
        FILE *file = compute_product(&made, &PRODUCTS[i])
                         ? open_product(folder, &PRODUCTS[i], "w")
                         : NULL;
        if (!file) {
            return 1;
        }
        print(file, &made, &PRODUCTS[i].shape);
        const bool failed = ferror(file);
        if (fclose(file) || failed) {
            fprintf(stderr, "mie_tables: cannot write %s\n", PRODUCTS[i].file);
            return 1;
        }
    }
    return 0;
}

/* Texts alike but for the last digit of a number. */
static bool are_alike(const char *got, const char *want)
{
    while (*got && *want) {
        char *got_end, *want_end;
        const double a = strtod(got, &got_end), b = strtod(want, &want_end);
        if (got_end != got && want_end != want) {
            if (!(fabs(a - b) <= DIGIT * fabs(b))) {
                return false;
            }
            got = got_end;
            want = want_end;
        } else if (*got++ != *want++) {
            return false;
        }
    }
    return *got == *want;
}

static bool check_product(const char *folder, const product *which)
{
    static table made;
    enum { SIZE = 1 << 18 };
    static char got[SIZE], want[SIZE];
    FILE *file = open_product(folder, which, "r");
    if (!file) {
        return false;
    }
    got[fread(got, 1, SIZE - 1, file)] = '\0';
    fclose(file);
    file = compute_product(&made, which) ? tmpfile() : NULL;
    if (!file) {
        return false;
    }
    print(file, &made, &which->shape);
    rewind(file);
    want[fread(want, 1, SIZE - 1, file)] = '\0';
    fclose(file);
    if (!are_alike(got, want)) {
        fprintf(stderr,
                "mie_tables: %s/%s is not what would be written; write it "
                "again with --write\n",
                folder, which->file);
        return false;
    }
    return true;
}

static int check_all(const char *folder, bool is_quick)
{
    int checked = 0, off = 0;
    for (size_t i = 0; i < PRODUCTS_COUNT; ++i) {
        if (PRODUCTS[i].is_quick || !is_quick) {
            off += !check_product(folder, &PRODUCTS[i]);
            ++checked;
        }
    }
    printf("%d tables, %d off\n", checked, off);
    return off > 0 || checked == 0;
}

/* Up to `most` numbers, by commas; 0 where the text is anything else. */
static size_t read_numbers(const char *text, size_t max, double *out)
{
    size_t n = 0;
    for (const char *at = text;;) {
        char *end;
        if (n == max) {
            return 0;
        }
        out[n++] = strtod(at, &end);
        if (end == at || (*end != ',' && *end != '\0')) {
            return 0;
        }
        if (*end == '\0') {
            return n;
        }
        at = end + 1;
    }
}

static int print_one(const char *shape_text, const char *nm_text)
{
    static table made;
    murk_error err = {0};
    double abc[3];
    if (read_numbers(shape_text, 3, abc) != 3) {
        fprintf(stderr, "mie_tables: --shape: %s, must be A,B,C\n", shape_text);
        return 2;
    }
    const murk_droplets shape = {abc[0], abc[1], abc[2]};
    if (murk_droplets_check(&shape, "--shape", &err)) {
        fprintf(stderr, "mie_tables: %s: %s\n", err.where, err.text);
        return 2;
    }
    made.columns = read_numbers(nm_text, COLUMNS_MAX, made.nm);
    bool is_right = made.columns > 0;
    for (size_t i = 0; i < made.columns; ++i) {
        is_right = is_right && made.nm[i] >= MURK_REFRACTION_NM_MIN &&
                   made.nm[i] <= MURK_REFRACTION_NM_MAX;
    }
    if (!is_right) {
        fprintf(stderr,
                "mie_tables: --nm: %s, must be 1..%d wavelengths of %d..%d nm, "
                "by commas\n",
                nm_text, COLUMNS_MAX, MURK_REFRACTION_NM_MIN,
                MURK_REFRACTION_NM_MAX);
        return 2;
    }
    if (!compute(&made, &shape)) {
        return 1;
    }
    print(stdout, &made, &shape);
    return 0;
}

int main(int n, char **word)
{
    if (n == 2 && strcmp(word[1], "--help") == 0) {
        fputs(HELP, stdout);
        return 0;
    }
    if (n == 3 && strcmp(word[1], "--write") == 0) {
        return write_all(word[2]);
    }
    const bool is_quick = n == 4 && strcmp(word[3], "--quick") == 0;
    if ((n == 3 || is_quick) && strcmp(word[1], "--check") == 0) {
        return check_all(word[2], is_quick);
    }
    if (n == 5 && strcmp(word[1], "--shape") == 0 &&
        strcmp(word[3], "--nm") == 0) {
        return print_one(word[2], word[4]);
    }
    fputs(HELP, stderr);
    return 2;
}
