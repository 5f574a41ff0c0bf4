/* Rewrites OBJ and PLY files with their vertices near 0; see
 * geometry/import_shift.h.
 *
 * The first pass reads all vertices and finds their bounding box; the second
 * writes the file with the shift subtracted from the three numbers of each
 * vertex and everything else unchanged. Sources of the formats: Wavefront,
 * Advanced Visualizer appendix B1; G. Turk, The PLY polygon file format,
 * 1994. */
#include "geometry/import_shift.h"

#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* A mesh is far if the largest coordinate of the middle exceeds this many
 * halves of the longest edge: the same number as for scenes
 * (scene/origin.h). */
#define FAR 32

/* Properties of a PLY vertex that are read; usual files have some ten. */
#define PROPERTIES_MAX 64

/* ---- the shift ---- */

typedef struct extent {
    double low[3], high[3];
    size_t n;
} extent;

static void take(extent *e, const double x[3])
{
    for (int k = 0; k < 3; ++k) {
        e->low[k] = e->n == 0 || x[k] < e->low[k] ? x[k] : e->low[k];
        e->high[k] = e->n == 0 || x[k] > e->high[k] ? x[k] : e->high[k];
    }
    ++e->n;
}

/* The shift: the middle of the box, rounded on each axis to a multiple of
 * twice the smallest power of two that is not below the longest edge.
 * Subtracting a round number loses no digits. False if the mesh is not far
 * from 0. */
static bool choose(const extent *e, double shift[3])
{
    double longest = 0, farthest = 0;
    for (int k = 0; k < 3; ++k) {
        longest = fmax(longest, e->high[k] - e->low[k]);
        farthest = fmax(farthest, fabs(e->low[k] + e->high[k]) / 2);
    }
    if (e->n == 0 || !(longest > 0 && isfinite(longest)) ||
        !(farthest > FAR * longest / 2 && isfinite(farthest))) {
        return false;
    }
    const double grid = 2 * exp2(ceil(log2(longest)));
    for (int k = 0; k < 3; ++k) {
        shift[k] = grid * nearbyint((e->low[k] + e->high[k]) / 2 / grid);
    }
    return true;
}

/* ---- text ---- */

static const char *line_end(const char *at, const char *end)
{
    const char *stop = memchr(at, '\n', (size_t)(end - at));
    return stop ? stop + 1 : end;
}

/* Finds word number `want`, counted from 0, of a line: sets *first to the first
 * byte of the word and returns the byte behind the word; NULL if there are
 * fewer words. */
static const char *column(const char *at, const char *end, size_t want,
                          const char **first)
{
    for (size_t k = 0; at < end; ++k) {
        while (at < end && isspace((unsigned char)*at)) {
            ++at;
        }
        *first = at;
        while (at < end && !isspace((unsigned char)*at)) {
            ++at;
        }
        if (k == want) {
            return at > *first ? at : NULL;
        }
    }
    return NULL;
}

/* Reads the numbers that are the words columns[0..2] of a line. False if one of
 * the words is missing, is longer than 63 bytes or is no finite number. */
static bool numbers(const char *at, const char *end, const size_t columns[3],
                    double x[3])
{
    for (int k = 0; k < 3; ++k) {
        const char *first = NULL;
        const char *behind = column(at, end, columns[k], &first);
        char word[64];
        char *stop = NULL;
        if (!behind || (size_t)(behind - first) >= sizeof word) {
            return false;
        }
        memcpy(word, first, (size_t)(behind - first));
        word[behind - first] = '\0';
        x[k] = strtod(word, &stop);
        if (*stop != '\0' || !isfinite(x[k])) {
            return false;
        }
    }
    return true;
}

/* Writes the line with the shift subtracted from the numbers in the three
 * columns, which get nine significant digits, enough for single precision. */
static void put_shifted(FILE *out, const char *at, const char *end,
                        const size_t columns[3], const double shift[3])
{
    double x[3] = {0};
    (void)numbers(at, end, columns, x);
    const char *from = at, *first = NULL, *behind;
    for (size_t c = 0; (behind = column(at, end, c, &first)); ++c) {
        for (int k = 0; k < 3; ++k) {
            if (columns[k] == c) {
                fwrite(from, 1, (size_t)(first - from), out);
                fprintf(out, "%.9g", x[k] - shift[k]);
                from = behind;
            }
        }
    }
    fwrite(from, 1, (size_t)(end - from), out);
}

