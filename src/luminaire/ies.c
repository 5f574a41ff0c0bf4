/* Reads IES LM-63 files.
 *
 * Lines of labels (1986) or keywords come first, then a line TILT=, then
 * numbers between blanks, commas and line ends: TILT data if they are included;
 * 13 numbers on lamps, table and opening; the vertical angles, the horizontal
 * angles, and for each horizontal angle the intensities at all vertical angles.
 * Every number is checked, and nothing may follow the last one, so that a lost
 * or a doubled number is found. */
#include "luminaire/table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/file.h"
#include "base/memory_files.h"
#include "base/words.h"
#include "luminaire/photometric_file.h"
#include "luminaire/text.h"

#define FOOT_M 0.3048 /* exactly */

/* Ranges of numbers: what lies beyond is a mistake. */
#define ANGLES_MAX 100000.0
#define LENGTH_MAX 1e4
#define LAMPS_MAX  1e6

/* Planes at 0 and 360 degrees that differ by less, relative to the largest
 * intensity, are one plane that was measured or rounded twice. */
#define SEAM_MAX 0.02

/* The first lines of the versions, and the year of each. A file with none of
 * them is of 1986. */
typedef struct version {
    const char *line;
    int year;
} version;

static const version VERSIONS[] = {
    {"IESNA86", 1986},          {"IESNA:LM-63-1986", 1986},
    {"IESNA91", 1991},          {"IESNA:LM-63-1991", 1991},
    {"IESNA:LM-63-1995", 1995}, {"IESNA:LM-63-2002", 2002},
    {"IES:LM-63-2019", 2019},   {"IESNA:LM-63-2019", 2019},
};

typedef struct ies {
    murk_luminaire_text text;
    murk_luminaire *out;
    int year;
    char tilt[256]; /* the text behind TILT= */
    size_t tilt_line;
    double scale;
    murk_luminaire_table table;
} ies;

/* ---- the lines up to TILT= ---- */

/* Recognises the version by the first line, and steps back if the line is a
 * label of 1986. */
static murk_status read_version(ies *f)
{
    /* The first line without the blanks at the end. */
    const murk_luminaire_text begin = f->text;
    const size_t length = strcspn(f->text.next, "\r\n");
    char line[64], shown[40];
    size_t number;
    f->year = 1986;
    snprintf(line, sizeof line, "%.*s",
             (int)(length < sizeof line ? length : sizeof line - 1),
             f->text.next);
    for (size_t n = strlen(line); n > 0 && strchr(" \t", line[n - 1]); --n) {
        line[n - 1] = '\0';
    }
    if (strncasecmp(line, "IES:", 4) != 0 &&
        strncasecmp(line, "IESNA", 5) != 0) {
        f->text = begin;
        return MURK_OK;
    }
    murk_luminaire_text_line(&f->text, &number);
    for (size_t i = 0; i < sizeof VERSIONS / sizeof *VERSIONS; ++i) {
        if (strcasecmp(line, VERSIONS[i].line) == 0) {
            f->year = VERSIONS[i].year;
            return MURK_OK;
        }
    }
    murk_words_show(shown, sizeof shown, line);
    return murk_luminaire_text_fail(
        &f->text, number,
        "%s, must be IESNA91, IESNA:LM-63-1995, IESNA:LM-63-2002 or "
        "IES:LM-63-2019",
        shown);
}

/* Takes the name of the luminaire from a line: the first of the keywords
 * LUMINAIRE and LUMCAT, in 1986 the first label. */
static void take_name(ies *f, const char *line)
{
    static const char *const keys[] = {"[LUMINAIRE]", "[LUMCAT]"};
    const char *name = f->year == 1986 && line[0] != '[' ? line : NULL;
    for (size_t i = 0; i < sizeof keys / sizeof *keys && !name; ++i) {
        if (strncasecmp(line, keys[i], strlen(keys[i])) == 0) {
            name = line + strlen(keys[i]);
            name += strspn(name, " \t");
        }
    }
    if (name && f->out->name[0] == '\0') {
        murk_luminaire_text_copy(f->out->name, sizeof f->out->name, name);
    }
}

static murk_status read_header(ies *f)
{
    char *line;
    size_t number = f->text.line;
    while ((line = murk_luminaire_text_line(&f->text, &number))) {
        if (strncasecmp(line, "TILT=", 5) == 0) {
            const char *tilt = line + 5 + strspn(line + 5, " \t");
            f->tilt_line = number;
            if (strlen(tilt) >= sizeof f->tilt) {
                return murk_luminaire_text_fail(
                    &f->text, number,
                    "TILT= with %zu bytes, must be at most %zu", strlen(tilt),
                    sizeof f->tilt - 1);
            }
            snprintf(f->tilt, sizeof f->tilt, "%s", tilt);
            return MURK_OK;
        }
        take_name(f, line);
    }
    return murk_luminaire_text_fail(&f->text, number,
                                    "the file ends without a line TILT=");
}

