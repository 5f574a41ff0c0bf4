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

static void check_escaped(const char *text, const char *want)
{
    char out[64];
    CHECK(murk_utf8_escape(out, sizeof out, text) == strlen(want));
    CHECK_TEXT(out, want);
}

static void test_control_characters_are_escaped(void)
{
    check_escaped("", "");
    check_escaped("plain ~ \xc3\xb6 \xe2\x80\x93 \xf0\x9f\x8c\xab",
                  "plain ~ \xc3\xb6 \xe2\x80\x93 \xf0\x9f\x8c\xab");
    check_escaped("\033[2J", "\\x1b[2J");
    check_escaped("a\nb\rc\td", "a\\nb\\rc\\td");
    check_escaped("\x01\x1f\x7f", "\\x01\\x1f\\x7f");
    check_escaped("\xc2\x9b"
                  "31m",
                  "\\xc2\\x9b31m");                   /* CSI beyond ASCII */
    check_escaped("\xc2\xa0", "\xc2\xa0");            /* just beyond C1 */
    check_escaped("\xe2\x80\xae", "\\xe2\\x80\\xae"); /* right to left */
    check_escaped("\xe2\x81\xa6", "\\xe2\\x81\\xa6"); /* isolate */
    check_escaped("\xc3(", "\\xc3(");                 /* cut short */
    check_escaped("\xff", "\\xff");
    CHECK(murk_utf8_control("\xc2\x80") == 0x80);
    CHECK(murk_utf8_control("\xc2\x9f") == 0x9f);
    CHECK(murk_utf8_control("\xe2\x80\xa8") == 0x2028);
    CHECK(murk_utf8_control("~") == 0);
}

/* Cut before the piece that does not fit, and always ended. */
static void test_escaped_text_is_cut_whole(void)
{
    char out[6];
    CHECK(murk_utf8_escape(out, sizeof out, "ab\033c") == 2);
    CHECK_TEXT(out, "ab");
    CHECK(murk_utf8_escape(out, sizeof out, "a\033c") == 5);
    CHECK_TEXT(out, "a\\x1b");
    CHECK(murk_utf8_escape(out, 1, "a") == 0);
    CHECK_TEXT(out, "");
    CHECK(murk_utf8_escape(NULL, 0, "a") == 0);
}

int main(void)
{
    test_control_characters_are_escaped();
    test_escaped_text_is_cut_whole();
    test_well_formed();
    test_ill_formed();
    test_printable();
    return check_done();
}
