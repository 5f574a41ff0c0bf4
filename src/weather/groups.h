/* The groups of a weather report (words between blanks), and numbers in them.
 * For use inside src/weather only. */
#ifndef MURK_WEATHER_GROUPS_H
#define MURK_WEATHER_GROUPS_H

#include "weather/report.h"

#include <stddef.h>

#define MURK_GROUPS_MAX                                  \
    200 /* more than MURK_REPORT_MAX has of usual length \
         */

typedef struct murk_groups {
    char text[MURK_REPORT_MAX + 1]; /* cut into groups */
    size_t n;
    const char *group[MURK_GROUPS_MAX + 1]; /* [n]; "" behind the last */
} murk_groups;

/* Cuts a report into groups, without the sign = at its end. Fails with
 * MURK_BAD_VALUE at `where` if the text is too long or has other characters
 * than reports have. */
murk_status murk_groups_cut(murk_groups *out, const char *text,
                            const char *where, murk_error *err);

/* True if a text has the form of a pattern: 0 stands for a digit, A for a
 * capital letter, / for itself or, with `or_slash`, ? for a digit or a slash;
 * any other character for itself. */
bool murk_group_is(const char *text, const char *pattern);

/* The number in the first n digits of a text. */
int murk_group_number(const char *digits, size_t n);

/* Fails with MURK_BAD_VALUE at `where`: the group k is not as it must be, or
 * the report ends before it. format: METAR or SYNOP. */
murk_status murk_group_fail(const murk_groups *groups, size_t k,
                            const char *format, const char *must,
                            const char *where, murk_error *err);

/* Appends a group to a text of MURK_WEATHER_GROUPS_SIZE bytes, a blank before
 * it; a group that does not fit is left out. */
void murk_group_append(char *to, const char *group);

#endif
