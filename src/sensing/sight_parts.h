/* What a murk_sight is made of; inside this room only. */
#ifndef MURK_SENSING_SIGHT_PARTS_H
#define MURK_SENSING_SIGHT_PARTS_H

#include "sensing/power.h"
#include "sensing/refract.h"
#include "sensing/sight.h"

/* A worker's room for what it sees. */
typedef struct murk_scratch {
    uint32_t *photon;  /* numbers of photons */
    uint16_t *clarity; /* NULL where all is clear */
} murk_scratch;

struct murk_sight {
    murk_sight_desc desc;
    murk_sensor_type *type; /* [desc.types] */
    murk_media **accepting; /* [desc.types] the media as the type sees them;
                               NULL: as they are */
    double max_m;           /* nothing is farther from anything */
    double position_error_m;
    bool has_media;
    bool has_sheets;             /* that let light through */
    bool has_interfaces;         /* where the index changes */
    murk_interfaces *interfaces; /* to see through; NULL: not wanted, or none */
    murk_power *power;           /* NULL: clarity is by transmittance */
    /* The clarity, 0..1, of a transmittance; NULL: the transmittance. */
    double (*detect)(const murk_sight_desc *desc, double transmittance);
    uint32_t *weight;
    uint64_t *regions; /* of interest, [photons]; NULL: none */
    size_t photons;
    murk_scratch *worker;                      /* [threads] */
    murk_photon_map *own_surface, *own_volume; /* NULL: of others */
    murk_tally queries, shadow_rays, blocked_by_interfaces, totally_reflected;
};

/* The clarity of a sightline that lets so much through. */
static inline uint16_t murk_sight_clarity(const murk_sight *sight,
                                          double through)
{
    const double detected =
        sight->detect ? sight->detect(&sight->desc, through) : through;
    return (uint16_t)floor(detected * MURK_CLEAR + 0.5);
}

#endif
