/* Estimates irradiance on pieces of surfaces from the surface photon map: the
 * stored power over the diffuse coefficient, summed over the photons of a piece
 * and divided by the area of the piece, with the standard error by emitted
 * photon; and the coverage of pieces by sensors. */
#include "results/lit_pieces.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "base/progress.h"
#include "sensing/combined_rows.h"
#include "sensing/places_seen.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define BATCH 4096 /* photons */

/* A point nearer to a side than this share of the largest coordinate of the
 * domain counts as inside. */
#define SIDE_SHARE 0x1p-18

static murk_status no_memory(const murk_pieces *pieces, murk_error *err)
{
    return murk_no_memory(err, "exports", "for %zu pieces", pieces->n);
}

bool murk_piece_is_within(const murk_piece *piece, const murk_domain *domain)
{
    const murk_vec3 p = piece->middle, a = domain->box.min, b = domain->box.max;
    const double tolerance_m =
        SIDE_SHARE * murk_box_largest_coordinate(&domain->box);
    return p.x >= a.x - tolerance_m && p.y >= a.y - tolerance_m &&
           p.z >= a.z - tolerance_m && p.x <= b.x + tolerance_m &&
           p.y <= b.y + tolerance_m && p.z <= b.z + tolerance_m;
}

/* ---- which photon lies on which piece ---- */

typedef struct locating {
    const murk_pieces *pieces;
    const murk_photon *photon;
    size_t n;
    uint32_t *piece;
} locating;

static void locate_batch(void *context, uint64_t batch)
{
    const locating *l = context;
    const size_t first = (size_t)batch * BATCH;
    const size_t end = first + BATCH < l->n ? first + BATCH : l->n;
    for (size_t i = first; i < end; ++i) {
        l->piece[i] =
            murk_pieces_at(l->pieces, murk_photon_place(&l->photon[i]),
                           murk_photon_normal(&l->photon[i]));
    }
    murk_progress_add(end - first);
}

/* Fills (*out)[n] with the piece of each photon of the map. The caller frees
 * *out, also after a failure. */
static murk_status locate(uint32_t **out, const murk_pieces *pieces,
                          const murk_photon_map *map, unsigned threads,
                          murk_error *err)
{
    locating l = {.pieces = pieces,
                  .photon = murk_photon_map_photons(map),
                  .n = murk_photon_map_count(map)};
    *out = l.piece = malloc(l.n * sizeof *l.piece + 1);
    if (!l.piece) {
        return no_memory(pieces, err);
    }
    murk_progress_begin("surfaces", l.n, "photons");
    murk_pool_run(threads, (l.n + BATCH - 1) / BATCH, locate_batch, &l);
    murk_progress_end();
    return murk_interrupt_check(err);
}

/* ---- irradiance ---- */

/* The power that arrived with one record. */
typedef struct arrival {
    uint32_t emitted;
    uint32_t record; /* so that sorting has one result */
    double w;
} arrival;

static int by_emitted(const void *a, const void *b)
{
    const arrival *x = a, *y = b;
    return x->emitted != y->emitted
               ? (x->emitted > y->emitted) - (x->emitted < y->emitted)
               : (x->record > y->record) - (x->record < y->record);
}

typedef struct lighting {
    murk_lit_pieces *out;
    const murk_photon *photon;
    double emitted;
    const uint32_t *order; /* numbers of the records, piece by piece */
    const size_t *begin;   /* [pieces + 1]; index in order[] of the first record
                              of each piece */
    arrival *scratch;      /* as many as the piece with most records has */
} lighting;

/* Computes the irradiance of piece i and the error, from sums over emitted
 * photons. An emitted photon counts once, with the sum of all records that it
 * left on this piece. */
static void light_piece(const lighting *l, size_t i)
{
    const murk_pieces *pieces = l->out->pieces;
    const size_t n = l->begin[i + 1] - l->begin[i];
    const double area_m2 = murk_piece_of(pieces, i).area_m2;
    double sum = 0, squares = 0;
    /* Power that arrived with each record. */
    for (size_t k = 0; k < n; ++k) {
        const uint32_t record = l->order[l->begin[i] + k];
        const murk_photon *photon = &l->photon[record];
        const murk_material *material = murk_surfaces_material(
            pieces->surfaces, murk_photon_material(photon));
        l->scratch[k] =
            (arrival){murk_photon_emitted(photon), record,
                      murk_photon_power_w(photon) /
                          material->diffuse.band[murk_photon_band(photon)]};
    }
    /* Add the records of one emitted photon, then all of them. */
    qsort(l->scratch, n, sizeof *l->scratch, by_emitted);
    for (size_t k = 0; k < n;) {
        double w = 0;
        const uint32_t emitted = l->scratch[k].emitted;
        for (; k < n && l->scratch[k].emitted == emitted; ++k) {
            w += l->scratch[k].w;
        }
        sum += w;
        squares += w * w;
    }
    const double variance =
        l->emitted / (l->emitted - 1) * (squares - sum * sum / l->emitted);
    l->out->piece[i].photons = (uint32_t)n;
    l->out->piece[i].irradiance = (float)(sum / area_m2);
    l->out->piece[i].error =
        (float)(variance > 0 ? sqrt(variance) / area_m2 : 0);
}

