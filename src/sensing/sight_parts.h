/* The members of a murk_sight. For use inside src/sensing only. */
#ifndef MURK_SENSING_SIGHT_PARTS_H
#define MURK_SENSING_SIGHT_PARTS_H

#include "sensing/power.h"
#include "sensing/refract.h"
#include "sensing/sight.h"

/* The scratch buffers of a worker for one row. */
typedef struct murk_scratch {
    uint32_t *photon;       /* indices of photons */
    uint16_t *clarity;      /* NULL if all entries are MURK_CLEAR */
    murk_row_counts counts; /* sightlines of the row */
} murk_scratch;

struct murk_sight {
    murk_sight_desc desc;
    murk_sensor_type *type; /* [desc.types] */
    murk_media *
        *accepting; /* [desc.types] media with the type's acceptance of forward
                       scattered light; NULL: the media themselves */
    double max_m;   /* longer than any distance in the domain */
    double position_error_m;
    bool has_media;
    bool has_sheets;     /* sheets that transmit light */
    bool has_interfaces; /* the refractive index changes somewhere */
    murk_interfaces
        *interfaces; /* boundaries that refract sightlines; NULL: refraction is
                        not requested, no region has a refractive index, or
                        shadow rays are not used */
    murk_power *power; /* NULL: the clarity follows from the transmittance */
    /* The clarity, 0..1, for a transmittance; NULL: the transmittance itself.
     */
    double (*detect)(const murk_sight_desc *desc, double transmittance);
    uint32_t *weight;
    uint64_t *regions; /* [photons] regions of interest; NULL: none */
    size_t photons;
    murk_scratch *worker; /* [threads] */
    murk_photon_map *own_surface,
        *own_volume; /* NULL: the maps belong to others */
    murk_tally queries, shadow_rays, blocked_by_interfaces, totally_reflected,
        reused;
};

/* The largest of redundancy, at_least and 1: the sum of the weights times this
 * number has an upper limit (murk_photon_weights()). */
static inline unsigned murk_sight_layers_max(const murk_sight_desc *desc)
{
    const unsigned maximum =
        desc->redundancy > desc->at_least ? desc->redundancy : desc->at_least;
    return maximum > 1 ? maximum : 1;
}

/* The clarity of a sightline with this transmittance (with detection by power:
 * with this detection probability), rounded to a whole number, MURK_CLEAR
 * for 1. */
static inline uint16_t murk_sight_clarity(const murk_sight *sight,
                                          double through)
{
    const double detected =
        sight->detect ? sight->detect(&sight->desc, through) : through;
    return (uint16_t)floor(detected * MURK_CLEAR + 0.5);
}

#endif
