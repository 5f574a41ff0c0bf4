/* One stored photon of either map: 32 bytes. */
#ifndef MURK_PHOTONMAP_PHOTON_H
#define MURK_PHOTONMAP_PHOTON_H

#include "base/vector.h"

#include <stdint.h>

typedef struct murk_photon {
    float position_m[3];
    uint32_t direction; /* incoming, of travel: murk_direction_pack() */
    uint32_t normal;    /* faces the arriving photon; 0 in the volume map */
    float power_w;      /* what leaves the event */
    uint32_t emitted;   /* index of the emitted photon: < 2^32 */
    uint8_t band, light;
    uint8_t material; /* or medium */
    uint8_t kind;     /* murk_photon_kind() of map and event class */
} murk_photon;

_Static_assert(sizeof(murk_photon) == 32, "a record is 32 bytes");

/* kind = (volume ? 4 : 0) + event class (0 first, 1 specular only, 2 later). */
static inline uint8_t murk_photon_kind(int is_volume, int event_class)
{
    return (uint8_t)((is_volume ? 4 : 0) + event_class);
}
static inline int murk_photon_is_volume(const murk_photon *p)
{
    return p->kind >= 4;
}
static inline int murk_photon_class(const murk_photon *p)
{
    return p->kind & 3;
}
static inline murk_vec3 murk_photon_place(const murk_photon *p)
{
    return murk_vec((double)p->position_m[0], (double)p->position_m[1],
                    (double)p->position_m[2]);
}

/* A unit vector as two 16-bit octahedral coordinates: axis directions are
 * exact, the others within MURK_DIRECTION_ERROR_RAD, 3 / (sqrt(2) 32767)
 * rounded up (derived in photon.c). No direction packs to 0, which is left to
 * the zero vector and to what is not finite; 0 unpacks to the zero vector.
 * Source: Cigolle et al., J. Comput. Graph. Tech. 3 (2014) 1. */
#define MURK_DIRECTION_ERROR_RAD 6.48e-5
uint32_t murk_direction_pack(murk_vec3 unit);
murk_vec3 murk_direction_unpack(uint32_t packed);

#endif
