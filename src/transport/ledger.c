#include "transport/trace.h"

#include <assert.h>
#include <stdlib.h>

#define ACCOUNTS 5

murk_status murk_ledger_create(murk_ledger **out, size_t channels,
                               murk_error *err)
{
    assert(out && channels > 0);
    murk_ledger *ledger = calloc(1, sizeof *ledger);
    murk_tally *cells = calloc(channels * ACCOUNTS, sizeof *cells);
    if (!ledger || !cells) {
        free(ledger);
        free(cells);
        return murk_fail(err, MURK_NO_MEMORY, "ledger",
                         "no memory for %zu channels", channels);
    }
    ledger->channels = channels;
    ledger->emitted = cells; /* the others follow it in one block */
    ledger->absorbed_surfaces = cells + channels;
    ledger->absorbed_media = cells + 2 * channels;
    ledger->escaped = cells + 3 * channels;
    ledger->lost = cells + 4 * channels;
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
