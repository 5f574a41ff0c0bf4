/* Computes the density paths of sightlines in chunks (murk_sight_depths()),
 * drops those with negligible transmittance, and merges the sightlines of
 * several sensors by a counting sort. */
#include "calibrate/sightlines.h"

#include "base/ranks.h"
#include "calibrate/packed_arrays.h"

#include <stdlib.h>
#include <string.h>

/* Sightlines with a smaller transmittance at the traced optics are dropped.
 * Each changes a coverage by less than this, and by less than the square root
 * of this if the extinction is halved. Rows of coverage matrices drop
 * sightlines already below 8000 times this, half a unit of the 16-bit
 * clarity. */
#define MIN_THROUGH 0x1p-30

#define CHUNK 512 /* sightlines computed together: fits the cache */

static size_t bytes_each(const murk_sightlines_through *t)
{
    return sizeof(uint32_t) + t->media * sizeof(float) +
           (t->has_rest ? sizeof(float) : 0);
}

static bool allocate(murk_sightlines *lines, const murk_sightlines_through *t,
                     size_t n, bool has_acceptances)
{
    lines->contribution = malloc(n * sizeof *lines->contribution + 1);
    lines->path_m = malloc(n * t->media * sizeof *lines->path_m + 1);
    lines->rest = t->has_rest ? malloc(n * sizeof *lines->rest + 1) : NULL;
    lines->acceptance =
        has_acceptances ? malloc(n * sizeof *lines->acceptance + 1) : NULL;
    return lines->contribution && lines->path_m &&
           (lines->rest || !t->has_rest) &&
           (lines->acceptance || !has_acceptances);
}

/* Releases unused capacity; if that fails, the larger array stays. */
static void *shrunk(void *array, size_t bytes)
{
    void *less = array ? realloc(array, bytes + 1) : NULL;
    return less ? less : array;
}

/* Appends those of n <= CHUNK sightlines whose transmittance suffices; depth[n
 * * media] is a workspace. */
static void keep(murk_sightlines *lines, const murk_sightlines_through *t,
                 const murk_pose *pose, const uint32_t *photon, size_t n,
                 double *depth)
{
    const size_t media = t->media;
    double sheets[CHUNK], other[CHUNK] = {0};
    /* Transmittance of other media, density paths of the re-weighted ones. */
    if (t->other) {
        murk_sight_depths(other, sheets, t->sight, pose, photon, n, &t->other,
                          1);
    }
    murk_sight_depths(depth, sheets, t->sight, pose, photon, n, t->alone,
                      media);
    /* Store the sightlines that are not negligible. */
    for (size_t i = 0; i < n; ++i) {
        const murk_photon *p = murk_sight_photon(t->sight, photon[i]);
        const double *extinction = t->extinction + murk_photon_band(p) * media;
        const double rest = sheets[i] * exp(-other[i]);
        double tau = 0;
        for (size_t m = 0; m < media; ++m) {
            tau += extinction[m] * depth[i * media + m];
        }
        if (!(rest * exp(-tau) >= MIN_THROUGH)) {
            continue;
        }
        lines->contribution[lines->n] = murk_photon_emitted(p);
        for (size_t m = 0; m < media; ++m) {
            lines->path_m[lines->n * media + m] = (float)depth[i * media + m];
        }
        if (lines->rest) {
            lines->rest[lines->n] = (float)rest;
        }
        ++lines->n;
    }
}

