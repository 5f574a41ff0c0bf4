/* Light that has been reflected or scattered before, from the photon maps: the
 * records that are not first events, by density estimate.
 *
 * The kernel is even: on a surface the disc, in a medium the ball that reaches
 * to the k-th nearest record, which itself does not count. Records are of the
 * same band; on surfaces those count whose normal is within 60 degrees of the
 * place's. A record's power is what leaves its event, so no reflectance and no
 * albedo is applied again.
 *
 * First events are direct light, which shadow rays find; those of lights that
 * no shadow ray finds (light/shine.h) stay with the maps.
 *
 * Source: Jensen, Realistic Image Synthesis Using Photon Mapping, 2001, ch. 7
 * and 10; k - 1 of k: Loftsgaarden and Quesenberry, Ann. Math. Statist. 36
 * (1965) 1049, doi:10.1214/aoms/1177700079. */
#ifndef MURK_RENDER_GATHER_H
#define MURK_RENDER_GATHER_H

#include "photonmap/map.h"
#include "render/direct.h"

#define MURK_GATHER_MAX 1000

typedef struct murk_gather murk_gather;

/* Both maps are copied as far as they are used. k: 2..MURK_GATHER_MAX. *out is
 * the caller's. Fails with MURK_NO_MEMORY. */
murk_status murk_gather_create(murk_gather **out, const murk_world *world,
                               const murk_photon_map *surface,
                               const murk_photon_map *volume, size_t k,
                               unsigned threads, murk_error *err);
void murk_gather_destroy(murk_gather *gather); /* NULL is fine */

typedef struct murk_gathered {
    double radiance; /* [W/m2/sr] towards who looks, over the index squared; of
                        a medium: for each metre of the way, [W/m3/sr] */
    double variance; /* of it, by the records' number */
} murk_gathered;

/* At a place of a surface or, where it has a phase function, of a medium. */
murk_gathered murk_gather_light(const murk_gather *gather,
                                const murk_place *place);

#endif
