/* The record of a stored photon, 32 bytes, the same in the surface map and the
 * volume map.
 *
 * Files outside src/photonmap make a record by murk_photon_make(), read it by
 * the functions below and change it by murk_photon_set_...(), so that only
 * src/photonmap knows how a record is stored. */
#ifndef MURK_PHOTONMAP_PHOTON_H
#define MURK_PHOTONMAP_PHOTON_H

#include "base/vector.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct murk_photon {
    float position_m[3];
    uint32_t direction; /* direction of travel of the incoming photon:
                         * murk_direction_pack() */
    uint32_t normal;    /* on the side from which the photon came; 0 in the
                         * volume map */
    float power_w;      /* power that leaves the event */
    uint32_t emitted;   /* index of the emitted photon, < 2^32 */
    uint8_t band, light;
    uint8_t material; /* number of the material, or of the medium */
    uint8_t kind;     /* murk_photon_kind() of the map and the event class */
} murk_photon;

_Static_assert(sizeof(murk_photon) == 32, "a record is 32 bytes");

/* The kind of a record: (volume ? 4 : 0) + event class (0 first, 1 specular
 * only, 2 later). */
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
/* Map and event class in one number: 0..2 surface, 4..6 volume. */
static inline uint8_t murk_photon_tag(const murk_photon *p)
{
    return p->kind;
}
static inline murk_vec3 murk_photon_place(const murk_photon *p)
{
    return murk_vec((double)p->position_m[0], (double)p->position_m[1],
                    (double)p->position_m[2]);
}
static inline double murk_photon_power_w(const murk_photon *p)
{
    return (double)p->power_w;
}
static inline uint32_t murk_photon_emitted(const murk_photon *p)
{
    return p->emitted;
}
static inline uint8_t murk_photon_band(const murk_photon *p)
{
    return p->band;
}
static inline uint8_t murk_photon_light(const murk_photon *p)
{
    return p->light;
}
/* Of a surface record the number of the material, of a volume record that of
 * the medium. */
static inline uint8_t murk_photon_material(const murk_photon *p)
{
    return p->material;
}
/* The normal as packed by murk_direction_pack(): equal numbers are equal
 * normals, and 0 is no normal. The same holds for the direction. */
static inline uint32_t murk_photon_packed_normal(const murk_photon *p)
{
    return p->normal;
}
static inline uint32_t murk_photon_packed_direction(const murk_photon *p)
{
    return p->direction;
}

/* Packs a unit vector into two 16-bit octahedral coordinates. Directions along
 * the axes are exact, all others are within MURK_DIRECTION_ERROR_RAD, which is
 * 3 / (sqrt(2) 32767) rounded up (derived in photon.c). No direction packs to
 * 0: the value 0 is reserved for the zero vector and for vectors that are not
 * finite, and unpacks to the zero vector. Source: Cigolle et al., J. Comput.
 * Graph. Tech. 3 (2014) 1. */
#define MURK_DIRECTION_ERROR_RAD 6.48e-5
static inline uint32_t murk_direction_pack(murk_vec3 unit);
murk_vec3 murk_direction_unpack(uint32_t packed);

/* The direction of travel of the incoming photon: unit, or zero if none was
 * given. */
static inline murk_vec3 murk_photon_direction(const murk_photon *p)
{
    return murk_direction_unpack(p->direction);
}
/* The normal on the side from which the photon came: unit; zero in the volume
 * map, or if none was given. */
static inline murk_vec3 murk_photon_normal(const murk_photon *p)
{
    return murk_direction_unpack(p->normal);
}

/* The values of a record before they are stored. */
typedef struct murk_photon_values {
    murk_vec3 position_m;
    murk_vec3 direction, normal; /* unit, or zero: none */
    double power_w;
    uint32_t emitted;
    uint8_t band, light, material;
    bool is_volume;
    int event_class; /* 0 first, 1 specular only, 2 later */
} murk_photon_values;

static inline murk_photon murk_photon_make(const murk_photon_values *values);

static inline void murk_photon_set_power_w(murk_photon *p, double power_w)
{
    p->power_w = (float)power_w;
}
static inline void murk_photon_set_emitted(murk_photon *p, uint32_t emitted)
{
    p->emitted = emitted;
}
static inline void murk_photon_set_material(murk_photon *p, uint8_t material)
{
    p->material = material;
}

/* ---- packing, inline because every stored photon takes it ---- */

#define MURK_DIRECTION_STEPS  32767.0 /* 2^15 - 1: 16 bits with a sign */
#define MURK_DIRECTION_OFFSET 32768   /* coordinates are 1..65535, never 0 */

/* Added to a number below 2^51, it moves all digits after the point beyond the
 * 52 bits of the mantissa, so that the sum is rounded as by nearbyint(), which
 * is a call for processors before SSE4. */
#define MURK_DIRECTION_ROUNDS 0x1.8p52

static inline double murk_direction_fold(double along, double across)
{
    return copysign(1 - fabs(across), along);
}

static inline uint32_t murk_direction_quantize(double coordinate)
{
    return (uint32_t)((int)(coordinate * MURK_DIRECTION_STEPS +
                            MURK_DIRECTION_ROUNDS - MURK_DIRECTION_ROUNDS) +
                      MURK_DIRECTION_OFFSET);
}

static inline uint32_t murk_direction_pack(murk_vec3 unit)
{
    const double norm = fabs(unit.x) + fabs(unit.y) + fabs(unit.z);
    if (!(norm > 0 && isfinite(norm))) {
        return 0;
    }
    const double u = unit.x / norm, v = unit.y / norm;
    const bool is_lower = unit.z < 0;
    return murk_direction_quantize(is_lower ? murk_direction_fold(u, v) : u) |
           murk_direction_quantize(is_lower ? murk_direction_fold(v, u) : v)
               << 16;
}

static inline murk_photon murk_photon_make(const murk_photon_values *v)
{
    const murk_vec3 at = v->position_m;
    return (murk_photon){
        .position_m = {(float)at.x, (float)at.y, (float)at.z},
        .direction = murk_direction_pack(v->direction),
        .normal = v->is_volume ? 0 : murk_direction_pack(v->normal),
        .power_w = (float)v->power_w,
        .emitted = v->emitted,
        .band = v->band,
        .light = v->light,
        .material = v->material,
        .kind = murk_photon_kind(v->is_volume, v->event_class)};
}

#endif
