/* Writes and reads light.murk: the sections of the file, and whether the file
 * belongs to a scene. store_check.c checks the ranges of all numbers;
 * photonmap/map_file.h has the container format. */
#include "lightmap/lightmap.h"
#include "lightmap/store_check.h"
#include "photonmap/map_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The section "facts" as it is stored in the file. */
typedef struct facts {
    uint64_t emitted, channels, photons, collisions;
    uint64_t lost_photons[MURK_LOSSES];
    uint32_t seed, stream;
} facts;

/* Emitted, absorbed by surfaces and by media, escaped, lost */
#define LEDGER_COLUMNS 5

static void ledger_columns(const murk_ledger *ledger,
                           murk_tally *column[LEDGER_COLUMNS])
{
    column[0] = ledger->emitted;
    column[1] = ledger->absorbed_surfaces;
    column[2] = ledger->absorbed_media;
    column[3] = ledger->escaped;
    column[4] = ledger->lost;
}

/* Number of cells of energy by channel and absorber (materials, then media). */
static size_t absorbers(const murk_ledger *ledger)
{
    return ledger->channels * (ledger->materials + ledger->media);
}

/* Copies the cells that absorbers() counts to out. */
static void absorbed_cells(const murk_ledger *ledger, int64_t *out)
{
    for (size_t c = 0; c < ledger->channels; ++c) {
        for (size_t m = 0; m < ledger->materials; ++m) {
            *out++ = murk_ledger_by_material(ledger, c, m);
        }
        for (size_t m = 0; m < ledger->media; ++m) {
            *out++ = murk_ledger_by_medium(ledger, c, m);
        }
    }
}

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

/* Describes a section. The member `bytes` is not const, so the pointer is
 * copied by memcpy(); the writer only reads the bytes. */
static murk_section section_of(const char *name, const void *bytes, size_t size)
{
    murk_section section = {.size = size};
    snprintf(section.name, sizeof section.name, "%s", name);
    memcpy(&section.bytes, &bytes, sizeof bytes);
    return section;
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
    const size_t n_absorbed = absorbers(traced->ledger);
    int64_t *energy =
        malloc((LEDGER_COLUMNS * channels + n_absorbed) * sizeof *energy);
    if (!energy) {
        return murk_no_memory(err, path, "to write it");
    }
    /* Copy the energies of the ledger. */
    murk_tally *column[LEDGER_COLUMNS];
    ledger_columns(traced->ledger, column);
    for (size_t k = 0; k < LEDGER_COLUMNS; ++k) {
        for (size_t c = 0; c < channels; ++c) {
            energy[k * channels + c] = murk_tally_read(&column[k][c]);
        }
    }
    int64_t *absorbed = energy + LEDGER_COLUMNS * channels;
    absorbed_cells(traced->ledger, absorbed);
    /* List the sections; the origin is written only if it is not 0. */
    const facts f = facts_of(traced);
    const murk_vec3 o = stage->scene->origin;
    const murk_section sections[] = {
        section_of("origin_m", &o, sizeof o),
        section_of("key", stage->light_key, strlen(stage->light_key)),
        section_of("facts", &f, sizeof f),
        section_of("packet_w", traced->packet_w,
                   channels * sizeof *traced->packet_w),
        section_of("ledger", energy,
                   LEDGER_COLUMNS * channels * sizeof *energy),
        section_of("absorbed", absorbed, n_absorbed * sizeof *absorbed),
        section_of("surface", murk_photon_map_photons(traced->surface),
                   murk_photon_map_count(traced->surface) *
                       sizeof(murk_photon)),
        section_of("volume", murk_photon_map_photons(traced->volume),
                   murk_photon_map_count(traced->volume) *
                       sizeof(murk_photon))};
    const size_t first = has_origin(stage->scene) ? 0 : 1;
    const murk_status status =
        murk_map_file_write(path, sections + first,
                            sizeof sections / sizeof *sections - first, err);
    free(energy);
    return status;
}

/* Length of the line at `text`, within [text, end). */
static int line_length(const char *text, const char *end)
{
    const char *newline = memchr(text, '\n', (size_t)(end - text));
    return (int)((newline ? newline : end) - text);
}

/* Compares the light key of a file with that of the stage, line by line. Fails
 * with MURK_BAD_VALUE and names the first line that differs. */
static murk_status check_key(const murk_section *key, const char *light_key,
                             const char *path, murk_error *err)
{
    const char *a = key->bytes, *b = light_key;
    const char *a_end = a + key->size, *b_end = b + strlen(b);
    while (a < a_end || b < b_end) {
        const int a_length = a < a_end ? line_length(a, a_end) : 0;
        const int b_length = b < b_end ? line_length(b, b_end) : 0;
        if (a_length != b_length || memcmp(a, b, (size_t)a_length) != 0) {
            return murk_fail(err, MURK_BAD_VALUE, path,
                             "made for another light: it has \"%.*s\", the "
                             "scene has \"%.*s\"",
                             a_length, a, b_length, b);
        }
        a += a_length + (a + a_length < a_end);
        b += b_length + (b + b_length < b_end);
    }
    return MURK_OK;
}

/* Positions of records are relative to the local origin of the scene that they
 * were traced for. In a scene without a domain the origin depends on the
 * sensors as well, which the light key does not contain, so the origin is
 * compared here. A file without the section has the origin 0. */
