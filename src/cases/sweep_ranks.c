/* Collects the rows that this rank has run as text, as subprocesses send them,
 * and hands those of the other ranks on (cases/sweep_ranks.h). */
#include "cases/sweep_ranks.h"

#include "base/ranks.h"

#include <stdlib.h>
#include <string.h>

/* What all ranks must see alike of a row. */
typedef struct row_state {
    char key[65];
    bool is_done;
} row_state;

murk_status murk_sweep_ranks_begin(murk_sweep *sweep, murk_status status,
                                   murk_error *err)
{
    const size_t rows = sweep->desc.study->rows;
    if (murk_ranks_count() == 1) {
        return status;
    }
    sweep->found.is_shared = true;
    row_state *state = calloc(rows + 1, sizeof *state);
    if (!status && !state) {
        status = murk_no_memory(err, "", "for %zu rows", rows);
    }
    /* The keys of the rows, and whether each is done. */
    for (size_t i = 0; i < rows && !status; ++i) {
        memcpy(state[i].key, sweep->row[i].key, sizeof state[i].key);
        state[i].is_done = sweep->row[i].is_done;
    }
    status = murk_ranks_check_same("study, or sees other stored rows,", state,
                                   rows * sizeof *state, status, err);
    free(state);
    return status;
}

void murk_sweep_ranks_add(murk_sweep *sweep, size_t number,
                          const murk_study_row *row)
{
    murk_sweep_found *found = &sweep->found;
    if (!found->is_shared || found->is_received) {
        return;
    }
    char *text = murk_study_row_print(row, number);
    const size_t size = text ? strlen(text) + 1 : 0;
    char *grown = text ? realloc(found->text, found->size + size) : NULL;
    if (grown) {
        memcpy(grown + found->size, text, size);
        found->text = grown;
        found->size += size;
    } else {
        found->is_short_of_memory = true;
    }
    free(text);
}

/* Hands a row of another rank on: its number in a line, and the row. */
static murk_status put_text(murk_sweep *sweep, const char *text, size_t numbers,
                            murk_sweep_put put, murk_error *err)
{
    char *end = NULL;
    murk_sweep_message message = {.number = strtoul(text, &end, 10)};
    if (*end != '\n' || message.number >= numbers) {
        return murk_fail(err, MURK_RUN_FAILED, "", "not the row of a rank");
    }
    message.text = end + 1;
    message.size = strlen(message.text);
    murk_status status = murk_study_row_read(
        &message.row, message.text, message.size, "a row of a rank", err);
    if (!status) {
        status = put(sweep, &message, err);
    }
    murk_study_row_release(&message.row);
    return status;
}

murk_status murk_sweep_ranks_exchange(murk_sweep *sweep, size_t numbers,
                                      murk_sweep_put put, murk_status status,
                                      murk_error *err)
{
    murk_sweep_found *found = &sweep->found;
    const size_t groups = sweep->groups;
    murk_gathered all = {0};
    uint64_t *traced = NULL;
    if (murk_ranks_count() == 1) {
        return status;
    }
    if (!status && (found->is_short_of_memory ||
                    !(traced = calloc(groups + 1, sizeof *traced)))) {
        status = murk_no_memory(err, "", "to exchange rows");
    }
    status = murk_ranks_gather(&all, found->text, found->size, status, err);
    /* The rows of the other ranks. */
    found->is_received = true;
    for (unsigned r = 0; r < murk_ranks_count() && !status; ++r) {
        uint64_t at = all.begin[r];
        while (at < all.begin[r + 1] && r != murk_ranks_number() && !status) {
            status = put_text(sweep, all.bytes + at, numbers, put, err);
            at += strlen(all.bytes + at) + 1;
        }
    }
    /* Which groups were traced. */
    for (size_t g = 0; g < groups && !status; ++g) {
        traced[g] = sweep->group[g].was_traced;
    }
    status = murk_ranks_sum(traced, groups, false, status, err);
    for (size_t g = 0; g < groups && !status; ++g) {
        sweep->group[g].was_traced = traced[g] > 0;
    }
    free(traced);
    free(found->text);
    *found = (murk_sweep_found){.is_shared = true};
    murk_gathered_release(&all);
    return status;
}
