/* Weather reports of stations in one line: METAR (aerodromes) and SYNOP (FM-12
 * land stations, FM-13 ships, FM-14 mobile land stations).
 *
 * The observation alone counts: forecasts (TEMPO, BECMG), runway visual ranges
 * and sections 2 to 5 of SYNOP are passed over. A group that is missing
 * (slashes) leaves its number NAN. A group that the reader does not know is
 * named in the observation (`unknown`).
 *
 * Sources: WMO, Manual on Codes, WMO-No. 306, volume I.1 (FM-12, FM-15; tables
 * 1855, 1860, 3590, 4019, 4377, 4677, 4680); U.S. Federal Meteorological
 * Handbook 1, FCM-H1 (statute miles, hourly precipitation, classes of
 * intensity). */
#ifndef MURK_WEATHER_REPORT_H
#define MURK_WEATHER_REPORT_H

#include "base/status.h"
#include "weather/observation.h"

/* Largest length of a report. */
#define MURK_REPORT_MAX 2000

/* Reads a METAR or SPECI. Fails with MURK_BAD_VALUE at `where`, naming the
 * group, if the text is no such report, or the report is NIL. */
murk_status murk_metar_read(murk_observation *out, const char *text,
                            const char *where, murk_error *err);

/* Reads a SYNOP report, which begins with AAXX, BBXX or OOXX. Fails as
 * murk_metar_read() does. */
murk_status murk_synop_read(murk_observation *out, const char *text,
                            const char *where, murk_error *err);

#endif
