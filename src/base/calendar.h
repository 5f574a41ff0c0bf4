/* Dates and times as people write them (ISO 8601, Gregorian calendar) and as
 * ephemerides want them (Julian dates).
 *
 * Seconds are counted from 1970-01-01T00:00:00 UTC without leap seconds, as
 * POSIX does. */
#ifndef MURK_BASE_CALENDAR_H
#define MURK_BASE_CALENDAR_H

#include <stdbool.h>

typedef struct murk_date {
    int year, month, day; /* 0..9999, 1..12, 1..31 */
} murk_date;

/* Of the proleptic Gregorian calendar. */
double murk_date_days(murk_date date); /* since 1970-01-01 */
murk_date murk_date_of_days(double days);

/* Each reads all of the text or says false, and then leaves *out alone:
 * "2026-06-21"; */
bool murk_date_read(const char *text, murk_date *out);
/* "06:00", "06:00:30", "06:00:30.5", up to 24:00, in seconds since midnight; */
bool murk_clock_read(const char *text, double *seconds);
/* "Z", "+02:00", "-0330", "+5", within 18 hours, in minutes east of Greenwich;
 */
bool murk_zone_read(const char *text, int *minutes);
/* "2026-06-21T12:00:00Z", "2026-06-21 12:00+02:00", and without the zone. */
bool murk_time_read(const char *text, double *local_s, bool *has_zone,
                    int *zone_min);

/* Of seconds since 1970, UTC. */
double murk_julian_date(double unix_s);

/* "2026-06-21T14:00:00+02:00"; seconds rounded. */
#define MURK_TIME_SIZE 40
void murk_time_print(char out[MURK_TIME_SIZE], double unix_s, int zone_min);

#endif
