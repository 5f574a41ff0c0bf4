/* Reads EULUMDAT files (.ldt). Each field has a line of its own, so the number
 * of a line tells the field; the last fields are the C angles, the gamma angles
 * and the intensities [cd/klm] of the planes that the symmetry leaves. Every
 * number is checked, and nothing but empty lines may follow, so that a lost or
 * a doubled line is found. */
#include "luminaire/table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "luminaire/text.h"

/* Ranges of numbers: what lies beyond is a mistake. */
#define PLANES_MAX 721.0
#define GAMMAS_MAX 1801.0
#define SETS_MAX   20.0
#define LUMENS_MAX 1e9
#define LENGTH_MAX 1e7 /* mm */

#define GAMMAS_LINE 6     /* has the number of gamma angles */
#define RATIOS      10    /* direct ratios, which only indoor planning needs */
#define PERCENT     100.0 /* of one */
#define MM          1e-3  /* metres */

typedef struct ldt {
    murk_luminaire_text text;
    murk_luminaire *out;
    size_t symmetry; /* 0..4 */
    size_t planes;   /* C angles that the file lists */
    size_t gammas;
    double light_output_ratio, conversion;
    double lumens, watts; /* of all sets of lamps */
    double *c_deg;        /* [planes] */
    size_t *c_line;       /* [planes] lines of these angles */
    murk_luminaire_table table;
} ldt;

static murk_status skip(ldt *f, const char *what)
{
    size_t line;
    return murk_luminaire_text_line(&f->text, &line)
               ? MURK_OK
               : murk_luminaire_text_fail(&f->text, f->text.line,
                                          "%s: the file ends, must be a line",
                                          what);
}

static murk_status number(ldt *f, const char *what, double min, double max,
                          double *out)
{
    return murk_luminaire_text_field(&f->text, what, false, min, max, out);
}

/* A number that murk does not use; the line may be empty. */
static murk_status check(ldt *f, const char *what)
{
    double unused;
    return murk_luminaire_text_field(&f->text, what, true, -1e9, 1e9, &unused);
}

static murk_status count(ldt *f, const char *what, double min, double max,
                         size_t *out)
{
    double value = 0;
    const size_t line = f->text.line;
    const murk_status status = number(f, what, min, max, &value);
    if (status) {
        return status;
    }
    *out = (size_t)value;
    return value == floor(value)
               ? MURK_OK
               : murk_luminaire_text_fail(&f->text, line,
                                          "%s: %.10g, must be a whole number",
                                          what, value);
}

/* ---- the luminaire ---- */

/* Reads the names: report, luminaire, number, file, date. */
static murk_status read_names(ldt *f)
{
    size_t line;
    murk_status status = skip(f, "report number");
    const char *name =
        status ? NULL : murk_luminaire_text_line(&f->text, &line);
    if (name) {
        murk_luminaire_text_copy(f->out->name, sizeof f->out->name, name);
    } else if (!status) {
        status = murk_luminaire_text_fail(&f->text, f->text.line,
                                          "luminaire name: the file ends, must "
                                          "be a line");
    }
    if (!status) {
        status = skip(f, "luminaire number");
    }
    if (!status) {
        status = skip(f, "file name");
    }
    return status ? status : skip(f, "date");
}

/* Reads the sizes [mm]: of the housing, then of the luminous area, whose width
 * is 0 for a disc. Length runs along C90-C270, width along C0-C180. */
static murk_status read_sizes(ldt *f)
{
    static const char *const names[] = {
        "length of luminaire",         "width of luminaire",
        "height of luminaire",         "length of luminous area",
        "width of luminous area",      "height of luminous area C0",
        "height of luminous area C90", "height of luminous area C180",
        "height of luminous area C270"};
    enum { SIZES = sizeof names / sizeof *names, FIRST_HEIGHT = 5 };
    double size[SIZES];
    murk_status status = MURK_OK;
    for (size_t i = 0; i < SIZES && !status; ++i) {
        status = murk_luminaire_text_field(&f->text, names[i], i > 4, 0,
                                           LENGTH_MAX, &size[i]);
    }
    if (status) {
        return status;
    }
    /* The shape of the luminous area. */
    const double length = size[3] * MM, width = size[4] * MM;
    murk_luminaire *out = f->out;
    const double height = fmax(fmax(size[5], size[6]), fmax(size[7], size[8]));
    out->height_m = height * MM;
    out->aperture = length <= 0 && width <= 0 ? MURK_APERTURE_POINT
                    : width > 0               ? MURK_APERTURE_RECT
                                              : MURK_APERTURE_DISC;
    out->along_c0_m = width > 0 ? width : length;
    out->along_c90_m = width > 0 ? length : 0;
    /* The first side that is lower than the highest. */
    size_t side = FIRST_HEIGHT;
    while (side < SIZES && size[side] >= height) {
        ++side;
    }
    if (side < SIZES) {
        murk_luminaire_text_warn(&f->text, f->text.line - (SIZES - side),
                                 "%s is %g mm, but size: file takes the "
                                 "highest, %g mm, for all sides",
                                 names[side], size[side], height);
    }
    return MURK_OK;
}

