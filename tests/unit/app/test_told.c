/* Notes of many rows are said once, whatever their numbers. */
#include "app/told.h"
#include "check.h"

static void check_news(murk_told *told, const char *notes, const char *want)
{
    char out[64];
    CHECK(murk_told_news(told, notes, out, sizeof out) == (*want != '\0'));
    CHECK_TEXT(out, want);
}

int main(void)
{
    murk_told told = {0};
    check_news(&told, "", "");
    check_news(&told, "12 photons lost", "12 photons lost");
    check_news(&told, "3.5 photons lost", "");
    check_news(&told, "-7 photons lost; the sun is down", "the sun is down");
    check_news(&told, "a 1; b 2; a 3", "a 1; b 2");
    check_news(&told, "photons lost; A 1",
               "photons lost; A 1"); /* blanks count */
    check_news(&told, "the sun is down; b 9", "");
    CHECK(told.n == 6);
    murk_told_release(&told);
    CHECK(told.n == 0 && told.text == NULL);
    check_news(&told, "b 9", "b 9");
    murk_told_release(&told);
    return check_done();
}