/* ---- TILT data ---- */

/* Reads the geometry of the lamp, the number of pairs, the angles and the
 * factors. */
static murk_status read_tilt(ies *f, murk_luminaire_text *text)
{
    murk_luminaire *out = f->out;
    size_t geometry;
    murk_status status = murk_luminaire_text_count(
        text, "lamp-to-luminaire geometry", 1, 3, &geometry);
    if (!status && geometry > 1) {
        murk_luminaire_text_warn(
            text, text->word_line,
            "lamp-to-luminaire geometry %zu, a horizontal lamp: the factors "
            "are "
            "taken by the angle between the aim and straight down, about "
            "whichever axis the luminaire is tilted",
            geometry);
    }
    if (!status) {
        status = murk_luminaire_text_count(text, "number of tilt angles", 1,
                                           MURK_TILTS_MAX, &out->tilts);
    }
    /* The angles, then the factors. */
    for (size_t i = 0; i < out->tilts && !status; ++i) {
        status = murk_luminaire_text_number(text, "tilt angle", 0, 180,
                                            &out->tilt_deg[i]);
        if (!status) {
            status = murk_luminaire_text_rising(text, text->word_line,
                                                "tilt angle", out->tilt_deg, i);
        }
    }
    for (size_t i = 0; i < out->tilts && !status; ++i) {
        status = murk_luminaire_text_number(text, "tilt factor", 0,
                                            MURK_LUMINAIRE_FACTOR_MAX,
                                            &out->tilt_factor[i]);
    }
    return status;
}

/* Reads the TILT data from a file of its own, which lies beside the file. */
static murk_status read_tilt_file(ies *f)
{
    char *text = NULL, shown[48];
    size_t size = 0;
    murk_luminaire_text own;
    /* The name must not lead to another folder. */
    if (f->tilt[0] == '\0' || f->tilt[0] == '.' || strchr(f->tilt, '/') ||
        strchr(f->tilt, '\\') || murk_memory_is(f->text.path)) {
        murk_words_show(shown, sizeof shown, f->tilt);
        return murk_luminaire_text_fail(
            &f->text, f->tilt_line,
            "TILT=%s, must be NONE, INCLUDE or the name of a file beside this "
            "file",
            shown);
    }
    char *path = murk_path_beside(f->text.path, f->tilt);
    murk_status status =
        path ? murk_file_read(&text, &size, path, MURK_LUMINAIRE_BYTES_MAX,
                              f->text.err)
             : murk_no_memory(f->text.err, f->text.path, "for TILT data");
    if (!status) {
        status = murk_luminaire_text_begin(&own, path, text, size, f->text.err);
    }
    if (!status) {
        status = read_tilt(f, &own);
    }
    if (!status) {
        status = murk_luminaire_text_end(&own);
    }
    free(text);
    free(path);
    return status;
}

static murk_status find_tilt(ies *f)
{
    if (strcasecmp(f->tilt, "NONE") == 0) {
        return MURK_OK;
    }
    return strcasecmp(f->tilt, "INCLUDE") == 0 ? read_tilt(f, &f->text)
                                               : read_tilt_file(f);
}

/* ---- lamps and opening ---- */

/* Reads lamps and factors; the size is in the units of the file. */
typedef struct numbers {
    size_t line; /* of the first one */
    size_t lamps, type, units;
    double lumens, multiplier, width, length, height, ballast, photometric;
} numbers;

/* True for a vertical disc: one side is 0, and width or length and the height
 * are negative (LM-63-02, table 1). */
static bool is_upright_disc(double width, double length, double height,
                            int year)
{
    return year >= 2002 && height < 0 && (width == 0 || length == 0) &&
           (width < 0 || length < 0);
}

/* Sets the opening from width, length and height [m], whose signs tell the
 * shape (LM-63-1995, table 2; LM-63-02, table 1). The opening is what is seen
 * from photometric zero; an ellipse counts as the disc of the same area. */
