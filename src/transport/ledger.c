/* The energy ledger: integer quanta that were emitted, absorbed, escaped or
 * lost, by light and band, so that the balance is exact. Absorption by
 * material and medium is kept in several lanes that threads add to and readers
 * sum up. */
#include "transport/trace.h"

#include <assert.h>
#include <stdlib.h>

/* Emitted, absorbed by surfaces and by media, escaped, lost. */
#define ACCOUNTS 5

/* A ledger has up to LANES lanes, fewer if they would have more than LANE_CELLS
 * cells together (but at least 1): with that many cells, two threads seldom add
 * to the same one at the same time. */
#define LANES      16
#define LANE_CELLS 65536

static size_t lanes_of(size_t cells)
{
    const size_t lanes = LANE_CELLS / cells;
    return lanes < 1 ? 1 : lanes < LANES ? lanes : LANES;
}

murk_status murk_ledger_create(murk_ledger **out,
                               const murk_transport_world *world,
                               murk_error *err)
{
    const size_t channels = murk_sources_channels(world->lights);
    const size_t materials = murk_surfaces_materials(world->surfaces);
    const size_t media = murk_media_count(world->media);
    assert(out && channels > 0 && materials > 0);
    const size_t absorbers = channels * (materials + media);
    const size_t lanes = lanes_of(absorbers);
    murk_ledger *ledger = calloc(1, sizeof *ledger);
    murk_tally *cells =
        calloc(channels * ACCOUNTS + lanes * absorbers, sizeof *cells);
    if (!ledger || !cells) {
        free(ledger);
        free(cells);
        return murk_no_memory(err, "ledger", "for %zu channels", channels);
    }
    ledger->channels = channels;
    ledger->materials = materials;
    ledger->media = media;
    ledger->lanes = lanes;
    ledger->emitted = cells; /* the others follow it in one block */
    ledger->absorbed_surfaces = cells + channels;
    ledger->absorbed_media = cells + 2 * channels;
    ledger->escaped = cells + 3 * channels;
    ledger->lost = cells + 4 * channels;
    ledger->absorber = cells + 5 * channels;
    *out = ledger;
    return MURK_OK;
}

void murk_ledger_destroy(murk_ledger *ledger)
{
    if (ledger) {
        free(ledger->emitted);
        free(ledger);
    }
}

static int64_t absorbed_by(const murk_ledger *ledger, size_t channel,
                           size_t absorber)
{
    const size_t absorbers = ledger->materials + ledger->media;
    int64_t sum = 0;
    for (size_t lane = 0; lane < ledger->lanes; ++lane) {
        sum += murk_tally_read(
            &ledger->absorber[(lane * ledger->channels + channel) * absorbers +
                              absorber]);
    }
    return sum;
}

int64_t murk_ledger_by_material(const murk_ledger *ledger, size_t channel,
                                size_t material)
{
    assert(material < ledger->materials);
    return absorbed_by(ledger, channel, material);
}

int64_t murk_ledger_by_medium(const murk_ledger *ledger, size_t channel,
                              size_t medium)
{
    assert(medium < ledger->media);
    return absorbed_by(ledger, channel, ledger->materials + medium);
}

int64_t murk_ledger_imbalance(const murk_ledger *ledger)
{
    int64_t sum = 0;
    for (size_t c = 0; c < ledger->channels; ++c) {
        const int64_t left = murk_tally_read(&ledger->emitted[c]) -
                             murk_tally_read(&ledger->absorbed_surfaces[c]) -
                             murk_tally_read(&ledger->absorbed_media[c]) -
                             murk_tally_read(&ledger->escaped[c]) -
                             murk_tally_read(&ledger->lost[c]);
        sum += left < 0 ? -left : left;
    }
    return sum;
}

size_t murk_ledger_accounts(const murk_ledger *ledger)
{
    return ACCOUNTS * ledger->channels;
}

size_t murk_ledger_absorbers(const murk_ledger *ledger)
{
    return ledger->channels * (ledger->materials + ledger->media);
}

size_t murk_ledger_cells(const murk_ledger *ledger)
{
    return murk_ledger_accounts(ledger) + murk_ledger_absorbers(ledger) +
           MURK_LOSSES + 2;
}

void murk_ledger_read(const murk_ledger *ledger, int64_t *cell)
{
    const size_t each = ledger->materials + ledger->media;
    for (size_t i = 0; i < murk_ledger_accounts(ledger); ++i) {
        *cell++ = murk_tally_read(&ledger->emitted[i]); /* and the accounts that
                                                           follow it */
    }
    for (size_t i = 0; i < murk_ledger_absorbers(ledger); ++i) {
        *cell++ = absorbed_by(ledger, i / each, i % each);
    }
    for (int i = 0; i < MURK_LOSSES; ++i) {
        *cell++ = murk_tally_read(&ledger->lost_photons[i]);
    }
    *cell++ = murk_tally_read(&ledger->photons);
    *cell = murk_tally_read(&ledger->collisions);
}

void murk_ledger_add(murk_ledger *ledger, const int64_t *cell)
{
    for (size_t i = 0; i < murk_ledger_accounts(ledger); ++i) {
        murk_tally_add(&ledger->emitted[i], *cell++);
    }
    /* The sum over the lanes counts, so the first lane takes all. */
    for (size_t i = 0; i < murk_ledger_absorbers(ledger); ++i) {
        murk_tally_add(&ledger->absorber[i], *cell++);
    }
    for (int i = 0; i < MURK_LOSSES; ++i) {
        murk_tally_add(&ledger->lost_photons[i], *cell++);
    }
    murk_tally_add(&ledger->photons, *cell++);
    murk_tally_add(&ledger->collisions, *cell);
}
