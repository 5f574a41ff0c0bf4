/* Fields written as .vdb come back the same, voxel by voxel, through the
 * reader for scenes. Deterministic. */

#include "base/file.h"
#include "check.h"
#include "medium/grid.h"
#include "medium/grid_write.h"

#include <stdlib.h>
#include <unistd.h>

static char folder[] = "/tmp/murk_grid_write_XXXXXX";
static char path[64];

static const size_t SIZE[3] = {19, 5, 10};

static murk_affine placed(void)
{
    murk_affine place = murk_affine_place(
        murk_vec(0, 0, 30), 0.25, murk_vec(100, -20, 3)); /* turned, too */
    place.matrix[2][2] *= 2;
    return place;
}

/* A third of the values are 0. */
static float *made_up(void)
{
    const size_t n = SIZE[0] * SIZE[1] * SIZE[2];
    float *value = malloc(n * sizeof *value);
    for (size_t i = 0; i < n; ++i) {
        value[i] = i % 3 == 0 ? 0 : (float)i * 1e-3F;
    }
    return value;
}

static murk_grid *read_back(const char *name)
{
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_read(&grid, path, name, "test", &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return grid;
}

static void check_values(const murk_grid *grid, const float *value)
{
    int wrong = 0;
    for (size_t k = 0; k < SIZE[2]; ++k) {
        for (size_t j = 0; j < SIZE[1]; ++j) {
            for (size_t i = 0; i < SIZE[0]; ++i, ++value) {
                wrong += murk_grid_value(grid, (int64_t)i, (int64_t)j,
                                         (int64_t)k) != (double)*value;
            }
        }
    }
    CHECK(wrong == 0);
}

static void test_fields_come_back(void)
{
    /* Write two fields, the first with notes. */
    float *value = made_up(), *twice = made_up();
    const murk_affine place = placed();
    for (size_t i = 0; i < SIZE[0] * SIZE[1] * SIZE[2]; ++i) {
        twice[i] *= 2;
    }
    const char *const notes[] = {"unit", "W/m2", "band_nm", "532", NULL};
    const murk_grid_field fields[] = {{"fluence", value, notes},
                                      {"fluence_error", twice, NULL}};
    murk_error err = {0};
    CHECK(murk_grid_write(path, fields, 2, SIZE, &place, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    /* Read both: values, number of active voxels (those that are not 0) and
     * placement come back. */
    murk_grid *grid = read_back("fluence"), *other = read_back("fluence_error");
    if (grid && other) {
        check_values(grid, value);
        check_values(other, twice);
        const murk_grid_facts *facts = murk_grid_describe(grid);
        const size_t n = SIZE[0] * SIZE[1] * SIZE[2];
        CHECK(facts->active == n - (n + 2) / 3);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                CHECK(facts->index_to_world.matrix[row][column] ==
                      place.matrix[row][column]);
            }
        }
        CHECK(facts->index_to_world.shift.y == place.shift.y);
    }
    murk_grid_destroy(grid);
    murk_grid_destroy(other);
    free(value);
    free(twice);
}

/* The bytes of the file, and the caller's to free(). */
static char *bytes_written(const float *value, size_t *n)
{
    const murk_affine place = placed();
    const murk_grid_field field = {"fluence", value, NULL};
    char *bytes = NULL;
    murk_error err = {0};
    CHECK(murk_grid_write(path, &field, 1, SIZE, &place, &err) == MURK_OK);
    CHECK(murk_file_read(&bytes, n, path, 10000000, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return bytes;
}

/* Two writings agree in every byte, identifier and all; other values have
 * another identifier, so that it still tells files apart. */
static void test_equal_fields_are_equal_bytes(void)
{
    enum { ID_AT = 21, ID_BYTES = 36 };
    float *value = made_up();
    size_t n = 0, again_n = 0, other_n = 0;
    char *one = bytes_written(value, &n);
    char *again = bytes_written(value, &again_n);
    value[1] += 1;
    char *other = bytes_written(value, &other_n);
    CHECK(one && again && n == again_n && memcmp(one, again, n) == 0);
    CHECK(one && one[ID_AT + 14] == '8' && strchr("89ab", one[ID_AT + 19]));
    CHECK(one && other && memcmp(one + ID_AT, other + ID_AT, ID_BYTES) != 0);
    free(one);
    free(again);
    free(other);
    free(value);
}

/* Written over what was there, and with nothing but zeros. */
static void test_a_field_of_zeros(void)
{
    const float zero[2] = {0};
    const size_t size[3] = {2, 1, 1};
    const murk_affine place = murk_affine_identity();
    const murk_grid_field field = {"dark", zero, NULL};
    murk_error err = {0};
    CHECK(murk_grid_write(path, &field, 1, size, &place, &err) == MURK_OK);
    murk_grid *grid = read_back(NULL);
    CHECK(grid && murk_grid_describe(grid)->active == 0);
    murk_grid_destroy(grid);
}

/* A thin grid fills its leaves worst: 8 of 512 voxels. */
static void test_a_long_thin_grid(void)
{
    const size_t size[3] = {1, 1, 400000};
    float *value = calloc(size[2], sizeof *value);
    value[size[2] - 1] = 3;
    for (size_t i = 0; i < size[2]; i += 8) {
        value[i] = 1;
    }
    const murk_affine place = murk_affine_identity();
    const murk_grid_field field = {"thin", value, NULL};
    murk_error err = {0};
    CHECK(murk_grid_write(path, &field, 1, size, &place, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    murk_grid *grid = read_back(NULL);
    CHECK(grid && murk_grid_value(grid, 0, 0, 399999) == 3);
    murk_grid_destroy(grid);
    free(value);
}

static void refuses(const char *to, const murk_grid_field *fields, size_t n,
                    size_t size_x, const murk_affine *place, const char *part)
{
    const size_t size[3] = {size_x, 1, 1};
    murk_error err = {0};
    CHECK(murk_grid_write(to, fields, n, size, place, &err) != MURK_OK);
    CHECK_MENTIONS(err.text, part);
}

static void test_refusals(void)
{
    const murk_affine place = murk_affine_identity();
    murk_affine flat = place;
    flat.matrix[1][1] = 0;
    const float value[2] = {1, NAN};
    const murk_grid_field fields[2] = {{"a", value, NULL}, {"a", value, NULL}};
    const murk_grid_field nameless = {"", value, NULL};
    refuses(path, fields, 0, 1, &place, "0 fields, must be 1..64");
    refuses(path, fields, 2, 1, &place, "two fields named a");
    refuses(path, &nameless, 1, 1, &place, "name of 0 bytes");
    refuses(path, fields, 1, 2, &place, "value 1 is nan, must be finite");
    refuses(path, fields, 1, 0, &place, "0 x 1 x 1 samples");
    refuses(path, fields, 1, 1, &flat, "index_to_world is singular");
    refuses("/tmp/no/such/folder/x.vdb", fields, 1, 1, &place, "cannot write");
}

int main(void)
{
    if (!mkdtemp(folder)) {
        return 1;
    }
    snprintf(path, sizeof path, "%s/out.vdb", folder);
    test_fields_come_back();
    test_equal_fields_are_equal_bytes();
    test_a_field_of_zeros();
    test_a_long_thin_grid();
    test_refusals();
    remove(path);
    rmdir(folder);
    return check_done();
}
