/* Data of a page: JSON that ends no script element, lists that are cut, numbers
 * that are read back. Nothing here is random. */
#include "check.h"
#include "report/data.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static char written[2048];

/* What `write` puts out, as text. */
#define WRITTEN(call)                                                  \
    do {                                                               \
        FILE *to = tmpfile();                                          \
        CHECK(to != NULL);                                             \
        if (to) {                                                      \
            call;                                                      \
            rewind(to);                                                \
            written[fread(written, 1, sizeof written - 1, to)] = '\0'; \
            fclose(to);                                                \
        }                                                              \
    } while (0)

static murk_yaml *parsed(const char *text)
{
    murk_yaml *root = NULL;
    CHECK(murk_yaml_parse(&root, text, strlen(text), "test", NULL) == MURK_OK);
    return root;
}

static void write_yaml(FILE *to, const char *text, size_t items_max)
{
    murk_yaml *root = parsed(text);
    murk_data data = {.to = to};
    murk_data_yaml(&data, NULL, root, items_max);
    murk_yaml_destroy(root);
}

static void test_json_ends_no_script(void)
{
    WRITTEN(murk_data data = murk_data_open(to, "a");
            murk_data_text(&data, "<b>", "</script><!--\"\\");
            murk_data_close(&data));
    CHECK_TEXT(written, "<script type=\"application/json\" id=\"a\">"
                        "{\"\\u003cb>\":\"\\u003c/script>\\u003c!--\\\"\\\\\"}"
                        "</script>\n");
    WRITTEN(murk_data data = {.to = to};
            murk_data_text(&data, NULL, "a\xff\x01\n\xc2\x85z"));
    CHECK_TEXT(written, "\"a\\ufffd\\ufffd\\ufffd\\ufffdz\"");
}

static void test_numbers_are_read_back(void)
{
    static const double values[] = {0.1, 1.0 / 3, 1e300, -2, 5e-324};
    for (size_t i = 0; i < sizeof values / sizeof *values; ++i) {
        WRITTEN(murk_data data = {.to = to};
                murk_data_number(&data, NULL, values[i]));
        CHECK(fabs(strtod(written, NULL) - values[i]) <=
              3e-16 * fabs(values[i]));
    }
    WRITTEN(murk_data data = {.to = to};
            murk_data_number(&data, NULL, (double)NAN));
    CHECK_TEXT(written, "null");
    /* little endian 1.0f is 00 00 80 3f */
    WRITTEN(murk_data data = {.to = to};
            murk_data_floats(&data, NULL, (const double[]){1}, 1));
    CHECK_TEXT(written, "\"AACAPw==\"");
}

static void test_results_keep_their_kinds(void)
{
    WRITTEN(write_yaml(to, "{\"a\": [1.50, \"1\", true, null, .5, 1e999]}", 9));
    CHECK_TEXT(written, "{\"a\":[1.5,\"1\",true,null,0.5,\"1e999\"]}");
    WRITTEN(
        write_yaml(to, "{\"a\": [1, 2, 3], \"b\": [[4, 5, 6]], \"c\": 1}", 2));
    CHECK_TEXT(written, "{\"a\":{\"of\":3,\"first\":[1,2]},"
                        "\"b\":[{\"of\":3,\"first\":[4,5]}]}");
}

int main(void)
{
    test_json_ends_no_script();
    test_numbers_are_read_back();
    test_results_keep_their_kinds();
    return check_done();
}