/* Counting sort: fills begin[pieces + 1], which must be zeros, and order.
 * Records on no piece are left out. Returns the largest number of records on a
 * piece. */
static size_t sort_by_piece(size_t *begin, uint32_t *order,
                            const uint32_t *piece, size_t n, size_t pieces)
{
    size_t maximum = 0;
    for (size_t i = 0; i < n; ++i) {
        if (piece[i] != MURK_NO_PIECE) {
            ++begin[piece[i] + 1];
        }
    }
    for (size_t i = 0; i < pieces; ++i) {
        maximum = begin[i + 1] > maximum ? begin[i + 1] : maximum;
        begin[i + 1] += begin[i];
    }
    for (size_t i = 0; i < n; ++i) {
        if (piece[i] != MURK_NO_PIECE) {
            order[begin[piece[i]]++] = (uint32_t)i;
        }
    }
    memmove(begin + 1, begin, pieces * sizeof *begin);
    begin[0] = 0;
    return maximum;
}

static murk_status light_all(murk_lit_pieces *out, const murk_traced *traced,
                             const uint32_t *piece, murk_error *err)
{
    const size_t pieces = out->pieces->n;
    const size_t n = murk_photon_map_count(traced->surface);
    /* Sort the photons by piece, then compute the irradiance piece by piece. */
    size_t *begin = calloc(pieces + 1, sizeof *begin);
    uint32_t *order = malloc(n * sizeof *order + 1);
    const size_t maximum =
        begin && order ? sort_by_piece(begin, order, piece, n, pieces) : 0;
    lighting l = {.out = out,
                  .photon = murk_photon_map_photons(traced->surface),
                  .emitted = (double)traced->emitted,
                  .order = order,
                  .begin = begin,
                  .scratch = malloc(maximum * sizeof *l.scratch + 1)};
    const bool has_memory = begin && order && l.scratch;
    for (size_t i = 0; has_memory && i < pieces; ++i) {
        light_piece(&l, i);
    }
    if (has_memory) {
        out->lost = n - begin[pieces];
    }
    free(begin);
    free(order);
    free(l.scratch);
    return has_memory ? MURK_OK : no_memory(out->pieces, err);
}

/* ---- coverage ---- */

/* Fills the coverage of pieces: the sum of weight times combined clarity over
 * the sum of weight, of the records on the piece; NaN if no weight lies there.
 * whole[] and seen[] begin as zeros. */
static void weigh(murk_lit_pieces *out, const murk_sight *sight,
                  const murk_combined_rows *combined, const uint32_t *piece,
                  uint64_t *whole, uint64_t *seen)
{
    const size_t n =
        murk_photon_map_count(murk_sight_described(sight)->surface_map);
    const uint32_t *weight = murk_sight_weights(sight);
    const uint64_t full =
        (uint64_t)MURK_CLEAR * (combined->layers > 1 ? combined->layers : 1);
    for (size_t i = 0; i < n; ++i) {
        if (piece[i] != MURK_NO_PIECE) {
            whole[piece[i]] += weight[i] * full;
            seen[piece[i]] +=
                (uint64_t)weight[i] * murk_combined_rows_worth(combined, i);
        }
    }
    for (size_t i = 0; i < out->pieces->n; ++i) {
        out->piece[i].coverage =
            whole[i] > 0 ? (float)((double)seen[i] / (double)whole[i]) : NAN;
    }
}

static murk_status cover_all(murk_lit_pieces *out, murk_sight *sight,
                             const murk_pose *sensor, size_t sensors,
                             const uint32_t *piece, murk_error *err)
{
    const murk_sight_desc *desc = murk_sight_described(sight);
    const size_t pieces = out->pieces->n;
    uint64_t *whole = calloc(pieces + 1, sizeof *whole);
    uint64_t *seen = calloc(pieces + 1, sizeof *seen);
    murk_combined_rows combined = {0};
    const bool has_memory =
        murk_combined_rows_init(&combined, murk_sight_photons(sight),
                                desc->combining,
                                desc->redundancy > 1 ? desc->redundancy : 1) &&
        whole && seen;
    /* Combine the rows of the coverage matrix, sensor by sensor. */
    for (size_t k = 0; has_memory && k < sensors && !murk_interrupted(); ++k) {
        murk_sparse_row row;
        murk_sight_row(sight, 0, &sensor[k], &row);
        murk_combined_rows_add(&combined, (uint32_t)k, &row);
    }
    if (has_memory) {
        weigh(out, sight, &combined, piece, whole, seen);
    }
    murk_combined_rows_release(&combined);
    free(whole);
    free(seen);
    return !has_memory ? no_memory(out->pieces, err)
                       : murk_interrupt_check(err);
}

