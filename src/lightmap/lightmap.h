/* The light of a scene: surface and volume photon map, energy ledger, tallies,
 * and the power of photon packets.
 *
 * The power of a record is the power that leaves the event. Records stored only
 * when a photon is reflected diffusely or scattered (power after Russian
 * roulette) and records stored at every event (expected power) therefore agree
 * in the mean. */
#ifndef MURK_LIGHTMAP_LIGHTMAP_H
#define MURK_LIGHTMAP_LIGHTMAP_H

#include "lightmap/light_part.h"
#include "lightmap/path_cells.h"
#include "photonmap/map.h"
#include "world/stage.h"

typedef struct murk_traced {
    murk_photon_map *surface, *volume; /* empty maps if not stored; NULL before
                                        * they are filled */
    uint64_t emitted;
    uint32_t seed, stream;
    size_t channels;  /* number of channels; channel light * bands + band is one
                       * band of one light source */
    double *packet_w; /* [channels]: power of one photon packet; 0 for a channel
                       * without photons */
    murk_ledger *ledger;
    murk_path_cells *cells; /* lightmap/light_update.h; NULL: no paths are
                             * noted */
    murk_tallies *tallies; /* NULL if the scene has none, in a stream other than
                            * 0, and in light that was read from a file or
                            * scaled */
    double trace_s, map_s; /* wall-clock times of tracing and of building the
                            * maps, for the results */
} murk_traced;

/* Forecast from a short pilot run. */
typedef struct murk_forecast {
    uint64_t pilot_photons;
    double pilot_s;         /* wall-clock time of the pilot run */
    double surface, volume; /* numbers of records at the end */
    double emitted;         /* photons at the end */
    double memory_bytes;    /* upper limit [bytes] of the memory of tracing and
                             * of both maps, for these numbers of records */
    double scratch_bytes;   /* the same of a scratch file with the records; 0 if
                             * they lie in memory (base/block.h) */
    double escaped_share;   /* share of the emitted power that escapes; 0 if
                             * nothing is emitted */
} murk_forecast;

/* Traces a pilot run of one batch, or of fewer photons if the scene emits
 * fewer, and extrapolates. Without records in the pilot, a scene that asks for
 * a number of records has the forecast 0. Fails as murk_ending_check(), with
 * MURK_NO_MEMORY or with MURK_INTERRUPTED. */
murk_status murk_lightmap_forecast(murk_forecast *out, const murk_stage *stage,
                                   uint32_t stream, unsigned threads,
                                   murk_error *err);

/* Warns if more than half of the emitted power escapes from a scene that has
 * surfaces and lamps, but no sun, sky or other distant light: walls may be
 * missing. murk_lightmap_trace() calls it for the first map; after
 * murk_lightmap_forecast() the caller may. */
void murk_warn_of_escape(const murk_stage *stage, double escaped_share);

/* Traces scene->photons.emit photons, or until scene->photons.store records are
 * stored. A stream is an independent set of photons. Fails before tracing as
 * murk_emission_check() and murk_ending_check(), with MURK_BAD_VALUE if the
 * scene stores records and the forecast exceeds max_stored records or the free
 * memory and disk space of the machine, and, in stream 0, as
 * murk_tallies_of_stage(). Fails later as murk_emission_run(),
 * murk_emission_check_losses() and murk_photon_map_create(). MURK_NO_MEMORY and
 * MURK_INTERRUPTED are possible throughout. The caller owns *out
 * (murk_traced_destroy()). */
murk_status murk_lightmap_trace(murk_traced **out, const murk_stage *stage,
                                uint32_t stream, unsigned threads,
                                murk_error *err);
/* The light of stream 0 of murk_lightmap_trace(). Where that can serve an
 * update (murk_can_watch() in lightmap/watching.h), traced->cells notes the
 * paths of the photons in the cells of a box. */