static murk_status check_origin(const murk_section *origin,
                                const murk_scene_desc *scene, const char *path,
                                murk_error *err)
{
    murk_vec3 of = {0, 0, 0};
    const murk_vec3 due = scene->origin;
    if (origin && origin->size == sizeof of) {
        memcpy(&of, origin->bytes, sizeof of);
    }
    if (of.x == due.x && of.y == due.y && of.z == due.z) {
        return MURK_OK;
    }
    return murk_fail(err, MURK_BAD_VALUE, path,
                     "its positions count from [%.12g, %.12g, %.12g] m, the "
                     "scene is computed about [%.12g, %.12g, %.12g] m: give "
                     "the scene a domain, or trace its light again",
                     of.x, of.y, of.z, due.x, due.y, due.z);
}

static murk_status bad_section(const char *path, const char *name,
                               murk_error *err)
{
    return murk_fail(err, MURK_BAD_FILE, path,
                     "section %s is missing or of the wrong size", name);
}

static murk_status load_map(murk_photon_map **out, const murk_traced *traced,
                            const murk_section *sections, size_t n,
                            bool is_volume, const murk_stage *stage,
                            const char *path, unsigned threads, murk_error *err)
{
    const char *name = is_volume ? "volume" : "surface";
    /* Find and check the records. */
    const murk_section *section = murk_map_file_find(sections, n, name);
    if (!section || section->size % sizeof(murk_photon) != 0) {
        return bad_section(path, name, err);
    }
    const murk_status status = murk_lightmap_check_records(
        section->bytes, section->size / sizeof(murk_photon), is_volume,
        traced->emitted, traced->packet_w, stage, path, err);
    if (status) {
        return status;
    }
    /* Copy them into a map. */
    murk_photon *photons = NULL;
    if (section->size) {
        photons = malloc(section->size);
        if (!photons) {
            return murk_no_memory(err, path, "for its photons");
        }
        memcpy(photons, section->bytes, section->size);
    }
    return murk_photon_map_create(out, photons, section->size / sizeof *photons,
                                  threads, err);
}

/* Adds the stored energies and counts to an empty ledger. */
static void load_ledger(murk_traced *traced, const facts *f,
                        const murk_section *energy,
                        const murk_section *absorbed)
{
    murk_ledger *ledger = traced->ledger;
    murk_tally *column[LEDGER_COLUMNS];
    ledger_columns(ledger, column);
    const int64_t *value = energy->bytes;
    for (size_t k = 0; k < LEDGER_COLUMNS; ++k) {
        for (size_t c = 0; c < traced->channels; ++c) {
            murk_tally_add(&column[k][c], value[k * traced->channels + c]);
        }
    }
    const int64_t *share = absorbed->bytes;
    for (size_t i = 0; i < absorbers(ledger); ++i) {
        murk_tally_add(&ledger->absorber[i], share[i]); /* absorber[] has
                                                         * several lanes, whose
                                                         * sum counts; all
                                                         * values go to the
                                                         * first lane */
    }
    for (int i = 0; i < MURK_LOSSES; ++i) {
        murk_tally_add(&ledger->lost_photons[i], (int64_t)f->lost_photons[i]);
    }
    murk_tally_add(&ledger->photons, (int64_t)f->photons);
    murk_tally_add(&ledger->collisions, (int64_t)f->collisions);
}

static murk_status load(murk_traced *traced, const murk_section *sections,
                        size_t n, const murk_stage *stage, const char *path,
                        unsigned threads, murk_error *err)
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
    murk_status status = check_key(key, stage->light_key, path, err);
    if (!status) {
        status = check_origin(murk_map_file_find(sections, n, "origin_m"),
                              stage->scene, path, err);
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
    if (!energy ||
        energy->size != LEDGER_COLUMNS * traced->channels * sizeof(int64_t)) {
        return bad_section(path, "ledger", err);
    }
    if (!absorbed ||
        absorbed->size != absorbers(traced->ledger) * sizeof(int64_t)) {
        return bad_section(path, "absorbed", err);
    }
    /* Check the numbers. */
    const size_t channels = traced->channels;
    const int64_t *column = energy->bytes;
    const murk_lightmap_numbers numbers = {
        .emitted = f.emitted,
        .counted = f.photons,
        .collisions = f.collisions,
        .lost_photons = f.lost_photons,
        .packet_w = worth->bytes,
        .emitted_quanta = column,
        .absorbed_surfaces_quanta = column + channels,
        .absorbed_media_quanta = column + 2 * channels,
        .escaped_quanta = column + 3 * channels,
        .lost_quanta = column + 4 * channels,
        .absorbed = absorbed->bytes};
    status = murk_lightmap_check_numbers(&numbers, stage, path, err);
    if (status) {
        return status;
    }
    /* Fill the ledger and build the maps. */
    traced->emitted = f.emitted;
    memcpy(traced->packet_w, worth->bytes, worth->size);
    load_ledger(traced, &f, energy, absorbed);
    status = load_map(&traced->surface, traced, sections, n, false, stage, path,
                      threads, err);
    return status ? status
                  : load_map(&traced->volume, traced, sections, n, true, stage,
                             path, threads, err);
}

murk_status murk_lightmap_load(murk_traced **out, const murk_stage *stage,
                               const char *path, unsigned threads,
                               murk_error *err)
{
    murk_section *sections = NULL;
    size_t n = 0;
    murk_status status = murk_map_file_read(&sections, &n, path, err);
    if (status) {
        return status;
    }
    murk_traced *traced = murk_traced_create(stage, 0, err);
    status = traced ? load(traced, sections, n, stage, path, threads, err)
                    : MURK_NO_MEMORY;
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
