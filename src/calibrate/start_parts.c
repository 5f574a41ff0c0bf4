/* Writes and reads the searches of a part of a fit, and exchanges searches
 * between ranks (calibrate/start_parts.h). The file has the container format of
 * light.murk (photonmap/map_file.h): the facts of the part, the texts by which
 * it is refused for another scene or other options, a record of each search,
 * and the points of the searches. Start values are no part of it, because they
 * follow from the number of the start.
 */
#include "calibrate/start_parts.h"

#include "base/host.h"
#include "base/ranks.h"
#include "calibrate/search.h"
#include "lightmap/key_check.h"
#include "photonmap/map_file.h"
#include "world/file_sums.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct part_facts {
    uint32_t number, count;
    char version[56]; /* murk_host_version() */
    char data[64];    /* SHA-256 of the readings, in hex */
} part_facts;

/* One search. points: x and lit of the start, [2 * keys]. */
typedef struct record {
    uint64_t number; /* of the start */
    uint64_t converged, traces, lights, evaluations, iterations;
    double chi2, cost;
    char why[256];
} record;

/* The texts that name the fit. */
typedef struct owner {
    char *files;   /* checksums of the files that the scene names */
    char *options; /* free keys and options of the search */
} owner;

static void release_owner(owner *o)
{
    free(o->files);
    free(o->options);
}

/* Prints what the fit is asked for, one line a fact. */
static void print_options(FILE *to, const murk_calibration_desc *desc)
{
    for (size_t k = 0; k < desc->keys->n; ++k) {
        const murk_free_key *key = &desc->keys->key[k];
        fprintf(to, "free %s, from %.17g, %.17g to %.17g\n", key->name,
                key->start, key->lower, key->upper);
    }
    fprintf(to, "loss %d, width %.17g\nstarts %zu\ntraces %zu\n",
            (int)desc->loss, desc->loss_width, desc->starts, desc->traces_max);
}

static murk_status name_owner(owner *out, const murk_calibration_desc *desc,
                              murk_error *err)
{
    size_t size = 0;
    bool is_whole = false;
    *out = (owner){0};
    /* The files. */
    FILE *to = open_memstream(&out->files, &size);
    if (to) {
        murk_file_sums sums = {0};
        is_whole = murk_file_sums_scene(to, &sums, desc->scene);
        murk_file_sums_release(&sums);
        is_whole = fclose(to) == 0 && is_whole;
    }
    /* The options. */
    to = is_whole ? open_memstream(&out->options, &size) : NULL;
    if (to) {
        print_options(to, desc);
        is_whole = fclose(to) == 0;
    }
    return to && is_whole ? MURK_OK
                          : murk_no_memory(err, "", "for a part of the fit");
}

/* ---- writing ---- */

/* Lists the searches that have ended: records and points [starts]. Returns
 * their number. */
static size_t list_ended(record *records, double *points,
                         const murk_calibration *found)
{
    const size_t n = found->n;
    size_t count = 0;
    /* points: x and lit of each search. */
    for (size_t i = 0; i < found->starts; ++i) {
        const murk_calibration_start *start = &found->start[i];
        if (!start->has_ended) {
            continue;
        }
        record *r = &records[count];
        *r = (record){.number = i,
                      .converged = start->converged,
                      .traces = start->traces,
                      .lights = start->lights,
                      .evaluations = start->evaluations,
                      .iterations = (uint64_t)start->iterations,
                      .chi2 = start->chi2,
                      .cost = start->cost};
        memcpy(r->why, start->why, sizeof r->why);
        memcpy(points + count * 2 * n, start->x, n * sizeof *points);
        memcpy(points + (count * 2 + 1) * n, start->lit, n * sizeof *points);
        ++count;
    }
    return count;
}

