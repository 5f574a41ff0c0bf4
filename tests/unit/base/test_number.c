/* Numbers are read strictly and written so that they read back the same.
 * Nothing here is random. */
#include "base/number.h"
#include "base/rng.h"
#include "check.h"

static void test_numbers(void)
{
    static const struct {
        const char *text;
        double value;
    } good[] = {{"0", 0},    {"-3", -3},       {"+3", 3},      {".5", .5},
                {"5.", 5},   {"1e6", 1e6},     {"1E-3", .001}, {"1e+2", 100},
                {"0007", 7}, {"-0.25e1", -2.5}};
    static const char *const bad[] = {
        "",    " 1",    "1 ",  "12abc", "nan",  ".nan", ".inf", "inf",
        "-",   ".",     "e5",  "1e",    "1e+",  "0x10", "0o7",  "1_000",
        "1,5", "1e999", "--1", "1.2.3", "true", "~",    "1e6m", "infinity"};
    for (size_t i = 0; i < sizeof good / sizeof *good; ++i) {
        double value = -99;
        CHECK(murk_number_parse(good[i].text, &value));
        CHECK(value == good[i].value);
    }
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        double value = -99;
        CHECK(!murk_number_parse(bad[i], &value) && value == -99);
    }
}

static void test_counts(void)
{
    uint64_t n = 99;
    CHECK(murk_count_parse("0", &n) && n == 0);
    CHECK(murk_count_parse("1e6", &n) && n == 1000000);
    CHECK(murk_count_parse("2.5e3", &n) && n == 2500);
    CHECK(murk_count_parse("18446744073709551615", &n) && n == UINT64_MAX);
    CHECK(murk_count_parse("9007199254740993", &n) &&
          n == 9007199254740993ull); /* 2^53 + 1: not through a double */
    n = 99;
    CHECK(!murk_count_parse("18446744073709551616", &n));
    CHECK(!murk_count_parse("-1", &n));
    CHECK(!murk_count_parse("1.5", &n));
    CHECK(!murk_count_parse("1e30", &n));
    CHECK(!murk_count_parse("12abc", &n));
    CHECK(n == 99);
}

static void test_printing_round_trips(void)
{
    char text[MURK_NUMBER_SIZE];
    murk_number_print(text, 0.1);
    CHECK_TEXT(text, "0.1");
    murk_number_print(text, 1e6);
    CHECK_TEXT(text, "1000000");
    for (uint64_t i = 0; i < 2000; ++i) {
        const murk_random4 u = murk_random(1, MURK_EMIT, i, 0, 0);
        const double value = (u.u[0] - 0.5) * pow(10, 600 * u.u[1] - 300);
        double back = 0;
        murk_number_print(text, value);
        CHECK(murk_number_parse(text, &back) && back == value);
    }
}

int main(void)
{
    test_numbers();
    test_counts();
    test_printing_round_trips();
    return check_done();
}