bool murk_sightlines_find(murk_sightlines *out,
                          const murk_sightlines_through *t, unsigned worker,
                          const murk_pose *pose, murk_sightlines_memory *memory)
{
    /* The row of records that the pose sees; reserve memory. */
    murk_sparse_row row;
    murk_sight_row(t->sight, worker, pose, &row);
    const int64_t max = (int64_t)(row.seen * bytes_each(t));
    murk_tally_add(&memory->bytes, max);
    if ((double)murk_tally_read(&memory->bytes) > memory->max_bytes) {
        return false;
    }
    double *depth = malloc(CHUNK * t->media * sizeof *depth + 1);
    if (!depth || !allocate(out, t, row.seen, false)) {
        free(depth);
        return false;
    }
    /* Compute in chunks. */
    for (size_t i = 0; i < row.seen; i += CHUNK) {
        const size_t left = row.seen - i;
        keep(out, t, pose, row.photon + i, left < CHUNK ? left : CHUNK, depth);
    }
    free(depth);
    /* Release what was dropped. */
    out->contribution =
        shrunk(out->contribution, out->n * sizeof *out->contribution);
    out->path_m = shrunk(out->path_m, out->n * t->media * sizeof *out->path_m);
    out->rest = shrunk(out->rest, out->n * sizeof *out->rest);
    murk_tally_add(&memory->bytes, (int64_t)(out->n * bytes_each(t)) - max);
    return true;
}

enum { ARRAYS = 3 };

/* The arrays of n sightlines of one sensor. */
static void arrays_of(murk_packed_array out[ARRAYS],
                      const murk_sightlines *lines,
                      const murk_sightlines_through *t, size_t n)
{
    const murk_packed_array arrays[ARRAYS] = {
        {lines->contribution, n * sizeof *lines->contribution},
        {lines->path_m, n * t->media * sizeof *lines->path_m},
        {lines->rest, t->has_rest ? n * sizeof *lines->rest : 0}};
    memcpy(out, arrays, sizeof arrays);
}

/* Packs the number and the arrays of each own part. *bytes: for free(). */
static murk_status pack(char **bytes, size_t *size, const murk_sightlines *part,
                        size_t parts, const murk_sightlines_through *t,
                        murk_error *err)
{
    murk_packed_array array[ARRAYS];
    *size = 0;
    const size_t own = (size_t)murk_ranks_share(parts);
    for (size_t k = 0; k < own; ++k) {
        const size_t j = (size_t)murk_ranks_item(k);
        arrays_of(array, &part[j], t, part[j].n);
        *size += sizeof(uint64_t) + murk_arrays_bytes(array, ARRAYS);
    }
    char *at = *bytes = malloc(*size + 1);
    if (!at) {
        return murk_no_memory(err, "", "to exchange sightlines");
    }
    for (size_t k = 0; k < own; ++k) {
        const size_t j = (size_t)murk_ranks_item(k);
        const uint64_t n = part[j].n;
        memcpy(at, &n, sizeof n);
        arrays_of(array, &part[j], t, part[j].n);
        at = murk_arrays_pack(at + sizeof n, array, ARRAYS);
    }
    return MURK_OK;
}

/* Stores the parts of another rank. */
static murk_status unpack(murk_sightlines *part, size_t parts, unsigned rank,
                          const murk_sightlines_through *t, const char *at,
                          murk_error *err)
{
    for (size_t j = 0; j < parts; ++j) {
        uint64_t n;
        if (murk_ranks_owner(j) != rank) {
            continue;
        }
        memcpy(&n, at, sizeof n);
        if (!allocate(&part[j], t, (size_t)n, false)) {
            return murk_no_memory(err, "", "for sightlines");
        }
        murk_packed_array array[ARRAYS];
        part[j].n = (size_t)n;
        arrays_of(array, &part[j], t, part[j].n);
        at = murk_arrays_unpack(array, ARRAYS, at + sizeof n);
    }
    return MURK_OK;
}

/* Whether the sightlines of all ranks fit into the memory of each rank, twice:
 * as they are received, and stored. */
static murk_status check_memory(bool *fits, murk_sightlines_memory *memory,
                                murk_error *err)
{
    const uint64_t own = (uint64_t)murk_tally_read(&memory->bytes);
    uint64_t all = own;
    murk_status status = murk_ranks_sum(&all, 1, false, MURK_OK, err);
    uint64_t lacking = !(2 * (double)all <= memory->max_bytes);
    status = murk_ranks_sum(&lacking, 1, false, status, err);
    murk_tally_add(&memory->bytes, (int64_t)(all - own));
    *fits = lacking == 0;
    return status;
}