murk_status murk_start_part_write(const murk_calibration *found,
                                  const murk_calibration_desc *desc,
                                  const char *path, murk_error *err)
{
    const size_t n = found->n;
    record *records = calloc(found->starts + 1, sizeof *records);
    double *points = calloc(found->starts * 2 * n + 1, sizeof *points);
    owner names = {0};
    murk_status status = records && points
                             ? name_owner(&names, desc, err)
                             : murk_no_memory(err, path, "to write it");
    if (status) {
        goto done;
    }
    const size_t count = list_ended(records, points, found);
    /* What the part belongs to. */
    part_facts facts = {.number = desc->shard.number,
                        .count = desc->shard.count};
    snprintf(facts.version, sizeof facts.version, "%s", murk_host_version());
    memcpy(facts.data, desc->measured->sha256, sizeof facts.data);
    const char *scene = desc->scene->resolved;
    const murk_section sections[] = {
        murk_section_of("part", &facts, sizeof facts),
        murk_section_of("scene", scene, strlen(scene)),
        murk_section_of("files", names.files, strlen(names.files)),
        murk_section_of("options", names.options, strlen(names.options)),
        murk_section_of("starts", records, count * sizeof *records),
        murk_section_of("points", points, count * 2 * n * sizeof *points)};
    status = murk_map_file_write(path, sections,
                                 sizeof sections / sizeof *sections, err);
done:
    release_owner(&names);
    free(records);
    free(points);
    return status;
}

/* ---- reading ---- */

typedef struct part {
    murk_section *sections;
    size_t n_sections;
    part_facts facts;
    const record *record; /* [n] */
    size_t n;
    const double *point; /* [n][2][keys] */
    const char *path;
} part;

static murk_status bad_part(const part *p, const char *what, murk_error *err)
{
    return murk_fail(err, MURK_BAD_FILE, p->path, "no part of a fit: %s", what);
}

static const murk_section *find(const part *p, const char *name)
{
    return murk_map_file_find(p->sections, p->n_sections, name);
}

/* Checks that the part belongs to the fit. */
static murk_status check_owner(const part *p, const murk_calibration_desc *desc,
                               const owner *names, murk_error *err)
{
    const murk_section *scene = find(p, "scene"), *files = find(p, "files"),
                       *options = find(p, "options");
    /* The version, then the scene, its files, the readings and the options. */
    if (!scene || !files || !options) {
        return bad_part(p, "the scene is missing", err);
    }
    murk_status status =
        murk_shard_check_version(p->facts.version, sizeof p->facts.version,
                                 murk_host_version(), p->path, err);
    if (!status) {
        status = murk_lightmap_check_text(scene, desc->scene->resolved, "scene",
                                          p->path, err);
    }
    if (!status && (files->size != strlen(names->files) ||
                    memcmp(files->bytes, names->files, files->size) != 0)) {
        status = murk_fail(err, MURK_BAD_VALUE, p->path,
                           "made with other contents of the files that the "
                           "scene names");
    }
    if (!status && memcmp(p->facts.data, desc->measured->sha256,
                          sizeof p->facts.data) != 0) {
        status = murk_fail(err, MURK_BAD_VALUE, p->path,
                           "made for other readings than those that %s has now",
                           desc->measured->path);
    }
    return status ? status
                  : murk_lightmap_check_text(options, names->options, "fit",
                                             p->path, err);
}

static bool are_finite(const double *a, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        if (!isfinite(a[i])) {
            return false;
        }
    }
    return true;
}

static bool is_text(const char *text, size_t size)
{
    size_t i = 0;
    while (i < size && (unsigned char)text[i] >= ' ') {
        ++i;
    }
    return i < size && text[i] == '\0';
}

/* True if x[n], in search coordinates, lies within the bounds of the keys. */
static bool are_allowed(const double *x, const murk_free_keys *keys)
{
    for (size_t k = 0; k < keys->n; ++k) {
        if (!(x[k] >= murk_free_lowest(&keys->key[k]) &&
              x[k] <= murk_free_highest(&keys->key[k]))) {
            return false;
        }
    }
    return true;
}

/* True if a search can have left this record. Start 0 has an end. The sums of
 * counts cannot overflow. */
