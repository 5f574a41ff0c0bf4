/* Notes of many rows are said once, whatever their numbers. */
#include "api/log_once.h"
#include "check.h"

#include <stdlib.h>

static void check_news(char **seen, const char *notes, const char *want)
{
    char out[64];
    CHECK(murk_log_once_news(seen, notes, out, sizeof out) == (*want != '\0'));
    CHECK_TEXT(out, want);
}

int main(void)
{
    char *seen = NULL;
    check_news(&seen, "", "");
    check_news(&seen, "12 photons lost", "12 photons lost");
    check_news(&seen, "3.5 photons lost", "");
    check_news(&seen, "-7 photons lost; the sun is down", "the sun is down");
    check_news(&seen, "a 1; b 2; a 3", "a 1; b 2");
    check_news(&seen, "photons lost; A 1",
               "photons lost; A 1"); /* blanks count */
    check_news(&seen, "the sun is down; b 9", "");
    free(seen);
    seen = NULL;
    check_news(&seen, "b 9", "b 9");
    free(seen);
    return check_done();
}