static void set_aperture(murk_luminaire *out, double width, double length,
                         double height, int year)
{
    const double w = fabs(width), l = fabs(length);
    const bool is_round = width < 0 || length < 0;
    /* A positive height is that of luminous sides. */
    out->height_m = fmax(height, 0);
    if (is_upright_disc(width, length, height, year)) {
        out->aperture = MURK_APERTURE_RECT; /* a line, as seen from below */
        out->along_c0_m = l;
        out->along_c90_m = w;
    } else if (is_round && width <= 0 && length <= 0) {
        /* a circle; with both sides an ellipse */
        out->aperture = MURK_APERTURE_DISC;
        out->along_c0_m = w > 0 && l > 0 ? sqrt(w * l) : w + l;
    } else if (is_round && year < 2002) {
        out->aperture = MURK_APERTURE_DISC; /* an ellipse along one axis */
        out->along_c0_m = sqrt(w * l);
    } else {
        /* a rectangle, or a horizontal cylinder, of which a side of 0 has the
         * diameter in the height (1995) */
        out->along_c0_m = l > 0 || height >= 0 ? l : -height;
        out->along_c90_m = w > 0 || height >= 0 ? w : -height;
        out->aperture = out->along_c0_m > 0 || out->along_c90_m > 0
                            ? MURK_APERTURE_RECT
                            : MURK_APERTURE_POINT;
    }
    if (w == 0 && l == 0) {
        out->aperture = MURK_APERTURE_POINT;
        out->along_c0_m = out->along_c90_m = 0;
    }
}

/* Reads the numbers between TILT and the angles. */
static murk_status read_numbers(ies *f, numbers *n)
{
    murk_luminaire_text *t = &f->text;
    size_t verticals, planes;
    double third_min = MURK_LUMINAIRE_FACTOR_MIN;
    murk_status s;
    n->line = t->line;
    if ((s = murk_luminaire_text_count(t, "number of lamps", 1, LAMPS_MAX,
                                       &n->lamps)) ||
        (s = murk_luminaire_text_number(t, "lumens per lamp", -1,
                                        MURK_LUMINAIRE_CANDELA_MAX,
                                        &n->lumens)) ||
        (s = murk_luminaire_text_number(
             t, "candela multiplier", MURK_LUMINAIRE_FACTOR_MIN,
             MURK_LUMINAIRE_FACTOR_MAX, &n->multiplier)) ||
        (s = murk_luminaire_text_count(t, "number of vertical angles", 2,
                                       ANGLES_MAX, &verticals)) ||
        (s = murk_luminaire_text_count(t, "number of horizontal angles", 1,
                                       ANGLES_MAX, &planes))) {
        return s;
    }
    const size_t counts_line = t->word_line;
    if ((s = murk_luminaire_text_count(t, "photometric type", 1, 3,
                                       &n->type)) ||
        (s = murk_luminaire_text_count(t, "units type", 1, 2, &n->units)) ||
        (s = murk_luminaire_text_number(t, "width", -LENGTH_MAX, LENGTH_MAX,
                                        &n->width)) ||
        (s = murk_luminaire_text_number(t, "length", -LENGTH_MAX, LENGTH_MAX,
                                        &n->length)) ||
        (s = murk_luminaire_text_number(t, "height", -LENGTH_MAX, LENGTH_MAX,
                                        &n->height)) ||
        (s = murk_luminaire_text_number(
             t, "ballast factor", MURK_LUMINAIRE_FACTOR_MIN,
             MURK_LUMINAIRE_FACTOR_MAX, &n->ballast))) {
        return s;
    }
    /* The next number is a factor up to 2002, and a code in 2019. */
    if (f->year >= 2019) {
        third_min = 0;
    }
    if ((s = murk_luminaire_text_number(
             t,
             f->year >= 2019 ? "file generation type"
                             : "ballast-lamp photometric factor",
             third_min, MURK_LUMINAIRE_FACTOR_MAX, &n->photometric)) ||
        (s = murk_luminaire_text_number(t, "input watts", 0,
                                        MURK_LUMINAIRE_WATTS_MAX,
                                        &f->out->input_w))) {
        return s;
    }
    if (n->lumens < 0 && n->lumens != -1) {
        return murk_luminaire_text_fail(
            t, n->line, "lumens per lamp: %.10g, must be 0 or more, or -1",
            n->lumens);
    }
    return murk_luminaire_table_create(&f->table, verticals, planes, t,
                                       counts_line);
}

static void use_numbers(ies *f, const numbers *n)
{
    const double unit_m = n->units == 1 ? FOOT_M : 1;
    f->scale =
        n->multiplier * n->ballast * (f->year >= 2019 ? 1 : n->photometric);
    f->out->type = (murk_goniometer)n->type;
    f->out->lamp_lumens = n->lumens > 0 ? (double)n->lamps * n->lumens : NAN;
    f->out->declared_lumens = f->out->lamp_lumens;
    if (is_upright_disc(n->width, n->length, n->height, f->year)) {
        murk_luminaire_text_warn(&f->text, n->line,
                                 "the luminous area is a vertical disc, which "
                                 "size: file takes as a horizontal line");
    }
    set_aperture(f->out, n->width * unit_m, n->length * unit_m,
                 n->height * unit_m, f->year);
}

/* ---- the table ---- */

static murk_status read_angles(ies *f, const char *what, double min, double max,
                               double *angle, size_t n)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < n && !status; ++i) {
        status =
            murk_luminaire_text_number(&f->text, what, min, max, &angle[i]);
        if (!status) {
            status = murk_luminaire_text_rising(&f->text, f->text.word_line,
                                                what, angle, i);
        }
    }
    return status;
}