/* Reads the sets of lamps. A negative number of lamps means absolute
 * photometry: the flux of the set is then that of the luminaire. */
static murk_status read_lamps(ldt *f)
{
    size_t sets;
    murk_status s = count(f, "number of sets of lamps", 1, SETS_MAX, &sets);
    for (size_t i = 0; i < sets && !s; ++i) {
        double lamps, lumens, watts;
        if ((s = number(f, "number of lamps", -1e6, 1e6, &lamps)) ||
            (s = skip(f, "type of lamps")) ||
            (s = number(f, "flux of the lamps", 0, LUMENS_MAX, &lumens)) ||
            (s = skip(f, "colour of the lamps")) ||
            (s = skip(f, "colour rendering of the lamps")) ||
            (s = murk_luminaire_text_field(&f->text, "watts of the lamps", true,
                                           0, MURK_LUMINAIRE_WATTS_MAX,
                                           &watts))) {
            return s;
        }
        /* All sets together. */
        f->lumens += lumens;
        f->watts += watts;
    }
    if (!s && !(f->lumens > 0)) {
        s = murk_luminaire_text_fail(&f->text, f->text.line - 1,
                                     "flux of the lamps: 0 lm, must be above "
                                     "0 lm");
    }
    return s;
}

static murk_status read_head(ldt *f)
{
    size_t type;
    murk_status s;
    if ((s = skip(f, "company")) || (s = count(f, "type", 0, 3, &type)) ||
        (s = count(f, "symmetry", 0, 4, &f->symmetry)) ||
        (s = count(f, "number of C planes", 1, PLANES_MAX, &f->planes)) ||
        (s = check(f, "distance of C planes")) ||
        (s = count(f, "number of gamma angles", 2, GAMMAS_MAX, &f->gammas)) ||
        (s = check(f, "distance of gamma angles")) || (s = read_names(f)) ||
        (s = read_sizes(f)) || (s = check(f, "downward flux fraction")) ||
        (s = number(f, "light output ratio", 0, 1e6, &f->light_output_ratio)) ||
        (s = number(f, "conversion factor", MURK_LUMINAIRE_FACTOR_MIN,
                    MURK_LUMINAIRE_FACTOR_MAX, &f->conversion)) ||
        (s = check(f, "tilt during measurement"))) {
        return s;
    }
    s = read_lamps(f);
    for (int i = 0; i < RATIOS && !s; ++i) {
        s = check(f, "direct ratio");
    }
    return s;
}

/* ---- the table ---- */

/* Reads the C angles, all of them, whatever the symmetry. */
static murk_status read_c_angles(ldt *f)
{
    f->c_deg = calloc(f->planes, sizeof *f->c_deg);
    f->c_line = calloc(f->planes, sizeof *f->c_line);
    if (!f->c_deg || !f->c_line) {
        return murk_no_memory(f->text.err, f->text.path, "for C angles");
    }
    murk_status status = MURK_OK;
    for (size_t i = 0; i < f->planes && !status; ++i) {
        f->c_line[i] = f->text.line;
        status = number(f, "C angle", 0, 360, &f->c_deg[i]);
        if (!status) {
            status = murk_luminaire_text_rising(&f->text, f->c_line[i],
                                                "C angle", f->c_deg, i);
        }
    }
    /* The whole turn begins at 0 and ends before 360. */
    if (!status && f->c_deg[0] != 0) {
        status = murk_luminaire_text_fail(&f->text, f->c_line[0],
                                          "C angle: %.10g, must begin at 0",
                                          f->c_deg[0]);
    }
    if (!status && f->c_deg[f->planes - 1] >= 360) {
        status = murk_luminaire_text_fail(
            &f->text, f->c_line[f->planes - 1],
            "C angle: 360, must end below 360, which is 0 again");
    }
    return status;
}

/* Finds the planes that the file has intensities of: `first` and their number,
 * counted on beyond the last C angle. */