murk_status murk_sightlines_exchange(bool *fits, murk_sightlines *part,
                                     size_t parts,
                                     const murk_sightlines_through *t,
                                     murk_sightlines_memory *memory,
                                     murk_error *err)
{
    *fits = true;
    if (murk_ranks_count() == 1) {
        return MURK_OK;
    }
    murk_status status = check_memory(fits, memory, err);
    if (status || !*fits) {
        return status;
    }
    char *bytes = NULL;
    size_t size = 0;
    murk_gathered all = {0};
    /* Give the own parts, and store those of the others. */
    status = pack(&bytes, &size, part, parts, t, err);
    status = murk_ranks_gather(&all, bytes, size, status, err);
    for (unsigned r = 0; r < murk_ranks_count() && !status; ++r) {
        if (r != murk_ranks_number()) {
            status = unpack(part, parts, r, t, all.bytes + all.begin[r], err);
        }
    }
    murk_gathered_release(&all);
    free(bytes);
    return status;
}

/* Copies sightlines to their sorted places; place[c] is the next free place of
 * contribution c. */
static void put(murk_sightlines *to, const murk_sightlines *from,
                uint32_t *place, size_t media)
{
    for (size_t i = 0; i < from->n; ++i) {
        const uint32_t c = from->contribution[i];
        const size_t at = place[c]++;
        to->contribution[at] = c;
        memcpy(to->path_m + at * media, from->path_m + i * media,
               media * sizeof *to->path_m);
        if (to->rest) {
            to->rest[at] = from->rest[i];
        }
        if (to->acceptance) {
            to->acceptance[at] = from->acceptance_all;
        }
    }
}

bool murk_sightlines_join(murk_sightlines *out, murk_sightlines *part,
                          size_t parts, const murk_sightlines_through *t,
                          size_t contributions)
{
    /* Count all sightlines; do acceptance angles differ? */
    size_t n = 0;
    bool has_acceptances = false;
    for (size_t j = 0; j < parts; ++j) {
        n += part[j].n;
        has_acceptances =
            has_acceptances || part[j].acceptance_all != part[0].acceptance_all;
    }
    uint32_t *place = calloc(contributions + 1, sizeof *place);
    if (!place || n > UINT32_MAX || !allocate(out, t, n, has_acceptances)) {
        free(place);
        return false;
    }
    out->n = n;
    out->acceptance_all = parts ? part[0].acceptance_all : 0;
    /* Counting sort by contribution: count, sum, place. */
    for (size_t j = 0; j < parts; ++j) {
        for (size_t i = 0; i < part[j].n; ++i) {
            ++place[part[j].contribution[i]];
        }
    }
    uint32_t before = 0;
    for (size_t c = 0; c < contributions; ++c) {
        const uint32_t here = place[c];
        out->max = here > out->max ? here : out->max;
        place[c] = before;
        before += here;
    }
    /* Copy. */
    for (size_t j = 0; j < parts; ++j) {
        put(out, &part[j], place, t->media);
        murk_sightlines_release(&part[j]);
    }
    free(place);
    return true;
}

void murk_sightlines_release(murk_sightlines *lines)
{
    free(lines->contribution);
    free(lines->path_m);
    free(lines->rest);
    free(lines->acceptance);
    *lines = (murk_sightlines){0};
}

double murk_sightlines_bytes(const murk_sightlines *lines, size_t media)
{
    const size_t each = sizeof *lines->contribution +
                        media * sizeof *lines->path_m +
                        (lines->rest ? sizeof *lines->rest : 0) +
                        (lines->acceptance ? sizeof *lines->acceptance : 0);
    return (double)lines->n * (double)each;
}
