/* Writes and reads light.murk: the sections of the file, and whether the file
 * belongs to a scene. store_check.c checks the ranges of all numbers;
 * photonmap/map_file.h has the container format. */
#include "base/ranks.h"
#include "lightmap/key_check.h"
#include "lightmap/lightmap.h"
#include "lightmap/store_check.h"
#include "photonmap/map_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The section "facts" as it is stored in the file. */
typedef struct facts {
    uint64_t emitted, channels, photons, collisions;
    uint64_t lost_photons[MURK_LOSSES];
    uint32_t seed, stream;
} facts;

static facts facts_of(const murk_traced *traced)
{
    const murk_ledger *ledger = traced->ledger;
    facts f = {.emitted = traced->emitted,
               .channels = traced->channels,
               .photons = (uint64_t)murk_tally_read(&ledger->photons),
               .collisions = (uint64_t)murk_tally_read(&ledger->collisions),
               .seed = traced->seed,
               .stream = traced->stream};
    for (int i = 0; i < MURK_LOSSES; ++i) {
        f.lost_photons[i] = (uint64_t)murk_tally_read(&ledger->lost_photons[i]);
    }
    return f;
}

/* True if the local origin of the scene is not 0. */
static bool has_origin(const murk_scene_desc *scene)
{
    const murk_vec3 o = scene->origin;
    return o.x != 0 || o.y != 0 || o.z != 0;
}

murk_status murk_lightmap_save(const murk_traced *traced,
                               const murk_stage *stage, const char *path,
                               murk_error *err)
{
    const size_t channels = traced->channels;
    const size_t accounts = murk_ledger_accounts(traced->ledger);
    int64_t *energy =
        malloc(murk_ledger_cells(traced->ledger) * sizeof *energy);
    if (!energy) {
        return murk_no_memory(err, path, "to write it");
    }
    murk_ledger_read(traced->ledger, energy);
    /* List the sections; the origin is written only if it is not 0. */
    const facts f = facts_of(traced);
    const murk_vec3 o = stage->scene->origin;
    const murk_section sections[] = {
        murk_section_of("origin_m", &o, sizeof o),
        murk_section_of("key", stage->light_key, strlen(stage->light_key)),
        murk_section_of("facts", &f, sizeof f),
        murk_section_of("packet_w", traced->packet_w,
                        channels * sizeof *traced->packet_w),
        murk_section_of("ledger", energy, accounts * sizeof *energy),
        murk_section_of("absorbed", energy + accounts,
                        murk_ledger_absorbers(traced->ledger) * sizeof *energy),
        murk_section_of("surface", murk_photon_map_photons(traced->surface),
                        murk_photon_map_count(traced->surface) *
                            sizeof(murk_photon)),
        murk_section_of("volume", murk_photon_map_photons(traced->volume),
                        murk_photon_map_count(traced->volume) *
                            sizeof(murk_photon))};
    const size_t first = has_origin(stage->scene) ? 0 : 1;
    const murk_status status =
        murk_map_file_write(path, sections + first,
                            sizeof sections / sizeof *sections - first, err);
    free(energy);
    return status;
}

/* As murk_map_file_find(), of sections that may be changed. */
static murk_section *find_section(murk_section *sections, size_t n,
                                  const char *name)
{
    const murk_section *found = murk_map_file_find(sections, n, name);
    return found ? &sections[found - sections] : NULL;
}

static murk_status bad_section(const char *path, const char *name,
                               murk_error *err)
{
    return murk_fail(err, MURK_BAD_FILE, path,
                     "section %s is missing or of the wrong size", name);
}

/* Checks the records of a section and makes a map of them, which takes their
 * memory. Of the ranks of a machine the first has the section, and all share
 * the map: collective. */
static murk_status load_map(murk_photon_map **out, const murk_traced *traced,
                            murk_section *sections, size_t n, bool is_volume,
                            const murk_stage *stage, const char *path,
                            unsigned threads, murk_status status,
                            murk_error *err)
{
    const char *name = is_volume ? "volume" : "surface";
    murk_block block = {0};
    /* Find and check the records. */
    murk_section *section = find_section(sections, n, name);
    if (!status && murk_ranks_on_machine().number == 0) {
        status = section && section->size % sizeof(murk_photon) == 0
                     ? murk_lightmap_check_records(
                           section->bytes, section->size / sizeof(murk_photon),
                           is_volume, traced->emitted, traced->packet_w, stage,
                           path, err)
                     : bad_section(path, name, err);
        /* The block of the section may be longer than the records. */
        if (!status) {
            status = murk_block_resize(&section->block, section->size, INFINITY,
                                       err);
        }
        if (!status) {
            block = section->block;
            section->block = (murk_block){0};
        }
    }
    return murk_photon_map_create_shared(out, &block, threads, status, err);
}

/* Checks the stored energies and counts, and adds them to an empty ledger. */
static murk_status load_ledger(murk_traced *traced, const facts *f,
                               const murk_section *energy,
                               const murk_section *absorbed,
                               const murk_stage *stage, const char *path,
                               murk_error *err)
{
    murk_ledger *ledger = traced->ledger;
    int64_t *cell = malloc(murk_ledger_cells(ledger) * sizeof *cell);
    if (!cell) {
        return murk_no_memory(err, path, "for the ledger");
    }
    /* The sums in the order of murk_ledger_read(). */
    memcpy(cell, energy->bytes, energy->size);
    int64_t *at = cell + murk_ledger_accounts(ledger);
    memcpy(at, absorbed->bytes, absorbed->size);
    at += murk_ledger_absorbers(ledger);
    for (int i = 0; i < MURK_LOSSES; ++i) {
        *at++ = (int64_t)f->lost_photons[i];
    }
    *at++ = (int64_t)f->photons;
    *at = (int64_t)f->collisions;
    const murk_status status = murk_lightmap_check_ledger(
        cell, f->emitted, traced->packet_w, stage, path, err);
    if (!status) {
        murk_ledger_add(ledger, cell);
    }
    free(cell);
    return status;
}

