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

/* Two vertices of a byte and three doubles, as this machine has them. */
static void test_binary_ply(void)
{
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
    char *out = NULL;
    size_t size = 0;
    double shift[3];
    CHECK(murk_import_shift("b.ply", file, at, &out, &size, shift));
    CHECK(out && size == at && memcmp(out, file, sizeof head - 1) == 0);
    for (int i = 0; out && i < 2; ++i) {
        double got[3];
        memcpy(got, out + sizeof head - 1 + 25 * i + 1, 24);
        for (int k = 0; k < 3; ++k) {
            CHECK(got[k] == x[i][k] - shift[k]);
        }
    }
    CHECK(shift[0] == 500000 && shift[1] == 5500000 && shift[2] == 0);
    free(out);
    CHECK(!murk_import_shift("b.ply", file, at - 1, &out, &size, shift));
}

int main(void)
{
    test_obj();
    test_text_ply();
    test_binary_ply();
    return check_done();
}
