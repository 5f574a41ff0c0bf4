/* Files for viewers hold what they are told, whatever its name: texts of any
 * bytes are one line of a PLY header and plain numbers in VTK's XML.
 *
 * Deterministic: never cries wolf. */
#include "base/file.h"
#include "check.h"
#include "results/vtk.h"

#include <stdlib.h>
#include <unistd.h>

#define HOSTILE "a\nend_header\n\"<&>]]>\x7f\xc3\xa9"

static murk_scene_desc hostile_scene(void)
{
    static char path[] = HOSTILE;
    murk_scene_desc scene = {.path = path, .seed = 5};
    return scene;
}

/* What a writer writes; the caller frees it. */
static char *written(void (*put)(FILE *, const murk_scene_desc *))
{
    char *text = NULL;
    size_t size = 0;
    const murk_scene_desc scene = hostile_scene();
    FILE *to = open_memstream(&text, &size);
    CHECK(to != NULL);
    put(to, &scene);
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

static void put_place(const void *context, size_t i, void *item)
{
    const float xyz[3] = {(float)i, *(const float *)context, -1};
    memcpy(item, xyz, sizeof xyz);
}

static void put_number(const void *context, size_t i, void *item)
{
    (void)context;
    *(uint8_t *)item = (uint8_t)(7 + i);
}

/* Offsets name where each array begins, with its length before it. */
static void check_mesh(bool has_triangles, size_t points)
{
    const float y = 2.5F;
    const murk_scene_desc scene = hostile_scene();
    const murk_vtk_array number = {"number", "UInt8", 1, 1, put_number};
    const murk_vtp vtp = {.scene = &scene,
                          .points = points,
                          .has_triangles = has_triangles,
                          .place = {"place", "Float32", 3, 12, put_place},
                          .array = &number,
                          .arrays = 1,
                          .context = &y,
                          .step = "test"};
    char path[] = "/tmp/murk-test-vtk-XXXXXX";
    const int fd = mkstemp(path);
    murk_error err = {0};
    char *text = NULL;
    size_t size = 0;
    CHECK(fd >= 0 && close(fd) == 0);
    CHECK(!murk_vtp_write(&vtp, path, &err));
    CHECK(!murk_file_read(&text, &size, path, 100000, &err));
    unlink(path);
    const char *raw = strstr(text, "\n_") + 2;
    const size_t items = has_triangles ? points / 3 : points;
    const size_t cells = has_triangles ? points / 3 : points > 0;
    const uint64_t want[4] = {12 * points, 8 * points, 8 * cells, items};
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
    CHECK(strcmp(raw, "\n  </AppendedData>\n</VTKFile>\n") == 0);
    free(text);
}

static void test_what_cannot_be_written(void)
{
    const murk_scene_desc scene = hostile_scene();
    const murk_vtk_array number = {"number", "UInt8", 1, 1, put_number};
    const murk_vtp vtp = {.scene = &scene, .array = &number, .arrays = 1};
    murk_error err = {0};
    CHECK(murk_vtp_write(&vtp, "/no/such/folder/a.vtp", &err) ==
          MURK_RUN_FAILED);
}

int main(void)
{
    test_comments_are_a_line_each();
    test_texts_are_numbers();
    check_mesh(true, 0);
    check_mesh(true, 12);
    check_mesh(false, 0);
    check_mesh(false, 5);
    test_what_cannot_be_written();
    return check_done();
}
