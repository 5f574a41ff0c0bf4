/* Coverage of given places: divides the places into pieces, puts each piece
 * into photon maps of its own, and computes the rows of all sensors for them,
 * one piece a thread (with detection by power, one piece at a time on all
 * threads). So apart from the results memory does not grow with the number of
 * places, and no sum is shared between threads. */
#include "sensing/places_seen.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "base/progress.h"
#include "medium/rescaled.h"
#include "sensing/combined_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Places in a piece: small pieces keep memory low. Detection by power first
 * gathers the light around each place of a piece on all threads, so pieces are
 * large and processed one after the other. */
#define PIECE          8192
#define PIECE_BY_POWER 1048576

typedef struct work {
    const murk_places *places;
    murk_sight_desc sight,
        open; /* sight: the description of the sight of plans, changed for
                 places; sight_onto() puts in the maps of a piece. open: the
                 same without attenuation by the media, for depths */
    const murk_media *media; /* media along unblocked sightlines */
    const murk_pose *pose;
    size_t sensors;
    size_t piece;  /* places in a piece */
    bool is_shown; /* with a progress bar */
    murk_place_seen *out;
    murk_error *error; /* [pieces] */
} work;

/* The places of a piece, as photon maps. The emitted index of a record is the
 * index of the place in the piece. */
typedef struct piece {
    murk_photon_map *surface, *volume;
    size_t first, n;
} piece;

static murk_status no_memory(murk_error *err)
{
    return murk_no_memory(err, "", "to look at places");
}

static murk_status piece_fill(piece *p, const work *w, murk_error *err)
{
    murk_photon *surface = malloc(p->n * sizeof *surface);
    murk_photon *volume = malloc(p->n * sizeof *volume);
    size_t on = 0, in = 0;
    if (!surface || !volume) {
        free(surface);
        free(volume);
        return no_memory(err);
    }
    /* Sort the places into surface and volume records. */
    for (size_t i = 0; i < p->n; ++i) {
        murk_photon record =
            w->places->record(w->places->context, p->first + i);
        murk_photon_set_power_w(&record, 1);
        murk_photon_set_emitted(&record, (uint32_t)i);
        if (murk_photon_is_volume(&record)) {
            volume[in++] = record;
        } else {
            surface[on++] = record;
        }
    }
    murk_status status =
        murk_photon_map_create(&p->surface, surface, on, 1, err);
    if (status) {
        free(volume);
        return status;
    }
    return murk_photon_map_create(&p->volume, volume, in, 1, err);
}

static murk_status sight_onto(murk_sight **out, murk_sight_desc desc,
                              const piece *p, murk_error *err)
{
    desc.surface_map = p->surface;
    desc.volume_map = p->volume;
    desc.photons_emitted = p->n;
    return murk_sight_create(out, &desc, err);
}

static murk_place_seen *place_of(const work *w, const piece *p,
                                 const murk_sight *sight, uint32_t photon)
{
    return &w->out[p->first +
                   murk_photon_emitted(murk_sight_photon(sight, photon))];
}

static murk_status see(const work *w, const piece *p, murk_error *err)
{
    const size_t layers = w->sight.redundancy > 1 ? w->sight.redundancy : 1;
    murk_combined_rows combined = {0};
    murk_sight *sight = NULL;
    murk_status status = sight_onto(&sight, w->sight, p, err);
    if (!status &&
        !murk_combined_rows_init(&combined, p->n, w->sight.combining, layers)) {
        status = no_memory(err);
    }
    /* The row of each sensor; then the combined value of each place. */
    for (size_t k = 0; k < w->sensors && !status; ++k) {
        murk_sparse_row row;
        murk_sight_row(sight, 0, &w->pose[k], &row);
        murk_combined_rows_add(&combined, (uint32_t)k, &row);
        for (size_t i = 0; i < row.seen; ++i) {
            const uint16_t clarity = row.clarity ? row.clarity[i] : MURK_CLEAR;
            murk_place_seen *place = place_of(w, p, sight, row.photon[i]);
            place->clarity = fmaxf(place->clarity, (float)clarity / MURK_CLEAR);
        }
    }
    for (uint32_t i = 0; i < p->n && !status; ++i) {
        murk_place_seen *place = place_of(w, p, sight, i);
        place->sensors = combined.sensors[i];
        place->worth = (float)((double)murk_combined_rows_worth(&combined, i) /
                               (double)(layers * MURK_CLEAR));
    }
    murk_combined_rows_release(&combined);
    murk_sight_destroy(sight);
    return status;
}

/* Sets the depth of each place: the smallest optical depth of the unblocked
 * sightlines of all sensors, or INFINITY if there are none. */
static murk_status measure_depths(const work *w, const piece *p,
                                  murk_error *err)
{
    double *depth = malloc(2 * p->n * sizeof *depth);
    murk_sight *sight = NULL;
    murk_status status =
        depth ? sight_onto(&sight, w->open, p, err) : no_memory(err);
    for (size_t i = 0; i < p->n && !status; ++i) {
        w->out[p->first + i].depth = INFINITY;
    }
    for (size_t k = 0; k < w->sensors && !status; ++k) {
        murk_sparse_row row;
        murk_sight_row(sight, 0, &w->pose[k], &row);
        murk_sight_depths(depth, depth + p->n, sight, &w->pose[k], row.photon,
                          row.seen, &w->media, 1);
        for (size_t i = 0; i < row.seen; ++i) {
            murk_place_seen *place = place_of(w, p, sight, row.photon[i]);
            place->depth = fminf(place->depth, (float)depth[i]);
        }
    }
    murk_sight_destroy(sight);
    free(depth);
    return status;
}

