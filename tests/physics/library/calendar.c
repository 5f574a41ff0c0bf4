/* Julian dates of civil times with time zones, against the examples of Meeus
 * (1998) and of NREL's solar position algorithm. */
#include "base/calendar.h"
#include "library/library.h"

static double julian(const char *text)
{
    double local = 0;
    bool has_zone;
    int zone = 0;
    (void)murk_time_read(text, &local, &has_zone, &zone);
    return murk_julian_date(local - 60.0 * zone);
}

void murk_library_calendar(murk_library *library)
{
    const char *meeus = "Meeus 1998, Astronomical Algorithms, ch. 7";
    murk_library_title(library, "Calendar",
                       "Julian dates of civil times, from noon to noon.");
    murk_library_row(library, "1957-10-04T19:26:24Z", "d", 2436116.31,
                     julian("1957-10-04T19:26:24Z"), 5e-7, "exact but rounding",
                     meeus);
    murk_library_row(library, "2000-01-01T12:00:00Z", "d", 2451545.0,
                     julian("2000-01-01T12:00:00Z"), 5e-7, "exact but rounding",
                     meeus);
    murk_library_row(library, "2003-10-17T12:30:30-07:00", "d", 2452930.313,
                     julian("2003-10-17T12:30:30-07:00"), 5e-4,
                     "last digit printed", "NREL/TP-560-34302, A.5");
}
