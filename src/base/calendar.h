/* Dates and times as people write them (ISO 8601, Gregorian calendar) and as
 * ephemerides need them (Julian dates).
 *
 * Seconds are counted from 1970-01-01T00:00:00 UTC without leap seconds, as
 * POSIX does. */
#ifndef MURK_BASE_CALENDAR_H
#define MURK_BASE_CALENDAR_H

#include <stdbool.h>

typedef struct murk_date {
    int year, month, day; /* 0..9999, 1..12, 1..31 */
} murk_date;

/* Conversion between dates of the proleptic Gregorian calendar and days.
 * murk_date_of_days() rounds `days` down to a whole number. */
double murk_date_days(murk_date date); /* since 1970-01-01, whole, negative
                                        * before */
murk_date murk_date_of_days(double days);

/* Each of the functions murk_..._read() reads the whole text. If the text is
 * malformed, the function returns false and leaves the results unchanged.
 *
 * A date: "2026-06-21". */
bool murk_date_read(const char *text, murk_date *out);
/* A clock time in seconds since midnight: "06:00", "06:00:30", "06:00:30.5", up
 * to "24:00". */
bool murk_clock_read(const char *text, double *seconds);
/* A time zone in minutes east of Greenwich: "Z", "+02:00", "-0330", "+5". The
 * hours are 0..18, the minutes 0..59. */
bool murk_zone_read(const char *text, int *minutes);
/* A date with a clock time, with or without a zone: "2026-06-21T12:00:00Z",
 * "2026-06-21 12:00+02:00". *local_s are the seconds from 1970-01-01T00:00:00
 * in the same zone; UTC is *local_s - 60 *zone_min. *zone_min is 0 if the text
 * has no zone. */
bool murk_time_read(const char *text, double *local_s, bool *has_zone,
                    int *zone_min);

/* The Julian date (UTC) of a number of seconds since 1970-01-01T00:00:00 UTC.
 */
double murk_julian_date(double unix_s);

/* Prints the local time in a zone zone_min minutes east of Greenwich as
 * "2026-06-21T14:00:00+02:00", or with Z for zone_min 0. Seconds are rounded.
 * The longest such text has 25 characters; the buffer leaves space for years of
 * more than four digits. */
#define MURK_TIME_SIZE 40
void murk_time_print(char out[MURK_TIME_SIZE], double unix_s, int zone_min);

#endif
