/* Values of fields by kind: a value is read exactly or refused, and a refusal
 * leaves the number of the caller as it was and names field, value and rule.
 * Paths: the longest names that lead to a value. */
#include "api/handles.h"
#include "check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char json[] =
    "{\"zero\": 0, \"count\": 3, \"below\": -2147483649,"
    " \"least\": -9007199254740991, \"largest\": 9007199254740991,"
    " \"power\": 1e15, \"half\": 2.5, \"tiny\": 1e-300,"
    " \"beyond\": 9007199254740992, \"rounded\": 9007199254740993,"
    " \"minus\": -9007199254740992, \"huge\": 1e300, \"text\": \"3\","
    " \"yes\": true, \"none\": null, \"list\": [4], \"map\": {\"of\": 5}}";

static void check_whole(const murk_fields *fields, const char *path,
                        int64_t want)
{
    murk_error error = MURK_ERROR_NONE;
    int64_t value = 77;
    double number = 77;
    CHECK(murk_fields_int64(fields, path, &value, &error) == MURK_OK);
    CHECK(value == want && error.code == MURK_OK);
    CHECK(murk_fields_double(fields, path, &number, NULL) == MURK_OK);
    CHECK((int64_t)number == want);
}

static void check_refused(const murk_fields *fields, const char *path,
                          const char *want)
{
    murk_error error = MURK_ERROR_NONE;
    int64_t value = 77;
    CHECK(murk_fields_int64(fields, path, &value, &error) == MURK_BAD_VALUE);
    CHECK(value == 77 && error.code == MURK_BAD_VALUE);
    CHECK_TEXT(error.where, path);
    CHECK_TEXT(error.text, want);
    CHECK(murk_fields_int64(fields, path, &value, NULL) == MURK_BAD_VALUE);
}

static void test_int64_is_exact_or_refused(const murk_fields *fields)
{
    check_whole(fields, "zero", 0);
    check_whole(fields, "count", 3);
    check_whole(fields, "below", -INT64_C(2147483649));
    check_whole(fields, "least", -INT64_C(9007199254740991));
    check_whole(fields, "largest", INT64_C(9007199254740991));
    check_whole(fields, "power", INT64_C(1000000000000000));
    check_whole(fields, "list.0", 4);
    check_whole(fields, "map.of", 5);
#define RULE                                                     \
    ", must be a whole number of "                               \
    "-9007199254740991..9007199254740991, which a double holds " \
    "exactly"
    check_refused(fields, "half", "is 2.5" RULE);
    check_refused(fields, "tiny", "is 1e-300" RULE);
    check_refused(fields, "beyond", "is 9007199254740992" RULE);
    /* The nearest double of 2^53 + 1 is 2^53, so 2^53 may be either number. */
    check_refused(fields, "rounded", "is 9007199254740992" RULE);
    check_refused(fields, "minus", "is -9007199254740992" RULE);
    check_refused(fields, "huge", "is 1.0000000000000001e+300" RULE);
    check_refused(fields, "text", "is a string, must be a whole number");
    check_refused(fields, "yes", "is true or false, must be a whole number");
    check_refused(fields, "none", "is absent, must be a whole number");
    check_refused(fields, "list", "is a list, must be a whole number");
    check_refused(fields, "map", "is an object, must be a whole number");
    check_refused(fields, "nothing", "is no field, must be a whole number");
}

/* Of the getters, only those of numbers and strings have a value for null. */
static void test_absent_values(const murk_fields *fields)
{
    double number = 0;
    const char *text = "before";
    bool is_set = true;
    CHECK(murk_fields_double(fields, "none", &number, NULL) == MURK_OK);
    CHECK(isnan(number));
    CHECK(murk_fields_string(fields, "none", &text, NULL) == MURK_OK && !text);
    CHECK(murk_fields_bool(fields, "none", &is_set, NULL) == MURK_BAD_VALUE);
    CHECK(is_set);
}

static void test_a_value_needs_an_address(const murk_fields *fields)
{
    murk_error error = MURK_ERROR_NONE;
    CHECK(murk_fields_int64(fields, "count", NULL, &error) == MURK_BAD_VALUE);
    CHECK_TEXT(error.text, "value is NULL");
    CHECK(murk_fields_double(fields, "count", NULL, NULL) == MURK_BAD_VALUE);
    CHECK(murk_fields_bool(fields, "yes", NULL, NULL) == MURK_BAD_VALUE);
    CHECK(murk_fields_string(fields, "text", NULL, NULL) == MURK_BAD_VALUE);
}

/* Names with dots, of which some begin with another one. */
static void test_names_with_dots(void)
{
    static const char dotted[] =
        "{\"wall\": {\"total\": 1, \"a.b\": [2, {\"c.d\": 3}]},"
        " \"wall.001\": {\"total\": 4}, \"wall.001.a\": {\"total\": 5},"
        " \"wall.total\": {\"total\": 6}}";
    murk_fields fields = {.root = cJSON_Parse(dotted)};
    CHECK(fields.root != NULL);
    check_whole(&fields, "wall.a.b.0", 2);
    check_whole(&fields, "wall.a.b.1.c.d", 3);
    check_whole(&fields, "wall.001.total", 4);
    check_whole(&fields, "wall.001.a.total", 5);
    check_whole(&fields, "wall.total.total", 6);
    CHECK(murk_fields_kind(&fields, "wall.total") == MURK_FIELD_OBJECT);
    static const char *const none[] = {"wall.001.b", "wall.a", "wall.a.b.2",
                                       "wall.a.b.0.c", "total"};
    for (size_t i = 0; i < sizeof none / sizeof *none; ++i) {
        CHECK(murk_fields_kind(&fields, none[i]) == MURK_FIELD_UNKNOWN);
    }
    murk_fields_release(&fields);
}

int main(void)
{
    murk_fields fields = {.root = cJSON_Parse(json)};
    CHECK(fields.root != NULL);
    test_int64_is_exact_or_refused(&fields);
    test_absent_values(&fields);
    test_a_value_needs_an_address(&fields);
    test_names_with_dots();
    murk_fields_release(&fields);
    return check_done();
}
