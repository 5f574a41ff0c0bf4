/* UTF-8 by the table of well-formed bytes (Unicode 15, table 3-7): the first
 * and the last of each row, and what lies just beyond. Nothing here is random.
 */
#include "base/utf8.h"
#include "check.h"

static void test_well_formed(void)
{
    static const char *const good[][4] = {
        {"a", "\x7f", "\x01", "~"},
        {"\xc2\x80", "\xdf\xbf", "\xc3\xb6", "\xd0\x96"},
        {"\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80", "\xef\xbf\xbf"},
        {"\xf0\x90\x80\x80", "\xf3\xbf\xbf\xbf", "\xf4\x8f\xbf\xbf",
         "\xf1\x80\x80\x80"}};
    for (size_t n = 1; n <= 4; ++n) {
        for (size_t i = 0; i < 4; ++i) {
            CHECK(murk_utf8_length(good[n - 1][i]) == n);
        }
    }
}

static void test_ill_formed(void)
{
    static const char *const bad[] = {
        "\x80",         "\xbf",         "\xc0\x80",         "\xc1\xbf",
        "\xc2",         "\xc2\x41",     "\xe0\x9f\xbf",     "\xed\xa0\x80",
        "\xe1\x80",     "\xe1\x80\xc0", "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80",
        "\xf5\x80\x80", "\xff",         "\xf1\x80\x80"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        CHECK(murk_utf8_length(bad[i]) == 0);
        CHECK(!murk_utf8_is_printable(bad[i], 9));
    }
}

static void test_printable(void)
{
    CHECK(murk_utf8_is_printable("", 9));
    CHECK(murk_utf8_is_printable("a \xc3\xb6", 9));
    CHECK(!murk_utf8_is_printable("a\n", 9));
    CHECK(!murk_utf8_is_printable("a\x7f", 9));
    CHECK(murk_utf8_is_printable("\xc3\xb6\n", 1));
    CHECK(!murk_utf8_is_printable("\xc3\xb6\n", 2));
}

int main(void)
{
    test_well_formed();
    test_ill_formed();
    test_printable();
    return check_done();
}
