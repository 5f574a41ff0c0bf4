/* What a sight needs to judge by power: see sensing/power.h. */
#ifndef MURK_SENSING_POWER_SETTINGS_H
#define MURK_SENSING_POWER_SETTINGS_H

#include "base/bands.h"
#include "base/status.h"
#include "base/vector.h"
#include "photonmap/map.h"

/* A place with fewer photons around it is judged badly: its error is a third or
 * more. */
#define MURK_POWER_FEW 10

/* The light that is stored, and by how many photons. */
typedef struct murk_power_light {
    const murk_photon_map *surface_map, *volume_map;
    uint64_t photons_emitted;
} murk_power_light;

/* What a sight needs to judge by power. */
typedef struct murk_power_settings {
    double radius_m;   /* 0: it does not */
    size_t neighbours; /* as murk_power_desc has both */
    double band_nm[MURK_BANDS_MAX];
    murk_power_light light; /* maps NULL: those looked at */
} murk_power_settings;

/* MURK_BAD_VALUE at `where` unless above 0, and in a periodic domain at most
 * half a period. */
murk_status murk_power_check_radius(double radius_m, const murk_domain *domain,
                                    const char *where, murk_error *err);

#endif
