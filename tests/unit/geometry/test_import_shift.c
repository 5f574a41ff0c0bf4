/* OBJ and PLY files far from 0 are rewritten near 0, in double precision, and
 * nothing else of them changes; near ones are left alone. Exact. */
#include "check.h"
#include "geometry/import_shift.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Compares the rewritten file (NULL: it is left alone) and the shift. */
static void check_file(const char *path, const char *from, const char *want,
                       double x, double y, double z)
{
    char *out = NULL;
    size_t size = 0;
    double shift[3] = {0, 0, 0};
    const bool is_shifted =
        murk_import_shift(path, from, strlen(from), &out, &size, shift);
    CHECK(is_shifted == (want != NULL));
    if (is_shifted && want) {
        CHECK(size == strlen(want) && memcmp(out, want, size) == 0);
        CHECK(shift[0] == x && shift[1] == y && shift[2] == z);
    }
    free(out);
}

static void test_obj(void)
{
    check_file("a.obj",
               "# v 1 2 3\nmtllib m.mtl\nv 500001.25 5500002.5 3\n"
               "v  500009.37\t5500000.125 0 1 0 0\r\nvn 0 0 1\nf 1 2 1\n",
               "# v 1 2 3\nmtllib m.mtl\nv 1.25 2.5 3\n"
               "v  9.37\t0.125 0 1 0 0\r\nvn 0 0 1\nf 1 2 1\n",
               500000, 5500000, 0);
    /* the middle, 32.5 and 31.8 m off, is farther than 16 extents, or not */
    check_file("a.obj", "v\t31.5 0 0\nv 33.5 0 0\n", "v\t-0.5 0 0\nv 1.5 0 0\n",
               32, 0, 0);
    check_file("b.obj", "v 30.8 0 0\nv 32.8 0 0\n", NULL, 0, 0, 0);
    check_file("c.obj", "v 0 0 -33.5\nv 0 0 -31.5\n", "v 0 0 -1.5\nv 0 0 0.5\n",
               0, 0, -32);
    check_file("one.obj", "v 5e5 0 0\nv 5e5 0 0\n", NULL, 0, 0, 0);
    check_file("none.obj", "vn 5e5 0 0\nf 1 1 1\n", NULL, 0, 0, 0);
    check_file("inf.obj", "v 5e5 0 0\nv inf 0 0\n", NULL, 0, 0, 0);
    check_file("near.obj", "v 1 2 3\nv 4 5 6\n", NULL, 0, 0, 0);
    /* not understood: a weight, a line that goes on, no number */
    check_file("w.obj", "v 5e5 0 0 2\nv 500001 1 1 2\n", NULL, 0, 0, 0);
    check_file("l.obj", "v 5e5 0 \\\n0\nv 500001 1 1\n", NULL, 0, 0, 0);
    check_file("n.obj", "v 5e5 0 x\nv 500001 1 1\n", NULL, 0, 0, 0);
    check_file("a.stl", "v 5e5 0 0\nv 500001 1 1\n", NULL, 0, 0, 0);
}

static void test_text_ply(void)
{
    check_file("a.PLY",
               "ply\nformat ascii 1.0\nelement vertex 2\nproperty uchar red\n"
               "property float x\nproperty float y\nproperty float z\n"
               "element face 1\nproperty list uchar int vertex_indices\n"
               "end_header\n9 500001.25 5500002.5 3\n8 500009.5 5500000 0\n"
               "3 0 1 0\n",
               "ply\nformat ascii 1.0\nelement vertex 2\nproperty uchar red\n"
               "property float x\nproperty float y\nproperty float z\n"
               "element face 1\nproperty list uchar int vertex_indices\n"
               "end_header\n9 1.25 2.5 3\n8 9.5 0 0\n"
               "3 0 1 0\n",
               500000, 5500000, 0);
    check_file("cut.ply",
               "ply\nformat ascii 1.0\nelement vertex 9\nproperty float x\n"
               "property float y\nproperty float z\nend_header\n5e5 1 1\n",
               NULL, 0, 0, 0);
}

/* Two vertices, each of a byte and three doubles, in the byte order of this
 * machine. */
static void test_binary_ply(void)
{
    /* Write the file in memory. */
    static const char head[] =
        "ply\nformat binary_little_endian 1.0\nelement vertex 2\n"
        "property uchar red\nproperty double x\nproperty double y\n"
        "property double z\nend_header\n";
    const double x[2][3] = {{500001.125, 5500002.0625, 4},
                            {500009.1, 5500001, -4}};
    char file[sizeof head + 51];
    size_t at = sizeof head - 1;
    memcpy(file, head, at);
    for (int i = 0; i < 2; ++i) {
        file[at] = (char)i;
        memcpy(file + at + 1, x[i], 24);
        at += 25;
    }
    /* The shift is subtracted from the coordinates of each vertex; the head
     * and the other property stay. */
    char *out = NULL;
    size_t size = 0;
    double shift[3];
    CHECK(murk_import_shift("b.ply", file, at, &out, &size, shift));
    CHECK(out && size == at && memcmp(out, file, sizeof head - 1) == 0);
    for (int i = 0; out && i < 2; ++i) {
        const char *vertex = out + sizeof head - 1 + 25 * i;
        double got[3];
        CHECK(vertex[0] == (char)i);
        memcpy(got, vertex + 1, 24);
        for (int k = 0; k < 3; ++k) {
            CHECK(got[k] == x[i][k] - shift[k]);
        }
    }
    CHECK(shift[0] == 500000 && shift[1] == 5500000 && shift[2] == 0);
    free(out);
    /* A file that is cut off is left alone. */
    CHECK(!murk_import_shift("b.ply", file, at - 1, &out, &size, shift));
}

