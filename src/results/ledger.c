/* Turns the quanta of a ledger (transport/ledger.h) into watts: by band, by
 * material and by medium. */
#include "results/ledger.h"

#include "results/json.h"
#include "world/units.h"

#include <stdio.h>

#define EMITTERS_MAX (MURK_SOURCES_MAX * MURK_BANDS_MAX)

/* Of quanta whose packet is worth that much. */
static double worth(int64_t quanta, double packet)
{
    return (double)quanta / (double)MURK_PACKET * packet;
}

double murk_ledger_watts(const murk_traced *traced, const murk_tally *column)
{
    double sum = 0;
    for (size_t c = 0; c < traced->channels; ++c) {
        sum += worth(murk_tally_read(&column[c]), traced->packet_w[c]);
    }
    return sum;
}

/* {"total": .., "bands": [..]} of quanta[channels], each of which is worth
 * packet[channel] a packet. */
static void add_worth(cJSON *object, const char *key, const double *packet,
                      size_t channels, const int64_t *quanta, int bands)
{
    double total = 0, band[MURK_BANDS_MAX] = {0};
    for (size_t c = 0; c < channels; ++c) {
        const double value = worth(quanta[c], packet[c]);
        total += value;
        band[c % (size_t)bands] += value;
    }
    cJSON *both = cJSON_AddObjectToObject(object, key);
    murk_json_number(both, "total", total);
    cJSON_AddItemToObject(both, "bands", cJSON_CreateDoubleArray(band, bands));
}

static void add_watts(cJSON *object, const char *key, const murk_traced *traced,
                      const int64_t *quanta, int bands)
{
    add_worth(object, key, traced->packet_w, traced->channels, quanta, bands);
}

static void add_column(cJSON *object, const char *key,
                       const murk_traced *traced, const murk_tally *column,
                       int bands)
{
    int64_t quanta[EMITTERS_MAX];
    for (size_t c = 0; c < traced->channels; ++c) {
        quanta[c] = murk_tally_read(&column[c]);
    }
    add_watts(object, key, traced, quanta, bands);
}

/* What one material or medium took. */
static void
add_absorber(cJSON *object, const char *name, const murk_traced *traced,
             int64_t (*absorbed)(const murk_ledger *, size_t, size_t),
             size_t number, int bands)
{
    int64_t quanta[EMITTERS_MAX];
    for (size_t c = 0; c < traced->channels; ++c) {
        quanta[c] = absorbed(traced->ledger, c, number);
    }
    add_watts(object, name, traced, quanta, bands);
}

static void add_absorbers(cJSON *object, const murk_traced *traced,
                          const murk_scene_desc *scene)
{
    cJSON *surfaces = cJSON_AddObjectToObject(object, "absorbed_by_material_w");
    for (size_t i = 0; i < scene->n_materials; ++i) {
        add_absorber(surfaces, scene->materials[i].name, traced,
                     murk_ledger_by_material, i, scene->bands);
    }
    cJSON *media = cJSON_AddObjectToObject(object, "absorbed_by_medium_w");
    for (size_t i = 0; i < scene->n_media; ++i) {
        add_absorber(media, scene->media[i].name, traced, murk_ledger_by_medium,
                     i, scene->bands);
    }
}

/* What left the lights as users read it: "emitted_lm". Nothing for watts. */
static void add_emitted(cJSON *object, const murk_traced *traced,
                        const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    if (scene->units == MURK_RADIOMETRIC) {
        return;
    }
    const murk_units units = murk_units_of(scene->units);
    char key[40];
    double packet[EMITTERS_MAX];
    int64_t quanta[EMITTERS_MAX];
    murk_units_packets(packet, scene->units, stage, traced->packet_w);
    for (size_t c = 0; c < traced->channels; ++c) {
        quanta[c] = murk_tally_read(&traced->ledger->emitted[c]);
    }
    snprintf(key, sizeof key, "emitted_%s", units.suffix);
    add_worth(object, key, packet, traced->channels, quanta, scene->bands);
}

void murk_json_ledger(cJSON *object, const murk_traced *traced,
                      const murk_stage *stage)
{
    const murk_ledger *ledger = traced->ledger;
    const int bands = stage->scene->bands;
    add_column(object, "emitted_w", traced, ledger->emitted, bands);
    add_emitted(object, traced, stage);
    add_column(object, "absorbed_surfaces_w", traced, ledger->absorbed_surfaces,
               bands);
    add_column(object, "absorbed_media_w", traced, ledger->absorbed_media,
               bands);
    add_column(object, "escaped_w", traced, ledger->escaped, bands);
    add_column(object, "lost_w", traced, ledger->lost, bands);
    add_absorbers(object, traced, stage->scene);
    cJSON_AddNumberToObject(object, "photons_emitted",
                            (double)murk_tally_read(&ledger->photons));
    cJSON_AddNumberToObject(object, "collisions",
                            (double)murk_tally_read(&ledger->collisions));
    static const char *const cause[MURK_LOSSES] = {
        [MURK_LOSS_EVENTS] = "events",
        [MURK_LOSS_WRAPS] = "wraps",
        [MURK_LOSS_NUMERICAL] = "numerical"};
    cJSON *lost = cJSON_AddObjectToObject(object, "lost");
    for (int i = 0; i < MURK_LOSSES; ++i) {
        cJSON_AddNumberToObject(
            lost, cause[i], (double)murk_tally_read(&ledger->lost_photons[i]));
    }
    cJSON_AddNumberToObject(object, "imbalance_quanta",
                            (double)murk_ledger_imbalance(ledger));
}