/* Everything but the records. */
static murk_status load(murk_traced *traced, const murk_section *sections,
                        size_t n, const murk_stage *stage, const char *path,
                        murk_error *err)
{
    /* Find the sections; the light key and the origin must be those of the
     * scene. */
    const murk_section *key = murk_map_file_find(sections, n, "key");
    const murk_section *fact = murk_map_file_find(sections, n, "facts");
    const murk_section *worth = murk_map_file_find(sections, n, "packet_w");
    const murk_section *energy = murk_map_file_find(sections, n, "ledger");
    const murk_section *absorbed = murk_map_file_find(sections, n, "absorbed");
    if (!key) {
        return bad_section(path, "key", err);
    }
    murk_status status =
        murk_lightmap_check_text(key, stage->light_key, "light", path, err);
    if (!status) {
        status = murk_lightmap_check_origin(
            murk_map_file_find(sections, n, "origin_m"), stage->scene, path,
            err);
    }
    if (status) {
        return status;
    }
    /* Seed, stream and the size of each section must fit the scene. */
    if (!fact || fact->size != sizeof(facts)) {
        return bad_section(path, "facts", err);
    }
    facts f;
    memcpy(&f, fact->bytes, sizeof f);
    if (f.seed != stage->scene->seed || f.stream != 0) {
        return murk_fail(err, MURK_BAD_VALUE, path,
                         "made with seed %u, the scene has seed %u", f.seed,
                         stage->scene->seed);
    }
    if (f.channels != traced->channels || f.emitted > UINT32_MAX) {
        return bad_section(path, "facts", err);
    }
    if (!worth || worth->size != traced->channels * sizeof *traced->packet_w) {
        return bad_section(path, "packet_w", err);
    }
    if (!energy || energy->size !=
                       murk_ledger_accounts(traced->ledger) * sizeof(int64_t)) {
        return bad_section(path, "ledger", err);
    }
    if (!absorbed || absorbed->size != murk_ledger_absorbers(traced->ledger) *
                                           sizeof(int64_t)) {
        return bad_section(path, "absorbed", err);
    }
    /* Fill the ledger. */
    traced->emitted = f.emitted;
    memcpy(traced->packet_w, worth->bytes, worth->size);
    return load_ledger(traced, &f, energy, absorbed, stage, path, err);
}

murk_status murk_lightmap_load(murk_traced **out, const murk_stage *stage,
                               const char *path, unsigned threads,
                               murk_error *err)
{
    static const char *const maps[] = {"surface", "volume", NULL};
    murk_section *sections = NULL;
    size_t n = 0;
    /* Of the ranks of a machine the first alone reads the records. */
    murk_status status =
        murk_ranks_on_machine().number == 0
            ? murk_map_file_read(&sections, &n, path, err)
            : murk_map_file_read_without(&sections, &n, path, maps, err);
    murk_traced *traced = NULL;
    if (!status) {
        traced = murk_traced_create(stage, 0, err);
        status = traced ? load(traced, sections, n, stage, path, err)
                        : MURK_NO_MEMORY;
    }
    status = murk_ranks_agree(status, err);
    if (!status) {
        status = load_map(&traced->surface, traced, sections, n, false, stage,
                          path, threads, status, err);
        status = load_map(&traced->volume, traced, sections, n, true, stage,
                          path, threads, status, err);
    }
    murk_map_file_release(sections, n);
    if (status) {
        murk_traced_destroy(traced);
        return status;
    }
    *out = traced;
    return MURK_OK;
}

/* The integer after `word` in a line of the light key; 0 if the word is
 * missing. */
static uint64_t number_behind(const char *line, const char *end,
                              const char *word)
{
    const size_t length = strlen(word);
    for (const char *at = line; at + length < end; ++at) {
        if (strncmp(at, word, length) == 0) {
            return strtoull(at + length, NULL, 10);
        }
    }
    return 0;
}

murk_status murk_lightmap_read_counts(murk_lightmap_counts *out,
                                      const char *path, murk_error *err)
{
    static const char photons[] = "\nphotons: {";
    murk_section *key = NULL, *fact = NULL;
    murk_status status = murk_map_file_read_one(&key, path, "key", err);
    if (!status) {
        status = murk_map_file_read_one(&fact, path, "facts", err);
    }
    if (!status && fact->size != sizeof(facts)) {
        status = bad_section(path, "facts", err);
    }
    if (!status) {
        facts f;
        memcpy(&f, fact->bytes, sizeof f);
        *out = (murk_lightmap_counts){.seed = f.seed};
        /* The light key is YAML as murk_scene_desc_read() writes it, one line
         * for each key of the scene. If the line of the key photons is missing,
         * emit and store stay 0, and murk_lightmap_load() refuses the file,
         * because the light key of a scene has that line. */
        char *text = strndup(key->bytes, key->size);
        const char *line = text ? strstr(text, photons) : NULL;
        if (line) {
            const char *end = line + 1 + strcspn(line + 1, "\n");
            out->emit = number_behind(line, end, "{emit: ");
            out->store = number_behind(line, end, "{store: ");
        }
        free(text);
    }
    murk_map_file_release(key, 1);
    murk_map_file_release(fact, 1);
    return status;
}
