/* Writes and reads parts of the light of a scene (lightmap/light_part.h), files
 * with the container format of light.murk (photonmap/map_file.h). A part is
 * checked as strictly as light.murk, because numbers in records lead to places
 * in arrays. */
#include "lightmap/light_part.h"

#include "base/host.h"
#include "base/machine.h"
#include "lightmap/key_check.h"
#include "lightmap/rank_exchange.h"
#include "lightmap/store_check.h"
#include "photonmap/map_file.h"
#include "world/scene_tallies.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The number of photons that may be emitted for each record that `store` asks
 * for; the total is at most 2^32 - 1. If `store` is not reached by then, the
 * run fails, because a scene that stores so few records would run for hours to
 * little effect. */
#define STORE_EMISSIONS UINT64_C(1000)

uint64_t murk_light_photons_max(const murk_scene_photons *settings)
{
    return settings->emit ? settings->emit
           : settings->store < UINT32_MAX / STORE_EMISSIONS
               ? settings->store * STORE_EMISSIONS
               : UINT32_MAX;
}

uint64_t murk_light_part_batches(uint64_t photons_max, murk_shard shard)
{
    const uint64_t all =
        (photons_max + MURK_BATCH_PHOTONS - 1) / MURK_BATCH_PHOTONS;
    return all >= shard.number ? (all - shard.number) / shard.count + 1 : 0;
}

uint64_t murk_light_part_end(uint64_t photons_max, murk_shard shard,
                             uint64_t batches)
{
    const uint64_t end =
        batches > 0
            ? (shard.number + (batches - 1) * shard.count) * MURK_BATCH_PHOTONS
            : 0;
    return end < photons_max ? end : photons_max;
}

murk_status murk_light_part_write(const char *path,
                                  const murk_light_part_content *c,
                                  const murk_stage *stage, murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    const uint64_t max = murk_light_photons_max(&scene->photons);
    murk_light_part_facts f = {
        .batches = c->batches,
        .end = murk_light_part_end(max, c->shard, c->batches),
        .number = c->shard.number,
        .count = c->shard.count};
    snprintf(f.version, sizeof f.version, "%s", murk_host_version());
    const murk_vec3 origin = scene->origin;
    /* What the part belongs to, the sums, and the records. */
    const murk_light_sums *sums = c->sums;
    const murk_section sections[] = {
        murk_section_of("part", &f, sizeof f),
        murk_section_of("scene", scene->resolved, strlen(scene->resolved)),
        murk_section_of("key", stage->light_key, strlen(stage->light_key)),
        murk_section_of("origin_m", &origin, sizeof origin),
        murk_section_of("ledger", sums->cell, sums->cells * sizeof *sums->cell),
        murk_section_of("tallies", sums->word,
                        sums->words * sizeof *sums->word),
        murk_section_of("counts", c->count, c->batches * sizeof *c->count),
        murk_section_of("records", c->record, c->records * sizeof *c->record)};
    return murk_map_file_write(path, sections,
                               sizeof sections / sizeof *sections, err);
}

typedef struct part {
    murk_section *sections; /* NULL: the shard is missing */
    size_t n_sections;
    murk_light_part_facts facts;
    const uint32_t *count; /* [facts.batches] records of each batch */
    size_t *first;         /* [facts.batches] the first record of each batch */
    const murk_photon *record;
    const int64_t *cell;
    const uint64_t *word; /* NULL: no tallies */
    const char *path;
} part;

struct murk_light_parts {
    uint32_t count; /* shards of the run */
    part *part;     /* [count] */
};

static murk_status bad_part(const char *path, const char *what, murk_error *err)
{
    return murk_fail(err, MURK_BAD_FILE, path, "no part of a trace: %s", what);
}

/* The bytes of the section of that name and size; NULL if there is none. */
static const void *find(const part *p, const char *name, size_t bytes)
{
    const murk_section *section =
        murk_map_file_find(p->sections, p->n_sections, name);
    return section && section->size == bytes ? section->bytes : NULL;
}

/* Checks that the part belongs to the scene, and was written by this version of
 * murk. */
static murk_status check_owner(const part *p, const murk_stage *stage,
                               murk_error *err)
{
    const murk_section *scene =
        murk_map_file_find(p->sections, p->n_sections, "scene");
    const murk_section *key =
        murk_map_file_find(p->sections, p->n_sections, "key");
    /* The version, then the scene, the files that it names, and the origin. */
    if (!scene || !key) {
        return bad_part(p->path, "the scene is missing", err);
    }
    murk_status status =
        murk_shard_check_version(p->facts.version, sizeof p->facts.version,
                                 murk_host_version(), p->path, err);
    if (!status) {
        status = murk_lightmap_check_text(scene, stage->scene->resolved,
                                          "scene", p->path, err);
    }
    if (!status) {
        status = murk_lightmap_check_text(key, stage->light_key, "light",
                                          p->path, err);
    }
    if (!status) {
        status = murk_lightmap_check_origin(
            murk_map_file_find(p->sections, p->n_sections, "origin_m"),
            stage->scene, p->path, err);
    }
    return status;
}

