/* Files for viewers hold what they are told, whatever its name: texts of any
 * bytes are one line of a PLY header and plain numbers in VTK's XML.
 *
 * Deterministic: never cries wolf. */
#include "check.h"
#include "results/mesh_file.h"
#include "results/vtk.h"

#include <stdlib.h>

#define HOSTILE "a\nend_header\n\"<&>]]>\x7f\xc3\xa9"

static murk_scene_desc hostile_scene(void)
{
    static char path[] = HOSTILE;
    murk_scene_desc scene = {.path = path, .seed = 5};
    return scene;
}

/* What a writer writes; the caller frees it. */
static char *written(void (*put)(FILE *, const murk_scene_desc *,
                                 const char *const *))
{
    char *text = NULL;
    size_t size = 0;
    const murk_scene_desc scene = hostile_scene();
    FILE *to = open_memstream(&text, &size);
    CHECK(to != NULL);
    put(to, &scene, NULL);
    fclose(to);
    return text;
}

static void test_comments_are_a_line_each(void)
{
    char *text = written(murk_ply_put_facts);
    CHECK(strstr(text, "comment scene a?end_header?\"<&>]]>?\xc3\xa9\n") ==
          text);
    size_t lines = 0;
    for (const char *line = text; line && *line; ++lines) {
        CHECK(strncmp(line, "comment ", 8) == 0);
        line = strchr(line, '\n') + 1;
    }
    CHECK(lines == 5);
    CHECK(strstr(text, "\ncomment seed 5\n") != NULL);
    free(text);
}

static void test_texts_are_numbers(void)
{
    char *text = written(murk_vtk_put_facts);
    CHECK(strstr(text, "Name=\"scene\" NumberOfTuples=\"1\" format=\"ascii\">"
                       "97 10 101 110 100 95 104 101 97 100 101 114 10 34 60 "
                       "38 62 93 93 62 127 195 169 0</DataArray>\n") != NULL);
    CHECK(strstr(text, "Name=\"seed\" NumberOfTuples=\"1\" format=\"ascii\">"
                       "53 0</DataArray>\n") != NULL);
    free(text);
}

static murk_vec3 position_of(const void *context, size_t i)
{
    return murk_vec((double)i, *(const double *)context, -1);
}

static void put_record(const void *context, size_t i, void *record)
{
    (void)context;
    *(uint8_t *)record = (uint8_t)(7 + i);
}

static const murk_mesh_column number = {"number", MURK_MESH_UINT8,
                                        .components = 1};
static const uint8_t first_alone[] = {0};

/* The offsets in the header name the beginning of each array, where the
 * length in bytes stands. */
static void check_mesh(bool has_triangles, size_t points)
{
    /* Write points, or triangles of three points each, with one column,
     * into memory. */
    const double y = 2.5;
    const murk_scene_desc scene = hostile_scene();
    const murk_mesh_export mesh = {.name = "test",
                                   .scene = &scene,
                                   .points = points,
                                   .has_triangles = has_triangles,
                                   .column = &number,
                                   .order = first_alone,
                                   .columns = 1,
                                   .position = position_of,
                                   .record = put_record,
                                   .context = &y};
    murk_error err = {0};
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    CHECK(to != NULL && !murk_vtp_write(to, &mesh, &err));
    CHECK(!fclose(to));
    /* Positions, connectivity, offsets of cells and the column follow each
     * other, each after the length in bytes. */
    const char *raw = strstr(text, "\n_") + 2;
    const size_t items = has_triangles ? points / 3 : points;
    const size_t cells = has_triangles ? points / 3 : points > 0;
    const uint64_t want[4] = {12 * points, 8 * points, 8 * cells, items};
    /* The header names the offset of each array; the column holds the
     * values of all items. */
    for (int k = 0; k < 4; ++k) {
        char offset[40];
        uint64_t bytes = 0;
        memcpy(&bytes, raw, sizeof bytes);
        CHECK(bytes == want[k]);
        snprintf(offset, sizeof offset, "offset=\"%zu\"",
                 (size_t)(raw - (strstr(text, "\n_") + 2)));
        CHECK(strstr(text, offset) != NULL);
        if (k == 3 && items > 0) {
            CHECK((uint8_t)raw[8] == 7 &&
                  (uint8_t)raw[8 + items - 1] == (uint8_t)(7 + items - 1));
        }
        raw += sizeof bytes + bytes;
    }
    /* Nothing but the end of the file follows the arrays. */
    CHECK(strcmp(raw, "\n  </AppendedData>\n</VTKFile>\n") == 0);
    free(text);
}

/* The same columns in a PLY file: positions as floats, then the columns. */
static void test_ply(void)
{
    /* Write two vertices and a face, each with one column, into memory. */
    const murk_scene_desc scene = hostile_scene();
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    CHECK(to != NULL);
    murk_ply ply = murk_mesh_begin(to, &scene, "comment two points\n");
    murk_mesh_vertices(&ply, 2, &number, 1);
    murk_mesh_faces(&ply, 1, &number, 1);
    murk_mesh_end_header(&ply);
    for (uint8_t i = 0; i < 2; ++i) {
        murk_mesh_put_vertex(&ply, murk_vec(i, 2, -1), &i);
    }
    murk_mesh_put_face(&ply, 0, 1, 1, &(uint8_t){9});
    CHECK(!fclose(to));
    /* The header lists the elements and columns. */
    static const char header[] =
        "ply\nformat binary_little_endian 1.0\ncomment two points\n"
        "element vertex 2\nproperty float x\nproperty float y\n"
        "property float z\nproperty uchar number\n"
        "element face 1\nproperty list uchar int vertex_indices\n"
        "property uchar number\nend_header\n";
    const char *raw = text + sizeof header - 1;
    float xyz[3];
    /* Records have no padding: 13 bytes for a vertex, 14 for a face. */
    CHECK(size == sizeof header - 1 + 2 * 13 + 14);
    CHECK(strncmp(text, header, sizeof header - 1) == 0);
    /* Position and column of the second vertex, and the face. */
    memcpy(xyz, raw + 13, sizeof xyz);
    CHECK(xyz[0] == 1 && xyz[1] == 2 && xyz[2] == -1 && raw[25] == 1);
    CHECK(raw[26] == 3 && raw[31] == 1 && raw[39] == 9);
    free(text);
}

int main(void)
{
    test_comments_are_a_line_each();
    test_texts_are_numbers();
    check_mesh(true, 0);
    check_mesh(true, 12);
    check_mesh(false, 0);
    check_mesh(false, 5);
    test_ply();
    return check_done();
}