/* The vertices in a file. In a PLY file they are the first items behind the
 * header: lines, or binary records. */
typedef struct layout {
    bool is_obj, is_ascii, is_big;
    uint64_t vertices;    /* of a PLY file */
    size_t header, bytes; /* bytes of the header and of one binary vertex */
    size_t column[3];     /* of x, y and z in a text vertex */
    size_t offset[3];     /* offset of x, y and z in a binary vertex */
    bool is_double[3];
    unsigned found; /* one bit for each of x, y and z */
} layout;

/* True if the line is a vertex; `before` vertices lie before it. */
static bool is_vertex(const layout *l, const char *bytes, const char *at,
                      const char *end, uint64_t before)
{
    return l->is_obj
               ? end - at > 2 && at[0] == 'v' && (at[1] == ' ' || at[1] == '\t')
               : at >= bytes + l->header && before < l->vertices;
}

/* False for a vertex of an OBJ file with a weight (a fourth number without a
 * fifth) and for a line that continues on the next: such files are not
 * rewritten. */
static bool is_plain(const char *at, const char *end)
{
    const char *first = NULL;
    const bool has_fourth = column(at, end, 4, &first) != NULL;
    const bool has_fifth = column(at, end, 5, &first) != NULL;
    return has_fourth == has_fifth && !memchr(at, '\\', (size_t)(end - at));
}

static bool shift_text(const layout *l, const char *bytes, size_t size,
                       FILE *out, double shift[3])
{
    const char *end = bytes + size, *stop;
    extent e = {.n = 0};
    /* First pass: the bounding box of the vertices. */
    for (const char *at = bytes; at < end; at = stop) {
        double x[3];
        stop = line_end(at, end);
        if (!is_vertex(l, bytes, at, stop, e.n)) {
            continue;
        }
        if ((l->is_obj && !is_plain(at, stop)) ||
            !numbers(at, stop, l->column, x)) {
            return false;
        }
        take(&e, x);
    }
    if (e.n < l->vertices || !choose(&e, shift)) {
        return false;
    }
    /* Second pass: copy the file, with the vertices shifted. */
    uint64_t n = 0;
    for (const char *at = bytes; at < end; at = stop) {
        stop = line_end(at, end);
        if (is_vertex(l, bytes, at, stop, n)) {
            put_shifted(out, at, stop, l->column, shift);
            ++n;
        } else {
            fwrite(at, 1, (size_t)(stop - at), out);
        }
    }
    return true;
}

/* ---- PLY ---- */