/* Checks the records of one batch: of the photons of the batch, in order, and
 * each possible. packet[channels] is 1. */
static murk_status check_batch(const part *p, uint64_t k, const double *packet,
                               const murk_stage *stage, murk_error *err)
{
    const uint64_t number = p->facts.number - 1 + k * p->facts.count;
    const uint64_t first = number * MURK_BATCH_PHOTONS;
    const uint64_t end = first + MURK_BATCH_PHOTONS < p->facts.end
                             ? first + MURK_BATCH_PHOTONS
                             : p->facts.end;
    uint64_t from = first;
    for (uint32_t i = 0; i < p->count[k]; ++i) {
        const murk_photon *photon = &p->record[p->first[k] + i];
        const uint64_t emitted = murk_photon_emitted(photon);
        if (emitted < from || emitted >= end) {
            return bad_part(p->path, "records of other photons", err);
        }
        from = emitted;
        const murk_status status = murk_lightmap_check_records(
            photon, 1, murk_photon_is_volume(photon), end, packet, stage,
            p->path, err);
        if (status) {
            return status;
        }
    }
    return MURK_OK;
}

/* Finds the batches in the list of records, and checks them. */
static murk_status check_batches(part *p, const murk_stage *stage,
                                 murk_error *err)
{
    const size_t channels = murk_sources_channels(stage->lights);
    double *packet = malloc((channels + 1) * sizeof *packet);
    p->first = malloc((p->facts.batches + 1) * sizeof *p->first);
    if (!packet || !p->first) {
        free(packet);
        return murk_no_memory(err, p->path, "to read it");
    }
    for (size_t c = 0; c < channels; ++c) {
        packet[c] = 1;
    }
    /* The records of all batches. */
    const murk_section *records =
        murk_map_file_find(p->sections, p->n_sections, "records");
    const size_t all = records ? records->size / sizeof(murk_photon) : 0;
    size_t n = 0;
    for (uint64_t k = 0; k < p->facts.batches && n <= all; ++k) {
        p->first[k] = n;
        n += p->count[k];
    }
    murk_status status = MURK_OK;
    if (!records || n != all || records->size % sizeof(murk_photon) != 0) {
        status = bad_part(p->path, "records are missing", err);
    } else {
        p->record = records->bytes;
    }
    for (uint64_t k = 0; k < p->facts.batches && !status; ++k) {
        status = check_batch(p, k, packet, stage, err);
    }
    free(packet);
    return status;
}

/* The sections of one file. `ledger` and `tallies` have the sizes of those of
 * the scene. */
static murk_status read_part(part *p, const murk_stage *stage,
                             const murk_ledger *ledger,
                             const murk_tallies *tallies, murk_error *err)
{
    murk_status status =
        murk_map_file_read(&p->sections, &p->n_sections, p->path, err);
    if (status) {
        return status;
    }
    const murk_light_part_facts *f =
        find(p, "part", sizeof(murk_light_part_facts));
    if (!f || murk_shard_check((murk_shard){f->number, f->count}, NULL)) {
        return bad_part(p->path, "the section \"part\" is missing", err);
    }
    p->facts = *f;
    status = check_owner(p, stage, err);
    if (status) {
        return status;
    }
    /* The batches must be those of the shard in a run of the scene. */
    const uint64_t max = murk_light_photons_max(&stage->scene->photons);
    const murk_shard shard = {f->number, f->count};
    if (f->batches > murk_light_part_batches(max, shard) ||
        f->end != murk_light_part_end(max, shard, f->batches)) {
        return bad_part(p->path, "other batches than those of the shard", err);
    }
    /* The sums must have the sizes of those of the scene. */
    const size_t words = tallies ? murk_tallies_words(tallies) : 0;
    p->count = find(p, "counts", p->facts.batches * sizeof *p->count);
    p->cell = find(p, "ledger", murk_ledger_cells(ledger) * sizeof *p->cell);
    p->word = find(p, "tallies", words * sizeof *p->word);
    if ((p->facts.batches > 0 && !p->count) || !p->cell ||
        (words > 0 && !p->word)) {
        return bad_part(p->path, "sums of another size than the scene's", err);
    }
    /* No sum of whole numbers can overflow if each part has at most the energy
     * of its photons. */
    const int64_t max_quanta =
        (int64_t)p->facts.batches * MURK_BATCH_PHOTONS * MURK_PACKET;
    for (size_t i = 0; i < murk_ledger_cells(ledger); ++i) {
        if (p->cell[i] < 0 || p->cell[i] > max_quanta) {
            return bad_part(p->path, "sums that no photons have", err);
        }
    }
    return check_batches(p, stage, err);
}