/* ---- middles ---- */

typedef struct middles {
    const murk_pieces *pieces;
    uint32_t *piece; /* [n]; pieces within the domain */
    size_t n;
    int band;
} middles;

/* Records 2 i and 2 i + 1 are the two sides of piece[i]. */
static murk_photon middle_of(const void *context, size_t i)
{
    const middles *m = context;
    const murk_piece piece = murk_piece_of(m->pieces, m->piece[i / 2]);
    return murk_photon_make(&(murk_photon_values){
        .position_m = piece.middle,
        .normal = murk_scale(i % 2 ? -1 : 1, piece.normal),
        .band = (uint8_t)m->band,
        .material = piece.material});
}

static void take_up(murk_lit_pieces *out, const middles *m,
                    const murk_place_seen *seen)
{
    for (size_t i = 0; i < m->n; ++i) {
        const uint32_t piece = m->piece[i];
        const murk_place_seen *sides = &seen[2 * i];
        const uint32_t sensors = sides[0].sensors + sides[1].sensors;
        const uint16_t maximum =
            (uint16_t)(sensors < UINT16_MAX ? sensors : UINT16_MAX);
        if (maximum > out->piece[piece].sensors) {
            out->piece[piece].sensors = maximum;
        }
        out->piece[piece].clarity = fmaxf(
            out->piece[piece].clarity, fmaxf(sides[0].worth, sides[1].worth));
    }
}

static murk_status see_middles(murk_lit_pieces *out, const murk_domain *domain,
                               int bands, const murk_sight *sight,
                               const murk_pose *sensor, size_t n,
                               murk_error *err)
{
    const murk_pieces *pieces = out->pieces;
    middles m = {.pieces = pieces,
                 .piece = malloc(pieces->n * sizeof *m.piece + 1)};
    murk_place_seen *seen = malloc(2 * pieces->n * sizeof *seen + 1);
    murk_status status = m.piece && seen ? MURK_OK : no_memory(pieces, err);
    /* The middles of pieces within the domain. */
    for (size_t i = 0; !status && i < pieces->n; ++i) {
        const murk_piece piece = murk_piece_of(pieces, i);
        if (murk_piece_is_within(&piece, domain)) {
            m.piece[m.n++] = (uint32_t)i;
        }
    }
    /* Evaluate the sightlines to both sides of each middle, band by band. */
    for (m.band = 0; !status && m.band < bands; ++m.band) {
        const murk_places places = {.n = 2 * m.n,
                                    .record = middle_of,
                                    .context = &m,
                                    .step = "surfaces"};
        status = murk_places_see(seen, &places, sight, sensor, n, err);
        if (!status) {
            take_up(out, &m, seen);
        }
    }
    free(m.piece);
    free(seen);
    return status;
}

/* ---- all ---- */

void murk_lit_pieces_release(murk_lit_pieces *lit)
{
    free(lit->piece);
    *lit = (murk_lit_pieces){0};
}

murk_status murk_lit_pieces_make(murk_lit_pieces *out,
                                 const murk_pieces *pieces,
                                 const murk_domain *domain,
                                 const murk_traced *traced, int bands,
                                 murk_sight *sight, const murk_pose *sensor,
                                 size_t n, unsigned threads, murk_error *err)
{
    *out = (murk_lit_pieces){.pieces = pieces,
                             .piece = calloc(pieces->n + 1, sizeof *out->piece),
                             .is_seen = sight != NULL};
    uint32_t *piece = NULL, *target = NULL;
    murk_status status = out->piece ? MURK_OK : no_memory(pieces, err);
    if (!status) {
        status = locate(&piece, pieces, traced->surface, threads, err);
    }
    if (!status) {
        status = light_all(out, traced, piece, err);
    }
    const murk_photon_map *map =
        sight ? murk_sight_described(sight)->surface_map : NULL;
    if (!status && sight && map != traced->surface) { /* targets */
        status = locate(&target, pieces, map, threads, err);
    }
    if (!status && sight) {
        status = cover_all(out, sight, sensor, n, target ? target : piece, err);
    }
    if (!status && sight) {
        status = see_middles(out, domain, bands, sight, sensor, n, err);
    }
    free(target);
    free(piece);
    return status;
}
