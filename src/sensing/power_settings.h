/* The settings of detection by power (sensing/power.h). */
#ifndef MURK_SENSING_POWER_SETTINGS_H
#define MURK_SENSING_POWER_SETTINGS_H

#include "base/bands.h"
#include "base/status.h"
#include "base/vector.h"
#include "photonmap/map.h"

/* A place with fewer photons in the estimate is judged badly: the relative
 * error is 1 / sqrt(10 - 2), a third, or more. */
#define MURK_POWER_FEW 10

/* The stored light, and the number of emitted photons. */
typedef struct murk_power_light {
    const murk_photon_map *surface_map, *volume_map;
    uint64_t photons_emitted;
} murk_power_light;

/* Settings of detection by power. */
typedef struct murk_power_settings {
    double radius_m;   /* 0: not by power */
    size_t neighbours; /* see murk_power_desc */
    double band_nm[MURK_BANDS_MAX];
    murk_power_light light; /* maps NULL: those of the sight */
} murk_power_settings;

/* Fails with MURK_BAD_VALUE at `where` unless the radius is above 0 and, in a
 * periodic domain, at most half a period. */
murk_status murk_power_check_radius(double radius_m, const murk_domain *domain,
                                    const char *where, murk_error *err);

#endif