static void release_part(part *p)
{
    murk_map_file_release(p->sections, p->n_sections);
    free(p->first);
    *p = (part){.sections = NULL};
}

static bool same_section(const part *a, const part *b, size_t i)
{
    const murk_section *x = &a->sections[i], *y = &b->sections[i];
    return strcmp(x->name, y->name) == 0 && x->size == y->size &&
           memcmp(x->bytes, y->bytes, x->size) == 0;
}

/* Puts a part in its place. A part that is there already must be equal. */
static murk_status place_part(murk_light_parts *parts, part *p, murk_error *err)
{
    if (p->facts.count != parts->count) {
        return murk_fail(err, MURK_BAD_VALUE, p->path,
                         "part %u of %u, other parts are of %u",
                         p->facts.number, p->facts.count, parts->count);
    }
    part *const there = &parts->part[p->facts.number - 1];
    if (!there->sections) {
        *there = *p;
        *p = (part){.sections = NULL};
        return MURK_OK;
    }
    bool is_equal = there->n_sections == p->n_sections;
    for (size_t i = 0; is_equal && i < p->n_sections; ++i) {
        is_equal = same_section(there, p, i);
    }
    return is_equal ? MURK_OK
                    : murk_fail(err, MURK_BAD_VALUE, p->path,
                                "part %u of %u again, and other than %s",
                                p->facts.number, p->facts.count, there->path);
}

static bool has_part(const void *of, uint32_t number)
{
    const murk_light_parts *parts = of;
    return parts->part[number - 1].sections != NULL;
}

murk_status murk_light_parts_read(murk_light_parts **out,
                                  const char *const *path, size_t n,
                                  const murk_stage *stage, murk_error *err)
{
    murk_ledger *ledger = NULL;
    murk_tallies *tallies = NULL;
    murk_light_parts *parts = calloc(1, sizeof *parts);
    murk_status status =
        parts ? MURK_OK : murk_no_memory(err, "", "for %zu parts", n);
    /* The sums of the scene, for their sizes. */
    if (!status) {
        status = murk_ledger_create(&ledger, &stage->world, err);
    }
    if (!status) {
        status = murk_tallies_of_stage(&tallies, stage, 1,
                                       murk_machine_memory_bytes(), err);
    }
    for (size_t i = 0; i < n && !status; ++i) {
        part p = {.path = path[i]};
        status = read_part(&p, stage, ledger, tallies, err);
        if (!status && !parts->part) {
            parts->count = p.facts.count;
            parts->part = calloc(parts->count, sizeof *parts->part);
            status = parts->part ? MURK_OK
                                 : murk_no_memory(err, p.path, "to read it");
        }
        if (!status) {
            status = place_part(parts, &p, err);
        }
        release_part(&p);
    }
    murk_ledger_destroy(ledger);
    murk_tallies_destroy(tallies);
    if (status) {
        murk_light_parts_destroy(parts);
        return status;
    }
    murk_shards_warn_of_missing(has_part, parts, parts->count,
                                "their photons are traced now");
    *out = parts;
    return MURK_OK;
}

void murk_light_parts_destroy(murk_light_parts *parts)
{
    if (parts) {
        for (uint32_t k = 0; parts->part && k < parts->count; ++k) {
            release_part(&parts->part[k]);
        }
        free(parts->part);
        free(parts);
    }
}

void murk_light_parts_add(const murk_light_parts *parts, murk_ledger *ledger,
                          murk_tallies *tallies)
{
    for (uint32_t k = 0; k < parts->count; ++k) {
        const part *p = &parts->part[k];
        if (p->sections) {
            murk_ledger_add(ledger, p->cell);
        }
        if (p->sections && tallies) {
            murk_tallies_add_sums(tallies, p->word);
        }
    }
}

bool murk_light_parts_batch(const murk_light_parts *parts, uint64_t batch,
                            const murk_photon **records, size_t *n)
{
    const part *p = &parts->part[batch % parts->count];
    const uint64_t k = batch / parts->count;
    if (!p->sections || k >= p->facts.batches) {
        return false;
    }
    if (records) {
        *records = p->record + p->first[k];
        *n = p->count[k];
    }
    return true;
}

uint64_t murk_light_parts_end(const murk_light_parts *parts)
{
    uint64_t end = 0;
    for (uint32_t k = 0; k < parts->count; ++k) {
        const murk_light_part_facts *f = &parts->part[k].facts;
        const uint64_t own =
            f->batches > 0 ? k + 1 + (f->batches - 1) * parts->count : 0;
        end = own > end ? own : end;
    }
    return end;
}
