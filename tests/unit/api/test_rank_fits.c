/* Fits through murk.h in ranks: ranks run the further starts of a fit and have
 * the fields of a fit of one rank. A rank that takes over a start with a wrong
 * bit is noticed, and a rank that is asked to stop ends all. Seeds are fixed.
 */
#include "check.h"
#include "murk.h"
#include "thread_ranks.h"

#include <stdlib.h>
#include <string.h>

typedef struct job {
    size_t starts;
    unsigned threads;
    bool is_stopped; /* rank 1 is asked to stop before the fit */
    char *json[THREAD_RANKS_MAX];
} job;

static murk_status fit(void *user, unsigned number, murk_error *error)
{
    static const char *const keys[] = {"media.fog.extinction_per_m"};
    job *j = user;
    const murk_context_options options = {.size = sizeof options,
                                          .threads = j->threads};
    const murk_fit_options asked = {
        .size = sizeof asked, .starts = j->starts, .traces = 4};
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_fit *made = NULL;
    const murk_fields *fields = NULL;
    /* One handle after the other, down to the fit. */
    *error = (murk_error)MURK_ERROR_NONE;
    murk_status status = murk_context_create(&context, &options, error);
    if (!status) {
        status = murk_scene_read(&scene, context, "scenes/calibrate-fog.yaml",
                                 error);
    }
    if (!status) {
        status = murk_scene_set(scene, "photons.emit", "600", error);
    }
    if (!status) {
        status = murk_fit_create(&made, scene, "scenes/calibrate/fog.csv", keys,
                                 1, &asked, error);
    }
    if (j->is_stopped && number == 1) {
        murk_context_cancel(context);
    }
    if (!status) {
        status = murk_fit_run(made, error);
    }
    if (!status) {
        status = murk_fit_fields(made, &fields, error);
    }
    if (!status) {
        j->json[number] = strdup(murk_fields_json(fields));
    }
    murk_fit_destroy(made);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return status;
}

/* True if all ranks have the fit of one. */
static bool fits_are_the_same(size_t starts, unsigned count, unsigned threads,
                              thread_ranks_defect defect)
{
    job one = {.starts = starts, .threads = 1};
    job all = {.starts = starts, .threads = threads};
    thread_ranks_end end = thread_ranks_run(1, THREAD_RANKS_SOUND, fit, &one);
    CHECK(thread_ranks_succeeded(&end, 1));
    CHECK_TEXT(end.error[0].text, "");
    CHECK(one.json[0] && strstr(one.json[0], "\"starts\""));
    end = thread_ranks_run(count, defect, fit, &all);
    bool is_same = thread_ranks_succeeded(&end, count);
    for (unsigned r = 0; r < count; ++r) {
        is_same = is_same && all.json[r] && one.json[0] &&
                  strcmp(all.json[r], one.json[0]) == 0;
        free(all.json[r]);
    }
    free(one.json[0]);
    return is_same;
}

static void test_a_stopped_rank_ends_all(void)
{
    job j = {.starts = 3, .threads = 1, .is_stopped = true};
    const thread_ranks_end end =
        thread_ranks_run(2, THREAD_RANKS_SOUND, fit, &j);
    for (unsigned r = 0; r < 2; ++r) {
        CHECK(end.status[r] == MURK_INTERRUPTED && !j.json[r]);
    }
}

int main(void)
{
    CHECK(fits_are_the_same(4, 2, 2, THREAD_RANKS_SOUND));
    CHECK(fits_are_the_same(2, 4, 1, THREAD_RANKS_SOUND)); /* idle ranks */
    CHECK(!fits_are_the_same(3, 2, 1, THREAD_RANKS_FLIP_BIT));
    test_a_stopped_rank_ends_all();
    return check_done();
}
