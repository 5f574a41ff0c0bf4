/* Light, traced: both photon maps, the ledger, and what a packet is worth.
 *
 * Joins transport's events to the maps' records. A record's power is what
 * leaves its event, so that stored when reflected and stored when hit agree in
 * the mean (contract: Stored). */
#ifndef MURK_LIGHTMAP_LIGHTMAP_H
#define MURK_LIGHTMAP_LIGHTMAP_H

#include "photonmap/map.h"
#include "world/stage.h"

typedef struct murk_traced {
    murk_photon_map *surface, *volume; /* empty where not stored */
    uint64_t emitted;
    uint32_t seed, stream;
    size_t channels;  /* light * bands + band */
    double *packet_w; /* [channels]: power of one packet; 0 without photons */
    murk_ledger *ledger;
    murk_tallies *tallies; /* of stream 0; NULL: none asked for, or light from
                              a file */
    double trace_s, map_s; /* for the run's own record */
} murk_traced;

/* What a short pilot foretells. */
typedef struct murk_forecast {
    uint64_t pilot_photons;
    double surface, volume; /* records at the end */
    double emitted;         /* photons at the end */
    double memory_bytes;    /* most that tracing and both maps take */
    double escaped_share;   /* of the emitted power; 0 where all is dark */
} murk_forecast;

murk_status murk_lightmap_forecast(murk_forecast *out, const murk_stage *stage,
                                   uint32_t stream, unsigned threads,
                                   murk_error *err);

/* Warns where more than half of the power escapes from a scene of lamps and
 * surfaces without sun, sky or other distant light: then walls may be missing.
 * murk_lightmap_trace() does it for the first map, murk_lightmap_forecast()
 * leaves it to the caller. */
void murk_warn_of_escape(const murk_stage *stage, double escaped_share);

/* Traces emit photons, or until `store` are stored. Refused before tracing, by
 * forecast, when more than max_stored records or more memory than the machine
 * has would be needed. *out is the caller's: murk_traced_destroy(). */
murk_status murk_lightmap_trace(murk_traced **out, const murk_stage *stage,
                                uint32_t stream, unsigned threads,
                                murk_error *err);
void murk_traced_destroy(murk_traced *traced); /* NULL is fine */

/* Nothing traced yet and no maps: for murk_lightmap_trace and
 * murk_lightmap_load. NULL, and err filled, when out of memory. */
murk_traced *murk_traced_create(const murk_stage *stage, uint32_t stream,
                                murk_error *err);

/* light.murk. Reading refuses a file whose seed or scene keys that the light
 * depends on differ, and names the first difference. */
murk_status murk_lightmap_save(const murk_traced *traced,
                               const murk_stage *stage, const char *path,
                               murk_error *err);
murk_status murk_lightmap_load(murk_traced **out, const murk_stage *stage,
                               const char *path, unsigned threads,
                               murk_error *err);

/* What a run must ask for to get this light: the seed, and the number of
 * emitted or of stored photons (0: not the one that was asked for). */
typedef struct murk_lightmap_counts {
    uint32_t seed;
    uint64_t emit, store;
} murk_lightmap_counts;

murk_status murk_lightmap_read_counts(murk_lightmap_counts *out,
                                      const char *path, murk_error *err);

#endif
