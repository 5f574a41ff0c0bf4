/* Units of heights. */
#ifndef MURK_TERRAIN_UNITS_H
#define MURK_TERRAIN_UNITS_H

/* International foot, and the foot of the survey of the USA (NIST SP 447, 1975)
 * [m]. */
#define MURK_FOOT_M    0.3048
#define MURK_US_FOOT_M (1200. / 3937)

#endif
