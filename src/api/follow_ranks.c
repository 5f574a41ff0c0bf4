/* The steps of a timeline with ranks (base/ranks.h). Steps that do not depend
 * on each other are dealt out: each rank takes the next run of neighbouring
 * steps until none is left, makes them as a single process, and leaves them in
 * the folder of results, which all ranks see. Rank 0 then takes all steps from
 * the folder, as a run does that finds them done, and writes the tables.
 *
 * Other steps are made by rank 0 alone. */
#include "api/follow.h"

#include "base/log.h"
#include "base/ranks.h"
#include "world/file_sums.h"

#include <stdlib.h>
#include <string.h>

/* Runs of steps for each rank: a few, so that ranks end at about the same time
 * although steps take unequal times, and no more, because the first step of a
 * run takes over less. */
#define RUNS_PER_RANK 4

/* Makes the steps from `begin` to `end`, without their tables. */
static murk_status make_run(murk_follow *follow, size_t begin, size_t end,
                            murk_error *err)
{
    const murk_fields *row = NULL;
    follow->next = begin;
    follow->end = end;
    murk_status status = murk_follow_next(follow, &row, err);
    while (!status && row) {
        status = murk_follow_next(follow, &row, err);
    }
    return status;
}

/* Makes runs of steps until none is left. *made: how many steps were made. */
static murk_status make_runs(uint64_t *made, const murk_follow *follow,
                             murk_deal *deal, size_t run, murk_error *err)
{
    murk_follow own;
    murk_status status = MURK_OK;
    murk_follow_part_begin(&own, follow);
    const size_t runs = (follow->steps + run - 1) / run;
    uint64_t k;
    while (!status && (k = murk_ranks_take(deal)) < runs) {
        const size_t begin = (size_t)k * run, left = follow->steps - begin;
        status = make_run(&own, begin, begin + (left < run ? left : run), err);
    }
    if (status) {
        murk_ranks_take_no_more(deal);
    }
    /* Steps that failed have no plan, and rank 0 tries them again. */
    for (size_t i = 0; i < own.sequence.rows; ++i) {
        *made += own.sequence.row[i].failed[0] == '\0';
    }
    *made -= own.reused;
    murk_follow_part_end(&own);
    return status;
}

/* Fails unless all ranks have the same scene and files. */
static murk_status check_same(const murk_follow *follow, murk_error *err)
{
    const char *key = follow->session.scene->whole_key;
    char *files = murk_file_sums_print(follow->session.scene);
    murk_status status =
        files ? MURK_OK : murk_no_memory(err, "", "for the steps");
    status = murk_ranks_check_same("scene", key, strlen(key), status, err);
    status =
        murk_ranks_check_same("file that the scene names", files ? files : "",
                              files ? strlen(files) : 0, status, err);
    free(files);
    return status;
}

/* Deals the steps out. */
static murk_status deal_steps(murk_follow *follow, murk_error *err)
{
    murk_context *context = follow->scene->context;
    const size_t runs = (size_t)RUNS_PER_RANK * murk_ranks_count();
    const size_t run = follow->steps > runs ? follow->steps / runs : 1;
    murk_deal deal;
    uint64_t made = 0;
    murk_status status = check_same(follow, err);
    status = murk_ranks_deal(&deal, status, err);
    if (status) {
        return status;
    }
    /* The work is that of a single process, in the host of the context and in
     * that of the caller. Rank 0 alone says what concerns all steps. */
    const bool was_quiet = murk_warn_quiet(murk_ranks_number() > 0);
    const murk_ranks *ranks = murk_ranks_leave();
    const murk_ranks *of_context = context->host->ranks;
    context->host->ranks = NULL;
    status = make_runs(&made, follow, &deal, run, err);
    context->host->ranks = of_context;
    murk_ranks_return(ranks);
    (void)murk_warn_quiet(was_quiet);
    status = murk_ranks_sum(&made, 1, false, status, err);
    follow->dealt = status ? 0 : (size_t)made;
    return status;
}

/* Says why the steps are not dealt out. */
static void note_alone(const murk_follow *follow)
{
    murk_call call =
        murk_call_begin(follow->scene->context, &follow->scene->files, NULL);
    murk_note("murk follow", "%s: rank 0 makes the steps alone",
              follow->part_of   ? "parts are put together"
              : !follow->folder ? "without a folder ranks share no steps"
                                : "each step begins at the plan of the step "
                                  "before (timeline.search_from)");
    (void)murk_call_end(&call, MURK_OK);
}

murk_status murk_follow_begin_ranks(murk_follow *follow, murk_error *err)
{
    murk_context *context = follow->scene->context;
    const bool is_dealt =
        murk_follow_is_divisible(follow) && follow->folder && !follow->part_of;
    follow->has_begun = true;
    if (!context->host->ranks || murk_ranks_count() == 1) {
        return MURK_OK;
    }
    const murk_status status = is_dealt ? deal_steps(follow, err) : MURK_OK;
    if (!status && murk_ranks_number() > 0) {
        follow->next = follow->end; /* rank 0 alone goes on */
    } else if (!status) {
        follow->ranks = context->host->ranks;
        context->host->ranks = NULL;
        if (!is_dealt) {
            note_alone(follow);
        }
    }
    return status;
}
