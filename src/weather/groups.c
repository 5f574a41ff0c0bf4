/* Cuts the text of a weather report into groups, and compares groups with
 * patterns of digits and letters. */
#include "weather/groups.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "base/words.h"

murk_status murk_groups_cut(murk_groups *out, const char *text,
                            const char *where, murk_error *err)
{
    static const char allowed[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/+-=$., \t\r\n";
    const size_t length = strlen(text), good = strspn(text, allowed);
    char *rest = NULL;
    out->n = 0;
    /* Refuse what no report has, then cut. */
    if (length > MURK_REPORT_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "a report of %zu characters, must be at most %d",
                         length, MURK_REPORT_MAX);
    }
    if (good < length) {
        char shown[24];
        murk_words_show(shown, sizeof shown, text + good);
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "'%s' in a weather report, which has capital letters, "
                         "digits and signs only",
                         shown);
    }
    memcpy(out->text, text, length + 1);
    /* The sign = ends a report. */
    char *end = strchr(out->text, '=');
    if (end && strspn(end, "= \t\r\n") != strlen(end)) {
        return murk_fail(
            err, MURK_BAD_VALUE, where,
            "text behind the = that ends a weather report, must be "
            "one report");
    }
    for (char *g = strtok_r(out->text, " \t\r\n=", &rest); g;
         g = strtok_r(NULL, " \t\r\n=", &rest)) {
        if (out->n == MURK_GROUPS_MAX) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "more than %d groups in a weather report",
                             MURK_GROUPS_MAX);
        }
        out->group[out->n++] = g;
    }
    for (size_t i = out->n; i <= MURK_GROUPS_MAX; ++i) {
        out->group[i] = "";
    }
    return MURK_OK;
}

bool murk_group_is(const char *text, const char *pattern)
{
    for (; *pattern; ++pattern, ++text) {
        const unsigned char c = (unsigned char)*text;
        const bool fits = *pattern == '0'   ? isdigit(c) != 0
                          : *pattern == 'A' ? isupper(c) != 0
                          : *pattern == '?' ? isdigit(c) || c == '/'
                                            : *text == *pattern;
        if (!fits) {
            return false;
        }
    }
    return *text == '\0';
}

int murk_group_number(const char *digits, size_t n)
{
    int number = 0;
    for (size_t i = 0; i < n; ++i) {
        number = 10 * number + (digits[i] - '0');
    }
    return number;
}

murk_status murk_group_fail(const murk_groups *groups, size_t k,
                            const char *format, const char *must,
                            const char *where, murk_error *err)
{
    char shown[40];
    if (groups->n == 0) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "an empty %s report, must have %s", format, must);
    }
    if (k >= groups->n) {
        murk_words_show(shown, sizeof shown, groups->group[groups->n - 1]);
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "a %s report ends behind '%s', must go on with %s",
                         format, shown, must);
    }
    murk_words_show(shown, sizeof shown, groups->group[k]);
    return murk_fail(err, MURK_BAD_VALUE, where,
                     "'%s' in a %s report, must be %s", shown, format, must);
}

void murk_group_append(char *to, const char *group)
{
    const size_t length = strlen(to);
    if (length + 1 + strlen(group) < MURK_WEATHER_GROUPS_SIZE) {
        snprintf(to + length, MURK_WEATHER_GROUPS_SIZE - length, "%s%s",
                 length > 0 ? " " : "", group);
    }
}