static void see_piece(void *context, uint64_t number)
{
    const work *w = context;
    const size_t first = (size_t)number * w->piece;
    const size_t left = w->places->n - first;
    piece p = {.first = first, .n = left < w->piece ? left : w->piece};
    murk_error *error = &w->error[number];
    memset(&w->out[first], 0, p.n * sizeof *w->out);
    murk_status status = piece_fill(&p, w, error);
    if (!status) {
        status = see(w, &p, error);
    }
    if (!status && w->places->wants_depth) {
        status = measure_depths(w, &p, error);
    }
    murk_photon_map_destroy(p.surface);
    murk_photon_map_destroy(p.volume);
    if (w->is_shown) {
        murk_progress_add(p.n);
    }
}

/* ---- the sight ---- */

/* Copies of the sensor types, changed so that they detect light whatever its
 * direction of travel. */
static murk_sensor_type *any_arrival(const murk_sight_desc *like)
{
    murk_sensor_type *type = malloc(like->types * sizeof *type + 1);
    for (size_t k = 0; type && k < like->types; ++k) {
        type[k] = like->type[k];
        type[k].toward = false;
    }
    return type;
}

static void describe(work *w, const murk_sight *like,
                     const murk_sensor_type *type)
{
    w->sight = *murk_sight_described(like);
    w->sight.type = type;
    w->sight.interest = NULL;
    w->sight.weights = (murk_map_weights){.balanced = true};
    const bool by_power = w->sight.power.radius_m > 0;
    if (by_power && !w->sight.power.light.surface_map) {
        w->sight.power.light =
            (murk_power_light){w->sight.surface_map, w->sight.volume_map,
                               w->sight.photons_emitted};
    }
    w->piece = by_power ? PIECE_BY_POWER : PIECE;
    /* With detection by power, the gathering of light has its own progress bar.
     */
    w->is_shown = w->places->step && !by_power;
    w->sight.threads = by_power ? w->sight.threads : 1;
}

/* The sight of `w->sight` without attenuation by the media, to find the
 * straight unblocked sightlines. The clarity is then the transmittance of the
 * sheets. Acceptance angles and detection by power are left out as well,
 * because both depend on attenuated light. */
static void describe_open(work *w, murk_sensor_type *type,
                          const murk_media *clear)
{
    w->media = w->sight.media;
    w->open = w->sight;
    w->open.media = clear;
    w->open.type = type;
    w->open.refracts = false;
    w->open.detection = MURK_DETECTION_WEIGHTED;
    w->open.combining = MURK_COMBINE_CLEAREST;
    w->open.redundancy = 1;
    w->open.power = (murk_power_settings){0};
    for (size_t k = 0; k < w->open.types; ++k) {
        type[k].acceptance_rad = 0;
    }
}

static murk_status make_clear(murk_media **out, const murk_media *media,
                              murk_error *err)
{
    murk_spectrum *none = calloc(murk_media_count(media) + 1, sizeof *none);
    const murk_status status =
        none ? murk_media_rescale(out, media, none, err) : no_memory(err);
    free(none);
    return status;
}

static murk_status run(work *w, unsigned threads, murk_error *err)
{
    const size_t n = w->places->n;
    const size_t pieces = (n + w->piece - 1) / w->piece;
    w->error = calloc(pieces + 1, sizeof *w->error);
    if (!w->error) {
        return no_memory(err);
    }
    if (w->is_shown) {
        murk_progress_begin(w->places->step, n, "places");
    }
    /* Each thread evaluates one piece at a time, but with detection by power
     * all threads work on one piece. The first error in the order of the pieces
     * is reported. */
    murk_pool_run(w->sight.threads > 1 ? 1 : threads, pieces, see_piece, w);
    if (w->is_shown) {
        murk_progress_end();
    }
    murk_status status = murk_interrupt_check(err);
    for (size_t i = 0; i < pieces && !status; ++i) {
        if (w->error[i].code) {
            status = murk_fail(err, w->error[i].code, w->error[i].where, "%s",
                               w->error[i].text);
        }
    }
    free(w->error);
    return status;
}

murk_status murk_places_see(murk_place_seen *out, const murk_places *places,
                            const murk_sight *like, const murk_pose *pose,
                            size_t n, murk_error *err)
{
    const murk_sight_desc *desc = murk_sight_described(like);
    work w = {.places = places, .pose = pose, .sensors = n, .out = out};
    murk_sensor_type *type = any_arrival(desc);
    murk_sensor_type *open_type = any_arrival(desc);
    murk_media *clear = NULL;
    murk_status status = type && open_type ? MURK_OK : no_memory(err);
    if (!status && places->wants_depth) {
        status = make_clear(&clear, desc->media, err);
    }
    if (!status) {
        describe(&w, like, type);
        describe_open(&w, open_type, clear);
        status = run(&w, desc->threads, err);
    }
    murk_media_destroy(clear);
    free(open_type);
    free(type);
    return status;
}
