/* Notes of many rows are said once, whatever their numbers. */
#include "app/log_once.h"
#include "check.h"

static void check_news(murk_log_once *told, const char *notes, const char *want)
{
    char out[64];
    CHECK(murk_log_once_news(told, notes, out, sizeof out) == (*want != '\0'));
    CHECK_TEXT(out, want);
}

int main(void)
{
    murk_log_once told = {0};
    check_news(&told, "", "");
    check_news(&told, "12 photons lost", "12 photons lost");
    check_news(&told, "3.5 photons lost", "");
    check_news(&told, "-7 photons lost; the sun is down", "the sun is down");
    check_news(&told, "a 1; b 2; a 3", "a 1; b 2");
    check_news(&told, "photons lost; A 1",
               "photons lost; A 1"); /* blanks count */
    check_news(&told, "the sun is down; b 9", "");
    CHECK(told.n == 6);
    murk_log_once_release(&told);
    CHECK(told.n == 0 && told.text == NULL);
    check_news(&told, "b 9", "b 9");
    murk_log_once_release(&told);
    return check_done();
}
