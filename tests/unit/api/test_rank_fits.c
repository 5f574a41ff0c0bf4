/* Fits through murk.h in ranks: ranks divide the photons of a fit and, if these
 * are many, the evaluation of their contributions, run the further starts, and
 * have the fields of a fit of one rank. A wrong bit in what a rank takes over
 * is noticed, and a rank that is asked to stop ends all. Seeds are fixed. */
#include "check.h"
#include "murk.h"
#include "thread_ranks.h"

#include <stdlib.h>
#include <string.h>

/* A fit, with the number of its photons and starts, and how often a search may
 * trace. */
typedef struct example {
    const char *scene, *data, *key[2], *emit;
    const char *start; /* of the first key; NULL: as in the scene */
    size_t keys;
    size_t starts, traces;
    char *json; /* its fields, by one rank */
} example;

static example few = {.scene = "scenes/calibrate-fog.yaml",
                      .data = "scenes/calibrate/fog.csv",
                      .key = {"media.fog.extinction_per_m"},
                      .keys = 1,
                      .emit = "300",
                      .starts = 4,
                      .traces = 4};
/* So far off that a further start is the best and traces light, and that there
 * are restarts; scattering angles are recorded. */
static example far_off = {
    .scene = "scenes/calibrate-fog.yaml",
    .data = "scenes/calibrate/fog.csv",
    .key = {"media.fog.extinction_per_m", "media.fog.phase.hg"},
    .keys = 2,
    .start = "2",
    .emit = "300",
    .starts = 4,
    .traces = 2};
/* So many contributions that ranks divide an evaluation
 * (MURK_LIGHTING_DIVIDED). */
static example receivers = {.scene = "scenes/calibrate-fog.yaml",
                            .data = "scenes/calibrate/fog.csv",
                            .key = {"media.fog.extinction_per_m"},
                            .keys = 1,
                            .emit = "90000",
                            .starts = 1,
                            .traces = 1};
static example coverage = {.scene = "scenes/calibrate-coverage.yaml",
                           .data = "scenes/calibrate/coverage.csv",
                           .key = {"media.fog.visibility_m"},
                           .keys = 1,
                           .emit = "12000",
                           .starts = 2,
                           .traces = 1};

typedef struct job {
    const example *of;
    unsigned threads;
    bool is_stopped; /* rank 1 is asked to stop before the fit */
    char *json[THREAD_RANKS_MAX];
} job;

static murk_status fit(void *user, unsigned number, murk_error *error)
{
    job *j = user;
    const murk_context_options options = {.size = sizeof options,
                                          .threads = j->threads};
    const murk_fit_options asked = {
        .size = sizeof asked, .starts = j->of->starts, .traces = j->of->traces};
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_fit *made = NULL;
    const murk_fields *fields = NULL;
    /* One handle after the other, down to the fit. */
    *error = (murk_error)MURK_ERROR_NONE;
    murk_status status = murk_context_create(&context, &options, error);
    if (!status) {
        status = murk_scene_read(&scene, context, j->of->scene, error);
    }
    if (!status) {
        status = murk_scene_set(scene, "photons.emit", j->of->emit, error);
    }
    if (!status && j->of->start) {
        status = murk_scene_set(scene, j->of->key[0], j->of->start, error);
    }
    if (!status) {
        status = murk_fit_create(&made, scene, j->of->data, j->of->key,
                                 j->of->keys, &asked, error);
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

static void fit_alone(example *of)
{
    job one = {.of = of, .threads = 2};
    const thread_ranks_end end =
        thread_ranks_run(1, THREAD_RANKS_SOUND, fit, &one);
    CHECK(thread_ranks_succeeded(&end, 1));
    CHECK_TEXT(end.error[0].text, "");
    CHECK(one.json[0] && strstr(one.json[0], "\"starts\""));
    of->json = one.json[0];
}

/* True if all ranks have the fit of one. */
static bool fits_are_the_same(const example *of, unsigned count,
                              unsigned threads, thread_ranks_defect defect)
{
    job all = {.of = of, .threads = threads};
    const thread_ranks_end end = thread_ranks_run(count, defect, fit, &all);
    bool is_same = thread_ranks_succeeded(&end, count);
    for (unsigned r = 0; r < count; ++r) {
        is_same = is_same && all.json[r] && of->json &&
                  strcmp(all.json[r], of->json) == 0;
        free(all.json[r]);
    }
    return is_same;
}

static void test_a_stopped_rank_ends_all(void)
{
    job j = {.of = &few, .threads = 1, .is_stopped = true};
    const thread_ranks_end end =
        thread_ranks_run(2, THREAD_RANKS_SOUND, fit, &j);
    for (unsigned r = 0; r < 2; ++r) {
        CHECK(end.status[r] == MURK_INTERRUPTED && !j.json[r]);
    }
}

/* Rank 1 is asked to stop in exchanges further and further into the fit: of
 * photons, sightlines and sums. */
static void test_a_rank_may_be_stopped_in_any_exchange(void)
{
    static const unsigned stops[] = {1, 5, 20, 60};
    for (size_t k = 0; k < sizeof stops / sizeof *stops; ++k) {
        job j = {.of = &coverage, .threads = 1};
        const thread_ranks_end end =
            thread_ranks_run_stopped(2, stops[k], fit, &j);
        for (unsigned r = 0; r < 2; ++r) {
            CHECK(end.status[r] == MURK_INTERRUPTED && !j.json[r]);
            free(j.json[r]);
        }
    }
}

int main(void)
{
    example *const all[] = {&few, &far_off, &receivers, &coverage};
    for (size_t i = 0; i < 4; ++i) {
        fit_alone(all[i]);
    }
    CHECK(fits_are_the_same(&few, 2, 2, THREAD_RANKS_SOUND));
    CHECK(fits_are_the_same(&few, 8, 1, THREAD_RANKS_SOUND)); /* idle ranks */
    CHECK(fits_are_the_same(&far_off, 3, 1, THREAD_RANKS_SOUND));
    CHECK(fits_are_the_same(&receivers, 2, 1, THREAD_RANKS_SOUND));
    CHECK(fits_are_the_same(&coverage, 3, 1, THREAD_RANKS_SOUND));
    CHECK(!fits_are_the_same(&few, 2, 1, THREAD_RANKS_FLIP_BIT));
    CHECK(!fits_are_the_same(&coverage, 2, 1, THREAD_RANKS_LOSE_WORDS));
    test_a_stopped_rank_ends_all();
    test_a_rank_may_be_stopped_in_any_exchange();
    for (size_t i = 0; i < 4; ++i) {
        free(all[i]->json);
    }
    return check_done();
}