/* A vertex of every type before three doubles, which are the only ones moved:
 * 4 of 1 byte, 4 of 2, 6 of 4 and 2 of 8, so x begins at byte 52. */
static void check_types(const char *format, const char *more, bool is_wanted)
{
    static const char *const type[] = {"char",  "uchar",   "int8",   "uint8",
                                       "short", "ushort",  "int16",  "uint16",
                                       "int",   "uint",    "int32",  "uint32",
                                       "float", "float32", "double", "float64"};
    enum { TYPES = sizeof type / sizeof *type, X_AT = 52, BYTES = 76 };
    char file[2000], want[2000];
    size_t at = (size_t)snprintf(
        file, sizeof file,
        "ply\nformat %s 1.0\ncomment %0300d\nelement vertex 2\n", format, 0);
    for (int i = 0; i < TYPES; ++i) {
        at += (size_t)snprintf(file + at, sizeof file - at, "property %s p%d\n",
                               type[i], i);
    }
    at += (size_t)snprintf(file + at, sizeof file - at,
                           "property double x\nproperty float64 y\n"
                           "property double z\n%send_header\n",
                           more);
    const size_t body = at;
    for (size_t i = 0; i < 2 * BYTES; ++i) {
        file[at++] = (char)i;
    }
    memcpy(want, file, at);
    const bool is_big = strstr(format, "big") != NULL;
    for (int i = 0; i < 2; ++i) {
        for (int k = 0; k < 3; ++k) {
            const double x = 1e6 + 4 * i + k, less = 4 * i + k;
            char bytes[2][8];
            memcpy(bytes[0], &x, 8);
            memcpy(bytes[1], &less, 8);
            for (int b = 0; b < 8; ++b) { /* this machine's are little */
                const size_t to = body + (size_t)(i * BYTES + X_AT + 8 * k) +
                                  (size_t)(is_big ? 7 - b : b);
                file[to] = bytes[0][b];
                want[to] = bytes[1][b];
            }
        }
    }
    char *out = NULL;
    size_t size = 0;
    double shift[3] = {0, 0, 0};
    const bool is_shifted =
        murk_import_shift("t.ply", file, at, &out, &size, shift);
    CHECK(is_shifted == is_wanted);
    if (is_shifted && is_wanted) {
        CHECK(shift[0] == 1e6 && shift[1] == 1e6 && shift[2] == 1e6);
        CHECK(size == at && memcmp(out, want, at) == 0);
    }
    free(out);
}

static void test_ply_types_and_elements(void)
{
    check_types("binary_little_endian", "", true);
    check_types("binary_big_endian", "", true);
    check_types("binary_little_endian", "element face 0\nproperty half w\n",
                true);
    check_types("binary_little_endian", "property half w\n", false);
    static const char *const malformed[] = {
        "element vertex 2\nproperty float x\nproperty float y\n",
        "element vertex 2\nproperty float x\nproperty float y\n"
        "property float a\n",
        "element vertex 0\nproperty float x\nproperty float y\n"
        "property float z\n",
        "element edge 2\nproperty float a\nelement vertex 2\n"
        "property float x\nproperty float y\nproperty float z\n"};
    for (size_t i = 0; i < sizeof malformed / sizeof *malformed; ++i) {
        char text[400];
        snprintf(text, sizeof text,
                 "ply\nformat ascii 1.0\n%send_header\n"
                 "500000 0 0\n500001 0 0\n",
                 malformed[i]);
        check_file("m.ply", text, NULL, 0, 0, 0);
    }
}

/* 64 properties are looked at, and no more. */
static void test_ply_of_many_properties(void)
{
    for (int others = 61; others <= 62; ++others) {
        char text[4000], want[4000], row[300] = "";
        size_t at = (size_t)snprintf(
            text, sizeof text,
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
            "property float y\nproperty float z\n");
        for (int i = 0; i < others; ++i) {
            at += (size_t)snprintf(text + at, sizeof text - at,
                                   "property uchar p%d\n", i);
            strcat(row, " 7");
        }
        snprintf(text + at, sizeof text - at, "end_header\n");
        strcpy(want, text);
        at = strlen(text);
        snprintf(text + at, sizeof text - at, "500000 0 0%s\n500001 0 0%s\n",
                 row, row);
        snprintf(want + at, sizeof want - at, "0 0 0%s\n1 0 0%s\n", row, row);
        check_file("many.ply", text, others == 61 ? want : NULL, 500000, 0, 0);
    }
}

int main(void)
{
    test_obj();
    test_text_ply();
    test_binary_ply();
    test_ply_types_and_elements();
    test_ply_of_many_properties();
    return check_done();
}
