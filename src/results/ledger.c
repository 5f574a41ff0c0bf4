/* Turns the quanta of a ledger (transport/ledger.h) into watts: by band, by
 * material and by medium. */
#include "results/ledger.h"

#include "results/json.h"
#include "world/units.h"

#include <stdio.h>

#define EMITTERS_MAX (MURK_SOURCES_MAX * MURK_BANDS_MAX)

/* The value of a number of quanta, if a packet (MURK_PACKET quanta) has the
 * value `packet`. */
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

/* Returns {"total": .., "bands": [..]} of quanta[channels]; packet[channels] is
 * the value of a packet of each channel (a light source in a band). */
static cJSON *worth_json(const murk_ledger_results *l, const int64_t *quanta,
                         const double *packet)
{
    const int bands = l->stage->scene->bands;
    double total = 0, band[MURK_BANDS_MAX] = {0};
    for (size_t c = 0; c < l->traced->channels; ++c) {
        const double value = worth(quanta[c], packet[c]);
        total += value;
        band[c % (size_t)bands] += value;
    }
    cJSON *both = cJSON_CreateObject();
    murk_json_number(both, "total", total);
    murk_json_numbers(both, "bands", band, bands);
    return both;
}

static cJSON *column_json(const murk_ledger_results *l,
                          const murk_tally *column, const double *packet)
{
    int64_t quanta[EMITTERS_MAX];
    for (size_t c = 0; c < l->traced->channels; ++c) {
        quanta[c] = murk_tally_read(&column[c]);
    }
    return worth_json(l, quanta, packet);
}

/* The power [W] that each material, or each medium, absorbed, by name. */
static cJSON *absorbed_json(const murk_ledger_results *l, bool of_media)
{
    const murk_scene_desc *scene = l->stage->scene;
    cJSON *object = cJSON_CreateObject();
    const size_t n = of_media ? scene->n_media : scene->n_materials;
    for (size_t i = 0; i < n; ++i) {
        int64_t quanta[EMITTERS_MAX];
        for (size_t c = 0; c < l->traced->channels; ++c) {
            quanta[c] = of_media
                            ? murk_ledger_by_medium(l->traced->ledger, c, i)
                            : murk_ledger_by_material(l->traced->ledger, c, i);
        }
        cJSON_AddItemToObject(
            object, of_media ? scene->media[i].name : scene->materials[i].name,
            worth_json(l, quanta, l->traced->packet_w));
    }
    return object;
}

/* The light that left the sources, in the units of the scene. */
static cJSON *emitted_json(const murk_ledger_results *l)
{
    double packet[EMITTERS_MAX];
    murk_units_packets(packet, l->stage->scene->units, l->stage,
                       l->traced->packet_w);
    return column_json(l, l->traced->ledger->emitted, packet);
}

static void list_lost(murk_results_fields *f, const void *of)
{
    static const char *const cause[MURK_LOSSES] = {
        [MURK_LOSS_EVENTS] = "events",
        [MURK_LOSS_WRAPS] = "wraps",
        [MURK_LOSS_NUMERICAL] = "numerical"};
    static const char *const help[MURK_LOSSES] = {
        [MURK_LOSS_EVENTS] = "ended by the cap of 100000 events",
        [MURK_LOSS_WRAPS] =
            "ended by the cap of passages through periodic sides",
        [MURK_LOSS_NUMERICAL] = "could not be followed"};
    const murk_ledger *ledger = of;
    for (int i = 0; i < MURK_LOSSES; ++i) {
        MURK_COUNT(f, cause[i], help[i],
                   (uint64_t)murk_tally_read(&ledger->lost_photons[i]));
    }
}

void murk_results_list_ledger(murk_results_fields *f, const void *of)
{
    static const char total[] = "total, and bands";
    const murk_ledger_results *l = of;
    const murk_ledger *ledger = l ? l->traced->ledger : NULL;
    const double *packet = l ? l->traced->packet_w : NULL;
    const murk_quantity units = l ? l->stage->scene->units : MURK_RADIOMETRIC;
    char emitted[40] = "emitted_lm";
    murk_results_list_head(f, l ? l->stage->scene : NULL);
    MURK_JSON(f, "emitted_w", "W", total,
              column_json(l, ledger->emitted, packet));
    if (units != MURK_RADIOMETRIC) {
        snprintf(emitted, sizeof emitted, "emitted_%s",
                 murk_units_of(units).suffix);
    }
    if (MURK_LISTED_IF(f, units != MURK_RADIOMETRIC)) {
        MURK_JSON(f, emitted, "",
                  "or emitted_photons_per_s, emitted_umol_per_s: in the "
                  "scene's units, if these are not watts",
                  emitted_json(l));
    }
    /* The power, by the fate of the photons. */
    MURK_JSON(f, "absorbed_surfaces_w", "W", total,
              column_json(l, ledger->absorbed_surfaces, packet));
    MURK_JSON(f, "absorbed_media_w", "W", total,
              column_json(l, ledger->absorbed_media, packet));
    MURK_JSON(f, "escaped_w", "W", total,
              column_json(l, ledger->escaped, packet));
    MURK_JSON(f, "lost_w", "W", total, column_json(l, ledger->lost, packet));
    MURK_JSON(f, "absorbed_by_material_w", "W", "by name, each total and bands",
              absorbed_json(l, false));
    MURK_JSON(f, "absorbed_by_medium_w", "W", "by name, each total and bands",
              absorbed_json(l, true));
    MURK_COUNT(f, "photons_emitted", "emitted photons",
               (uint64_t)murk_tally_read(&ledger->photons));
    MURK_COUNT(f, "collisions", "real collisions in media",
               (uint64_t)murk_tally_read(&ledger->collisions));
    MURK_OBJECT(f, "lost",
                "photons dropped, by cause; more than 1 % refuse the "
                "run",
                list_lost, ledger);
    MURK_NUMBER(f, "imbalance_quanta", "", "emitted less all else: 0",
                (double)murk_ledger_imbalance(ledger));
}
