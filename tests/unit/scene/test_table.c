/* CSV tables: cells, numbers, and refusals with their lines. Nothing here is
 * random but the bytes that the last test changes: no luck can fail it. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "scene/table.h"

#include "base/rng.h"
#include "scene_files.h"

static murk_table *read_table(const char *text, size_t size, murk_error *err)
{
    murk_table *table = NULL;
    *err = (murk_error){0};
    write_bytes("a.csv", text, size);
    murk_table_read(&table, "a.csv", err);
    return table;
}

#define CHECK_REFUSES(input, want_where, want_text)                         \
    do {                                                                    \
        murk_error err_;                                                    \
        murk_table *table_ = read_table((input), sizeof(input) - 1, &err_); \
        CHECK(table_ == NULL && err_.code == MURK_BAD_FILE);                \
        CHECK_TEXT(err_.where, want_where);                                 \
        CHECK_TEXT(err_.text, want_text);                                   \
        murk_table_destroy(table_);                                         \
    } while (0)

static void test_cells(void)
{
    /* A byte-order mark, comments, empty lines, both line ends, and quoted
     * cells with quotes and line ends. */
    static const char text[] =
        "\xEF\xBB\xBF# sensors\r\n\r\n type , x_m,\"a \"\"b\"\", c\"\r\n"
        "node,1e3,\r\n# none\n\"two\nlines\", -.5 ,\"\" \n"
        "last, abc, 1";
    murk_error err;
    murk_table *table = read_table(text, sizeof text - 1, &err);
    CHECK(table && table->columns == 3 && table->rows == 3);
    if (!table) {
        return;
    }
    /* Columns by name, cells, and the line of each row. */
    CHECK(murk_table_column(table, "type") == 0);
    CHECK(murk_table_column(table, "a \"b\", c") == 2);
    CHECK(murk_table_column(table, "y_m") == -1);
    CHECK_TEXT(table->cell[0], "node");
    CHECK_TEXT(table->cell[3], "two\nlines");
    CHECK(table->line[0] == 4 && table->line[1] == 6 && table->line[2] == 8);
    /* Numbers, defaults of empty cells and of missing columns, and refused
     * cells. */
    double x = 0;
    CHECK(murk_table_number(table, 0, 1, NAN, &x, &err) == MURK_OK && x == 1e3);
    CHECK(murk_table_number(table, 1, 1, NAN, &x, &err) == MURK_OK && x == -.5);
    CHECK(murk_table_number(table, 1, 2, 7, &x, &err) == MURK_OK && x == 7);
    CHECK(murk_table_number(table, 1, -1, 8, &x, &err) == MURK_OK && x == 8);
    CHECK(murk_table_number(table, 2, 1, 7, &x, &err) == MURK_BAD_VALUE);
    CHECK_TEXT(err.where, "a.csv:8: x_m");
    CHECK_TEXT(err.text, "abc, must be a number");
    err = (murk_error){0};
    CHECK(murk_table_number(table, 1, 2, NAN, &x, &err) == MURK_BAD_VALUE);
    CHECK_TEXT(err.text, "an empty cell, must be a number");
    murk_table_destroy(table);
}

static void test_refusals(void)
{
    CHECK_REFUSES("", "a.csv", "empty, must begin with a row of column names");
    CHECK_REFUSES("# only\n\n", "a.csv",
                  "empty, must begin with a row of column names");
    CHECK_REFUSES("a,b\n1,2\n3\n", "a.csv:3",
                  "1 cells, must be 2: one for each column of the header");
    CHECK_REFUSES("a,b\n1,2,3\n", "a.csv:2",
                  "3 cells, must be 2: one for each column of the header");
    CHECK_REFUSES("a,b,a\n", "a.csv:1", "column a is there twice");
    CHECK_REFUSES("a,,b\n", "a.csv:1", "column 2 has no name");
    CHECK_REFUSES("a\n\"x\n\n", "a.csv:2", "a quote is not closed");
    CHECK_REFUSES("a\n\"x\"y\n", "a.csv:2",
                  "text behind a closing quote, must be a comma or the end of "
                  "the line");
    CHECK_REFUSES("a\n1\n\0\n", "a.csv:3", "a NUL byte, must be text");
}

/* Changed bytes are read or refused, never more. */
static void test_broken_bytes(void)
{
    static const char text[] = "a,b,\"c d\"\n1,2,\"x \"\"y\"\n# z\n\n3,,5\n";
    for (uint64_t i = 0; i < 1000; ++i) {
        const murk_random4 u = murk_random(1, MURK_EMIT, i, 0, 0);
        char bytes[sizeof text];
        memcpy(bytes, text, sizeof text);
        const size_t size = (size_t)(u.u[2] * (double)sizeof text);
        bytes[(size_t)(u.u[0] * (double)sizeof text)] =
            ",\"\n\r# \0x"[(size_t)(8 * u.u[1])];
        murk_error err;
        murk_table *table = read_table(bytes, size, &err);
        CHECK((table != NULL) == (err.code == MURK_OK));
        CHECK(strchr(err.text, '\n') == NULL);
        for (size_t k = 0; table && k < table->rows * table->columns; ++k) {
            CHECK(strlen(table->cell[k]) <= size);
        }
        murk_table_destroy(table);
    }
}

int main(void)
{
    if (!folder_enter()) {
        check_skip("no folder for temporary files");
    }
    test_cells();
    test_refusals();
    test_broken_bytes();
    folder_leave((const char *const[]){"a.csv", NULL});
    return check_done();
}