static size_t type_bytes(const char *name)
{
    static const struct {
        const char *name;
        size_t bytes;
    } types[] = {{"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},
                 {"short", 2}, {"ushort", 2},  {"int16", 2},  {"uint16", 2},
                 {"int", 4},   {"uint", 4},    {"int32", 4},  {"uint32", 4},
                 {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
    for (size_t i = 0; i < sizeof types / sizeof *types; ++i) {
        if (strcmp(types[i].name, name) == 0) {
            return types[i].bytes;
        }
    }
    return 0;
}

static bool add_property(layout *p, size_t *columns, const char *type,
                         const char *name)
{
    const size_t bytes = type_bytes(type);
    if (bytes == 0 || *columns == PROPERTIES_MAX) {
        return false;
    }
    if (strlen(name) == 1 && name[0] >= 'x' && name[0] <= 'z') {
        const int k = name[0] - 'x';
        p->column[k] = *columns;
        p->offset[k] = p->bytes;
        p->is_double[k] = bytes == 8;
        p->found |= 1U << k;
    }
    p->bytes += bytes;
    ++*columns;
    return true;
}

/* Reads the header. False if the vertices are not the first element, or have no
 * x, y and z, a list or too many properties: then the file is not rewritten. */
static bool read_ply_header(layout *p, const char *bytes, size_t size)
{
    const char *end = bytes + size;
    bool is_of_vertex = false, is_past = false;
    size_t columns = 0;
    for (const char *at = bytes; at < end; at = line_end(at, end)) {
        const char *stop = line_end(at, end);
        char line[256], word[4][64] = {"", "", "", ""};
        const size_t n = (size_t)(stop - at);
        if (n >= sizeof line) {
            continue; /* a long comment line */
        }
        memcpy(line, at, n);
        line[n] = '\0';
        (void)sscanf(line, "%63s %63s %63s %63s", word[0], word[1], word[2],
                     word[3]);
        if (strcmp(word[0], "format") == 0) {
            p->is_ascii = strcmp(word[1], "ascii") == 0;
            p->is_big = strcmp(word[1], "binary_big_endian") == 0;
        } else if (strcmp(word[0], "element") == 0) {
            is_of_vertex = strcmp(word[1], "vertex") == 0 && !is_past;
            is_past = true;
            p->vertices =
                is_of_vertex ? strtoull(word[2], NULL, 10) : p->vertices;
        } else if (strcmp(word[0], "property") == 0 && is_of_vertex) {
            if (!add_property(p, &columns, word[1], word[2])) {
                return false;
            }
        } else if (strcmp(word[0], "end_header") == 0) {
            p->header = (size_t)(stop - bytes);
            return p->found == 7 && p->vertices > 0;
        }
    }
    return false;
}

/* Copies the bytes of a number, turned around in a big-endian file. */
static void copy_double(void *to, const void *from, bool is_big)
{
    for (int k = 0; k < 8; ++k) {
        ((char *)to)[is_big ? 7 - k : k] = ((const char *)from)[k];
    }
}

static bool shift_binary(const layout *p, const char *bytes, size_t size,
                         FILE *out, double shift[3])
{
    extent e = {.n = 0};
    const char *first = bytes + p->header;
    /* Only doubles can hold coordinates that lose digits in single precision; a
     * file with other coordinates is not rewritten. */
    const bool fits = p->vertices <= (size - p->header) / p->bytes;
    if (!fits || !p->is_double[0] || !p->is_double[1] || !p->is_double[2]) {
        return false;
    }
    /* First pass: the bounding box of the vertices. */
    for (uint64_t i = 0; i < p->vertices; ++i) {
        double x[3];
        for (int k = 0; k < 3; ++k) {
            copy_double(&x[k], first + i * p->bytes + p->offset[k], p->is_big);
            if (!isfinite(x[k])) {
                return false;
            }
        }
        take(&e, x);
    }
    if (!choose(&e, shift)) {
        return false;
    }
    /* Second pass: copy the file, with the vertices shifted. */
    fwrite(bytes, 1, p->header, out);
    for (uint64_t i = 0; i < p->vertices; ++i) {
        char vertex[PROPERTIES_MAX * sizeof(double)];
        memcpy(vertex, first + i * p->bytes, p->bytes);
        for (int k = 0; k < 3; ++k) {
            double x;
            copy_double(&x, vertex + p->offset[k], p->is_big);
            x -= shift[k];
            copy_double(vertex + p->offset[k], &x, p->is_big);
        }
        fwrite(vertex, 1, p->bytes, out);
    }
    const size_t copied = p->header + p->vertices * p->bytes;
    fwrite(bytes + copied, 1, size - copied, out);
    return true;
}

static bool has_ending(const char *path, const char *ending)
{
    const char *dot = strrchr(path, '.');
    return dot && strcasecmp(dot, ending) == 0;
}

bool murk_import_may_shift(const char *path)
{
    return has_ending(path, ".obj") || has_ending(path, ".ply");
}

bool murk_import_shift(const char *path, const char *bytes, size_t size,
                       char **out, size_t *out_size, double shift[3])
{
    /* Words of a vertex line of an OBJ file: `v` is word 0, then x, y and z. */
    layout l = {.is_obj = has_ending(path, ".obj"), .column = {1, 2, 3}};
    if (!l.is_obj &&
        !(has_ending(path, ".ply") && read_ply_header(&l, bytes, size))) {
        return false;
    }
    FILE *stream = open_memstream(out, out_size);
    if (!stream) {
        return false;
    }
    bool is_shifted = (l.is_obj || l.is_ascii ? shift_text : shift_binary)(
        &l, bytes, size, stream, shift);
    is_shifted = !ferror(stream) && is_shifted;
    is_shifted = fclose(stream) == 0 && is_shifted;
    if (!is_shifted) {
        free(*out);
        *out = NULL;
    }
    return is_shifted;
}