murk_status murk_lightmap_trace_watched(murk_traced **out,
                                        const murk_stage *stage,
                                        const murk_box *watched,
                                        unsigned threads, murk_error *err);

/* Sets packet_w for the photons that the light has emitted. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_traced_set_powers(murk_traced *traced, const murk_stage *stage,
                                   murk_error *err);

/* The same light from parts of a run, in every bit (lightmap/light_part.h).
 * Batches that no part has are traced. Fails also with MURK_BAD_FILE if the
 * sums of the parts cannot be those of a run. */
murk_status murk_lightmap_merge(murk_traced **out, const murk_stage *stage,
                                const murk_light_parts *parts, unsigned threads,
                                murk_error *err);

/* The light of murk_lightmap_trace() with checkpoints (lightmap/checkpoint.h):
 * goes on from the file `path`, if an earlier run of the same scene left one
 * there, and writes the file every `every_s` seconds, never if 0. The caller
 * removes the file when it has saved the light. Fails also with MURK_BAD_FILE
 * if the sums of the file cannot be those of a run. */
murk_status murk_lightmap_resume(murk_traced **out, const murk_stage *stage,
                                 unsigned threads, const char *path,
                                 double every_s, murk_error *err);

void murk_traced_destroy(murk_traced *traced); /* NULL is fine */

/* As murk_lightmap_trace(), for stream 0, and calls each(context, batch) for
 * the records of each batch, in the order of photons and in the calling thread.
 * The records of a batch may move in memory after the sink returns, so the sink
 * must copy the records that it keeps. The power of the records is in watts if
 * photons.emit gives the number of photons, as later in the maps; with
 * photons.store it is the share of a packet, whose power is known at the end. A
 * failure of the sink ends the trace. */
murk_status murk_lightmap_stream(murk_traced **out, const murk_stage *stage,
                                 unsigned threads, murk_record_batch_sink each,
                                 void *context, murk_error *err);

/* The same for any stream, and no record is kept: both maps stay empty. The
 * sink takes `bytes_each` bytes for each record; the run is refused if that
 * exceeds the free memory. watched: as in murk_lightmap_trace_watched(), or
 * NULL. */
murk_status murk_lightmap_pass(murk_traced **out, const murk_stage *stage,
                               uint32_t stream, unsigned threads,
                               double bytes_each, murk_record_batch_sink each,
                               void *context, const murk_box *watched,
                               murk_error *err);

/* A light without photons and without maps (NULL), to be filled. Returns NULL,
 * with err set, when out of memory. */
murk_traced *murk_traced_create(const murk_stage *stage, uint32_t stream,
                                murk_error *err);

/* Writes light to, and reads it from, a file light.murk, without the tallies.
 * Writing fails as murk_map_file_write() or with MURK_NO_MEMORY. Reading fails
 * with MURK_BAD_VALUE if the light is of a stream other than 0, or if the seed,
 * the local origin, or one of the scene keys and files that light depends on
 * differs from that of the stage; the message names the first difference. It
 * also fails as murk_map_file_read(), and with MURK_BAD_FILE for sections that
 * are missing or that no run can have written, or with MURK_NO_MEMORY. */
murk_status murk_lightmap_save(const murk_traced *traced,
                               const murk_stage *stage, const char *path,
                               murk_error *err);
murk_status murk_lightmap_load(murk_traced **out, const murk_stage *stage,
                               const char *path, unsigned threads,
                               murk_error *err);

/* The settings of the run that wrote a light.murk: the seed, and the number of
 * emitted photons or of stored records, whichever was asked for; the other is
 * 0. emit and store are both 0 if the light key of the file contains neither
 * number. Fails as murk_map_file_read_one(), and with MURK_BAD_FILE for a
 * section "facts" of another size. */
typedef struct murk_lightmap_counts {
    uint32_t seed;
    uint64_t emit, store;
} murk_lightmap_counts;

murk_status murk_lightmap_read_counts(murk_lightmap_counts *out,
                                      const char *path, murk_error *err);

#endif