/* Recognises the symmetry by the horizontal angles. */
static murk_status find_symmetry(ies *f)
{
    const size_t n = f->table.planes;
    const double first = f->table.plane_deg[0],
                 last = f->table.plane_deg[n - 1];
    murk_luminaire_symmetry *symmetry = &f->out->symmetry;
    /* Types A and B are mirrored if they begin in the middle. */
    if (f->out->type != MURK_GONIOMETER_C) {
        *symmetry = first == 0 ? MURK_SYMMETRY_LEFT_RIGHT : MURK_SYMMETRY_NONE;
        return n >= 2 ? MURK_OK
                      : murk_luminaire_text_fail(
                            &f->text, f->text.word_line,
                            "1 horizontal angle, must be 2 or more for "
                            "photometric types A and B");
    }
    /* Type C: the planes tell which part of the turn they are. */
    if (n == 1 && first == 0) {
        *symmetry = MURK_SYMMETRY_AXIAL;
    } else if (first == 0 && last == 90) {
        *symmetry = MURK_SYMMETRY_QUADRANT;
    } else if (first == 0 && last == 180) {
        *symmetry = MURK_SYMMETRY_0_180;
    } else if (first == 90 && last == 270) {
        *symmetry = MURK_SYMMETRY_90_270;
    } else if (first == 0 && last == 360) {
        *symmetry = MURK_SYMMETRY_NONE;
    } else {
        return murk_luminaire_text_fail(
            &f->text, f->text.word_line,
            "horizontal angles %.10g..%.10g, must be 0, 0..90, 0..180, 90..270 "
            "or 0..360",
            first, last);
    }
    return MURK_OK;
}

/* Warns if the planes at 0 and 360 degrees, which are one plane, differ by more
 * than the digits of a file explain: the intensity jumps there. `line` is that
 * of the last plane. */
static void warn_of_seam(const ies *f, size_t line)
{
    const murk_luminaire_table *t = &f->table;
    const double *first = t->candela,
                 *last = t->candela + t->verticals * (t->planes - 1);
    double largest = 0, off = 0;
    for (size_t i = 0; i < t->verticals; ++i) {
        largest = fmax(largest, fmax(first[i], last[i]));
        off = fmax(off, fabs(first[i] - last[i]));
    }
    if (off > SEAM_MAX * largest) {
        murk_luminaire_text_warn(
            &f->text, line,
            "the plane at 360 degrees differs from that at 0 degrees by up to "
            "%.3g %% of the largest intensity, must be the same plane",
            100 * off / largest);
    }
}

static murk_status read_table(ies *f)
{
    const bool is_c = f->out->type == MURK_GONIOMETER_C;
    murk_luminaire_table *t = &f->table;
    size_t last_line = 0;
    murk_status status =
        read_angles(f, "vertical angle", is_c ? 0 : -90, is_c ? 180 : 90,
                    t->vertical_deg, t->verticals);
    if (!status) {
        status = read_angles(f, "horizontal angle", is_c ? 0 : -90,
                             is_c ? 360 : 90, t->plane_deg, t->planes);
    }
    if (!status) {
        status = find_symmetry(f);
    }
    /* The intensities, plane by plane. */
    for (size_t i = 0; i < t->verticals * t->planes && !status; ++i) {
        status = murk_luminaire_text_number(&f->text, "intensity", 0,
                                            MURK_LUMINAIRE_CANDELA_MAX,
                                            &t->candela[i]);
        if (i == t->verticals * (t->planes - 1)) {
            last_line = f->text.word_line;
        }
    }
    if (!status && is_c && f->out->symmetry == MURK_SYMMETRY_NONE) {
        warn_of_seam(f, last_line);
    }
    return status ? status : murk_luminaire_text_end(&f->text);
}

murk_status murk_luminaire_read_ies(murk_luminaire *out, const char *path,
                                    char *text, size_t size, murk_error *err)
{
    ies f = {.out = out};
    numbers n;
    murk_status status =
        murk_luminaire_text_begin(&f.text, path, text, size, err);
    if (status || (status = read_version(&f)) || (status = read_header(&f)) ||
        (status = find_tilt(&f)) || (status = read_numbers(&f, &n))) {
        goto done;
    }
    use_numbers(&f, &n);
    status = read_table(&f);
    if (!status) {
        snprintf(out->format, sizeof out->format, "LM-63-%d", f.year);
        out->verticals = f.table.verticals;
        out->horizontals = f.table.planes;
        status = murk_luminaire_unfold(out, &f.table, f.scale, path, err);
    }
done:
    murk_luminaire_table_release(&f.table);
    return status;
}
