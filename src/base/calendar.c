/* Reads and prints dates and clock times, and converts them to days and
 * seconds.
 *
 * A date becomes a day number by counting years from March, so that the leap
 * day is the last day of a year. Parsing takes one field after the other from
 * the text; a function that reads a whole text accepts nothing behind the last
 * field. */
#include "base/calendar.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DAY_S 86400.0 /* without leap seconds */

/* The Julian date of the Unix epoch, 1970-01-01T00:00 UTC. */
#define JULIAN_1970 2440587.5

/* Time zones on the earth lie within -12 and +14 hours; this limit leaves some
 * margin. */
#define ZONE_HOURS_MAX 18

/* Reads exactly n digits at *text and moves *text behind them. Returns false
 * and changes nothing if there are fewer. */
static bool digits(const char **text, int n, int *out)
{
    int value = 0;
    for (int i = 0; i < n; ++i) {
        const char c = (*text)[i];
        if (c < '0' || c > '9') {
            return false;
        }
        value = 10 * value + (c - '0');
    }
    *text += n;
    *out = value;
    return true;
}

static bool is_leap(int year)
{
    return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
}

static int days_in_month(int year, int month)
{
    /* The days of each month in a year that is no leap year. */
    static const int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    return days[month - 1] + (month == 2 && is_leap(year));
}

/* Counts months m from March, m = 0, so that the leap day is the last day of a
 * year. The days before month m are then (153 m + 2) / 5, rounded down. */
double murk_date_days(murk_date date)
{
    const int year = date.year - (date.month <= 2);
    const int month = (date.month + 9) % 12;
    const double days_before_month = floor((153.0 * month + 2) / 5);
    const double leaps =
        floor(year / 4.0) - floor(year / 100.0) + floor(year / 400.0);
    const double days_0000_03_01_to_1970 = 719468;
    return 365.0 * year + leaps + days_before_month + date.day - 1 -
           days_0000_03_01_to_1970;
}

murk_date murk_date_of_days(double days)
{
    /* Estimate the year by the mean length of a Gregorian year. The estimate
     * may be one year early or late, which the loops correct. */
    murk_date date = {1970 + (int)floor(days / 365.2425), 1, 1};
    while (murk_date_days(date) > days) {
        --date.year;
    }
    while (murk_date_days((murk_date){date.year + 1, 1, 1}) <= days) {
        ++date.year;
    }
    while (date.month < 12 &&
           murk_date_days((murk_date){date.year, date.month + 1, 1}) <= days) {
        ++date.month;
    }
    date.day = 1 + (int)(days - murk_date_days(date));
    return date;
}

static bool take_date(const char **text, murk_date *out)
{
    murk_date d;
    const char *t = *text;
    if (!digits(&t, 4, &d.year) || *t++ != '-' || !digits(&t, 2, &d.month) ||
        *t++ != '-' || !digits(&t, 2, &d.day)) {
        return false;
    }
    if (d.month < 1 || d.month > 12 || d.day < 1 ||
        d.day > days_in_month(d.year, d.month)) {
        return false;
    }
    *text = t;
    *out = d;
    return true;
}

static bool take_clock(const char **text, double *seconds)
{
    /* Hours and minutes, then optional seconds with an optional fraction. */
    const char *t = *text;
    int hours, minutes, whole = 0;
    double part = 0;
    if (!digits(&t, 2, &hours) || *t++ != ':' || !digits(&t, 2, &minutes)) {
        return false;
    }
    if (*t == ':') {
        ++t;
        if (!digits(&t, 2, &whole)) {
            return false;
        }
        if (*t == '.') {
            double place = 0.1;
            int digit;
            ++t;
            if (!digits(&t, 1, &digit)) {
                return false;
            }
            do {
                part += place * digit;
                place /= 10;
            } while (digits(&t, 1, &digit));
        }
    }
    /* Refuse minutes and seconds above 59, and clock times past 24:00. */
    const double all = 3600.0 * hours + 60.0 * minutes + whole + part;
    if (minutes > 59 || whole > 59 || all > DAY_S) {
        return false;
    }
    *text = t;
    *seconds = all;
    return true;
}

static bool take_zone(const char **text, int *minutes)
{
    const char *t = *text;
    int hours, rest = 0;
    if (*t == 'Z' || *t == 'z') {
        *text = t + 1;
        *minutes = 0;
        return true;
    }
    /* A sign and one or two digits of hours. */
    const int sign = *t == '-' ? -1 : 1;
    if (*t != '+' && *t != '-') {
        return false;
    }
    ++t;
    if (!digits(&t, 2, &hours) && !digits(&t, 1, &hours)) {
        return false;
    }
    /* Optional minutes, with or without a colon. */
    if (*t == ':') {
        ++t;
        if (!digits(&t, 2, &rest)) {
            return false;
        }
    } else {
        (void)digits(&t, 2, &rest);
    }
    if (hours > ZONE_HOURS_MAX || rest > 59) {
        return false;
    }
    *text = t;
    *minutes = sign * (60 * hours + rest);
    return true;
}

bool murk_date_read(const char *text, murk_date *out)
{
    murk_date date;
    if (!take_date(&text, &date) || *text) {
        return false;
    }
    *out = date;
    return true;
}

bool murk_clock_read(const char *text, double *seconds)
{
    double found;
    if (!take_clock(&text, &found) || *text) {
        return false;
    }
    *seconds = found;
    return true;
}

bool murk_zone_read(const char *text, int *minutes)
{
    int found;
    if (!take_zone(&text, &found) || *text) {
        return false;
    }
    *minutes = found;
    return true;
}

bool murk_time_read(const char *text, double *local_s, bool *has_zone,
                    int *zone_min)
{
    murk_date date;
    double seconds;
    int zone = 0;
    if (!take_date(&text, &date) || (*text != 'T' && *text != ' ')) {
        return false;
    }
    ++text;
    if (!take_clock(&text, &seconds)) {
        return false;
    }
    const bool with_zone = *text != '\0';
    if (with_zone && (!take_zone(&text, &zone) || *text)) {
        return false;
    }
    *local_s = DAY_S * murk_date_days(date) + seconds;
    *has_zone = with_zone;
    *zone_min = zone;
    return true;
}

double murk_julian_date(double unix_s)
{
    return JULIAN_1970 + unix_s / DAY_S;
}

void murk_time_print(char out[MURK_TIME_SIZE], double unix_s, int zone_min)
{
    const double local = floor(unix_s + 60.0 * zone_min + 0.5);
    const double days = floor(local / DAY_S);
    const murk_date date = murk_date_of_days(days);
    const int seconds = (int)(local - days * DAY_S);
    const int zone = abs(zone_min);
    char offset[16] = "Z";
    if (zone_min != 0) {
        snprintf(offset, sizeof offset, "%c%02d:%02d", zone_min < 0 ? '-' : '+',
                 zone / 60 % 100, zone % 60);
    }
    snprintf(out, MURK_TIME_SIZE, "%04d-%02d-%02dT%02d:%02d:%02d%s", date.year,
             date.month, date.day, seconds / 3600, seconds / 60 % 60,
             seconds % 60, offset);
}