static bool is_record(const record *r, const double *points,
                      const murk_calibration *out, const murk_free_keys *keys,
                      const murk_shard *shard)
{
    const uint64_t count_max = INT_MAX / (uint64_t)out->starts;
    const bool has_end = !isnan(r->chi2);
    return r->number < out->starts &&
           (r->number == 0 ||
            (r->number - 1) % shard->count == shard->number - 1) &&
           (r->number > 0 || (has_end && r->traces > 0)) &&
           (!has_end || (r->chi2 >= 0 && isfinite(r->chi2) && r->cost >= 0 &&
                         isfinite(r->cost))) &&
           r->converged <= 1 && r->traces <= count_max &&
           r->lights <= count_max && r->evaluations <= count_max &&
           r->iterations <= count_max && is_text(r->why, sizeof r->why) &&
           are_finite(points, 2 * out->n) &&
           (!has_end || are_allowed(points, keys));
}

/* Finds the records and points of the part, and checks them. */
static murk_status check_records(part *p, const murk_calibration *out,
                                 const murk_free_keys *keys, murk_error *err)
{
    const murk_section *starts = find(p, "starts"), *points = find(p, "points");
    if (!starts || starts->size == 0 || starts->size % sizeof(record) != 0) {
        return bad_part(p, "searches are missing", err);
    }
    p->n = starts->size / sizeof(record);
    p->record = starts->bytes;
    if (p->n > out->starts || !points ||
        points->size != p->n * 2 * out->n * sizeof(double)) {
        return bad_part(p, "searches with other keys", err);
    }
    p->point = points->bytes;
    /* Start 0, then those of the shard, in rising order. */
    const murk_shard shard = {p->facts.number, p->facts.count};
    for (size_t i = 0; i < p->n; ++i) {
        const bool is_in_order =
            i == 0 ? p->record[i].number == 0
                   : p->record[i].number > p->record[i - 1].number;
        if (!is_in_order || !is_record(&p->record[i], p->point + i * 2 * out->n,
                                       out, keys, &shard)) {
            return bad_part(p, "searches that no fit has", err);
        }
    }
    return MURK_OK;
}

static murk_status read_part(part *p, const murk_calibration *out,
                             const murk_calibration_desc *desc,
                             const owner *names, murk_error *err)
{
    murk_status status =
        murk_map_file_read(&p->sections, &p->n_sections, p->path, err);
    if (status) {
        return status;
    }
    const murk_section *facts = find(p, "part");
    if (!facts || facts->size != sizeof p->facts) {
        return bad_part(p, "the section \"part\" is missing", err);
    }
    memcpy(&p->facts, facts->bytes, sizeof p->facts);
    if (murk_shard_check((murk_shard){p->facts.number, p->facts.count}, NULL)) {
        return bad_part(p, "no number of a part", err);
    }
    status = check_owner(p, desc, names, err);
    return status ? status : check_records(p, out, desc->keys, err);
}

/* True if the start is the one of the record. */
static bool is_same(const murk_calibration_start *start, const record *r,
                    const double *points, size_t n)
{
    return memcmp(&start->chi2, &r->chi2, sizeof r->chi2) == 0 &&
           memcmp(&start->cost, &r->cost, sizeof r->cost) == 0 &&
           start->converged == (r->converged != 0) &&
           start->traces == r->traces && start->lights == r->lights &&
           start->evaluations == r->evaluations &&
           (uint64_t)start->iterations == r->iterations &&
           strcmp(start->why, r->why) == 0 &&
           memcmp(start->x, points, n * sizeof *points) == 0 &&
           memcmp(start->lit, points + n, n * sizeof *points) == 0;
}

/* Takes over a search. */
static void take_start(murk_calibration *out, const murk_fit_search *search,
                       const record *r, const double *points)
{
    const size_t n = out->n;
    murk_calibration_start *start = &out->start[r->number];
    start->has_ended = true;
    start->converged = r->converged != 0;
    start->traces = (size_t)r->traces;
    start->lights = (size_t)r->lights;
    start->evaluations = (size_t)r->evaluations;
    start->iterations = (int)r->iterations;
    start->chi2 = r->chi2;
    start->cost = r->cost;
    memcpy(start->why, r->why, sizeof start->why);
    memcpy(start->x, points, n * sizeof *points);
    memcpy(start->lit, points + n, n * sizeof *points);
    murk_fit_complete(out, search, (size_t)r->number);
}