static murk_status find_planes(ldt *f, size_t *first, size_t *n)
{
    /* For each symmetry: quarters of the planes from the first to the last
     * one. */
    static const struct {
        murk_luminaire_symmetry kind;
        size_t from, quarters;
    } rule[] = {{MURK_SYMMETRY_NONE, 0, 4},
                {MURK_SYMMETRY_AXIAL, 0, 0},
                {MURK_SYMMETRY_0_180, 0, 2},
                {MURK_SYMMETRY_90_270, 3, 2},
                {MURK_SYMMETRY_QUADRANT, 0, 1}};
    const size_t from = rule[f->symmetry].from,
                 quarters = rule[f->symmetry].quarters;
    f->out->symmetry = rule[f->symmetry].kind;
    *first = from * f->planes / 4;
    *n = quarters == 4 ? f->planes : quarters * f->planes / 4 + 1;
    /* The last plane of a part of the turn must be where the part ends. */
    const size_t last = *first + *n - 1;
    const size_t ends[] = {*first, last % f->planes};
    const double wanted[] = {90.0 * (double)from,
                             90.0 * (double)((from + quarters) % 4)};
    for (int i = 0; i < 2 && quarters > 0 && quarters < 4; ++i) {
        if (f->c_deg[ends[i]] != wanted[i]) {
            return murk_luminaire_text_fail(
                &f->text, f->c_line[ends[i]],
                "C angle: %.10g, must be %g by symmetry %zu with %zu planes",
                f->c_deg[ends[i]], wanted[i], f->symmetry, f->planes);
        }
    }
    if (quarters == 4 && f->planes < 2) {
        return murk_luminaire_text_fail(
            &f->text, f->c_line[0],
            "1 C plane, must be 2 or more without symmetry");
    }
    return MURK_OK;
}

/* The angle of a plane, so that the planes rise: those before C0 are
 * negative. */
static double angle_of(const ldt *f, size_t first, size_t i)
{
    const double deg = f->c_deg[(first + i) % f->planes];
    return first > 0 && first + i < f->planes ? deg - 360 : deg;
}

static murk_status read_table(ldt *f)
{
    size_t first = 0, n = 0;
    murk_status status = read_c_angles(f);
    if (!status) {
        status = find_planes(f, &first, &n);
    }
    if (status) {
        return status;
    }
    /* Without symmetry the first plane closes the turn. */
    const bool is_closed = f->out->symmetry == MURK_SYMMETRY_NONE;
    murk_luminaire_table *t = &f->table;
    status = murk_luminaire_table_create(t, f->gammas, n + is_closed, &f->text,
                                         GAMMAS_LINE);
    for (size_t i = 0; i < n && !status; ++i) {
        t->plane_deg[i] = angle_of(f, first, i);
    }
    for (size_t i = 0; i < f->gammas && !status; ++i) {
        const size_t line = f->text.line;
        status = number(f, "gamma angle", 0, 180, &t->vertical_deg[i]);
        if (!status) {
            status = murk_luminaire_text_rising(&f->text, line, "gamma angle",
                                                t->vertical_deg, i);
        }
    }
    for (size_t i = 0; i < n * f->gammas && !status; ++i) {
        status = number(f, "intensity", 0, MURK_LUMINAIRE_CANDELA_MAX,
                        &t->candela[i]);
    }
    if (!status && is_closed) {
        t->plane_deg[n] = 360;
        memcpy(t->candela + n * f->gammas, t->candela,
               f->gammas * sizeof *t->candela);
    }
    return status ? status : murk_luminaire_text_end(&f->text);
}

murk_status murk_luminaire_read_eulumdat(murk_luminaire *out, const char *path,
                                         char *text, size_t size,
                                         murk_error *err)
{
    ldt f = {.out = out};
    murk_status status =
        murk_luminaire_text_begin(&f.text, path, text, size, err);
    if (!status) {
        status = read_head(&f);
    }
    if (!status) {
        status = read_table(&f);
    }
    /* The factors of the table: cd/klm times klm. */
    if (!status) {
        snprintf(out->format, sizeof out->format, "EULUMDAT");
        out->type = MURK_GONIOMETER_C;
        out->verticals = f.gammas;
        out->horizontals = f.planes;
        out->lamp_lumens = f.lumens;
        out->declared_lumens = f.lumens * f.light_output_ratio / PERCENT;
        out->input_w = f.watts;
        status = murk_luminaire_unfold(
            out, &f.table, f.lumens / 1000 * f.conversion, path, err);
    }
    free(f.c_deg);
    free(f.c_line);
    murk_luminaire_table_release(&f.table);
    return status;
}