/* Takes over the searches of a part. One that is there already must be equal.
 */
static murk_status take_part(murk_calibration *out,
                             const murk_fit_search *search, const part *p,
                             murk_error *err)
{
    const size_t n = out->n;
    for (size_t i = 0; i < p->n; ++i) {
        const record *r = &p->record[i];
        const double *points = p->point + i * 2 * n;
        const murk_calibration_start *start = &out->start[r->number];
        /* Compare with the search of a part before. */
        if (start->has_ended && !is_same(start, r, points, n)) {
            return murk_fail(
                err, MURK_BAD_VALUE, p->path,
                "start %llu of the fit differs from that of a part "
                "before",
                (unsigned long long)r->number + 1);
        }
        take_start(out, search, r, points);
    }
    return MURK_OK;
}

/* has[count]; the first part has number 1. */
static bool has_part(const void *has, uint32_t number)
{
    return ((const bool *)has)[number - 1];
}

murk_status murk_start_parts_read(murk_calibration *out,
                                  const murk_fit_search *search,
                                  murk_error *err)
{
    const murk_calibration_desc *desc = search->desc;
    owner names;
    bool *has = NULL;
    uint32_t count = 0;
    murk_status status = name_owner(&names, desc, err);
    for (size_t i = 0; i < desc->parts && !status; ++i) {
        /* Read and check a part; the first gives the number of parts. */
        part p = {.path = desc->part[i]};
        status = read_part(&p, out, desc, &names, err);
        if (!status && !has) {
            count = p.facts.count;
            has = calloc(count, sizeof *has);
            status = has ? MURK_OK : murk_no_memory(err, p.path, "to read it");
        }
        if (!status && p.facts.count != count) {
            status = murk_fail(err, MURK_BAD_VALUE, p.path,
                               "part %u of %u, other parts are of %u",
                               p.facts.number, p.facts.count, count);
        }
        /* Take over the searches of the part. */
        if (!status) {
            has[p.facts.number - 1] = true;
            status = take_part(out, search, &p, err);
        }
        murk_map_file_release(p.sections, p.n_sections);
    }
    if (!status && has) {
        murk_shards_warn_of_missing(has_part, has, count,
                                    "their starts are run now");
    }
    release_owner(&names);
    free(has);
    return status;
}

/* ---- ranks ---- */

murk_status murk_starts_exchange(murk_calibration *out,
                                 const murk_fit_search *search,
                                 murk_status status, murk_error *err)
{
    /* A rank gives its records, then their points. */
    const size_t pair = 2 * out->n * sizeof(double);
    record *records = calloc(out->starts + 1, sizeof *records);
    double *points = calloc(out->starts + 1, pair);
    char *bytes = malloc(out->starts * (sizeof *records + pair) + 1);
    size_t count = 0;
    murk_gathered all = {0};
    if (!status && !(records && points && bytes)) {
        status = murk_no_memory(err, "", "to exchange the starts of the fit");
    }
    if (!status) {
        count = list_ended(records, points, out);
        memcpy(bytes, records, count * sizeof *records);
        memcpy(bytes + count * sizeof *records, points, count * pair);
    }
    status = murk_ranks_gather(&all, bytes, count * (sizeof *records + pair),
                               status, err);
    /* Take over those of the other ranks, one after the other. */
    for (unsigned r = 0; r < murk_ranks_count() && !status; ++r) {
        const char *at = all.bytes + all.begin[r];
        count = (all.begin[r + 1] - all.begin[r]) / (sizeof *records + pair);
        memcpy(records, at, count * sizeof *records);
        memcpy(points, at + count * sizeof *records, count * pair);
        for (size_t i = 0; i < count; ++i) {
            if (!out->start[records[i].number].has_ended) {
                take_start(out, search, &records[i], points + i * 2 * out->n);
            }
        }
    }
    murk_gathered_release(&all);
    free(bytes);
    free(points);
    free(records);
    return status;
}
